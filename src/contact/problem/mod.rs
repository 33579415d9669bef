//! The contact problem: a kernel, what presses on each contact, and where the contacts are.
//!
//! Every contact has a [`Side`] that says what is special about it. No other room asks which contact belongs to the punch.
pub(crate) mod abel;
pub(crate) mod accuracy;
pub(crate) mod closed;
pub(crate) mod face;
pub(crate) mod iteration;
pub(crate) mod load;
pub(crate) mod modes;
mod pieces;
pub(crate) mod placed;
pub(crate) mod profile;
pub(crate) mod rows;
pub(crate) mod twin;

use crate::contact::error::ContactError;
use crate::kernel::Kernel;
use crate::numeric::longest;
use crate::numeric::means::MeanWindow;
use crate::numeric::waves::Waves;
use crate::scene::{Force, Gap, Pressed, Punches, Top};
use crate::solution::{Controlled, Interface};

use accuracy::MOST_OPERATIONS;
use closed::ClosedPressure;
use face::Face;
use load::Given;
use placed::Placed;
use profile::PunchProfile;
use twin::Twin;

/// One punch, or one given load, pressed with one force on a stack.
pub(crate) struct Problem<'a> {
    pub(crate) kernel: &'a Kernel,
    /// Names of the contacts, from the top down.
    pub(crate) interfaces: &'a [Interface],
    /// What is special about each of them.
    pub(crate) sides: Vec<Side<'a>>,
    /// Where x = 0 is in the scene, in units of L: where the force acts, if anything is not even.
    pub(crate) origin: f64,
    pub(crate) top: &'a Top,
    /// Gaps at contacts below the uppermost one before anything is loaded, and how the face on top is curved.
    pub(crate) gaps: &'a [(Interface, Gap)],
    /// How far dents that weights press flat lower the face above them.
    pub(crate) hollow: Option<&'a Waves>,
    /// Whether all contacts are even.
    pub(crate) is_even: bool,
    /// P' = P/(μ₀L), or what is expected of it where something else is prescribed of the punch.
    pub(crate) force: f64,
    /// What is prescribed of punches, by their numbers from the left.
    pub(crate) prescribed: Vec<(usize, Prescribed)>,
    /// Relative error wanted.
    pub(crate) tolerance: f64,
    /// Multiplications at most, see [`MOST_OPERATIONS`].
    pub(crate) operations: f64,
}

/// What is prescribed of a punch in place of its force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Prescribed {
    /// Where the contact ends on a side, 1 for the right one and −1 for the left one, in units of L: where all is even the innermost interval, on its right.
    End { side: f64, at: f64 },
    /// How far the punch sinks, in units of L and per unit of P'.
    Depth(f64),
}

impl Prescribed {
    pub(crate) fn controlled(self) -> Controlled {
        match self {
            Self::End { .. } => Controlled::HalfLength,
            Self::Depth(_) => Controlled::Approach,
        }
    }

    /// How far the punch is to sink, if that is prescribed.
    pub(crate) fn depth(self) -> Option<f64> {
        if let Self::Depth(depth) = self { Some(depth) } else { None }
    }

    /// What stands beside a punch in a list, with x = 0 at a place and a unit force, in units of L; none of a force that is given.
    fn of(pressed: &Pressed, origin: f64, length: f64, force: f64) -> Option<Self> {
        match pressed.pressed_by() {
            Force::ForDepth(depth) => Some(Self::Depth(depth / (length * force))),
            Force::ForLeft(place) => Some(Self::End { side: -1.0, at: place / length - origin }),
            Force::ForRight(place) => Some(Self::End { side: 1.0, at: place / length - origin }),
            _ => None,
        }
    }
}

/// An interval to begin with, in units of L.
pub(crate) struct Expected {
    pub(crate) contact: usize,
    pub(crate) punch: usize,
    pub(crate) ends: [f64; 2],
}

/// Force, moment and rotation of a group of intervals: under one punch, or all intervals of a contact between layers.
pub(crate) struct Group {
    /// Their part of P'.
    pub(crate) share: f64,
    /// Their moment about x = 0 over P', in units of L; `None` if it is to be found. Between layers, less moments to be found on top.
    pub(crate) moment: Option<f64>,
    /// Whether the bodies may turn against each other.
    pub(crate) turns: bool,
}

