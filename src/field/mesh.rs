//! Meshes in all layers, and the places at which a stress is larger than at those around them.
use super::error::FieldError;
use super::measure::{Peak, Search, Seen};
use super::pressure::Pressure;
use super::sum::Row;
use super::waves::{self, Precision};
use super::{Field, FieldPoint, PlacedLayer};

/// Points of the mesh next to the loads: x in half-lengths of each contact next to the layer, depths in half-lengths from a loaded
/// face, and in thicknesses.
const BESIDE: [f64; 15] = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.96, 1.0, 1.05, 1.15, 1.4];
const BELOW: [f64; 6] = [0.03, 0.1, 0.25, 0.5, 0.8, 1.3];
const THROUGH: [f64; 3] = [0.0, 0.5, 1.0];
/// Where a pressure jumps stresses depend on the direction: they are searched at this part of the narrowest load from there, at these parts of
/// that distance along x and in depth.
const CLOSE: f64 = 1e-8;
const ASIDE: [f64; 9] = [-1.0, -0.7, -0.4, -0.15, 0.0, 0.15, 0.4, 0.7, 1.0];
const DOWN: [f64; 5] = [0.0, 0.2, 0.45, 0.7, 1.0];
/// The mesh away from the loads reaches this number of bending lengths beyond the longest contact, and each of its places is this factor
/// times the one before, from this part of the shortest contact on.
const BEYOND: f64 = 4.0;
const SPREAD: f64 = 1.3;
const NEAREST: f64 = 0.5;
/// Its depths, in parts of the thickness of a layer, or of the depth to which a half-plane is searched.
const LAYER: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
const HALF_PLANE: [f64; 7] = [0.0, 0.05, 0.1, 0.2, 0.35, 0.6, 1.0];
/// The distance of points, in parts of that of the places of this mesh.
const SCALE: f64 = 2.0;

/// Stresses in rows of points, layer by layer.
pub(super) struct Mesh {
    rows: Vec<Row>,
    sets: Vec<Vec<f64>>,
    points: Vec<Vec<FieldPoint>>,
    scale: Scale,
    /// The ends of contacts: row, and place in it.
    ends: Vec<(usize, usize)>,
}

/// The length that steps from a place of a mesh are parts of.
enum Scale {
    /// The shortest half-length next to each layer, or the distance of the next place where that is larger.
    Shortest(Vec<f64>),
    /// The distance from the loads: that from x = 0, or from the nearest loaded face, and no less than this.
    Distance(f64),
}

impl Scale {
    /// For the place number `k` of a row in a layer.
    fn at(&self, field: &Field, row: &Row, places: &[f64], k: usize) -> f64 {
        let x = places[k];
        match self {
            Self::Shortest(of) => places.get(k + 1).map_or(0.0, |next| next - x).max(of[row.layer]),
            Self::Distance(least) => {
                let placed = &field.layers[row.layer];
                let (body, depth) = (&field.bodies[placed.body], placed.top + row.depth);
                let face = (depth - body.top).min(body.bottom.map_or(f64::INFINITY, |bottom| bottom - depth));
                SCALE * (SPREAD - 1.0) * x.abs().max(face).max(*least)
            }
        }
    }
}

