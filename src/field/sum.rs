//! The fields in rows of points at one depth each: closed forms next to the loaded faces, and a sum over wavenumbers of
//! the remainder.
use std::f64::consts::PI;

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};
use recede_layers::{State, Wave};

use super::body::{DepthRow, LoadedBody, PlacedLayer, Rows, components};
use super::error::FieldError;
use super::joints::Motion;
use super::pressure::ContactPressure;
use super::surface::{COMPONENTS, Components};
use super::transform::Transform;
use super::waves::{self, CutOff, Precision, WavePanel};
use super::{FaceLoad, Field};
use crate::geometry::Geometry;
use crate::system::Unresolved;

/// A row that is being summed.
struct Active {
    row: DepthRow,
    /// The index of the row in the requested order.
    index: usize,
    /// The cut-off wavenumber of the row.
    end: f64,
    /// ∫ (V at the depth − V at the reference point) dλ/π, and the same of U in the odd part of the field.
    lifts: [f64; 2],
}

/// A channel of the field: what is even about x = 0, or what is odd.
struct Channel {
    /// For each component the table of [`WavePanel::tables`] and the sign of its wave.
    tables: [(usize, f64); COMPONENTS],
    /// The displacement that does not vanish at x = 0, and is counted from the reference point of its body, with the sign of its wave.
    counted: (usize, f64),
}

/// The odd part is the even part a quarter of a wave to the right.
const CHANNELS: [Channel; 2] = [
    Channel { tables: [(1, 1.0), (1, 1.0), (0, 1.0), (0, 1.0), (2, 1.0), (0, 1.0)], counted: (4, 1.0) },
    Channel { tables: [(0, 1.0), (0, 1.0), (1, -1.0), (2, -1.0), (0, 1.0), (1, -1.0)], counted: (3, -1.0) },
];

impl Field {
    /// σ_xx, σ_yy, σ_xy, u, v, dv/dx in rows of points.
    pub(super) fn sum(&self, rows: &Rows, precision: &Precision) -> Result<Vec<Vec<Components>>, FieldError> {
        let (mut rows, asked) = (rows.clone(), rows.rows.len());
        let joints = if precision.displacements { self.joints(&mut rows) } else { Vec::new() };
        let closed = |row: &DepthRow| self.closed(row, &rows.sets[row.set], precision.displacements);
        let mut values: Vec<Vec<Components>> = rows.rows.iter().map(closed).collect();
        self.integrate(&rows, precision, &mut values)?;
        if !precision.displacements {
            return Ok(values);
        }
        // v of a body is counted from v of the body below, where they touch
        let motions = self.motions(&joints, &values.split_off(asked));
        for (row, values) in rows.rows.iter().zip(&mut values) {
            let placed = &self.layers[row.layer];
            let depth = row.depth + placed.top - self.bodies[placed.body].top;
            let Motion { lift, turn } = motions[placed.body];
            for ([.., u, v, slope], x) in values.iter_mut().zip(&rows.sets[row.set]) {
                *u += turn * depth;
                *v += lift + turn * x;
                *slope += turn;
            }
        }
        Ok(values)
    }

    /// The closed forms of the loaded faces, with u and v counted from the reference point of the body, if displacements are wanted.
    pub(super) fn closed(&self, row: &DepthRow, set: &[f64], displacements: bool) -> Vec<Components> {
        let placed = &self.layers[row.layer];
        let body = &self.bodies[placed.body];
        let at = |placed: &PlacedLayer, depth: f64, x: f64| self.closed_at(placed, depth, x, displacements);
        let origin = body.reference.filter(|_| displacements).map_or([0.0; 2], |DepthRow { layer, depth, .. }| {
            let [.., u, v, _] = at(&self.layers[layer], depth, 0.0);
            // a line load on a half-plane moves its own place without limit
            let is_own = body.bottom.is_some() || self.middle == 0.0;
            [u, if is_own { v } else { at(&self.layers[layer], depth, self.place(0.0))[4] }]
        });
        let mut values: Vec<Components> = set.iter().map(|x| at(placed, row.depth, *x)).collect();
        for value in &mut values {
            value[3] -= origin[0];
            value[4] -= origin[1];
        }
        values
    }

