//! Figures on a page: solves what they show, draws it, and keeps account of what is said of it.
use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use recede::plot::{self, Chart, Curve, Frame, Labels, Picture, Scale, style};
use recede::{Axis, FieldQuantity, Model, Scene, Solution};

const FRAME: Frame = Frame { left: 58.0, top: 12.0, right: 318.0, bottom: 192.0 };
const SIZE: (f64, f64) = (430.0, 236.0);
/// Points of a pressure.
const POINTS: usize = 160;
const CONTACTS: [&str; 2] = ["advancing contact", "receding contact"];

const HEAD: &str = "\
# The paper's figures, drawn again

Figures of the [source paper](../references.md#the-source-paper), and whether the paper's statements about them hold. Where a figure does not vary
them, h₁ = h₂, μ₁ = μ₃, μ₁h₁/P = 500, R/h₁ = 500, and ν = 1/4 in plane strain. Radii and ranges that the paper's text does not give are chosen.
";

const FOOT: &str = "
`cargo run --release --example figures` makes this page.
";

/// Paths of a scene and the values there.
type Changes = Vec<(&'static str, f64)>;
/// What curves of a figure differ in, and its values.
type Families<'a> = (&'a str, &'a [f64; 3]);

/// A page with figures.
pub struct Page {
    folder: PathBuf,
    scene: Scene,
    /// What is written below each figure.
    texts: BTreeMap<usize, String>,
}

/// What was found for each curve, from point to point.
pub struct Found {
    x: Vec<f64>,
    curves: Vec<Vec<Solution>>,
}

impl Page {
    /// A page in a folder, with figures that vary this scene.
    pub fn new(folder: &Path, scene: &str) -> Result<Self, Box<dyn Error>> {
        fs::create_dir_all(folder)?;
        let scene = Scene::read(Path::new(env!("CARGO_MANIFEST_DIR")).join(scene))?;
        Ok(Self { folder: folder.to_owned(), scene, texts: BTreeMap::new() })
    }

    /// Draws the scene itself.
    pub fn stack(&self, file: &str) -> Result<(), Box<dyn Error>> {
        let picture = plot::stack(&self.scene, &self.scene.stack()?, &recede::solve(&self.scene)?);
        Ok(plot::save(&self.folder.join(file), &picture)?)
    }

    /// Draws the largest shear stress inside the scene.
    pub fn map(&self, file: &str) -> Result<(), Box<dyn Error>> {
        let model = Model::new(self.scene.stack()?)?;
        let solution = model.press(&self.scene.top, self.scene.force)?;
        let field = model.field(&solution)?;
        let steps = |from: f64, to: f64, count: i32| -> Vec<f64> {
            (0..=count).map(|k| from + (to - from) * f64::from(k) / f64::from(count)).collect()
        };
        let grids = field.by_layer(&steps(-4.5, 4.5, 300), &steps(0.0, 5.0, 180))?;
        let picture = plot::map(&self.scene, &solution, &field, &grids, FieldQuantity::MaxShear)?;
        Ok(plot::save(&self.folder.join(file), &picture)?)
    }

    fn solve(&self, changes: Changes) -> Result<Solution, recede::Error> {
        let scene = changes.into_iter().try_fold(self.scene.clone(), |scene, (path, value)| scene.with(path, value))?;
        recede::solve(&scene)
    }

    /// Draws the pressures of both contacts, for three values.
    pub fn pressures(
        &mut self,
        numbers: [usize; 2],
        fixed: &str,
        (name, values): Families,
        changes: impl Fn(f64) -> Changes,
    ) -> Result<Found, Box<dyn Error>> {
        let curves: Result<_, _> = values.iter().map(|value| Ok(vec![self.solve(changes(*value))?])).collect();
        let found = Found { x: Vec::new(), curves: curves.map_err(|error: recede::Error| error)? };
        for (contact, number) in numbers.into_iter().enumerate() {
            let curve = |solution: &Solution| {
                let contact = &solution.contacts()[contact];
                let x = |i: usize| {
                    -contact.half_length().unwrap() * (std::f64::consts::PI * i as f64 / POINTS as f64).cos()
                };
                (0..=POINTS).map(|i| (x(i), contact.pressure(x(i)))).collect::<Vec<_>>()
            };
            let curves = found.curves.iter().map(|solutions| curve(&solutions[0])).collect();
            let symbol = ["p", "q"][contact];
            let caption =
                format!("Pressure {symbol} at the {}, for {name} = {}. {fixed}", CONTACTS[contact], list(values));
            let y_label = format!("{}/{}₁", plot::italic(symbol), plot::italic("μ"));
            let x_label = format!("{}/{}₁", plot::italic("x"), plot::italic("h"));
            self.figure(number, &caption, (&x_label, &y_label), false, (name, values), curves, Labels::Listed)?;
        }
        Ok(found)
    }

    /// Draws the half-lengths of both contacts over an axis, for three values.
    pub fn half_lengths(
        &mut self,
        numbers: [usize; 2],
        fixed: &str,
        along: &Axis,
        (name, values): Families,
        changes: impl Fn(f64, f64) -> Changes,
    ) -> Result<Found, Box<dyn Error>> {
        let mut found = Found { x: along.values().collect(), curves: Vec::new() };
        for value in values {
            let solutions: Result<_, _> = found.x.iter().map(|x| self.solve(changes(*value, *x))).collect();
            found.curves.push(solutions?);
        }
        for (contact, number) in numbers.into_iter().enumerate() {
            let curves =
                (0..values.len()).map(|i| found.x.iter().copied().zip(found.of(i, contact)).collect()).collect();
            let symbol = ["a", "b"][contact];
            let caption = format!(
                "Half-length {symbol} of the {}, over {}, for {name} = {}. {fixed}",
                CONTACTS[contact],
                along.path(),
                list(values)
            );
            let y_label = format!("{}/{}₁", plot::italic(symbol), plot::italic("h"));
            let ratio = found.x[1] / found.x[0];
            let logarithmic = found.x.windows(2).all(|pair| (pair[1] / pair[0] / ratio - 1.0).abs() < 1e-9);
            self.figure(
                number,
                &caption,
                (along.path(), &y_label),
                logarithmic,
                (name, values),
                curves,
                Labels::AtEnds,
            )?;
        }
        Ok(found)
    }

    #[allow(clippy::too_many_arguments, reason = "all that a figure is made of")]
    fn figure(
        &mut self,
        number: usize,
        caption: &str,
        (x_label, y_label): (&str, &str),
        logarithmic: bool,
        (name, values): Families,
        curves: Vec<Vec<(f64, f64)>>,
        labels: Labels,
    ) -> Result<(), Box<dyn Error>> {
        let points = || curves.iter().flatten();
        let x = Scale::around(points().map(|(x, _)| *x)).of(x_label, None);
        let y = Scale::around(points().map(|(_, y)| *y)).rounded().of(y_label, None);
        let count = curves.len();
        let named = values.iter().map(|value| format!("{name} = {}", plot::label(*value)));
        let curves = curves.into_iter().zip(named).enumerate();
        let chart = Chart {
            frame: FRAME,
            x: if logarithmic { x.logarithmic() } else { x },
            y,
            curves: curves
                .map(|(i, (points, label))| Curve { points, stroke: style::curve(i, count), label })
                .collect(),
            labels,
        };
        let file = format!("figure_{number:02}.svg");
        let mut picture = Picture::new(SIZE.0, SIZE.1);
        chart.draw(&mut picture);
        plot::save(&self.folder.join(&file), &picture.fitted())?;
        let caption = caption.trim().trim_end_matches('.');
        self.texts.insert(number, format!("## Figure {number}\n\n![Figure {number}]({file})\n\n{caption}.\n\n"));
        Ok(())
    }

    /// Notes what the paper says of a figure, and whether it holds.
    pub fn says(&mut self, figure: usize, claim: &str, holds: bool) {
        let verdict = if holds { "holds" } else { "**does not hold**" };
        self.adds(figure, &format!("{claim}: {verdict}"));
    }

    /// Notes what the paper says of all curves of a figure, and for which it holds.
    pub fn says_of_each(&mut self, figure: usize, claim: &str, (name, values): Families, holds: [bool; 3]) {
        let those = |which: bool| {
            let values: Vec<f64> = values.iter().zip(holds).filter(|(_, is)| *is == which).map(|(v, _)| *v).collect();
            (!values.is_empty()).then(|| format!("for {name} = {}", list(&values)))
        };
        match (those(true), those(false)) {
            (Some(held), Some(broken)) => {
                self.adds(figure, &format!("{claim}: holds {held}, **does not hold** {broken}"))
            }
            (held, _) => self.says(figure, claim, held.is_some()),
        }
    }

    /// Adds a sentence to a figure.
    pub fn adds(&mut self, figure: usize, sentence: &str) {
        *self.texts.entry(figure).or_default() += &format!("* {sentence}\n");
    }

    /// Writes the page.
    pub fn finish(self) -> Result<(), Box<dyn Error>> {
        let figures: Vec<String> = self.texts.into_values().collect();
        Ok(fs::write(self.folder.join("README.md"), format!("{HEAD}\n{}{FOOT}", figures.join("\n")))?)
    }
}

impl Found {
    /// Half-lengths, or whatever else, of a contact along one curve.
    fn of(&self, curve: usize, contact: usize) -> Vec<f64> {
        self.curves[curve].iter().map(|solution| solution.contacts()[contact].half_length().unwrap()).collect()
    }

    /// Half-lengths of both contacts, from curve to curve at their first point.
    pub fn half_lengths(&self) -> [Vec<f64>; 2] {
        [0, 1].map(|contact| {
            self.curves.iter().map(|curve| curve[0].contacts()[contact].half_length().unwrap()).collect()
        })
    }

    /// Pressures at x = 0 of both contacts, from curve to curve at their first point.
    pub fn peaks(&self) -> [Vec<f64>; 2] {
        [0, 1].map(|contact| self.curves.iter().map(|curve| curve[0].contacts()[contact].central_pressure).collect())
    }

    /// Whether something is true of the half-lengths of a contact along each curve.
    pub fn all(&self, contact: usize, is: impl Fn(&[f64]) -> bool) -> bool {
        self.which(contact, is).into_iter().all(|is| is)
    }

    /// For which curves something is true of the half-lengths of a contact.
    pub fn which(&self, contact: usize, is: impl Fn(&[f64]) -> bool) -> [bool; 3] {
        [0, 1, 2].map(|curve| is(&self.of(curve, contact)))
    }

    /// Whether half-lengths of a contact grow from curve to curve at every point.
    pub fn grows(&self, contact: usize) -> bool {
        (1..self.curves.len()).all(|curve| above(&self.of(curve, contact), &self.of(curve - 1, contact)))
    }

    /// Where the half-length of a contact is smallest, for each curve: the lowest of a parabola through three points.
    pub fn lowest(&self, contact: usize) -> [f64; 3] {
        [0, 1, 2].map(|curve| {
            let half_lengths = self.of(curve, contact);
            let lowest = (1..half_lengths.len() - 1).min_by(|i, j| half_lengths[*i].total_cmp(&half_lengths[*j]));
            let Some(at) = lowest else { return f64::NAN };
            let [left, middle, right] = [at - 1, at, at + 1].map(|i| half_lengths[i]);
            let step = self.x[at + 1] - self.x[at];
            self.x[at] + 0.5 * step * (left - right) / (left - 2.0 * middle + right)
        })
    }

    /// Whether each pressure of a contact is everywhere below that of the curve before it.
    pub fn nested(&self, contact: usize) -> bool {
        self.curves.windows(2).all(|pair| {
            let [outer, inner] = [&pair[0][0], &pair[1][0]].map(|solution| &solution.contacts()[contact]);
            let x = |i: usize| outer.half_length().unwrap() * i as f64 / POINTS as f64;
            (0..POINTS).all(|i| inner.pressure(x(i)) < outer.pressure(x(i)))
        })
    }
}

/// Whether each is smaller than the one before.
pub fn falls(values: &[f64]) -> bool {
    values.windows(2).all(|pair| pair[1] < pair[0])
}

/// Whether each is larger than the one before.
pub fn rises(values: &[f64]) -> bool {
    values.windows(2).all(|pair| pair[1] > pair[0])
}

/// Whether each is larger than its counterpart.
pub fn above(values: &[f64], others: &[f64]) -> bool {
    values.iter().zip(others).all(|(value, other)| value > other)
}

/// Whether of any two the one that is larger here is smaller there.
pub fn opposite(values: &[f64], others: &[f64]) -> bool {
    let pairs = || (0..values.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    pairs().all(|(i, j)| (values[i] > values[j]) == (others[i] < others[j]))
}

fn list(values: &[f64]) -> String {
    values.iter().map(|value| plot::label(*value)).collect::<Vec<_>>().join(", ")
}
