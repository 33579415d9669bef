//! Where stresses are: what maps and tables show unless they are told.
use super::{ContactPressure, Field};

/// How far a [`Field::window`] reaches beside the middle, and below the top face, in half-lengths of what presses; how far into a half-plane; and how far about openings, in parts of their distance.
const BESIDE: f64 = 2.0;
const AROUND: f64 = 1.1;
const BELOW: f64 = 3.0;
const GROUND: f64 = 1.5;

impl Field {
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
