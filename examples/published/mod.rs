//! Published numbers next to those computed here, and what is to be said of the difference.
mod axisymmetric;
pub mod sources;

/// Parts of the last printed digit by which the number computed here may be wrong, for a verdict to be certain.
const CERTAIN: f64 = 0.05;

const HEAD: &str = "\
# Published numbers, computed again

Numbers from the literature ([references.md](references.md)) next to the same numbers computed with `recede`. Where a published number is not the computed one
rounded to as many digits, there follows in brackets

* *last digit*, if it differs by one in the last printed digit (often cut off instead of rounded);
* otherwise the difference in per cent, published minus computed; the text above the table gives the reason.

Every difference is an error of the publication: the estimated error of each computed number is less than a twentieth of the last printed digit, and
[accuracy.md](accuracy.md#error-estimates) shows that such estimates hold.
";

/// A published number, and the same computed here.
pub struct Number {
    /// Of what, as a cell of a table.
    pub of: String,
    /// Which quantity; what stands in brackets is not in the head of its column.
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

    /// The head of its column.
    fn column(&self) -> &'static str {
        self.quantity.split(" (").next().unwrap_or_default()
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

    /// Published number with its difference, and computed number as cells of a table.
    fn cells(&self) -> String {
        let difference = match self.verdict() {
            Verdict::SameDigits => String::new(),
            Verdict::LastDigit => " (last digit)".to_owned(),
            Verdict::Source => format!(" ({:+.2})", 100.0 * self.difference()),
            Verdict::Misprint => " (misprint)".to_owned(),
        };
        let decimals = self.decimals() + 2;
        format!("{}{difference} | {:.decimals$}", self.published, self.computed)
    }
}

impl Table {
    /// Whether a number of this table differs by no more than is said; misprints may.
    pub fn allows(&self, number: &Number) -> bool {
        let within = self.within.iter().find(|(quantity, _)| *quantity == number.quantity);
        number.misprinted || within.is_some_and(|(_, allowed)| number.difference().abs() <= *allowed)
    }

    fn markdown(&self) -> String {
        format!("\n## {}\n\n{}\n\n{}", self.title, self.about, self.rows())
    }

    /// The head of the first column and its cells. Where all are values of the same parameters, as in `R/h = 10, μh/P = 500`, the head has their names.
    fn of(&self) -> (String, Vec<String>) {
        let split = |number: &Number| {
            let items: Option<Vec<(&str, &str)>> = number.of.split(", ").map(|item| item.split_once(" = ")).collect();
            let (names, values): (Vec<&str>, Vec<&str>) = items?.into_iter().unzip();
            Some((names.join(", "), values.join(", ")))
        };
        let all: Option<Vec<(String, String)>> = self.numbers.iter().map(split).collect();
        match all.and_then(|all| Some((all.first()?.0.clone(), all))) {
            Some((names, all)) if all.iter().all(|(own, _)| *own == names) => {
                (names, all.into_iter().map(|(_, values)| values).collect())
            }
            _ => ("of".to_owned(), self.numbers.iter().map(|number| number.of.clone()).collect()),
        }
    }

    /// A row for the numbers of each thing, with two columns for each quantity.
    fn rows(&self) -> String {
        let (of, values) = self.of();
        let mut columns: Vec<&str> = Vec::new();
        for column in self.numbers.iter().map(Number::column) {
            if !columns.contains(&column) {
                columns.push(column);
            }
        }
        let head: String = columns.iter().map(|column| format!(" {column} | computed |")).collect();
        let mut text = format!("| {of} |{head}\n{}|\n", "|---".repeat(1 + 2 * columns.len()));
        let mut begun = 0;
        for own in self.numbers.chunk_by(|a, b| a.of == b.of) {
            let cells = |column: &&str| own.iter().find(|number| number.column() == *column).map(Number::cells);
            let cells: Vec<String> = columns.iter().map(|column| cells(column).unwrap_or("|".to_owned())).collect();
            text += &format!("| {} | {} |\n", values[begun], cells.join(" | "));
            begun += own.len();
        }
        text
    }
}

const FOOT: &str = "
`cargo run --release --example published_tables` makes this page.
";

/// How many numbers were printed right.
fn counted<'a>(numbers: impl Iterator<Item = &'a Number> + Clone) -> String {
    let count = |verdict: Verdict| numbers.clone().filter(|number| number.verdict() == verdict).count();
    let kinds = [
        (Verdict::SameDigits, "right in all digits"),
        (Verdict::LastDigit, "one off in the last digit"),
        (Verdict::Source, "different by more"),
        (Verdict::Misprint, "misprinted"),
    ];
    let kinds = kinds.map(|(verdict, words)| (count(verdict), words));
    let kinds: Vec<String> =
        kinds.iter().filter(|(count, _)| *count > 0).map(|(count, words)| format!("{count} {words}")).collect();
    format!("{} numbers: {}.", numbers.clone().count(), kinds.join(", "))
}

/// The whole document.
pub fn markdown(tables: &[Table]) -> String {
    let all = counted(tables.iter().flat_map(|table| &table.numbers));
    format!("{HEAD}\n{all}\n{}{FOOT}", tables.iter().map(Table::markdown).collect::<String>())
}
