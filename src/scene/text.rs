//! Values of a scene as texts in one line.
use std::fmt::{self, Write};

use serde::Serialize;

/// Writes a punch or a load as it stands in a scene, in one line.
pub(super) fn written(value: &impl Serialize, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    use ron::extensions::Extensions;
    let style = ron::ser::PrettyConfig::new()
        .compact_structs(true)
        .compact_arrays(true)
        .extensions(Extensions::UNWRAP_VARIANT_NEWTYPES | Extensions::IMPLICIT_SOME);
    let text = ron::ser::to_string_pretty(value, style).map_err(|_| fmt::Error)?;
    // extensions are announced in a first line
    f.write_str(text.rsplit('\n').next().unwrap_or(&text))
}

/// What is written in one line.
pub(super) struct Written<T>(pub(super) T);

impl<T: Serialize> fmt::Display for Written<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        written(&self.0, f)
    }
}

/// A text in double quotes, whatever it contains.
pub(super) fn quoted(text: &str) -> String {
    let mut quoted = "\"".to_owned();
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            '\n' => quoted += "\\n",
            c if c.is_control() => {
                let _ = write!(quoted, "\\u{{{:x}}}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted + "\""
}
