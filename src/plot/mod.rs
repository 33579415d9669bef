//! Pictures of scenes, solutions, fields and sweeps, as SVG, PDF or PNG.
//!
//! A [`Picture`] is drawn in points and written by [`save`]; SVG, PDF and PNG are made from the same shapes, and letters are
//! outlines, so all look alike on any computer. [`style`] has the colours and lines of all pictures, [`Chart`] the axes.
//!
//! ```
//! use recede::plot::{self, Chart, Curve, Frame, Labels, Picture, Scale, style};
//! let curve: Vec<(f64, f64)> = (0..=50).map(|i| 0.02 * f64::from(i)).map(|x| (x, (1.0 - x * x).sqrt())).collect();
//! let chart = Chart {
//!     frame: Frame { left: 60.0, top: 15.0, right: 330.0, bottom: 200.0 },
//!     x: Scale::around([0.0, 1.0]).of(&format!("{} / {}", plot::italic("x"), plot::italic("a")), None),
//!     y: Scale::around(curve.iter().map(|(_, y)| *y)).rounded().of("pressure", Some("N/mm²".into())),
//!     curves: vec![Curve { points: curve, stroke: style::curve(0, 1), label: plot::italic("p") }],
//!     labels: Labels::AtEnds,
//! };
//! let mut picture = Picture::new(380.0, 240.0);
//! chart.draw(&mut picture);
//! assert!(picture.svg().contains("N/mm²"));
//! ```
mod bands;
mod chart;
mod contour;
mod depths;
mod displaced;
mod file;
mod letters;
mod map;
mod names;
mod page;
mod pdf;
mod picture;
mod png;
mod pressure;
mod punch;
mod scale;
mod section;
mod stack;
pub mod style;
mod svg;
mod sweep;

pub use bands::MapStyle;
pub use chart::{Chart, Curve, Frame, Labels};
pub use file::{Kind, PlotError, save};
pub use letters::width;
pub use map::{map, map_with};
pub use picture::{Anchor, Colour, Picture, Stroke, italic, subscript};
pub use scale::{Scale, Tick, label, ten_to};
pub use stack::{deformed, stack};
pub use style::Colours;
pub use sweep::{DrawnColumns, is_drawn, is_map, sweep};
