//! Values of any type that serde can read, from a tree.
use std::fmt;

use serde::de::value::BorrowedStrDeserializer;
use serde::de::{
    self, Deserialize, DeserializeSeed, Deserializer, EnumAccess, MapAccess, SeqAccess, VariantAccess, Visitor,
};

use super::{Entry, Fault, Form, Kind, Node, ReadError};

type Read<T> = Result<T, ReadError>;

impl Node {
    /// Reads a value: `Homogeneous(thickness: 1.0)` without a second pair of parentheses, optional fields without `Some`.
    ///
    /// # Errors
    /// [`ReadError`] with its place and field if the tree is none of a `T`.
    pub fn read<'de, T: Deserialize<'de>>(&'de self) -> Result<T, ReadError> {
        T::deserialize(Value { node: self, named: true }).map_err(|error| error.at(self.place.start))
    }

    /// Reads what follows the name, as [`Self::read`] does.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn read_inner<'de, T: Deserialize<'de>>(&'de self) -> Result<T, ReadError> {
        T::deserialize(Value { node: self, named: false }).map_err(|error| error.at(self.place.start))
    }
}

impl de::Error for ReadError {
    fn custom<T: fmt::Display>(reason: T) -> Self {
        Fault::Reason(reason.to_string()).into()
    }

    fn invalid_type(found: de::Unexpected, expected: &dyn de::Expected) -> Self {
        Self::custom(format_args!("{expected} is expected, found {found}"))
    }

    fn invalid_value(found: de::Unexpected, expected: &dyn de::Expected) -> Self {
        Self::invalid_type(found, expected)
    }

    fn invalid_length(length: usize, expected: &dyn de::Expected) -> Self {
        Self::custom(format_args!("{expected} is expected, the length is {length}"))
    }

    fn unknown_variant(found: &str, allowed: &'static [&'static str]) -> Self {
        Fault::UnknownName { found: found.to_owned(), allowed }.into()
    }

    fn unknown_field(found: &str, allowed: &'static [&'static str]) -> Self {
        Fault::UnknownField { found: found.to_owned(), allowed: allowed.to_vec() }.into()
    }

    fn missing_field(field: &'static str) -> Self {
        Fault::Missing(field).into()
    }

    fn duplicate_field(field: &'static str) -> Self {
        Fault::Twice(field).into()
    }
}

/// Whole numbers up to this, 2^53, are exact in double precision: beyond, a number is no whole one.
const LARGEST_WHOLE: f64 = 9_007_199_254_740_992.0;

/// A value that is read, with its name or what follows it.
#[derive(Clone, Copy)]
struct Value<'de> {
    node: &'de Node,
    named: bool,
}

impl Node {
    /// Its kind, unless it has a name.
    fn unnamed(&self) -> Option<&Kind> {
        self.name.is_none().then_some(&self.kind)
    }
}

impl<'de> Value<'de> {
    fn of(node: &'de Node) -> Self {
        Self { node, named: true }
    }

    /// Something else is expected.
    fn expected(&self, form: Form) -> ReadError {
        Fault::Expected(form).at(self.start())
    }

    /// Where it begins: behind a name, the first value in parentheses.
    fn start(&self) -> usize {
        let Node { place, inner, kind, .. } = self.node;
        match kind {
            _ if self.named => place.start,
            Kind::Nothing => place.end,
            Kind::Fields(fields) => fields.first().map_or(*inner, |field| field.at),
            Kind::Row(members) => members.first().map_or(inner + 1, |member| member.place.start),
            _ => *inner,
        }
    }

