//! The bodies of a stack, free laminates and base, with the contacts that press on them.
use std::ops::Range;
use std::sync::Arc;

use recede_layers::{Layer, Material, State, Wave, layer_label};

use super::pressure::ContactPressure;
use super::surface::{Components, Remainder, Surface};
use crate::geometry::Geometry;
use crate::stack::{Placed, ResidualStrain, Stack, residual_stress};
use crate::system::{BaseChain, BlockSystem, FaceLoad, FreeChain, slowest_decay};

/// The remainder of a half-plane's fields counts as zero below this.
const NEGLIGIBLE: f64 = 1e-13;
/// The lowest wavenumber, over the shift of a [`Surface`], at which the remainder is examined, and how often it is doubled.
const SHORT: f64 = 36.0;
const DOUBLINGS: usize = 4;
/// A material varies over the depth within which it changes by this part. It is a length scale only: twice as large a
/// change makes it twice as long.
const CHANGE: f64 = 0.1;
/// Most doublings, or halvings, of a length in the search for it.
const SCALES: usize = 200;

/// A layer with its place in the stack and in its body.
#[derive(Clone, Debug)]
pub(super) struct PlacedLayer {
    /// Number from the top as written in the scene.
    pub(super) number: usize,
    pub(super) layer: Arc<dyn Layer>,
    /// Depth of its top face below the top face of the stack.
    pub(super) top: f64,
    /// `None` for a half-plane.
    pub(super) thickness: Option<f64>,
    /// Fields decay at least like e^(−slowest·λ·depth).
    pub(super) slowest: f64,
    /// The body it belongs to, and its place in it.
    pub(super) body: usize,
    pub(super) place: usize,
    /// The modulus of stretching along it in its middle, or at the face of a half-plane, in stress.
    pub(super) stiffness: f64,
    /// How eigenstrains and weights strain it, if there are any.
    pub(super) residual: Option<ResidualStrain>,
}

impl PlacedLayer {
    /// The stresses before anything presses but weights: along the layer, across it, and out of the plane or about the axis.
    pub(super) fn residual(&self, depth: f64, geometry: Geometry) -> [f64; 3] {
        let of = |strain| {
            let material = self.layer.material(depth, geometry.plane());
            residual_stress(&*self.layer, &material, geometry, strain, depth)
        };
        self.residual.map_or([0.0; 3], of)
    }

    /// Its name in messages.
    pub(super) fn label(&self) -> String {
        layer_label(self.number, self.layer.name())
    }

    /// Depth of its bottom face, infinite for a half-plane.
    pub(super) fn bottom(&self) -> f64 {
        self.thickness.map_or(f64::INFINITY, |thickness| self.top + thickness)
    }
}

#[derive(Clone, Debug)]
enum Chain {
    Free(FreeChain),
    Base(BaseChain),
}

/// Points at one depth.
#[derive(Clone, Copy, Debug)]
pub(super) struct DepthRow {
    /// Index of the layer.
    pub(super) layer: usize,
    /// Depth below its top face.
    pub(super) depth: f64,
    /// Index of the list of places.
    pub(super) set: usize,
}

/// Rows of points, and the lists of places along x, counted from the middle, at which they are.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    pub(super) rows: Vec<DepthRow>,
    pub(super) sets: Vec<Vec<f64>>,
}

impl Rows {
    /// Adds rows in a layer at some places: the number of the first of them.
    pub(super) fn add(&mut self, layer: usize, depths: &[f64], places: Vec<f64>) -> usize {
        let set = self.sets.iter().position(|set| *set == places).unwrap_or(self.sets.len());
        if set == self.sets.len() {
            self.sets.push(places);
        }
        self.rows.extend(depths.iter().map(|depth| DepthRow { layer, depth: *depth, set }));
        self.rows.len() - depths.len()
    }
}

/// A body between shear-free faces.
#[derive(Clone, Debug)]
pub(super) struct LoadedBody {
    chain: Chain,
    /// Its layers among all.
    pub(super) layers: Range<usize>,
    /// Depth of its top face.
    pub(super) top: f64,
    /// Depth of its bottom face, if that is loaded.
    pub(super) bottom: Option<f64>,
    /// The contact on its top face; that on the bottom face is the next one.
    pub(super) contact: usize,
    /// The faces, top first, whose slowly converging part is known in closed form.
    pub(super) faces: [Option<Surface>; 2],
    /// The depth from whose point in the middle v is counted.
    pub(super) reference: Option<DepthRow>,
}

