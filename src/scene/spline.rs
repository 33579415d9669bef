//! Smooth curves through the heights of a table.
use super::shape::{Piece, even};

/// A smooth curve through (x, height), x increasing, with 0, the tip, among them: the cubic spline, and where that would fall away from the tip
/// though the heights do not, cubic polynomials that do not either. Without heights on the left of the tip the curve is even; with heights on both
/// sides that rise away from the tip, it is level there.
pub(super) fn smooth(rows: &[(f64, f64)]) -> Vec<Piece> {
    let tip = rows.iter().position(|(x, _)| *x == 0.0).unwrap_or(0);
    let right = &rows[tip..];
    // as seen in a mirror
    let left: Vec<(f64, f64)> = rows[..=tip].iter().rev().map(|(x, height)| (-x, *height)).collect();
    let joined = |left: &[f64], right: &[f64]| -> Vec<f64> {
        left.iter().rev().map(|slope| -slope).chain(right.iter().skip(1).copied()).collect()
    };
    let mut slopes =
        if tip > 0 && rise(&left) && rise(right) { joined(&spline(&left), &spline(right)) } else { spline(rows) };
    limit_falls(right, &mut slopes[tip..]);
    if tip > 0 {
        let mut images: Vec<f64> = slopes[..=tip].iter().rev().map(|slope| -slope).collect();
        limit_falls(&left, &mut images);
        slopes = joined(&images, &slopes[tip..]);
    }
    let pieces = hermite(rows, &slopes, rows.get(tip).map_or(0.0, |(_, height)| *height));
    if tip > 0 { pieces } else { even(&pieces, rows.last().map_or(0.0, |(x, _)| *x)) }
}

/// Whether heights do not fall.
fn rise(rows: &[(f64, f64)]) -> bool {
    rows.windows(2).all(|pair| pair[0].1 <= pair[1].1)
}

/// Limits slopes on the right of the tip if the curve would fall though the heights do not.
fn limit_falls(rows: &[(f64, f64)], slopes: &mut [f64]) {
    let ends = rows.iter().skip(1).map(|(x, _)| x);
    let falls = |(piece, end): (&Piece, &f64)| piece.last_fall(*end).is_some();
    if rise(rows) && hermite(rows, slopes, 0.0).iter().zip(ends).any(falls) {
        limit(rows, slopes);
    }
}

/// Makes slopes so small that the cubic polynomials between heights that do not fall do not fall either: (m₀, m₁) on a
/// circle about 0 of three times the secant at most (Fritsch and Carlson 1980).
fn limit(rows: &[(f64, f64)], slopes: &mut [f64]) {
    for (i, pair) in rows.windows(2).enumerate() {
        let most = 3.0 * (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0);
        for slope in &mut slopes[i..i + 2] {
            *slope = slope.max(0.0);
        }
        let both = slopes[i].hypot(slopes[i + 1]);
        if both > most {
            slopes[i..i + 2].iter_mut().for_each(|slope| *slope *= most / both);
        }
    }
}

/// Cubic polynomials with these heights above another, and slopes.
fn hermite(rows: &[(f64, f64)], slopes: &[f64], tip: f64) -> Vec<Piece> {
    let piece = |(i, pair): (usize, &[(f64, f64)])| {
        let step = pair[1].0 - pair[0].0;
        let secant = (pair[1].1 - pair[0].1) / step;
        let [m0, m1] = [slopes[i], slopes[i + 1]];
        let second = (3.0 * secant - 2.0 * m0 - m1) / step;
        let third = (m0 + m1 - 2.0 * secant) / (step * step);
        Piece::starting(pair[0].0, [pair[0].1 - tip, m0, second, third])
    };
    rows.windows(2).enumerate().map(piece).collect()
}

