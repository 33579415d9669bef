//! Values of a scene as texts in one line.
use ron::extensions::Extensions;
use ron::ser::PrettyConfig;
use serde::Serialize;

/// A punch, a load or a list of them as it stands in a scene, in one line.
pub(super) fn written(value: &impl Serialize) -> String {
    let style = PrettyConfig::new()
        .compact_structs(true)
        .compact_arrays(true)
        .extensions(Extensions::UNWRAP_VARIANT_NEWTYPES | Extensions::IMPLICIT_SOME);
    // a String takes whatever is written to it
    let text = ron::ser::to_string_pretty(value, style).unwrap_or_default();
    // extensions are announced in a first line
    text.rsplit('\n').next().unwrap_or_default().to_owned()
}

/// A text in double quotes, whatever it contains.
pub(super) fn quoted(text: &str) -> String {
    let escaped = |c: char| match c {
        '"' | '\\' | '\n' => c.escape_default().to_string(),
        c if c.is_control() => c.escape_unicode().to_string(),
        c => c.into(),
    };
    format!("\"{}\"", text.chars().map(escaped).collect::<String>())
}
