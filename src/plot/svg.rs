//! A picture as scalable vector graphics. Letters are outlines, each defined once, so that no viewer needs a font.
use std::collections::BTreeSet;
use std::fmt::{self, Display, Formatter, Write};

use super::letters::{Letter, Piece, letters};
use super::picture::{Anchor, Colour, Picture, Shape, pieces};

impl Picture {
    /// The picture as SVG.
    pub fn svg(&self) -> String {
        Svg(self).to_string()
    }
}

struct Svg<'a>(&'a Picture);

impl Display for Svg<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Picture { size: (width, height), shapes } = self.0;
        let (width, height) = (Number(*width), Number(*height));
        write!(f, "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"")?;
        writeln!(f, " width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">")?;
        self::outlines(f, shapes)?;
        writeln!(f, "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>")?;
        shapes.iter().try_for_each(|shape| self::shape(f, shape))?;
        writeln!(f, "</svg>")
    }
}

/// The outlines of all letters that occur, in units of their font.
fn outlines(f: &mut Formatter<'_>, shapes: &[Shape]) -> fmt::Result {
    let of = |shape: &Shape| match shape {
        Shape::Text { text, size, anchor, .. } => letters(text, *size, *anchor),
        Shape::Line { .. } | Shape::Area { .. } => Vec::new(),
    };
    let all: BTreeSet<Letter> = shapes.iter().flat_map(of).map(|placed| placed.letter).collect();
    writeln!(f, "<defs>")?;
    for letter in all {
        write!(f, "<path id=\"{}\" d=\"", Name(letter))?;
        for piece in letter.outline() {
            match piece {
                Piece::Move([x, y]) => write!(f, "M{} {}", Number(x), Number(y))?,
                Piece::Line([x, y]) => write!(f, "L{} {}", Number(x), Number(y))?,
                Piece::Quadratic([[a, b], [x, y]]) => {
                    write!(f, "Q{} {} {} {}", Number(a), Number(b), Number(x), Number(y))?;
                }
                Piece::Cubic(points) => {
                    f.write_char('C')?;
                    points.iter().flatten().try_for_each(|number| write!(f, "{} ", Number(*number)))?;
                }
                Piece::Close => f.write_char('Z')?,
            }
        }
        writeln!(f, "\"/>")?;
    }
    writeln!(f, "</defs>")
}

fn shape(f: &mut Formatter<'_>, shape: &Shape) -> fmt::Result {
    match shape {
        Shape::Line { points, stroke } => {
            write!(f, "<path d=\"")?;
            path(f, points)?;
            write!(f, "\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"", Hex(stroke.colour), Number(stroke.width))?;
            if let Some((dash, space)) = stroke.dash {
                write!(f, " stroke-dasharray=\"{} {}\"", Number(dash), Number(space))?;
            }
            writeln!(f, "/>")
        }
        Shape::Area { rings, colour } => {
            write!(f, "<path d=\"")?;
            for ring in rings {
                path(f, ring)?;
                f.write_char('Z')?;
            }
            writeln!(f, "\" fill=\"{}\" fill-rule=\"evenodd\"/>", Hex(*colour))
        }
        Shape::Text { at, text, size, colour, anchor } => {
            // what is written there, for those who do not see it
            write!(f, "<g role=\"img\" aria-label=\"")?;
            pieces(text).try_for_each(|(_, piece)| write!(f, "{}", Escaped(piece)))?;
            write!(f, "\" transform=\"translate({} {})", Number(at.0), Number(at.1))?;
            if *anchor == Anchor::Upwards {
                write!(f, " rotate(-90)")?;
            }
            write!(f, "\" fill=\"{}\">", Hex(*colour))?;
            for placed in letters(text, *size, *anchor) {
                let ((x, y), scale) = (placed.at, (1e5 * placed.scale).round() / 1e5);
                write!(f, "<use xlink:href=\"#{}\" transform=\"", Name(placed.letter))?;
                write!(f, "translate({} {}) scale({scale} -{scale})\"/>", Number(x), Number(y))?;
            }
            writeln!(f, "</g>")
        }
    }
}

/// Lines from the first point through all others.
fn path(f: &mut Formatter<'_>, points: &[(f64, f64)]) -> fmt::Result {
    for (i, (x, y)) in points.iter().enumerate() {
        f.write_char(if i == 0 { 'M' } else { ' ' })?;
        write!(f, "{} {}", Number(*x), Number(*y))?;
    }
    Ok(())
}

/// What the outline of a letter is called.
struct Name(Letter);

impl Display for Name {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", if self.0.font == 0 { "u" } else { "i" }, self.0.glyph)
    }
}

/// Hundredths of a point are finer than any printer.
struct Number(f64);

impl Display for Number {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        // no negative zero
        write!(f, "{}", (100.0 * self.0).round() / 100.0 + 0.0)
    }
}

struct Hex(Colour);

impl Display for Hex {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Colour { r, g, b } = self.0;
        write!(f, "#{r:02x}{g:02x}{b:02x}")
    }
}

/// Text without the characters that mean something in SVG, and without those that it may not have.
struct Escaped<'a>(&'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|c| match c {
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '&' => f.write_str("&amp;"),
            '"' => f.write_str("&quot;"),
            '\u{fffe}' | '\u{ffff}' => f.write_char(' '),
            c => f.write_char(c),
        })
    }
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
