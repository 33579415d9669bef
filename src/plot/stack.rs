//! A stack drawn with its punch and contacts, and the pressures below it.
use super::chart::{Beside, Chart, Curve, Frame, Labels, beside, hidden};
use super::depths::Depths;
use super::ground::hatching;
use super::names::{self, Dimension, after, index, symbols, unit};
use super::picture::{Anchor, Colour, Picture, Stroke, italic};
use super::pressure::{highest, lines, pressure};
use super::punch::Presses;
use super::scale::{Scale, short};
use super::style::{FAINT, INK, SMALL, curve, hair};
use crate::scene::Scene;
use crate::solution::{Contact, Interface, Interval, Solution};
use crate::stack::{Placed, Stack};

/// Width of the drawing, without what is left and right of it, in points.
const WIDTH: f64 = 340.0;
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
/// If the largest pressures of two contacts differ by more than this factor, all are drawn in parts of their largest.
const DIFFERENT: f64 = 20.0;
/// Contacts that have a line in the list of pressures, at most.
const LISTED: usize = 5;

/// The stack of a solved scene with punch and contacts, and the contact pressures below it: to scale, unless layers would be too
/// thin or too thick to be seen.
pub fn stack(scene: &Scene, stack: &Stack, solution: &Solution) -> Picture {
    let contacts = solution.contacts();
    let total = stack.total_thickness();
    let longest = solution.extent().unwrap_or(if total > 0.0 { total } else { 1.0 });
    // points per length
    let [most, least] = FILLED.map(|share| share * 0.5 * WIDTH / longest);
    let scale = if total > 0.0 { (HIGHEST / total).clamp(least, most) } else { most };
    let layers: Vec<&Placed> = layers_in_order(stack);
    let mut depth = 0.0;
    let below = layers.iter().map(|placed| {
        depth += placed.layer.thickness().unwrap_or(0.0);
        depth
    });
    let faces = [0.0].into_iter().chain(below).collect();
    let drawing = Drawing { scene, stack, layers, contacts, scale, depths: Depths::new(faces, scale, [0.0, HIGHEST]) };
    let mut picture = Picture::new(WIDTH, HIGHEST);
    drawing.layers(&mut picture);
    drawing.punch(solution.force()).draw(&mut picture);
    drawing.contacts(&mut picture);
    drawing.pressures(&mut picture);
    picture.fitted()
}

/// All layers from the top down, without a half-plane.
fn layers_in_order(stack: &Stack) -> Vec<&Placed> {
    let free = stack.laminates().iter().flat_map(|laminate| laminate.layers());
    free.chain(stack.base().layers()).collect()
}

/// What is drawn: the top face lies at height 0, x = 0 in the middle of the width.
struct Drawing<'a> {
    scene: &'a Scene,
    stack: &'a Stack,
    layers: Vec<&'a Placed>,
    contacts: &'a [Contact],
    /// Points per length along the layers.
    scale: f64,
    depths: Depths,
}