    /// The closed forms at a place in a layer.
    fn closed_at(&self, placed: &PlacedLayer, depth: f64, x: f64, displacements: bool) -> Components {
        let mut sum = Components::default();
        for (surface, contact, distance) in self.bodies[placed.body].surfaces(placed, depth) {
            let pressure = &self.pressures[contact];
            let closed = surface.closed(pressure, x, distance, displacements);
            sum.iter_mut().zip(closed).for_each(|(sum, value)| *sum += value);
            if let Some(sinks) = pressure.singularity(x).filter(|_| distance == 0.0) {
                // the limits along the loaded face; the limits of the shear stress and of the slope depend on the direction
                [sum[0], sum[1], sum[2]] = [f64::NEG_INFINITY, f64::NEG_INFINITY, f64::NAN];
                sum[4] = if sinks { f64::NEG_INFINITY } else { sum[4] };
                sum[5] = f64::NAN;
            }
        }
        sum
    }

    /// Adds the integrals over the wavenumber of the remainders of the closed forms.
    fn integrate(&self, rows: &Rows, precision: &Precision, values: &mut [Vec<Components>]) -> Result<(), FieldError> {
        let sets = &rows.sets;
        let parts = if self.is_even { 1 } else { CHANNELS.len() };
        let farthest = sets.iter().flatten().fold(0.0, |x: f64, y| x.max(y.abs()));
        let (cut_offs, origins, mut active) = self.cut_offs(rows, precision, farthest);
        if active.is_empty() {
            return Ok(());
        }
        let in_half_plane = active.iter().filter(|active| self.layers[active.row.layer].thickness.is_none());
        let deepest = in_half_plane.fold(0.0, |deepest: f64, active| deepest.max(active.row.depth));
        let panels = waves::panels(&cut_offs, farthest, self.origin(deepest), precision);
        let panels = panels.ok_or(FieldError::TooFar(farthest))?;
        let mut sums: Vec<WaveSums> =
            sets.iter().enumerate().map(|(set, xs)| WaveSums::new(xs, &active, set, precision.displacements)).collect();
        // for each body and part of the field the measure of the longest waves
        let mut longest = vec![[0.0; 2]; self.bodies.len()];
        for panel in &panels {
            let transforms = self.transforms(panel, &cut_offs);
            // of each part component c of row k at the wavenumber q stands at (6k + c)·n + q
            let mut blocks = vec![vec![0.0; COMPONENTS * panel.wavenumbers.len() * active.len()]; parts];
            for (part, block) in blocks.iter_mut().enumerate() {
                for (body, origin) in origins.iter().enumerate() {
                    let longest = &mut longest[body][part];
                    self.add_body((body, part), (panel, &transforms), &mut active, (*origin, longest), block)?;
                }
            }
            for sum in &mut sums {
                sum.add(self.geometry, panel, &blocks, &active);
            }
        }
        for sum in &sums {
            sum.collect(&active, values);
        }
        for active in &active {
            for (Channel { counted: (component, sign), .. }, lift) in CHANNELS.iter().zip(active.lifts) {
                values[active.index].iter_mut().for_each(|value| value[*component] += sign * lift);
            }
        }
        Ok(())
    }

    /// How far the sums over wavenumbers go with places as far out as `farthest`: pressure by pressure; for the reference points of the bodies; and
    /// the rows with anything to sum, by their sets, those with the largest cut-offs first.
    fn cut_offs(&self, rows: &Rows, precision: &Precision, farthest: f64) -> (Vec<CutOff>, Vec<f64>, Vec<Active>) {
        let cut_off = |contact: usize| CutOff { end: 0.0, own: self.length(contact) };
        let mut pressures: Vec<CutOff> = (0..self.pressures.len()).map(cut_off).collect();
        // the last wavenumber of a row
        let mut end_of = |row: &DepthRow| {
            self.decays(row).fold(0.0, |last: f64, (contact, decay)| {
                let end = self.end(contact, &decay, precision, farthest);
                pressures[contact].end = pressures[contact].end.max(end);
                last.max(end)
            })
        };
        let wanted = rows.rows.iter().enumerate().filter(|(_, row)| !rows.sets[row.set].is_empty());
        let mut active: Vec<Active> = wanted
            .map(|(index, row)| Active { row: *row, index, end: end_of(row), lifts: [0.0; 2] })
            .filter(|active| active.end > 0.0)
            .collect();
        active.sort_by(|a, b| a.row.set.cmp(&b.row.set).then(b.end.total_cmp(&a.end)));
        let reference = |body: &LoadedBody| body.reference.filter(|_| precision.displacements);
        let mut origin = |body: &LoadedBody| reference(body).map_or(0.0, |row| end_of(&row));
        let origins = if active.is_empty() { Vec::new() } else { self.bodies.iter().map(&mut origin).collect() };
        (pressures, origins, active)
    }

