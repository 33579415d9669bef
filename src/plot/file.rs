//! From a picture to a file.
use std::path::{Path, PathBuf};

use super::picture::Picture;
use crate::files;

/// Why a picture could not be made.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// The name of this file does not say what kind of picture it is to be.
    #[error("{}: a picture is a file that ends in .svg, .pdf or .png", .0.display())]
    Ending(PathBuf),
    /// The file cannot be written.
    #[error("{}: {cause}", file.display())]
    File {
        /// The file.
        file: PathBuf,
        /// Why.
        #[source]
        cause: std::io::Error,
    },
    /// There is nothing that could be drawn.
    #[error("nothing to draw: {0}")]
    Empty(String),
    /// A picture without a size cannot be one of pixels.
    #[error("the picture cannot be drawn: {0}")]
    Drawing(String),
}

/// What kind of picture a file is to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Scalable vector graphics.
    Svg,
    /// A page of a PDF.
    Pdf,
    /// Pixels.
    Png,
}

impl Kind {
    /// The kind that a file's name asks for; SVG if that says nothing, and leads to a pipe or a device.
    ///
    /// ```
    /// use recede::plot::Kind;
    /// assert_eq!(Kind::of("stack.PNG".as_ref())?, Kind::Png);
    /// assert!(Kind::of("stack.jpg".as_ref()).is_err());
    /// # Ok::<(), recede::plot::PlotError>(())
    /// ```
    ///
    /// # Errors
    /// [`PlotError::Ending`] if it ends in none of `.svg`, `.pdf` and `.png`.
    pub fn of(file: &Path) -> Result<Self, PlotError> {
        let ending = file.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("svg") => Ok(Self::Svg),
            Some("pdf") => Ok(Self::Pdf),
            Some("png") => Ok(Self::Png),
            None if files::is_stream(file) => Ok(Self::Svg),
            _ => Err(PlotError::Ending(file.to_owned())),
        }
    }
}

/// Writes a picture to a file that ends in `.svg`, `.pdf` or `.png`. The file appears when it is complete.
///
/// # Errors
/// [`PlotError`] if the ending is another one, or the file cannot be written.
pub fn save(file: &Path, picture: &Picture) -> Result<(), PlotError> {
    let bytes = match Kind::of(file)? {
        Kind::Svg => picture.svg().into_bytes(),
        Kind::Pdf => picture.pdf(),
        Kind::Png => picture.png()?,
    };
    files::replace(file, |out| out.write_all(&bytes)).map_err(|cause| PlotError::File { file: file.to_owned(), cause })
}
