//! A quantity inside the stack as a map, with the interfaces, the contacts and the punch.
use super::bands::{Bands, MapStyle};
use super::chart::{Chart, Frame, Labels};
use super::depths::DrawnDepths;
use super::file::PlotError;
use super::names::{self, Dimension, after, unit};
use super::picture::{Anchor, Picture, Stroke, WHITE, italic};
use super::scale::{Scale, short};
use super::section::{self, GROUND, Section, WIDTH, hatching};
use super::style::{INK, SMALL};
use crate::field::{Field, FieldPoint, FieldQuantity, Grid, Point};
use crate::scene::{Punch, Scene};
use crate::solution::Solution;

/// Least and greatest height of the map, in points.
const HEIGHTS: [f64; 2] = [75.0, 380.0];
/// Least height of the scale of colours, in points, and its distance from the labels beside the map.
const BAR: f64 = 150.0;
const BEFORE_BAR: f64 = 12.0;
/// Distance of lines of text below the map, and of the first from the map, in points.
const LINE: f64 = 12.0;
const BELOW: f64 = 46.0;
/// Width of a contact, in points, and at most in parts of the height of a layer.
const CONTACT: f64 = 2.4;
const BETWEEN: f64 = 0.3;
/// Where the arms of the cross begin and end that marks an extreme, in points from its place.
const ARMS: [f64; 2] = [3.0, 8.5];
/// Values that differ by less than this part are the same.
const SAME: f64 = 1e-6;
/// Where a quantity is infinite, this part of the points may lie above the colours, and as many below: half as much hides less
/// and leaves the colours to a few points next to the singular one.
const BEYOND: f64 = 0.01;
/// Values have one sign if values of the other one are smaller than this part of the largest; zero belongs to their colours if the
/// smallest is smaller than that part; logarithmic colours begin at that part.
const OTHER_SIGN: f64 = 0.005;
const NEAR_ZERO: f64 = 0.5;
const DECADES: f64 = 1e-3;
/// Where a quantity is infinite, a tension smaller than this multiple of the largest one in colours is not one next to a singular point.
const WITHIN: f64 = 1.5;

/// A quantity on grids that reach the faces of the layers, see [`Field::by_layer`], as bands of colour, with the interfaces, contacts
/// in bold, and a cross where the quantity is largest: the largest shear stress where [`Field::max_shear`] finds it, others
/// on the grid, normal stresses and strains where tension is. Colours go from light to dark where values have one sign; where they
/// have two, they are blue below 0 and red above, with a line at 0.
///
/// # Errors
/// [`PlotError::Empty`] if the grids have fewer than two places and depths, or the quantity is nowhere finite.
pub fn map(
    scene: &Scene,
    solution: &Solution,
    field: &Field,
    grids: &[Grid],
    quantity: FieldQuantity,
) -> Result<Picture, PlotError> {
    map_with(scene, solution, field, grids, quantity, &MapStyle::default())
}

/// The same as [`map`] with other colours.
///
/// # Errors
/// As [`map`]; [`PlotError::Drawing`] if colours are to be logarithmic, and the values or the range are not positive.
pub fn map_with(
    scene: &Scene,
    solution: &Solution,
    field: &Field,
    grids: &[Grid],
    quantity: FieldQuantity,
    style: &MapStyle,
) -> Result<Picture, PlotError> {
    let points = || grids.iter().flat_map(|grid| grid.points());
    let over = |pick: fn(&FieldPoint) -> f64| Scale::around(points().map(pick));
    let (x, depth) = (over(|point| point.x), over(|point| point.depth).ends());
    let along = scene.coordinates().along();
    if grids.is_empty() || grids.iter().any(|grid| grid.xs().len() < 2) {
        return Err(PlotError::Empty(format!("a map needs two places along {along} and two depths")));
    }
    let layers: Vec<_> = field.layers().collect();
    let on_ground = layers.last().is_some_and(|(_, [_, to])| *to <= depth.1 * (1.0 + 1e-9));
    let per_length = WIDTH / (x.ends().1 - x.ends().0);
    let depths = DrawnDepths::new(vec![depth.0, depth.1], per_length, HEIGHTS);
    let error = error(field, grids, quantity);
    let value = |point: &FieldPoint| known(quantity.of_in(point, scene.coordinates()), error);
    // infinite or not defined because stresses are infinite at this point
    let is_singular = |point: &FieldPoint| point.sigma_yy.is_infinite() && !quantity.of(point).is_finite();
    let clipped = points().any(is_singular) || depth.0 <= 0.0 && rises(scene, solution, quantity);
    let values = range(points().map(value), clipped).ok_or_else(|| {
        let name = quantity.name_in(scene.coordinates());
        PlotError::Empty(format!("{name} is infinite or not known at all points of the map"))
    })?;
    let largest = Largest::of(scene, field, grids, quantity, error).filter(|largest| {
        known(largest.value, error) != 0.0
            && (!clipped || largest.overall || largest.value.abs() < WITHIN * values.ends().1)
    });
    let chart = Chart {
        frame: Frame { left: 0.0, top: 0.0, right: WIDTH, bottom: depths.height() },
        x: x.of(&italic(along), unit(scene, Dimension::LENGTH)),
        y: Scale::around([depth.0, depth.1]).reversed().of("depth", unit(scene, Dimension::LENGTH)),
        curves: Vec::new(),
        labels: Labels::AtEnds,
    };
    let middle = chart.place((0.0, 0.0)).0;
    let section = Section::new(scene, solution, chart.place((1.0, 0.0)).0 - middle, middle);
    let clipped = clipped && style.range.is_none();
    let map = Map { section, layers, on_ground, quantity, clipped, largest, chart, note: depths.note() };
    // colours reach the value that is called the largest
    let values = match &map.largest {
        Some(Largest { point: (x, at, _), value, .. }) if !map.clipped && map.shows(*x, *at) => values.with(*value),
        _ => values,
    };
    let (name, dimension) = names::of_quantity(quantity, scene.coordinates());
    let shown = shown(values.ends(), style)?.of(&name, unit(scene, dimension));
    let has_signs = shown.ends().0 < 0.0 && shown.ends().1 > 0.0;
    Ok(map.draw(grids, &Bands::new(shown, has_signs.then_some(error), style)))
}

