//! Loads about axes of their own on a stack without receding interfaces: what each of them does alone is added up in Cartesian components.
use std::slice::ChunksExact;

use super::Field;
use super::body::{DepthRow, Rows};
use super::error::FieldError;
use super::place::{Point, SpacePoint};
use super::point::FieldPoint;
use super::waves::{FULL, Precision};
use crate::geometry::Coordinates;
use crate::solution::{Contact, Solution};
use crate::stack::Stack;

/// Fields of loads, each of which is the same about several axes, and the vertical plane in which points without a y are.
#[derive(Clone, Debug)]
pub(super) struct Superposed {
    fields: Vec<AboutAxes>,
    y: f64,
}

/// The field of a load about its own axis, which presses about several ones.
#[derive(Clone, Debug)]
struct AboutAxes {
    field: Field,
    /// How far the load reaches from its axis.
    reach: f64,
    axes: Vec<[f64; 2]>,
}

impl Superposed {
    /// The fields of the loads of a solution; `None` if they press about one axis. Equal loads, as of the wheels of an axle, are one field, summed once over the
    /// wavenumbers.
    pub(super) fn new(stack: &Stack, solution: &Solution) -> Option<Self> {
        let mut fields: Vec<AboutAxes> = Vec::new();
        let mut seen: Vec<&Contact> = Vec::new();
        for (contact, axis) in solution.contacts.iter().zip(&solution.axes) {
            match seen.iter().position(|other| *other == contact) {
                Some(known) => fields[known].axes.push(*axis),
                None => {
                    let own = Solution { contacts: vec![contact.clone()], axes: Vec::new(), ..solution.clone() };
                    let mut field = Field::new(stack, &own);
                    // residual stresses are there once, however many loads press
                    field.layers.iter_mut().for_each(|placed| placed.residual = None);
                    fields.push(AboutAxes { field, reach: contact.reach(), axes: vec![*axis] });
                    seen.push(contact);
                }
            }
        }
        (!fields.is_empty()).then_some(Self { fields, y: 0.0 })
    }

    /// Where the loads press along x.
    pub(super) fn ends(&self) -> [f64; 2] {
        let ends = self.fields.iter().flat_map(|own| own.axes.iter().map(|[x, _]| [x - own.reach, x + own.reach]));
        ends.reduce(|all, one| [all[0].min(one[0]), all[1].max(one[1])]).unwrap_or_default()
    }

    /// The estimated error of the stresses at a point.
    pub(super) fn stress_error(&self, point: &SpacePoint) -> Result<f64, FieldError> {
        let of = |own: &AboutAxes| {
            let at = |[x, y]: &[f64; 2]| SpacePoint { x: (point.x - x).hypot(point.y - y), ..*point }.in_plane();
            own.axes.iter().map(|axis| own.field.stress_error(&at(axis))).sum::<Result<f64, _>>()
        };
        self.fields.iter().map(of).sum()
    }

    /// Points in rows, each at a set of places (x, y).
    fn sum(&self, whole: &Field, rows: &[DepthRow], sets: &[Vec<[f64; 2]>], precision: &Precision) -> Summed {
        let mut sums: Vec<Vec<FieldPoint>> = Vec::new();
        for own in &self.fields {
            // all places about the first axis, then all about the second one
            let distances = |places: &Vec<[f64; 2]>| {
                let from = |&[x0, y0]: &[f64; 2]| places.iter().map(move |[x, y]| (x - x0).hypot(y - y0));
                own.axes.iter().flat_map(from).collect()
            };
            let about = Rows { rows: rows.to_vec(), sets: sets.iter().map(distances).collect() };
            let found = own.field.at_places(&about, precision)?;
            let rows = found.iter().zip(rows).map(|(points, row)| own.added(points, &sets[row.set]));
            match sums.is_empty() {
                true => sums = rows.collect(),
                false => sums.iter_mut().zip(rows).for_each(|(sums, row)| sums.iter_mut().zip(row).for_each(add)),
            }
        }
        for (points, row) in sums.iter_mut().zip(rows) {
            points.iter_mut().for_each(|point| whole.add_residual(row, point));
        }
        Ok(sums)
    }
}

type Summed = Result<Vec<Vec<FieldPoint>>, FieldError>;

impl AboutAxes {
    /// The sums over all axes at some places (x, y), from points at the distances from them, axis by axis.
    fn added(&self, points: &[FieldPoint], places: &[[f64; 2]]) -> Vec<FieldPoint> {
        let about = |(axis, points): (&[f64; 2], &[FieldPoint])| {
            places.iter().zip(points).map(|(place, point)| turned(point, axis, place)).collect::<Vec<_>>()
        };
        let chunks: ChunksExact<FieldPoint> = points.chunks_exact(places.len().max(1));
        let mut all = self.axes.iter().zip(chunks).map(about);
        let mut sums = all.next().unwrap_or_default();
        all.for_each(|own| sums.iter_mut().zip(own).for_each(add));
        sums
    }
}

