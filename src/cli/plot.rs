//! `recede plot`: the stack, its contacts and their pressures as a picture.
use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use recede::plot::{self, Colours, Kind, MapStyle, Picture};
use recede::{Scene, profile_places};

use super::{Failure, SceneFile, solved};

/// Places along a face that is displaced, about.
const PLACES: usize = 300;

/// The page of a picture
#[derive(Debug, clap::Args)]
pub struct Page {
    /// Write a title above the picture: TEXT, or without it the name of the scene
    #[arg(long, value_name = "TEXT", num_args = 0..=1, require_equals = true, default_missing_value = "")]
    title: Option<String>,
    /// Size of the page of a picture in points, of three pixels each in a PNG; the picture fills it unless there is a --font-size
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    size: Option<(f64, f64)>,
    /// Size of the letters of a picture in points, 10 by default: all of it is enlarged
    #[arg(long, value_name = "N", value_parser = font_size)]
    font_size: Option<f64>,
}

impl Page {
    /// Writes the picture on the page.
    pub fn save(&self, picture: Picture, scene: &Scene, file: &Path) -> Result<(), Failure> {
        let titled = match self.title.as_deref() {
            None => picture,
            Some("") => picture.titled(scene.title()),
            Some(title) => picture.titled(title),
        };
        Ok(plot::save(file, &titled.sized(self.size, self.font_size)?)?)
    }
}

/// Colours of maps
#[derive(Debug, clap::Args)]
pub struct ColourOptions {
    /// Values at which the colours of a map begin and end
    #[arg(long, value_name = "LOW:HIGH", value_parser = range, allow_hyphen_values = true)]
    pub range: Option<[f64; 2]>,
    /// How many colours a map has, from 2 to 256
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(2..=256))]
    levels: Option<u16>,
    /// Which colours: the last two tell the sign
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(Colours::NAMED.map(|(name, _)| name)))]
    colours: Option<String>,
}

impl ColourOptions {
    /// The style of maps, with logarithmic colours or others.
    pub fn style(&self, is_logarithmic: bool) -> MapStyle {
        MapStyle {
            range: self.range,
            is_logarithmic,
            levels: self.levels.map(usize::from),
            colours: self.colours.as_deref().and_then(Colours::named),
        }
    }
}

/// A number between two, both included.
fn between(text: &str, [least, most]: [f64; 2]) -> Option<f64> {
    text.trim().parse().ok().filter(|number| (least..=most).contains(number))
}

/// WIDTHxHEIGHT.
fn size(text: &str) -> Result<(f64, f64), String> {
    let side = |text: &str| between(text, [50.0, 5000.0]);
    let sides = text.split_once('x').and_then(|(width, height)| side(width).zip(side(height)));
    sides.ok_or_else(|| format!("found `{text}`, expected WIDTHxHEIGHT as in 400x300, each from 50 to 5000"))
}

fn font_size(text: &str) -> Result<f64, String> {
    between(text, [1.0, 100.0]).ok_or_else(|| format!("found `{text}`, allowed is a number from 1 to 100"))
}

/// LOW:HIGH.
pub fn range(text: &str) -> Result<[f64; 2], String> {
    let wrong =
        || format!("found `{text}`, expected LOW:HIGH as in 0:2.5, finite numbers of which the second is larger");
    let (low, high) = text.split_once(':').ok_or_else(wrong)?;
    let number = |text: &str| text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    let ends = number(low).zip(number(high)).filter(|(low, high)| low < high);
    ends.map(|(low, high)| [low, high]).ok_or_else(wrong)
}

/// Draw a scene to scale with its contacts, and the pressures below it
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede plot scene.ron --out scene.svg
  recede plot scene.ron --out scene.pdf
  recede plot scene.ron --out scene.png --title='A strip on rock'
  recede plot scene.ron --deformed --out lifted.svg
  recede plot scene.ron --deformed 50 --out lifted.svg
  recede plot scene.ron --size 400x300 --out scene.png

Exit status: 0 drawn, 1 no admissible solution, 2 bad input.")]
pub struct PlotArguments {
    #[command(flatten)]
    file: SceneFile,
    /// The picture; its ending, .svg, .pdf or .png, says of which kind it is
    #[arg(long, value_name = "FILE.svg|pdf|png")]
    out: PathBuf,
    /// Draw displacements across the layers, gaps and punches SCALE times larger than lengths along the layers, without SCALE so that they are seen. They are
    /// counted from the rigid base, or from both ends of what is drawn of a half-plane's top face
    #[arg(long, value_name = "SCALE", num_args = 0..=1, value_parser = scale)]
    deformed: Option<Option<f64>>,
    /// Relative error to aim at, from 1e-13 to 1e-2
    #[arg(long, default_value = "1e-10")]
    tolerance: f64,
    #[command(flatten)]
    page: Page,
}

/// How many times larger displacements are drawn.
fn scale(text: &str) -> Result<f64, String> {
    let legal = text.parse().ok().filter(|times: &f64| times.is_finite() && *times > 0.0);
    legal.ok_or_else(|| format!("found `{text}`, allowed is a number > 0, or none behind the scene"))
}

impl PlotArguments {
    pub fn run(&self) -> Result<(), Failure> {
        Kind::of(&self.out)?;
        let scene = self.file.read_for(&[&self.out])?;
        let (model, solution) = solved(&scene, self.tolerance)?;
        let picture = match self.deformed {
            None => plot::stack(&scene, model.stack(), &solution),
            Some(times) => {
                let places = profile_places(&solution, None, PLACES);
                let profile = model.profile(&scene.top, &solution, &places)?;
                plot::deformed(&scene, model.stack(), &solution, &profile, times)?
            }
        };
        self.page.save(picture, &scene, &self.out)
    }
}