/// The range of colours for values from one to another.
fn shown((low, high): (f64, f64), style: &MapStyle) -> Result<Scale, PlotError> {
    let (least, most) = (low.abs().min(high.abs()), low.abs().max(high.abs()));
    let has_signs = low < -OTHER_SIGN * most && high > OTHER_SIGN * most;
    style.scale(match style.is_logarithmic {
        _ if has_signs => [low, high],
        true => [low.max(DECADES * high), high],
        false if low * high >= 0.0 && least >= NEAR_ZERO * most => [low, high],
        false if high > -low => [0.0, high],
        false => [low, 0.0],
    })
}

/// A value, or 0 if it is less than its error: rounding is not drawn.
fn known(value: f64, error: f64) -> f64 {
    if value.abs() < error { 0.0 } else { value }
}

/// The largest error of a quantity at the sides of the grids, which are far from singular points: where bodies are free of stress it is all
/// that is left. Displacements and strains are as right as stresses, in parts of their largest.
fn error(field: &Field, grids: &[Grid], quantity: FieldQuantity) -> f64 {
    let sides = grids.iter().flat_map(Grid::rows).filter_map(|row| row.last());
    let at = |side: &FieldPoint| Point { x: side.x, depth: side.depth, layer: Some(side.layer) };
    let errors = sides.filter_map(|side| field.stress_error(&at(side)).ok()).filter(|error| error.is_finite());
    let error = errors.fold(0.0, f64::max);
    let largest = |of: FieldQuantity| {
        let values = grids.iter().flat_map(|grid| grid.points()).map(|point| of.of(point).abs());
        values.filter(|value| value.is_finite()).fold(0.0, f64::max)
    };
    match quantity {
        FieldQuantity::U | FieldQuantity::V | FieldQuantity::W => {
            error * largest(quantity) / largest(FieldQuantity::MaxShear).max(error)
        }
        _ if quantity.is_strain() => error * largest(quantity) / largest(FieldQuantity::MaxShear).max(error),
        _ => error,
    }
}

/// Whether a quantity may have both signs.
fn is_signed(quantity: FieldQuantity) -> bool {
    !matches!(quantity, FieldQuantity::MaxShear | FieldQuantity::VonMises)
}

/// Whether a quantity is infinite somewhere on the face on which the punch presses, be it between the points of a grid.
fn rises(scene: &Scene, solution: &Solution, quantity: FieldQuantity) -> bool {
    let infinite = solution.contacts().first().is_some_and(|contact| contact.peak().pressure.is_infinite());
    let has_no_corners = |punch: &Punch| punch.is_sharp() || !punch.is_singular();
    match quantity {
        FieldQuantity::U | FieldQuantity::V | FieldQuantity::W => false,
        // under a tip, stresses along the face and across it are the same
        FieldQuantity::SigmaXy | FieldQuantity::MaxShear | FieldQuantity::GammaXy => {
            let punches = scene.top.punches();
            infinite && !punches.is_some_and(|all| all.parts().all(|(pressed, _)| has_no_corners(pressed.shape())))
        }
        _ => infinite,
    }
}

