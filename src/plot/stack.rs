//! A stack drawn to scale with its punch and contacts, and the pressures below it.
use super::chart::{Chart, Curve, Frame, Labels, apart};
use super::ground::hatching;
use super::names::{Dimension, index, symbols, unit};
use super::picture::{Anchor, Colour, Picture, Stroke, italic};
use super::pressure::{highest, pressure};
use super::punch::{ABOVE, Punch};
use super::scale::{Scale, label};
use super::style::{BOLD, FAINT, INK, SMALL, TEXT, curve, hair};
use crate::scene::{Load, Scene};
use crate::solution::{Contact, Interface, Interval, Solution};
use crate::stack::{Placed, Stack};

/// Width of the drawing, without what is left and right of it, in points.
const WIDTH: f64 = 340.0;
/// Greatest height of the layers together, in points.
const HIGHEST: f64 = 190.0;
/// Height of the plane of the pressures, in points.
const PRESSURES: f64 = 140.0;
/// What is left and right of the drawing, in points.
const SIDES: (f64, f64) = (88.0, 20.0);
/// Room for what is shown of the base, in points.
const BASE: f64 = 44.0;
/// The longest contact fills this share of the width, unless the stack is too high for that.
const FILLED: f64 = 0.72;
/// A longest contact below this share of the width would not be seen in the pressures.
const SMALLEST: f64 = 0.1;
/// Slices of a layer whose stiffness varies, at most, and how high each is at least, in points.
const SLICES: usize = 48;
const SLICE: f64 = 0.5;
/// Names of layers, written below each other: of more layers the first and the last ones are named.
const NAMES: usize = 40;

/// The stack of a solved scene drawn to scale, with punch and contacts, and the contact pressures below it.
pub fn stack(scene: &Scene, stack: &Stack, solution: &Solution) -> Picture {
    let contacts = solution.contacts();
    let total = stack.total_thickness();
    let longest = solution.extent().unwrap_or(if total > 0.0 { total } else { 1.0 });
    // points per length
    let scale = (FILLED * 0.5 * WIDTH / longest).min(if total > 0.0 { HIGHEST / total } else { f64::INFINITY });
    let drawing = Drawing { scene, stack, contacts, scale, middle: SIDES.0 + 0.5 * WIDTH, top: ABOVE };
    let rigid = stack.base().foundation().half_plane().is_none();
    let labels = drawing.labels().last().map_or(0.0, |(_, y, _)| y + TEXT);
    let bottom = labels.max(drawing.top + scale * total + if rigid { 12.0 } else { BASE });
    let height = bottom + 22.0 + PRESSURES + 38.0;
    let names = drawing.layers_in_order().into_iter().map(|placed| drawing.name(placed));
    let peaks = contacts.iter().map(|contact| format!("123456789012345{}", short(contact.central_pressure)));
    let longest = names.chain(peaks).chain([scene.punch.label()]).map(|name| name.chars().count()).max().unwrap_or(0);
    let right = SIDES.1 + 0.5 * TEXT * longest as f64;
    let mut picture = Picture::new(SIDES.0 + WIDTH + right, height);
    drawing.layers(&mut picture);
    drawing.punch().draw(&mut picture);
    drawing.contacts(&mut picture);
    drawing.pressures(&mut picture, bottom + 22.0);
    picture
}

/// What is drawn, and where.
struct Drawing<'a> {
    scene: &'a Scene,
    stack: &'a Stack,
    contacts: &'a [Contact],
    scale: f64,
    middle: f64,
    top: f64,
}

