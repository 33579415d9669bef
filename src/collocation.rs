//! A check of a solution by a second, independent discretisation of the contact equations: where bodies are said to touch, their faces have no gap.
//!
//! The pressures of the solution move the faces of the bodies as [`crate::field`] says, which sums the states inside the layers over the wavenumber. The gaps that are
//! left at points of all intervals, and how the pressures have to change so that these gaps are as small as they can be, tell what the solver has missed. It shares
//! with the solver the layers and the ends.
use std::f64::consts::PI;

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;

use crate::contact::ContactError;
use crate::errors::Error;
use crate::field::{DISPLACEMENTS, Field, FieldError, Precision, ROUGH};
use crate::kernel::Kernel;
use crate::numeric::largest;
use crate::profile;
use crate::scene::{Tilt, Top};
use crate::solution::{Contact, Interface, Interval, Solution, Strip};
use crate::stack::Stack;

/// Terms of the pressure that may change on an interval. Twice as many: differences are told to more digits than one.
const TERMS: usize = 12;
/// Points on an interval.
const POINTS: usize = 3 * TERMS;
/// The weight of the equations of equilibrium: gaps are closed by pressures that carry what they carried.
const EQUILIBRIUM: f64 = 1e3;
/// Rounding of displacements, as a part of what all of a pressure does to them.
const ROUNDING: f64 = 1e-12;
/// The same for the changes, which are told to few digits; and the weight of changes beside the gaps that they close: what they do is not seen below.
const SEEN: f64 = 1e-4;

/// What collocation says of one contact of a solution.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Collocated {
    /// The contact.
    pub interface: Interface,
    /// The largest gap that is left at the points, less the mean of all under the same punch, over the height by which an elliptic pressure of the same resultant
    /// and extent makes half-planes bulge; dimensionless, 0 for exact pressures.
    pub residual: f64,
    /// The largest change of the pressure at the points that closes these gaps in the sense of least squares, over the largest pressure there; dimensionless.
    pub pressure_difference: f64,
    /// Number of points.
    pub nodes: usize,
}

/// The points on one interval; of an even solution on one that reaches to x > 0.
struct Points<'a> {
    contact: usize,
    /// The number of the punch, from the left; 0 elsewhere.
    punch: usize,
    interval: &'a Interval,
    x: Vec<f64>,
}

/// A change of the pressure on one interval, and on its mirror image.
struct Change {
    contact: usize,
    punch: usize,
    strips: Vec<Strip>,
}

/// The gaps at points of all intervals, and the changes of the pressures that close them.
///
/// # Errors
/// [`ContactError::NotCollocated`] about an axis, if a contact is a ring; others if the fields of a layer cannot be computed.
pub(crate) fn check(top: &Top, stack: &Stack, kernel: &Kernel, solution: &Solution) -> Result<Vec<Collocated>, Error> {
    let contacts = solution.contacts();
    let is_round = stack.geometry().is_axisymmetric();
    let points = points(top, solution);
    if is_round && points.iter().any(|points| points.interval.left != -points.interval.right) {
        return Err(ContactError::NotCollocated.into());
    }
    let largest_at = |contact: usize, pressure: &dyn Fn(f64) -> f64| {
        let own = points.iter().filter(|points| points.contact == contact).flat_map(|points| &points.x);
        largest(own.map(|x| pressure(*x).abs()))
    };
    let peaks: Vec<f64> = (0..contacts.len()).map(|i| largest_at(i, &|x| contacts[i].pressure(x))).collect();
    let changes: Vec<Change> =
        points.iter().flat_map(|points| changes(points, solution, peaks[points.contact], is_round)).collect();
    let gaps = |solution: &Solution, precision: &Precision| gaps(top, stack, solution, &points, precision);
    let before = gaps(solution, &ROUGH)?;
    let columns = changes.iter().map(|change| {
        let after = gaps(&change.added_to(solution), &ROUGH)?;
        Ok(after.iter().zip(&before).map(|(after, before)| after - before).collect())
    });
    let columns: Vec<Vec<f64>> = columns.collect::<Result<_, FieldError>>()?;
    let gaps = gaps(solution, &DISPLACEMENTS)?;
    // laminates that bend easily move by far more than they are pressed together
    let moved = |i: usize| {
        let own: Vec<bool> = points.iter().flat_map(|points| points.x.iter().map(|_| points.contact == i)).collect();
        let of =
            |column: &Vec<f64>| largest(column.iter().zip(&own).filter(|(_, own)| **own).map(|(gap, _)| gap.abs()));
        largest(columns.iter().map(of))
    };
    let height = |i: usize, part: f64| bulge(kernel, i, &contacts[i], is_round) + part * moved(i);
    let heights: Vec<f64> = (0..contacts.len()).map(|i| height(i, SEEN)).collect();
    let amplitudes = closing(top, solution, &points, (&changes, &columns), &gaps, &heights);
    let of = |i: usize| {
        let change = |x: f64| {
            let own = changes.iter().zip(&amplitudes).filter(|(change, _)| change.contact == i);
            own.map(|(change, part)| part * change.strips.iter().map(|strip| strip.pressure(x)).sum::<f64>()).sum()
        };
        let own = levelled(&points, &gaps).into_iter().filter(|(contact, _)| *contact == i).map(|(_, gap)| gap.abs());
        Collocated {
            interface: contacts[i].interface,
            residual: largest(own) / height(i, ROUNDING),
            pressure_difference: largest_at(i, &change) / peaks[i],
            nodes: points.iter().filter(|points| points.contact == i).map(|points| points.x.len()).sum(),
        }
    };
    Ok((0..contacts.len()).filter(|i| points.iter().any(|points| points.contact == *i)).map(of).collect())
}

