//! Errors in the structure of a stack.
use super::{MAX_CONTRAST, MAX_LAYERS, MAX_RECEDING};
use crate::solution::Interface;

/// The items do not make a stack.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{problem}")]
pub struct StackError {
    pub(super) item: Option<usize>,
    pub(super) problem: StackProblem,
}

impl StackError {
    pub(super) fn whole(problem: StackProblem) -> Self {
        Self { item: None, problem }
    }

    pub(super) fn at(index: usize, problem: StackProblem) -> Self {
        Self { item: Some(index), problem }
    }

    /// The error in the body that presses on top.
    pub(crate) fn of_second(problem: StackProblem) -> Self {
        Self::whole(StackProblem::OfSecond(Box::new(problem)))
    }

    /// Whether it is about the body that presses on top.
    pub(crate) fn is_of_second(&self) -> bool {
        matches!(self.problem, StackProblem::OfSecond(_))
    }

    /// The error at the layer of this number: layers and interfaces alternate.
    pub(super) fn of_layer(number: usize, problem: StackProblem) -> Self {
        Self::at(2 * (number - 1), problem)
    }

    /// Index of the offending item among the items, layers and interfaces, from 0; `None` if it is the whole stack.
    pub fn item(&self) -> Option<usize> {
        self.item
    }

    /// What is wrong.
    pub fn problem(&self) -> &StackProblem {
        &self.problem
    }

    /// What to do about it.
    pub fn hint(&self) -> Option<String> {
        let hint = match &self.problem {
            StackProblem::NotAxisymmetric(_) => {
                "here x is outwards and z around the axis: let young.x = young.z and poisson.xy/young.x = poisson.yz/young.y, or take an isotropic \
                 layer, or a plane problem: `geometry: PlaneStrain`"
            }
            StackProblem::ComplexRoots(_) => {
                "its shear modulus is too high beside its other moduli: take a lower one, an isotropic layer, or a plane problem: \
                 `geometry: PlaneStrain`"
            }
            StackProblem::Empty => "write the layers from the top down, ending in `HalfPlane(...)` or `Rigid`",
            StackProblem::NoInterface { .. } => "write `Bonded`, `Receding`, `Sliding` or `Spring(...)` between them",
            StackProblem::TwoInterfaces { .. } => "remove one of them, or write the layer between them",
            StackProblem::BeginsWithInterface(_) => "the punch acts on the first layer without an interface",
            StackProblem::EndsWithInterface(_) => "end the stack with `HalfPlane(...)` or `Rigid`",
            StackProblem::NoBase(_) => "add an interface and `HalfPlane(...)` or `Rigid` below it",
            StackProblem::BaseNotLast(_) => "end the stack here, or put a layer with a thickness in its place",
            StackProblem::NothingElastic => "write a layer with a thickness above `Rigid`, or use `HalfPlane(...)`",
            StackProblem::TooManyLayers(_) => "a layer that is graded through its thickness replaces many slices",
            StackProblem::TooManyReceding(_) => "bond the interfaces that do not open under the load",
            StackProblem::Contrast { .. } => {
                "what is so much stiffer than all else is rigid, and what is so much softer carries nothing: leave it out, or \
                 write `Rigid` in its place; a large `beta` times the thickness has the same effect"
            }
            StackProblem::NotBonded(_) => {
                "the pressure on springs alone would be stiffness times displacement, place by place, and not end like that \
                 on an elastic body: put a thin layer between, `Bonded` to the springs"
            }
            StackProblem::LooseSprings(_) => {
                "give the layer a thickness, or write `Bonded` or `Sliding` in place of `Spring(...)`: springs under a loose \
                 face, or under the punch itself, would give way like no elastic body"
            }
            StackProblem::SameName { .. } => "give each layer a name of its own, or none",
            StackProblem::TwoGaps => "write one gap, the sum of both",
            StackProblem::GapUnderWeight { .. } => {
                "write `Parabola`, which weight presses flat, or `Dent`, or leave out the gap, the weights and `pressure_on_top`"
            }
            StackProblem::PressureOnTop(_) | StackProblem::Weight { .. } => {
                "a stack lies on its base: what hangs is not solved for"
            }
            StackProblem::Bent { is_unknown: true, .. } => "write `Parabola`, `RoundedFlat` or `Table` in its place",
            StackProblem::Bent { .. } => {
                "nothing presses the layers together far away: bond them, or give them other eigenstrains"
            }
            StackProblem::RoughFace { .. } => {
                "give the material a finite slope at the face, e.g. by a table of values or by a thin layer of one material \
                 bonded to the face; inside a body, away from contacts, any variation is allowed"
            }
            StackProblem::LooseCover(_) => "write `Bonded`, `Sliding` or `Spring(...)` between its layers",
            StackProblem::OtherGeometry => "build both for the same geometry",
            StackProblem::OfSecond(problem) => return Self::whole((**problem).clone()).hint(),
            StackProblem::Thickness { .. } | StackProblem::TooThick => return None,
        };
        Some(hint.to_owned())
    }
}

