//! Rows against a rule of very many points, and closed forms.
use super::*;
use crate::contact::problem::modes::alternating;
use crate::scene::Punch;

fn punches() -> Vec<Punch> {
    vec![
        Punch::cylinder(2.0).unwrap(),
        Punch::parabola(2.0).unwrap(),
        Punch::wedge(0.3).unwrap(),
        Punch::power(2.7, 1.3, 0.1).unwrap(),
        Punch::power(1.3, 1.3, 0.1).unwrap(),
        Punch::power(3.0, 1.3, 0.1).unwrap(),
        Punch::polynomial(1.3, &[0.1, -0.02, 0.1]).unwrap(),
        Punch::rounded_flat(0.8, 3.0).unwrap(),
        Punch::table(&[(0.0, 0.1), (0.3, 0.2), (0.9, 0.5), (1.5, 1.9)]).unwrap(),
        Punch::table(&[(-1.6, 0.9), (-0.7, 0.3), (0.0, 0.1), (0.3, 0.2), (1.5, 1.9)]).unwrap(),
        Punch::uneven_wedge(0.5, 0.2).unwrap(),
        Punch::dent(0.2, 0.6).unwrap(),
    ]
}

/// In units none of which is 1.
fn profile(punch: &Punch, twin: Twin) -> PunchProfile<'_> {
    PunchProfile::new(punch, 0.7, 1.3, twin)
}

/// Intervals with x = 0 inside, and without.
fn intervals() -> impl Iterator<Item = Span> {
    let mut state = 771_983_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        -2.0 + (state >> 33) as f64 / (1u64 << 29) as f64
    };
    (0..12).map(move |_| [random(), random()]).map(|[l, r]| Span::anywhere(0.5 * (l + r), 0.5 * (r - l).abs()))
}

/// The rows by a rule of very many points, finest on either side of a tip.
fn brute(profile: &PunchProfile, span: Span, rows: usize) -> Vec<f64> {
    let points = 300_000;
    let mut sums = vec![0.0; rows];
    let tip = (-span.middle / span.half).clamp(-1.0, 1.0).acos();
    let places = [tip, tip - PI].into_iter().flat_map(|length| {
        let u = (0..points).map(move |q| (f64::from(q) + 0.5) / f64::from(points));
        u.map(move |u| (tip - length * u.powi(4), length.abs() * 4.0 * u.powi(3) / f64::from(points)))
    });
    for (theta, weight) in places {
        let slope = profile.slope(span.middle + span.half * theta.cos()) * weight;
        let (mut test, mut before) = (1.0, theta.cos());
        for sum in &mut sums {
            *sum += slope * test;
            (test, before) = (2.0 * theta.cos() * test - before, test);
        }
    }
    sums
}

#[test]
fn rows_are_integrals_of_the_slope() {
    for (punch, span) in punches().iter().flat_map(|punch| intervals().map(move |span| (punch, span))) {
        let profile = profile(punch, Twin::Plane);
        for (found, expected) in profile.rows(span, 18).iter().zip(brute(&profile, span, 18)) {
            assert!((found - expected).abs() < 3e-9, "{punch} {span:?}: {found} {expected}");
        }
    }
}

#[test]
fn about_the_middle_rows_of_odd_orders_are_those_of_all() {
    for punch in punches().iter().filter(|punch| punch.is_even()) {
        let [odd, all] =
            [Span::even(1.7), Span::anywhere(0.0, 1.7)].map(|span| profile(punch, Twin::Plane).rows(span, 18));
        for m in 0..9 {
            let (odd, even, all) = (odd[m], all[2 * m], all[2 * m + 1]);
            assert!((alternating(m) * odd - all).abs() < 1e-13, "{punch} {m}: {odd} {all}");
            assert!(even.abs() < 1e-13, "{punch} {m}");
        }
    }
}

