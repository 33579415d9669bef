//! Free chains: laminates between two loaded faces.
use std::ops::Range;
use std::sync::Arc;

use nalgebra::Matrix2x3;
use recede_layers::graded::Remembering;
use recede_layers::{FaceStates, Flexibility, Layer, Plane, Wave};

use super::cut_off::cut_off;
use super::half::{FaceOf, Half, PutBack, flexibility, meet};
use super::junction::Junction;
use super::repeats::{self, Bodies, JoinedLayers, Repeat};
use crate::solution::Stats;
use crate::system::{BlockSystem, Component, InterfaceSide};

/// Layers joined to each other, top down, with shear-free faces above and below: a component of the block system that only
/// the pressures on both of its faces hold.
///
/// ```
/// use recede::{BlockSystem, FreeChain, HalfPlane, Homogeneous, Plane, Stack, Wave};
/// let strip = Homogeneous::new(1.0, 1.0, 0.25)?;
/// let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(HalfPlane::new(1.0, 0.25)?).build()?;
/// let chains = FreeChain::all(&BlockSystem::new(&stack));
/// let wave = Wave { wavenumber: 1.0, modulus: 1.0, plane: Plane::Strain };
/// assert!(chains[0].flexibility(&wave).is_some_and(|found| found.top > 0.0));
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct FreeChain {
    pub(super) layers: Vec<Arc<dyn Layer>>,
    /// Between each layer and the next.
    pub(super) junctions: Vec<Junction>,
    /// The chain is eliminated from both faces to the interface above layer `meeting`, the one nearest to the neutral
    /// axis: for long waves, the bending of a stiff part would cancel against its stretching.
    pub(super) meeting: usize,
    pub(super) repeats: Vec<Repeat>,
}

impl FreeChain {
    /// The free laminates of a block system, from the top down.
    pub fn all(system: &BlockSystem) -> Vec<Self> {
        let components = system.components();
        components.iter().filter(|component| component.is_free()).map(|free| Self::new(free, system.plane())).collect()
    }

    /// Elimination from both faces meets next to the neutral axis, which follows from the stiffness of the layers.
    fn new(component: &Component<'_>, plane: Plane) -> Self {
        let layers = layers(component);
        let junctions = junctions(component);
        let repeats = repeats::find(&layers, &junctions);
        Self { meeting: neutral_interface(&layers, plane), layers, junctions, repeats }
    }

