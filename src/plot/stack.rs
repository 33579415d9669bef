//! A stack drawn with its punch and contacts, and the pressures below it.
use super::chart::{Chart, Curve, Frame, Labels, hidden};
use super::depths::DrawnDepths;
use super::names::{self, Dimension, after, index, unit};
use super::picture::{Anchor, Colour, Picture, Stroke, WHITE, italic};
use super::pressure::{highest, lines, pressure};
use super::punch::rounded_down;
use super::scale::{Scale, label, short};
use super::section::{self, GROUND, Section, WIDTH, hatching};
use super::style::{INK, SMALL, curve};
use crate::scene::Scene;
use crate::solution::{ClosedInterface, Contact, Interface, Solution};
use crate::stack::{Group, Placed, Stack};

/// Greatest height of the layers together, in points.
const HIGHEST: f64 = 190.0;
/// Height of the plane of the pressures, and how far below the drawing it begins, in points.
const PRESSURES: [f64; 2] = [140.0, 30.0];
/// Room for what is shown of the base, in points.
const BASE: f64 = 44.0;
/// The longest contact fills the first share of the width, or down to the second one if the stack is to scale then.
const FILLED: [f64; 2] = [0.72, 0.24];
/// Slices of a layer whose stiffness varies, at most, and how high each is at least, in points.
const SLICES: usize = 48;
const SLICE: f64 = 0.5;
/// A modulus that changes by less than this part is the same everywhere.
const VARIES: f64 = 1e-9;
/// If the largest pressures of two contacts differ by more than this factor, all are drawn in parts of their largest.
const DIFFERENT: f64 = 20.0;
/// Greatest height of a gap, in points, and places of its outline.
const GAP: f64 = 8.0;
const POINTS: usize = 170;
/// Contacts that have a line in the list of pressures, at most.
const LISTED: usize = 5;

/// The stack of a solved scene with punch and contacts, and the contact pressures below it: to scale, unless layers would be too
/// thin or too thick to be seen.
pub fn stack(scene: &Scene, stack: &Stack, solution: &Solution) -> Picture {
    let total = stack.total_thickness();
    let [left, right] = solution.ends_with_openings();
    let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
    let longest = [half, total].into_iter().find(|length| *length > 0.0).unwrap_or(1.0);
    // points per length
    let [most, least] = FILLED.map(|share| share * 0.5 * WIDTH / longest);
    let scale = if total > 0.0 { (HIGHEST / total).clamp(least, most) } else { most };
    let layers: Vec<&Placed> = stack.groups().flat_map(|group| Group::layers(&group)).collect();
    let mut depth = 0.0;
    let below = layers.iter().filter_map(|placed| placed.layer.thickness()).map(|thickness| {
        depth += thickness;
        depth
    });
    let faces = [0.0].into_iter().chain(below).collect();
    let depths = DrawnDepths::new(faces, scale, [0.0, HIGHEST]);
    let is_ground = stack.base().foundation().half_plane().is_none();
    let base = if is_ground { None } else { Some(depths.height() + BASE) };
    let drawing = Drawing {
        section: Section::new(scene, solution, scale, 0.5 * WIDTH - scale * middle),
        stack,
        closed: solution.closed(),
        is_ground,
        layers,
        middle,
        bottom: base.unwrap_or(depths.height() + GROUND),
        heights: depths.knots.iter().map(|(_, height)| *height).chain(base).collect(),
    };
    let mut picture = Picture::new(WIDTH, HIGHEST);
    drawing.layers(&mut picture);
    if let Some(note) = depths.note() {
        picture.text((0.0, drawing.bottom + 8.0), &note, SMALL, INK, Anchor::Left);
    }
    drawing.section.presses(&mut picture);
    drawing.interfaces(&mut picture);
    drawing.pressures(&mut picture);
    picture.fitted()
}

/// A stack with its places in the drawing: the top face lies at height 0.
struct Drawing<'a> {
    section: Section<'a>,
    stack: &'a Stack,
    /// Interfaces that weights press together.
    closed: &'a [ClosedInterface],
    /// Whether what does not move is below the layers.
    is_ground: bool,
    /// From the top down, a half-plane included.
    layers: Vec<&'a Placed>,
    /// x in the middle of the width.
    middle: f64,
    /// Heights of the faces of the layers, from the top down.
    heights: Vec<f64>,
    /// Height at which the base ends.
    bottom: f64,
}

