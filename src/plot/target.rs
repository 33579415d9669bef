//! From a drawing to a file: SVG, or PNG made from the same SVG, so that both look alike.
use std::path::{Path, PathBuf};

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use crate::files;

/// The letters of all pictures; the licence stands beside the files.
const FONTS: [&[u8]; 2] = [include_bytes!("font/DejaVuSans.ttf"), include_bytes!("font/DejaVuSans-Oblique.ttf")];
/// What they are called in SVG.
pub(super) const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";
/// Pixels of a PNG per point: 216 to the inch.
const PIXELS: f32 = 3.0;
/// Pixels of a PNG at most, four bytes each: larger pictures have fewer pixels per point.
const MOST_PIXELS: f32 = 3e7;

/// Why a picture could not be made.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// The file's name does not say what kind of picture it is to be.
    #[error("{}: a picture is a file that ends in .svg or .png", file.display())]
    Ending {
        /// The file.
        file: PathBuf,
    },
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
    /// The drawing library failed.
    #[error("the picture cannot be drawn: {0}")]
    Drawing(String),
}

/// What kind of picture a file is to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Scalable vector graphics.
    Svg,
    /// Pixels.
    Png,
}

impl Kind {
    /// The kind that a file's name asks for.
    ///
    /// ```
    /// use recede::plot::Kind;
    /// assert_eq!(Kind::of("stack.PNG".as_ref())?, Kind::Png);
    /// assert!(Kind::of("stack.pdf".as_ref()).is_err());
    /// # Ok::<(), recede::plot::PlotError>(())
    /// ```
    ///
    /// # Errors
    /// [`PlotError::Ending`] if it ends neither in `.svg` nor in `.png`.
    pub fn of(file: &Path) -> Result<Self, PlotError> {
        let ending = file.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            _ => Err(PlotError::Ending { file: file.to_owned() }),
        }
    }
}

/// Writes a picture, given as SVG, to a file that ends in `.svg` or `.png`. The file appears when it is complete.
///
/// # Errors
/// [`PlotError`] if the ending is another one, or the file cannot be written.
pub fn save(file: &Path, svg: &str) -> Result<(), PlotError> {
    let bytes = match Kind::of(file)? {
        Kind::Svg => svg.as_bytes().to_vec(),
        Kind::Png => png(svg)?,
    };
    files::replace(file, |out| out.write_all(&bytes)).map_err(|cause| PlotError::File { file: file.to_owned(), cause })
}

/// An SVG of this crate as pixels.
///
/// # Errors
/// [`PlotError::Drawing`] if it is not an SVG, or has no size.
pub fn png(svg: &str) -> Result<Vec<u8>, PlotError> {
    let mut options = Options { font_family: "DejaVu Sans".into(), ..Options::default() };
    for font in FONTS {
        options.fontdb_mut().load_font_data(font.to_vec());
    }
    let failed = |error: &dyn std::fmt::Display| PlotError::Drawing(error.to_string());
    let tree = Tree::from_str(svg, &options).map_err(|error| failed(&error))?;
    let size = tree.size();
    let scale = PIXELS.min((MOST_PIXELS / (size.width() * size.height())).sqrt());
    let pixels = |points: f32| (scale * points).ceil() as u32;
    let mut pixmap =
        Pixmap::new(pixels(size.width()), pixels(size.height())).ok_or_else(|| failed(&"it has no size"))?;
    pixmap.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixmap.as_mut());
    pixmap.encode_png().map_err(|error| failed(&error))
}