/// What is wrong with a stack. Layers are named like `layer 1 (Homogeneous)` or `layer 1 "coating" (Homogeneous)`.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StackProblem {
    /// No items at all.
    #[error("the stack is empty")]
    Empty,
    /// Layers that eigenstrains bend so that the gap falls away without end, or that has a shape which cannot be bent.
    #[error(
        "eigenstrains bend the layers at the contact {interface} by {curvature:e} against each other, {}",
        if *is_unknown { "and the gap there is a circle or has sharp corners" } else { "so that their edges fall away without end" }
    )]
    Bent {
        /// The contact.
        interface: Interface,
        /// By how much the slope of the gap grows with x, in 1/length.
        curvature: f64,
        /// Whether the shape of the gap cannot be bent.
        is_unknown: bool,
    },
    /// A gap that is neither a parabola nor, in the plane, a dent between layers that are pressed together far away.
    #[error(
        "weight presses the layers at the contact {interface} together, and the gap there is neither a parabola nor, in the plane, a dent"
    )]
    GapUnderWeight {
        /// The contact.
        interface: Interface,
    },
    /// A pressure on top that pulls.
    #[error("the pressure on top is {0:?}; allowed is a finite number >= 0")]
    PressureOnTop(f64),
    /// A layer with a weight that pulls.
    #[error("the specific weight of {layer} is {found:?}; allowed is a finite number >= 0")]
    Weight {
        /// The layer.
        layer: String,
        /// Its specific weight.
        found: f64,
    },
    /// Two layers of one name.
    #[error("{second} has the name of {first}")]
    SameName {
        /// The upper layer.
        first: String,
        /// The lower layer.
        second: String,
    },
    /// Two gaps with nothing but layers of thickness zero between.
    #[error("there are two gaps with no layer between them")]
    TwoGaps,
    /// A problem of the body that presses on top.
    #[error("the body that presses on top: {0}")]
    OfSecond(Box<StackProblem>),
    /// Layers of the body that presses on top lie loose on each other.
    #[error("its layers are loose at the interface {0}, and only the layers below it may be")]
    LooseCover(Interface),
    /// The body that presses on top was made for another geometry.
    #[error("it belongs to another geometry")]
    OtherGeometry,
    /// Two layers follow each other.
    #[error("no interface between {above} and {below}")]
    NoInterface {
        /// The upper layer.
        above: String,
        /// The lower layer.
        below: String,
    },
    /// Two interfaces follow each other.
    #[error("two interfaces in a row: `{second}` follows `{first}`")]
    TwoInterfaces {
        /// The upper interface.
        first: &'static str,
        /// The lower interface.
        second: &'static str,
    },
    /// The first item is an interface, of this name.
    #[error("the stack begins with the interface `{0}`; allowed is a layer")]
    BeginsWithInterface(&'static str),
    /// The last item is an interface, of this name.
    #[error("the stack ends with the interface `{0}`: nothing lies below it")]
    EndsWithInterface(&'static str),
    /// The last item is this layer, which is neither a half-plane nor rigid.
    #[error(
        "the stack ends with {0}, which is no base; allowed are `Rigid` and layers without a thickness, such as `HalfPlane`"
    )]
    NoBase(String),
    /// This base, a half-plane or a rigid body, has something below it.
    #[error("{0} is not at the bottom of the stack")]
    BaseNotLast(String),
    /// This layer of an axisymmetric problem is not as stiff along x as along z.
    #[error("{0} is not the same in all directions about the axis, and cannot be part of an axisymmetric stack")]
    NotAxisymmetric(String),
    /// This layer of an axisymmetric problem is so stiff against shear that its roots are complex.
    #[error("{0} has complex roots, and cannot be part of an axisymmetric stack")]
    ComplexRoots(String),
    /// No layer between the punch and the rigid base can deform.
    #[error("nothing can deform between the punch and the rigid base")]
    NothingElastic,
    /// No layer is bonded to this support, which is no elastic body.
    #[error("nothing is bonded to {0}")]
    NotBonded(String),
    /// Springs have this layer of thickness 0, which is dropped, on one side.
    #[error("next to {0}, which is not there, springs have nothing to hold")]
    LooseSprings(String),
    /// A thickness that is negative or not finite, reported by a user-defined layer type.
    #[error("{layer} has thickness {found:?}; allowed is a finite number >= 0")]
    Thickness {
        /// The layer.
        layer: String,
        /// Its thickness, in length.
        found: f64,
    },
    /// A material without a slope at a face on which pressures act.
    #[error(
        "the material of {layer} varies next to its {face} face like the distance from it to the power {exponent:.2}; allowed \
         next to a contact are powers >= 1, which have a slope there"
    )]
    RoughFace {
        /// The layer.
        layer: String,
        /// `top` or `bottom`.
        face: &'static str,
        /// The power; 0 at a jump.
        exponent: f64,
    },
    /// All thicknesses together are not finite.
    #[error("the layers together are thicker than the largest number, about 1.8e308")]
    TooThick,
    /// Moduli that differ by more than the moduli of any two materials do.
    #[error("{stiff} is {ratio:.1e} times as stiff as {soft}; allowed is a ratio of at most {MAX_CONTRAST:e}")]
    Contrast {
        /// The stiffest layer or the punch.
        stiff: String,
        /// The softest layer or the punch.
        soft: String,
        /// The ratio of their moduli.
        ratio: f64,
    },
    /// The number of layers with a thickness above 0 is more than can be solved for in a reasonable time.
    #[error("the stack has {0} layers; allowed are at most {MAX_LAYERS}")]
    TooManyLayers(usize),
    /// So many receding interfaces cannot be solved for in a reasonable time and memory.
    #[error("the stack has {0} receding interfaces; allowed are at most {MAX_RECEDING}")]
    TooManyReceding(usize),
}
