//! Tables with lines between their parts.
use comfy_table::{LineStyle, Table, TableStyle};

const RULE: LineStyle = LineStyle::none().fill('─').junction('─');
const RULES: TableStyle = TableStyle::new().top_border(RULE).header_separator(RULE).bottom_border(RULE);

/// A table with lines between its parts, and columns of these names in these units.
pub fn ruled<'a>(header: impl IntoIterator<Item = (&'a str, &'a str)>) -> Table {
    let mut table = Table::new();
    table.load_style(RULES);
    let named = |(name, unit): (&str, &str)| if unit.is_empty() { name.to_owned() } else { format!("{name},{unit}") };
    table.set_header(header.into_iter().map(named));
    table
}