/// The points of all contacts whose pressure was to be found.
fn points<'a>(top: &Top, solution: &'a Solution) -> Vec<Points<'a>> {
    let about = solution.about();
    let x = |interval: &Interval| {
        let (middle, half) = (0.5 * (interval.left + interval.right), 0.5 * (interval.right - interval.left));
        (0..POINTS).map(|k| middle - half * (PI * (k as f64 + 0.5) / POINTS as f64).cos()).collect()
    };
    let is_unknown = |contact: &Contact| contact.interface != Interface::Punch || top.punches().is_some();
    let of = |(number, contact): (usize, &'a Contact)| {
        let intervals =
            contact.intervals.iter().enumerate().filter(|(_, one)| about.is_none_or(|about| one.right > about));
        let punch = |k: usize| contact.punches.get(k).copied().unwrap_or(0);
        let points = move |(k, interval)| Points { contact: number, punch: punch(k), interval, x: x(interval) };
        intervals.map(points).collect::<Vec<_>>()
    };
    solution.contacts().iter().enumerate().filter(|(_, contact)| is_unknown(contact)).flat_map(of).collect()
}

/// The terms of the pressure that may change on an interval, each by the largest pressure of its contact.
fn changes(points: &Points, solution: &Solution, peak: f64, is_round: bool) -> Vec<Change> {
    let (contact, interval) = (&solution.contacts()[points.contact], points.interval);
    let about = solution.about();
    let is_middle = about.is_some_and(|about| interval.left < about && about < interval.right);
    let blank = Strip {
        at: about.filter(|_| is_middle).unwrap_or(0.5 * (interval.left + interval.right)),
        is_round,
        ..Strip::series(0.5 * (interval.right - interval.left), Vec::new())
    };
    let unit = |m: usize| (0..=m).map(|k| if k == m { peak } else { 0.0 }).collect::<Vec<f64>>();
    let mut strips: Vec<Strip> = (0..TERMS).map(|m| Strip { coefficients: unit(m), ..blank.clone() }).collect();
    if !is_middle {
        strips.extend((0..TERMS).map(|m| Strip { coefficients: vec![0.0; m + 1], skew: unit(m), ..blank.clone() }));
    }
    // pressures are singular at corners
    let is_corner = |side: usize| {
        contact.strips.iter().any(|strip| strip.ends()[side] == blank.ends()[side] && strip.corners[side] != 0.0)
    };
    let corners: &[[f64; 2]] = if is_middle { &[[1.0, 1.0]] } else { &[[1.0, 0.0], [0.0, 1.0]] };
    let own = corners.iter().filter(|corners| (0..2).any(|side| corners[side] != 0.0 && is_corner(side)));
    strips.extend(own.map(|corners| Strip { corners: corners.map(|corner| corner * peak), ..blank.clone() }));
    let with_image = |strip: Strip| match about.filter(|_| !is_middle) {
        Some(about) => vec![strip.mirrored(about), strip],
        None => vec![strip],
    };
    let change = |strip| Change { contact: points.contact, punch: points.punch, strips: with_image(strip) };
    strips.into_iter().map(change).collect()
}

impl Change {
    /// A solution with pressures that are changed.
    fn added_to(&self, solution: &Solution) -> Solution {
        let mut changed = solution.clone();
        let contact = &mut changed.contacts[self.contact];
        // strips stand from left to right on either side of the middle of what is even
        let (image, own) = self.strips.split_at(self.strips.len() - 1);
        contact.strips.splice(0..0, image.iter().cloned());
        contact.strips.extend(own.iter().cloned());
        if !contact.punches.is_empty() {
            contact.punches.push(self.punch);
        }
        changed
    }

    /// Resultant, and moment about x = 0.
    fn carried(&self) -> [f64; 2] {
        let of = |strip: &Strip| [strip.resultant(), strip.moment() + strip.at * strip.resultant()];
        self.strips.iter().map(of).fold([0.0; 2], |all, own| [all[0] + own[0], all[1] + own[1]])
    }
}

