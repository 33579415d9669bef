//! Known values, and identities that hold for all arguments.

use super::*;
use proptest::prelude::*;

/// n, z, J_n(z) from a multiple-precision evaluation.
#[rustfmt::skip]
const J: [(usize, f64, f64); 36] = [
(0, 0.001, 0.999_999_750_000_015_6),
(1, 0.001, 0.000_499_999_937_500_002_6),
(7, 0.001, 1.550_099_157_908_607_1e-27),
(31, 0.5, 2.631_905_208_612_420_6e-53),
(60, 0.5, 9.031_932_711_389_307e-119),
(120, 0.5, 8.456_348_395_462_305e-272),
(0, 2.5, -0.048_383_776_468_198),
(3, 2.5, 0.216_600_391_039_113_52),
(40, 2.5, 8.875_586_840_581_55e-45),
(0, 12.25, 0.100_930_610_510_515_1),
(11, 12.25, 0.281_967_114_141_266),
(47, 12.25, 1.734_281_956_892_744_6e-23),
(1, 24.875, -0.137_031_042_579_213_03),
(24, 24.875, 0.194_794_658_663_943_13),
(47, 24.875, 3.887_226_239_263_199_7e-10),
(0, 30.0, -0.086_367_983_581_040_21),
(25, 30.0, 0.084_292_740_643_031_73),
(47, 30.0, 5.195_857_554_916_298e-7),
(47, 47.5, 0.139_250_523_755_316_05),
(0, 48.0, -0.114_714_878_324_197_26),
(47, 48.0, 0.153_665_967_345_945_54),
(0, 100.0, 0.019_985_850_304_223_122),
(20, 100.0, 0.062_217_458_498_338_755),
(99, 100.0, 0.115_243_925_323_037_8),
(120, 100.0, 1.147_622_179_566_493_7e-5),
(150, 100.0, 2.722_902_171_882_048e-16),
(0, 1234.5, -0.013_550_379_618_035_721),
(47, 1234.5, -0.000_831_491_723_359_967_6),
(500, 1234.5, -0.007_467_455_321_614_187),
(999, 900.0, 8.123_229_921_728_249e-16),
(999, 1000.0, 0.048_830_228_770_221_78),
(0, 1000.0, 0.024_786_686_152_420_176),
(999, 300.0, 0.0),
(700, 300.0, 3.983_131_750_031_831_7e-181),
(0, 1000000.0, 0.000_331_043_013_739_873_76),
(999, 1000000.0, 0.000_479_024_940_638_236_6),
];

/// n, z, J_n(z), Y_n(z)
#[rustfmt::skip]
const JY: [(usize, f64, f64, f64); 8] = [
(0, 25.0, 0.096_266_783_275_958_11, -0.127_249_432_268_006_14),
(1, 25.0, -0.125_350_249_580_289_9, -0.098_829_964_783_237_41),
(20, 25.0, 0.051_994_049_228_303_23, 0.198_040_747_762_892_43),
(24, 25.0, 0.199_778_510_669_943_26, -0.179_658_076_056_343_82),
(0, 60.5, -0.102_552_724_780_990_84, -0.002_284_801_030_573_988),
(48, 60.5, -0.012_646_891_560_578_298, -0.130_720_312_809_094_05),
(0, 10000.0, -0.007_096_160_353_388_801_5, 0.003_647_805_558_986_605_8),
(59, 10000.0, -0.002_363_849_091_777_548, -0.007_620_715_366_296_334),
];

/// n, Re z, Im z, and the parts of exp(-iz) H_n(z)
#[rustfmt::skip]
const H: [(usize, f64, f64, f64, f64); 7] = [
(0, 25.0, 0.0, 0.112_261_591_331_799_94, -0.113_388_917_829_222_22),
(1, 25.0, 0.5, -0.112_331_356_220_166_7, -0.113_454_185_747_189_99),
(20, 25.0, 10.0, 3.484_907_499_933_714, -1.464_456_938_773_119),
(0, 48.0, 48.0, 0.036_896_279_037_921_19, -0.089_401_182_030_414_49),
(38, 48.0, 0.25, 0.143_951_322_163_687_9, -0.074_341_892_012_056_57),
(30, 100.0, 700.0, -0.009_011_651_758_044_166, 0.055_573_282_117_524_41),
(47, 1000.0, 1.0, -0.007_918_363_314_753_717, 0.024_000_692_230_027_123),
];

