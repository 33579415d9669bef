//! The block matrix as text: a table, or a list of conditions where a table would be too wide.
use std::fmt;

use comfy_table::{CellAlignment, Table, presets};

use crate::system::{Block, BlockSystem, Column, Face, InterfaceSide, Place, Quantity, RightHandSide, Row};

/// Most columns of a table.
pub(super) const MAX_COLUMNS: usize = 12;

impl fmt::Display for BlockSystem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (rows, unknowns) = (self.rows().len(), self.unknowns());
        writeln!(f, "{rows} conditions for {unknowns} amplitudes")?;
        if self.columns().len() > MAX_COLUMNS {
            for row in self.rows() {
                writeln!(f, "{row}")?;
            }
            return Ok(());
        }
        let mut table = Table::new();
        table.load_style(presets::UTF8_FULL_CONDENSED);
        let header = self.columns().iter().map(Column::to_string);
        table.set_header([String::new()].into_iter().chain(header).chain([String::new()]));
        for row in self.rows() {
            let entry = |block: &Block| format!("{}({})", signed(block), block.face);
            let entry = |column| row.blocks.iter().filter(move |block| block.column == column).map(entry).collect();
            let entries = (0..self.columns().len()).map(entry);
            table.add_row([row.name()].into_iter().chain(entries).chain([row.right_hand_side()]));
        }
        for column in table.column_iter_mut().skip(1) {
            column.set_cell_alignment(CellAlignment::Center);
        }
        writeln!(f, "{table}")
    }
}

/// The quantity of a block with its sign and the stiffness of springs, e.g. `+kn·V`.
fn signed(block: &Block) -> String {
    let sign = if block.negative { '-' } else { '+' };
    let stiffness = stiffness(block).map_or(String::new(), |k| format!("k{k}·"));
    format!("{sign}{stiffness}{}", block.quantity)
}

/// The direction of the springs whose stiffness is before a displacement: normal or tangential.
pub(super) fn stiffness(block: &Block) -> Option<char> {
    block.stiffness.map(|_| if block.quantity == Quantity::U { 't' } else { 'n' })
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (body, amplitudes) = (self.body(), self.amplitudes());
        let name = body.name().map_or(String::new(), |name| format!(" \"{name}\""));
        let kind = body.notation().kind;
        write!(f, "{}{name} {kind}\nC{}..C{}", self.number(), amplitudes.start(), amplitudes.end())
    }
}

impl Row {
    /// Place and condition, e.g. `1|2 U continuous`.
    pub fn name(&self) -> String {
        let Some(first) = self.blocks.first() else { return self.place.to_string() };
        let sprung = self.blocks.iter().find(|block| block.stiffness.is_some());
        let condition = match (sprung, self.blocks.len()) {
            (Some(sprung), _) => format!("{} springs", sprung.quantity),
            // the top face has one side only
            (None, 1) if self.place == Place::Punch => first.quantity.to_string(),
            (None, 1) => format!("{} {}", first.quantity, first.side()),
            (None, _) if self.right.is_some() => format!("{} continuous but for a gap", first.quantity),
            (None, _) => format!("{} continuous", first.quantity),
        };
        format!("{} {condition}", self.place)
    }

    fn right_hand_side(&self) -> String {
        self.right.map_or("= 0".into(), |right| format!("= {right}"))
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.name())?;
        for block in self.blocks.iter() {
            write!(f, " {}({} of {})", signed(block), block.face, block.layer)?;
        }
        write!(f, " {}", self.right_hand_side())
    }
}

impl fmt::Display for RightHandSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pressure(contact) => write!(f, "-p{contact}"),
            Self::Gap(contact) => write!(f, "g{contact}"),
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}

impl fmt::Display for Face {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::Top { "top" } else { "bottom" })
    }
}

impl fmt::Display for InterfaceSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::Above { "above" } else { "below" })
    }
}

#[cfg(test)]
mod tests {
    use recede_layers::{Homogeneous, Plane};

    use super::*;
    use crate::stack::Stack;

    #[test]
    fn a_rigid_base_holds_the_lowest_layer_and_many_layers_are_listed() {
        let strips = |count: usize| {
            let strip = || Homogeneous::new(1.0, 1.0, 0.25).unwrap();
            let stack = (0..count).fold(Stack::builder(Plane::Strain), |stack, _| stack.layer(strip()).bonded());
            BlockSystem::new(&stack.rigid().build().unwrap())
        };
        assert_eq!(strips(1).rows()[3].to_string(), "1|2 V above: +V(bottom of 1) = 0");
        let many = strips(MAX_COLUMNS + 1);
        let (text, latex) = (many.to_string(), many.to_latex());
        assert!(text.contains("\n1|2 U continuous: +U(bottom of 1) -U(top of 2) = 0\n"), "{text}");
        assert!(
            latex.contains(r"+\mathbf{U}_{1}^{b}\,\mathbf{c}_{1}-\mathbf{U}_{2}^{t}\,\mathbf{c}_{2} = 0"),
            "{latex}"
        );
    }
}