/// How much higher the body above is than the body below at all points; what lies above the stack is a punch.
fn gaps(
    top: &Top,
    stack: &Stack,
    solution: &Solution,
    points: &[Points],
    precision: &Precision,
) -> Result<Vec<f64>, FieldError> {
    let field = Field::new(stack, solution);
    let places: Vec<f64> = points.iter().flat_map(|points| points.x.iter().copied()).collect();
    let faces = field.faces(&places, precision)?;
    let (mut gaps, mut first) = (Vec::new(), 0);
    for Points { contact, punch, x, .. } in points {
        let interface = solution.contacts()[*contact].interface;
        let heights = profile::heights(top, &field, &faces, interface, *punch, &places)?.unwrap_or_default();
        let tilt = solution.punches().get(*punch).filter(|_| interface == Interface::Punch).map_or(0.0, |own| own.tilt);
        gaps.extend(x.iter().zip(&heights[first..]).map(|(x, height)| height + tilt * x));
        first += x.len();
    }
    Ok(gaps)
}

/// Gaps with the numbers of their contacts, less the mean of all under the same punch, which tells how far that has sunk.
fn levelled(points: &[Points], gaps: &[f64]) -> Vec<(usize, f64)> {
    let owners: Vec<[usize; 2]> =
        points.iter().flat_map(|points| points.x.iter().map(|_| [points.contact, points.punch])).collect();
    let mean = |owner: &[usize; 2]| {
        let own: Vec<f64> =
            gaps.iter().zip(&owners).filter(|(_, other)| *other == owner).map(|(gap, _)| *gap).collect();
        own.iter().sum::<f64>() / own.len() as f64
    };
    gaps.iter().zip(&owners).map(|(gap, owner)| (owner[0], gap - mean(owner))).collect()
}

/// The height by which an elliptic pressure with the resultant and the extent of a contact makes half-planes of the materials at its faces bulge.
fn bulge(kernel: &Kernel, i: usize, contact: &Contact, is_round: bool) -> f64 {
    let compliance = contact.resultant / kernel.contact_modulus(i);
    if is_round { 0.375 * compliance / contact.reach() } else { 2.0 / PI * compliance }
}

/// By how many times each change gaps are closed in the sense of least squares, where all contacts carry what they carried.
fn closing(
    top: &Top,
    solution: &Solution,
    points: &[Points],
    (changes, columns): (&[Change], &[Vec<f64>]),
    gaps: &[f64],
    heights: &[f64],
) -> Vec<f64> {
    let (contacts, is_even) = (solution.contacts(), solution.about().is_some());
    let mut owners: Vec<[usize; 2]> = points.iter().map(|points| [points.contact, points.punch]).collect();
    owners.dedup();
    let turns = |punch: usize| {
        let pressed = top.punches().and_then(|punches| punches.parts().nth(punch));
        pressed.is_some_and(|(pressed, _)| matches!(pressed.tilt(), Tilt::Free { .. }))
    };
    let carried: Vec<[f64; 2]> = changes.iter().map(Change::carried).collect();
    let mut rows: Vec<(Vec<f64>, f64)> = Vec::new();
    let mut gap = 0;
    for Points { contact, punch, x, .. } in points {
        for x in x {
            let own = columns.iter().map(|column| column[gap]);
            // how far a punch has sunk, and how it is turned
            let mut row: Vec<f64> = own.collect();
            for owner in &owners {
                let is_own = f64::from(*owner == [*contact, *punch]);
                row.extend([is_own, if owner[0] == 0 && turns(owner[1]) { is_own * x } else { 0.0 }]);
            }
            row.iter_mut().for_each(|value| *value /= heights[*contact]);
            rows.push((row, -gaps[gap] / heights[*contact]));
            gap += 1;
        }
    }
    for [contact, punch] in &owners {
        let force = contacts[*contact].resultant;
        let is_own = |change: &Change| f64::from([change.contact, change.punch] == [*contact, *punch]);
        let mut hold = |unit: f64, of: &dyn Fn(&Change, &[f64; 2]) -> f64| {
            let all = changes.iter().zip(&carried).map(|(change, carried)| EQUILIBRIUM * of(change, carried) / unit);
            rows.push((all.chain(owners.iter().flat_map(|_| [0.0; 2])).collect(), 0.0));
        };
        hold(force, &|change, carried| is_own(change) * carried[0]);
        let moment = force * contacts[*contact].reach();
        if *contact > 0 && !is_even {
            // layers that rest on each other carry the moment on
            hold(moment, &|change, carried| (is_own(change) - f64::from(change.contact == 0)) * carried[1]);
        } else if *contact == 0 && turns(*punch) {
            hold(moment, &|change, carried| is_own(change) * carried[1]);
        }
    }
    let size = changes.len() + 2 * owners.len();
    rows.extend(
        (0..changes.len()).map(|k| ((0..size).map(|other| if other == k { SEEN } else { 0.0 }).collect(), 0.0)),
    );
    let used: Vec<usize> = (0..size).filter(|k| rows.iter().any(|(row, _)| row[*k] != 0.0)).collect();
    let matrix = Mat::from_fn(rows.len(), used.len(), |row, column| rows[row].0[used[column]]);
    let right = Mat::from_fn(rows.len(), 1, |row, _| rows[row].1);
    let found = matrix.col_piv_qr().solve_lstsq(&right);
    let mut amplitudes = vec![0.0; size];
    used.iter().enumerate().for_each(|(k, column)| amplitudes[*column] = found[(k, 0)]);
    amplitudes.truncate(changes.len());
    amplitudes
}
