//! A stack drawn with its punch and contacts, and the pressures below it.
use recede_layers::Plane;

use super::chart::{APART, Chart, Curve, Frame, Labels, hidden};
use super::depths::DrawnDepths;
use super::displaced::Displaced;
use super::file::PlotError;
use super::names::{self, Dimension, after, index, unit};
use super::picture::{Anchor, Colour, Picture, Stroke, WHITE, italic};
use super::pressure::{highest, lines, pressure, under_weight};
use super::punch::rounded_down;
use super::scale::{Scale, label, short};
use super::section::{self, GROUND, Outline, Section, WIDTH, dashed, hatching, height_at, level};
use super::style::{INK, SMALL, curve};
use crate::profile::FaceProfiles;
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
    let (mut drawing, note) = Drawing::new(scene, stack, solution, [scale, middle]);
    drawing.draw(&note.into_iter().collect::<Vec<_>>())
}

/// The stack of a solved scene as [`stack`] draws it, but with its faces displaced: a profile along its faces between the first and
/// the last of its places.
///
/// Displacements across the layers, gaps and the profiles of punches are drawn larger than lengths along the layers by a factor, by
/// default so that they are seen well: the picture says how many times. They are counted from the rigid base, and in a stack on a half-plane from the ends of its top
/// face in the picture. Displacements along the layers are left out, so that bodies touch in the drawing where they touch.
///
/// ```
/// use recede::{Model, Scene, plot, profile_places};
/// let scene = Scene::from_ron("Scene(geometry: PlaneStrain, punch: Cylinder(radius: 500), force: 0.002, stack: [
///     Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, HalfPlane(shear_modulus: 1, poisson: 0.25)])")?;
/// let model = Model::new(scene.stack()?)?;
/// let solution = model.press(&scene.top, scene.force)?;
/// let profile = model.profile(&scene.top, &solution, &profile_places(&solution, None, 400))?;
/// let picture = plot::deformed(&scene, model.stack(), &solution, &profile, Some(50.0))?;
/// assert!(picture.labels().iter().any(|(text, _)| text.contains("displacements drawn × 50")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`PlotError::Empty`] if there are fewer than two places, or displacements are infinite: a line load presses on x = 0 of a half-plane,
/// from where they are counted. [`PlotError::Drawing`] if the factor is so large that they do not fit on a page.
pub fn deformed(
    scene: &Scene,
    stack: &Stack,
    solution: &Solution,
    profile: &FaceProfiles,
    times: Option<f64>,
) -> Result<Picture, PlotError> {
    let (Some(first), Some(last)) = (profile.x.first(), profile.x.last()) else { return Err(few()) };
    let (scale, middle) = (WIDTH / (last - first), 0.5 * (first + last));
    if !(scale > 0.0 && scale.is_finite()) {
        return Err(few());
    }
    let (mut drawing, note) = Drawing::new(scene, stack, solution, [scale, middle]);
    let displaced = Displaced::new(profile, &drawing.numbers())?;
    let thick: Vec<f64> = drawing.heights.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let times = times.map_or_else(|| Ok(displaced.times(scale, &thick)), |times| displaced.seen(times, scale))?;
    drawing.displace(&displaced, times, &profile.x);
    let notes = [Some(displaced.note(scene, times)), note];
    Ok(drawing.draw(&notes.into_iter().flatten().collect::<Vec<_>>()))
}

fn few() -> PlotError {
    PlotError::Empty("the faces need two places".to_owned())
}

/// A stack with its places in the drawing: the top face lies at height 0.
struct Drawing<'a> {
    section: Section<'a>,
    stack: &'a Stack,
    /// Interfaces that weights press together, and their pressures over x.
    closed: &'a [ClosedInterface],
    pressed: Vec<Vec<(f64, f64)>>,
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
    /// The upper and the lower face of each layer.
    faces: Vec<[Outline; 2]>,
    /// Whether displacements are drawn.
    is_displaced: bool,
}

