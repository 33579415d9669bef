//! Texts from others, as they may be shown.
use std::borrow::Cow;
use std::fmt::Write;

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
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            c if !c.is_control() => shown.push(c),
            c if c.is_whitespace() => shown.push(' '),
            c => shown.extend(c.escape_unicode()),
        }
    }
    shown.into()
}

/// A text in JSON in which the control characters that JSON itself allows are written in its way, too.
pub(crate) fn visible_json(json: &str) -> String {
    let mut shown = String::with_capacity(json.len());
    for c in json.chars() {
        if c.is_control() && c != '\n' {
            // a String takes whatever is written to it
            let _ = write!(shown, "\\u{:04x}", u32::from(c));
        } else {
            shown.push(c);
        }
    }
    shown
}