impl Drawing<'_> {
    /// The shear modulus of a layer at its upper face, in its middle and at its lower face, or as deep as a half-plane is drawn.
    fn moduli(&self, placed: &Placed) -> [f64; 3] {
        [0.0, 0.5, 1.0].map(|part| self.modulus(placed, part))
    }

    /// The shear modulus at a part of what is drawn of a layer.
    fn modulus(&self, placed: &Placed, part: f64) -> f64 {
        let depth = part * placed.layer.thickness().unwrap_or(BASE / self.section.scale);
        placed.layer.material(depth, self.section.scene.geometry.plane()).shear_compliance.recip()
    }

    /// The layers from the top down, light where they are soft and darker where they are stiff by orders of magnitude, with what they are
    /// called at their right.
    fn layers(&self, picture: &mut Picture) {
        let stiffness = Scale::around(self.layers.iter().flat_map(|placed| self.moduli(placed))).logarithmic();
        let mut labels = Vec::new();
        for (placed, ends) in self.layers.iter().zip(self.heights.windows(2)) {
            let (top, height) = (ends[0], ends[1] - ends[0]);
            let slices = if self.varies(placed) { ((height / SLICE) as usize).clamp(1, SLICES) } else { 1 };
            for slice in 0..slices {
                let part = |slice: f64| slice / slices as f64;
                let share = stiffness.share(self.modulus(placed, part(slice as f64 + 0.5)));
                let grey = (244.0 - 46.0 * share.clamp(0.0, 1.0)) as u8;
                // down to the bottom, so that no line remains between slices
                let from = top + height * part(slice as f64);
                picture.rectangle((0.0, from), (WIDTH, ends[1]), Colour { r: grey, g: grey, b: grey });
            }
            labels.push((top + 0.5 * height, self.name(placed)));
        }
        if self.is_ground {
            let lowest = self.heights[self.heights.len() - 1];
            hatching(picture, lowest);
            let support = self.stack.base().foundation().support().map(|(_, support)| support.notation());
            let name = support.map(|notation| format!("{}, {}", notation.kind, notation.parameters));
            labels.push((lowest + 0.5 * GROUND, name.unwrap_or("rigid".to_owned())));
        }
        labels.extend(self.gaps(picture));
        section::labels(picture, labels, Anchor::Left, [0.0, self.bottom], "layers");
    }

    /// Gaps as they were before anything was loaded, and openings, in the layers above them. Returns labels that say by how much they are drawn higher than to scale.
    fn gaps(&self, picture: &mut Picture) -> Vec<(f64, String)> {
        let (numbers, gaps) = (self.numbers(), self.stack.gaps());
        let mut labels = Vec::new();
        let mut draw = |height: &dyn Fn(f64) -> f64, y: f64, what: &str| {
            let places = (0..=POINTS).map(|k| WIDTH * k as f64 / POINTS as f64);
            // beyond its ends a gap is not known
            let at = |x: f64| (x, height((x - self.section.middle) / self.section.scale));
            let known: Vec<(f64, f64)> = places.map(at).filter(|(_, height)| height.is_finite()).collect();
            let highest = known.iter().fold(0.0, |most: f64, (_, height)| most.max(*height));
            if highest > 0.0 {
                let times = rounded_down(GAP / (highest * self.section.scale)).max(1.0);
                let outline = known.iter().map(|(x, height)| (*x, y - (times * self.section.scale * height).min(GAP)));
                let ends = known.last().into_iter().chain(known.first()).map(|(x, _)| (*x, y));
                picture.area(&outline.chain(ends).collect::<Vec<_>>(), WHITE);
                labels.push((y, format!("{what} drawn × {}", label(times))));
            }
        };
        for (found, y) in self.section.contacts_at(&numbers).into_iter().zip(&self.heights) {
            let Some(Contact { interface, .. }) = found.map(|i| &self.section.contacts[i]) else { continue };
            draw(&|x| gaps.height(*interface, x), *y, "gap");
        }
        for own in self.closed {
            let Interface::Between { above, .. } = own.interface else { continue };
            let face = numbers.iter().position(|number| *number == above).map(|layer| layer + 1);
            face.iter().for_each(|face| draw(&|x| own.gap(x), self.heights[*face], "opening"));
        }
        labels
    }

    /// The numbers of the layers from the top down.
    fn numbers(&self) -> Vec<usize> {
        self.layers.iter().map(|placed| placed.number).collect()
    }

    fn varies(&self, placed: &Placed) -> bool {
        let [top, _, bottom] = self.moduli(placed);
        (bottom / top - 1.0).abs() > VARIES
    }

    /// Thickness and modulus of a layer.
    fn name(&self, placed: &Placed) -> String {
        let [stress, length] =
            [Dimension::STRESS, Dimension::LENGTH].map(|dimension| after(self.section.scene, dimension));
        let [modulus, _, below] = self.moduli(placed).map(short);
        let number = index(placed.number);
        let thick = placed.layer.thickness();
        let (until, at) = match thick {
            _ if !self.varies(placed) => (String::new(), ""),
            Some(_) => (format!(" to {below}"), ""),
            None => (String::new(), " at its top"),
        };
        let thick = thick.map_or(String::new(), |h| format!("{}{number} = {}{length}, ", italic("h"), short(h)));
        format!("{thick}{}{number} = {modulus}{until}{stress}{at}", italic("μ"))
    }

    /// Thin lines where layers are bonded and around a rigid base, thick ones where bodies touch, and as far as they do.
    fn interfaces(&self, picture: &mut Picture) {
        let (numbers, contacts) = (self.numbers(), self.section.contacts);
        let mut labels = Vec::new();
        let faces = self.section.contacts_at(&numbers).into_iter().zip(&self.heights).enumerate();
        for (face, (found, y)) in faces.take(self.layers.len() + usize::from(self.is_ground)) {
            let touching = Stroke { width: 3.0, dash: None, ..curve(found.unwrap_or(0), contacts.len()) };
            if self.is_ground && face == self.layers.len() {
                self.section.interface(picture, None, *y, touching);
            }
            labels.extend(self.section.interface(picture, found, *y, touching));
            let intervals = found.map_or(&[][..], |i| contacts[i].intervals());
            for x in intervals.iter().flat_map(|own| [own.left, own.right]).map(|end| self.section.x(end)) {
                picture.line(&[(x, y - 4.0), (x, y + 4.0)], Stroke { width: 1.2, ..touching });
            }
        }
        section::labels(picture, labels, Anchor::Right, [0.0, self.bottom], "contacts");
    }

    /// The pressures over x, below the contacts where they act: in parts of their largest, if these are very different.
    fn pressures(&self, picture: &mut Picture) {
        let Section { scene, contacts, scale, ref symbols, .. } = self.section;
        let (count, half) = (contacts.len(), 0.5 * WIDTH / scale);
        let curves: Vec<Vec<Vec<(f64, f64)>>> = contacts.iter().map(|contact| pressure(scene, contact)).collect();
        // an infinite pressure is drawn as far as its curve goes
        let peaks: Vec<f64> = curves.iter().map(|curves| highest(curves)).collect();
        let pressed = || peaks.iter().copied().filter(|peak| *peak > 0.0);
        let (least, most) = (pressed().fold(f64::INFINITY, f64::min), pressed().fold(0.0, f64::max));
        let relative = most > DIFFERENT * least;
        // where nothing but concentrated forces press: their mean over what is drawn
        let force = contacts.iter().map(|contact| contact.resultant).fold(0.0, f64::max);
        let height = if most > 0.0 { most } else { force / scene.geometry.size(-half, half) };
        let y = match relative {
            true => Scale::around([0.0, 1.0]).of("pressure / its largest", None),
            false => Scale::around([0.0, height]).of("contact pressure", unit(scene, Dimension::STRESS)),
        };
        let y = y.rounded();
        let top = y.ends().1;
        let line = |x| Curve { points: vec![(x, 0.0), (x, top)], stroke: curve(0, count), label: String::new() };
        let drawn = contacts.iter().zip(&curves).enumerate().map(|(i, (contact, parts))| {
            let unit = if relative && peaks[i] > 0.0 { peaks[i] } else { 1.0 };
            let name = format!("{}, {}", symbols[i].1, names::of_contact(scene, contact.interface));
            let name = [name].into_iter().chain(names::largest(scene, contact)).collect::<Vec<_>>().join("\n");
            let label = if hidden(i, count, LISTED) { String::new() } else { name };
            // intervals are curves of their own
            let points = parts.iter().flat_map(|part| part.iter().copied().chain([(f64::NAN, f64::NAN)]));
            Curve { points: points.map(|(x, p)| (x, p / unit)).collect(), stroke: curve(i, count), label }
        });
        let (top, along) = (self.bottom + PRESSURES[1], italic(scene.geometry.words().along));
        let chart = Chart {
            frame: Frame { left: 0.0, top, right: WIDTH, bottom: top + PRESSURES[0] },
            x: Scale::around([self.middle - half, self.middle + half]).of(&along, unit(scene, Dimension::LENGTH)),
            y,
            curves: drawn.chain(lines(scene).into_iter().map(line)).collect(),
            labels: Labels::Listed,
        };
        chart.draw(picture);
    }
}
