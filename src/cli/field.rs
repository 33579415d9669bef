//! `recede field`: stresses and displacements inside the stack.
use std::io::Write;
use std::path::PathBuf;

use clap::builder::PossibleValuesParser;
use recede::plot::{self, MapStyle};
use recede::report::{Format, write_field};
use recede::{Coordinates, FieldQuantity, SpacePoint};

use super::plot::{ColourOptions, Page, range};
use super::{Failure, SceneFile, outputs, solved, warn};

/// Places along the layers and depths of a grid that is not specified.
const TABLE: [usize; 2] = [5, 7];
const LIST: [usize; 2] = [201, 101];
const MAP: [usize; 2] = [301, 181];
/// Most points in a table.
const READABLE: usize = 200;
/// Stresses and displacements inside the stack: points, a grid or a map
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  recede field scene.ron
  recede field scene.ron --at 0,0.5 --at 1.2,1@2 --format json
  recede field scene.ron --out field.csv
  recede field scene.ron --x -3:3:400 --depth 0:2:200 --out field.csv
  recede field scene.ron --out shear.svg
  recede field scene.ron --quantity sigma_xx --out along.png
  recede field scene.ron --out shear.svg --range 0:200 --colours viridis
  recede field scene.ron --out shear.svg --window -1:1,0:0.5 --levels 20

On an interface a point belongs to the layer below, unless @LAYER says which.

Exit status: 0 written, 1 no admissible solution, 2 bad input.")]
pub struct FieldArguments {
    #[command(flatten)]
    file: SceneFile,
    /// A point: x, or r about an axis, and the depth below the stack's top face; and which layer, by its number or name, if that is not clear. Under loads at
    /// places (x, y): X,Y,DEPTH
    #[arg(long, value_name = "X,DEPTH[@LAYER]", allow_hyphen_values = true)]
    at: Vec<String>,
    /// The vertical plane of a grid or a map under loads at places (x, y)
    #[arg(long, default_value = "0", conflicts_with = "at", allow_hyphen_values = true)]
    y: f64,
    /// Places of a grid along x, or r; without it, two half-lengths (radii) of the longest contact to either side, in a map as far as the
    /// quantity is appreciable
    #[arg(long, value_name = "START:STOP:COUNT", value_parser = steps, conflicts_with = "at", allow_hyphen_values = true)]
    x: Option<Steps>,
    /// Depths of a grid; without it, all layers and one and a half half-lengths (radii) of the longest contact in a half-plane,
    /// at most three in all
    #[arg(long, value_name = "START:STOP:COUNT", value_parser = steps, conflicts_with = "at", allow_hyphen_values = true)]
    depth: Option<Steps>,
    /// From where to where grids and maps go along x, or r, and in depth
    #[arg(long, value_name = "LEFT:RIGHT,TOP:BOTTOM", value_parser = window, conflicts_with_all = ["at", "x", "depth"], allow_hyphen_values = true)]
    window: Option<[[f64; 2]; 2]>,
    /// File to write: numbers (.csv, .json) or a map (.svg, .pdf, .png); without it, a short table on standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// What a map shows; in plane problems displacements are u and v, upwards, in axisymmetric ones u_r and u_z, downwards, and under loads at places (x, y)
    /// u_x, u_y and u_z
    #[arg(long, default_value = "max_shear", value_parser = PossibleValuesParser::new(names()))]
    quantity: String,
    /// How to write to standard output
    #[arg(long, value_enum, default_value = "table")]
    format: Format,
    /// Relative error to aim at in the contacts, from 1e-13 to 1e-2
    #[arg(long, default_value = "1e-10")]
    tolerance: f64,
    #[command(flatten)]
    page: Page,
    /// Logarithmic colours of a map, over three decades unless --range says which
    #[arg(long)]
    log: bool,
    #[command(flatten)]
    colours: ColourOptions,
}

/// Equally spaced numbers, one value of an option.
type Steps = Vec<f64>;

fn spaced(start: f64, stop: f64, count: usize) -> Steps {
    let part = |k: usize| if count > 1 { k as f64 / (count - 1) as f64 } else { 0.0 };
    (0..count).map(part).map(|part| (1.0 - part) * start + part * stop).collect()
}

/// START:STOP:COUNT.
fn steps(text: &str) -> Result<Steps, String> {
    let wrong = || format!("found `{text}`, expected START:STOP:COUNT as in 0:2:200");
    let [start, stop, count] = text.split(':').collect::<Vec<_>>()[..] else { return Err(wrong()) };
    let number = |text: &str| text.parse().map_err(|_| wrong());
    let (start, stop, count): (f64, f64, _) = (number(start)?, number(stop)?, count.parse().map_err(|_| wrong())?);
    let legal = start.is_finite() && stop.is_finite() && (1..=10_000).contains(&count);
    let refused = || format!("found `{text}`, allowed are finite numbers and a count of 1 to 10000");
    legal.then(|| spaced(start, stop, count)).ok_or_else(refused)
}