    /// The one value that it is, or that follows the name.
    fn one(&self, form: Form) -> Read<&'de Node> {
        match &self.node.kind {
            _ if self.named => Ok(self.node),
            Kind::Row(members) if members.len() == 1 => Ok(&members[0]),
            Kind::Nothing => Err(self.expected(Form::Open)),
            _ => Err(self.expected(form)),
        }
    }

    /// The same without its name, which may be left out.
    fn without_name(self, expected: &'static str) -> Read<Self> {
        match self.node.name.as_deref() {
            Some(found) if self.named && found != expected => {
                let fault = Fault::OtherName { expected, found: found.to_owned() };
                Err(fault.at(self.node.place.start))
            }
            name => Ok(Self { named: self.named && name.is_none(), ..self }),
        }
    }

    /// Values in parentheses, or in JSON in brackets, all of which are read.
    fn read_row<V: Visitor<'de>>(self, visitor: V) -> Read<V::Value> {
        let (Kind::Row(members) | Kind::List(members)) = &self.node.kind else {
            return Err(self.expected(Form::Open));
        };
        if self.named && self.node.name.is_some() {
            return Err(self.expected(Form::Open));
        }
        let mut rest = members.iter();
        let value = visitor.visit_seq(Members(&mut rest))?;
        rest.next().map_or(Ok(value), |member| Err(Value::of(member).expected(Form::Close)))
    }

    fn read_fields<V: Visitor<'de>>(self, allowed: &'static [&'static str], visitor: V) -> Read<V::Value> {
        let fields = match &self.node.kind {
            Kind::Fields(fields) => &fields[..],
            Kind::Row(members) => match members.first() {
                None => &[],
                Some(member) => return Err(no_field(member, allowed)),
            },
            _ => return Err(self.expected(Form::Open)),
        };
        let mut entries = Entries { fields, next: 0 };
        visitor.visit_map(&mut entries).map_err(|error| match (&error.fault, entries.current()) {
            (Fault::Twice(_), Some(field)) => error.at(field.at),
            // it is to be added before the closing parenthesis
            (Fault::Missing(_), _) => error.at(self.node.place.end.saturating_sub(1)),
            _ => error,
        })
    }
}

/// Why a value in parentheses is no field.
fn no_field(value: &Node, allowed: &'static [&'static str]) -> ReadError {
    let (start, end) = (value.place.start, value.place.end);
    match value.name.as_deref() {
        Some(name) if allowed.contains(&name) => {
            Fault::syntax(format!("`{name}` has no value"), "fields are written with their values, `field: value`")
                .at(end)
        }
        Some(name) => Fault::UnknownField { found: name.to_owned(), allowed: allowed.to_vec() }.at(start),
        None => Fault::Expected(Form::Name).at(start),
    }
}