/// Thickness of the thinnest layer.
pub(super) fn thinnest(layers: &[PlacedLayer]) -> f64 {
    layers.iter().filter_map(|placed| placed.thickness).fold(f64::INFINITY, f64::min)
}

/// The layers from the top down, without layers of thickness 0.
pub(super) fn layers(stack: &Stack) -> Vec<PlacedLayer> {
    let mut layers: Vec<PlacedLayer> = Vec::new();
    let (mut top, residual) = (0.0, stack.residual());
    for (body, group) in stack.groups().enumerate() {
        for (place, Placed { number, layer, .. }) in group.layers().enumerate() {
            let (number, layer, thickness) = (*number, layer.clone(), layer.thickness());
            let slowest = slowest_decay(&*layer, thickness.unwrap_or(0.0), stack.plane());
            let residual = residual.as_ref().map(|residual| residual.layers[layers.len()]);
            let stiffness = layer.material(0.5 * thickness.unwrap_or(0.0), stack.plane()).axial_stiffness;
            layers.push(PlacedLayer { number, layer, top, thickness, slowest, body, place, stiffness, residual });
            top += thickness.unwrap_or(0.0);
        }
    }
    layers
}

impl LoadedBody {
    /// The bodies from the top down; a rigid base without layers is not one of them.
    pub(super) fn all(stack: &Stack, layers: &[PlacedLayer], pressures: &[ContactPressure], modulus: f64) -> Vec<Self> {
        let system = BlockSystem::new(stack);
        let laminates = FreeChain::all(&system).into_iter().map(Chain::Free);
        let chains = laminates.chain([Chain::Base(BaseChain::of(&system))]);
        let unit = Wave { wavenumber: 1.0, modulus, plane: stack.plane() };
        let of = |(contact, chain): (usize, Chain)| {
            let from = layers.partition_point(|placed| placed.body < contact);
            let own = from..layers.partition_point(|placed| placed.body <= contact);
            let (first, last) = (layers[own.clone()].first()?, layers[own.clone()].last()?);
            let free = matches!(chain, Chain::Free(_));
            let depth = match last.thickness {
                // the bottom face of a laminate or the top face of a half-plane; a rigid base does not move
                Some(thickness) => free.then_some(thickness),
                // displacements vanish far away if forces do not act on whole lines
                None if stack.geometry().is_axisymmetric() => None,
                None => Some(0.0),
            };
            let reference = depth.map(|depth| DepthRow { layer: own.end - 1, depth, set: 0 });
            let (top, bottom) = (first.top, free.then(|| last.bottom()));
            let mut body = Self { chain, layers: own, top, bottom, contact, faces: [None, None], reference };
            body.faces[0] = body.face(0, first, &pressures[contact], unit);
            body.faces[1] = pressures.get(contact + 1).filter(|_| free).and_then(|own| body.face(1, last, own, unit));
            Some(body)
        };
        chains.enumerate().filter_map(of).collect()
    }

    /// A loaded face, 0 on top or 1 at the bottom, of the layer that has it.
    fn face(&self, side: usize, placed: &PlacedLayer, pressure: &ContactPressure, unit: Wave) -> Option<Surface> {
        let Wave { plane, modulus, .. } = unit;
        let material = |distance: f64| match placed.thickness {
            Some(thickness) if side == 1 => placed.layer.material((thickness - distance).max(0.0), plane),
            _ => placed.layer.material(distance, plane),
        };
        let length = placed.thickness.unwrap_or_else(|| depth_of_change(&material, pressure.half_length));
        let mut surface = Surface::new(&material, length, modulus)?;
        (surface.is_round, surface.up) = (pressure.is_round(), if side == 1 { -1.0 } else { 1.0 });
        if self.layers.len() == 1 && placed.thickness.is_none() {
            // a homogeneous half-plane has no remainder at any wavenumber
            let mut whole = surface.clone();
            whole.shift = f64::INFINITY;
            let remainder = |l: f64| self.remainder(&whole, side, placed, &Wave { wavenumber: l / length, ..unit });
            if [1e-3, 0.1, 1.0, 10.0].into_iter().all(|l| remainder(l).is_some_and(|part| part < NEGLIGIBLE)) {
                return Some(whole);
            }
        }
        let short = SHORT / surface.shift;
        let waves: [Wave; DOUBLINGS] =
            std::array::from_fn(|k| Wave { wavenumber: short * 2f64.powi(k as i32), ..unit });
        let remainders = waves.iter().map(|wave| self.remainder(&surface, side, placed, wave));
        let remainders: Vec<f64> = remainders.collect::<Option<_>>()?;
        let (first, last) = (remainders[0], remainders[DOUBLINGS - 1]);
        if last <= NEGLIGIBLE {
            return Some(surface);
        }
        let power = ((first / last).log2() / (DOUBLINGS - 1) as f64).clamp(0.0, 3.0);
        let size = remainders.iter().zip(waves).map(|(remainder, wave)| remainder * wave.wavenumber.powf(power));
        surface.remainder = Remainder { size: size.fold(0.0, f64::max), power };
        Some(surface)
    }