impl<'a> Drawing<'a> {
    /// A stack at rest, from the scale in points per length and which x is in the middle; and a note on heights that are not to scale.
    fn new(
        scene: &'a Scene,
        stack: &'a Stack,
        solution: &'a Solution,
        [scale, middle]: [f64; 2],
    ) -> (Self, Option<String>) {
        let layers: Vec<&Placed> = stack.groups().flat_map(|group| Group::layers(&group)).collect();
        let mut depth = 0.0;
        let below = layers.iter().filter_map(|placed| placed.layer.thickness()).map(|thickness| {
            depth += thickness;
            depth
        });
        let depths = DrawnDepths::new([0.0].into_iter().chain(below).collect(), scale, [0.0, HIGHEST]);
        let is_ground = stack.base().foundation().half_plane().is_none();
        let base = if is_ground { None } else { Some(depths.height() + BASE) };
        let heights: Vec<f64> = depths.knots.iter().map(|(_, height)| *height).chain(base).collect();
        let half = 0.5 * WIDTH / scale;
        let drawing = Self {
            pressed: under_weight(stack, solution, [middle - half, middle + half]),
            section: Section::new(scene, solution, scale, 0.5 * WIDTH - scale * middle),
            stack,
            closed: solution.closed(),
            is_ground,
            layers,
            middle,
            bottom: base.unwrap_or(depths.height() + GROUND),
            faces: heights.windows(2).map(|pair| [level(pair[0]), level(pair[1])]).collect(),
            heights,
            is_displaced: false,
        };
        (drawing, depths.note())
    }

    fn draw(&mut self, notes: &[String]) -> Picture {
        let mut picture = Picture::new(WIDTH, HIGHEST);
        self.layers(&mut picture);
        for (i, note) in notes.iter().enumerate() {
            picture.text((0.0, self.bottom + 8.0 + APART * i as f64), note, SMALL, INK, Anchor::Left);
        }
        self.section.presses(&mut picture);
        self.interfaces(&mut picture);
        self.pressures(&mut picture);
        picture.fitted()
    }

    /// Moves the faces as far as they are displaced at places along x, times a factor, and the lower end of the drawing below them.
    fn displace(&mut self, displaced: &Displaced, times: f64, xs: &[f64]) {
        let up = times * self.section.scale;
        let places: Vec<f64> = xs.iter().map(|x| self.section.x(*x)).collect();
        let moved = |y: f64, heights: &[f64]| places.iter().zip(heights).map(|(x, v)| (*x, y - up * v)).collect();
        for (pair, (faces, heights)) in self.faces.iter_mut().zip(displaced.faces.iter().zip(self.heights.windows(2))) {
            *pair = [0, 1].map(|k| moved(heights[k], &faces[k]));
        }
        let lowest = |face: &Outline| face.iter().map(|(_, y)| *y).fold(f64::MIN, f64::max);
        let room = if self.is_ground { GROUND } else { BASE };
        self.bottom = self.faces.iter().flatten().map(|face| lowest(face) + room).fold(self.bottom, f64::max);
        if !self.is_ground
            && let Some([_, lower]) = self.faces.last_mut()
        {
            lower.iter_mut().for_each(|(_, y)| *y = self.bottom);
        }
        self.section.top = self.faces.first().map_or(level(0.0), |[upper, _]| upper.clone());
        let lower = displaced.punches.as_deref().unwrap_or_default();
        self.section.punches = Some(moved(0.0, lower));
        self.is_displaced = true;
    }

    /// The shear modulus of a layer at its upper face, in its middle and at its lower face, or as deep as a half-plane is drawn.
    fn moduli(&self, placed: &Placed) -> [f64; 3] {
        [0.0, 0.5, 1.0].map(|part| self.modulus(placed, part))
    }

    /// The shear modulus at a part of what is drawn of a layer.
    fn modulus(&self, placed: &Placed, part: f64) -> f64 {
        let depth = part * placed.layer.thickness().unwrap_or(BASE / self.section.scale);
        placed.layer.material(depth, self.section.scene.geometry.plane()).shear_compliance.recip()
    }

    /// Young's modulus where [`Self::moduli`] are, of an isotropic layer of which the scene gives it.
    fn young(&self, placed: &Placed) -> Option<[f64; 3]> {
        let is_given = placed.layer.notation().parameters.contains("young: ");
        let deep = placed.layer.thickness().unwrap_or(BASE / self.section.scale);
        let at = |part: f64| {
            let material = placed.layer.material(part * deep, Plane::Strain);
            let [poisson, _] = material.out_of_plane.filter(|_| is_given && material.is_isotropic())?;
            Some(2.0 * (1.0 + poisson) / material.shear_compliance)
        };
        Some([at(0.0)?, at(0.5)?, at(1.0)?])
    }