    /// Flexibility at one wavenumber; `None` if a layer's states are not finite or do not determine its fields.
    pub fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        self.counted_flexibility(wave, &mut Stats::default())
    }

    /// The flexibility, with the layers evaluated for it counted.
    pub(crate) fn counted_flexibility(&self, wave: &Wave, stats: &mut Stats) -> Option<Flexibility> {
        let count = self.layers.len();
        let Some([above, below]) = self.decayed(wave) else {
            return self.part(0..count, self.meeting, wave, stats);
        };
        stats.below_decay_depth += below - above;
        let top = self.part(0..above, 0, wave, stats)?.top;
        let bottom = self.part(below..count, count, wave, stats)?.bottom;
        Some(Flexibility { top, coupling: 0.0, bottom, equal_top: top, equal_bottom: bottom })
    }

    /// The layers between which the fields of loads on either face have decayed; `None` if they meet.
    pub(super) fn decayed(&self, wave: &Wave) -> Option<[usize; 2]> {
        let count = self.layers.len();
        let above = cut_off(&self.layers, &self.junctions, 0..count, wave);
        let below = cut_off(&self.layers, &self.junctions, (0..count).rev(), wave);
        (above + below <= count && above < count).then_some([above, count - below])
    }

    /// Flexibility of some of the layers, eliminated from both faces to the interface above layer `meeting`.
    fn part(&self, range: Range<usize>, meeting: usize, wave: &Wave, stats: &mut Stats) -> Option<Flexibility> {
        if let [layer] = &self.layers[range.clone()] {
            stats.layers += 1;
            return layer.flexibility(wave).or_else(|| Flexibility::of_face_states(&layer.face_states(wave)));
        }
        let [upper, lower] =
            [range.start..meeting, meeting..range.end].map(|part| Bodies::new(&self.layers, &self.repeats, part, wave));
        upper.count(stats);
        lower.count(stats);
        let (mut down, mut up) = (upper.iter(wave), lower.iter(wave).rev());
        let (halves, displacements) = self.eliminate(&range, meeting, wave, [&mut down, &mut up], |_, _, _| ())?;
        Some(flexibility(&halves, &displacements))
    }

    /// Eliminates the amplitudes of `bodies`, those between the upper face of `range` and the interface above layer `meeting` from the top down
    /// and those between the lower face and this interface from the bottom up. `keep` is given the half, 0 or 1, the first layer of each body and
    /// its back substitution. Returns the halves, and the displacements where they meet, see [`meet`].
    pub(super) fn eliminate(
        &self,
        range: &Range<usize>,
        meeting: usize,
        wave: &Wave,
        bodies: [&mut dyn Iterator<Item = JoinedLayers>; 2],
        mut keep: impl FnMut(usize, usize, PutBack),
    ) -> Option<([Half; 2], [Matrix2x3<f64>; 2])> {
        let junction = |interface: usize| {
            let is_inside = range.start < interface && interface < range.end;
            if is_inside { self.junctions.get(interface - 1) } else { None }
        };
        let mut halves = [Half::of_face(); 2];
        for (side, bodies) in bodies.into_iter().enumerate() {
            for JoinedLayers { layers, states } in bodies {
                let [near, far] = faces(&states, side)?;
                let (interface, near_side) =
                    [(layers.start, InterfaceSide::Above), (layers.end, InterfaceSide::Below)][side];
                let across = junction(interface).and_then(|junction| junction.at(wave, near_side));
                let (half, put_back) = halves[side].through(across, near, far)?;
                halves[side] = half;
                keep(side, layers.start, put_back);
            }
        }
        let displacements = meet(&halves, junction(meeting), wave)?;
        Some((halves, displacements))
    }

    /// The layers, top down.
    pub fn layers(&self) -> &[Arc<dyn Layer>] {
        &self.layers
    }
}

/// The faces of a layer, first the one that is nearer to the loaded face of the upper half, 0, or the lower half, 1.
pub(super) fn faces(states: &FaceStates, side: usize) -> Option<[FaceOf<'_>; 2]> {
    let FaceStates::Finite { top, bottom, uniform: [at_top, at_bottom] } = states else { return None };
    let mut faces = [(top, at_top), (bottom, at_bottom)];
    faces.swap(0, side);
    Some(faces)
}

/// The layers of a component, which keep what the general body computes of them.
pub(super) fn layers(component: &Component<'_>) -> Vec<Arc<dyn Layer>> {
    let layers = component.columns().iter().filter_map(|column| column.body().layer());
    layers.map(|layer| Remembering::of(layer.clone())).collect()
}

/// The interfaces between the columns of a component.
pub(super) fn junctions(component: &Component<'_>) -> Vec<Junction> {
    (1..component.columns().len()).map(|interface| Junction::new(component.rows_at(interface))).collect()
}

/// The interface, counted as the layer below it, that is nearest to the neutral axis of bending.
fn neutral_interface(layers: &[Arc<dyn Layer>], plane: Plane) -> usize {
    // Simpson's rule, for graded layers
    let mut depth = 0.0;
    let (mut stiffness, mut moment) = (0.0, 0.0);
    let mut faces = vec![0.0];
    for layer in layers {
        let h = layer.thickness().unwrap_or(0.0);
        for (at, weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
            let share = weight * h / 6.0 * layer.material(at * h, plane).axial_stiffness;
            stiffness += share;
            moment += share * (depth + at * h);
        }
        depth += h;
        faces.push(depth);
    }
    let neutral = moment / stiffness;
    let distance = |i: &usize| (faces[*i] - neutral).abs();
    (0..faces.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
}