impl Drawing<'_> {
    fn x(&self, x: f64) -> f64 {
        0.5 * WIDTH + self.scale * x
    }

    /// Height at which the base ends.
    fn bottom(&self) -> f64 {
        self.depths.height() + if self.stack.base().foundation().half_plane().is_some() { BASE } else { 12.0 }
    }

    /// The layers from the top down, grey where they are stiff, with what they are called at their right.
    fn layers(&self, picture: &mut Picture) {
        let shown = BASE / self.scale;
        let stiffness = Stiffness::of(self.scene, self.stack, &self.layers, shown);
        let heights: Vec<f64> = self.depths.knots().map(|(_, height)| height).collect();
        let last = self.depths.height();
        let base = self.stack.base().foundation().half_plane();
        let layers = self.layers.iter().copied().zip(heights.windows(2).map(|ends| [ends[0], ends[1]]));
        for (placed, [top, bottom]) in layers.chain(base.map(|placed| (placed, [last, last + BASE]))) {
            let thickness = placed.layer.thickness().unwrap_or(shown);
            let height = bottom - top;
            let slices = if stiffness.varies(placed) { ((height / SLICE) as usize).clamp(1, SLICES) } else { 1 };
            for slice in 0..slices {
                let from = top + height * slice as f64 / slices as f64;
                let depth = thickness * (slice as f64 + 0.5) / slices as f64;
                // down to the bottom, so that no line remains between slices
                picture.rectangle((0.0, from), (WIDTH, bottom), stiffness.grey(placed, depth));
            }
        }
        if base.is_none() {
            hatching(picture, (0.0, WIDTH), last);
        }
        for y in self.bonds() {
            picture.line(&[(0.0, y), (WIDTH, y)], hair(INK));
        }
        picture.line(&[(0.0, 0.0), (WIDTH, 0.0)], hair(INK));
        for (at, y, text) in self.labels() {
            if (y - at).abs() > 2.0 {
                picture.line(&[(WIDTH + 1.0, at), (WIDTH + 7.0, y)], hair(FAINT));
            }
            picture.text((WIDTH + 9.0, y), &text, SMALL, INK, Anchor::Left);
        }
        if let Some(note) = self.depths.note() {
            picture.text((0.0, self.bottom() + 8.0), &note, SMALL, INK, Anchor::Left);
        }
    }

    /// What layers and ground are called.
    fn labels(&self) -> Vec<Beside> {
        let heights: Vec<f64> = self.depths.knots().map(|(_, height)| height).collect();
        let middles = heights.windows(2).map(|ends| 0.5 * (ends[0] + ends[1]));
        let mut labels: Vec<(f64, String)> = middles.zip(self.layers.iter().map(|placed| self.name(placed))).collect();
        let foundation = self.stack.base().foundation();
        let depth = if foundation.half_plane().is_some() { 0.4 * BASE } else { 6.0 };
        let support = foundation.support().map(|(_, support)| support.notation());
        let name = foundation.half_plane().map(|placed| self.name(placed));
        let name = name.or(support.map(|notation| format!("{}, {}", notation.kind, notation.parameters)));
        labels.push((self.depths.height() + depth, name.unwrap_or("rigid".to_owned())));
        beside(labels, 0.0, self.bottom(), "layers")
    }

    /// Thickness and modulus of a layer.
    fn name(&self, placed: &Placed) -> String {
        let modulus = placed.layer.material(0.0, self.scene.geometry.plane()).shear_compliance.recip();
        let [stress, length] = [Dimension::STRESS, Dimension::LENGTH].map(|dimension| after(self.scene, dimension));
        let number = index(placed.number);
        let thick = placed.layer.thickness();
        let end = thick.unwrap_or(BASE / self.scale);
        let thick = thick.map(|h| format!("{}{number} = {}{length}, ", italic("h"), short(h))).unwrap_or_default();
        let below = placed.layer.material(end, self.scene.geometry.plane()).shear_compliance.recip();
        let (mut until, mut at) = (String::new(), "");
        if (below / modulus - 1.0).abs() > 1e-9 {
            match placed.layer.thickness() {
                Some(_) => until = format!(" to {}", short(below)),
                None => at = " at its top",
            }
        }
        format!("{thick}{}{number} = {}{until}{stress}{at}", italic("μ"), short(modulus))
    }

    fn punch(&self, force: f64) -> Presses<'_> {
        let (scene, contact) = (self.scene, self.contacts.first());
        Presses { scene, force, contact, scale: self.scale, middle: self.x(0.0), top: 0.0, ends: (0.0, WIDTH) }
    }

    /// A thick line where bodies touch, and as far as they do.
    fn contacts(&self, picture: &mut Picture) {
        let mut labels = Vec::new();
        for (i, ((contact, y), (symbol, _))) in self.contacts.iter().zip(self.heights()).zip(self.symbols()).enumerate()
        {
            let touching = Stroke { width: 3.0, dash: None, ..curve(i, self.contacts.len()) };
            let tick = |end: f64| [(end, y - 4.0), (end, y + 4.0)];
            // farther out it has opened
            let open = Stroke { dash: Some((2.5, 2.5)), ..hair(INK) };
            let mut from = 0.0;
            for Interval { left, right, .. } in contact.intervals() {
                let [left, right] = [left, right].map(|x| self.x(*x));
                if contact.interface != Interface::Punch {
                    picture.line(&[(from, y), (left, y)], open);
                }
                picture.line(&[(left, y), (right, y)], touching);
                for end in [left, right] {
                    picture.line(&tick(end), Stroke { width: 1.2, ..touching });
                }
                from = right;
            }
            if contact.interface != Interface::Punch {
                picture.line(&[(from, y), (WIDTH, y)], open);
            }
            labels.push((y, names::reach(self.scene, contact, &symbol)));
        }
        for (at, y, text) in beside(labels, 0.0, self.bottom(), "contacts") {
            if (y - at).abs() > 2.0 {
                picture.line(&[(-1.0, at), (-5.0, y)], hair(FAINT));
            }
            picture.text((-6.0, y), &text, SMALL, INK, Anchor::Right);
        }
    }

    /// Heights of the bonded interfaces in the drawing; a rigid base has an outline in any case.
    fn bonds(&self) -> Vec<f64> {
        let contacts: Vec<f64> = self.heights().collect();
        let rigid = self.stack.base().foundation().half_plane().is_none();
        let last = self.layers.len();
        let is_bond = |(i, (_, y)): (usize, (f64, f64))| {
            let contact = contacts.iter().any(|contact| (contact - y).abs() < 1e-6);
            (!contact || rigid && i == last).then_some(y)
        };
        self.depths.knots().enumerate().skip(1).filter_map(is_bond).collect()
    }

    /// Heights of the contacts in the drawing.
    fn heights(&self) -> impl Iterator<Item = f64> {
        let heights: Vec<f64> = self.depths.knots().map(|(_, height)| height).collect();
        let mut layers = 0;
        let below = self.stack.laminates().iter().map(|laminate| {
            layers += laminate.layers().len();
            layers
        });
        let faces: Vec<usize> = [0].into_iter().chain(below).collect();
        faces.into_iter().filter_map(move |face| heights.get(face).copied())
    }

    fn symbols(&self) -> Vec<(String, String)> {
        let interfaces: Vec<Interface> = self.contacts.iter().map(|contact| contact.interface).collect();
        symbols(&interfaces)
    }

    /// The pressures over x, below the contacts where they act: in parts of their largest, if these are very different.
    fn pressures(&self, picture: &mut Picture) {
        let (scene, count) = (self.scene, self.contacts.len());
        let half = 0.5 * WIDTH / self.scale;
        let curves: Vec<Vec<Vec<(f64, f64)>>> = self.contacts.iter().map(|contact| pressure(scene, contact)).collect();
        // an infinite pressure is drawn as far as its curve goes
        let peaks: Vec<f64> = curves.iter().map(|curves| highest(curves)).collect();
        let pressed = || peaks.iter().copied().filter(|peak| *peak > 0.0);
        let (least, most) = (pressed().fold(f64::INFINITY, f64::min), pressed().fold(0.0, f64::max));
        let relative = most > DIFFERENT * least;
        // where nothing but concentrated forces press: their mean over what is drawn
        let force = self.contacts.iter().map(|contact| contact.resultant).fold(0.0, f64::max);
        let height = if most > 0.0 { most } else { force / scene.geometry.size(-half, half) };
        let y = Scale::around([0.0, if relative { 1.0 } else { height }]).rounded();
        let unit_of = |i: usize| if relative && peaks[i] > 0.0 { peaks[i] } else { 1.0 };
        let lines = lines(scene).into_iter().map(|x| vec![(x, 0.0), (x, y.ends().1)]);
        let names = self.contacts.iter().zip(self.symbols()).map(|(contact, (_, symbol))| {
            let name = format!("{symbol}, {}", names::of_contact(scene, contact.interface));
            [name].into_iter().chain(names::largest(scene, contact)).collect::<Vec<_>>().join("\n")
        });
        let drawn = curves.iter().enumerate().zip(names).flat_map(|((i, parts), name)| {
            let scaled = |(x, p): &(f64, f64)| (*x, p / unit_of(i));
            let label = if hidden(i, count, LISTED) { String::new() } else { name };
            // intervals are curves of their own
            let points =
                parts.iter().map(|part| part.iter().map(scaled).chain([(f64::NAN, f64::NAN)]).collect::<Vec<_>>());
            [Curve { points: points.flatten().collect(), stroke: curve(i, count), label }]
        });
        let lines = lines.map(|points| Curve { points, stroke: curve(0, count), label: String::new() });
        let top = self.bottom() + PRESSURES[1];
        let chart = Chart {
            frame: Frame { left: 0.0, top, right: WIDTH, bottom: top + PRESSURES[0] },
            x: Scale::around([-half, half]),
            y: y.clone(),
            x_label: italic(scene.geometry.words().along),
            x_unit: unit(scene, Dimension::LENGTH),
            y_label: if relative { "pressure / its largest" } else { "contact pressure" }.into(),
            y_unit: unit(scene, Dimension::STRESS).filter(|_| !relative),
            curves: drawn.chain(lines).collect(),
            labels: Labels::Listed,
        };
        chart.draw(picture);
    }
}

/// How stiff the layers are compared with each other.
struct Stiffness<'a> {
    scene: &'a Scene,
    /// What is shown of a half-plane.
    shown: f64,
    softest: f64,
    stiffest: f64,
}

impl<'a> Stiffness<'a> {
    fn of(scene: &'a Scene, stack: &Stack, layers: &[&Placed], shown: f64) -> Self {
        let mut found = Self { scene, shown, softest: f64::INFINITY, stiffest: 0.0 };
        for placed in layers.iter().copied().chain(stack.base().foundation().half_plane()) {
            let thickness = placed.layer.thickness().unwrap_or(shown);
            for depth in [0.0, 0.5 * thickness, thickness] {
                let modulus = found.modulus(placed, depth);
                found.softest = found.softest.min(modulus);
                found.stiffest = found.stiffest.max(modulus);
            }
        }
        found
    }

    fn modulus(&self, placed: &Placed, depth: f64) -> f64 {
        placed.layer.material(depth, self.scene.geometry.plane()).shear_compliance.recip()
    }

    fn varies(&self, placed: &Placed) -> bool {
        let thickness = placed.layer.thickness().unwrap_or(self.shown);
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
