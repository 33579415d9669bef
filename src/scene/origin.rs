//! Where a scene came from, and errors that name a place in its text.
use std::fmt;
use std::sync::Arc;

use recede_layers::Registry;
use recede_layers::tree::Node;

use super::visible;

/// Widest excerpt of a line that is shown, in characters.
const EXCERPT: usize = 100;

/// Longest message and hint, in characters: names in them are as long as somebody made them.
const LONGEST: usize = 600;

/// The text of a scene, what stands in it, and the layer types with which it is read.
#[derive(Clone, Debug, Default)]
pub(super) struct Origin {
    pub(super) file: String,
    pub(super) text: String,
    /// The values of the text, those with a unit in the units of the scene.
    pub(super) tree: Node,
    pub(super) registry: Registry,
}

impl Origin {
    /// The text from a byte on.
    pub(super) fn rest(&self, at: usize) -> &str {
        self.text.get(at..).unwrap_or_default()
    }

    /// An error at a byte of the text, or about the file as a whole.
    pub(super) fn error(&self, at: Option<usize>, message: impl AsRef<str>) -> SceneError {
        SceneError {
            file: self.file.clone(),
            place: at.map(|offset| Box::new(TextPlace::new(&self.text, offset))),
            message: abridged(message.as_ref()),
            hint: None,
            cause: None,
        }
    }

    /// An error at a value.
    pub(super) fn error_at(&self, node: &Node, message: impl AsRef<str>) -> SceneError {
        self.error(Some(node.place.start), message)
    }
}

/// A text as it is shown, without its middle if it is very long.
fn abridged(text: &str) -> String {
    let text = visible(text);
    let length = text.chars().count();
    if length <= LONGEST {
        return text.into_owned();
    }
    let start: String = text.chars().take(LONGEST / 2).collect();
    let end: String = text.chars().skip(length - LONGEST / 2).collect();
    format!("{start}...{end}")
}

/// A line and column, with the line as it reads.
#[derive(Clone, Debug)]
struct TextPlace {
    line: usize,
    column: usize,
    excerpt: String,
    /// Position of the column in the excerpt, in characters from 0.
    caret: usize,
}

impl TextPlace {
    fn new(text: &str, offset: usize) -> Self {
        // the last place before that is one: an offset may be in the middle of a character, or beyond the end
        let before = (0..=offset).rev().find_map(|end| text.get(..end)).unwrap_or_default();
        let number = before.matches('\n').count();
        let column = before.rsplit('\n').next().map_or(0, |start| start.chars().count());
        let line = text.split('\n').nth(number).unwrap_or_default().trim_end();
        // a window of a long line
        let skipped = if line.chars().count() > EXCERPT { column.saturating_sub(EXCERPT / 2) } else { 0 };
        let window = |end: usize| line.chars().skip(skipped).take(end).collect::<String>();
        Self {
            line: number + 1,
            column: column + 1,
            excerpt: visible(&window(EXCERPT)).into_owned(),
            // behind what was trimmed the caret stands, too
            caret: visible(&window(column - skipped)).chars().count() + column.saturating_sub(line.chars().count()),
        }
    }
}

/// What is wrong with a scene, and where in its text: prints as `file:line:column: message`.
///
/// ```
/// use recede::Scene;
/// let error = Scene::from_ron("Scene(\n    geometry: PlaneStrian,\n)").unwrap_err();
/// assert_eq!((error.line(), error.column()), (Some(2), Some(15)));
/// assert_eq!(error.message(), "`geometry` of the scene is `PlaneStrian`; allowed are `PlaneStrain`, `PlaneStress`, `Axisymmetric`");
/// assert_eq!(error.hint(), Some("did you mean `PlaneStrain`?"));
/// ```
#[derive(Clone, Debug)]
pub struct SceneError {
    file: String,
    place: Option<Box<TextPlace>>,
    message: String,
    hint: Option<String>,
    cause: Option<Arc<dyn std::error::Error + Send + Sync>>,
}

impl SceneError {
    /// The error with a hint.
    pub(super) fn hinted(mut self, hint: Option<impl AsRef<str>>) -> Self {
        self.hint = hint.map(|hint| abridged(hint.as_ref()));
        self
    }

    pub(super) fn because(mut self, cause: impl std::error::Error + Send + Sync + 'static) -> Self {
        self.cause = Some(Arc::new(cause));
        self
    }

    /// Name of the file, or what stands for it.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Line in the text, from 1; `None` if the text could not be read at all.
    pub fn line(&self) -> Option<usize> {
        self.place.as_ref().map(|place| place.line)
    }

    /// Column in the line, in characters from 1.
    pub fn column(&self) -> Option<usize> {
        self.place.as_ref().map(|place| place.column)
    }

    /// What was found, and what is allowed.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What to do about it.
    pub fn hint(&self) -> Option<&str> {
        self.hint.as_deref()
    }

    /// The line in question with a caret below the column; long lines are cut.
    pub fn excerpt(&self) -> Option<String> {
        let TextPlace { line, excerpt, caret, .. } = self.place.as_deref()?;
        let number = line.to_string();
        let margin = " ".repeat(number.len());
        Some(format!("{number} | {excerpt}\n{margin} | {}^", " ".repeat(*caret)))
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let file = visible(&self.file);
        match &self.place {
            Some(place) => write!(f, "{file}:{}:{}: {}", place.line, place.column, self.message),
            None => write!(f, "{file}: {}", self.message),
        }
    }
}

impl std::error::Error for SceneError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.cause.as_deref().map(|cause| cause as _)
    }
}
