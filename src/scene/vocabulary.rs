//! All that may be written in a scene, from the definitions that read it.
use recede_layers::Registry;
use recede_layers::description::{Field, Form, Value};

use super::read::Draft;
use super::round::{RoundLoad, RoundPunch};
use super::{Item, Load, Punch};

/// The field that a layer has and a base has not.
const THICKNESS: &str = "thickness";

/// Names that may be written in a scene, with their fields and what they mean. Made of the definitions that read scenes, so
/// that it says what they do.
///
/// ```
/// use recede::{Registry, Vocabulary};
/// let vocabulary = Vocabulary::new(&Registry::default());
/// assert!(vocabulary.layers.iter().any(|layer| layer.name == "Homogeneous"));
/// assert!(vocabulary.interfaces.iter().any(|interface| interface.name == "Sliding"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Vocabulary {
    /// The fields of a scene.
    pub scene: Vec<Field>,
    /// Punches.
    pub punches: Vec<Form>,
    /// Pressures that may be given in place of a punch.
    pub loads: Vec<Form>,
    /// Punches of axisymmetric scenes.
    pub round_punches: Vec<Form>,
    /// Loads of axisymmetric scenes.
    pub round_loads: Vec<Form>,
    /// Layers of finite thickness.
    pub layers: Vec<Form>,
    /// Interfaces between layers.
    pub interfaces: Vec<Form>,
    /// What may stand last in a stack.
    pub bases: Vec<Form>,
}

impl Vocabulary {
    /// The words of scenes with the layers of `registry`. A type without a field `thickness` counts as a base, and of
    /// one that was registered without a [description](Registry::register_described) only the name is known.
    pub fn new(registry: &Registry) -> Self {
        let registered = registry.iter().map(|entry| Form {
            name: entry.name.to_owned(),
            meaning: entry.summary.to_owned(),
            value: entry.describe(),
        });
        let is_base = |form: &Form| match &form.value {
            Some(Value::Fields(fields)) => fields.iter().all(|field| field.name != THICKNESS),
            _ => false,
        };
        let (mut bases, layers): (Vec<Form>, Vec<Form>) = registered.partition(is_base);
        let mut interfaces = Item::forms();
        // the last is the rigid base
        bases.extend(interfaces.pop());
        Self {
            scene: if let Value::Fields(fields) = Value::of::<Draft>() { fields } else { Vec::new() },
            punches: alternatives(Value::of::<Punch>()),
            loads: alternatives(Value::of::<Load>()),
            round_punches: alternatives(Value::of::<RoundPunch>()),
            round_loads: alternatives(Value::of::<RoundLoad>()),
            layers,
            interfaces,
            bases,
        }
    }
}

/// What stands in place of a value of several forms.
fn alternatives(value: Value) -> Vec<Form> {
    if let Value::OneOf(forms) = value { forms } else { Vec::new() }
}
