//! A homogeneous layer of any material: fields symmetric and antisymmetric about mid-depth, without slices.
//!
//! With e = (U, S), o = (V, T) and ζ = λy from mid-depth upwards the state equations read e' = B o, o' = C e. Of symmetric
//! fields o = C f e, of antisymmetric ones e = B f o, where f = tanh(√K ζ)/√K with K = B C, or C B. Functions of K are
//! combinations of the identity and the adjugate of K, since K has two rows only, and f(2ζ) = 2 f/(1 + K f²) leads from a
//! thin layer to any other. No root of the material is computed, so that roots may coincide or be complex; hardly any
//! difference is formed, so that a layer may be thin for one pair of roots and thick for the other.
use nalgebra::{Matrix2, Matrix4, Vector2};

use super::surface::{Coefficients, surface_states};
use super::{FELT, THIN};
use crate::{FaceStates, Flexibility, InnerStates, LayerStates, Material, State, Wave};

/// Power series are summed up to this length in decay lengths of the faster field, where [`TERMS`] reach rounding.
const SERIES: f64 = 0.5;
/// (1/2)^18/18! is below rounding.
const TERMS: u32 = 9;
/// Above this thickness, in decay lengths of the slower field, amplitudes multiply fields that decay from one face. Below
/// it these fields are too similar; far above it, the difference of symmetric and antisymmetric fields would be rounding.
const DECAYING: f64 = 1.0;

/// one + adjugate · adj K, a function of the matrix K.
#[derive(Clone, Copy, Default)]
struct Function {
    one: f64,
    adjugate: f64,
}

const ONE: Function = Function { one: 1.0, adjugate: 0.0 };

impl Function {
    fn plus(self, other: Self) -> Self {
        Self { one: self.one + other.one, adjugate: self.adjugate + other.adjugate }
    }

    fn times(self, factor: f64) -> Self {
        Self { one: self.one * factor, adjugate: self.adjugate * factor }
    }
}

/// A homogeneous layer at one wavenumber.
pub(super) struct Homogeneous<'a> {
    material: &'a Material,
    modulus: f64,
    coefficients: Coefficients,
    /// Trace and determinant of K: sum and product of the squared roots.
    trace: f64,
    determinant: f64,
    /// λh/2.
    half: f64,
    /// Decay rates of the faster and the slower field.
    rates: [f64; 2],
}

/// tanh(√K t)/√K, and 1/cosh(√K t).
#[derive(Clone, Copy)]
struct Section {
    tanh: Function,
    sech: Function,
}

impl<'a> Homogeneous<'a> {
    pub fn new(material: &'a Material, wave: &Wave, thickness: f64) -> Self {
        let coefficients = Coefficients::new(material, wave.modulus);
        let Coefficients { m, c, d, e } = coefficients;
        let fastest = material.squared_roots().iter().fold(1.0, |s: f64, root| s.max(root.norm().sqrt()));
        Self {
            material,
            modulus: wave.modulus,
            coefficients,
            trace: e * m - 2.0 * c,
            determinant: c * c + e * d,
            half: 0.5 * wave.wavenumber * thickness,
            rates: [fastest, material.slowest_decay()],
        }
    }

    /// Whether no field decays in the layer, so that the state at one depth serves for amplitudes.
    pub fn is_thin(&self) -> bool {
        2.0 * self.half * self.rates[0] <= THIN
    }

    /// λμ₀C under loads on both faces, first equal and then opposite ones, of which neither is a difference.
    pub fn flexibility(&self) -> Flexibility {
        let slowest = self.rates[1];
        // beyond FELT nothing changes
        let length = if self.half * slowest > FELT { FELT / slowest } else { self.half };
        let Section { tanh: f, sech } = self.section(length);
        let Coefficients { e, .. } = self.coefficients;
        let equal = self.determinant * self.norm(f) / (e * f.one);
        let opposite = (e * f.adjugate).recip();
        let coupling = if 2.0 * self.half * slowest < DECAYING {
            0.5 * (equal - opposite)
        } else if self.half * slowest > FELT {
            0.0
        } else {
            // the same difference in 1 − tanh² = 1/cosh²
            let square = self.times(sech, sech);
            let left =
                square.adjugate * (f.one + self.trace * f.adjugate) + f.adjugate * (square.one - self.norm(square));
            -0.5 * left / (self.norm(f) * e * f.one * f.adjugate)
        };
        let top = 0.5 * (equal + opposite);
        Flexibility { top, coupling, bottom: -top, equal_top: equal, equal_bottom: -equal }
    }