impl Mesh {
    /// Next to the loads.
    pub(super) fn near(field: &Field, precision: &Precision) -> Result<Self, FieldError> {
        let (mut rows, mut sets) = (Vec::new(), Vec::new());
        for (layer, placed) in field.layers.iter().enumerate() {
            let body = &field.bodies[placed.body];
            let contacts = field.contacts_of(layer);
            let deepest = field.deepest(layer);
            let xs = contacts.clone().flat_map(|contact| beside(field, contact));
            let mut depths: Vec<f64> = THROUGH.iter().map(|part| part * deepest).collect();
            for (side, contact) in contacts.enumerate() {
                // counted from the loaded face, be it that of this layer or of one above or below it
                let face = if side == 0 { body.top } else { body.bottom.unwrap_or(body.top) } - placed.top;
                let lengths = [field.length(contact), field.narrowest(contact)];
                let distances = lengths.iter().flat_map(|length| BELOW.map(|part| part * length));
                let inside = distances.map(|distance| if side == 0 { face + distance } else { face - distance });
                depths.extend(inside.filter(|depth| *depth > 0.0 && *depth < deepest));
            }
            rows.extend(ascending(depths).into_iter().map(|depth| Row { layer, depth, set: sets.len() }));
            sets.push(ascending(xs.collect()));
        }
        let points = points(field, &rows, &sets, precision)?;
        let scale = Scale::Shortest((0..field.layers.len()).map(|layer| field.shortest(layer)).collect());
        let ends = ends(field, &rows, &sets);
        Ok(Self { rows, sets, points, scale, ends })
    }

    /// About the places of the top face at which a pressure jumps.
    pub(super) fn jumps(field: &Field) -> Result<Option<Self>, FieldError> {
        let near = CLOSE * field.narrowest(0);
        let of = |at: f64| ASIDE.iter().map(|part| at + part * near).collect();
        let sets: Vec<Vec<f64>> = field.pressures.first().into_iter().flat_map(Pressure::jumps).map(of).collect();
        if sets.is_empty() {
            return Ok(None);
        }
        let of = |set: usize| DOWN.map(|part| Row { layer: 0, depth: part * near, set });
        let rows: Vec<Row> = (0..sets.len()).flat_map(of).collect();
        let points = points(field, &rows, &sets, &waves::LOW)?;
        Ok(Some(Self { rows, sets, points, scale: Scale::Shortest(vec![0.0; field.layers.len()]), ends: Vec::new() }))
    }

    /// Away from the loads: as far as a stiff layer on soft ones distributes them by bending.
    pub(super) fn far(field: &Field) -> Result<Self, FieldError> {
        let finite = field.layers.iter().filter_map(|placed| placed.thickness);
        let bending = finite.fold(0.0, |sum, h| sum + h) * field.contrast.max(field.over_support).cbrt();
        let longest = field.pressures.iter().fold(0.0, |a: f64, pressure| a.max(pressure.half_length));
        let from = NEAREST * (0..field.layers.len()).map(|layer| field.shortest(layer)).fold(f64::INFINITY, f64::min);
        let to = longest + BEYOND * bending;
        let mut places = vec![0.0];
        let mut x = from;
        while x < to {
            places.push(x);
            x *= SPREAD;
        }
        if !field.is_even {
            places = places[1..].iter().rev().map(|x| -x).chain(places.iter().copied()).collect();
        }
        let depths = |(layer, placed): (usize, &PlacedLayer)| {
            let parts: &[f64] = if placed.thickness.is_some() { &LAYER } else { &HALF_PLANE };
            let deepest = field.deepest(layer);
            parts.iter().map(move |part| Row { layer, depth: part * deepest, set: 0 })
        };
        let rows: Vec<Row> = field.layers.iter().enumerate().flat_map(depths).collect();
        let sets = vec![places];
        let points = points(field, &rows, &sets, &waves::LOW)?;
        Ok(Self { rows, sets, points, scale: Scale::Distance(from), ends: Vec::new() })
    }

