//! A quantity inside the stack as a map, with the interfaces, the contacts and the punch.
use super::chart::{Chart, Frame, Labels, apart, with_unit};
use super::contour::rings;
use super::file::PlotError;
use super::ground::hatching;
use super::names::{self, Dimension, symbols, unit};
use super::picture::{Anchor, Colour, Picture, Stroke, WHITE, italic};
use super::punch::{ABOVE, Punch};
use super::scale::{Scale, label};
use super::style::{FAINT, INK, SMALL, TEXT, hair, heat};
use crate::field::{Field, FieldPoint, FieldQuantity, Grid};
use crate::scene::Scene;
use crate::solution::{Contact, Interface, Solution};

/// Width of the map, and its smallest and greatest height, in points: depths are stretched or compressed to keep them.
const WIDTH: f64 = 340.0;
const HEIGHTS: [f64; 2] = [75.0, 380.0];
/// Room left of the map, between map and colours, and right of the colours, in points.
const LEFT: f64 = 62.0;
const BETWEEN: f64 = 92.0;
const RIGHT: f64 = 64.0;
/// Above a map that does not begin at the top face, and below any, in points.
const TOP: f64 = 16.0;
const BELOW: f64 = 62.0;
/// Width and least height of the scale of colours, in points.
const BAR: [f64; 2] = [12.0, 150.0];
/// Room for the sign of what does not move, in points.
const GROUND: f64 = 12.0;
/// Values that differ by less than this part are the same.
const SAME: f64 = 1e-6;
/// Where a quantity is infinite, this part of the points may lie above the colours, and as many below: half as much hides less
/// and leaves the colours to a few points next to the singular one.
const BEYOND: f64 = 0.01;
/// Fewest bands of colour.
const BANDS: usize = 10;

/// A quantity on grids that reach the faces of the layers, see [`Field::by_layer`], as bands of colour, which become
/// darker as the quantity grows, the interfaces, contacts in bold, and a ring where the quantity is largest.
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
    let points = || grids.iter().flat_map(|grid| grid.points());
    let over = |pick: fn(&FieldPoint) -> f64| Scale::around(points().map(pick)).ends();
    let (x, depth) = (over(|point| point.x), over(|point| point.depth));
    if grids.is_empty() || grids.iter().any(|grid| grid.xs().len() < 2) {
        return Err(PlotError::Empty("a map needs two places along x and two depths".into()));
    }
    let clipped = points().any(|point| is_singular(point, quantity));
    let values = range(points().map(|point| quantity.of(point)), clipped).ok_or_else(|| {
        PlotError::Empty(format!("{} is infinite or not known at all points of the map", quantity.name()))
    })?;
    let Layout { frame, scale, shown, stretched, ground } = Layout::new(field, x, depth);
    let map = Map {
        scene,
        contacts: solution.contacts(),
        layers: field.layers().collect(),
        grids,
        quantity,
        colours: Colours::new(values.rounded(), quantity),
        clipped,
        chart: Chart {
            frame,
            x: Scale::around([x.0, x.1]),
            y: Scale::around([depth.0, depth.1 + ground]).reversed(),
            x_label: italic("x"),
            x_unit: unit(scene, Dimension::Length),
            y_label: "depth".into(),
            y_unit: unit(scene, Dimension::Length),
            curves: Vec::new(),
            labels: Labels::AtEnds,
        },
        scale,
    };
    let lowest = (frame.bottom + BELOW).max(frame.top + BAR[1] + TOP);
    let right = BETWEEN + BAR[0] + RIGHT;
    let name = if shown { 9.0 + 0.58 * SMALL * scene.punch.label().chars().count() as f64 } else { 0.0 };
    let mut picture = Picture::new(LEFT + WIDTH + right.max(name), lowest);
    for grid in grids {
        map.bands(&mut picture, grid);
    }
    if shown {
        map.punch().draw(&mut picture);
    }
    map.interfaces(&mut picture);
    map.chart.draw(&mut picture);
    map.largest(&mut picture, frame.bottom + BELOW - 12.0, stretched);
    map.bar(&mut picture);
    Ok(picture)
}

/// Where a map stands in the picture.
struct Layout {
    frame: Frame,
    /// Units of the picture per unit of length, along and across the layers.
    scale: [f64; 2],
    /// Whether the map begins on top, so that the punch is seen.
    shown: bool,
    /// How much higher the map is than to scale.
    stretched: f64,
    /// Depth of the ground drawn below the last layer.
    ground: f64,
}

