//! The page of a picture: as large as what is drawn on it, with a title on request, and nothing over anything else.
use tiny_skia::{Path, PathBuilder, Transform};

use super::chart::Frame;
use super::file::PlotError;
use super::letters::{PlacedLetter, letters, shortened};
use super::picture::{Anchor, DrawnShape, Picture, plain};
use super::scale::label;
use super::style::{INK, TEXT, TITLE};
use crate::scene::visible;

/// Room around all that is drawn, in points.
const MARGIN: f64 = 10.0;
/// Boxes that share less than this, in points, only touch each other.
const TOUCHING: f64 = 0.5;
/// Distance of a title from what is below it, in points.
const BELOW_TITLE: f64 = 10.0;

impl Frame {
    /// The smallest that holds all these; `None` for none.
    fn around(frames: impl IntoIterator<Item = Self>) -> Option<Self> {
        frames.into_iter().reduce(|a, b| Self {
            left: a.left.min(b.left),
            top: a.top.min(b.top),
            right: a.right.max(b.right),
            bottom: a.bottom.max(b.bottom),
        })
    }

    fn overlaps(&self, other: &Self) -> bool {
        let shared = |from: f64, to: f64| to - from > TOUCHING;
        shared(self.left.max(other.left), self.right.min(other.right))
            && shared(self.top.max(other.top), self.bottom.min(other.bottom))
    }
}

impl DrawnShape {
    /// The path of the shape in points, which is stroked for a line and filled for an area or a text; `None` if it has no extent.
    pub(super) fn path(&self) -> Option<Path> {
        let mut path = PathBuilder::new();
        match self {
            Self::Line { points, .. } => through(&mut path, points),
            Self::Area { rings, .. } => rings.iter().for_each(|ring| {
                through(&mut path, ring);
                path.close();
            }),
            Self::Text { at: (x, y), text, size, anchor, .. } => {
                let turn = if *anchor == Anchor::Upwards { -90.0 } else { 0.0 };
                let place = Transform::from_translate(*x as f32, *y as f32).pre_rotate(turn);
                for PlacedLetter { letter, scale, at: (x, y) } in letters(text, *size, *anchor) {
                    let own = place.pre_translate(x as f32, y as f32).pre_scale(scale as f32, -scale as f32);
                    if let Some(outline) = letter.outline().and_then(|outline| outline.transform(own)) {
                        path.push_path(&outline);
                    }
                }
            }
        }
        path.finish()
    }

    /// The rectangle that the shape covers; `None` if the shape has no extent.
    fn frame(&self) -> Option<Frame> {
        let beside = if let Self::Line { stroke, .. } = self { 0.5 * stroke.width } else { 0.0 };
        let bounds = self.path()?.bounds();
        let [left, top] = [bounds.left(), bounds.top()].map(|end| f64::from(end) - beside);
        let [right, bottom] = [bounds.right(), bounds.bottom()].map(|end| f64::from(end) + beside);
        Some(Frame { left, top, right, bottom })
    }

    /// Enlarges the shape about the origin, and shifts it.
    fn place(&mut self, times: f64, (right, down): (f64, f64)) {
        let place = |(x, y): &mut (f64, f64)| (*x, *y) = (times * *x + right, times * *y + down);
        match self {
            Self::Line { points, stroke } => {
                points.iter_mut().for_each(place);
                stroke.width *= times;
                stroke.dash = stroke.dash.map(|(dash, space)| (times * dash, times * space));
            }
            Self::Area { rings, .. } => rings.iter_mut().flatten().for_each(place),
            Self::Text { at, size, .. } => {
                place(at);
                *size *= times;
            }
        }
    }
}

/// Lines from the first point through all others.
fn through(path: &mut PathBuilder, points: &[(f64, f64)]) {
    for (i, (x, y)) in points.iter().map(|(x, y)| (*x as f32, *y as f32)).enumerate() {
        if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
    }
}

impl Picture {
    /// The page cut to what is drawn on it, with a margin.
    pub fn fitted(mut self) -> Self {
        if let Some(all) = Frame::around(self.shapes.iter().filter_map(DrawnShape::frame)) {
            let by = (MARGIN - all.left, MARGIN - all.top);
            self.shapes.iter_mut().for_each(|shape| shape.place(1.0, by));
            self.size = (all.right + by.0 + MARGIN, all.bottom + by.1 + MARGIN);
        }
        self
    }

    /// The page with a title above all that is drawn on it, as much of it as fits in one line.
    ///
    /// ```
    /// # use recede::plot::{Picture, style};
    /// let mut picture = Picture::new(300.0, 100.0);
    /// picture.line(&[(0.0, 50.0), (300.0, 50.0)], style::curve(0, 1));
    /// let svg = picture.titled("Half-lengths of the paper").svg();
    /// assert!(svg.contains("aria-label=\"Half-lengths of the paper\""));
    /// ```
    pub fn titled(mut self, title: &str) -> Self {
        let title = plain(title);
        let title = visible(&title);
        if let Some(all) = Frame::around(self.shapes.iter().filter_map(DrawnShape::frame)) {
            let title = shortened(title.trim(), TITLE, all.right - all.left);
            let y = all.top - BELOW_TITLE - 0.5 * TITLE;
            self.text((0.5 * (all.left + all.right), y), &title, TITLE, INK, Anchor::Centre);
        }
        self.fitted()
    }