/// LEFT:RIGHT,TOP:BOTTOM.
fn window(text: &str) -> Result<[[f64; 2]; 2], String> {
    let wrong = || format!("found `{text}`, expected LEFT:RIGHT,TOP:BOTTOM as in -1:1,0:0.5");
    let (along, depths) = text.split_once(',').ok_or_else(wrong)?;
    Ok([range(along)?, range(depths)?])
}

impl FieldArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let format = self.format()?;
        if format.is_none() && !self.at.is_empty() {
            return Err(Failure::usage(
                "a map is drawn of a grid, not of points",
                "leave out --at, or let the file end in .csv or .json",
            ));
        }
        if format.is_some() && self.colours.style(self.log) != MapStyle::default() {
            return Err(Failure::usage(
                "colours are of a map, not of numbers",
                "let the file end in .svg, .pdf or .png, or leave out --range, --log, --levels and --colours",
            ));
        }
        let scene = self.file.read_for(self.out.as_deref().as_slice())?;
        let at: Result<Vec<SpacePoint>, _> = self.at.iter().map(|text| scene.numbered(text).parse()).collect();
        let wrong = |message| Failure::usage(message, "LAYER is a number, from 1 at the top, or a name in the scene");
        let at = at.map_err(wrong)?;
        let (model, solution) = solved(&scene, self.tolerance)?;
        warn(&solution);
        let field = model.field(&solution)?.at_y(self.y)?;
        let Some(format) = format else {
            // without a file there is no map
            let Some(path) = &self.out else { return Ok(()) };
            let quantity = self.quantity(scene.coordinates())?;
            let window = self.window.map_or_else(|| field.window_of(quantity), Ok)?;
            let [xs, depths] = self.grid(window, MAP);
            let (grids, style) = (field.by_layer(&xs, &depths)?, self.colours.style(self.log));
            let picture = plot::map_with(&scene, &solution, &field, &grids, quantity, &style)?;
            return self.page.save(picture, &scene, path);
        };
        let points = if self.at.is_empty() {
            let window = self.window.unwrap_or_else(|| field.window());
            let [xs, depths] = self.grid(window, if format == Format::Table { TABLE } else { LIST });
            field.grid(&xs, &depths)?.points().to_vec()
        } else {
            field.points_in_space(&at)?
        };
        if format == Format::Table && points.len() > READABLE {
            return Err(Failure::usage(
                format!("a table of {} points is too long to be read; at most {READABLE} are shown", points.len()),
                "write them to a file, --out FILE.csv, or say --format csv",
            ));
        }
        outputs::write(self.out.as_deref(), out, |out| write_field(&points, &scene, format, out))
    }

    /// The format of numbers at points, as the name of the file asks for; `None` for a map.
    fn format(&self) -> Result<Option<Format>, Failure> {
        let kinds =
            [("csv", Some(Format::Csv)), ("json", Some(Format::Json)), ("svg", None), ("pdf", None), ("png", None)];
        let hint = "let it end in .csv or .json for numbers, in .svg, .pdf or .png for a map";
        outputs::kind(self.out.as_deref(), None, &kinds, Some(self.format), hint)
    }

    /// The quantity that is asked for by its name in this geometry.
    fn quantity(&self, coordinates: Coordinates) -> Result<FieldQuantity, Failure> {
        let hint = "name a quantity of this geometry";
        FieldQuantity::named(&self.quantity, coordinates).map_err(|message| Failure::usage(message, hint))
    }

    /// Places along x and depths; the default number of each unless it is given.
    fn grid(&self, [[from, to], [top, bottom]]: [[f64; 2]; 2], [columns, rows]: [usize; 2]) -> [Vec<f64>; 2] {
        let xs = self.x.clone().unwrap_or_else(|| spaced(from, to, columns));
        [xs, self.depth.clone().unwrap_or_else(|| spaced(top, bottom, rows))]
    }
}

/// The names of quantities in all geometries.
fn names() -> Vec<&'static str> {
    let all = [Coordinates::Plane, Coordinates::Cylindrical, Coordinates::Cartesian];
    let of = |own: Coordinates| FieldQuantity::all_in(own).map(move |quantity| quantity.name_in(own));
    let mut names: Vec<&str> = Vec::new();
    for name in all.into_iter().flat_map(of) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}
