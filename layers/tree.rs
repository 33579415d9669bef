//! A text as a tree of values, each with its place in the text: what scenes, layers and sweeps are read from.
mod json;
mod reader;
mod typed;

use std::fmt;
use std::ops::Range;

pub use reader::{bare_token, first_name, token};

/// A value as it was written.
///
/// ```
/// use recede_layers::tree::{Kind, Node};
/// let node = Node::from_ron("Homogeneous(thickness: 1.5, poisson: 0.25)")?;
/// let thickness = node.field("thickness").ok_or("no thickness")?;
/// assert_eq!((node.name.as_deref(), &thickness.kind), (Some("Homogeneous"), &Kind::Number(1.5)));
/// assert_eq!(thickness.place, 23..26);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Node {
    /// Bytes of the text, from its name on if it has one.
    pub place: Range<usize>,
    /// The name with which it begins, such as `Homogeneous` or `Receding`.
    pub name: Option<Box<str>>,
    /// Where begins what follows the name; the end of a name alone.
    pub inner: usize,
    /// What follows the name, or the value itself without one.
    pub kind: Kind,
}

/// What a value is.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Kind {
    /// Nothing, behind a name; without one, characters that are no value.
    #[default]
    Nothing,
    /// A number.
    Number(f64),
    /// A text in quotes.
    Text(String),
    /// Values in brackets.
    List(Vec<Node>),
    /// Values in parentheses.
    Row(Vec<Node>),
    /// Values with names, in parentheses.
    Fields(Vec<Entry>),
}

/// A field with its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Its name.
    pub name: Box<str>,
    /// Where the name stands.
    pub at: usize,
    /// Its value.
    pub value: Node,
}

impl Node {
    /// A value without a name.
    pub fn new(place: Range<usize>, kind: Kind) -> Self {
        Self { inner: place.start, place, name: None, kind }
    }

    /// The fields; none if it has no fields.
    pub fn fields(&self) -> &[Entry] {
        if let Kind::Fields(fields) = &self.kind { fields } else { &[] }
    }

    /// The value of a field, the first of that name.
    pub fn field(&self, name: &str) -> Option<&Self> {
        self.fields().iter().find(|field| &*field.name == name).map(|field| &field.value)
    }

    /// The values in it.
    pub fn values_mut(&mut self) -> Vec<&mut Self> {
        match &mut self.kind {
            Kind::List(members) | Kind::Row(members) => members.iter_mut().collect(),
            Kind::Fields(fields) => fields.iter_mut().map(|field| &mut field.value).collect(),
            Kind::Nothing | Kind::Number(_) | Kind::Text(_) => Vec::new(),
        }
    }

    /// Values in brackets or parentheses.
    pub fn members(&self) -> &[Self] {
        if let Kind::List(members) | Kind::Row(members) = &self.kind { members } else { &[] }
    }
}

/// What is expected where something else was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A number.
    Number,
    /// A text in double quotes.
    Text,
    /// A list in brackets.
    List,
    /// A name.
    Name,
    /// `(`, before fields or the members of a row.
    Open,
    /// `)`, behind the members of a row.
    Close,
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Number => "a number",
            Self::Text => "a text in double quotes",
            Self::List => "a list in `[` and `]`",
            Self::Name => "a name",
            Self::Open => "`(`",
            Self::Close => "`)`",
        })
    }
}

/// What is wrong at some place of a text.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Fault {
    /// The text is none in its notation.
    #[error("{message}")]
    Syntax {
        /// What was found.
        message: String,
        /// What to do.
        hint: Option<String>,
    },
    /// Something behind the end of the text's value.
    #[error("something follows the end")]
    Follows,
    /// Something else is expected.
    #[error("{0} is expected")]
    Expected(Form),
    /// Something behind a name that stands alone.
    #[error("something follows a name that stands alone")]
    NotAlone,
    /// The type that is read gives another name to its values.
    #[error("found `{found}`, the name is `{expected}`")]
    OtherName {
        /// The name that it gives.
        expected: &'static str,
        /// The name that was found.
        found: String,
    },
    /// A name that is none of a few.
    #[error("found `{found}`, allowed are {allowed:?}")]
    UnknownName {
        /// The name that was found.
        found: String,
        /// The names that are allowed.
        allowed: &'static [&'static str],
    },
    /// A field that there is not.
    #[error("no field is called `{found}`, allowed are {allowed:?}")]
    UnknownField {
        /// The name that was found.
        found: String,
        /// The names that are allowed.
        allowed: Vec<&'static str>,
    },
    /// A field that has to be there.
    #[error("`{0}` is missing")]
    Missing(&'static str),
    /// A field that stands twice.
    #[error("`{0}` stands twice")]
    Twice(&'static str),
    /// What the type that is read says.
    #[error("{0}")]
    Reason(String),
}

/// Why a text could not be read, where in the text, and at which field of it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{fault}")]
pub struct ReadError {
    /// The field being read, e.g. `poisson` or `units.length`; `None` outside any field.
    pub field: Option<String>,
    /// The byte of the text; `None` before it is known.
    pub at: Option<usize>,
    /// What is wrong.
    pub fault: Fault,
}

impl From<Fault> for ReadError {
    fn from(fault: Fault) -> Self {
        Self { field: None, at: None, fault }
    }
}

impl Fault {
    /// What was found, and what to do, unless that is empty.
    fn syntax(message: impl Into<String>, hint: &str) -> Self {
        Self::Syntax { message: message.into(), hint: (!hint.is_empty()).then(|| hint.to_owned()) }
    }

    /// The error at a byte of the text.
    pub fn at(self, place: usize) -> ReadError {
        ReadError::from(self).at(place)
    }
}

impl ReadError {
    /// The same at a place, unless its place is known.
    fn at(self, place: usize) -> Self {
        Self { at: self.at.or(Some(place)), ..self }
    }

    /// The same in a field.
    fn within(self, field: &str) -> Self {
        let inner = self.field.map_or(String::new(), |inner| format!(".{inner}"));
        Self { field: Some(format!("{field}{inner}")), ..self }
    }
}