    /// The page enlarged until letters of axes have a size, or until it fills a page of a given width and height; with both the
    /// letters have that size, and what is drawn stands in the middle of the page. All in points.
    ///
    /// ```
    /// # use recede::plot::{Picture, style};
    /// let mut picture = Picture::new(300.0, 100.0);
    /// picture.line(&[(0.0, 50.0), (280.0, 50.0)], style::curve(0, 1));
    /// let picture = picture.fitted().sized(Some((600.0, 400.0)), None)?;
    /// assert_eq!(picture.size(), (600.0, 400.0));
    /// assert!(picture.sized(Some((300.0, 200.0)), Some(20.0)).is_err());
    /// # Ok::<(), recede::plot::PlotError>(())
    /// ```
    ///
    /// # Errors
    /// [`PlotError::Drawing`] if what is drawn with such letters is larger than the page.
    pub fn sized(mut self, page: Option<(f64, f64)>, letters: Option<f64>) -> Result<Self, PlotError> {
        let (width, height) = self.size;
        let fits = page.map_or(f64::INFINITY, |(w, h)| (w / width).min(h / height));
        let times = letters.map_or(if page.is_some() { fits } else { 1.0 }, |letters| letters / TEXT);
        if times > fits {
            let [letters, width, height] = [times * TEXT, (times * width).ceil(), (times * height).ceil()].map(label);
            let needed = format!("letters of {letters} points need a page of {width} x {height} points");
            return Err(PlotError::Drawing(needed));
        }
        self.size = page.unwrap_or((times * width, times * height));
        let beside = (0.5 * (self.size.0 - times * width), 0.5 * (self.size.1 - times * height));
        self.shapes.iter_mut().for_each(|shape| shape.place(times, beside));
        Ok(self)
    }

    /// The size of the page, width and height, in points.
    pub fn size(&self) -> (f64, f64) {
        self.size
    }

    /// All that is written on the page, and where.
    pub fn labels(&self) -> Vec<(String, Frame)> {
        let of = |shape: &DrawnShape| match shape {
            DrawnShape::Text { text, .. } => Some((plain(text), shape.frame()?)),
            DrawnShape::Line { .. } | DrawnShape::Area { .. } => None,
        };
        self.shapes.iter().filter_map(of).collect()
    }

    /// The faults of the page, in sentences: a coordinate that is not finite, labels that leave the page or lie over each other or over an
    /// area of colour. Empty for a picture that is fit to print.
    pub fn faults(&self) -> Vec<String> {
        if !self.is_finite() {
            return vec!["a place is not finite".to_owned()];
        }
        let labels = self.labels();
        let page = Frame { left: 0.0, top: 0.0, right: self.size.0, bottom: self.size.1 };
        let is_area = |shape: &&DrawnShape| matches!(shape, DrawnShape::Area { .. });
        let areas: Vec<Frame> = self.shapes.iter().filter(is_area).filter_map(DrawnShape::frame).collect();
        let mut faults = Vec::new();
        for (i, (text, own)) in labels.iter().enumerate() {
            if Frame::around([page, *own]) != Some(page) {
                faults.push(format!("`{text}` leaves the page"));
            }
            let others = labels[..i].iter().filter(|(_, other)| other.overlaps(own));
            faults.extend(others.map(|(other, _)| format!("`{text}` lies over `{other}`")));
            if areas.iter().any(|area| area.overlaps(own)) {
                faults.push(format!("`{text}` lies over an area"));
            }
        }
        faults
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_holds_all_that_is_drawn() {
        let mut picture = Picture::new(1.0, 1.0);
        picture.text((-50.0, 7.0), "left", 9.0, INK, Anchor::Right);
        picture.rectangle((0.0, 0.0), (20.0, 30.0), INK);
        assert!(picture.faults()[0].contains("`left` leaves the page"));
        let picture = picture.fitted();
        assert_eq!(picture.faults(), Vec::<String>::new());
        assert_eq!(picture.size().1, 30.0 + 2.0 * MARGIN);
        let titled = picture.titled("a\ntitle");
        assert!(titled.size().1 > 50.0 && titled.labels()[1].0 == "a title" && titled.faults().is_empty());
    }

    #[test]
    fn labels_over_each_other_are_found() {
        let mut picture = Picture::new(100.0, 100.0);
        picture.text((50.0, 50.0), "one", 9.0, INK, Anchor::Centre);
        picture.text((55.0, 52.0), "two", 9.0, INK, Anchor::Upwards);
        picture.rectangle((50.0, 30.0), (53.0, 48.0), INK);
        let faults = picture.faults();
        assert!(faults.contains(&"`two` lies over `one`".to_owned()), "{faults:?}");
        assert_eq!(faults.iter().filter(|fault| fault.ends_with("over an area")).count(), 2, "{faults:?}");
    }
}