    /// States at the faces and at depths, given as λd.
    pub fn states(&self, depths: impl Iterator<Item = f64>) -> LayerStates {
        if 2.0 * self.half * self.rates[1] >= DECAYING { self.decaying(depths) } else { self.parities(depths) }
    }

    /// Amplitudes = S and T on the top face of fields that decay downwards, then on the bottom face of fields that decay
    /// upwards.
    fn decaying(&self, depths: impl Iterator<Item = f64>) -> LayerStates {
        let thickness = 2.0 * self.half;
        let mirror = Matrix4::from_diagonal(&State::new(1.0, -1.0, 1.0, -1.0));
        let columns = |depth: f64| {
            let down = surface_states(self.material, self.modulus, depth);
            let up = mirror * surface_states(self.material, self.modulus, (thickness - depth).max(0.0));
            super::clamped::beside(&down, &up)
        };
        let inside = depths.map(|depth| InnerStates::thick(columns(depth))).collect();
        LayerStates { faces: FaceStates::thick(columns(0.0), columns(thickness)), inside }
    }

    /// Amplitudes = U and S on the faces of symmetric fields, V and T on the faces of antisymmetric ones.
    fn parities(&self, depths: impl Iterator<Item = f64>) -> LayerStates {
        let whole = self.section(self.half);
        let inside = depths.map(|depth| {
            let from_middle = (self.half - depth).clamp(-self.half, self.half);
            let [inner, outer] = [from_middle.abs(), self.half - from_middle.abs()].map(|t| self.section(t));
            // cosh of the sum of two arguments
            let sum = self.times_k(self.times(inner.tanh, outer.tanh));
            let share = self.times(outer.sech, self.inverse(ONE.plus(sum)));
            self.inner(&inner, share, from_middle.signum())
        });
        let [top, bottom] = [1.0, -1.0].map(|side| self.inner(&whole, ONE, side));
        let inside = inside.collect();
        let faces =
            FaceStates::Finite { top: top.columns, bottom: bottom.columns, uniform: [top.uniform, bottom.uniform] };
        LayerStates { faces, inside }
    }

    /// States above (1) or below (−1) the middle, where the even part of a symmetric field and the odd part of an antisymmetric one
    /// are these shares of their values on the faces. The field close to uniform pressure is symmetric, with S = 1 on the faces.
    fn inner(&self, section: &Section, share: Function, side: f64) -> InnerStates {
        let Coefficients { m, c, d, e } = self.coefficients;
        let adjugate = Matrix2::new(-c, -(d + m * c), e, m * e - c);
        // of C B the matrix K itself
        let k = Matrix2::new(m * e - c, d + m * c, -e, -c);
        let of =
            |function: Function, matrix: &Matrix2<f64>| Matrix2::identity() * function.one + matrix * function.adjugate;
        let [b, c] = [Matrix2::new(1.0, m, 0.0, -1.0), Matrix2::new(-c, d, e, c)];
        let Function { one, adjugate: f } = section.tanh;
        let even = of(share, &adjugate);
        let odd = of(share, &k);
        // C adj K = B det K, B adj(C B) = C
        let of_even = (c * one + b * (f * self.determinant)) * even * side;
        let of_odd = (b * one + c * f) * odd * side;
        let place = |pair: Matrix2<f64>, i: usize, j: usize| pair[(i / 2, j)];
        let columns = Matrix4::from_fn(|i, j| match (i % 2 == 0, j < 2) {
            (true, true) => place(even, i, j),
            (false, true) => place(of_even, i, j),
            (true, false) => place(of_odd, i, j - 2),
            (false, false) => place(odd, i, j - 2),
        });
        let close =
            Vector2::new(share.adjugate * adjugate[(0, 1)], share.one - 1.0 + share.adjugate * adjugate[(1, 1)]);
        let uniform = State::new(close[0], columns[(1, 1)], close[1], columns[(3, 1)]);
        InnerStates { columns, uniform }
    }

