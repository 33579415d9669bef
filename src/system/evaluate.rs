//! The block system at one wavenumber: eliminated layer by layer, at a cost linear in the number of layers.
//!
//! Shear-free faces uncouple the system into *chains*: free laminates, and the base with all that is bonded to it. In a
//! chain each layer's four amplitudes follow from two conditions handed on by its neighbour and the two displacements
//! (or stresses) of its far face. Nothing grows: every layer offers its states in amplitudes that decay from a face.
use std::ops::Range;
use std::sync::Arc;

use nalgebra::{Matrix2, Matrix2x4, Matrix4, Matrix4x2, RowVector2, Vector2};
use recede_layers::graded::Remembering;
use recede_layers::{FaceStates, Flexibility, Layer, Plane, State, Wave, solve_equilibrated};

use super::across::allowed_above;
use super::repeats::{self, Bodies, Repeat};
use crate::stack::{Base, Foundation, Joint, Laminate, Placed};

/// Fields decay like e^(−λd): beyond this λd nothing is felt, since even squared it is below rounding.
const FELT: f64 = 40.0;

/// Layers joined to each other, top down, with shear-free faces above and below.
#[derive(Clone, Debug)]
pub struct FreeChain {
    pub(super) layers: Vec<Arc<dyn Layer>>,
    /// What joins each layer to the next.
    pub(super) joints: Vec<Joint>,
    /// The chain is eliminated from both faces to the interface above layer `meeting`, the one nearest to the neutral
    /// axis: seen from afar, the bending of a stiff part would cancel against its stretching.
    pub(super) meeting: usize,
    pub(super) repeats: Vec<Repeat>,
}

/// How many layers a flexibility has taken.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Taken {
    /// Those that the wave is felt by.
    pub(crate) felt: usize,
    /// Those that were evaluated, others being like them.
    pub(crate) evaluated: usize,
}

impl std::ops::AddAssign for Taken {
    fn add_assign(&mut self, other: Self) {
        self.felt += other.felt;
        self.evaluated += other.evaluated;
    }
}

/// Layers joined to each other and to a foundation, top down, with a shear-free top face.
#[derive(Clone, Debug)]
pub struct BaseChain {
    pub(super) layers: Vec<Arc<dyn Layer>>,
    /// What joins each layer to the next, and the last one to the foundation.
    pub(super) joints: Vec<Joint>,
    pub(super) foundation: Foundation,
    pub(super) repeats: Vec<Repeat>,
}

impl FreeChain {
    /// The chain of a laminate; the layers' stiffness decides where elimination from both faces meets.
    pub fn new(laminate: &Laminate, plane: Plane) -> Self {
        let layers = shared(laminate.layers());
        // three points tell where a layer is stiff, also if it is graded
        let mut depth = 0.0;
        let (mut stiffness, mut moment) = (0.0, 0.0);
        let mut faces = vec![0.0];
        for layer in &layers {
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
        let meeting = (0..faces.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0);
        let joints = laminate.joints().to_vec();
        let repeats = repeats::find(&layers, &joints);
        Self { layers, joints, meeting, repeats }
    }

    /// Flexibility at one wavenumber; `None` if a layer's states are not finite or do not determine its fields.
    pub fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        self.flexibility_and_taken(wave).map(|(flexibility, _)| flexibility)
    }

    /// The same, and how many layers it took.
    pub(crate) fn flexibility_and_taken(&self, wave: &Wave) -> Option<(Flexibility, Taken)> {
        let count = self.layers.len();
        let above = felt(self.layers.iter(), wave);
        let below = felt(self.layers.iter().rev(), wave);
        if above + below <= count && above < count {
            // the faces do not feel each other
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
        let felt = range.len();
        if let [layer] = &self.layers[range.clone()] {
            let own = layer.flexibility(wave).or_else(|| Flexibility::of_face_states(&layer.face_states(wave)));
            return Some((own?, Taken { felt, evaluated: 1 }));
        }
        let [upper, lower] =
            [range.start..meeting, meeting..range.end].map(|part| Bodies::new(&self.layers, &self.repeats, part, wave));
        let mut above = Half::free();
        for body in upper.iter(wave) {
            let FaceStates::Finite { top, bottom, uniform: [at_top, at_bottom] } = body.states else { return None };
            above = above.through((&top, &at_top), (&bottom, &at_bottom))?;
            if body.layers.end < range.end {
                above = above.across(&self.joints[body.layers.end - 1], wave, true)?.0;
            }
        }
        let mut below = Half::free();
        for body in lower.iter(wave).rev() {
            let FaceStates::Finite { top, bottom, uniform: [at_top, at_bottom] } = body.states else { return None };
            below = below.through((&bottom, &at_bottom), (&top, &at_top))?;
            if body.layers.start > meeting {
                below = below.across(&self.joints[body.layers.start - 1], wave, false)?.0;
            }
        }
        let evaluated = upper.evaluated + lower.evaluated;
        Some((joined(&above, &below)?, Taken { felt, evaluated }))
    }

    /// The layers, top down.
    pub fn layers(&self) -> &[Arc<dyn Layer>] {
        &self.layers
    }
}

impl BaseChain {
    /// The chain of a base.
    pub fn new(base: &Base) -> Self {
        let foundation = match base.foundation() {
            Foundation::HalfPlane(placed) => {
                Foundation::HalfPlane(Placed { number: placed.number, layer: Remembering::of(placed.layer.clone()) })
            }
            rigid @ Foundation::Rigid { .. } => rigid.clone(),
        };
        let (layers, joints) = (shared(base.layers()), base.joints().to_vec());
        let repeats = repeats::find(&layers, &joints);
        Self { layers, joints, foundation, repeats }
    }

