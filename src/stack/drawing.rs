//! The small drawing of a stack.
use std::fmt;

use recede_layers::Body;

use super::{Placed, Stack};

/// Columns between the borders, at least.
const NARROWEST: usize = 50;
/// Columns between the borders, at most.
const WIDEST: usize = 500;
/// Columns by which the second line of a long layer is indented.
const INDENT: usize = 3;

impl fmt::Display for Stack {
    /// Draws the stack without a punch.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.drawing(None, None))
    }
}

impl Stack {
    /// Draws the stack from the top down, one box for each group of joined layers; above it the punch with what is
    /// written on it, if anything. It is no wider than so many columns, or 50.
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
    pub fn drawing(&self, punch: Option<&str>, columns: Option<usize>) -> String {
        let widths = self.texts().into_iter().chain(self.second.iter().flat_map(|second| second.texts()));
        let widest = widths.flatten().map(|text| text.chars().count()).max().unwrap_or(NARROWEST);
        let width = widest.clamp(NARROWEST, WIDEST);
        // the borders take a column each
        let width = columns.map_or(width, |columns| width.min(columns.saturating_sub(2).max(NARROWEST)));

        let mut lines = Vec::new();
        if let Some(text) = punch {
            let text = cut(text, width.saturating_sub(10));
            lines.push(centred(&format!("╲    {text}    ╱"), width));
            lines.push(centred(&format!("╰{}╯", "─".repeat(text.chars().count() + 6)), width));
        }
        if let Some(second) = &self.second {
            // its core is on top
            let corners = |line: String| line.replace('┌', "└").replace('┐', "┘");
            lines.extend(second.boxes(width).into_iter().rev().flatten().map(corners));
        }
        lines.extend(self.boxes(width).into_iter().flatten());
        lines.extend(self.left_out());
        lines.join("\n")
    }

    /// The bodies of each group as they are written.
    fn texts(&self) -> Vec<Vec<String>> {
        let label = |(number, body): (usize, Option<Body>)| match body.map(|body| body.notation()) {
            Some(notation) => format!(" {number} {notation} "),
            None => format!(" {number} Rigid"),
        };
        self.groups().map(|group| group.bodies().map(label).collect()).collect()
    }

    /// The boxes from the top down, with the lines of each layer together.
    fn boxes(&self, width: usize) -> Vec<Vec<String>> {
        let (contacts, mut lines) = (self.contacts(), Vec::new());
        for (i, (texts, group)) in self.texts().iter().zip(self.groups()).enumerate() {
            if i > 0 {
                lines.push(vec![format!("└{}┘", "─".repeat(width))]);
                let gap = self.laminates[i - 1].gap().map(|gap| format!(", gap {}", gap.written_in(self.geometry)));
                lines.push(vec![centred(&format!("receding {}{}", contacts[i], gap.unwrap_or_default()), width)]);
            }
            lines.push(vec![format!("┌{}┐", "─".repeat(width))]);
            for (j, text) in texts.iter().enumerate() {
                if j > 0 {
                    let joint = format!(" {} ", group.joints()[j - 1]);
                    lines.push(vec![format!("├{joint:─^width$}┤")]);
                }
                lines.push(folded(text, width).iter().map(|line| format!("│{line:width$}│")).collect());
            }
        }
        lines.push(vec![format!("│{}│", "╱".repeat(width))]);
        lines
    }

    /// A line that names the dropped layers.
    fn left_out(&self) -> Option<String> {
        const SHOWN: usize = 5;
        let names: Vec<String> = self.dropped.iter().take(SHOWN).map(Placed::name).collect();
        let more = self.dropped.len().checked_sub(SHOWN + 1).map_or(String::new(), |n| format!(" and {} more", n + 1));
        (!names.is_empty()).then(|| format!("not there, because of thickness 0: {}{more}", names.join(", ")))
    }
}

fn centred(text: &str, width: usize) -> String {
    format!("{text:^0$}", width + 2).trim_end().to_owned()
}

/// A text without its end, if it is too long.
fn cut(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    text.chars().take(most.saturating_sub(3)).chain("...".chars()).collect()
}

/// A text in lines that are no longer than `width`, broken between words where that can be done.
fn folded(text: &str, width: usize) -> Vec<String> {
    let (mut lines, mut line) = (Vec::new(), String::new());
    let length = |text: &str| text.chars().count();
    for word in text.trim_end().split_inclusive(' ') {
        let is_begun = length(&line) > INDENT;
        if is_begun && length(&line) + length(word.trim_end()) + 1 > width {
            lines.push(std::mem::replace(&mut line, " ".repeat(INDENT)));
        }
        for c in word.chars() {
            if length(&line) >= width {
                lines.push(std::mem::replace(&mut line, " ".repeat(INDENT)));
            }
            line.push(c);
        }
    }
    lines.push(line);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_are_folded_between_words() {
        assert_eq!(folded(" 1 Layer(a: 1.0) ", 20), [" 1 Layer(a: 1.0)"]);
        assert_eq!(folded(" 1 Layer(aaaa: 1.0, bbbb: 2.0) ", 20), [" 1 Layer(aaaa: 1.0, ", "   bbbb: 2.0)"]);
        for text in [" 1 aaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", "", "µ µµµµµµµ µµµµµµ µµµµµµµµµµµµµµµµµµµµ"]
        {
            let lines = folded(text, 10);
            assert!(lines.iter().all(|line| line.chars().count() <= 10), "{lines:?}");
            let joined: String = lines.concat().split_whitespace().collect();
            assert_eq!(joined, text.split_whitespace().collect::<String>());
        }
        assert_eq!((cut("abcdefgh", 6), cut("abc", 6)), ("abc...".into(), "abc".into()));
    }
}
