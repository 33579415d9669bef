//! Free chains: laminates between two loaded faces.
use std::ops::Range;
use std::sync::Arc;

use recede_layers::graded::Remembering;
use recede_layers::{FaceStates, Flexibility, Layer, Plane, Wave};

use super::cut_off::{Taken, cut_off};
use super::half::{Half, Meeting};
use super::junction::Junction;
use super::repeats::{self, Bodies, Repeat};
use crate::system::{BlockSystem, Component, Side};

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
    /// The loaded faces, the upper one first.
    pub(super) faces: [Half; 2],
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
        let faces = [(0, Side::Below), (layers.len(), Side::Above)];
        let faces = faces.map(|(interface, side)| Half::of_face(component.rows_at(interface), side));
        let repeats = repeats::find(&layers, &junctions);
        Self { meeting: neutral_interface(&layers, plane), layers, junctions, faces, repeats }
    }

    /// Flexibility at one wavenumber; `None` if a layer's states are not finite or do not determine its fields.
    pub fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        self.flexibility_and_taken(wave).map(|(flexibility, _)| flexibility)
    }

    /// The same, and the number of layers for it.
    pub(crate) fn flexibility_and_taken(&self, wave: &Wave) -> Option<(Flexibility, Taken)> {
        let count = self.layers.len();
        let above = cut_off(&self.layers, &self.junctions, 0..count, wave);
        let below = cut_off(&self.layers, &self.junctions, (0..count).rev(), wave);
        if above + below <= count && above < count {
            // the fields of either face have decayed before the other one
            let (top, mut taken) = self.part(0..above, 0, wave)?;
            let (bottom, more) = self.part(count - below..count, count, wave)?;
            taken += more;
            let apart = Flexibility {
                top: top.top,
                coupling: 0.0,
                bottom: bottom.bottom,
                equal_top: top.top,
                equal_bottom: bottom.bottom,
            };
            return Some((apart, taken));
        }
        self.part(0..count, self.meeting, wave)
    }

    /// Flexibility of some of the layers, eliminated from both faces to the interface above layer `meeting`.
    fn part(&self, range: Range<usize>, meeting: usize, wave: &Wave) -> Option<(Flexibility, Taken)> {
        let cut_off = range.len();
        if let [layer] = &self.layers[range.clone()] {
            let flexibility = layer.flexibility(wave).or_else(|| Flexibility::of_face_states(&layer.face_states(wave)));
            return Some((flexibility?, Taken { cut_off, evaluated: 1 }));
        }
        let [upper, lower] =
            [range.start..meeting, meeting..range.end].map(|part| Bodies::new(&self.layers, &self.repeats, part, wave));
        let inside = |interface: usize| range.start < interface && interface < range.end;
        let at = |interface: usize, near: Side| self.junction(interface).filter(|_| inside(interface))?.at(wave, near);
        let [mut above, mut below] = self.faces;
        for body in upper.iter(wave) {
            let FaceStates::Finite { top, bottom, uniform: [at_top, at_bottom] } = body.states else { return None };
            let across = at(body.layers.start, Side::Above);
            above = above.through(across, (&top, &at_top), (&bottom, &at_bottom))?.0;
        }
        for body in lower.iter(wave).rev() {
            let FaceStates::Finite { top, bottom, uniform: [at_top, at_bottom] } = body.states else { return None };
            let across = at(body.layers.end, Side::Below);
            below = below.through(across, (&bottom, &at_bottom), (&top, &at_top))?.0;
        }
        let evaluated = upper.evaluated + lower.evaluated;
        let junction = self.junction(meeting).filter(|_| inside(meeting));
        Some((Meeting::of(above, below, junction, wave)?.flexibility(), Taken { cut_off, evaluated }))
    }

    /// The interface above a layer; `None` above the first one.
    pub(super) fn junction(&self, interface: usize) -> Option<&Junction> {
        self.junctions.get(interface.checked_sub(1)?)
    }

    /// The layers, top down.
    pub fn layers(&self) -> &[Arc<dyn Layer>] {
        &self.layers
    }
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
