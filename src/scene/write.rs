//! A scene as text, to be read again.
use std::fmt::Write;

use super::Scene;
use super::text::quoted;

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
                field(self.force.field(), format!("{:?}", self.force.number()));
            }
        }
        text += "    stack: [\n";
        for item in &self.stack {
            let parameters = item.parameters().map_or(String::new(), |parameters| format!("({parameters})"));
            let _ = writeln!(text, "        {}{parameters},", item.name());
        }
        text + "    ],\n)\n"
    }
}
