//! Texts: values of a scene in one line, and texts from others as they may be shown.
use std::borrow::Cow;

use ron::extensions::Extensions;
use ron::ser::PrettyConfig;
use serde::Serialize;

/// A punch, a load or a list of them as it stands in a scene, in one line.
pub(super) fn written(value: &impl Serialize) -> String {
    let style = PrettyConfig::new()
        .compact_structs(true)
        .compact_arrays(true)
        .extensions(Extensions::UNWRAP_NEWTYPES | Extensions::UNWRAP_VARIANT_NEWTYPES | Extensions::IMPLICIT_SOME);
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

/// A text in one line without characters that could disturb a terminal or a picture: white space of any kind is a space, and
/// other control characters are written as in a scene, `\u{1b}`. All that is shown of names, descriptions, labels, and
/// of the names of files goes through this.
///
/// ```
/// use recede::visible;
/// assert_eq!(visible("a \u{1b}[31mred\n name"), "a \\u{1b}[31mred  name");
/// assert_eq!(visible("µm"), "µm");
/// ```
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.contains(char::is_control) {
        return text.into();
    }
    let shown = |c: char| match c {
        c if !c.is_control() => c.into(),
        c if c.is_whitespace() => " ".to_owned(),
        c => c.escape_unicode().to_string(),
    };
    text.chars().map(shown).collect::<String>().into()
}

/// A text in JSON in which the control characters that JSON itself allows are written in its way, too.
pub(crate) fn visible_json(json: &str) -> String {
    let escaped = |c: char| match c {
        c if c.is_control() && c != '\n' => format!("\\u{:04x}", u32::from(c)),
        c => c.into(),
    };
    json.chars().map(escaped).collect()
}
