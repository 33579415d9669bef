//! From a text as written to one that is read: JSON becomes RON, and numbers with a unit become numbers in the units of the
//! scene. Every place in the text that is read is known in the one that was written.
use std::ops::Range;

use recede_layers::read_ron;
use serde::de::IgnoredAny;

use super::explain::too_deep;
use super::text::{field, fields, members, part, without_comments};
use super::units::{Dimension, Units, converted, has_unit};

/// A text that was made of another one, and where its parts stood there.
#[derive(Clone, Debug, Default)]
pub(super) struct Translation {
    pub(super) text: String,
    marks: Vec<Mark>,
}

/// A part of the new text, and of the old one.
#[derive(Clone, Copy, Debug)]
struct Mark {
    new: usize,
    old: usize,
    /// Bytes of the old part.
    length: usize,
}

/// What cannot be translated: where, what, and what to do.
#[derive(Debug)]
pub(super) struct Untranslatable {
    pub(super) at: usize,
    pub(super) message: String,
    pub(super) hint: Option<String>,
}

impl Translation {
    /// Adds a part of the old text, as it is now written.
    fn add(&mut self, written: &str, old: Range<usize>) {
        self.marks.push(Mark { new: self.text.len(), old: old.start, length: old.len() });
        self.text += written;
    }

    /// Takes back what was added from a place in the new text on.
    fn truncate(&mut self, at: usize) {
        self.text.truncate(at);
        self.marks.truncate(self.marks.partition_point(|mark| mark.new < at));
    }

    /// Where a place in the new text was in the old one.
    pub(super) fn place(&self, at: usize) -> usize {
        let next = self.marks.partition_point(|mark| mark.new <= at);
        match next.checked_sub(1).and_then(|last| self.marks.get(last)) {
            Some(mark) => mark.old + (at - mark.new).min(mark.length),
            None => at,
        }
    }
}

/// A text in which numbers with a unit have become numbers; `None` if there are none.
pub(super) fn without_units(text: &str) -> Result<Option<Translation>, Untranslatable> {
    if !text.contains('"') {
        return Ok(None);
    }
    let labels = ["name", "description", "units"].map(|name| field(text, name).unwrap_or_default());
    let quotes = |text: &str| text.matches('"').count();
    if quotes(text) <= labels.map(quotes).iter().sum() {
        return Ok(None);
    }
    let units: Option<Units> = Some(labels[2]).filter(|units| !units.is_empty()).and_then(|text| read_ron(text).ok());
    let is_round = field(text, "geometry").is_some_and(|geometry| geometry.trim() == "Axisymmetric");
    let mut found = Vec::new();
    for (name, value) in fields(text) {
        if !matches!(&name[..], "name" | "description" | "units") {
            // the numbers of a punch that say nothing else, those of its table, are lengths
            let own = if name == "force" && is_round { Some(Dimension::FORCE) } else { Dimension::of_field(&name) };
            let dimension = own.or((name == "punch").then_some(Dimension::LENGTH));
            numbers_with_units(value, dimension, &mut found);
        }
    }
    if found.is_empty() {
        return Ok(None);
    }
    let mut translation = Translation::default();
    let mut at = 0;
    for (value, dimension) in found {
        let start = part(text, value).offset;
        // a text in quotes has one at either end
        let inner = value.trim_end().trim_matches('"');
        let number = converted(inner, dimension, units.as_ref()).map_err(|(message, hint)| Untranslatable {
            at: start,
            message,
            hint: Some(hint),
        })?;
        translation.add(&text[at..start], at..start);
        at = start + value.trim_end().len();
        translation.add(&number, start..at);
    }
    translation.add(&text[at..], at..text.len());
    Ok(Some(translation))
}