impl Drawing<'_> {
    fn ends(&self) -> (f64, f64) {
        (self.middle - 0.5 * WIDTH, self.middle + 0.5 * WIDTH)
    }

    /// The layers from the top down, grey where they are stiff, with what they are called at their right.
    fn layers(&self, picture: &mut Picture) {
        let (left, right) = self.ends();
        let layers = self.layers_in_order();
        let stiffness = Stiffness::of(self.scene, self.stack, &layers);
        let mut y = self.top;
        for placed in &layers {
            let thickness = placed.layer.thickness().unwrap_or(0.0);
            let height = self.scale * thickness;
            let slices = if stiffness.varies(placed) { ((height / SLICE) as usize).clamp(1, SLICES) } else { 1 };
            for slice in 0..slices {
                let share = |i: usize| y + height * i as f64 / slices as f64;
                let depth = thickness * (slice as f64 + 0.5) / slices as f64;
                // down to the bottom, so that no line remains between slices
                picture.rectangle((left, share(slice)), (right, y + height), stiffness.grey(placed, depth));
            }
            y += height;
        }
        match self.stack.base().foundation().half_plane() {
            Some(placed) => picture.rectangle((left, y), (right, y + BASE), stiffness.grey(placed, 0.0)),
            None => hatching(picture, (left, right), y),
        }
        for y in self.bonds() {
            picture.line(&[(left, y), (right, y)], hair(INK));
        }
        picture.line(&[(left, self.top), (right, self.top)], hair(INK));
        for (at, y, text) in self.labels() {
            if y - at > 2.0 {
                picture.line(&[(right + 1.0, at), (right + 7.0, y)], hair(FAINT));
            }
            picture.text((right + 9.0, y), &text, SMALL, INK, Anchor::Left);
        }
    }

    /// What layers and ground are called, the height of each, and the height at which that is written: below each other.
    fn labels(&self) -> Vec<(f64, f64, String)> {
        let mut y = self.top;
        let mut labels = Vec::new();
        for placed in self.layers_in_order() {
            let height = self.scale * placed.layer.thickness().unwrap_or(0.0);
            labels.push((y + 0.5 * height, self.name(placed)));
            y += height;
        }
        let foundation = self.stack.base().foundation();
        let depth = if foundation.half_plane().is_some() { 0.4 * BASE } else { 6.0 };
        let support = foundation.support().map(|(_, support)| support.notation());
        let name = foundation.half_plane().map(|placed| self.name(placed));
        let name = name.or(support.map(|notation| format!("{}({})", notation.kind, notation.parameters)));
        labels.push((y + depth, name.unwrap_or("rigid".to_owned())));
        if let Some(more) = labels.len().checked_sub(NAMES).filter(|more| *more > 1) {
            let left_out: Vec<(f64, String)> = labels.drain(NAMES / 2..NAMES / 2 + more).collect();
            let middle = left_out[more / 2].0;
            labels.insert(NAMES / 2, (middle, format!("{more} more layers")));
        }
        let mut last = f64::NEG_INFINITY;
        let below = |(at, text): (f64, String)| {
            last = at.max(last + 1.25 * TEXT);
            (at, last, text)
        };
        labels.into_iter().map(below).collect()
    }

    /// Thickness and modulus of a layer.
    fn name(&self, placed: &Placed) -> String {
        let modulus = placed.layer.material(0.0, self.scene.plane).shear_compliance.recip();
        let with = |dimension| unit(self.scene, dimension).map_or(String::new(), |unit| format!(" {unit}"));
        let (stress, length) = (with(Dimension::Stress), with(Dimension::Length));
        let number = index(placed.number);
        let end = placed.layer.thickness().unwrap_or(0.0);
        let thick = placed.layer.thickness();
        let thick = thick.map(|h| format!("{}{number} = {}{length}, ", italic("h"), short(h))).unwrap_or_default();
        let below = placed.layer.material(end, self.scene.plane).shear_compliance.recip();
        let until = if (below / modulus - 1.0).abs() > 1e-9 { format!(" to {}", short(below)) } else { String::new() };
        format!("{thick}{}{number} = {}{until}{stress}", italic("μ"), short(modulus))
    }

    fn punch(&self) -> Punch<'_> {
        let scale = [self.scale; 2];
        Punch {
            scene: self.scene,
            contact: self.contacts.first(),
            scale,
            middle: self.middle,
            top: self.top,
            ends: self.ends(),
        }
    }

    /// A thick line where bodies touch, and its half-length.
    fn contacts(&self, picture: &mut Picture) {
        let symbols = self.symbols();
        let heights = self.heights();
        let unit = unit(self.scene, Dimension::Length).map_or(String::new(), |unit| format!(" {unit}"));
        let (left, right) = self.ends();
        let labels = apart(&heights, 0.0, f64::INFINITY);
        let places = heights.into_iter().zip(labels);
        for (i, ((contact, (y, label)), (symbol, _))) in self.contacts.iter().zip(places).zip(symbols).enumerate() {
            let Stroke { colour, .. } = curve(i, self.contacts.len());
            let touching = Stroke { colour, width: 3.0, dash: None };
            if contact.interface != Interface::Punch {
                // farther out it has opened
                let open = Stroke { dash: Some((2.5, 2.5)), ..hair(INK) };
                let mut from = left;
                for Interval { left, right, .. } in contact.intervals() {
                    picture.line(&[(from, y), (self.middle + self.scale * left, y)], open);
                    from = self.middle + self.scale * right;
                }
                picture.line(&[(from, y), (right, y)], open);
            }
            for interval in contact.intervals() {
                let [from, to] = [interval.left, interval.right].map(|x| self.middle + self.scale * x);
                picture.line(&[(from, y), (to, y)], touching);
                for end in [from, to] {
                    picture.line(&[(end, y - 5.0), (end, y + 5.0)], Stroke { width: 1.2, ..touching });
                }
            }
            let text = format!("{symbol} = {}{unit}", short(contact.innermost().to));
            picture.text((left - 6.0, label), &text, SMALL, INK, Anchor::Right);
        }
    }

    /// Heights of the bonded interfaces in the drawing; a rigid base has an outline in any case.
    fn bonds(&self) -> Vec<f64> {
        let contacts = self.heights();
        let mut y = self.top;
        let mut bonds = Vec::new();
        for placed in self.layers_in_order() {
            y += self.scale * placed.layer.thickness().unwrap_or(0.0);
            bonds.push(y);
        }
        let rigid = self.stack.base().foundation().half_plane().is_none();
        let last = bonds.len();
        let is_bond = |(i, y): (usize, f64)| {
            let contact = contacts.iter().any(|contact| (contact - y).abs() < 1e-6);
            (!contact || rigid && i + 1 == last).then_some(y)
        };
        bonds.into_iter().enumerate().filter_map(is_bond).collect()
    }

    fn layers_in_order(&self) -> Vec<&Placed> {
        let free = self.stack.laminates().iter().flat_map(|laminate| laminate.layers());
        free.chain(self.stack.base().layers()).collect()
    }

    /// Heights of the contacts in the drawing.
    fn heights(&self) -> Vec<f64> {
        let mut y = self.top;
        let below = self.stack.laminates().iter().map(|laminate| {
            y += self.scale * laminate.thickness();
            y
        });
        let below: Vec<f64> = below.collect();
        [self.top].into_iter().chain(below).collect()
    }

    fn symbols(&self) -> Vec<(String, String)> {
        let interfaces: Vec<Interface> = self.contacts.iter().map(|contact| contact.interface).collect();
        symbols(&interfaces)
    }

    /// The pressures over x, below the contacts where they act.
    fn pressures(&self, picture: &mut Picture, top: f64) {
        let longest = self.contacts.iter().map(Contact::reach).fold(0.0, f64::max);
        let mut half = 0.5 * WIDTH / self.scale;
        if longest > 0.0 && longest < SMALLEST * half {
            half = longest / FILLED;
        }
        // an infinite pressure is drawn as far as its curve goes
        let highest = self.contacts.iter().map(|contact| highest(&pressure(self.scene, contact))).fold(0.0, f64::max);
        // where nothing but line loads presses: their mean over the width that is drawn
        let force: f64 = self.contacts.iter().map(|contact| contact.resultant).fold(0.0, f64::max);
        let y = Scale::around([0.0, if highest > 0.0 { highest } else { force / (2.0 * half) }]).rounded();
        let (left, right) = self.ends();
        let lines = self.scene.punch.load().map_or(Vec::new(), Load::parts);
        let lines = lines.into_iter().filter(|(_, _, load)| load.half_width() == 0.0).flat_map(|(at, _, _)| [at, -at]);
        let stroke = |i: usize| Stroke { width: BOLD, ..curve(i, self.contacts.len()) };
        let lines =
            lines.map(|x| Curve { points: vec![(x, 0.0), (x, y.ends().1)], stroke: stroke(0), label: String::new() });
        let curves = self.contacts.iter().zip(self.symbols()).enumerate().map(|(i, (contact, (_, symbol)))| Curve {
            points: pressure(self.scene, contact),
            stroke: stroke(i),
            label: match contact.central_pressure.is_finite() {
                true => format!("{symbol}(0) = {}", short(contact.central_pressure)),
                false => format!("{symbol}(0) = ∞"),
            },
        });
        let chart = Chart {
            frame: Frame { left, top, right, bottom: top + PRESSURES },
            x: Scale::around([-half, half]),
            y: y.clone(),
            x_label: italic("x"),
            x_unit: unit(self.scene, Dimension::Length),
            y_label: "contact pressure".into(),
            y_unit: unit(self.scene, Dimension::Stress),
            curves: curves.chain(lines).collect(),
            labels: Labels::Listed,
        };
        chart.draw(picture);
    }
}

