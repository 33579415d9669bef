//! The block matrix in LaTeX: an array, or a list of equations where an array would be too wide.
use super::text::{MAX_COLUMNS, stiffness};
use crate::system::{Block, BlockSystem, Face, RightHandSide, Row};

impl BlockSystem {
    /// The block matrix in LaTeX, to stand in a document that uses `amsmath`.
    ///
    /// 𝐜ᵢ is the column of amplitudes of layer i, 𝐒ᵢ with t or b the row by which S at its top or bottom face follows
    /// from them, p̂ₖ the transformed pressure of contact k, and ĝₖ the transformed gap there.
    ///
    /// ```
    /// use recede::{BlockSystem, HalfPlane, Plane, Stack};
    /// let stack = Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25)?).build()?;
    /// assert!(BlockSystem::new(&stack).to_latex().contains(r"\mathbf{S}_{1}^{t}"));
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn to_latex(&self) -> String {
        let columns = self.columns().iter().map(|column| {
            let (kind, number, amplitudes) = (column.body().notation().kind, column.number(), column.amplitudes());
            let name = column.body().name().map_or(String::new(), |name| format!("{name}, "));
            format!("% c_{number} = (C_{}, ..., C_{}): {name}{kind}", amplitudes.start(), amplitudes.end())
        });
        let matrix = if self.columns().len() > MAX_COLUMNS { self.equations() } else { self.array() };
        columns.chain(matrix).map(|line| line + "\n").collect()
    }

    fn array(&self) -> Vec<String> {
        let columns = self.columns();
        let header: Vec<String> =
            columns.iter().map(|column| format!(r"\mathbf{{c}}_{{{}}}", column.number())).collect();
        let begin = format!(r"\begin{{array}}{{l|{}|l}}", "c".repeat(columns.len()));
        let mut lines = vec![r"\[".to_owned(), begin, format!(r"  & {} & \\ \hline", header.join(" & "))];
        for row in self.rows() {
            let entry = |column| row.blocks.iter().filter(move |block| block.column == column).map(signed).collect();
            let entries: Vec<String> = (0..columns.len()).map(entry).collect();
            lines.push(format!(r"  {} & {} & {} \\", row.latex_name(), entries.join(" & "), row.latex_right()));
        }
        lines.extend([r"\end{array}", r"\]"].map(str::to_owned));
        lines
    }

    fn equations(&self) -> Vec<String> {
        let mut lines = vec![r"\begin{align*}".to_owned()];
        for row in self.rows() {
            let blocks = row.blocks.iter().map(|block| format!(r"{}\,\mathbf{{c}}_{{{}}}", signed(block), block.layer));
            let blocks: String = blocks.collect();
            lines.push(format!(r"  & {}: && {blocks} {} \\", row.latex_name(), row.latex_right()));
        }
        lines.push(r"\end{align*}".to_owned());
        lines
    }
}

fn signed(block: &Block) -> String {
    let sign = if block.negative { '-' } else { '+' };
    let face = if block.face == Face::Top { 't' } else { 'b' };
    let stiffness = stiffness(block).map_or(String::new(), |k| format!("k_{k} "));
    format!(r"{sign}{stiffness}\mathbf{{{}}}_{{{}}}^{{{face}}}", block.quantity, block.layer)
}

/// Quantities are symbols, as the numbers of a place are; all else are words.
fn in_latex(words: &str) -> String {
    let is_symbol = |word: &str| word.len() == 1 || word.contains('|');
    let word = |word| if is_symbol(word) { word.replace('|', r"\,|\,") } else { format!(r"\text{{{word}}}") };
    words.split(' ').map(word).collect::<Vec<_>>().join(r"\ ")
}

impl Row {
    fn latex_name(&self) -> String {
        let name = self.name();
        match name.split_once(' ') {
            None => in_latex(&name),
            Some((place, condition)) => format!(r"{}:\ {}", in_latex(place), in_latex(condition)),
        }
    }

    fn latex_right(&self) -> String {
        match self.right {
            None => "= 0".to_owned(),
            Some(RightHandSide::Pressure(contact)) => format!(r"= -\hat{{p}}_{{{contact}}}"),
            Some(RightHandSide::Gap(contact)) => format!(r"= \hat{{g}}_{{{contact}}}"),
        }
    }
}