impl Layout {
    /// For places and depths between these.
    fn new(field: &Field, x: (f64, f64), depth: (f64, f64)) -> Self {
        let along = WIDTH / (x.1 - x.0);
        let to_scale = along * (depth.1 - depth.0);
        let height = to_scale.clamp(HEIGHTS[0], HEIGHTS[1]);
        let across = height / (depth.1 - depth.0);
        let shown = depth.0 <= 0.0;
        let top = if shown { ABOVE } else { TOP };
        let on_ground = field.layers().last().is_some_and(|(_, [_, to])| to <= depth.1 * (1.0 + 1e-9));
        let ground = if on_ground { GROUND } else { 0.0 };
        let frame = Frame { left: LEFT, top, right: LEFT + WIDTH, bottom: top + height + ground };
        Self { frame, scale: [along, across], shown, stretched: height / to_scale, ground: ground / across }
    }
}

/// Whether a quantity is infinite or not defined because stresses are infinite at this point.
fn is_singular(point: &FieldPoint, quantity: FieldQuantity) -> bool {
    point.sigma_yy.is_infinite() && !quantity.of(point).is_finite()
}

/// From the smallest to the largest value, without some at both ends where colours are clipped; `None` if no value is finite.
fn range(values: impl Iterator<Item = f64>, clipped: bool) -> Option<Scale> {
    let mut finite: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    finite.sort_by(f64::total_cmp);
    let beyond = if clipped { (BEYOND * finite.len() as f64) as usize } else { 0 };
    let ends = [finite.get(beyond)?, finite.get(finite.len() - 1 - beyond)?];
    Some(Scale::around(ends.map(|end| *end)))
}

/// Bands of a quantity and their colours.
struct Colours {
    scale: Scale,
    /// Where bands meet.
    edges: Vec<f64>,
}

impl Colours {
    fn new(scale: Scale, quantity: FieldQuantity) -> Self {
        // what cannot be negative begins at nothing
        let scale = match quantity {
            FieldQuantity::MaxShear | FieldQuantity::VonMises => scale.with(0.0),
            _ => scale,
        };
        let (low, high) = scale.ends();
        let ticks: Vec<f64> = scale.ticks().iter().map(|tick| tick.value).collect();
        let step = ticks.windows(2).map(|pair| pair[1] - pair[0]).next().unwrap_or(high - low);
        let parts = (1..5).find(|parts| parts * (ticks.len().max(2) - 1) >= BANDS).unwrap_or(4);
        let width = step / parts as f64;
        let count = ((high - low) / width).round() as usize;
        Self { edges: (1..count).map(|i| low + i as f64 * width).collect(), scale }
    }

    /// The colour of the band that begins at this edge; 0 is the lowest band.
    fn band(&self, index: usize) -> Colour {
        heat(index as f64 / self.edges.len().max(1) as f64)
    }
}

struct Map<'a> {
    scene: &'a Scene,
    contacts: &'a [Contact],
    layers: Vec<(usize, [f64; 2])>,
    grids: &'a [Grid],
    quantity: FieldQuantity,
    colours: Colours,
    /// Whether the quantity is infinite somewhere, and the colours end before.
    clipped: bool,
    chart: Chart,
    scale: [f64; 2],
}