/// Texts in double quotes within a value, with what they are to be measured in.
fn numbers_with_units<'a>(value: &'a str, dimension: Option<Dimension>, found: &mut Vec<(&'a str, Option<Dimension>)>) {
    let value = without_comments(value);
    if let Some(text) = value.strip_prefix('"') {
        if has_unit(text.trim_end().trim_end_matches('"')) {
            found.push((value, dimension));
        }
        return;
    }
    let fields = fields(value);
    for (name, inner) in &fields {
        numbers_with_units(inner, Dimension::of_field(name).or(dimension), found);
    }
    if fields.is_empty() {
        let row = value.starts_with('(');
        for (index, inner) in members(value).into_iter().enumerate() {
            // of the rows of a table, the first number is a place
            let dimension = if row && index == 0 { Some(Dimension::LENGTH) } else { dimension };
            numbers_with_units(inner, dimension, found);
        }
    }
}

/// Whether a text is JSON: a scene in RON begins with its name or a parenthesis.
pub(super) fn is_json(text: &str) -> bool {
    text.trim_start().starts_with('{')
}

/// A text in JSON as RON, with the same lines. An object whose only key begins with a capital letter is the name of a punch, a
/// layer or the like with what follows it, a text that begins with one such a name alone; any other object holds fields.
pub(super) fn from_json(text: &str) -> Result<Translation, Untranslatable> {
    if let Err(error) = serde_json::from_str::<IgnoredAny>(text) {
        let lines: usize = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
        let at = (lines + error.column().saturating_sub(1)).min(text.len());
        let at = (0..=at).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
        let message = error.to_string();
        let message = message.split(" at line ").next().unwrap_or(&message).to_owned();
        let hint = Some("the text begins with `{`, and is read as JSON".to_owned());
        return Err(Untranslatable { at, message, hint });
    }
    let mut reader = Json { text, at: 0, depth: 0, made: Translation::default() };
    reader.value(&Context::default())?;
    reader.space();
    Ok(reader.made)
}

/// A reader of a text that is known to be JSON.
struct Json<'a> {
    text: &'a str,
    at: usize,
    /// In how many lists and objects the next value stands.
    depth: usize,
    made: Translation,
}

/// Brackets within brackets that are read, as many as the reader of RON reads.
const DEEPEST: usize = 128;

/// Where a value stands.
#[derive(Clone, Copy, Default)]
struct Context {
    /// In a list: a list there is a row.
    in_list: bool,
    /// A text there stands for itself.
    label: bool,
    /// Right behind a name and its parenthesis.
    named: bool,
}

