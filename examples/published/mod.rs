//! Published numbers next to those computed here, and what is to be said of the difference.
mod axisymmetric;
pub mod sources;

/// Parts of the last printed digit by which the number computed here may be wrong, for a verdict to be certain.
const CERTAIN: f64 = 0.05;

const HEAD: &str = "\
# Published numbers, computed again

Numbers from the literature next to the same numbers computed with `recede`. The *difference* is the published number minus the computed one, relative to the computed one. The
*assessment* is

* –, if the published number is the computed one rounded to as many digits;
* last digit, if it differs by one in the last printed digit (often because a number was cut off instead of rounded);
* source, if it differs by more; the text above the table gives the reason.

Every difference is an error of the publication: the estimated error of each computed number is less than a twentieth of the last printed digit.
[accuracy.md](accuracy.md) shows that these estimates hold, and compares the solver with references of many digits. The publications are
listed in [references.md](references.md).

The tables contain only numbers whose source and problem are known for certain. Publications on receding contact that were available by title only are left out, and so are
numbers read from curves; the figures of the source paper are drawn again in [figures](figures/README.md).
";

/// A published number, and the same computed here.
pub struct Number {
    /// Of what, as a cell of a table.
    pub of: String,
    /// Which quantity, as a cell of a table.
    pub quantity: &'static str,
    /// As printed, so that its digits are known.
    pub published: String,
    pub computed: f64,
    /// The estimated error of what is computed.
    pub error: f64,
    /// Whether what is printed cannot be meant.
    pub misprinted: bool,
}

/// Numbers of one publication.
pub struct Table {
    pub title: &'static str,
    /// The publication, the problem, and why numbers differ.
    pub about: &'static str,
    /// The largest relative difference of each quantity.
    pub within: Vec<(&'static str, f64)>,
    pub numbers: Vec<Number>,
}

/// Whether a number was printed right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    SameDigits,
    LastDigit,
    Source,
    Misprint,
}

impl Number {
    /// A number that was not misprinted.
    pub fn new(of: impl Into<String>, quantity: &'static str, published: &str, (computed, error): (f64, f64)) -> Self {
        let published = published.to_owned();
        Self { of: of.into(), quantity, published, computed, error, misprinted: false }
    }

    fn decimals(&self) -> usize {
        self.published.split_once('.').map_or(0, |(_, decimals)| decimals.len())
    }

    /// One in the last digit printed.
    fn unit(&self) -> f64 {
        0.1f64.powi(i32::try_from(self.decimals()).unwrap_or(i32::MAX))
    }

    fn value(&self) -> f64 {
        self.published.parse().expect("a number as printed")
    }

    /// The relative difference.
    pub fn difference(&self) -> f64 {
        self.value() / self.computed - 1.0
    }

    /// How the published number differs from the computed one.
    pub fn verdict(&self) -> Verdict {
        let rounded: f64 = format!("{:.*}", self.decimals(), self.computed).parse().expect("a number just written");
        let digits = ((self.value() - rounded) / self.unit()).abs();
        match digits {
            _ if self.misprinted => Verdict::Misprint,
            ..0.5 => Verdict::SameDigits,
            ..1.5 => Verdict::LastDigit,
            _ => Verdict::Source,
        }
    }

    /// Whether the number computed here is accurate enough to say so.
    pub fn is_certain(&self) -> bool {
        self.error < CERTAIN * self.unit()
    }

    fn row(&self) -> String {
        let verdict = match self.verdict() {
            Verdict::SameDigits => "–",
            Verdict::LastDigit => "last digit",
            Verdict::Source => "source",
            Verdict::Misprint => "source: a misprint",
        };
        let Self { of, quantity, published, computed, .. } = self;
        let decimals = self.decimals() + 2;
        format!(
            "| {of} | {quantity} | {published} | {computed:.decimals$} | {:+.2} % | {verdict} |\n",
            100.0 * self.difference()
        )
    }
}

impl Table {
    /// Whether a number of this table differs by no more than is said; misprints may.
    pub fn allows(&self, number: &Number) -> bool {
        let within = self.within.iter().find(|(quantity, _)| *quantity == number.quantity);
        number.misprinted || within.is_some_and(|(_, allowed)| number.difference().abs() <= *allowed)
    }

    fn markdown(&self) -> String {
        let within = self.within.iter().map(|(quantity, part)| format!("{quantity} within {:.2} %", 100.0 * part));
        let within = within.collect::<Vec<_>>().join(", ");
        let counted = counted(self.numbers.iter());
        let rows: String = self.numbers.iter().map(Number::row).collect();
        format!(
            "\n## {}\n\n{}\n\n{counted} Differences: {within}.\n\n\
             | of | quantity | published | computed | difference | assessment |\n|---|---|---|---|---|---|\n{rows}",
            self.title, self.about
        )
    }
}

const FOOT: &str = "
## How this page is made

`cargo run --release --example published_tables` writes it. `tests/examples.rs` checks that the page is up to date, that no difference is
larger than stated above its table, and that the computed numbers are accurate enough for the assessments.
";

/// How many numbers were printed right.
fn counted<'a>(numbers: impl Iterator<Item = &'a Number> + Clone) -> String {
    let count = |verdict: Verdict| numbers.clone().filter(|number| number.verdict() == verdict).count();
    format!(
        "Numbers: {}. Right in all digits: {}; one off in the last digit: {}; different by more: {}; misprinted: {}.",
        numbers.clone().count(),
        count(Verdict::SameDigits),
        count(Verdict::LastDigit),
        count(Verdict::Source),
        count(Verdict::Misprint),
    )
}

/// The whole document.
pub fn markdown(tables: &[Table]) -> String {
    let all = counted(tables.iter().flat_map(|table| &table.numbers));
    format!("{HEAD}\n{all}\n{}{FOOT}", tables.iter().map(Table::markdown).collect::<String>())
}
