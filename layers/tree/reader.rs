//! A reader of RON, Rusty Object Notation, and of JSON.
use super::json::{name_of_text, object, rows};
use super::{Entry, Fault, Form, Kind, Node, ReadError};

/// Brackets within brackets that are read.
const DEEPEST: usize = 128;
/// Extensions that a text may ask for: they are on, or change nothing here.
const EXTENSIONS: [&str; 4] = ["implicit_some", "unwrap_newtypes", "unwrap_variant_newtypes", "explicit_struct_names"];

impl Node {
    /// Reads a text in JSON. An object whose first key begins with a capital letter is a name with what follows it, a text with
    /// one such word a name alone; any other object holds fields. Lists within lists are rows.
    ///
    /// # Errors
    /// [`ReadError`] with its place if the text is none. Not all that JSON forbids is refused.
    pub fn from_json(text: &str) -> Result<Self, ReadError> {
        Reader { text, at: 0, depth: 0, is_json: true }.all()
    }

    /// Reads a text in RON.
    ///
    /// # Errors
    /// [`ReadError`] with its place if the text is no RON.
    pub fn from_ron(text: &str) -> Result<Self, ReadError> {
        let mut reader = Reader { text, at: 0, depth: 0, is_json: false };
        reader.space()?;
        while reader.eat("#![") {
            reader.attribute()?;
        }
        reader.all()
    }
}

/// The name with which a text in RON begins, if it does.
pub fn first_name(text: &str) -> Option<&str> {
    let mut reader = Reader { text, at: 0, depth: 0, is_json: false };
    reader.space().and_then(|()| reader.name()).ok().flatten()
}

/// The first characters that belong together, for messages.
pub fn token(rest: &str) -> String {
    const LONGEST: usize = 30;
    let rest = rest.trim_start();
    let bare = bare_token(rest);
    let token: String = match rest.chars().next() {
        None => return "the end of the text".into(),
        Some('"') => rest.chars().take(1 + rest[1..].find('"').map_or(LONGEST, |end| end + 1)).collect(),
        Some(first) if bare.is_empty() => first.into(),
        Some(_) => bare.into(),
    };
    let shown: String = token.chars().take(LONGEST).collect();
    let more = if token.chars().count() > LONGEST { "..." } else { "" };
    format!("`{shown}{more}`")
}

/// The characters up to the next space or punctuation.
pub fn bare_token(rest: &str) -> &str {
    rest.split(|c: char| c.is_whitespace() || ",:()[]{}\"".contains(c)).next().unwrap_or_default()
}

/// Reads a text from its beginning to its end.
struct Reader<'a> {
    text: &'a str,
    /// What is read next.
    at: usize,
    /// Brackets that are open.
    depth: usize,
    is_json: bool,
}