    /// Between mid-depth and t = λy above it.
    fn section(&self, t: f64) -> Section {
        let [fastest, slowest] = self.rates;
        let length = t * fastest;
        let doublings = if length > SERIES { (length / SERIES).log2().ceil() as i32 } else { 0 };
        let mut t = t / 2f64.powi(doublings);
        let (mut section, mut lack) = self.thin_section(t);
        for _ in 0..doublings {
            let Section { tanh, sech } = section;
            let square = self.times(tanh, tanh);
            let inverse = self.inverse(ONE.plus(self.times_k(square)));
            section.tanh = self.times(tanh, inverse).times(2.0);
            section.sech = if t * slowest > 0.5 * DECAYING {
                self.times(self.times(sech, sech), inverse)
            } else {
                lack = self.times(square.plus(self.times(lack, ONE.plus(sech))), inverse);
                ONE.plus(self.times_k(lack).times(-1.0))
            };
            t *= 2.0;
        }
        section
    }

    /// The same by power series, and (1 − 1/cosh(√K t))/K. What is near 1 would double its relative error each time it is squared.
    fn thin_section(&self, t: f64) -> (Section, Function) {
        let (mut cosh, mut sinh) = (Function::default(), Function::default());
        // K^n t^(2n)/(2n)!
        let mut term = ONE;
        for n in 0..TERMS {
            let odd = t / f64::from(2 * n + 1);
            let factor = t * odd / f64::from(2 * n + 2);
            sinh = sinh.plus(term.times(odd));
            // (cosh(√K t) − 1)/K
            cosh = cosh.plus(term.times(factor));
            term = self.times_k(term).times(factor);
        }
        let inverse = self.inverse(ONE.plus(self.times_k(cosh)));
        let lack = self.times(cosh, inverse);
        let sech = ONE.plus(self.times_k(lack).times(-1.0));
        (Section { tanh: self.times(sinh, inverse), sech }, lack)
    }

    fn times(&self, a: Function, b: Function) -> Function {
        let both = a.adjugate * b.adjugate;
        Function {
            one: a.one * b.one - both * self.determinant,
            adjugate: a.one * b.adjugate + a.adjugate * b.one + both * self.trace,
        }
    }

    /// Times K = tr K − adj K.
    fn times_k(&self, a: Function) -> Function {
        Function { one: self.trace * a.one + self.determinant * a.adjugate, adjugate: -a.one }
    }

    fn inverse(&self, a: Function) -> Function {
        let factor = self.norm(a).recip();
        Function { one: (a.one + a.adjugate * self.trace) * factor, adjugate: -a.adjugate * factor }
    }

