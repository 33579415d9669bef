//! Tables with lines between their parts.
use comfy_table::{LineStyle, Table, TableStyle};

const RULE: LineStyle = LineStyle::none().fill('─').junction('─');
const RULES: TableStyle = TableStyle::new().top_border(RULE).header_separator(RULE).bottom_border(RULE);

/// A table with lines between its parts.
pub(super) fn ruled() -> Table {
    let mut table = Table::new();
    table.load_style(RULES);
    table
}
