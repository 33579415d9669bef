//! A picture as scalable vector graphics. Letters are outlines, each defined once, so that no viewer needs a font.
use std::collections::BTreeSet;

use tiny_skia::{Path, PathSegment};

use super::letters::{Letter, PlacedLetter, letters};
use super::picture::{Anchor, Colour, DrawnShape, Picture, plain};

impl Picture {
    /// The picture as SVG.
    pub fn svg(&self) -> String {
        let (width, height) = (rounded(self.size.0), rounded(self.size.1));
        let of = |shape: &DrawnShape| match shape {
            DrawnShape::Text { text, size, anchor, .. } => letters(text, *size, *anchor),
            DrawnShape::Line { .. } | DrawnShape::Area { .. } => Vec::new(),
        };
        let letters: BTreeSet<Letter> = self.shapes.iter().flat_map(of).map(|placed| placed.letter).collect();
        let outline = |letter: Letter| {
            let path = letter.outline().map_or(String::new(), |outline| data(&outline));
            format!("<path id=\"{}\" d=\"{path}\"/>\n", name(letter))
        };
        [
            "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"".to_owned(),
            format!(" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n<defs>\n"),
            letters.into_iter().map(outline).collect(),
            "</defs>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n".to_owned(),
            self.shapes.iter().map(shape).collect(),
            "</svg>\n".to_owned(),
        ]
        .concat()
    }
}

fn shape(shape: &DrawnShape) -> String {
    let path = || shape.path().map_or(String::new(), |path| data(&path));
    match shape {
        DrawnShape::Line { stroke, .. } => {
            let (hex, width) = (hex(stroke.colour), rounded(stroke.width));
            let dashes = |(dash, space)| format!(" stroke-dasharray=\"{} {}\"", rounded(dash), rounded(space));
            let dashes = stroke.dash.map_or(String::new(), dashes);
            format!("<path d=\"{}\" fill=\"none\" stroke=\"{hex}\" stroke-width=\"{width}\"{dashes}/>\n", path())
        }
        DrawnShape::Area { colour, .. } => {
            format!("<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\"/>\n", path(), hex(*colour))
        }
        DrawnShape::Text { at, text, size, colour, anchor } => {
            let (x, y, turned) = (rounded(at.0), rounded(at.1), *anchor == Anchor::Upwards);
            let turn = if turned { " rotate(-90)" } else { "" };
            // what is written there, for those who do not see it
            let label = escaped(&plain(text));
            let letter = |PlacedLetter { letter, scale, at: (x, y) }| {
                let (x, y, scale) = (rounded(x), rounded(y), (1e5 * scale).round() / 1e5);
                let place = format!("translate({x} {y}) scale({scale} -{scale})");
                format!("<use xlink:href=\"#{}\" transform=\"{place}\"/>", name(letter))
            };
            let letters: String = letters(text, *size, *anchor).into_iter().map(letter).collect();
            let head = format!("<g role=\"img\" aria-label=\"{label}\" transform=\"translate({x} {y}){turn}\"");
            format!("{head} fill=\"{}\">{letters}</g>\n", hex(*colour))
        }
    }
}

/// A path as SVG has it.
fn data(path: &Path) -> String {
    let (mut data, mut curved) = (String::new(), false);
    for segment in path.segments() {
        let (letter, points) = match segment {
            PathSegment::MoveTo(to) => ("M", vec![to]),
            // a line goes on without a letter
            PathSegment::LineTo(to) => (if curved { "L" } else { " " }, vec![to]),
            PathSegment::QuadTo(by, to) => ("Q", vec![by, to]),
            PathSegment::CubicTo(from, towards, to) => ("C", vec![from, towards, to]),
            PathSegment::Close => ("Z", Vec::new()),
        };
        curved = points.len() > 1;
        let numbers = points.iter().map(|point| [point.x, point.y].map(|number| rounded(number.into()).to_string()));
        data += letter;
        data += &numbers.flatten().collect::<Vec<_>>().join(" ");
    }
    data
}

/// The name by which the outline of a letter is used.
fn name(Letter { font, glyph }: Letter) -> String {
    format!("{}{glyph}", if font == 0 { "u" } else { "i" })
}

/// Hundredths of a point are finer than any printer; no negative zero.
fn rounded(number: f64) -> f64 {
    (100.0 * number).round() / 100.0 + 0.0
}

fn hex(Colour { r, g, b }: Colour) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Text without the characters that mean something in SVG, and without those that it may not have.
fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;");
    text.replace(['\u{fffe}', '\u{ffff}'], " ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::{Stroke, italic};

    #[test]
    fn shapes_are_written_in_order_with_hundredths_of_a_point() {
        let ink = Colour { r: 1, g: 20, b: 255 };
        let mut picture = Picture::new(30.0, 20.5);
        picture.line(&[(0.004, -0.001), (1.0 / 3.0, 2.0)], Stroke { colour: ink, width: 0.7, dash: Some((1.6, 2.4)) });
        picture.area(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)], ink);
        picture.text((1.0, 2.0), &format!("{}\"<&\u{fffe}", italic("l")), 9.0, ink, Anchor::Upwards);
        let svg = picture.svg();
        // outlines of five letters, the last of them a box for what cannot be written
        assert_eq!(svg.matches("<path id=").count(), 5);
        let (_, drawn) = svg.split_once("</defs>\n").unwrap();
        insta::assert_snapshot!(drawn, @r##"
        <rect width="100%" height="100%" fill="#ffffff"/>
        <path d="M0 0 0.33 2" fill="none" stroke="#0114ff" stroke-width="0.7" stroke-dasharray="1.6 2.4"/>
        <path d="M0 0 1 0 1 1Z" fill="#0114ff" fill-rule="evenodd"/>
        <g role="img" aria-label="l&quot;&lt;&amp; " transform="translate(1 2) rotate(-90)" fill="#0114ff"><use xlink:href="#i77" transform="translate(-13.3 2.43) scale(0.00439 -0.00439)"/><use xlink:href="#u3" transform="translate(-10.8 2.43) scale(0.00439 -0.00439)"/><use xlink:href="#u29" transform="translate(-6.66 2.43) scale(0.00439 -0.00439)"/><use xlink:href="#u7" transform="translate(0.88 2.43) scale(0.00439 -0.00439)"/><use xlink:href="#u0" transform="translate(7.9 2.43) scale(0.00439 -0.00439)"/></g>
        </svg>
        "##);
    }
}
