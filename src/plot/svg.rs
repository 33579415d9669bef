//! A picture as scalable vector graphics.
use std::fmt::{self, Display, Formatter, Write};

use super::picture::{Anchor, Colour, Face, Picture, Shape, pieces};

/// What the letters are called; the second and third stand in where the first is not installed.
const FAMILY: &str = "DejaVu Sans, Verdana, sans-serif";

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
        write!(f, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\"")?;
        writeln!(f, " viewBox=\"0 0 {width} {height}\" font-family=\"{FAMILY}\">")?;
        writeln!(f, "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>")?;
        shapes.iter().try_for_each(|shape| self::shape(f, shape))?;
        writeln!(f, "</svg>")
    }
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
        Shape::Area { rings, colour, opacity } => {
            write!(f, "<path d=\"")?;
            for ring in rings {
                path(f, ring)?;
                f.write_char('Z')?;
            }
            write!(f, "\" fill=\"{}\" fill-rule=\"evenodd\"", Hex(*colour))?;
            if *opacity < 1.0 {
                write!(f, " fill-opacity=\"{}\"", Number(*opacity))?;
            }
            writeln!(f, "/>")
        }
        Shape::Text { at, text, size, colour, anchor } => {
            let (x, y) = (Number(at.0), Number(at.1));
            let place = match anchor {
                Anchor::Left => "start",
                Anchor::Right => "end",
                Anchor::Centre | Anchor::Upwards => "middle",
            };
            // half the height of a small letter below the point
            write!(
                f,
                "<text x=\"{x}\" y=\"{y}\" dy=\"0.5ex\" font-size=\"{}\" text-anchor=\"{place}\"",
                Number(*size)
            )?;
            if *anchor == Anchor::Upwards {
                write!(f, " transform=\"rotate(270 {x} {y})\"")?;
            }
            write!(f, " fill=\"{}\">", Hex(*colour))?;
            for (face, piece) in pieces(text) {
                let Face { italic, index } = face;
                let end = if italic || index { "</tspan>" } else { "" };
                match (italic, index) {
                    (false, false) => (),
                    (true, false) => f.write_str("<tspan font-style=\"italic\">")?,
                    (false, true) => f.write_str("<tspan baseline-shift=\"sub\" font-size=\"70%\">")?,
                    (true, true) => {
                        f.write_str("<tspan font-style=\"italic\" baseline-shift=\"sub\" font-size=\"70%\">")?
                    }
                }
                write!(f, "{}{end}", Escaped(piece))?;
            }
            writeln!(f, "</text>")
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
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => f.write_char(' '),
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
        picture.area(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)], ink, 0.8);
        picture.text((1.0, 2.0), &format!("{} < 1 & \u{7}", italic("x")), 9.0, ink, Anchor::Upwards);
        insta::assert_snapshot!(picture.svg(), @r##"
        <svg xmlns="http://www.w3.org/2000/svg" width="30" height="20.5" viewBox="0 0 30 20.5" font-family="DejaVu Sans, Verdana, sans-serif">
        <rect width="100%" height="100%" fill="#ffffff"/>
        <path d="M0 0 0.33 2" fill="none" stroke="#0114ff" stroke-width="0.7" stroke-dasharray="1.6 2.4"/>
        <path d="M0 0 1 0 1 1Z" fill="#0114ff" fill-rule="evenodd" fill-opacity="0.8"/>
        <text x="1" y="2" dy="0.5ex" font-size="9" text-anchor="middle" transform="rotate(270 1 2)" fill="#0114ff"><tspan font-style="italic">x</tspan> &lt; 1 &amp;  </text>
        </svg>
        "##);
    }
}