    /// The layers from the top down, light where they are soft and darker where they are stiff by orders of magnitude, with what they are
    /// called at their right.
    fn layers(&self, picture: &mut Picture) {
        let stiffness = Scale::around(self.layers.iter().flat_map(|placed| self.moduli(placed))).logarithmic();
        let mut labels = Vec::new();
        for (placed, [upper, lower]) in self.layers.iter().zip(&self.faces) {
            let slices = if self.varies(placed) { self.slices(upper, lower) } else { 1 };
            for slice in 0..slices {
                let part = |slice: f64| slice / slices as f64;
                let share = stiffness.share(self.modulus(placed, part(slice as f64 + 0.5)));
                let grey = (244.0 - 46.0 * share.clamp(0.0, 1.0)) as u8;
                // down to the bottom, so that no line remains between slices
                let below = |(x, y): &(f64, f64)| (*x, y + (height_at(lower, *x) - y) * part(slice as f64));
                let outline = upper.iter().map(below).chain(lower.iter().rev().copied());
                picture.area(&outline.collect::<Vec<_>>(), Colour { r: grey, g: grey, b: grey });
            }
            labels.push((0.5 * (height_at(upper, WIDTH) + height_at(lower, WIDTH)), self.name(placed)));
        }
        if self.is_ground {
            let lowest = self.bottom - GROUND;
            hatching(picture, lowest);
            let support = self.stack.base().foundation().support().map(|(_, support)| support.notation());
            let name = support.map(|notation| format!("{}, {}", notation.kind, notation.parameters));
            labels.push((lowest + 0.5 * GROUND, name.unwrap_or("rigid".to_owned())));
        }
        if !self.is_displaced {
            labels.extend(self.gaps(picture));
        }
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
            if *interface == Interface::Punch {
                continue;
            }
            draw(&|x| gaps.height(*interface, x), *y, "gap");
        }
        for (face, y) in self.heights.iter().enumerate() {
            let closed = self.closed_at(face).map(|k| &self.closed[k]);
            closed.iter().for_each(|own| draw(&|x| own.gap(x), *y, "opening"));
        }
        labels
    }

    /// The number of what weights press together at the upper face of a layer.
    fn closed_at(&self, face: usize) -> Option<usize> {
        let number = self.layers.get(face.checked_sub(1)?)?.number;
        self.closed.iter().position(|own| matches!(own.interface, Interface::Between { above, .. } if above == number))
    }

    /// The line of a contact by its number, or of an interface that weights press together, which come last.
    fn curve(&self, number: usize) -> Stroke {
        curve(number, self.section.symbols.len())
    }

    /// The numbers of the layers from the top down.
    fn numbers(&self) -> Vec<usize> {
        self.layers.iter().map(|placed| placed.number).collect()
    }

    /// In how many slices a layer is drawn whose stiffness varies.
    fn slices(&self, upper: &Outline, lower: &Outline) -> usize {
        ((height_at(lower, 0.0) - height_at(upper, 0.0)) / SLICE).clamp(1.0, SLICES as f64) as usize
    }

    fn varies(&self, placed: &Placed) -> bool {
        let [top, _, bottom] = self.moduli(placed);
        (bottom / top - 1.0).abs() > VARIES
    }

    /// Thickness and modulus of a layer.
    fn name(&self, placed: &Placed) -> String {
        let [stress, length] =
            [Dimension::STRESS, Dimension::LENGTH].map(|dimension| after(self.section.scene, dimension));
        let young = self.young(placed);
        let moduli = self.moduli(placed);
        let [modulus, _, below] = [0, 1, 2].map(|k| short(young.map_or(moduli[k], |young| young[k])));
        let symbol = italic(if young.is_some() { "E" } else { "μ" });
        let number = index(placed.number);
        let thick = placed.layer.thickness();
        let (until, at) = match thick {
            _ if !self.varies(placed) => (String::new(), ""),
            Some(_) => (format!(" to {below}"), ""),
            None => (String::new(), " at its top"),
        };
        let thick = thick.map_or(String::new(), |h| format!("{}{number} = {}{length}, ", italic("h"), short(h)));
        let name = placed.layer.name().map_or(String::new(), |name| format!("{name}: "));
        format!("{name}{thick}{symbol}{number} = {modulus}{until}{stress}{at}")
    }

    /// Thin lines where layers are bonded and around a rigid base, thick ones where bodies touch, and as far as they do.
    fn interfaces(&self, picture: &mut Picture) {
        let (numbers, contacts) = (self.numbers(), &self.section.contacts);
        let mut labels = Vec::new();
        let faces = self.section.contacts_at(&numbers).into_iter().enumerate();
        for (face, found) in faces.take(self.layers.len() + usize::from(self.is_ground)) {
            let closed = self.closed_at(face);
            let number = found.or(closed.map(|k| contacts.len() + k));
            let touching = Stroke { width: 3.0, dash: None, ..self.curve(number.unwrap_or(0)) };
            let is_last = face == self.layers.len();
            let ground = is_last.then(|| level(self.bottom - GROUND));
            if let Some(line) = &ground {
                self.section.interface(picture, None, line, touching);
            }
            let lower = self.faces.get(face).map(|[upper, _]| upper).filter(|_| !is_last).or(ground.as_ref());
            let upper = face.checked_sub(1).and_then(|above| self.faces.get(above)).map(|[_, lower]| lower);
            // the lower one last, so that its colour is seen
            let lines = upper.filter(|line| self.is_displaced && Some(*line) != lower).into_iter().chain(lower);
            let mut label = None;
            for line in lines {
                match closed {
                    None => label = self.section.interface(picture, found, line, touching),
                    Some(k) => {
                        let openings: Vec<[f64; 2]> =
                            self.closed[k].openings.iter().map(|one| [one.left, one.right]).collect();
                        self.section.spans(picture, &openings, line, [dashed(), touching]);
                    }
                }
            }
            labels.extend(label);
            let intervals = found.map_or(&[][..], |i| contacts[i].intervals());
            for x in intervals.iter().flat_map(|own| [own.left, own.right]).map(|end| self.section.x(end)) {
                let y = lower.map_or(0.0, |line| height_at(line, x.clamp(0.0, WIDTH)));
                picture.line(&[(x, y - 4.0), (x, y + 4.0)], Stroke { width: 1.2, ..touching });
            }
        }
        section::labels(picture, labels, Anchor::Right, [0.0, self.bottom], "contacts");
    }

    /// The pressures over x, below the contacts where they act: in parts of their largest, if these are very different.
    fn pressures(&self, picture: &mut Picture) {
        let Section { scene, ref contacts, scale, ref symbols, .. } = self.section;
        let half = 0.5 * WIDTH / scale;
        let of_contacts = contacts.iter().map(|contact| pressure(scene, contact));
        let curves: Vec<Vec<Vec<(f64, f64)>>> =
            of_contacts.chain(self.pressed.iter().map(|curve| vec![curve.clone()])).collect();
        let count = curves.len();
        if count == 0 {
            return;
        }
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
        let line = |x| Curve { points: vec![(x, 0.0), (x, top)], stroke: self.curve(0), label: String::new() };
        let of_contacts = contacts.iter().map(|contact| (contact.interface, names::largest(scene, contact)));
        let of_closed = self.closed.iter().map(|own| (own.interface, names::central(scene, own)));
        let drawn = of_contacts.chain(of_closed).zip(&curves).enumerate().map(|(i, ((interface, notes), parts))| {
            let unit = if relative && peaks[i] > 0.0 { peaks[i] } else { 1.0 };
            let name = format!("{}, {}", symbols[i].1, names::of_contact(scene, interface));
            let name = [name].into_iter().chain(notes).collect::<Vec<_>>().join("\n");
            let label = if hidden(i, count, LISTED) { String::new() } else { name };
            // intervals are curves of their own
            let points = parts.iter().flat_map(|part| part.iter().copied().chain([(f64::NAN, f64::NAN)]));
            Curve { points: points.map(|(x, p)| (x, p / unit)).collect(), stroke: self.curve(i), label }
        });
        let (top, along) = (self.bottom + PRESSURES[1], italic(scene.coordinates().along()));
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
