//! The chain of a base: layers joined to a foundation.
use std::sync::Arc;

use nalgebra::{Matrix2, Matrix2x4, Matrix4x2};
use recede_layers::{Body, FaceStates, Layer, Support, Wave, solve_equilibrated};

use super::cut_off::cut_off;
use super::free::{junctions, layers};
use super::half::{displacement, eliminate_two, stacked, stress, uniform};
use super::junction::{Junction, JunctionRows};
use super::repeats::{self, Bodies, Repeat};
use crate::solution::Stats;
use crate::system::{BlockSystem, Component, InterfaceSide};

/// Layers joined to each other and to a foundation, top down, with a shear-free top face: the component of the block system
/// that nothing presses on from below.
#[derive(Clone, Debug)]
pub struct BaseChain {
    /// The layers of finite thickness.
    pub(super) layers: Vec<Arc<dyn Layer>>,
    /// Between each layer and the next, and above an elastic foundation.
    pub(super) junctions: Vec<Junction>,
    pub(super) foot: Foot,
    pub(super) repeats: Vec<Repeat>,
}

/// The lower end of a base.
#[derive(Clone, Debug)]
pub(super) enum Foot {
    /// A half-plane, a column of two amplitudes.
    HalfPlane(Arc<dyn Layer>),
    /// A support, a column of two amplitudes, too.
    Support(Arc<dyn Support>),
    /// Rows on the bottom face of the last layer.
    Held(Box<JunctionRows<2>>),
}

/// The bodies below an interface of a base, eliminated: two states of which all states at the upper face of these bodies are combinations.
pub(super) type Below = Matrix4x2<f64>;

impl BaseChain {
    /// The base of a block system; it has no layers if all layers are above a receding interface on a rigid base.
    pub fn of(system: &BlockSystem) -> Self {
        let components = system.components();
        let rigid = Component::default();
        Self::new(components.iter().find(|component| !component.is_free()).unwrap_or(&rigid))
    }

    fn new(component: &Component<'_>) -> Self {
        let mut layers = layers(component);
        let junctions = junctions(component);
        let foot = match component.columns().last().map(|column| column.body()) {
            Some(Body::Support(support)) => Foot::Support(Arc::clone(support)),
            _ => match layers.pop_if(|last| last.thickness().is_none()) {
                Some(half_plane) => Foot::HalfPlane(half_plane),
                None => Foot::Held(Box::new(JunctionRows::new(component.rows_at(layers.len())))),
            },
        };
        let repeats = repeats::find(&layers, &junctions);
        Self { layers, junctions, foot, repeats }
    }

    /// λμ₀C: displacement of the top face, times λμ₀, under unit pressure amplitude S on it; `None` if a layer's states are not
    /// finite or do not determine its fields.
    pub fn flexibility(&self, wave: &Wave) -> Option<f64> {
        self.counted_flexibility(wave, &mut Stats::default())
    }

    /// The flexibility, with the layers evaluated for it counted, without the foundation.
    pub(crate) fn counted_flexibility(&self, wave: &Wave, stats: &mut Stats) -> Option<f64> {
        let cut_off = cut_off(&self.layers, &self.junctions, 0..self.layers.len(), wave);
        stats.below_decay_depth += self.layers.len() - cut_off;
        let states = |column: &dyn Layer| match column.face_states(wave) {
            FaceStates::HalfPlane { top } => Some(top),
            FaceStates::Finite { .. } => None,
        };
        let mut below = self.below(cut_off, wave, states)?;
        let bodies = Bodies::new(&self.layers, &self.repeats, 0..cut_off, wave);
        bodies.count(stats);
        for body in bodies.iter(wave).rev() {
            (below, ..) = self.with_layer(&below, body.layers.end, &body.states, wave)?;
        }
        let stress: Matrix2<f64> = below.fixed_rows::<2>(2).into_owned();
        let shares = solve_equilibrated(stress, uniform())?;
        Some((below.row(1) * shares)[0])
    }