#[test]
fn known_values() {
    // Each argument in a table of its own, and all of them in one table of mixed blocks.
    let arguments: Vec<f64> = J.iter().map(|row| row.1).collect();
    let mut all = vec![f64::NAN; 1000 * arguments.len()];
    table(1000, &arguments, &mut all);
    for (i, &(n, z, exact)) in J.iter().enumerate() {
        let mut own = vec![f64::NAN; n + 1];
        table(n + 1, &[z], &mut own);
        for value in [own[n], all[n * arguments.len() + i]] {
            let tolerance = if n as f64 > z { 1e-13 * exact.abs() } else { 2e-15 };
            assert!((value - exact).abs() <= tolerance, "J_{n}({z}) = {value:e}, not {exact:e}");
        }
    }
}

#[test]
fn zero_and_almost_zero() {
    let arguments = [0.0, 5e-324, 1e-300, 1e-291, 1e-289, 1e-200, 1e-100, 1e-9];
    let length = arguments.len();
    let mut j = vec![f64::NAN; 50 * length];
    table(50, &arguments, &mut j);
    for (i, z) in arguments.iter().enumerate() {
        assert_eq!(j[i], 1.0);
        assert!((j[length + i] - 0.5 * z).abs() <= 1e-15 * z + 1e-290);
        assert!((j[2 * length + i] - 0.125 * z * z).abs() <= 1e-15 * z * z + 1e-290);
        assert!((3..50).all(|n| (0.0..1e-28).contains(&j[n * length + i])));
    }
}

#[test]
fn shapes() {
    table(0, &[1.0, 2.0], &mut []);
    table(3, &[], &mut []);
    jy_table(Kind::Integer, 2, &[], &mut [], &mut []);
    hankel_table(Kind::Integer, 0, &[Complex64::new(30.0, 0.0)], &mut []);
    let mut one = [f64::NAN];
    for z in [0.0, 3.0, 80.0] {
        table(1, &[z], &mut one);
        assert!(one[0].is_finite());
    }
}

proptest! {
    /// J_0 + 2 (J_2 + J_4 + ...) = 1 normalises one branch only; J_0^2 + 2 (J_1^2 + J_2^2 + ...) = 1 examines both.
    #[test]
    fn squares_sum_to_one(arguments in prop::collection::vec((-5.0f64..2.7).prop_map(|e| 10f64.powf(e)), 1..20)) {
        let length = arguments.len();
        for orders in [600, 700] {
            let mut j = vec![f64::NAN; orders * length];
            table(orders, &arguments, &mut j);
            for i in 0..length {
                let squares: f64 = (1..orders).map(|n| j[n * length + i].powi(2)).sum();
                prop_assert!((j[i].powi(2) + 2.0 * squares - 1.0).abs() < 5e-14);
                let even: f64 = (2..orders).step_by(2).map(|n| j[n * length + i]).sum();
                prop_assert!((j[i] + 2.0 * even - 1.0).abs() < 5e-14);
            }
        }
    }

    /// The number of orders asked for decides on the branch, but not on the value; nor do the neighbours.
    #[test]
    fn values_do_not_depend_on_the_company(z in 0.0f64..200.0, others in prop::collection::vec(0.0f64..1e6, 7)) {
        let mut lone = vec![f64::NAN; 300];
        table(300, &[z], &mut lone);
        let mut arguments = others.clone();
        arguments.insert(3, z);
        for orders in [1, 20, 150] {
            let mut j = vec![f64::NAN; orders * 8];
            table(orders, &arguments, &mut j);
            for n in 0..orders {
                prop_assert!((j[n * 8 + 3] - lone[n]).abs() < 2e-15);
            }
        }
    }

    /// J_{n+1} Y_n - J_n Y_{n+1} = 2/(pi z)
    #[test]
    fn wronskian(z in (25f64.ln()..1e6f64.ln()).prop_map(f64::exp)) {
        let orders = (z as usize).min(300);
        let (mut j, mut y) = (vec![f64::NAN; orders], vec![f64::NAN; orders]);
        jy_table(Kind::Integer, orders, &[z], &mut j, &mut y);
        let mut same = vec![f64::NAN; orders];
        table(orders, &[z], &mut same);
        for n in 0..orders - 1 {
            prop_assert!((0.5 * std::f64::consts::PI * z * (j[n + 1] * y[n] - j[n] * y[n + 1]) - 1.0).abs() < 2e-13);
            prop_assert!((j[n] - same[n]).abs() < 2e-15);
        }
    }

    /// The Hankel functions on the real axis are J + iY.
    #[test]
    fn hankel_functions_join_the_real_axis(z in 25.0f64..1e4) {
        let orders = (0.8 * z.min(100.0)) as usize;
        for (kind, tolerance) in [(Kind::Integer, 1e-14), (Kind::Spherical, 3e-14)] {
            let (mut j, mut y) = (vec![f64::NAN; orders], vec![f64::NAN; orders]);
            jy_table(kind, orders, &[z], &mut j, &mut y);
            let mut h = vec![Complex64::ZERO; orders];
            hankel_table(kind, orders, &[Complex64::from(z)], &mut h);
            for n in 0..orders {
                let joined = h[n] * Complex64::cis(z);
                prop_assert!((joined - Complex64::new(j[n], y[n])).norm() < tolerance * joined.norm());
            }
        }
    }
}