    /// The transforms of the pressures, contact by contact, at the wavenumbers of a panel.
    fn transforms(&self, panel: &WavePanel, cut_offs: &[CutOff]) -> Vec<Vec<Transform>> {
        let of = |(pressure, cut_off): (&ContactPressure, &CutOff)| match cut_off.end > panel.lo {
            true => pressure.transforms(&panel.wavenumbers),
            false => {
                let left_out = |l: &f64| Transform { variation: -pressure.long_waves(*l), ..Transform::default() };
                panel.wavenumbers.iter().map(left_out).collect()
            }
        };
        self.pressures.iter().zip(cut_offs).map(of).collect()
    }

    /// The transformed components of a part of the field, times weights, in all rows of a body whose cut-off is beyond the first wavenumber, and their lifts from the
    /// reference point of the body, whose cut-off is `origin`; `longest` is the measure of waves before these that are too long to tell how a laminate is squeezed.
    fn add_body(
        &self,
        (index, part): (usize, usize),
        (panel, transforms): (&WavePanel, &[Vec<Transform>]),
        active: &mut [Active],
        (origin, longest): (f64, &mut f64),
        block: &mut [f64],
    ) -> Result<(), FieldError> {
        let (body, (counted, _)) = (&self.bodies[index], CHANNELS[part].counted);
        let (from, n) = (panel.lo, panel.wavenumbers.len());
        // (depth, row or `None` for the reference point), layer by layer
        let mut wanted: Vec<Vec<(f64, Option<usize>)>> = vec![Vec::new(); body.layers.len()];
        for (k, active) in active.iter().enumerate().filter(|(_, active)| active.end > from) {
            let placed = &self.layers[active.row.layer];
            if placed.body == index {
                wanted[placed.place].push((active.row.depth, Some(k)));
            }
        }
        if wanted.iter().all(Vec::is_empty) && origin <= from {
            return Ok(());
        }
        if let Some(DepthRow { layer, depth, .. }) = body.reference.filter(|_| origin > 0.0) {
            wanted[self.layers[layer].place].push((depth, None));
        }
        wanted.iter_mut().for_each(|wanted| wanted.sort_by(|a, b| a.0.total_cmp(&b.0)));
        let depths: Vec<Vec<f64>> =
            wanted.iter().map(|wanted| wanted.iter().map(|(depth, _)| *depth).collect()).collect();
        let layers = &self.layers[body.layers.clone()];
        let mut lifted = vec![0.0; active.len()];
        let reach = body.contacts().map(|contact| self.length(contact)).fold(self.thickness(), f64::max);
        for (q, (wavenumber, weight)) in panel.wavenumbers.iter().zip(&panel.weights).enumerate() {
            let wave = Wave { wavenumber: *wavenumber, modulus: self.modulus, plane: self.geometry.plane() };
            let transform = |contact: usize| transforms[contact][q].part(part);
            let load = load(body, *wavenumber, transform);
            let states = body.states(&wave, &depths, &load).ok_or(Unresolved { wavenumber: *wavenumber })?;
            let mut at_reference = 0.0;
            for ((placed, wanted), states) in layers.iter().zip(&wanted).zip(&states) {
                for ((depth, row), state) in wanted.iter().zip(states) {
                    let remainder = self.remainder(body, placed, (*depth, *wavenumber), state, transform);
                    let remainder = match self.geometry {
                        Geometry::Axisymmetric => remainder.map(|value| value * weight * wavenumber),
                        _ => remainder.map(|value| value * weight / PI),
                    };
                    let Some(k) = row else {
                        at_reference = remainder[counted];
                        continue;
                    };
                    for (c, value) in remainder.into_iter().enumerate() {
                        block[(COMPONENTS * k + c) * n + q] = value;
                    }
                    lifted[*k] = remainder[counted];
                }
            }
            // the longest waves move a laminate by so much that rounding hides how they squeeze it: they squeeze it like the next shorter ones
            let measure = if self.geometry.is_axisymmetric() { weight * wavenumber } else { *weight };
            if body.bottom.is_some() && wavenumber * reach < waves::LONG {
                *longest += measure;
                continue;
            }
            let share = 1.0 + std::mem::take(longest) / measure;
            for (active, lifted) in active.iter_mut().zip(&lifted) {
                if self.layers[active.row.layer].body == index {
                    active.lifts[part] += share * (lifted - at_reference);
                }
            }
        }
        Ok(())
    }

