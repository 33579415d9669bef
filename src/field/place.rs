//! Points at which fields are requested.
use std::fmt;
use std::str::FromStr;

use crate::geometry::Geometry;

/// A point at which a field is requested.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Along the layers, from the centre of the contact, in length.
    pub x: f64,
    /// Below the top face of the stack, in length.
    pub depth: f64,
    /// The layer, numbered from the top as written in the scene, starting at 1. On an interface `None` is the layer below.
    pub layer: Option<usize>,
}

/// A point at which a field is requested under loads at several places (x, y).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpacePoint {
    /// Along the layers, in length.
    pub x: f64,
    /// Along the layers, too, in length; 0 unless loads press at several places (x, y).
    pub y: f64,
    /// Below the top face of the stack, in length.
    pub depth: f64,
    /// The layer, numbered from the top as written in the scene, starting at 1. On an interface `None` is the layer below.
    pub layer: Option<usize>,
}

impl From<Point> for SpacePoint {
    /// The point at y = 0.
    fn from(Point { x, depth, layer }: Point) -> Self {
        Self { x, y: 0.0, depth, layer }
    }
}

impl SpacePoint {
    /// The point without its y.
    pub(super) fn in_plane(&self) -> Point {
        Point { x: self.x, depth: self.depth, layer: self.layer }
    }
}

/// Reads X,DEPTH or X,DEPTH@LAYER.
impl FromStr for Point {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("found `{text}`, expected X,DEPTH or X,DEPTH@LAYER as in 0,0.5 or 1.2,1@2");
        let (numbers, layer) = numbers(text).ok_or_else(wrong)?;
        let [x, depth] = numbers[..] else { return Err(wrong()) };
        Ok(Self { x, depth, layer })
    }
}

/// Reads X,DEPTH or X,Y,DEPTH, and @LAYER behind it.
impl FromStr for SpacePoint {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong =
            || format!("found `{text}`, expected X,DEPTH or X,DEPTH@LAYER as in 0,0.5 or 1.2,1@2, or X,Y,DEPTH");
        let (numbers, layer) = numbers(text).ok_or_else(wrong)?;
        match numbers[..] {
            [x, depth] => Ok(Self { x, y: 0.0, depth, layer }),
            [x, y, depth] => Ok(Self { x, y, depth, layer }),
            _ => Err(wrong()),
        }
    }
}

/// Numbers between commas, and the number of a layer behind them.
fn numbers(text: &str) -> Option<(Vec<f64>, Option<usize>)> {
    let (place, layer) = match text.split_once('@') {
        Some((place, layer)) => (place, Some(layer.trim().parse().ok()?)),
        None => (text, None),
    };
    let numbers: Result<Vec<f64>, _> = place.split(',').map(|number| number.trim().parse()).collect();
    Some((numbers.ok()?, layer))
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.written_in(Geometry::PlaneStrain))
    }
}

impl Point {
    /// The point in words, with the name of the coordinate in this geometry.
    pub(super) fn written_in(&self, geometry: Geometry) -> String {
        let layer = self.layer.map_or(String::new(), |layer| format!(" in layer {layer}"));
        format!("{} = {:?}, depth = {:?}{layer}", geometry.words().along, self.x, self.depth)
    }
}