/// From the smallest to the largest value, without some at both ends where colours are clipped; `None` if no value is finite.
fn range(values: impl Iterator<Item = f64>, clipped: bool) -> Option<Scale> {
    let mut finite: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    finite.sort_by(f64::total_cmp);
    let beyond = if clipped { (BEYOND * finite.len() as f64) as usize } else { 0 };
    let ends = [finite.get(beyond)?, finite.get(finite.len() - 1 - beyond)?];
    Some(Scale::around(ends.map(|end| *end)))
}

/// Where a quantity is largest.
struct Largest {
    /// x, depth, and the layer's number.
    point: (f64, f64, usize),
    value: f64,
    /// What is compared, if not all values.
    what: Option<&'static str>,
    /// Whether the value is the largest of the whole stack, or on the grid of the map only.
    overall: bool,
}

impl Largest {
    /// `None` if it is infinite.
    fn of(scene: &Scene, field: &Field, grids: &[Grid], quantity: FieldQuantity, error: f64) -> Option<Self> {
        if quantity == FieldQuantity::MaxShear
            && let Ok(found) = field.max_shear()
        {
            let point = (found.x, found.depth, found.layer);
            let largest = Self { point, value: found.value, what: None, overall: true };
            return Some(largest).filter(|largest| largest.value.is_finite());
        }
        let value = |point: &FieldPoint| quantity.of_in(point, scene.coordinates());
        let points = grids.iter().flat_map(|grid| grid.points());
        let is_tense = |point: &FieldPoint| value(point).is_finite() && value(point) > error;
        let name = if quantity.is_strain() { "stretch" } else { "tension" };
        let has_tension = quantity.is_tensile() && grids.iter().flat_map(|grid| grid.points()).any(is_tense);
        let tension = has_tension.then_some(name);
        let size = |point: &FieldPoint| if tension.is_some() { value(point) } else { value(point).abs() };
        // of two that are the same the one on the right, and the one above
        let finite = points.filter(|point| value(point).is_finite());
        let larger = |a: &&FieldPoint, b: &&FieldPoint| {
            let (p, q) = (size(a), size(b));
            let same = (p - q).abs() <= SAME * p.abs().max(q.abs());
            let upper = b.depth.total_cmp(&a.depth).then(b.layer.cmp(&a.layer));
            if same { a.x.total_cmp(&b.x).then(upper) } else { p.total_cmp(&q) }
        };
        let point = finite.max_by(larger)?;
        let what = tension.or(is_signed(quantity).then_some("magnitude"));
        Some(Self { point: (point.x, point.depth, point.layer), value: value(point), what, overall: false })
    }
}

struct Map<'a> {
    section: Section<'a>,
    /// Numbers of the layers, and the depths at which they begin and end.
    layers: Vec<(usize, [f64; 2])>,
    /// Whether what does not move begins at the lower end.
    on_ground: bool,
    quantity: FieldQuantity,
    /// Whether the quantity is infinite somewhere, and the colours end before.
    clipped: bool,
    largest: Option<Largest>,
    chart: Chart,
    /// About depths that are not to scale.
    note: Option<String>,
}

