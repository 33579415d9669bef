//! Where stresses are: what maps and tables show unless they are told.
use super::{ContactPressure, Field, FieldError, FieldPoint, FieldQuantity};

/// How far a [`Field::window`] reaches beside the middle, and below the top face, in half-lengths of what presses; how far into a half-plane; and how far about openings, in parts of their distance.
const BESIDE: f64 = 2.0;
const AROUND: f64 = 1.1;
const BELOW: f64 = 3.0;
const GROUND: f64 = 1.5;
/// A quantity is appreciable where it is larger than this part of its largest value, but for this part of all points, which may be larger
/// next to singular ones; and how much wider than that a window is.
const APPRECIABLE: f64 = 0.15;
const SINGULAR: f64 = 0.01;
const MARGIN: f64 = 0.15;
/// A tension is wanted in a window as far as it is larger than a part of the largest one, unless even that is less than a part of the largest magnitude.
const TENSE: f64 = 0.5;
const TENSION: f64 = 0.005;
/// How often a window is narrowed, and how many points are looked at from one end of a contact to the next, and down.
const ROUNDS: usize = 3;
const ALONG: usize = 12;
const DOWN: usize = 24;

impl Field {
    /// Where a quantity is appreciable, as [`Self::window`]: what presses on the top face, and all places of that window where the
    /// quantity is larger than about a seventh of its largest value, or a normal stress or strain than half the largest tension.
    ///
    /// ```
    /// use recede::{FieldQuantity, HalfPlane, Homogeneous, Model, Plane, Punch, Stack};
    /// let strip = Homogeneous::new(1.0, 1.0, 0.25)?;
    /// let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(HalfPlane::new(1.0, 0.25)?).build()?;
    /// let model = Model::new(stack)?;
    /// // the contact below is much longer than this one
    /// let field = model.field(&model.press(&Punch::cylinder(1.0)?, 0.002)?)?;
    /// let [[left, right], [top, bottom]] = field.window_of(FieldQuantity::MaxShear)?;
    /// let [[_, farthest], [_, deepest]] = field.window();
    /// assert!(left == -right && right < 0.2 * farthest && top == 0.0 && bottom < 0.2 * deepest);
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// If the fields cannot be computed.
    pub fn window_of(&self, quantity: FieldQuantity) -> Result<[[f64; 2]; 2], FieldError> {
        let mut window = self.window();
        let [presses, depths] = self.least_window();
        for _ in 0..ROUNDS {
            let [along, [top, bottom]] = window;
            // denser towards the top face, on which most quantities are largest
            let down = |k: usize| top + (bottom - top) * (k as f64 / DOWN as f64).powi(2);
            let grids = self.by_layer(&self.places(along), &(0..=DOWN).map(down).collect::<Vec<_>>())?;
            let points = || grids.iter().flat_map(|grid| grid.points());
            let mut values: Vec<f64> = points().map(|point| quantity.of(point).abs()).collect();
            values.retain(|value| value.is_finite());
            values.sort_by(f64::total_cmp);
            let Some(largest) = values.get(((1.0 - SINGULAR) * values.len() as f64) as usize) else { break };
            let of = |point: &FieldPoint| quantity.of(point);
            let tensions = points().map(of).filter(|value| quantity.is_tensile() && value.is_finite());
            let tension = TENSE * tensions.fold(TENSION / TENSE * largest, f64::max);
            let is_tense = |value: f64| quantity.is_tensile() && value >= tension;
            let seen = points().filter(|point| of(point).abs() >= APPRECIABLE * largest || is_tense(of(point)));
            let mut wanted = [presses, depths];
            for point in seen {
                let [x, depth] = &mut wanted;
                *x = [x[0].min(point.x), x[1].max(point.x)];
                *depth = [depth[0].min(point.depth), depth[1].max(point.depth)];
            }
            let margin = wanted.map(|[from, to]| MARGIN * (to - from));
            for (k, [from, to]) in window.iter_mut().enumerate() {
                *from = from.max(wanted[k][0] - margin[k]);
                *to = to.min(wanted[k][1] + margin[k]);
            }
            if self.is_even {
                let half = 0.5 * (window[0][1] - window[0][0]);
                window[0] = [self.middle - half, self.middle + half];
            }
        }
        Ok(window)
    }