    /// The places at which a quantity is no smaller than at those around them, and the ends of contacts.
    pub(super) fn peaks(&self, field: &Field, search: &Search) -> Vec<Peak> {
        let Search { measure, layer } = *search;
        let searched = |row: &Row| layer.is_none_or(|layer| row.layer == layer);
        let is_lower_face = |row: &Row| field.layers[row.layer].thickness == Some(row.depth);
        let is_chosen = |row: &Row| searched(row) && (!measure.is_on_face() || is_lower_face(row));
        let chosen: Vec<usize> = (0..self.rows.len()).filter(|i| is_chosen(&self.rows[*i])).collect();
        let values: Vec<Vec<f64>> =
            chosen.iter().map(|i| self.points[*i].iter().map(|point| measure.of(point)).collect()).collect();
        let at_end = |&(i, k): &(usize, usize)| {
            let row = self.rows[i];
            let (x, value) = (self.sets[row.set][k], measure.of(&self.points[i][k]));
            Peak::new(measure, row.layer, Seen { x, depth: row.depth, value }, 0.0)
        };
        let ends = self.ends.iter().filter(|(i, _)| chosen.contains(i));
        let mut peaks: Vec<Peak> = ends.map(at_end).collect();
        for (i, in_row) in values.iter().enumerate() {
            let row = self.rows[chosen[i]];
            let beside = |other: Option<usize>| {
                let same = |other: &Row| (other.layer, other.set) == (row.layer, row.set);
                other.filter(|k| chosen.get(*k).is_some_and(|k| same(&self.rows[*k])))
            };
            let around: Vec<&Vec<f64>> =
                [i.checked_sub(1), Some(i), Some(i + 1)].into_iter().filter_map(beside).map(|k| &values[k]).collect();
            for (k, value) in in_row.iter().copied().enumerate() {
                let near = k.saturating_sub(1)..(k + 2).min(in_row.len());
                if around.iter().all(|list| list[near.clone()].iter().all(|other| *other <= value)) {
                    let places = &self.sets[row.set];
                    let (x, scale) = (places[k], self.scale.at(field, &row, places, k));
                    peaks.push(Peak::new(measure, row.layer, Seen { x, depth: row.depth, value }, scale));
                }
            }
        }
        peaks
    }
}

/// The ends of the contacts on the loaded faces of the bodies.
fn ends(field: &Field, rows: &[Row], sets: &[Vec<f64>]) -> Vec<(usize, usize)> {
    let of = |(i, row): (usize, &Row)| {
        let placed = &field.layers[row.layer];
        let body = &field.bodies[placed.body];
        let top = (placed.place == 0 && row.depth == 0.0).then_some(body.contact);
        let is_bottom = body.bottom.is_some() && placed.place + 1 == body.layers && placed.thickness == Some(row.depth);
        let contact = &field.pressures[top.or(is_bottom.then_some(body.contact + 1))?];
        let ends = contact.ends();
        let places = sets[row.set].iter().enumerate();
        Some(places.filter(move |(_, x)| ends.contains(x)).map(move |(k, _)| (i, k)))
    };
    rows.iter().enumerate().filter_map(of).flatten().collect()
}

/// Places of the mesh for one contact.
fn beside(field: &Field, contact: usize) -> Vec<f64> {
    let (pressure, narrowest) = (&field.pressures[contact], field.narrowest(contact));
    let about = |(at, a): (f64, f64)| {
        // a line load has no length
        let a = if a > 0.0 { a } else { narrowest };
        [-1.0, 1.0].into_iter().flat_map(move |side| BESIDE.map(|part| at + side * part * a))
    };
    // many strips are taken as one
    let strips: Vec<(f64, f64)> = pressure.strips().filter(|_| !pressure.is_of_many()).collect();
    let all = strips.into_iter().chain([(0.0, field.length(contact))]).flat_map(about);
    all.chain(pressure.ends()).filter(|x| !field.is_even || *x >= 0.0).collect()
}

fn ascending(mut list: Vec<f64>) -> Vec<f64> {
    list.sort_by(f64::total_cmp);
    list.dedup();
    list
}

/// Stresses in rows of points.
pub(super) fn points(
    field: &Field,
    rows: &[Row],
    sets: &[Vec<f64>],
    precision: &Precision,
) -> Result<Vec<Vec<FieldPoint>>, FieldError> {
    let found = field.sum(rows, sets, precision)?;
    let of = |(row, components): (&Row, Vec<_>)| {
        sets[row.set].iter().zip(components).map(|(x, components)| field.point(*x, row, components)).collect()
    };
    Ok(rows.iter().zip(found).map(of).collect())
}
