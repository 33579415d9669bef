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
/// Areas are no darker than this, from 0 to 1, so that dark lines are seen on them.
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

/// A colour for an area, from light (0) to dark (1), brightness changing evenly: the map "magma" from its light end on.
pub fn heat(share: f64) -> Colour {
    of_map(colorous::MAGMA, 1.0 - DARKEST * share.clamp(0.0, 1.0))
}

/// A colour for an area from -1, blue, through a neutral 0 to 1, red: equally dark on both sides.
pub fn signed(share: f64) -> Colour {
    if share == 0.0 { NEUTRAL } else { of_map(colorous::RED_BLUE, 0.5 - 0.5 * DEEPEST * share.clamp(-1.0, 1.0)) }
}

fn of_map(map: colorous::Gradient, share: f64) -> Colour {
    let colorous::Color { r, g, b } = map.eval_continuous(share.clamp(0.0, 1.0));
    Colour { r, g, b }
}

/// A thin line.
pub fn hair(colour: Colour) -> Stroke {
    Stroke { colour, width: HAIR, dash: None }
}