impl<'de> Deserializer<'de> for Value<'de> {
    type Error = ReadError;

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 char bytes byte_buf identifier unit
    }

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Read<V::Value> {
        let inner = Value { named: false, ..self };
        match (self.node.name.as_deref().filter(|_| self.named), &self.node.kind) {
            (Some("true"), Kind::Nothing) => visitor.visit_bool(true),
            (Some("false"), Kind::Nothing) => visitor.visit_bool(false),
            (Some("None" | "Some"), _) => self.deserialize_option(visitor),
            (Some(name), Kind::Nothing) => visitor.visit_borrowed_str(name),
            (None, Kind::Nothing) => Err(self.expected(Form::Open)),
            (None, Kind::Row(members)) if !self.named && members.len() == 1 => {
                Value::of(&members[0]).deserialize_any(visitor)
            }
            (_, Kind::Number(number)) if number.fract() == 0.0 && number.abs() <= LARGEST_WHOLE => {
                visitor.visit_i64(*number as i64)
            }
            (_, Kind::Number(number)) => visitor.visit_f64(*number),
            (_, Kind::Text(text)) => visitor.visit_borrowed_str(text),
            (_, Kind::List(members)) => visitor.visit_seq(Members(&mut members.iter())),
            (_, Kind::Row(members)) if members.is_empty() => visitor.visit_unit(),
            (_, Kind::Row(_)) => inner.read_row(visitor),
            (_, Kind::Fields(_)) => inner.deserialize_map(visitor),
        }
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Read<V::Value> {
        visitor.visit_unit()
    }

    fn deserialize_f32<V: Visitor<'de>>(self, visitor: V) -> Read<V::Value> {
        self.deserialize_f64(visitor)
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Read<V::Value> {
        match self.one(Form::Number)?.unnamed() {
            Some(Kind::Number(number)) => visitor.visit_f64(*number),
            _ => Err(self.expected(Form::Number)),
        }
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Read<V::Value> {
        self.deserialize_str(visitor)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Read<V::Value> {
        match self.one(Form::Text)?.unnamed() {
            Some(Kind::Text(text)) => visitor.visit_borrowed_str(text),
            _ => Err(self.expected(Form::Text)),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Read<V::Value> {
        match (self.node.name.as_deref().filter(|_| self.named), &self.node.kind) {
            (Some("None"), Kind::Nothing) => visitor.visit_none(),
            (Some("Some"), Kind::Row(_) | Kind::Fields(_)) => visitor.visit_some(Value { named: false, ..self }),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_unit_struct<V: Visitor<'de>>(self, name: &'static str, visitor: V) -> Read<V::Value> {
        match self.without_name(name)? {
            Self { node: Node { kind: Kind::Nothing, .. }, named: false } => visitor.visit_unit(),
            inner => inner.deserialize_any(visitor),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, name: &'static str, visitor: V) -> Read<V::Value> {
        let has_own_name = self.named && self.node.name.as_deref() == Some(name);
        let is_row = matches!(self.node.unnamed(), Some(Kind::Row(_)));
        visitor.visit_newtype_struct(Value { named: self.named && !has_own_name && !is_row, ..self })
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Read<V::Value> {
        match self.one(Form::List)?.unnamed() {
            Some(Kind::List(members)) => visitor.visit_seq(Members(&mut members.iter())),
            _ => Err(self.expected(Form::List)),
        }
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, _: usize, visitor: V) -> Read<V::Value> {
        self.read_row(visitor)
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(self, name: &'static str, _: usize, visitor: V) -> Read<V::Value> {
        self.without_name(name)?.read_row(visitor)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Read<V::Value> {
        self.read_fields(&[], visitor)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        allowed: &'static [&'static str],
        visitor: V,
    ) -> Read<V::Value> {
        self.without_name(name)?.read_fields(allowed, visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Read<V::Value> {
        visitor.visit_enum(Variant(self.one(Form::Name)?))
    }
}

/// Values one after the other.
struct Members<'a, 'de>(&'a mut std::slice::Iter<'de, Node>);

impl<'de> SeqAccess<'de> for Members<'_, 'de> {
    type Error = ReadError;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Read<Option<T::Value>> {
        let read =
            |member: &'de Node| seed.deserialize(Value::of(member)).map_err(|error| error.at(member.place.start));
        self.0.next().map(read).transpose()
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.0.len())
    }
}

/// Fields one after the other.
struct Entries<'de> {
    fields: &'de [Entry],
    next: usize,
}

impl<'de> Entries<'de> {
    /// The field whose name was read last.
    fn current(&self) -> Option<&'de Entry> {
        self.fields.get(self.next.checked_sub(1)?)
    }
}

impl<'de> MapAccess<'de> for &mut Entries<'de> {
    type Error = ReadError;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Read<Option<K::Value>> {
        let Some(field) = self.fields.get(self.next) else { return Ok(None) };
        self.next += 1;
        let name = BorrowedStrDeserializer::new(&field.name);
        seed.deserialize(name).map(Some).map_err(|error: ReadError| error.at(field.at))
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Read<T::Value> {
        let Some(Entry { name, value, .. }) = self.current() else {
            return Err(de::Error::custom("a value was read before its name"));
        };
        seed.deserialize(Value::of(value)).map_err(|error| error.at(value.place.start).within(name))
    }
}

/// A name with what follows it.
struct Variant<'de>(&'de Node);

impl<'de> EnumAccess<'de> for Variant<'de> {
    type Error = ReadError;
    type Variant = Value<'de>;

    fn variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Read<(T::Value, Value<'de>)> {
        let node = self.0;
        let Some(name) = node.name.as_deref() else { return Err(Value::of(node).expected(Form::Name)) };
        let variant = seed.deserialize(BorrowedStrDeserializer::new(name));
        let variant = variant.map_err(|error: ReadError| error.at(node.place.start))?;
        Ok((variant, Value { node, named: false }))
    }
}

impl<'de> VariantAccess<'de> for Value<'de> {
    type Error = ReadError;

    fn unit_variant(self) -> Read<()> {
        match self.node.kind {
            Kind::Nothing => Ok(()),
            _ => Err(Fault::NotAlone.at(self.node.inner)),
        }
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Read<T::Value> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'de>>(self, _: usize, visitor: V) -> Read<V::Value> {
        self.read_row(visitor)
    }

    fn struct_variant<V: Visitor<'de>>(self, allowed: &'static [&'static str], visitor: V) -> Read<V::Value> {
        self.read_fields(allowed, visitor)
    }
}