    /// The determinant.
    fn norm(&self, a: Function) -> f64 {
        a.one * (a.one + self.trace * a.adjugate) + a.adjugate * a.adjugate * self.determinant
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::conformance::{size_over, work};
    use crate::{ClosedForm, EngineeringConstants, Isotropic, Plane};

    fn entries(c: &Flexibility) -> [f64; 5] {
        [c.top, c.coupling, c.bottom, c.equal_top, c.equal_bottom]
    }

    fn wave(wavenumber: f64) -> Wave {
        Wave { wavenumber, modulus: 1.0, plane: Plane::Strain }
    }

    /// λh from 1e-8 to 1e8.
    fn lengths() -> impl Iterator<Item = f64> {
        (-64..=64).map(|k| 10f64.powf(0.125 * f64::from(k)))
    }

    /// Materials with moduli of all sizes.
    fn materials() -> impl Strategy<Value = Material> {
        let modulus = || (-3.0..3.0f64).prop_map(|power| 10f64.powf(power));
        let part = || -0.6..0.6f64;
        ([modulus(), modulus(), modulus()], modulus(), [part(), part(), part()]).prop_filter_map(
            "a legal material",
            |([x, y, z], shear_modulus, [xy, xz, yz])| {
                let poisson = [xy * (x / y).sqrt(), xz * (x / z).sqrt(), yz * (y / z).sqrt()];
                Some(EngineeringConstants::new([x, y, z], poisson, shear_modulus).ok()?.material(Plane::Strain))
            },
        )
    }

    #[test]
    fn isotropic_constants_make_an_isotropic_layer() {
        for poisson in [-0.9, 0.0, 0.3, 0.5] {
            let layer = crate::Homogeneous::new(1.0, 2.0, poisson).expect("legal");
            let material = Isotropic { shear_modulus: 2.0, poisson }.material(Plane::Strain);
            for z in lengths() {
                let expected = ClosedForm::flexibility(&layer, &wave(z)).expect("two faces");
                let found = Homogeneous::new(&material, &wave(z), 1.0).flexibility();
                for (found, expected) in entries(&found).into_iter().zip(entries(&expected)) {
                    // the coupling of faces that do not feel each other
                    let unfelt = 100.0 * (-2.0 * FELT).exp() / material.axial_stiffness;
                    // e^(−z) has the relative error of z, times z
                    let rounding = 1e-13 + 4.0 * f64::EPSILON * z.min(100.0);
                    assert!((found - expected).abs() <= rounding * expected.abs() + unfelt, "{poisson} {z:e}");
                }
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

        /// s⁴ − (em − 2c) s² + c² + ed = 0, and of fields symmetric or antisymmetric about mid-depth
        /// λC = s₁s₂ tanh s₁t tanh s₂t/(eγ) and 1/(eδ).
        #[test]
        fn flexibilities_are_those_of_the_roots(material in materials()) {
            let [fast, slow] = material.squared_roots().map(|root| root.sqrt());
            prop_assume!(fast.im == 0.0 && fast.re > 3.0 * slow.re);
            let (fast, slow, e) = (fast.re, slow.re, material.axial_stiffness);
            for z in lengths().filter(|z| slow * z > 0.3) {
                let [a, b] = [fast, slow].map(|root| (0.5 * root * z).tanh());
                let squares = fast * fast - slow * slow;
                let equal = fast * slow * a * b * squares / (e * (fast * a - slow * b));
                let opposite = squares / (e * (b / slow - a / fast));
                let found = Homogeneous::new(&material, &wave(z), 1.0).flexibility();
                prop_assert!((found.equal_top / equal - 1.0).abs() < 1e-12, "{} {}", found.equal_top, equal);
                prop_assert!((found.top / (0.5 * (equal + opposite)) - 1.0).abs() < 1e-12);
                // e^(−s z) decays to its own digits
                let expected = 0.5 * (equal - opposite);
                prop_assert!((found.coupling - expected).abs() < 1e-12 * expected.abs() + 1e-14 * equal.max(opposite));
            }
        }

        /// Long waves bend the layer as a plate, and equal pressures stretch it.
        #[test]
        fn long_waves_see_a_plate(material in materials()) {
            let Material { normal_compliance: d, coupling: c, axial_stiffness: e, .. } = material;
            let fastest = material.squared_roots()[0].norm().sqrt().max(1.0);
            for part in lengths().filter(|part| *part < 1e-6) {
                let z = part / fastest;
                let found = Homogeneous::new(&material, &wave(z), 1.0).flexibility();
                prop_assert!((found.top * e * z.powi(3) / 12.0 - 1.0).abs() < 1e-11);
                prop_assert!((found.coupling / found.top + 1.0).abs() < 1e-11);
                prop_assert!((found.equal_top / (0.5 * z * (c * c / e + d)) - 1.0).abs() < 1e-11);
                prop_assert_eq!(found.equal_bottom, -found.equal_top);
            }
        }

        /// Amplitudes of all three kinds make the same fields: the fields that the closed flexibility tells, and, with mid-depth as a face,
        /// the fields of two halves on each other.
        #[test]
        fn states_are_those_of_the_flexibility(material in materials()) {
            for z in lengths() {
                let layer = Homogeneous::new(&material, &wave(z), 1.0);
                if layer.is_thin() {
                    continue;
                }
                let states = layer.states([0.0, 0.5 * z, z].into_iter());
                let FaceStates::Finite { top, bottom, .. } = &states.faces else { unreachable!() };
                prop_assert!((states.inside[0].columns - top).amax() <= 1e-13 * top.amax());
                prop_assert!((states.inside[2].columns - bottom).amax() <= 1e-13 * bottom.amax());
                let expected = layer.flexibility();
                let found = Flexibility::of_face_states(&states.faces);
                prop_assert!(found.is_some());
                let found = found.unwrap_or(expected);
                prop_assert!((found.top / expected.top - 1.0).abs() < 1e-11, "{z:e} {} {}", found.top, expected.top);
                prop_assert!((found.bottom / expected.bottom - 1.0).abs() < 1e-11);
                prop_assert!((found.coupling - expected.coupling).abs() < 1e-11 * expected.top);
                // Betti between a face and mid-depth, which feel each other
                if z * material.slowest_decay() > 2.0 * FELT {
                    continue;
                }
                let middle = &states.inside[1].columns;
                for (i, j) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
                    let pair = |states: &Matrix4<f64>| [i, j].map(|column| State::from(states.column(column)));
                    let [[one, two], [inside, other]] = [top, middle].map(pair);
                    let size = size_over(&[one], &[two]) + size_over(&[inside], &[other]);
                    prop_assert!((work(&one, &two) - work(&inside, &other)).abs() <= 1e-11 * size, "{z:e} {i} {j}");
                }
            }
        }
    }
}