#[test]
fn known_values_of_the_second_kind() {
    for (n, z, exact_j, exact_y) in JY {
        let (mut j, mut y) = (vec![f64::NAN; n + 1], vec![f64::NAN; n + 1]);
        jy_table(Kind::Integer, n + 1, &[z], &mut j, &mut y);
        assert!((j[n] - exact_j).hypot(y[n] - exact_y) < 1e-14 * exact_j.hypot(exact_y), "order {n} at {z}");
    }
    for (n, x, y, re, im) in H {
        let mut h = vec![Complex64::ZERO; n + 1];
        hankel_table(Kind::Integer, n + 1, &[Complex64::new(x, y)], &mut h);
        let exact = Complex64::new(re, im);
        assert!((h[n] - exact).norm() < 1e-14 * exact.norm(), "order {n} at {x} + {y}i");
    }
}

#[test]
fn deficit_keeps_its_digits() {
    let known = [
        (1.0e-8, -1.25e-17),
        (0.001, -1.249_999_947_916_667_7e-7),
        (0.1, -0.001_249_479_275_160_049),
        (1.0, -0.119_898_828_510_132_96),
        (1.999_9, -0.423_239_909_077_660_46),
        (2.0, -0.423_275_192_243_126_6),
        (3.5, -0.921_498_555_792_955_9),
        (24.0, -1.012_836_505_431_926_8),
        (26.0, -0.998_842_636_108_698_8),
        (1000.0, -0.999_990_543_376_185_9),
    ];
    for (z, exact) in known {
        assert!((jinc_minus_one(z) / exact - 1.0).abs() < 1e-15, "at {z}");
        assert_eq!(jinc_minus_one(-z), jinc_minus_one(z));
    }
}

#[test]
fn some_orders_of_a_table_are_those_of_all() {
    let arguments: Vec<f64> = (0..37).map(|k| 0.03 * f64::from(k * k)).collect();
    let count = arguments.len();
    for orders in [0, 1, 2, 9, 30] {
        let mut all = vec![0.0; orders * count];
        scaled_orders(orders, Wanted::ALL, &arguments, 0.7, count, &mut all);
        for wanted in [Wanted::ALL, Wanted::ZERO_AND_ODD] {
            let mut some = vec![0.0; wanted.below(orders) * count];
            scaled_orders(orders, wanted, &arguments, 0.7, count, &mut some);
            let columns: Vec<&[f64]> = all.chunks(count).collect();
            assert_eq!(some, wanted.of(&columns).copied().collect::<Vec<_>>().concat(), "{orders} {wanted:?}");
        }
    }
}