    /// The components of a state at a depth, minus the closed forms of the faces.
    fn remainder(
        &self,
        body: &LoadedBody,
        placed: &PlacedLayer,
        (depth, wavenumber): (f64, f64),
        state: &State,
        transform: impl Fn(usize) -> [f64; 3],
    ) -> Components {
        let mut remainder = components(state, &placed.layer.material(depth, self.geometry.plane()), self.modulus);
        for (surface, contact, distance) in body.surfaces(placed, depth) {
            let surface = surface.transformed(wavenumber, distance);
            let [.., pressure] = transform(contact);
            remainder.iter_mut().zip(surface).for_each(|(value, surface)| *value -= pressure * surface);
        }
        let displacement = 1.0 / (wavenumber * self.modulus);
        remainder[3] *= displacement;
        remainder[4] *= displacement;
        remainder[5] /= -self.modulus;
        remainder
    }
}

/// The loads on a body, from the transforms of the pressures and their variations: for long waves, the equal part of both pressures and
/// their small difference.
fn load(body: &LoadedBody, wavenumber: f64, transform: impl Fn(usize) -> [f64; 3]) -> FaceLoad {
    let [top, top_variation, _] = transform(body.contact);
    let Some(bottom) = body.bottom else { return FaceLoad { top: -top, ..FaceLoad::default() } };
    let [other, variation, _] = transform(body.contact + 1);
    if wavenumber * (bottom - body.top) > 1.0 {
        FaceLoad { top: -top, bottom: -other, equal: 0.0 }
    } else {
        FaceLoad { top: 0.0, bottom: top_variation - variation, equal: -top }
    }
}

/// The sums over wavenumbers at the places of one set, for its rows: column by column, one value per place.
struct WaveSums<'a> {
    places: &'a [f64],
    /// Rows of this set among the active ones.
    rows: std::ops::Range<usize>,
    displacements: bool,
    values: [Vec<f64>; COMPONENTS],
}

impl<'a> WaveSums<'a> {
    fn new(places: &'a [f64], active: &[Active], set: usize, displacements: bool) -> Self {
        let from = active.partition_point(|active| active.row.set < set);
        let rows = from..active.partition_point(|active| active.row.set <= set);
        let size = places.len() * rows.len();
        Self { places, rows, displacements, values: std::array::from_fn(|_| vec![0.0; size]) }
    }

    /// Adds a panel, with the transformed components of all parts.
    fn add(&mut self, geometry: Geometry, panel: &WavePanel, blocks: &[Vec<f64>], active: &[Active]) {
        let (n, m) = (panel.wavenumbers.len(), self.places.len());
        let count = active[self.rows.clone()].partition_point(|active| active.end > panel.lo);
        if count == 0 || m == 0 {
            return;
        }
        let tables = panel.tables(geometry, self.places);
        // the stress about the axis takes the displacement from it
        let wanted = match (self.displacements, geometry) {
            (true, _) => COMPONENTS,
            (false, Geometry::Axisymmetric) => 4,
            (false, _) => 3,
        };
        for (part, block) in CHANNELS.iter().zip(blocks) {
            for (component, (table, sign)) in part.tables.into_iter().enumerate().take(wanted) {
                let places = MatRef::from_column_major_slice(&tables[table], m, n);
                let mut coefficients = Vec::with_capacity(n * count);
                for k in self.rows.start..self.rows.start + count {
                    coefficients.extend_from_slice(&block[(COMPONENTS * k + component) * n..][..n]);
                }
                let coefficients = MatRef::from_column_major_slice(&coefficients, n, count);
                let sums = MatMut::from_column_major_slice_mut(&mut self.values[component][..m * count], m, count);
                matmul(sums, Accum::Add, places, coefficients, sign, Par::Seq);
            }
        }
    }

    fn collect(&self, active: &[Active], values: &mut [Vec<Components>]) {
        let m = self.places.len();
        for (k, active) in active[self.rows.clone()].iter().enumerate() {
            for (place, value) in values[active.index].iter_mut().enumerate() {
                for (component, value) in value.iter_mut().enumerate() {
                    *value += self.values[component][k * m + place];
                }
            }
        }
    }
}