/// Whether a name may begin with it.
fn begins_name(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

/// Whether a name goes on with it.
fn in_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Whether a text in quotes begins with `r`.
fn begins_raw_text(rest: &str) -> bool {
    ["r\"", "r#\"", "r##"].iter().any(|start| rest.starts_with(start))
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn next(&self) -> Option<char> {
        self.rest().chars().next()
    }

    /// Passes over a word if it comes next.
    fn eat(&mut self, word: &str) -> bool {
        let found = self.rest().starts_with(word);
        self.at += if found { word.len() } else { 0 };
        found
    }

    /// Passes over characters, and returns them.
    fn take(&mut self, wanted: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let taken = &rest[..rest.find(|c| !wanted(c)).unwrap_or(rest.len())];
        self.at += taken.len();
        taken
    }

    /// What is wrong here: where nothing is left, that the text ends.
    fn fault(&self, fault: Fault) -> ReadError {
        if self.rest().trim().is_empty() {
            return Fault::syntax("the text ends too early", "is a closing `)`, `]` or `\"` missing?").at(self.at);
        }
        fault.at(self.at)
    }

    /// What comes next makes no sense.
    fn senseless(&self) -> ReadError {
        self.fault(Fault::syntax(format!("{} makes no sense here", token(self.rest())), ""))
    }

    /// The value that is the whole text.
    fn all(&mut self) -> Result<Node, ReadError> {
        let node = self.value()?;
        if node.name.is_none() && node.kind == Kind::Nothing {
            return Err(Fault::Expected(Form::Open).at(node.place.start));
        }
        self.space()?;
        if self.rest().is_empty() { Ok(node) } else { Err(self.fault(Fault::Follows)) }
    }

    /// Passes over white space and comments.
    fn space(&mut self) -> Result<(), ReadError> {
        loop {
            self.take(|c| c.is_whitespace() || matches!(c, '\u{200e}' | '\u{200f}'));
            if self.eat("//") {
                self.take(|c| c != '\n');
            } else if self.eat("/*") {
                self.comment()?;
            } else {
                return Ok(());
            }
        }
    }

    /// Passes over the rest of a comment, and those within it.
    fn comment(&mut self) -> Result<(), ReadError> {
        let mut open = 1;
        while open > 0 {
            self.take(|c| c != '*' && c != '/');
            if self.eat("*/") {
                open -= 1;
            } else if self.eat("/*") {
                open += 1;
            } else {
                self.at += self.next().ok_or_else(|| self.senseless())?.len_utf8();
            }
        }
        Ok(())
    }

    /// The rest of `#![enable(...)]` or `#![type = "..."]`.
    fn attribute(&mut self) -> Result<(), ReadError> {
        let what = self.value()?;
        self.space()?;
        if self.eat("=") {
            self.value()?;
            self.space()?;
        }
        for extension in what.members() {
            let name = extension.name.as_deref().unwrap_or_default();
            if !EXTENSIONS.contains(&name) {
                let message = format!("no extension of RON is called `{name}`");
                return Err(Fault::syntax(message, "").at(extension.place.start));
            }
        }
        if !self.eat("]") {
            return Err(self.senseless());
        }
        self.space()
    }

    /// A name, if one comes next.
    fn name(&mut self) -> Result<Option<&'a str>, ReadError> {
        let rest = self.rest();
        if let Some(raw) = rest.strip_prefix("r#").filter(|raw| raw.starts_with(in_name)) {
            self.at += rest.len() - raw.len();
            return Ok(Some(self.take(|c| in_name(c) || ".+-".contains(c))));
        }
        if !rest.starts_with(begins_name) || begins_raw_text(rest) {
            return Ok(None);
        }
        let start = self.at;
        let name = self.take(in_name);
        if self.next().is_some_and(|c| ".+-".contains(c)) {
            self.at = start;
            return Err(self.fault(Fault::Expected(Form::Name)));
        }
        Ok(Some(name))
    }

    fn value(&mut self) -> Result<Node, ReadError> {
        self.space()?;
        let start = self.at;
        let rest = self.rest();
        let kind = match self.next() {
            None => return Err(self.senseless()),
            Some('(' | '[') => self.bracket()?,
            Some('{') if self.is_json => {
                let kind = self.bracket()?;
                return object(Node::new(start..self.at, kind), self.text);
            }
            Some('"') => Kind::Text(self.text()?),
            Some('r') if begins_raw_text(rest) => Kind::Text(self.raw_text()?),
            Some(c) if begins_name(c) && !matches!(bare_token(rest), "inf" | "NaN") => return self.named(start),
            Some(_) => match self.number() {
                Some(number) => Kind::Number(number),
                None => self.nothing()?,
            },
        };
        let node = Node::new(start..self.at, kind);
        Ok(if self.is_json { name_of_text(node) } else { node })
    }

    /// A value that begins with a name.
    fn named(&mut self, start: usize) -> Result<Node, ReadError> {
        let name = self.name()?.map(|name| if self.is_json && name == "null" { "None" } else { name }.into());
        let end = self.at;
        self.space()?;
        let inner = self.at;
        if self.rest().starts_with('(') {
            let kind = self.bracket()?;
            return Ok(Node { place: start..self.at, name, inner, kind });
        }
        self.at = end;
        Ok(Node { place: start..end, name, inner: end, kind: Kind::Nothing })
    }

    fn number(&mut self) -> Option<f64> {
        let rest = self.rest();
        let unsigned = rest.trim_start_matches(['+', '-']);
        let sign = rest.len() - unsigned.len();
        let length = match bare_token(unsigned) {
            word @ ("inf" | "NaN") => word.len(),
            _ => unsigned.find(|c: char| !c.is_ascii_digit() && !".eE+-_".contains(c)).unwrap_or(unsigned.len()),
        };
        let number = &rest[..sign + length];
        // digits may be grouped
        let value = number.parse().or_else(|_| number.replace('_', "").parse()).ok()?;
        self.at += number.len();
        // a number may name its type
        let _ = self.eat("f64") || self.eat("f32");
        Some(value)
    }

    /// Passes over characters that are no value: the type that is read tells what should stand there.
    fn nothing(&mut self) -> Result<Kind, ReadError> {
        let rest = self.rest();
        let quoted = rest.strip_prefix('\'').and_then(|quoted| quoted.split('\n').next()?.find('\''));
        let length = quoted.map_or(bare_token(rest).len(), |end| end + 2);
        if length == 0 {
            return Err(self.senseless());
        }
        self.at += length;
        Ok(Kind::Nothing)
    }

    /// What stands in brackets, the first of which comes next.
    fn bracket(&mut self) -> Result<Kind, ReadError> {
        if self.depth == DEEPEST {
            let hint = "a scene needs no more than four levels of brackets";
            return Err(Fault::syntax("brackets are nested too deeply", hint).at(self.at));
        }
        self.depth += 1;
        let kind = if self.eat("[") {
            let members = self.separated("]", Self::value)?;
            Kind::List(if self.is_json { rows(members) } else { members })
        } else if self.eat("{") {
            Kind::Fields(self.separated("}", Self::field)?)
        } else {
            self.at += 1;
            match self.has_fields()? {
                true => Kind::Fields(self.separated(")", Self::field)?),
                false => Kind::Row(self.separated(")", Self::value)?),
            }
        };
        self.depth -= 1;
        Ok(kind)
    }

    /// Whether what comes next in parentheses is a field: a name and a colon, or a name and something else that makes no row.
    fn has_fields(&mut self) -> Result<bool, ReadError> {
        self.space()?;
        let start = self.at;
        let is_field = self.name()?.is_some() && {
            self.space()?;
            !self.rest().starts_with([',', ')', '('])
        };
        self.at = start;
        Ok(is_field)
    }

    /// Values with commas between them up to a bracket.
    fn separated<T>(
        &mut self,
        end: &str,
        one: impl Fn(&mut Self) -> Result<T, ReadError>,
    ) -> Result<Vec<T>, ReadError> {
        let mut values = Vec::new();
        loop {
            self.space()?;
            if self.eat(end) {
                return Ok(values);
            }
            values.push(one(self)?);
            let before = self.at;
            self.space()?;
            if !self.eat(",") && !self.rest().starts_with(end) {
                return Err(self.no_comma(before));
            }
        }
    }

    /// Something else follows a value that ends at a place.
    fn no_comma(&self, end: usize) -> ReadError {
        let rest = self.rest();
        let found = token(rest);
        let is_number = self.text[..end].ends_with(|c: char| c.is_ascii_digit() || c == '.');
        let is_unit = || !rest[bare_token(rest).len()..].trim_start().starts_with([':', '(']);
        self.fault(if rest.starts_with([')', ']', '}', ':']) {
            let hint = "is it one too many, or is another bracket not closed?";
            Fault::syntax(format!("{found} makes no sense here"), hint)
        } else if is_number && rest.starts_with(|c: char| c.is_alphabetic() || "°%".contains(c)) && is_unit() {
            let hint = "write a number with its unit in double quotes: `\"210 GPa\"`";
            Fault::syntax(format!("{found} follows a number"), hint)
        } else {
            Fault::syntax(format!("a comma is missing before {found}"), "")
        })
    }

    fn field(&mut self) -> Result<Entry, ReadError> {
        let at = self.at;
        let name = match self.is_json {
            true => self.text()?.into(),
            false => Box::from(self.name()?.ok_or_else(|| self.fault(Fault::Expected(Form::Name)))?),
        };
        self.space()?;
        if !self.eat(":") {
            let hint = "fields are written with their names, `field: value`; is a `)` missing before?";
            let message = format!("a colon is missing before {}", token(self.rest()));
            return Err(self.fault(Fault::syntax(message, hint)));
        }
        self.space()?;
        if self.rest().starts_with([',', ')', ']', '}']) {
            let message = format!("`{name}`: a value is expected, found {}", token(self.rest()));
            return Err(self.fault(Fault::syntax(message, "")));
        }
        Ok(Entry { name, at, value: self.value()? })
    }

    /// A text whose quotation mark stands at a place has no second one.
    fn open_text(&self, quote: usize) -> ReadError {
        let begun = Reader { at: quote + 1, ..*self };
        begun.fault(Fault::syntax("a closing `\"` is missing", ""))
    }

    /// A text in quotes.
    fn text(&mut self) -> Result<String, ReadError> {
        let start = self.at;
        self.at += 1;
        if self.is_json {
            let mut texts = serde_json::Deserializer::from_str(&self.text[start..]).into_iter();
            let text = texts.next().and_then(Result::ok).ok_or_else(|| self.open_text(start))?;
            self.at = start + texts.byte_offset();
            return Ok(text);
        }
        let mut text = String::new();
        loop {
            text += self.take(|c| c != '"' && c != '\\');
            if self.eat("\"") {
                return Ok(text);
            }
            if self.rest().is_empty() {
                return Err(self.open_text(start));
            }
            let escape = self.at;
            self.at += 1;
            let c = self.escape().ok_or_else(|| {
                let shown: String = self.text[escape..].chars().take(2).collect();
                Fault::syntax(format!("`{shown}` makes no sense in a text"), "a backslash is written `\\\\`").at(escape)
            })?;
            text.extend(c);
        }
    }

    /// The character for which stands what follows a backslash; none for the end of a line.
    fn escape(&mut self) -> Option<Option<char>> {
        let c = self.next()?;
        self.at += c.len_utf8();
        let code = |digits: &str| u32::from_str_radix(digits, 16).ok().and_then(char::from_u32);
        Some(Some(match c {
            '"' | '\\' | '\'' => c,
            'n' => '\n',
            'r' => '\r',
            't' => '\t',
            '0' => '\0',
            'x' => {
                let c = code(self.rest().get(..2)?).filter(char::is_ascii)?;
                self.at += 2;
                c
            }
            'u' => {
                let (digits, _) = self.rest().strip_prefix('{')?.split_once('}')?;
                self.at += digits.len() + 2;
                code(digits)?
            }
            '\n' | '\r' => {
                self.take(char::is_whitespace);
                return Some(None);
            }
            _ => return None,
        }))
    }

    /// A text in quotes with as many `#` before and behind, in which a backslash is a backslash.
    fn raw_text(&mut self) -> Result<String, ReadError> {
        self.at += 1;
        let marks = self.take(|c| c == '#');
        if !self.eat("\"") {
            return Err(self.fault(Fault::Expected(Form::Text)));
        }
        let end = format!("\"{marks}");
        let (text, _) = self.rest().split_once(&end).ok_or_else(|| self.open_text(self.at - 1))?;
        self.at += text.len() + end.len();
        Ok(text.to_owned())
    }
}