impl Json<'_> {
    fn next(&self) -> u8 {
        self.text.as_bytes().get(self.at).copied().unwrap_or_default()
    }

    /// Keeps white space.
    fn space(&mut self) {
        let rest = &self.text[self.at..];
        let length = rest.len() - rest.trim_start().len();
        self.made.add(&rest[..length], self.at..self.at + length);
        self.at += length;
    }

    /// One character as another.
    fn sign(&mut self, written: &str) {
        self.made.add(written, self.at..self.at + 1);
        self.at += 1;
    }

    /// The text in quotes that comes next, which is then behind.
    fn string(&mut self) -> (String, Range<usize>) {
        let start = self.at;
        let bytes = self.text.as_bytes();
        self.at += 1;
        while self.at < bytes.len() && bytes[self.at] != b'"' {
            self.at += if bytes[self.at] == b'\\' { 2 } else { 1 };
        }
        self.at = (self.at + 1).min(bytes.len());
        (serde_json::from_str(&self.text[start..self.at]).unwrap_or_default(), start..self.at)
    }

    fn value(&mut self, context: &Context) -> Result<(), Untranslatable> {
        self.space();
        if self.depth > DEEPEST {
            let (message, hint) = too_deep();
            return Err(Untranslatable { at: self.at, message, hint: Some(hint) });
        }
        self.depth += 1;
        let read = self.value_at(context);
        self.depth -= 1;
        read
    }

    fn value_at(&mut self, context: &Context) -> Result<(), Untranslatable> {
        match self.next() {
            b'{' => self.object(context),
            b'[' => self.list(context),
            b'"' => {
                let (text, place) = self.string();
                let written = if !context.label && is_name(&text) { text } else { super::write::quoted(&text) };
                self.made.add(&written, place);
                Ok(())
            }
            _ => {
                let rest = &self.text[self.at..];
                let length = rest.find([',', ']', '}', ' ', '\n', '\r', '\t']).unwrap_or(rest.len());
                let place = self.at..self.at + length;
                self.made.add(if &rest[..length] == "null" { "None" } else { &rest[..length] }, place);
                self.at += length;
                Ok(())
            }
        }
    }

    /// Values in brackets, or in parentheses.
    fn list(&mut self, context: &Context) -> Result<(), Untranslatable> {
        let row = context.in_list;
        self.sign(if row { "(" } else { "[" });
        self.space();
        while self.next() != b']' {
            self.value(&Context { in_list: !row, ..Context::default() })?;
            self.space();
            if self.next() == b',' {
                self.sign(",");
                self.space();
            }
        }
        self.sign(if row { ")" } else { "]" });
        Ok(())
    }

    fn object(&mut self, context: &Context) -> Result<(), Untranslatable> {
        let start = self.at;
        self.at += 1;
        let before = self.made.text.len();
        self.space();
        if self.next() == b'"' {
            let (name, place) = self.string();
            if is_name(&name) {
                return self.named(&name, place);
            }
            self.at = place.start;
        }
        // the fields of a name stand in its own parentheses
        self.made.truncate(before);
        self.at = start;
        self.fields(context.named)
    }

    /// `{"Name": value}` as `Name(value)`.
    fn named(&mut self, name: &str, place: Range<usize>) -> Result<(), Untranslatable> {
        self.made.add(name, place.clone());
        self.space();
        self.at += 1;
        self.space();
        if self.text[self.at..].starts_with("null") {
            self.at += 4;
        } else {
            let at = self.at;
            self.made.add("(", at..at);
            self.value(&Context { named: true, ..Context::default() })?;
            self.made.add(")", self.at..self.at);
        }
        self.space();
        if self.next() != b'}' {
            let message = format!("`{name}` is followed by a second key");
            let hint =
                Some(format!("what belongs to `{name}` stands in an object of its own: `{{\"{name}\": {{...}}}}`"));
            return Err(Untranslatable { at: self.at, message, hint });
        }
        self.at += 1;
        Ok(())
    }

    /// Passes over a value, its colon and the comma behind it.
    fn left_out(&mut self) -> Result<(), Untranslatable> {
        let before = self.made.text.len();
        self.space();
        self.sign(":");
        self.value(&Context { label: true, ..Context::default() })?;
        self.space();
        if self.next() == b',' {
            self.sign(",");
        }
        self.made.truncate(before);
        self.space();
        Ok(())
    }

    /// `{"name": value, ...}` as `(name: value, ...)`, without the parentheses if they are there.
    fn fields(&mut self, bare: bool) -> Result<(), Untranslatable> {
        self.sign(if bare { "" } else { "(" });
        self.space();
        while self.next() == b'"' {
            let (name, place) = self.string();
            if name == SCHEMA {
                self.left_out()?;
                continue;
            }
            if !is_word(&name) {
                let message = format!("`{}` is no name of a field", name.chars().take(40).collect::<String>());
                let hint = Some("names of fields are those of a scene in RON, such as `shear_modulus`".to_owned());
                return Err(Untranslatable { at: place.start, message, hint });
            }
            self.made.add(&name, place);
            self.space();
            self.sign(":");
            // the units are called by texts, which may be capital letters
            let label = matches!(&name[..], "name" | "description" | "length" | "force");
            self.value(&Context { label, ..Context::default() })?;
            self.space();
            if self.next() == b',' {
                self.sign(",");
                self.space();
            }
        }
        self.sign(if bare { "" } else { ")" });
        Ok(())
    }
}

/// The key under which a text in JSON may say, for editors, by which schema it is written.
const SCHEMA: &str = "$schema";

/// Letters, digits and underscores, a letter first.
fn is_word(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic()) && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// A word with a capital letter.
fn is_name(text: &str) -> bool {
    is_word(text) && text.starts_with(|c: char| c.is_ascii_uppercase())
}
