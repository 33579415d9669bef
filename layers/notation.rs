//! How layers are written in drawings, messages and scene files.
use std::fmt;

/// How a layer is written in drawings, messages and scene files.
///
/// ```
/// use recede_layers::{Homogeneous, Layer, Notation};
/// let notation = Notation::of::<Homogeneous>().with("thickness", &1.0).with("shear_modulus", &2.5);
/// assert_eq!(notation.to_string(), "Homogeneous(thickness: 1.0, shear_modulus: 2.5)");
/// assert_eq!(Homogeneous::new(1.0, 2.5, 0.25)?.notation(), notation.with("poisson", &0.25));
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notation {
    /// Name of the layer type, e.g. `Homogeneous`.
    pub kind: &'static str,
    /// The parameters with their values, as in the scene file, e.g. `thickness: 1.0, shear_modulus: 1.0, poisson: 0.25`.
    pub parameters: String,
}

/// The value of a field of a layer, as it is written in a scene file.
pub trait Parameter {
    /// The text, from which the same value is read.
    fn written(&self) -> String;
}

impl Parameter for f64 {
    fn written(&self) -> String {
        // the fewest digits that are read as this number, with a point
        format!("{self:?}")
    }
}

impl Notation {
    /// The name of a type without its path, and no parameters yet.
    pub fn of<L: ?Sized>() -> Self {
        let path = std::any::type_name::<L>();
        let path = path.split_once('<').map_or(path, |(path, _)| path);
        Self { kind: path.rsplit("::").next().unwrap_or(path), parameters: String::new() }
    }

    /// The same with one parameter more.
    #[must_use]
    pub fn with(mut self, name: &str, value: &impl Parameter) -> Self {
        if !self.parameters.is_empty() {
            self.parameters += ", ";
        }
        self.parameters += &format!("{name}: {}", value.written());
        self
    }

    /// The same with the name of the layer as the first parameter.
    #[must_use]
    pub fn named(self, name: &impl Parameter) -> Self {
        let own = Self { kind: self.kind, parameters: String::new() }.with("name", name);
        let parts = [own.parameters, self.parameters];
        Self { parameters: parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", "), ..self }
    }
}

impl fmt::Display for Notation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}({})", self.kind, self.parameters)
    }
}