    /// The bodies below the layers above the cut-off; `states` gives the states at the face of a half-plane.
    pub(super) fn below(
        &self,
        cut_off: usize,
        wave: &Wave,
        states: impl FnOnce(&dyn Layer) -> Option<Matrix4x2<f64>>,
    ) -> Option<Below> {
        let rigid = with_unit_stress(&Matrix2::zeros());
        match &self.foot {
            // fields have decayed: the layers below the cut-off count as rigid
            _ if cut_off < self.layers.len() => Some(rigid),
            Foot::HalfPlane(layer) => states(&**layer),
            Foot::Support(support) => Some(support.face_states(wave)),
            Foot::Held(_) if self.layers.is_empty() => Some(rigid),
            Foot::Held(rows) => Some(allowed(&rows.at(wave)[0])),
        }
    }

    /// The bodies below an interface with a layer on top, which has these states at its faces and is the last one of so many. Also the amplitudes of
    /// the layer, and the stresses on its bottom face, under unit stresses S and T on its top face.
    pub(super) fn with_layer(
        &self,
        below: &Below,
        layers: usize,
        states: &FaceStates,
        wave: &Wave,
    ) -> Option<(Below, Matrix4x2<f64>, Matrix2<f64>)> {
        let FaceStates::Finite { top, bottom, .. } = states else { return None };
        let junction = self.junctions.get(layers - 1);
        let (condition, shares) = match junction.and_then(|junction| junction.at(wave, InterfaceSide::Above)) {
            None => (reciprocal(below), None),
            Some([above, rows]) => {
                let [left, solved] = eliminate_two(rows * below, above)?;
                (left, Some(solved))
            }
        };
        let amplitudes: Matrix4x2<f64> = solve_equilibrated(
            stacked(&(condition * bottom), &stress(top)),
            Matrix4x2::from_fn(|i, j| if i == j + 2 { 1.0 } else { 0.0 }),
        )?;
        // where states differ on both sides, the shares of the states below
        let at_bottom = shares.map_or_else(|| stress(bottom) * amplitudes, |shares| shares * bottom * amplitudes);
        Some((with_unit_stress(&(displacement(top) * amplitudes)), amplitudes, at_bottom))
    }

    /// The layers of finite thickness, top down.
    pub fn layers(&self) -> &[Arc<dyn Layer>] {
        &self.layers
    }

    /// The layer with the top face: the foundation, if it is one and there are no others.
    pub fn top_layer(&self) -> Option<&Arc<dyn Layer>> {
        self.layers.first().or(match &self.foot {
            Foot::HalfPlane(layer) => Some(layer),
            Foot::Support(_) | Foot::Held(_) => None,
        })
    }
}

/// The states for S = 1 and for T = 1, from the displacements under them.
fn with_unit_stress(flexibility: &Matrix2<f64>) -> Matrix4x2<f64> {
    let mut states = Matrix4x2::zeros();
    states.fixed_rows_mut::<2>(0).copy_from(flexibility);
    states.fixed_rows_mut::<2>(2).fill_with_identity();
    states
}

/// Two rows that vanish on the states that a base allows, and on no others: by reciprocity these do no work on each other,
/// U₁T₂ − T₁U₂ + V₁S₂ − S₁V₂ = 0. Unlike a flexibility they exist for any base, be it rigid or free to slide.
pub(super) fn reciprocal(allowed: &Matrix4x2<f64>) -> Matrix2x4<f64> {
    Matrix2x4::from_fn(|i, j| if j < 2 { -allowed[(3 - j, i)] } else { allowed[(3 - j, i)] })
}

/// Two states that fulfil two rows: the inverse of [`reciprocal`].
fn allowed(rows: &Matrix2x4<f64>) -> Below {
    Matrix4x2::from_fn(|i, j| if i < 2 { rows[(j, 3 - i)] } else { -rows[(j, 3 - i)] })
}
