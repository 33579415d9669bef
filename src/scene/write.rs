//! A scene as text, to be read again.
use std::fmt::Write;

use recede_layers::tree::{Kind, Node};
use serde_json::{Value, json};

use super::Scene;
use super::text::{quoted, visible_json};

impl Scene {
    /// The scene in RON, with all digits: [`Scene::from_ron`] reads the same scene from it.
    ///
    /// A layer is written as its [`notation`](crate::Layer::notation) says, so a user-defined layer type is read again
    /// if its notation names the fields that it is read from, as the notation of the layers that ship does.
    ///
    /// ```
    /// use recede::{HalfPlane, Item, Plane, Punch, Scene};
    /// let ground = Item::layer(HalfPlane::new(1.0, 0.25)?);
    /// let scene = Scene::new(Plane::Strain, Punch::parabola(500.0)?, 0.002, vec![ground]);
    /// let text = scene.to_ron();
    /// assert!(text.contains("        HalfPlane(shear_modulus: 1.0, poisson: 0.25),\n"));
    /// assert_eq!(Scene::from_ron(&text)?.to_ron(), text);
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn to_ron(&self) -> String {
        let mut text = "Scene(\n".to_owned();
        let mut field = |name: &str, value: String| {
            // a String takes whatever is written to it
            let _ = writeln!(text, "    {name}: {value},");
        };
        for (name, text) in [("name", &self.name), ("description", &self.description)] {
            text.iter().for_each(|text| field(name, quoted(text)));
        }
        if let Some(units) = &self.units {
            field("units", format!("(length: {}, force: {})", quoted(&units.length), quoted(&units.force)));
        }
        field("geometry", self.geometry.name().to_owned());
        match self.force.given().and_then(|force| self.top.written_with(force)) {
            Some(list) => field(self.top.field(), list),
            None => {
                field(self.top.field(), self.top.written_in(self.geometry));
                self.force.number().iter().for_each(|number| field(self.force.field(), format!("{number:?}")));
            }
        }
        if self.pressure_on_top != 0.0 {
            let _ = writeln!(text, "    pressure_on_top: {:?},", self.pressure_on_top);
        }
        text += "    stack: [\n";
        for item in &self.stack {
            let _ = writeln!(text, "        {},", item.written(self.geometry));
        }
        text + "    ],\n)\n"
    }

    /// The scene in JSON, with the same names as in RON and with all digits: [`Scene::from_json`] reads the same scene from
    /// it. `Homogeneous(thickness: 1.0, ...)` is `{"Homogeneous": {"thickness": 1.0, ...}}`, `Receding` is `"Receding"`.
    ///
    /// ```
    /// use recede::Scene;
    /// let scene = Scene::read("examples/scenes/two_strips.ron")?;
    /// let again = Scene::from_json(&scene.to_json())?;
    /// assert_eq!(again.to_ron(), scene.to_ron());
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn to_json(&self) -> String {
        // the name of a scene is not needed, as there is nothing else
        let scene =
            Node::from_ron(self.to_ron().trim_start_matches("Scene")).map_or(Value::Null, |scene| value(&scene));
        visible_json(&format!("{scene:#}\n"))
    }
}

/// A value as JSON.
fn value(node: &Node) -> Value {
    let inner = match &node.kind {
        Kind::Nothing => Value::Null,
        Kind::Number(number) => json!(number),
        Kind::Text(text) => json!(text),
        Kind::Row(members) if node.name.is_some() && members.len() == 1 => value(&members[0]),
        Kind::List(members) | Kind::Row(members) => members.iter().map(value).collect(),
        Kind::Fields(fields) => fields.iter().map(|field| (field.name.to_string(), value(&field.value))).collect(),
    };
    match (node.name.as_deref(), &node.kind) {
        (None, _) => inner,
        (Some(name @ ("true" | "false")), Kind::Nothing) => Value::Bool(name == "true"),
        (Some(name), Kind::Nothing) => Value::String(name.to_owned()),
        (Some(name), _) => json!({name: inner}),
    }
}