    /// λμ₀C: displacement of the top face, times λμ₀, under unit pressure amplitude S on it; `None` as for a laminate.
    pub fn flexibility(&self, wave: &Wave) -> Option<f64> {
        self.flexibility_and_taken(wave).map(|(flexibility, _)| flexibility)
    }

    /// The same, and how many of the layers it took, the foundation not counted.
    pub(crate) fn flexibility_and_taken(&self, wave: &Wave) -> Option<(f64, Taken)> {
        let felt = felt(self.layers.iter(), wave);
        // what the face of the foundation allows: two columns (λμ₀U, λμ₀V, S, T)
        let mut allowed = match &self.foundation {
            Foundation::HalfPlane(placed) if felt == self.layers.len() => match placed.layer.face_states(wave) {
                FaceStates::HalfPlane { top } => top,
                FaceStates::Finite { .. } => return None,
            },
            // a rigid foundation, or one too deep to be felt
            _ => with_unit_stress(&Matrix2::zeros()),
        };
        let bodies = Bodies::new(&self.layers, &self.repeats, 0..felt, wave);
        for body in bodies.iter(wave).rev() {
            let FaceStates::Finite { top, bottom, .. } = body.states else { return None };
            allowed = allowed_above(allowed, &self.joints[body.layers.end - 1], wave);
            let amplitudes: Matrix4x2<f64> = solve_equilibrated(
                stacked(&(reciprocal(&allowed) * bottom), &stress(&top)),
                Matrix4x2::from_fn(|i, j| if i == j + 2 { 1.0 } else { 0.0 }),
            )?;
            allowed = with_unit_stress(&(displacement(&top) * amplitudes));
        }
        let stress: Matrix2<f64> = allowed.fixed_rows::<2>(2).into_owned();
        let unit = solve_equilibrated(stress, Vector2::new(1.0, 0.0))?;
        Some(((allowed.row(1) * unit)[0], Taken { felt, evaluated: bodies.evaluated }))
    }

    /// The layers bonded to the foundation, top down.
    pub fn layers(&self) -> &[Arc<dyn Layer>] {
        &self.layers
    }

    /// What lies below them.
    pub fn foundation(&self) -> &Foundation {
        &self.foundation
    }
}

fn shared(placed: &[Placed]) -> Vec<Arc<dyn Layer>> {
    placed.iter().map(|placed| Remembering::of(placed.layer.clone())).collect()
}

/// How many of the layers, counted from a face, the face can feel.
pub(super) fn felt<'a>(layers: impl Iterator<Item = &'a Arc<dyn Layer>>, wave: &Wave) -> usize {
    let mut length = 0.0;
    let mut count = 0;
    for layer in layers {
        if length > FELT {
            break;
        }
        let thickness = layer.thickness().unwrap_or(f64::INFINITY);
        let own = wave.wavenumber * thickness;
        // unless what stiffens a layer along its faces carries the fields farther
        length += if length + own > FELT { own * slowest_decay(&**layer, thickness, wave.plane) } else { own };
        count += 1;
    }
    count
}

/// The slowest decay of fields in a layer, see [`Material::slowest_decay`].
///
/// [`Material::slowest_decay`]: recede_layers::Material::slowest_decay
pub(crate) fn slowest_decay(layer: &dyn Layer, thickness: f64, plane: Plane) -> f64 {
    let at = |depth: f64| layer.material(depth, plane).slowest_decay();
    [0.0, 0.5, 1.0].map(|part| at(part * thickness)).into_iter().fold(1.0, f64::min)
}

/// Two halves that meet.
fn joined(above: &Half, below: &Half) -> Option<Flexibility> {
    // stresses are continuous: K_above w + ... = K_below w + ..., for a load on top, on the bottom, on both
    let zero = Vector2::zeros();
    let loads =
        nalgebra::Matrix2x3::from_columns(&[zero - above.by_load, below.by_load, below.by_equal - above.by_equal]);
    let w = solve_equilibrated(above.stiffness - below.stiffness, loads)?;
    let top = above.face * w;
    let bottom = below.face * w;
    let (top_by_top, bottom_by_bottom) = (top[0] + above.face_by_load, bottom[1] + below.face_by_load);
    Some(Flexibility {
        top: top_by_top,
        coupling: Flexibility::coupling(top_by_top, top[1], bottom[0], bottom_by_bottom),
        bottom: bottom_by_bottom,
        equal_top: top[2] + above.face_by_equal,
        equal_bottom: bottom[2] + below.face_by_equal,
    })
}