/// What is special about a contact.
pub(crate) enum Side<'a> {
    /// A punch presses there, or the bodies are apart before they are loaded, and all is even.
    Profile(PunchProfile<'a>),
    /// Two bodies that fit together lie on each other: the contact recedes.
    Closed,
    /// Punches press there, or the bodies are apart before they are loaded, and contacts are not even.
    Punches(Vec<Placed<'a>>),
    /// The pressure is given.
    Known(Given<'a>),
    /// The bodies lie on each other but for openings, and this pressure is on them while nothing else presses.
    Openings(ClosedPressure<'a>),
}

impl<'a> Problem<'a> {
    /// A punch or load on the uppermost contact, all others closed; the force is in the units of the scene, and what is expected where it is to be found.
    pub(crate) fn new(
        kernel: &'a Kernel,
        interfaces: &'a [Interface],
        (top, gaps, hollow): (&'a Top, &'a [(Interface, Gap)], Option<&'a Waves>),
        force: f64,
        tolerance: f64,
    ) -> Self {
        let length = kernel.length();
        let twin = Twin::of(kernel.geometry());
        let force = twin.force(force, kernel.modulus(), length);
        let origin = top.middle() / length;
        // dents are below all contacts
        let hollow_below = |contact: usize| hollow.filter(|_| contact == kernel.lowest());
        let is_hollow = hollow.is_some() && (kernel.lowest() > 0 || top.punches().is_some());
        let is_even = top.is_even()
            && (origin == 0.0 || !is_hollow)
            && gaps.iter().all(|(_, gap)| origin == 0.0 && gap.shape().is_even());
        let gap_at =
            |contact: usize| gaps.iter().find(|(own, _)| interfaces.get(contact) == Some(own)).map(|own| &own.1);
        let curvature = gap_at(0).map_or(0.0, |gap| gap.curvature);
        let face = Face { curvature, hollow: hollow_below(0), from: 0.0 };
        let side = match top {
            Top::Loads(loads) => Side::Known(Given::new(loads, origin, length, twin)),
            Top::Punches(punches) => match top.even_punch().filter(|_| is_even) {
                Some(punch) => Side::Profile(PunchProfile::new(punch, length, force, twin).over(face)),
                None => Side::Punches(Placed::all(punches, face, origin, length, force)),
            },
        };
        // a gap is to the layer above what a punch is to the stack
        let below = (1..kernel.contacts()).map(|contact| {
            let face = Face { hollow: hollow_below(contact), ..Face::default() };
            match gap_at(contact).or(face.hollow.map(|_| &Gap::NONE)) {
                None if contact > kernel.lowest() => {
                    let by_dents = None;
                    Side::Openings(ClosedPressure { weight: 0.0, by_dents, length, unit: 1.0, origin })
                }
                None => Side::Closed,
                Some(gap) if is_even => Side::Profile(PunchProfile::gap(gap, length, force, twin).over(face)),
                Some(gap) => Side::Punches(vec![Placed::gap(gap, face, origin, length, force)]),
            }
        });
        let sides = std::iter::once(side).chain(below).collect();
        let all = top.punches().into_iter().flat_map(Punches::parts).enumerate();
        let of = |(number, (pressed, _)): (usize, (&Pressed, f64))| {
            let prescribed = Prescribed::of(pressed, origin, length, force)?;
            Some(match prescribed {
                Prescribed::End { side, at } if is_even => (number, Prescribed::End { side: 1.0, at: side * at }),
                _ => (number, prescribed),
            })
        };
        let (prescribed, operations) = (all.filter_map(of).collect(), MOST_OPERATIONS);
        Self { kernel, interfaces, sides, origin, top, gaps, hollow, is_even, force, prescribed, tolerance, operations }
    }

    /// The same on a kernel of openings, with the pressures of weights and on top that keep the layers together, and of dents that these press flat, in the unit of the scene.
    pub(crate) fn opened(
        kernel: &'a Kernel,
        interfaces: &'a [Interface],
        loaded: (&'a Top, &'a [(Interface, Gap)], Option<&'a Waves>),
        (weights, by_dents): (&[(Interface, f64)], &'a [Waves]),
        force: f64,
        tolerance: f64,
    ) -> Self {
        let mut problem = Self::new(kernel, interfaces, loaded, force, tolerance);
        let unit = kernel.modulus() * problem.force;
        let below = problem.sides.iter_mut().skip(1 + kernel.lowest());
        let (length, origin) = (kernel.length(), problem.origin);
        for (number, (side, (_, weight))) in below.zip(weights).enumerate() {
            let (weight, by_dents) = (weight / unit, by_dents.get(number));
            *side = Side::Openings(ClosedPressure { weight, by_dents, length, unit, origin });
        }
        // dents are about x = 0
        problem.is_even &= by_dents.is_empty() || origin == 0.0;
        problem
    }

    /// The same punch and force on another kernel in the same units, with another tolerance.
    pub(crate) fn on<'b>(&self, kernel: &'b Kernel, interfaces: &'b [Interface], tolerance: f64) -> Problem<'b>
    where
        'a: 'b,
    {
        Problem {
            prescribed: self.prescribed.clone(),
            ..Problem::new(kernel, interfaces, (self.top, self.gaps, self.hollow), self.total_force(), tolerance)
        }
    }

    /// The force in the units of the scene.
    pub(crate) fn total_force(&self) -> f64 {
        self.twin().total_force(self.force, self.kernel.modulus(), self.kernel.length())
    }

    /// Plane or axisymmetric.
    pub(crate) fn twin(&self) -> Twin {
        Twin::of(self.kernel.geometry())
    }

    pub(crate) fn contacts(&self) -> usize {
        self.sides.len()
    }

    /// Whether the pressure of contact i is given.
    pub(crate) fn is_known(&self, i: usize) -> bool {
        matches!(self.sides[i], Side::Known(_))
    }

    /// Where the contact under a punch ends on its right, if that is prescribed.
    pub(crate) fn prescribed_end(&self) -> Option<f64> {
        self.prescribed.iter().find_map(|(_, own)| if let Prescribed::End { at, .. } = own { Some(*at) } else { None })
    }

    /// The contacts whose pressure is to be found.
    pub(crate) fn unknown(&self) -> impl Iterator<Item = usize> {
        (0..self.contacts()).filter(|i| !self.is_known(*i))
    }

    /// What the groups of intervals of a contact carry, from left to right.
    pub(crate) fn groups(&self, contact: usize) -> Vec<Group> {
        match &self.sides[contact] {
            Side::Known(given) => vec![Group { share: 1.0, moment: Some(given.moment), turns: false }],
            Side::Profile(_) if contact == 0 => vec![Group { share: 1.0, moment: None, turns: false }],
            Side::Punches(all) if contact == 0 => all.iter().map(Placed::group).collect(),
            // one for all openings: a gap closes again, and does not turn
            Side::Openings(_) => vec![Group { share: 0.0, moment: None, turns: false }],
            _ => {
                let above = if contact > 0 { self.groups(0) } else { Vec::new() };
                let moment = above.iter().filter_map(|group| group.moment).sum();
                vec![Group { share: 1.0, moment: Some(moment), turns: true }]
            }
        }
    }

    /// What the group of intervals of this number carries: each opening is one by itself.
    pub(crate) fn group(&self, contact: usize, number: usize) -> Option<Group> {
        let number = if self.is_opened(contact) { 0 } else { number };
        self.groups(contact).into_iter().nth(number)
    }

    /// Whether the intervals of a contact are openings.
    pub(crate) fn is_opened(&self, contact: usize) -> bool {
        matches!(self.sides[contact], Side::Openings(_))
    }

    /// Whether all contacts are even.
    pub(crate) fn is_even(&self) -> bool {
        self.is_even
    }

    /// The punch of this number on a contact where nothing is even.
    pub(crate) fn placed(&self, contact: usize, punch: usize) -> Option<&Placed<'a>> {
        if let Side::Punches(all) = &self.sides[contact] { all.get(punch) } else { None }
    }

    /// Where the punch of this number has a sharp tip, if it has one, and by how much its slope jumps there, per unit of P'.
    pub(crate) fn tip(&self, contact: usize, punch: usize) -> Option<(f64, f64)> {
        match &self.sides[contact] {
            Side::Punches(all) => all.get(punch).and_then(Placed::tip),
            Side::Profile(profile) => profile.jump().map(|jump| (0.0, jump)),
            _ => None,
        }
    }

    /// Whether the terms of a pressure under the punch of this number fall fast.
    pub(crate) fn is_smooth(&self, contact: usize, punch: usize) -> bool {
        !self.sides[contact].is_kinked(punch) && self.tip(contact, punch).is_none()
    }

    /// Where the corner of the punch of this number is on a side, 1 for the right one and −1 for the left one, if the punch is flat.
    pub(crate) fn corner(&self, contact: usize, punch: usize, side: f64) -> Option<f64> {
        match &self.sides[contact] {
            Side::Punches(all) => all.get(punch).and_then(|punch| punch.corner(side)),
            Side::Profile(profile) => profile.flat().map(|half| side * half),
            _ => None,
        }
    }

    /// The profiles of all punches, with the contacts where they press.
    pub(crate) fn profiles(&self) -> impl Iterator<Item = (usize, &PunchProfile<'a>)> {
        self.sides.iter().enumerate().filter_map(|(i, side)| side.profile().map(|profile| (i, profile)))
    }

    /// How far out gaps have to be looked at, in units of L: several lengths of the contacts, and all of a profile that falls
    /// somewhere.
    pub(crate) fn span(&self, half_lengths: &[f64]) -> f64 {
        self.last_fall().max(2.0 * longest(half_lengths.iter().copied()) + 2.0)
    }

    /// The last place at which a profile falls, in units of L; 0 if none does so anywhere.
    pub(crate) fn last_fall(&self) -> f64 {
        self.profiles().map(|(_, profile)| profile.last_fall()).fold(0.0, f64::max)
    }

    /// The error to report if a contact has grown to the edge of its punch.
    pub(crate) fn too_small(&self, half_lengths: &[f64]) -> Option<ContactError> {
        self.profiles().find_map(|(i, profile)| Some(profile.too_small(half_lengths[i])?.at(i)))
    }
}

impl<'a> Side<'a> {
    pub(crate) fn profile(&self) -> Option<&PunchProfile<'a>> {
        if let Self::Profile(profile) = self { Some(profile) } else { None }
    }

    pub(crate) fn given(&self) -> Option<&Given<'a>> {
        if let Self::Known(given) = self { Some(given) } else { None }
    }

    /// Height above the apex at x (both in units of L), per unit of P', as the equations test it: about an axis after Abel's transform.
    pub(crate) fn height(&self, x: f64) -> f64 {
        self.profile().map_or(0.0, |profile| profile.tested_height(x))
    }

    /// Height above the tip of the punch of this number at x (both in units of L), per unit of P'.
    pub(crate) fn height_under(&self, punch: usize, x: f64) -> f64 {
        match self {
            Self::Punches(all) => all.get(punch).map_or(0.0, |placed| placed.height(x)),
            _ => self.height(x),
        }
    }

    /// The same of any punch, and about an axis as it is.
    pub(crate) fn height_above_tip(&self, punch: usize, x: f64) -> f64 {
        self.profile().map_or_else(|| self.height_under(punch, x), |profile| profile.height(x))
    }

    /// How much higher than at its lowest point the punch of this number is on average over a window, per unit of P'.
    pub(crate) fn mean_height(&self, punch: usize, window: &MeanWindow) -> f64 {
        match self {
            Self::Profile(profile) => profile.mean_height(window, 0.0, 0.0),
            Self::Punches(all) => all.get(punch).map_or(0.0, |placed| placed.mean_height(window)),
            _ => 0.0,
        }
    }

    /// Where the punch of this number ends, in units of L; infinite where it does not.
    pub(crate) fn ends_of(&self, punch: usize) -> [f64; 2] {
        match self {
            Self::Punches(all) => all.get(punch).map_or([f64::NEG_INFINITY, f64::INFINITY], Placed::ends),
            _ => self.edge().map_or([f64::NEG_INFINITY, f64::INFINITY], |edge| [-edge, edge]),
        }
    }

    /// Half-length at which the punch ends, in units of L.
    pub(crate) fn edge(&self) -> Option<f64> {
        self.profile().and_then(PunchProfile::edge)
    }

    /// Whether the punch of the contact has sharp corners.
    pub(crate) fn is_flat(&self) -> bool {
        self.profile().is_some_and(|profile| profile.flat().is_some())
    }

    /// Whether terms of the pressure under the punch of this number fall slowly, but for what a sharp tip makes.
    pub(crate) fn is_kinked(&self, punch: usize) -> bool {
        match self {
            Self::Profile(profile) => profile.is_kinked(),
            Self::Punches(all) => all.get(punch).is_some_and(Placed::is_kinked),
            _ => false,
        }
    }

    /// Whether the pressure is infinite at the apex of a punch.
    pub(crate) fn is_sharp(&self) -> bool {
        self.profile().is_some_and(PunchProfile::is_sharp)
    }

    /// The half-length at which a step from `before` to `after` ends.
    pub(crate) fn within(&self, before: f64, after: f64) -> f64 {
        self.profile().map_or(after, |profile| profile.within(before, after))
    }
}