/// Four digits.
fn short(value: f64) -> String {
    label(format!("{value:.3e}").parse().unwrap_or(value))
}

/// How stiff the layers are compared with each other.
struct Stiffness<'a> {
    scene: &'a Scene,
    softest: f64,
    stiffest: f64,
}

impl<'a> Stiffness<'a> {
    fn of(scene: &'a Scene, stack: &Stack, layers: &[&Placed]) -> Self {
        let mut found = Self { scene, softest: f64::INFINITY, stiffest: 0.0 };
        for placed in layers.iter().copied().chain(stack.base().foundation().half_plane()) {
            let thickness = placed.layer.thickness().unwrap_or(0.0);
            for depth in [0.0, 0.5 * thickness, thickness] {
                let modulus = found.modulus(placed, depth);
                found.softest = found.softest.min(modulus);
                found.stiffest = found.stiffest.max(modulus);
            }
        }
        found
    }

    fn modulus(&self, placed: &Placed, depth: f64) -> f64 {
        placed.layer.material(depth, self.scene.plane).shear_compliance.recip()
    }

    fn varies(&self, placed: &Placed) -> bool {
        let thickness = placed.layer.thickness().unwrap_or(0.0);
        (self.modulus(placed, thickness) / self.modulus(placed, 0.0) - 1.0).abs() > 1e-6
    }

    /// Light where soft, darker where stiff, by orders of magnitude.
    fn grey(&self, placed: &Placed, depth: f64) -> Colour {
        let span = (self.stiffest / self.softest).ln();
        let share = if span > 1e-6 { (self.modulus(placed, depth) / self.softest).ln() / span } else { 0.5 };
        let grey = (244.0 - 46.0 * share.clamp(0.0, 1.0)) as u8;
        Colour { r: grey, g: grey, b: grey }
    }
}