/// About an axis rows of pieces follow from recurrences, which a rule in every piece does not know.
#[test]
fn about_an_axis_rows_of_pieces_are_integrals() {
    let punches = punches();
    for punch in punches.iter().filter(|punch| punch.is_even() && matches!(punch.shape(), Shape::Pieces { .. })) {
        let (profile, span, count) = (profile(punch, Twin::Round), Span::even(1.7), 400);
        let mut expected = Slopes { rows: vec![0.0; count], twin: Twin::Round };
        let phase = (2 * count) as f64 + profile.shape.degree();
        expected.add(2, count, &profile.between(span, &profile.not_smooth(span), phase));
        for (m, (found, expected)) in profile.rows(span, count).iter().zip(&expected.rows).enumerate() {
            assert!((found - expected).abs() < 1e-13, "{punch} {m}: {found} {expected}");
        }
    }
}

#[test]
fn rows_of_one_shape_are_the_same_however_it_is_written() {
    let parabola = Punch::parabola(2.0).unwrap();
    let others = [Punch::polynomial(1.5, &[1.5 * 1.5 / 4.0]).unwrap(), Punch::rounded_flat(0.0, 2.0).unwrap()];
    for (twin, other) in [Twin::Plane, Twin::Round].into_iter().flat_map(|twin| others.iter().map(move |o| (twin, o))) {
        let [found, expected] = [other, &parabola].map(|punch| profile(punch, twin).rows(Span::even(1.2), 6));
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-13, "{twin:?}: {found} {expected}");
        }
    }
}

#[test]
fn the_pressure_at_the_tip_is_the_sum_of_all_rows() {
    let (span, points) = (Span::even(1.7), 400_000);
    for (punch, twin) in punches().iter().flat_map(|punch| [(punch, Twin::Plane), (punch, Twin::Round)]) {
        let profile = profile(punch, twin);
        if !punch.is_even() || matches!(profile.shape, Shape::Powers { .. }) {
            continue;
        }
        let width = FRAC_PI_2 / f64::from(points);
        let places = (0..points).map(|q| profile.place(span, width * (f64::from(q) + 0.5), 0.5 * width));
        let (found, expected) = (profile.apex(1.7, 0), places.map(|(theta, value)| value / theta.cos()).sum::<f64>());
        assert!((found / expected - 1.0).abs() < 1e-6, "{punch} {twin:?}: {found} {expected}");
    }
    let [power, wedge] = [Punch::power(3.5, 1.3, 0.1).unwrap(), Punch::wedge(1.0).unwrap()];
    let power = profile(&power, Twin::Plane);
    let sum: f64 = power.rows(span, 4000).iter().sum();
    assert!((sum / power.apex(1.7, 0) - 1.0).abs() < 1e-6);
    assert_eq!(profile(&wedge, Twin::Plane).apex(1.0, 0), f64::INFINITY);
}

#[test]
fn corners_next_to_the_tip_take_no_digits_of_the_pressure_there() {
    for corner in [0.5, 1e-3, 1e-7] {
        let punch = Punch::rounded_flat(corner, 1.0).unwrap();
        // ∫ (2/cosh u − c) du up to where both are the same
        let end = (2.0 / corner).acosh();
        let (found, exact) =
            (PunchProfile::new(&punch, 1.0, 1.0, Twin::Plane).apex(2.0, 0), 2.0 * end.sinh().atan() - corner * end);
        assert!((found / exact - 1.0).abs() < 1e-13, "{corner}: {found} {exact}");
    }
}

#[test]
fn long_series_stay_exact() {
    // a flat punch whose corners are so far out that they hardly round it: ± 2 sin(kθ_c)/k dominates
    let punch = Punch::rounded_flat(1.0, 1.0).unwrap();
    let rows = PunchProfile::new(&punch, 1.0, 1.0, Twin::Plane).rows(Span::even(2.0), 2000);
    let corner = 0.5f64.acos();
    for m in [0, 10, 500, 1999] {
        let k = order(m);
        // ∫ (2 cos θ − 1) cos kθ dθ from 0 to θ_c, twice
        let sinc = |n: f64| if n == 0.0 { corner } else { (n * corner).sin() / n };
        let exact = 2.0 * (sinc(k - 1.0) + sinc(k + 1.0) - sinc(k));
        assert!((alternating(m) * rows[m] - exact).abs() < 1e-13, "{m}: {} {exact}", rows[m]);
    }
}