/// Slopes of the cubic spline through (x, height): one polynomial across the two intervals at an end, from x = 0 on even.
fn spline(rows: &[(f64, f64)]) -> Vec<f64> {
    let side = |pair: &[(f64, f64)]| (pair[1].0 - pair[0].0, (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0));
    // steps and secants
    let sides: Vec<(f64, f64)> = rows.windows(2).map(side).collect();
    // slopes at the rows: a tridiagonal system, (below, diagonal, above, right-hand side)
    let is_even = rows.first().is_none_or(|(x, _)| *x == 0.0);
    // the row at the left end, from the steps and secants of the last interval and of the one before; at the right end as seen in a mirror
    let at_end = |(h, d): (f64, f64), (inner, secant): (f64, f64)| {
        let both = h + inner;
        (0.0, inner, both, (h * h * secant + (2.0 * both + h) * inner * d) / both)
    };
    let mut system = vec![match sides[..] {
        [(h0, d0), (h1, d1)] if !is_even => (0.0, 1.0, 0.0, d0 - h0 * (d1 - d0) / (h0 + h1)), // a parabola through three points
        [first, second, ..] if !is_even => at_end(first, second),
        _ => (0.0, 1.0, 0.0, 0.0),
    }];
    for pair in sides.windows(2) {
        let (before, after) = (pair[0].0.recip(), pair[1].0.recip());
        system.push((before, 2.0 * (before + after), after, 3.0 * (pair[0].1 * before + pair[1].1 * after)));
    }
    system.push(match sides[..] {
        [.., before, last] => {
            let (_, diagonal, beside, known) = at_end(last, before);
            (beside, diagonal, 0.0, known)
        }
        _ => (0.0, 1.0, 0.0, 2.0 * sides.first().map_or(0.0, |(_, secant)| *secant)),
    });
    for i in 1..system.len() {
        let (_, pivot, above, known) = system[i - 1];
        let factor = system[i].0 / pivot;
        system[i].1 -= factor * above;
        system[i].3 -= factor * known;
    }
    let mut slopes = vec![0.0; system.len() + 1];
    for (i, (_, pivot, above, known)) in system.iter().enumerate().rev() {
        slopes[i] = (known - above * slopes[i + 1]) / pivot;
    }
    slopes.pop();
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Shape;

    #[test]
    fn a_spline_through_points_of_an_even_cubic_is_that_cubic() {
        let height = |x: f64| 0.3 + 0.5 * x * x + 0.25 * x.powi(3);
        let rows: Vec<(f64, f64)> = [0.0, 0.3, 0.5, 1.1, 1.2].iter().map(|x| (*x, height(*x))).collect();
        for rows in [&rows[..], &rows[..3]] {
            let shape = Shape::Pieces { pieces: smooth(rows).into(), end: f64::INFINITY };
            for x in [0.0, 0.1, 0.42, 0.5] {
                assert!((shape.height(x) - height(x) + 0.3).abs() < 1e-15, "{x}");
                assert!((shape.slope(-x) + x + 0.75 * x * x).abs() < 1e-14, "{x}");
                assert!((shape.curvature(x) - 1.0 - 1.5 * x).abs() < 1e-13, "{x}");
            }
        }
        let two = Shape::Pieces { pieces: smooth(&[(0.0, 0.0), (2.0, 3.0)]).into(), end: f64::INFINITY };
        assert!((two.height(1.0) - 0.75).abs() < 1e-15);
    }

    #[test]
    fn between_its_points_a_spline_is_smooth() {
        let rows: Vec<(f64, f64)> = (0..12).map(|i| (0.1 * f64::from(i), (0.17 * f64::from(i * i)).sin())).collect();
        let pieces = smooth(&rows);
        for (i, (pair, row)) in pieces[rows.len() - 1..].windows(2).zip(&rows[1..]).enumerate() {
            let step = pair[1].start - pair[0].start;
            let [c0, c1, c2, c3] = pair[0].coefficients;
            let [d0, d1, d2, _] = pair[1].coefficients;
            assert!((c0 + step * (c1 + step * (c2 + step * c3)) - d0).abs() < 1e-14 && (d0 - row.1).abs() < 1e-14);
            assert!((c1 + step * (2.0 * c2 + step * 3.0 * c3) - d1).abs() < 1e-12, "{i}");
            assert!((c2 + 3.0 * step * c3 - d2).abs() < 1e-10, "{i}");
        }
    }

    #[test]
    fn on_either_side_of_the_tip_a_curve_is_as_smooth_and_falls_as_little() {
        let shape = |rows: &[(f64, f64)]| Shape::Pieces { pieces: smooth(rows).into(), end: f64::INFINITY };
        for rows in [
            &[(-1.0, 0.4), (0.0, 0.1), (2.0, 0.3)][..],
            &[(-2.0, 1.0), (-1.0, 1e-9), (0.0, 0.0), (1.5, 0.01), (2.0, 0.4), (2.5, 3.0)],
            &[(-0.3, 5.0), (-0.1, 0.2), (0.0, 0.2), (1.0, 0.2), (1.1, 4.0)],
            &[(-3.0, 0.0), (-1.0, 1.0), (0.0, 0.5), (1.0, 1.0), (1.5, -1.0), (2.0, 3.0)],
        ] {
            let images: Vec<(f64, f64)> = rows.iter().rev().map(|(x, height)| (-x, *height)).collect();
            let ([found, mirrored], [first, last]) =
                ([shape(rows), shape(&images)], [rows[0].0, rows[rows.len() - 1].0]);
            let tip = rows.iter().find(|(x, _)| *x == 0.0).unwrap().1;
            for (x, height) in rows {
                assert!((found.height(*x) - height + tip).abs() < 1e-14, "{rows:?}");
            }
            let falls = rows.windows(2).any(|pair| (pair[1].1 - pair[0].1) * (pair[0].0 + pair[1].0) < 0.0);
            for x in (0..=1000).map(|i| first + (last - first) * f64::from(i) / 1000.0) {
                assert!((found.height(x) - mirrored.height(-x)).abs() < 1e-14, "{rows:?} {x}");
                assert!((found.slope(x) + mirrored.slope(-x)).abs() < 1e-12, "{rows:?} {x}");
                assert!(falls || found.slope(x) * x >= -1e-12, "{rows:?} {x}");
            }
        }
        // a parabola that falls on its way from the left, as its heights do
        let height = |x: f64| 0.5 * x + 0.5 * x * x;
        let rows: Vec<(f64, f64)> = [-1.0, -0.4, 0.0, 0.7].iter().map(|x| (*x, height(*x))).collect();
        for rows in [&rows[..], &rows[1..]] {
            let found = shape(rows);
            for x in [-0.3, 0.1, 0.6] {
                assert!((found.height(x) - height(x)).abs() < 1e-15 && (found.curvature(x) - 1.0).abs() < 1e-13, "{x}");
            }
        }
    }

    #[test]
    fn a_curve_through_heights_that_do_not_fall_does_not_fall() {
        for rows in [
            &[(0.0, 0.0), (0.5, 0.0), (1.0, 0.1), (1.5, 0.1), (2.0, 0.4)][..],
            &[(0.0, 0.0), (1.0, 1e-9), (1.1, 1.0), (3.0, 1.0), (3.1, 50.0), (3.2, 50.1)],
            &[(0.0, 1.0), (0.1, 1.0), (0.2, 1.0), (0.3, 4.0)],
        ] {
            let pieces = smooth(rows);
            let end = rows[rows.len() - 1].0;
            let shape = Shape::Pieces { pieces: pieces.into(), end };
            assert_eq!(shape.last_fall(), 0.0);
            for (x, height) in rows {
                assert!((shape.height(*x) - height + rows[0].1).abs() <= 1e-14 * height);
            }
            let places = (0..=1000).map(|i| end * f64::from(i) / 1000.0);
            assert!(places.clone().all(|x| shape.slope(x) >= -1e-13), "{rows:?}");
        }
    }
}
