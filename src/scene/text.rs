//! The parts of a scene's text: names, fields and elements as they are written.
use std::fmt;

use recede_layers::read_ron;
use ron::value::RawValue;
use serde::de::{MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

/// A part of the scene's text that is read on its own, and what it is called.
pub(super) struct Part<'a> {
    pub(super) text: &'a str,
    /// Where it begins in the scene's text.
    pub(super) offset: usize,
    /// Where its name stands in the scene's text.
    pub(super) name_at: usize,
    pub(super) owner: String,
}

/// A part of the scene's text; `within` must be a slice of `text`.
pub(super) fn part<'a>(text: &'a str, within: &'a str) -> Part<'a> {
    let offset = (within.as_ptr() as usize).saturating_sub(text.as_ptr() as usize);
    // comments before the name belong to the part as it was cut out
    let name_at = offset + within.len() - without_comments(within).len();
    Part { text: within, offset, name_at, owner: String::new() }
}

/// The name with which a text begins.
#[cfg(feature = "files")]
pub(crate) fn first_name(text: &str) -> Option<&str> {
    name_and_rest(text).map(|(name, _)| name)
}

/// The name with which a text begins, if it does, and what follows it.
pub(super) fn name_and_rest(text: &str) -> Option<(&str, &str)> {
    struct Name;
    impl<'de> Visitor<'de> for Name {
        type Value = &'de str;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a name")
        }

        fn visit_borrowed_str<E>(self, name: &'de str) -> Result<&'de str, E> {
            Ok(name)
        }
    }
    let mut reader = ron::Deserializer::from_str(text).ok()?;
    let name = reader.deserialize_identifier(Name).ok()?;
    Some((name, reader.remainder()))
}

/// A text without the white space and comments with which it begins.
pub(super) fn without_comments(text: &str) -> &str {
    ron::Deserializer::from_str(text).map_or(text, |reader| reader.remainder())
}

/// The text of one field of a structure.
pub(super) fn field<'a>(text: &'a str, name: &str) -> Option<&'a str> {
    fields(text).into_iter().find(|(found, _)| found == name).map(|(_, value)| value)
}

/// The fields of a structure as written, with or without its name before it.
pub(super) fn fields(text: &str) -> Vec<(String, &str)> {
    let rest = name_and_rest(text).map_or(text, |(_, rest)| rest);
    read_ron::<Fields>(rest).map_or_else(|_| Vec::new(), |Fields(fields)| fields)
}

/// The elements of a list as written, with or without a name and parentheses about it.
pub(super) fn elements(text: &str) -> Vec<&str> {
    let list = match name_and_rest(text) {
        Some((_, rest)) => read_ron::<(Vec<&RawValue>,)>(rest).map(|(list,)| list),
        None => read_ron::<Vec<&RawValue>>(text),
    };
    list.map_or_else(|_| Vec::new(), |list| list.into_iter().map(RawValue::get_ron).collect())
}

/// The values in brackets or parentheses as written, with or without a name before them.
pub(super) fn members(text: &str) -> Vec<&str> {
    let rest = name_and_rest(text).map_or(text, |(_, rest)| rest);
    let list = match without_comments(rest).starts_with('(') {
        true => read_ron::<Members>(rest).map(|Members(members)| members),
        false => read_ron::<Vec<&RawValue>>(rest),
    };
    list.map_or_else(|_| Vec::new(), |list| list.into_iter().map(RawValue::get_ron).collect())
}

/// The values of a tuple, however many there are.
struct Members<'a>(Vec<&'a RawValue>);

impl<'de> Deserialize<'de> for Members<'de> {
    fn deserialize<D: Deserializer<'de>>(reader: D) -> Result<Self, D::Error> {
        struct Collect;
        impl<'de> Visitor<'de> for Collect {
            type Value = Members<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("values")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Members<'de>, A::Error> {
                let mut members = Vec::new();
                while let Some(member) = list.next_element()? {
                    members.push(member);
                }
                Ok(Members(members))
            }
        }
        reader.deserialize_tuple(usize::MAX, Collect)
    }
}

/// Fields with the text of their values.
struct Fields<'a>(Vec<(String, &'a str)>);

impl<'de> Deserialize<'de> for Fields<'de> {
    fn deserialize<D: Deserializer<'de>>(reader: D) -> Result<Self, D::Error> {
        struct Collect;
        impl<'de> Visitor<'de> for Collect {
            type Value = Fields<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("fields")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Fields<'de>, A::Error> {
                let mut fields = Vec::new();
                while let Some((name, value)) = map.next_entry::<String, &RawValue>()? {
                    fields.push((name, value.get_ron()));
                }
                Ok(Fields(fields))
            }
        }
        reader.deserialize_struct("", &[], Collect)
    }
}