/// A point of a field about an axis in Cartesian components.
fn turned(point: &FieldPoint, [x0, y0]: &[f64; 2], &[x, z]: &[f64; 2]) -> FieldPoint {
    let (along, across, distance) = (x - x0, z - y0, point.x);
    // on the axis all directions are alike
    let [cos, sin] = if distance > 0.0 { [along / distance, across / distance] } else { [1.0, 0.0] };
    // the components xx, zz and xz of what is radial and about the axis
    let tensor = |radial: f64, hoop: f64| {
        let [square, other] = [cos * cos, sin * sin];
        [radial * square + hoop * other, radial * other + hoop * square, (radial - hoop) * cos * sin]
    };
    let [sigma_xx, sigma_zz, sigma_xz] = tensor(point.sigma_xx, point.sigma_zz);
    let [eps_xx, eps_zz, eps_xz] = tensor(point.eps_xx, point.eps_zz);
    FieldPoint {
        x,
        z,
        // not −0
        u: point.u * cos + 0.0,
        w: point.u * sin + 0.0,
        slope: point.slope * cos,
        sigma_xx,
        sigma_zz,
        sigma_xz,
        sigma_xy: point.sigma_xy * cos,
        sigma_yz: point.sigma_xy * sin,
        eps_xx,
        eps_zz,
        gamma_xz: 2.0 * eps_xz,
        gamma_xy: point.gamma_xy * cos,
        gamma_yz: point.gamma_xy * sin,
        coordinates: Coordinates::Cartesian,
        ..*point
    }
}

/// Adds the stresses, strains and displacements of another field at the same point.
fn add((sum, mut other): (&mut FieldPoint, FieldPoint)) {
    sum.additive().into_iter().zip(other.additive()).for_each(|(sum, other)| *sum += *other);
}

impl Field {
    /// Stresses and displacements at any points, each with a y if loads press at several places (x, y).
    ///
    /// # Errors
    /// As [`Self::at`] and [`Self::at_layer`]; [`FieldError::NoSpace`] for a y that is not 0 in a field of other loads.
    pub fn points_in_space(&self, requested: &[SpacePoint]) -> Result<Vec<FieldPoint>, FieldError> {
        let Some(all) = &self.superposed else {
            return match requested.iter().find(|point| point.y != 0.0) {
                Some(point) => Err(FieldError::NoSpace(point.y)),
                None => self.points(&requested.iter().map(SpacePoint::in_plane).collect::<Vec<_>>()),
            };
        };
        let rows = requested.iter().enumerate().map(|(set, point)| self.row(&point.in_plane(), set));
        let rows: Vec<DepthRow> = rows.collect::<Result<_, _>>()?;
        let sets: Vec<Vec<[f64; 2]>> = requested.iter().map(|point| vec![[point.x, point.y]]).collect();
        Ok(all.sum(self, &rows, &sets, &FULL)?.concat())
    }

    /// The same field in the vertical plane at this y, in which points without a y are then, and grids; at first it is y = 0.
    ///
    /// # Errors
    /// [`FieldError::NoSpace`] if y is not finite, or not 0 in a field of anything but loads at several places (x, y).
    pub fn at_y(mut self, y: f64) -> Result<Self, FieldError> {
        match &mut self.superposed {
            Some(all) if y.is_finite() => all.y = y,
            None if y == 0.0 => {}
            _ => return Err(FieldError::NoSpace(y)),
        }
        Ok(self)
    }

    /// Refuses to search where fields are the same about no axis.
    pub(super) fn check_searched(&self) -> Result<(), FieldError> {
        if self.superposed.is_some() { Err(FieldError::Superposed) } else { Ok(()) }
    }

    /// The coordinates in which the field is told.
    pub fn coordinates(&self) -> Coordinates {
        if self.superposed.is_some() { Coordinates::Cartesian } else { self.geometry.into() }
    }

    /// Points in rows at places along x of the vertical plane; `None` unless several fields are added up.
    pub(super) fn superposed(&self, Rows { rows, sets }: &Rows, precision: &Precision) -> Option<Summed> {
        let all = self.superposed.as_ref()?;
        let sets: Vec<Vec<[f64; 2]>> = sets.iter().map(|xs| xs.iter().map(|x| [*x, all.y]).collect()).collect();
        Some(all.sum(self, rows, &sets, precision))
    }

    /// Where loads about several axes press along x; `None` unless several fields are added up.
    pub(super) fn superposed_ends(&self) -> Option<[f64; 2]> {
        self.superposed.as_ref().map(Superposed::ends)
    }

    /// The estimated error of the stresses at a point of the vertical plane; `None` unless several fields are added up.
    pub(super) fn superposed_error(&self, point: &Point) -> Option<Result<f64, FieldError>> {
        let all = self.superposed.as_ref()?;
        Some(all.stress_error(&SpacePoint { y: all.y, ..SpacePoint::from(*point) }))
    }
}