    /// What presses on the top face, and half as deep as that is long.
    fn least_window(&self) -> [[f64; 2]; 2] {
        let mirrored = if self.is_even { -1.0 } else { 1.0 };
        let ends = self.pressures.iter().take(1).flat_map(|pressure| &pressure.ends);
        let ends = ends.flat_map(|end| [*end, mirrored * end]);
        let reach = ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, r], end| [l.min(end), r.max(end)]);
        let [from, to] = self.superposed_ends().unwrap_or(reach);
        [[from, to].map(|x| self.middle + x), [0.0, 0.25 * (to - from)]]
    }

    /// Places between two, some between each two ends of contacts.
    fn places(&self, [from, to]: [f64; 2]) -> Vec<f64> {
        let mirrored = if self.is_even { -1.0 } else { 1.0 };
        let ends = self.pressures.iter().flat_map(|pressure| &pressure.ends);
        let ends = ends.flat_map(|end| [*end, mirrored * end]).map(|end| self.middle + end);
        let mut ends: Vec<f64> = ends.filter(|x| *x > from && *x < to).chain([from, to]).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let between = |pair: &[f64]| {
            let (start, step) = (pair[0], (pair[1] - pair[0]) / ALONG as f64);
            (0..ALONG).map(move |k| start + step * k as f64)
        };
        ends.windows(2).flat_map(between).chain([to]).collect()
    }

    /// Where stresses are, from and to along x, and in depth: two half-lengths to either side of what presses, and through all layers and one and a half half-lengths into a half-plane, but no
    /// deeper than three. Where layers come apart, what presses counts as no shorter than they are thick, and openings are in it.
    ///
    /// ```
    /// # use recede::{HalfPlane, Model, Plane, Punch, Stack};
    /// # let model = Model::new(Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25)?).build()?)?;
    /// let solution = model.press(&Punch::parabola(500.0)?, 0.002)?;
    /// let half_length = solution.contacts()[0].reach();
    /// assert_eq!(model.field(&solution)?.window(), [[-2.0 * half_length, 2.0 * half_length], [0.0, 1.5 * half_length]]);
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn window(&self) -> [[f64; 2]; 2] {
        let ends = |is_closed: bool| {
            let own = self.pressures.iter().filter(move |pressure| pressure.has_waves() == is_closed);
            let mirrored = if self.is_even { -1.0 } else { 1.0 };
            own.flat_map(|pressure| &pressure.ends).flat_map(move |end| [*end, mirrored * end])
        };
        let reach = |is_closed: bool| {
            ends(is_closed).fold([f64::INFINITY, f64::NEG_INFINITY], |[from, to], end| [from.min(end), to.max(end)])
        };
        let [left, right] = self.superposed_ends().unwrap_or_else(|| reach(false));
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        let (from, to) = self.layers().last().map_or((0.0, 0.0), |(_, [from, to])| (from, to));
        let layers = if to.is_finite() { to } else { from };
        let comes_apart = self.pressures.iter().any(ContactPressure::has_waves);
        // under a line load alone: the thickness of the layers, or 1 on a half-plane, which has no length of its own
        let half = if comes_apart { half.max(layers) } else { half };
        let longest = [half, layers].into_iter().find(|length| *length > 0.0).unwrap_or(1.0);
        let last = if to.is_finite() { to } else { from + GROUND * longest };
        let [opens, closes] = reach(true).map(|end| middle + AROUND * (end - middle));
        let along = [opens.min(middle - BESIDE * longest), closes.max(middle + BESIDE * longest)];
        [along.map(|x| self.middle + x), [0.0, last.min(BELOW * longest)]]
    }
}
