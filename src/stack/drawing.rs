//! The small drawing of a stack.
use std::fmt;

use recede_layers::Notation;

use super::{Group, Joint, Placed, Stack};

/// Columns between the borders, at least.
const NARROWEST: usize = 50;
/// Columns between the borders, at most.
const WIDEST: usize = 500;

impl fmt::Display for Stack {
    /// Draws the stack without a punch.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.drawing(None))
    }
}

impl Stack {
    /// Draws the stack from the top down, one box for each group of joined layers; above it the punch with what is
    /// written on it, if anything.
    ///
    /// ```text
    ///           ╲    Cylinder(radius: 500.0), force 0.002    ╱
    ///            ╰──────────────────────────────────────────╯
    /// ┌──────────────────────────────────────────────────────────────────┐
    /// │ 1 Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25) │
    /// └──────────────────────────────────────────────────────────────────┘
    ///                           receding 1|2
    /// ┌──────────────────────────────────────────────────────────────────┐
    /// │ 2 HalfPlane(shear_modulus: 1.0, poisson: 0.25)                   │
    /// │╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱│
    /// ```
    pub fn drawing(&self, punch: Option<&str>) -> String {
        let joints: Vec<&[Joint]> = self.groups().map(|group| group.joints()).collect();
        let labels = |group: Group<'_>| {
            let support = group.support().map(|(number, support)| label(number, &support.notation()));
            group.layers().map(|placed| label(placed.number, &placed.layer.notation())).chain(support).collect()
        };
        let groups: Vec<Vec<String>> = self.groups().map(labels).collect();
        let widths = groups.iter().flatten().map(|text| text.chars().count());
        let width = widths.chain([NARROWEST]).max().unwrap_or(NARROWEST).min(WIDEST);

        let mut lines = Vec::new();
        if let Some(text) = punch {
            lines.push(centred(&format!("╲    {text}    ╱"), width));
            lines.push(centred(&format!("╰{}╯", "─".repeat(text.chars().count() + 6)), width));
        }
        let contacts = self.contacts();
        for (i, texts) in groups.iter().enumerate() {
            if i > 0 {
                lines.push(format!("└{}┘", "─".repeat(width)));
                lines.push(centred(&format!("receding {}", contacts[i]), width));
            }
            lines.push(format!("┌{}┐", "─".repeat(width)));
            for (j, text) in texts.iter().enumerate() {
                if j > 0 {
                    lines.push(joined(joints[i].get(j - 1), width));
                }
                lines.push(format!("│{text:width$}│"));
            }
        }
        if let Some(number) = self.groups().find_map(|group| group.rigid()) {
            if !self.base.layers.is_empty() {
                lines.push(joined(self.base.joints.last(), width));
            }
            lines.push(format!("│{:width$}│", format!(" {number} Rigid")));
        }
        lines.push(format!("│{}│", "╱".repeat(width)));
        lines.extend(self.left_out());
        lines.join("\n")
    }

    /// A line that names the dropped layers.
    fn left_out(&self) -> Option<String> {
        const SHOWN: usize = 5;
        let names: Vec<String> = self.dropped.iter().take(SHOWN).map(Placed::name).collect();
        let more = self.dropped.len().checked_sub(SHOWN + 1).map_or(String::new(), |n| format!(" and {} more", n + 1));
        (!names.is_empty()).then(|| format!("not there, because of thickness 0: {}{more}", names.join(", ")))
    }
}

fn joined(joint: Option<&Joint>, width: usize) -> String {
    let text = joint.map_or(String::new(), |joint| format!(" {joint} "));
    format!("├{text:─^width$}┤")
}

fn centred(text: &str, width: usize) -> String {
    format!("{text:^0$}", width + 2).trim_end().to_owned()
}

/// The text in the box of a layer.
fn label(number: usize, notation: &Notation) -> String {
    format!(" {number} {}({}) ", notation.kind, notation.parameters)
}
