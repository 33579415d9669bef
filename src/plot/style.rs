//! Colours, lines and letters of all pictures: legible in print, in grey, and for the colour-blind.
use super::picture::{Colour, Stroke};

/// Text, axes and outlines.
pub const INK: Colour = Colour { r: 26, g: 26, b: 26 };
/// Grids and help lines, fainter than curves.
pub const FAINT: Colour = Colour { r: 170, g: 170, b: 170 };
/// Values of zero, between the colours of two signs.
pub const NEUTRAL: Colour = Colour { r: 247, g: 247, b: 247 };
/// Letters of axes and labels, in points.
pub const TEXT: f64 = 10.0;
/// Letters of numbers at axes, in points.
pub const SMALL: f64 = 9.0;
/// The body of a punch, and loads.
pub const PUNCH: Colour = Colour { r: 187, g: 187, b: 187 };
/// Letters of a title, in points.
pub const TITLE: f64 = 12.0;
/// Lines of axes, in points.
pub const HAIR: f64 = 0.7;
/// Lines of curves, in points.
pub const BOLD: f64 = 1.6;

/// Colours of the palette up to here are dark enough for lines on white.
const DARK: f64 = 0.66;
/// Areas of one sign are no darker than this, from 0 to 1, so that dark lines are seen on them.
const DARKEST: f64 = 0.68;
/// Areas of two signs are no darker than this, on both sides of zero.
const DEEPEST: f64 = 0.82;
/// Dashes and spaces, so that lines differ also where colours do not.
const DASHES: [Option<(f64, f64)>; 4] = [None, Some((7.0, 3.0)), Some((1.6, 2.4)), Some((12.0, 3.0))];

/// The line of curve `index` of `count`: from dark to light in the order of the curves, brightness changing evenly, each dashed
/// otherwise.
pub fn curve(index: usize, count: usize) -> Stroke {
    let share = if count > 1 { index as f64 / (count - 1) as f64 } else { 0.0 };
    Stroke { colour: of_map(colorous::VIRIDIS, DARK * share), width: BOLD, dash: DASHES[index % DASHES.len()] }
}

/// Colours of areas, whose brightness changes evenly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colours {
    /// From light yellow to dark violet.
    Magma,
    /// From light yellow to dark green and blue.
    Viridis,
    /// From light yellow to dark blue, for the colour-blind.
    Cividis,
    /// From white to dark grey.
    Greys,
    /// Blue below zero, red above.
    RedBlue,
    /// Violet below zero, orange above.
    PurpleOrange,
}

impl Colours {
    /// All of them, by their names.
    pub const NAMED: [(&'static str, Self); 6] = [
        ("magma", Self::Magma),
        ("viridis", Self::Viridis),
        ("cividis", Self::Cividis),
        ("greys", Self::Greys),
        ("red-blue", Self::RedBlue),
        ("purple-orange", Self::PurpleOrange),
    ];

    /// The colours of this name.
    ///
    /// ```
    /// use recede::plot::style::Colours;
    /// assert_eq!(Colours::named("viridis"), Some(Colours::Viridis));
    /// ```
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMED.iter().find(|(own, _)| *own == name).map(|(_, colours)| *colours)
    }

    /// Whether they tell the sign of a value.
    pub fn are_signed(self) -> bool {
        matches!(self, Self::RedBlue | Self::PurpleOrange)
    }

    /// The colour of a part of the largest value: from light, 0, to dark, 1; of those that tell the sign from -1 through a neutral 0 to 1,
    /// equally dark on both sides.
    pub fn at(self, share: f64) -> Colour {
        let (light, signed) = (1.0 - DARKEST * share.clamp(0.0, 1.0), 0.5 * DEEPEST * share.clamp(-1.0, 1.0));
        match self {
            _ if self.are_signed() && share == 0.0 => NEUTRAL,
            Self::Magma => of_map(colorous::MAGMA, light),
            Self::Viridis => of_map(colorous::VIRIDIS, light),
            Self::Cividis => of_map(colorous::CIVIDIS, light),
            Self::Greys => of_map(colorous::GREYS, 1.0 - light),
            Self::RedBlue => of_map(colorous::RED_BLUE, 0.5 - signed),
            Self::PurpleOrange => of_map(colorous::PURPLE_ORANGE, 0.5 + signed),
        }
    }
}

fn of_map(map: colorous::Gradient, share: f64) -> Colour {
    let colorous::Color { r, g, b } = map.eval_continuous(share.clamp(0.0, 1.0));
    Colour { r, g, b }
}

/// A thin line.
pub fn hair(colour: Colour) -> Stroke {
    Stroke { colour, width: HAIR, dash: None }
}
