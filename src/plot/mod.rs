//! Pictures of scenes, solutions, fields and sweeps, as SVG or PNG.
//!
//! A picture is drawn on a [`Canvas`], in points, by [`svg`], and written by [`save`]; a PNG is made from the SVG, so both
//! look alike on any computer. [`style`] has the colours and lines of all pictures, [`Chart`] the axes.
//!
//! ```
//! use recede::plot::{self, Chart, Curve, Frame, Labels, Scale, style};
//! let curve: Vec<(f64, f64)> = (0..=50).map(|i| 0.02 * f64::from(i)).map(|x| (x, (1.0 - x * x).sqrt())).collect();
//! let chart = Chart {
//!     frame: Frame { left: 60.0, top: 15.0, right: 330.0, bottom: 200.0 },
//!     x: Scale::around([0.0, 1.0]),
//!     y: Scale::around(curve.iter().map(|(_, y)| *y)).rounded(),
//!     x_label: format!("{} / {}", plot::italic("x"), plot::italic("a")),
//!     x_unit: None,
//!     y_label: "pressure".into(),
//!     y_unit: Some("N/mm²".into()),
//!     curves: vec![Curve { points: curve, stroke: style::curve(0, 1), label: plot::italic("p") }],
//!     labels: Labels::AtEnds,
//! };
//! let picture = plot::svg(380.0, 240.0, |canvas| chart.draw(canvas))?;
//! assert!(picture.contains("N/mm²"));
//! # Ok::<(), recede::plot::PlotError>(())
//! ```
mod canvas;
mod chart;
mod ground;
mod map;
mod names;
mod pressure;
mod punch;
mod scale;
mod stack;
pub mod style;
mod sweep;
mod target;

pub use canvas::{Anchor, Canvas, Colour, Stroke, italic, svg};
pub use chart::{Chart, Curve, Frame, Labels, with_unit};
pub use map::map;
pub use scale::{Scale, Tick, label, ten_to};
pub use stack::stack;
pub use sweep::{is_drawn, sweep};
pub use target::{Kind, PlotError, png, save};