    /// The remainder of the stresses next to a face, per unit load on it: the largest difference between the stresses of the body and of the surface.
    fn remainder(&self, surface: &Surface, side: usize, placed: &PlacedLayer, wave: &Wave) -> Option<f64> {
        let mut distances = [0.0, 1.0 / wave.wavenumber, 3.0 / wave.wavenumber];
        let depth = |distance: f64| if side == 0 { distance } else { placed.bottom() - placed.top - distance };
        if side == 1 {
            distances.reverse();
        }
        let mut depths = vec![Vec::new(); self.layers.len()];
        depths[placed.place] = distances.iter().map(|distance| depth(*distance)).collect();
        let (top, bottom) = if side == 0 { (-1.0, 0.0) } else { (0.0, -1.0) };
        let load = FaceLoad { top, bottom, equal: 0.0 };
        let states = self.states(wave, &depths, &load)?;
        let differences = distances.iter().zip(&states[placed.place]).map(|(distance, state)| {
            let found = components(state, &placed.layer.material(depth(*distance), wave.plane), wave.modulus);
            let surface = surface.transformed(wave.wavenumber, *distance);
            (0..3).map(|i| (found[i] - surface[i]).abs()).fold(0.0, f64::max)
        });
        Some(differences.fold(0.0, f64::max))
    }

    /// The faces whose closed forms hold at a depth in one of its layers, with the contact and the distance.
    pub(super) fn surfaces(&self, placed: &PlacedLayer, depth: f64) -> impl Iterator<Item = (&Surface, usize, f64)> {
        let above = Some(depth).filter(|_| placed.place == 0);
        let below = placed.thickness.filter(|_| placed.place + 1 == self.layers.len()).map(|h| (h - depth).max(0.0));
        let of =
            |(side, distance): (usize, Option<f64>)| Some((self.faces[side].as_ref()?, self.contact + side, distance?));
        [above, below].into_iter().enumerate().filter_map(of)
    }

    /// The contacts on its loaded faces, the face on top first.
    pub(super) fn contacts(&self) -> Range<usize> {
        self.contact..self.contact + 1 + usize::from(self.bottom.is_some())
    }

    /// The states at depths in ascending order below the top faces of the layers.
    pub(super) fn states(&self, wave: &Wave, depths: &[Vec<f64>], load: &FaceLoad) -> Option<Vec<Vec<State>>> {
        match &self.chain {
            Chain::Free(chain) => chain.states(wave, depths, load),
            Chain::Base(chain) => chain.states(wave, depths, load.top + load.equal),
        }
    }
}

/// The depth in a half-plane over which its material changes by about a tenth, whatever the load; for a homogeneous one, which
/// has no such depth, the half-length of the contact, or 1 under a line load.
fn depth_of_change(material: &dyn Fn(f64) -> Material, half_length: f64) -> f64 {
    let face = material(0.0);
    let changes = |depth: f64| {
        let Material { shear_compliance: m, normal_compliance: d, coupling: c, axial_stiffness: e, .. } =
            material(depth);
        let coefficients =
            [(m, face.shear_compliance), (d, face.normal_compliance), (c, face.coupling), (e, face.axial_stiffness)];
        coefficients.iter().any(|(there, here)| (there - here).abs() > CHANGE * here.abs())
    };
    let start = if half_length > 0.0 { half_length } else { 1.0 };
    let (mut depth, factor) = (start, if changes(start) { 0.5 } else { 2.0 });
    for _ in 0..SCALES {
        let next = depth * factor;
        match (changes(next), factor > 1.0) {
            (true, true) => return next,
            (false, false) => return depth,
            _ => depth = next,
        }
    }
    start
}

/// Stresses from a state, σ_xx = E λU + c S, and λμ₀U, λμ₀V, from which both v and its slope follow.
pub(super) fn components(state: &State, material: &recede_layers::Material, modulus: f64) -> Components {
    let along = material.axial_stiffness / modulus * state[0] + material.coupling * state[2];
    [along, state[2], state[3], state[0], state[1], state[1]]
}