impl Map<'_> {
    fn draw(&self, grids: &[Grid], bands: &Bands) -> Picture {
        let mut picture = Picture::new(WIDTH, HEIGHTS[1]);
        let Frame { left, top, right, bottom } = self.chart.frame;
        let coordinates = self.section.scene.coordinates();
        for grid in grids {
            let ys: Vec<f64> = grid.rows().filter_map(|row| Some(row.first()?.depth)).collect();
            let values: Vec<f64> = grid.points().iter().map(|point| self.quantity.of_in(point, coordinates)).collect();
            // what is not known in this layer is left white
            if ys.len() > 1 && values.iter().any(|value| !value.is_nan()) {
                let values = filled(values, grid.xs().len());
                bands.draw(&mut picture, [grid.xs(), &ys], &values, |point| self.chart.place(point));
            }
        }
        if self.chart.y.ends().0 <= 0.0 {
            self.section.presses(&mut picture);
        }
        if self.on_ground {
            hatching(&mut picture, bottom);
        }
        let beside = right + self.interfaces(&mut picture);
        let ground = if self.on_ground { GROUND } else { 0.0 };
        self.chart.draw_with(&mut picture, ground);
        let lowest = bottom.max(top + BAR);
        bands.bar(&mut picture, (beside + BEFORE_BAR, top), lowest);
        if let Some(Largest { point: (x, depth, _), .. }) = self.largest
            && self.shows(x, depth)
        {
            cross(&mut picture, self.chart.place((x, depth)), &self.chart.frame);
        }
        let first = (bottom + BELOW + ground).max(lowest + LINE);
        for (i, line) in self.notes().iter().enumerate() {
            picture.text((left, first + LINE * i as f64), line, SMALL, INK, Anchor::Left);
        }
        picture.fitted()
    }

    /// Bonded ones thin; receding ones bold where there is contact, dashed where they have opened; and how far their labels reach
    /// to the right.
    fn interfaces(&self, picture: &mut Picture) -> f64 {
        let Frame { top, bottom, .. } = self.chart.frame;
        let (first, last) = self.chart.y.ends();
        let height = |depth: f64| self.chart.place((0.0, depth.clamp(first, last))).1;
        // not so wide that they hide thin layers
        let thick = self.layers.iter().map(|(_, [from, to])| height(*to) - height(*from)).filter(|thick| *thick > 0.0);
        let width = thick.fold(CONTACT, |width, thick| width.min(BETWEEN * thick));
        let touching = Stroke { colour: INK, width, dash: None };
        let mut labels: Vec<(f64, String)> = Vec::new();
        for (number, [from, to]) in &self.layers {
            let [upper, lower] = [*from, *to].map(height);
            if upper < lower {
                labels.push((0.5 * (upper + lower), self.section.scene.layer_label(*number)));
            }
        }
        let numbers: Vec<usize> = self.layers.iter().map(|(number, _)| *number).collect();
        let ends = self.layers.last().map(|(_, [_, to])| *to);
        let faces = self.layers.iter().map(|(_, [from, _])| *from).chain(ends);
        for (depth, found) in faces.zip(self.section.contacts_at(&numbers)) {
            if depth < first || depth > last * (1.0 + SAME) {
                continue;
            }
            labels.extend(self.section.interface(picture, found, &section::level(height(depth)), touching));
        }
        section::labels(picture, labels, Anchor::Left, [top, bottom.max(top + BAR)], "labels")
    }

    fn shows(&self, x: f64, depth: f64) -> bool {
        let within = |(low, high): (f64, f64), value: f64| (low..=high).contains(&value);
        within(self.chart.x.ends(), x) && within(self.chart.y.ends(), depth)
    }

    /// Lines of text below the map.
    fn notes(&self) -> Vec<String> {
        let scene = self.section.scene;
        let (_, dimension) = names::of_quantity(self.quantity, scene.coordinates());
        let [stress, length] = [dimension, Dimension::LENGTH].map(|dimension| after(scene, dimension));
        let along = italic(scene.coordinates().along());
        let mut notes = Vec::new();
        if let Some(Largest { point: (x, depth, layer), value, what, overall }) = &self.largest {
            let mark = match (overall, self.shows(*x, *depth)) {
                (true, true) => "cross: largest in the stack".to_owned(),
                (true, false) => "largest in the stack, outside this map".to_owned(),
                (false, _) => {
                    let what = what.map_or(String::new(), |what| format!(" {what}"));
                    format!("cross: largest{what} on the grid of this map")
                }
            };
            let [x, depth, layer] = [short(*x), short(*depth), scene.layer_label(*layer)];
            let place = format!("at {along} = {x}{length}, depth {depth}{length} in {layer}");
            notes.push(format!("{mark}, {}{stress} {place}", short(*value)));
        }
        if self.clipped {
            let [least, most] = [BEYOND, 1.0 - BEYOND].map(|part| 100.0 * part);
            notes.push(format!(
                "infinite at singular points: colours end at the percentiles {least} and {most} of the grid"
            ));
        }
        notes.extend(self.note.clone());
        notes
    }
}

/// A cross with an open middle, in which one sees what is there, without arms that leave a frame.
fn cross(picture: &mut Picture, (x, y): (f64, f64), frame: &Frame) {
    let arms = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)];
    let arms = arms.map(|(right, down)| ARMS.map(|arm| (x + right * arm, y + down * arm)));
    let holds = |(x, y): (f64, f64)| x > frame.left && x < frame.right && y > frame.top && y < frame.bottom;
    for stroke in [Stroke { colour: WHITE, width: 3.0, dash: None }, Stroke { colour: INK, width: 1.0, dash: None }] {
        arms.iter().filter(|arm| holds(arm[1])).for_each(|arm| picture.line(arm, stroke));
    }
}

/// The values of a grid; for those that are not defined, at singular points, the ones next to them.
fn filled(mut values: Vec<f64>, columns: usize) -> Vec<f64> {
    for i in 0..values.len() {
        if values[i].is_nan() {
            let beside = [i.checked_sub(1), Some(i + 1), Some(i + columns), i.checked_sub(columns)];
            let known = beside.into_iter().flatten().filter_map(|k| values.get(k)).find(|value| !value.is_nan());
            values[i] = known.copied().unwrap_or(0.0);
        }
    }
    values
}
