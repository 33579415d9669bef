//! Everything that can go wrong, put together from the errors of the stages. No stage below the model imports it.
use recede_layers::LayerError;

use crate::approach::ApproachError;
use crate::axis::AxisError;
use crate::contact::{ContactError, NoSolution};
use crate::field::FieldError;
use crate::options::OptionsError;
use crate::scene::{Owner, Scene, SceneError, ValueError};
use crate::stack::StackError;
use crate::system::Unresolved;

/// Why a scene could not be read or solved.
#[derive(Clone, Debug, thiserror::Error)]
pub enum Error {
    /// The text of a scene is wrong at some place.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A punch, a load, a force or a spring cannot be made of these numbers.
    #[error(transparent)]
    Value(#[from] ValueError),
    /// A layer cannot be made of these numbers.
    #[error(transparent)]
    Layer(#[from] LayerError),
    /// The items of a stack do not fit together.
    #[error(transparent)]
    Stack(#[from] StackError),
    /// Something is no axis of a sweep.
    #[error(transparent)]
    Axis(#[from] AxisError),
    /// What was asked of a solution cannot be fulfilled.
    #[error(transparent)]
    Options(#[from] OptionsError),
    /// The layers' fields cannot be computed.
    #[error(transparent)]
    Unresolved(#[from] Unresolved),
    /// The scene is well posed, but no admissible contact was found.
    #[error(transparent)]
    NoSolution(#[from] NoSolution),
    /// The contact problem was not solved for another reason.
    #[error(transparent)]
    Contact(ContactError),
    /// No approach of the punch is defined.
    #[error(transparent)]
    Approach(ApproachError),
    /// Stresses and displacements cannot be told.
    #[error(transparent)]
    Field(FieldError),
}

impl From<ContactError> for Error {
    fn from(error: ContactError) -> Self {
        match error {
            ContactError::Unresolved(cause) => Self::Unresolved(cause),
            ContactError::NoSolution(cause) => Self::NoSolution(cause),
            other => Self::Contact(other),
        }
    }
}

impl From<FieldError> for Error {
    fn from(error: FieldError) -> Self {
        match error {
            FieldError::Unresolved(cause) => Self::Unresolved(cause),
            other => Self::Field(other),
        }
    }
}

impl From<ApproachError> for Error {
    fn from(error: ApproachError) -> Self {
        match error {
            ApproachError::Field(cause) => cause.into(),
            other => Self::Approach(other),
        }
    }
}

impl Error {
    /// Whether the input is at fault, rather than the solver unable to find an admissible solution.
    ///
    /// ```
    /// let error = recede::Error::from(recede::Punch::cylinder(-1.0).unwrap_err());
    /// assert!(error.is_input());
    /// ```
    pub fn is_input(&self) -> bool {
        match self {
            Self::Scene(_)
            | Self::Value(_)
            | Self::Layer(_)
            | Self::Stack(_)
            | Self::Axis(_)
            | Self::Options(_)
            | Self::Approach(_) => true,
            Self::Unresolved(_) => false,
            Self::NoSolution(cause) => cause.is_input(),
            Self::Contact(cause) => cause.is_input(),
            Self::Field(cause) => cause.is_input(),
        }
    }

    /// What to do about it, if that can be said.
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::Scene(error) => error.hint().map(str::to_owned),
            Self::Stack(error) => error.hint(),
            Self::Unresolved(error) => Some(error.hint()),
            Self::NoSolution(error) => error.hint(),
            Self::Contact(error) => error.hint(),
            Self::Field(error) => error.hint(),
            Self::Approach(error) => Some(error.hint()),
            Self::Value(_) | Self::Layer(_) | Self::Axis(_) | Self::Options(_) => None,
        }
    }
}

impl Scene {
    /// Adds to an error the place in the scene's text that it is about: the stack's offending item, or the punch
    /// where it cannot carry the force. Other errors, and errors of a scene not read from a text, are left as they are.
    pub fn locate(&self, error: Error) -> Error {
        let located = match &error {
            Error::Stack(cause) if cause.is_of_second() => self.error_at(Owner::Top, cause.hint(), cause),
            Error::Stack(cause) => self.error_at(cause.item().map_or(Owner::Stack, Owner::Item), cause.hint(), cause),
            Error::NoSolution(cause @ NoSolution::PunchTooSmall { .. }) => {
                let hint = "a larger punch or a smaller force keeps the contact within the punch";
                self.error_at(Owner::Top, Some(hint.to_owned()), cause)
            }
            Error::NoSolution(cause @ NoSolution::Unreachable { .. }) => {
                self.error_at(Owner::Force, cause.hint(), cause)
            }
            Error::Contact(
                cause @ (ContactError::UnevenPunch
                | ContactError::PunchFalls { .. }
                | ContactError::LoadsUnknown { .. }),
            ) => self.error_at(Owner::Top, Some(cause.hint().unwrap_or_default()), cause),
            Error::Approach(cause) => self.error_at(Owner::Force, Some(cause.hint()), cause),
            _ => None,
        };
        located.map_or(error, Error::Scene)
    }
}