impl Map<'_> {
    /// From the lowest band up, each over all that is higher: so no seams remain.
    fn bands(&self, picture: &mut Picture, grid: &Grid) {
        let xs = grid.xs();
        let depths: Vec<f64> = grid.rows().filter_map(|row| Some(row.first()?.depth)).collect();
        let (Some(first), Some(last)) = (depths.first(), depths.last()) else { return };
        let [from, to] = [(xs[0], *first), (xs[xs.len() - 1], *last)].map(|corner| self.chart.place(corner));
        let values: Vec<f64> = grid.points().iter().map(|point| self.quantity.of(point)).collect();
        if values.iter().all(|value| value.is_nan()) {
            // not known in this layer: left white
            return;
        }
        let values = within(values, xs.len(), self.colours.scale.ends());
        picture.rectangle(from, to, self.colours.band(0));
        let within = |(x, y): (f64, f64)| self.chart.place((between(xs, x), between(&depths, y)));
        for (index, edge) in self.colours.edges.iter().enumerate() {
            let rings = rings(&values, xs.len(), *edge).into_iter();
            let rings: Vec<Vec<_>> = rings.map(|ring| ring.into_iter().map(within).collect()).collect();
            if !rings.is_empty() {
                picture.rings(rings, self.colours.band(index + 1));
            }
        }
    }

    /// Bonded ones thin; receding ones bold where there is contact, dashed where they have opened.
    fn interfaces(&self, picture: &mut Picture) {
        let Frame { left, right, top, bottom } = self.chart.frame;
        let symbols = symbols(&self.contacts.iter().map(|contact| contact.interface).collect::<Vec<_>>());
        let length = unit(self.scene, Dimension::Length).map_or(String::new(), |unit| format!(" {unit}"));
        let visible = |y: f64| y > top - 1e-6 && y < bottom + 1e-6;
        let mut labels: Vec<(f64, String)> = Vec::new();
        for (k, (number, [from, to])) in self.layers.iter().enumerate() {
            let (_, upper) = self.chart.place((0.0, *from));
            let (_, lower) = self.chart.place((0.0, *to));
            let (upper_seen, lower_seen) = (upper.max(top), lower.min(bottom));
            if upper_seen < lower_seen {
                labels.push((0.5 * (upper_seen + lower_seen), format!("layer {number}")));
            }
            let contact = self.contacts.iter().zip(&symbols).find(|(contact, _)| match contact.interface {
                Interface::Punch => k == 0,
                Interface::Between { below, .. } => below == *number,
            });
            if visible(upper) {
                self.interface(picture, upper, contact.map(|(contact, _)| contact));
                if let Some((contact, (symbol, _))) = contact {
                    labels.push((upper, format!("{symbol} = {}{length}", short(contact.innermost().to))));
                }
            }
            if k + 1 == self.layers.len() && to.is_finite() && visible(lower) {
                // what does not move is below
                let last = self.contacts.iter().zip(&symbols).find(
                    |(contact, _)| matches!(contact.interface, Interface::Between { above, .. } if above == *number),
                );
                hatching(picture, (left, right), lower);
                self.interface(picture, lower, last.map(|(contact, _)| contact));
                if let Some((contact, (symbol, _))) = last {
                    labels.push((lower, format!("{symbol} = {}{length}", short(contact.innermost().to))));
                }
            }
        }
        labels.sort_by(|a, b| a.0.total_cmp(&b.0));
        let wanted: Vec<f64> = labels.iter().map(|(y, _)| *y).collect();
        for (y, (at, text)) in apart(&wanted, top, f64::INFINITY).into_iter().zip(&labels) {
            picture.line(&[(right + 1.0, *at), (right + 6.0, y)], hair(FAINT));
            picture.text((right + 9.0, y), text, SMALL, INK, Anchor::Left);
        }
    }

    /// One interface, dark on a light seam, so that it is seen on any colour.
    fn interface(&self, picture: &mut Picture, y: f64, contact: Option<&Contact>) {
        let Frame { left, right, .. } = self.chart.frame;
        let seam = |width: f64| Stroke { colour: WHITE, width, dash: None };
        let inside = contact.is_none_or(|contact| contact.interface != Interface::Punch);
        if inside {
            picture.line(&[(left, y), (right, y)], seam(2.2));
        }
        let Some(contact) = contact else { return picture.line(&[(left, y), (right, y)], hair(INK)) };
        let end = |x: f64| self.chart.place((x, 0.0)).0.clamp(left, right);
        let open = match contact.interface {
            Interface::Punch => hair(INK),
            Interface::Between { .. } => Stroke { dash: Some((2.5, 2.5)), ..hair(INK) },
        };
        let mut touching = Vec::new();
        let mut before = left;
        let intervals = contact.intervals().into_iter().map(|interval| [interval.left, interval.right].map(end));
        for [from, to] in intervals.chain([[right, right]]) {
            if before < from {
                picture.line(&[(before, y), (from, y)], open);
            }
            touching.push((from, to));
            before = to;
        }
        for (from, to) in touching.into_iter().filter(|(from, to)| from < to) {
            if inside {
                picture.line(&[(from, y), (to, y)], seam(4.0));
            }
            picture.line(&[(from, y), (to, y)], Stroke { colour: INK, width: 2.4, dash: None });
        }
    }

    fn punch(&self) -> Punch<'_> {
        let Frame { left, top, right, .. } = self.chart.frame;
        let (middle, _) = self.chart.place((0.0, 0.0));
        Punch { scene: self.scene, contact: self.contacts.first(), scale: self.scale, middle, top, ends: (left, right) }
    }

    /// A ring at the largest value, and what it is.
    fn largest(&self, picture: &mut Picture, y: f64, stretch: f64) {
        let points = self.grids.iter().flat_map(|grid| grid.points());
        let value = |point: &FieldPoint| self.quantity.of(point);
        // of two that are the same the one on the right, and the one above
        let points = points.filter(|point| value(point).is_finite());
        let larger = |a: &&FieldPoint, b: &&FieldPoint| {
            let (p, q) = (value(a).abs(), value(b).abs());
            let same = (p - q).abs() <= SAME * p.max(q);
            let upper = b.depth.total_cmp(&a.depth).then(b.layer.cmp(&a.layer));
            if same { a.x.total_cmp(&b.x).then(upper) } else { p.total_cmp(&q) }
        };
        let Some(point) = points.max_by(larger) else { return };
        let (x, at) = self.chart.place((point.x, point.depth));
        let ring: Vec<(f64, f64)> = (0..=24)
            .map(|k| std::f64::consts::TAU * f64::from(k) / 24.0)
            .map(|phi| (x + 3.2 * phi.cos(), at + 3.2 * phi.sin()))
            .collect();
        picture.line(&ring, Stroke { colour: WHITE, width: 2.4, dash: None });
        picture.line(&ring, Stroke { colour: INK, width: 1.0, dash: None });
        let with = |dimension| unit(self.scene, dimension).map_or(String::new(), |unit| format!(" {unit}"));
        let (_, dimension) = names::of_quantity(self.quantity);
        let (stress, length) = (with(dimension), with(Dimension::Length));
        let mut text = format!(
            "ring: largest on this grid, {}{stress} at {} = {}{length}, depth {}{length} in layer {}",
            short(value(point)),
            italic("x"),
            short(point.x),
            short(point.depth),
            point.layer
        );
        if self.clipped {
            let (low, high) = self.colours.scale.ends();
            text += &format!("; infinite at singular points, clipped to {} … {}", short(low), short(high));
        }
        if (stretch - 1.0).abs() > 1e-6 {
            text += &format!("; depths drawn × {}", label(format!("{stretch:.1e}").parse().unwrap_or(1.0)));
        }
        picture.text((self.chart.frame.left, y), &text, SMALL, INK, Anchor::Left);
    }

    /// The scale of colours.
    fn bar(&self, picture: &mut Picture) {
        let Frame { top, right, bottom, .. } = self.chart.frame;
        let (left, bottom) = (right + BETWEEN, bottom.max(top + BAR[1]));
        let right = left + BAR[0];
        let Colours { scale, edges } = &self.colours;
        let height = |value: f64| bottom - scale.share(value) * (bottom - top);
        for index in 0..=edges.len() {
            let from = if index == 0 { bottom } else { height(edges[index - 1]) };
            picture.rectangle((left, from), (right, top), self.colours.band(index));
        }
        picture.line(&[(left, top), (right, top), (right, bottom), (left, bottom), (left, top)], hair(INK));
        for tick in scale.ticks() {
            let y = height(tick.value);
            picture.line(&[(right, y), (right + 3.0, y)], hair(INK));
            picture.text((right + 6.0, y), &tick.label, SMALL, INK, Anchor::Left);
        }
        let (name, dimension) = names::of_quantity(self.quantity);
        let title = with_unit(&name, unit(self.scene, dimension).as_deref(), scale.power());
        let widest = scale.ticks().iter().map(|tick| tick.label.chars().count()).max().unwrap_or(0);
        let beside = right + 12.0 + 0.62 * SMALL * widest as f64 + 0.5 * TEXT;
        picture.text((beside, 0.5 * (top + bottom)), &title, TEXT, INK, Anchor::Upwards);
    }
}

/// The values of a grid within the ends of a scale; of those that are not defined, at singular points, the ones next to them.
fn within(mut values: Vec<f64>, columns: usize, (low, high): (f64, f64)) -> Vec<f64> {
    for i in 0..values.len() {
        if values[i].is_nan() {
            let beside = [i.checked_sub(1), Some(i + 1), Some(i + columns), i.checked_sub(columns)];
            let known = beside.into_iter().flatten().filter_map(|k| values.get(k)).find(|value| !value.is_nan());
            values[i] = known.copied().unwrap_or(low);
        }
        values[i] = values[i].clamp(low, high);
    }
    values
}

/// The value at a place between those of a list.
fn between(list: &[f64], at: f64) -> f64 {
    let last = list.len() - 1;
    let at = at.clamp(0.0, last as f64);
    let below = (at as usize).min(last.saturating_sub(1));
    let share = at - below as f64;
    list[below] + share * (list[(below + 1).min(last)] - list[below])
}

/// Four digits.
fn short(value: f64) -> String {
    label(format!("{value:.3e}").parse().unwrap_or(value))
}