/// The part of a free chain between a loaded face and an interface, with the amplitudes eliminated: the stresses (S, T)
/// at the interface and V at the face, as functions of the displacements w = (U, V) at the interface and of the load.
/// Under equal loads on both faces of the chain, S means the excess over the load.
pub(super) struct Half {
    pub(super) stiffness: Matrix2<f64>,
    pub(super) by_load: Vector2<f64>,
    pub(super) by_equal: Vector2<f64>,
    pub(super) face: RowVector2<f64>,
    pub(super) face_by_load: f64,
    pub(super) face_by_equal: f64,
}

impl Half {
    /// Nothing yet: the interface is the loaded face itself.
    pub(super) fn free() -> Self {
        Self {
            stiffness: Matrix2::zeros(),
            by_load: Vector2::new(1.0, 0.0),
            by_equal: Vector2::zeros(),
            face: RowVector2::new(0.0, 1.0),
            face_by_load: 0.0,
            face_by_equal: 0.0,
        }
    }

    /// One layer more: `near` is its face at the present interface, `far` the one that becomes the interface.
    fn through(&self, near: (&Matrix4<f64>, &State), far: (&Matrix4<f64>, &State)) -> Option<Self> {
        Some(self.eliminate(near, far)?.0)
    }

    /// The same, with the amplitudes of the layer: columns for the displacements w at the far face, for the load and for
    /// equal loads.
    pub(super) fn eliminate(
        &self,
        near: (&Matrix4<f64>, &State),
        far: (&Matrix4<f64>, &State),
    ) -> Option<(Self, Matrix4<f64>)> {
        let [(near, near_uniform), (far, far_uniform)] = [near, far];
        let condition = stress(near) - self.stiffness * displacement(near);
        let uniform_condition =
            self.by_equal - (near_uniform.fixed_rows::<2>(2) - self.stiffness * near_uniform.fixed_rows::<2>(0));
        let mut loads = Matrix4::zeros();
        loads.fixed_view_mut::<2, 2>(2, 0).fill_with_identity();
        loads.fixed_view_mut::<2, 1>(0, 2).copy_from(&self.by_load);
        loads.fixed_view_mut::<2, 1>(0, 3).copy_from(&uniform_condition);
        loads.fixed_view_mut::<2, 1>(2, 3).copy_from(&-far_uniform.fixed_rows::<2>(0));
        let amplitudes = solve_equilibrated(stacked(&condition, &displacement(far)), loads)?;
        let at_far = stress(far) * amplitudes;
        let at_near = self.face * displacement(near) * amplitudes;
        let half = Self {
            stiffness: at_far.fixed_columns::<2>(0).into_owned(),
            by_load: at_far.column(2).into_owned(),
            by_equal: at_far.column(3) + far_uniform.fixed_rows::<2>(2),
            face: at_near.fixed_columns::<2>(0).into_owned(),
            face_by_load: self.face_by_load + at_near[2],
            face_by_equal: self.face_by_equal + at_near[3] + (self.face * near_uniform.fixed_rows::<2>(0))[0],
        };
        Some((half, amplitudes))
    }
}

/// The states for S = 1 and for T = 1, from the displacements under them.
pub(super) fn with_unit_stress(flexibility: &Matrix2<f64>) -> Matrix4x2<f64> {
    let mut states = Matrix4x2::zeros();
    states.fixed_rows_mut::<2>(0).copy_from(flexibility);
    states.fixed_rows_mut::<2>(2).fill_with_identity();
    states
}

/// Two rows that vanish on what a base allows, and on nothing else: by reciprocity its states do no work on each other,
/// U₁T₂ − T₁U₂ + V₁S₂ − S₁V₂ = 0. Unlike a flexibility they exist for any base, be it rigid or free to slide.
pub(super) fn reciprocal(allowed: &Matrix4x2<f64>) -> Matrix2x4<f64> {
    Matrix2x4::from_fn(|i, j| if j < 2 { -allowed[(3 - j, i)] } else { allowed[(3 - j, i)] })
}

pub(super) fn displacement(states: &Matrix4<f64>) -> Matrix2x4<f64> {
    states.fixed_rows::<2>(0).into_owned()
}

pub(super) fn stress(states: &Matrix4<f64>) -> Matrix2x4<f64> {
    states.fixed_rows::<2>(2).into_owned()
}

pub(super) fn stacked(upper: &Matrix2x4<f64>, lower: &Matrix2x4<f64>) -> Matrix4<f64> {
    Matrix4::from_rows(&[upper.row(0), upper.row(1), lower.row(0), lower.row(1)])
}
