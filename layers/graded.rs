//! The general body: face states of any layer from its [`Material`] alone, by integrating the state equations.
//!
//! The layer is cut into slices, so thin that the wave (λδ) and the material hardly change in one. A slice's transfer
//! matrix, less identity, follows from Picard iteration on Gauss points: every entry keeps its own order in λδ, and
//! with it all its digits. Three ways lead from the slices to the faces:
//!
//! * *thin*: amplitudes = the state at one depth; the transfer matrices are multiplied as X − 1.
//! * *thick*: amplitudes = the stresses on one face while the other is clamped; the flexibility seen from a face is
//!   carried from slice to slice, so that nothing grows.
//! * *deep*: the faces do not feel each other; each is the surface of a half-plane.
use std::sync::LazyLock;

use nalgebra::{Matrix2, Matrix4, Matrix4x2, RowSVector, SMatrix, SVector};

use crate::{FaceStates, Layer, Material, Plane, State, Wave};

/// Gauss points per slice: collocation on them is exact to order 2·10 at the end of a slice.
const NODES: usize = 10;
/// A slice's largest λδ, in units of the material's own decay length.
const LENGTH: f64 = 1.0;
/// A material counts as resolved when the last Legendre coefficients on a slice are this small: their squares, which
/// is what Gauss points leave, are below rounding.
const RESOLVED: f64 = 1e-9;
/// The polynomial through the Gauss points must also meet the material at the ends of a slice, as closely as this: a
/// thin skin or a jump might hide there. The ends proper may belong to the neighbours.
const MET: f64 = 1e-8;
const ENDS: [f64; 2] = [1e-13, 1.0 - 1e-13];
/// Slices around a jump of the material are halved down to this part of the thickness.
const THINNEST: f64 = 1e-14;
/// A material that is still not resolved after so many slices is taken as it is.
const MANY: usize = 10_000;
/// A slice that is too long all the same is not iterated forever.
const MOST_SWEEPS: f64 = 100.0;
/// Up to this length, in decay lengths of the material, a layer is thin: it bends and translates almost freely.
const THIN: f64 = 2.0;
/// Beyond this length, in decay lengths, nothing is felt: e^(−2·30) is below rounding, squared once more.
const FELT: f64 = 30.0;
/// Above this a layer counts as thick whatever its length, see [`Clamped::independence`].
const INDEPENDENT: f64 = 0.01;
/// A modulus that varies by less than this factor is no reason to leave mid-depth.
const MILD: f64 = 3.0;

/// Face states of any layer, from [`Layer::thickness`] and [`Layer::material`]: the provided body of
/// [`Layer::face_states`], and what an override is examined against.
///
/// Relative accuracy of the flexibility: 1e-12 for any λh and a smooth modulus that varies by up to e^±30; of the
/// response to equal loads 1e-10, or 1e-8 if the layer is as steep as that and incompressible. Jumps of the material
/// are found, at the cost of some fifty slices each; two layers are better. A feature much thinner than 1/(100 λ) and
/// than h/200 is found only where it meets a face.
///
/// ```
/// use recede_layers::{Exponential, Flexibility, Layer, Plane, Wave, graded};
/// let layer = Exponential::new(1.0, 1.0, 0.25, -2.0)?;
/// let wave = Wave { wavenumber: 3.0, modulus: 1.0, plane: Plane::Strain };
/// let general = Flexibility::of_face_states(&graded::face_states(&layer, &wave)).expect("has two faces");
/// let closed_form = layer.flexibility(&wave).expect("has two faces");
/// assert!((general.top / closed_form.top - 1.0).abs() < 1e-12);
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
pub fn face_states(layer: &(impl Layer + ?Sized), wave: &Wave) -> FaceStates {
    let material = |depth| layer.material(depth, wave.plane);
    Profile { thickness: layer.thickness(), material: &material }.face_states(wave)
}

/// All that the general body knows of a layer.
#[derive(Clone, Copy)]
pub(crate) struct Profile<'a> {
    /// As [`Layer::thickness`].
    pub thickness: Option<f64>,
    /// The material at a depth.
    pub material: &'a dyn Fn(f64) -> Material,
}

impl Profile<'_> {
    pub(crate) fn face_states(&self, wave: &Wave) -> FaceStates {
        let Some(thickness) = self.thickness else {
            return FaceStates::HalfPlane { top: self.surface(wave) };
        };
        let mirrored = |depth: f64| (self.material)((thickness - depth).max(0.0));
        let mirrored = Profile { thickness: self.thickness, material: &mirrored };
        let mut slices = self.slices(wave, FELT);
        if slices.depth < thickness {
            if slices.depth + mirrored.slices(wave, FELT).depth <= thickness {
                return deep(self.surface(wave), mirrored.surface(wave));
            }
            slices = self.slices(wave, f64::INFINITY);
        }
        let thick = Clamped::new(&slices.list);
        let length = slices.list.iter().map(|slice| slice.length).sum::<f64>();
        if length > THIN {
            thick.face_states([-State::z(), -State::z()])
        } else if thick.independence() > INDEPENDENT {
            thick.face_states(uniform(&slices.list))
        } else {
            thin(&slices.list)
        }
    }

    /// ∫ f dy over the thickness for each of the functions of (material, depth), with the points that resolve the
    /// material; zero for a half-plane.
    pub(crate) fn integrate<const N: usize>(&self, f: impl Fn(&Material, f64) -> [f64; N]) -> [f64; N] {
        let mut sums = [0.0; N];
        let Some(thickness) = self.thickness else { return sums };
        let still = Wave { wavenumber: 0.0, modulus: 1.0, plane: Plane::Strain };
        let mut from = 0.0;
        for slice in self.slices(&still, f64::INFINITY).list {
            for (t, weight) in RULE.nodes.iter().zip(RULE.weights.iter()) {
                let depth = from + (1.0 - t) * slice.thickness;
                for (sum, value) in sums.iter_mut().zip(f(&(self.material)(depth), depth)) {
                    *sum += weight * slice.thickness * value;
                }
            }
            from = (from + slice.thickness).min(thickness);
        }
        sums
    }

    /// Slices from the top face down to the bottom or to where `felt` decay lengths are passed; in a half-plane also
    /// to where the material is so stiff that it does not move.
    fn slices(&self, wave: &Wave, felt: f64) -> Slices {
        let end = self.thickness.unwrap_or(f64::INFINITY);
        let largest = (1.0 / wave.wavenumber).min(0.5 * end);
        let thinnest = THINNEST * largest;
        let mut slices = Slices { list: Vec::new(), depth: 0.0 };
        let (mut decay, mut softest) = (0.0, 0.0_f64);
        let mut guess = largest;
        while slices.depth < end && decay < felt {
            let left = end - slices.depth;
            // what is left is shared evenly if a second slice would do
            let mut thickness = if guess >= left { left } else { guess.min(0.5 * left).max(thinnest.min(left)) };
            let mut points = Points::new(self, wave, slices.depth, thickness);
            while !points.resolved(wave.wavenumber * thickness) && thickness > thinnest && slices.list.len() < MANY {
                thickness *= 0.5;
                points = Points::new(self, wave, slices.depth, thickness);
            }
            slices.depth = if thickness >= left { end } else { slices.depth + thickness };
            let zeta = wave.wavenumber * thickness;
            decay += zeta * points.slowest();
            if self.thickness.is_none() {
                softest = softest.max(points.shear[NODES - 1]);
                decay = decay.max(0.5 * (softest / points.shear[0]).ln());
            }
            slices.list.push(Slice {
                thickness,
                length: zeta * points.fastest(),
                softness: points.shear.mean(),
                transfer: points.transfer(zeta),
            });
            guess = (2.0 * thickness).min(largest);
        }
        slices
    }

    /// Two columns (λμ₀U, λμ₀V, S, T) at the top face of a layer whose bottom is not felt, for S = 1 and for T = 1.
    fn surface(&self, wave: &Wave) -> Matrix4x2<f64> {
        let slices = self.slices(wave, FELT);
        let depth = slices.depth.min(self.thickness.unwrap_or(f64::INFINITY));
        let mut seen = Seen { flexibility: surface_flexibility(&(self.material)(depth), wave.modulus), far: None };
        for slice in slices.list.iter().rev() {
            seen = seen.through(&slice.transfer);
        }
        seen.states()
    }
}

/// The flexibility of a homogeneous half-plane: (λμ₀U, λμ₀V) at its top face from (S, T) on it.
///
/// With the roots s₁, s₂ of s⁴ − (em − 2c) s² + c² + ed = 0 (coefficients in units of μ₀) only s₁s₂ and s₁ + s₂ enter,
/// so that coalescing or complex roots need no care.
pub(crate) fn surface_flexibility(material: &Material, modulus: f64) -> Matrix2<f64> {
    let Coefficients { m, c, d, e } = Coefficients::new(material, modulus);
    let product = (c * c + e * d).sqrt();
    let sum = (e * m - 2.0 * c + 2.0 * product).sqrt();
    let cross = if c > 0.0 { d / (product + c) } else { (product - c) / e };
    Matrix2::new(cross, sum / e, product * sum / e, cross)
}

/// The coefficients of the state equations for (λμ₀U, λμ₀V, S, T).
#[derive(Clone, Copy)]
struct Coefficients {
    m: f64,
    c: f64,
    d: f64,
    e: f64,
}

impl Coefficients {
    fn new(material: &Material, modulus: f64) -> Self {
        Self {
            m: material.shear_compliance * modulus,
            c: material.coupling,
            d: material.normal_compliance * modulus,
            e: material.axial_stiffness / modulus,
        }
    }
}

/// Gauss points t on [0, 1] with what is needed to integrate on them.
struct Rule {
    nodes: [f64; NODES],
    weights: RowSVector<f64, NODES>,
    /// Row i: ∫ from 0 to t_i of the interpolating polynomial.
    integral: SMatrix<f64, NODES, NODES>,
    /// The two highest Legendre coefficients of the interpolating polynomial.
    highest: SMatrix<f64, 2, NODES>,
    /// Values of the interpolating polynomial at [`ENDS`].
    ends: SMatrix<f64, 2, NODES>,
}

static RULE: LazyLock<Rule> = LazyLock::new(Rule::new);

impl Rule {
    fn new() -> Self {
        let mut nodes = [0.0; NODES];
        let mut weights = RowSVector::zeros();
        let mut tables = [[0.0; NODES + 1]; NODES];
        for i in 0..NODES {
            let mut x = -(std::f64::consts::PI * (i as f64 + 0.75) / (NODES as f64 + 0.5)).cos();
            let slope = |x: f64, p: &[f64]| NODES as f64 * (p[NODES - 1] - x * p[NODES]) / (1.0 - x * x);
            for _ in 0..8 {
                let p = legendre(x);
                x -= p[NODES] / slope(x, &p);
            }
            tables[i] = legendre(x);
            nodes[i] = 0.5 * (1.0 + x);
            weights[i] = 1.0 / ((1.0 - x * x) * slope(x, &tables[i]).powi(2));
        }
        // coefficient k of the polynomial through f: (2k + 1) Σ w f P_k, with Σ w = 1
        let coefficient = |k: usize, j: usize| (2 * k + 1) as f64 * weights[j] * tables[j][k];
        let integral = SMatrix::from_fn(|i, j| {
            let constant = weights[j] * nodes[i];
            let p = &tables[i];
            // ∫ P_k dt from 0 = (P_(k+1) − P_(k−1))/(2 (2k + 1))
            (1..NODES).map(|k| coefficient(k, j) * (p[k + 1] - p[k - 1]) / (4 * k + 2) as f64).sum::<f64>() + constant
        });
        let highest = SMatrix::from_fn(|i, j| coefficient(NODES - 2 + i, j));
        let ends = SMatrix::from_fn(|i, j| {
            let p = legendre(2.0 * ENDS[i] - 1.0);
            (0..NODES).map(|k| coefficient(k, j) * p[k]).sum()
        });
        Self { nodes, weights, integral, highest, ends }
    }
}

/// P_0 … P_NODES at x.
fn legendre(x: f64) -> [f64; NODES + 1] {
    let mut p = [1.0; NODES + 1];
    p[1] = x;
    for k in 1..NODES {
        p[k + 1] = ((2 * k + 1) as f64 * x * p[k] - k as f64 * p[k - 1]) / (k + 1) as f64;
    }
    p
}

/// Consecutive slices from the top face down to `depth`.
struct Slices {
    list: Vec<Slice>,
    depth: f64,
}

struct Slice {
    thickness: f64,
    /// In units of the material's shortest decay length.
    length: f64,
    /// Mean shear compliance, times μ₀.
    softness: f64,
    /// State at the top from the state at the bottom, less identity.
    transfer: Matrix4<f64>,
}

/// The material at the Gauss points of a slice, from the bottom up, in units of μ₀.
struct Points {
    shear: SVector<f64, NODES>,
    coupling: SVector<f64, NODES>,
    normal: SVector<f64, NODES>,
    axial: SVector<f64, NODES>,
    /// At the ends of the slice.
    ends: [Coefficients; 2],
}

impl Points {
    fn new(profile: &Profile, wave: &Wave, depth: f64, thickness: f64) -> Self {
        let at = |t: f64| Coefficients::new(&(profile.material)(depth + (1.0 - t) * thickness), wave.modulus);
        let points = RULE.nodes.map(at);
        let values = |pick: fn(&Coefficients) -> f64| SVector::from_iterator(points.iter().map(pick));
        Self {
            shear: values(|point| point.m),
            coupling: values(|point| point.c),
            normal: values(|point| point.d),
            axial: values(|point| point.e),
            ends: ENDS.map(at),
        }
    }

    /// Whether the slice is short enough for the wave and for the variation of the material.
    fn resolved(&self, zeta: f64) -> bool {
        let smooth = |f: &SVector<f64, NODES>, ends: fn(&Coefficients) -> f64, floor: f64| {
            let size = f.amax().max(floor);
            let missed = RULE.ends * f - SVector::from(self.ends.each_ref().map(ends));
            (RULE.highest * f).amax() <= RESOLVED * size && missed.amax() <= MET * size
        };
        zeta * self.fastest() <= LENGTH
            && smooth(&self.shear, |end| end.m, 0.0)
            && smooth(&self.axial, |end| end.e, 0.0)
            && smooth(&self.coupling, |end| end.c, 1.0)
            && smooth(&self.normal, |end| end.d, self.shear.amax())
    }

    /// How fast the fastest field varies with ζ = λy.
    fn fastest(&self) -> f64 {
        let rate = |i: usize| {
            let (m, c, d, e) = (self.shear[i], self.coupling[i], self.normal[i], self.axial[i]);
            (e * m).max(c.abs()).max((e * d).sqrt()).sqrt()
        };
        (0..NODES).map(rate).fold(1.0, f64::max)
    }

    /// How fast the slowest field decays with ζ: the real part of the smaller root s, see [`surface_flexibility`].
    fn slowest(&self) -> f64 {
        let rate = |i: usize| {
            let (m, c, d, e) = (self.shear[i], self.coupling[i], self.normal[i], self.axial[i]);
            let (half, product) = (0.5 * (e * m - 2.0 * c), c * c + e * d);
            let root = half * half - product;
            if root > 0.0 { (product / (half + root.sqrt())).sqrt() } else { (0.5 * (half + product.sqrt())).sqrt() }
        };
        (0..NODES).map(rate).fold(f64::INFINITY, f64::min)
    }

    /// The transfer matrix through the slice of length ζ, less identity: Picard iteration of X − 1 = ∫ A X dζ, where
    /// each component takes at once what the others have just become.
    fn transfer(&self, zeta: f64) -> Matrix4<f64> {
        type Columns = SMatrix<f64, NODES, 4>;
        let along = |f: &SVector<f64, NODES>, x: &Columns| Columns::from_fn(|i, j| f[i] * x[(i, j)]);
        let unit = |k: usize| Columns::from_fn(|_, j| if j == k { 1.0 } else { 0.0 });
        let integral = RULE.integral * zeta;
        let [unit_u, unit_v, unit_s, unit_t] = [0, 1, 2, 3].map(unit);
        let (mut u, mut v, mut s, mut t) = (unit_u, unit_v, unit_s, unit_t);
        let rates = |u: &Columns, v: &Columns, s: &Columns, t: &Columns| {
            [
                v + along(&self.shear, t),
                along(&self.normal, s) - along(&self.coupling, u),
                -t,
                along(&self.axial, u) + along(&self.coupling, s),
            ]
        };
        for _ in 0..sweeps(zeta * self.fastest()) {
            u = unit_u + integral * (v + along(&self.shear, &t));
            t = unit_t + integral * (along(&self.axial, &u) + along(&self.coupling, &s));
            s = unit_s - integral * t;
            v = unit_v + integral * (along(&self.normal, &s) - along(&self.coupling, &u));
        }
        let ends = rates(&u, &v, &s, &t).map(|rate| RULE.weights * rate * zeta);
        Matrix4::from_rows(&ends)
    }
}

/// Sweeps of Picard iteration through a slice of the given length: each adds two orders of the power series.
fn sweeps(length: f64) -> usize {
    let (mut count, mut term) = (1.0, 1.0);
    while term > 0.1 * f64::EPSILON && count < MOST_SWEEPS {
        term *= length * length / (2.0 * count * (2.0 * count + 1.0));
        count += 1.0;
    }
    count as usize + 2
}

/// X⁻¹ − 1 from X − 1, entry by entry: reciprocity makes X symplectic, X⁻¹ = Ω⁻¹ Xᵀ Ω, with the pairs (U, T), (V, S).
fn inverse(transfer: &Matrix4<f64>) -> Matrix4<f64> {
    let sign = |i: usize| if i < 2 { 1.0 } else { -1.0 };
    Matrix4::from_fn(|i, j| sign(i) * sign(j) * transfer[(3 - j, 3 - i)])
}

/// The transfer matrices, less identity, from the boundary `start` up to the top and down to the bottom.
fn outwards(slices: &[Slice], start: usize) -> [Matrix4<f64>; 2] {
    // (1 + A)(1 + B) − 1
    let after = |first: Matrix4<f64>, then: Matrix4<f64>| first + then + then * first;
    let up = slices[..start].iter().rev().fold(Matrix4::zeros(), |sum, slice| after(sum, slice.transfer));
    let down = slices[start..].iter().fold(Matrix4::zeros(), |sum, slice| after(sum, inverse(&slice.transfer)));
    [up, down]
}

/// Amplitudes = the state at mid-depth, or where the layer is softest: from there to stiffer places the terms of a
/// transfer matrix do not cancel.
fn thin(slices: &[Slice]) -> FaceStates {
    let [up, down] = outwards(slices, extreme(slices, f64::max));
    FaceStates::Finite { top: Matrix4::identity() + up, bottom: Matrix4::identity() + down, uniform: uniform(slices) }
}

/// The field that starts from S = 1 at mid-depth, or where the layer is stiffest: from there to softer places stresses
/// do not grow.
fn uniform(slices: &[Slice]) -> [State; 2] {
    outwards(slices, extreme(slices, f64::min)).map(|transfer| transfer.column(2).into_owned())
}

/// The boundary between slices where the compliance is extreme; the middle one if it is about the same everywhere.
fn extreme(slices: &[Slice], more: fn(f64, f64) -> f64) -> usize {
    let compliance = |i: usize| {
        let slice = |i: usize| slices.get(i).map(|slice| slice.softness);
        let (above, below) = (i.checked_sub(1).and_then(slice), slice(i));
        0.5 * (above.or(below).unwrap_or(0.0) + below.or(above).unwrap_or(0.0))
    };
    let among = |pick: fn(f64, f64) -> f64| (0..=slices.len()).map(compliance).reduce(pick).unwrap_or(0.0);
    let mild = among(f64::max) <= MILD * among(f64::min);
    let wanted = among(more);
    let thickness: f64 = slices.iter().map(|slice| slice.thickness).sum();
    let (mut chosen, mut off_centre, mut depth) = (0, f64::INFINITY, 0.0);
    for i in 0..=slices.len() {
        let distance = (depth - 0.5 * thickness).abs();
        // equal places are told apart by their distance from the middle
        if (mild || compliance(i) == wanted) && distance < off_centre {
            (chosen, off_centre) = (i, distance);
        }
        depth += slices.get(i).map_or(0.0, |slice| slice.thickness);
    }
    chosen
}

/// A layer seen from one of its faces.
struct Seen {
    /// (λμ₀U, λμ₀V) at the face from (S, T) on it.
    flexibility: Matrix2<f64>,
    /// (S, T) on the far, clamped face from (S, T) on this one; `None` if there is no far face.
    far: Option<Matrix2<f64>>,
}

impl Seen {
    /// Nothing yet, next to the clamp.
    fn clamped() -> Self {
        Self { flexibility: Matrix2::zeros(), far: Some(Matrix2::identity()) }
    }

    /// The face moved through a slice, away from the far one.
    fn through(self, transfer: &Matrix4<f64>) -> Self {
        let block = |i: usize, j: usize| transfer.fixed_view::<2, 2>(i, j);
        let displacement = self.flexibility + (block(0, 0) * self.flexibility + block(0, 2));
        let stress = Matrix2::identity() + (block(2, 0) * self.flexibility + block(2, 2));
        let back = stress.try_inverse().unwrap_or(Matrix2::repeat(f64::NAN));
        Self { flexibility: displacement * back, far: self.far.map(|far| far * back) }
    }

    /// The states at the face for S = 1 and for T = 1 on it.
    fn states(&self) -> Matrix4x2<f64> {
        stacked(&self.flexibility, &Matrix2::identity())
    }

    /// The states at the far face for S = 1 and for T = 1 on this one.
    fn far_states(&self) -> Matrix4x2<f64> {
        stacked(&Matrix2::zeros(), &self.far.unwrap_or(Matrix2::zeros()))
    }
}

/// A layer of which one or the other face is clamped. Amplitudes = (S, T) on the top face above a clamped bottom, then
/// (S, T) on the bottom face below a clamped top.
struct Clamped {
    from_top: Seen,
    from_bottom: Seen,
}

impl Clamped {
    fn new(slices: &[Slice]) -> Self {
        Self {
            from_top: slices.iter().rev().fold(Seen::clamped(), |seen, slice| seen.through(&slice.transfer)),
            from_bottom: slices.iter().fold(Seen::clamped(), |seen, slice| seen.through(&inverse(&slice.transfer))),
        }
    }

    /// 1 if the faces do not feel each other, 0 if stresses on one face are handed on to the other unchanged, as in a
    /// layer that moves like a rigid body.
    fn independence(&self) -> f64 {
        let [down, up] = [&self.from_top, &self.from_bottom].map(|seen| seen.far.unwrap_or(Matrix2::zeros()));
        (Matrix2::identity() - up * down).determinant()
    }

    fn face_states(&self, uniform: [State; 2]) -> FaceStates {
        FaceStates::Finite {
            top: beside(&self.from_top.states(), &self.from_bottom.far_states()),
            bottom: beside(&self.from_top.far_states(), &self.from_bottom.states()),
            uniform,
        }
    }
}

/// Faces that do not feel each other; the bottom is given as the top of the mirrored layer.
fn deep(top: Matrix4x2<f64>, mut bottom: Matrix4x2<f64>) -> FaceStates {
    // V and T change their signs
    for i in [1, 3] {
        bottom.row_mut(i).neg_mut();
    }
    FaceStates::thick(beside(&top, &Matrix4x2::zeros()), beside(&Matrix4x2::zeros(), &bottom))
}

fn stacked(upper: &Matrix2<f64>, lower: &Matrix2<f64>) -> Matrix4x2<f64> {
    Matrix4x2::from_fn(|i, j| if i < 2 { upper[(i, j)] } else { lower[(i - 2, j)] })
}

fn beside(left: &Matrix4x2<f64>, right: &Matrix4x2<f64>) -> Matrix4<f64> {
    Matrix4::from_fn(|i, j| if j < 2 { left[(i, j)] } else { right[(i, j - 2)] })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Exponential, Flexibility, HalfPlane, Homogeneous, Isotropic};

    fn wave(wavenumber: f64) -> Wave {
        Wave { wavenumber, modulus: 1.0, plane: Plane::Strain }
    }

    fn isotropic(shear_modulus: f64) -> Material {
        Isotropic { shear_modulus, poisson: 0.3 }.material(Plane::Strain)
    }

    #[test]
    fn the_rule_integrates_polynomials_of_its_degree() {
        for k in 0..NODES as i32 {
            let powers = SVector::<f64, NODES>::from_fn(|i, _| RULE.nodes[i].powi(k));
            let integrals = RULE.integral * powers;
            for (t, integral) in RULE.nodes.iter().zip(integrals.iter()) {
                assert!((integral - t.powi(k + 1) / f64::from(k + 1)).abs() < 1e-15, "degree {k} to {t}");
            }
            assert!(((RULE.weights * powers)[0] - 1.0 / f64::from(k + 1)).abs() < 1e-15, "degree {k}");
        }
    }

    #[test]
    fn a_slice_and_its_inverse_compose_to_nothing() {
        let material = |depth: f64| isotropic((0.8 * depth).exp());
        let profile = Profile { thickness: Some(1.0), material: &material };
        let transfer = Points::new(&profile, &wave(0.5), 0.0, 1.0).transfer(0.5);
        let back = inverse(&transfer);
        assert!((transfer + back + back * transfer).amax() < 1e-15);
    }

    #[test]
    fn the_surface_of_a_half_plane_is_a_closed_form() {
        for poisson in [-0.9, 0.0, 0.25, 0.5] {
            for plane in [Plane::Strain, Plane::Stress] {
                let material = Isotropic { shear_modulus: 3.0, poisson };
                let wave = Wave { wavenumber: 2.0, modulus: 5.0, plane };
                let ground = HalfPlane::new(3.0, poisson).expect("legal");
                let FaceStates::HalfPlane { top } = ground.face_states(&wave) else { panic!("one face") };
                let predicted = surface_flexibility(&material.material(plane), wave.modulus) * top.fixed_rows::<2>(2);
                assert!((predicted - top.fixed_rows::<2>(0)).amax() < 1e-14, "{poisson} {plane:?}");
            }
        }
    }

    #[test]
    fn slices_are_counted() {
        // one slice for each half; βδ < 1 in a slice; thick: thirty decay lengths from a face, however thick the layer
        let count = |beta: f64, wavenumber: f64| {
            let layer = Exponential::new(1.0, 1.0, 0.25, beta).expect("legal");
            let material = |depth| layer.material(depth, Plane::Strain);
            let profile = Profile { thickness: Some(1.0), material: &material };
            profile.slices(&wave(wavenumber), FELT).list.len()
        };
        assert_eq!([count(0.0, 1e-8), count(0.0, 1.0), count(30.0, 1e-8)], [2, 2, 33]);
        assert!([1e3, 1e8, 1e150].map(|wavenumber| count(1.0, wavenumber)).iter().all(|n| (60..=61).contains(n)));
    }

    #[test]
    fn a_jump_of_the_material_is_found() {
        let jump = 0.3;
        let material = |depth: f64| isotropic(if depth < jump { 1.0 } else { 10.0 });
        let [stiffness] = Profile { thickness: Some(1.0), material: &material }.integrate(|m, _| [m.axial_stiffness]);
        let expected = isotropic(jump + 10.0 * (1.0 - jump)).axial_stiffness;
        assert!((stiffness / expected - 1.0).abs() < 1e-13);
    }

    #[test]
    fn a_material_without_any_order_ends() {
        let material = |depth: f64| isotropic(1.5 + (1e9 * depth).sin());
        let states = Profile { thickness: Some(1.0), material: &material }.face_states(&wave(1.0));
        assert!(Flexibility::of_face_states(&states).is_some());
    }

    #[test]
    fn a_half_plane_that_stiffens_is_a_layer_on_rigid_ground() {
        // μ = e^(βd), so soft at the face that waves longer than 1/β feel nothing of it but its compression
        let material = |depth: f64| isotropic((5.0 * depth).exp());
        for wavenumber in [1e-8, 1e-3, 1.0, 10.0] {
            let top = Profile { thickness: None, material: &material }.surface(&wave(wavenumber));
            let rigid = Profile { thickness: Some(14.0), material: &material };
            let seen = rigid
                .slices(&wave(wavenumber), FELT)
                .list
                .iter()
                .rev()
                .fold(Seen::clamped(), |seen, slice| seen.through(&slice.transfer));
            assert!((top - seen.states()).amax() < 1e-13 * top.amax(), "{wavenumber} {top} {}", seen.states());
        }
    }

    #[test]
    fn no_thickness_is_no_layer() {
        let nothing = Homogeneous::new(0.0, 1.0, 0.25).expect("legal");
        let FaceStates::Finite { top, bottom, .. } = face_states(&nothing, &wave(1.0)) else { panic!("two faces") };
        assert_eq!(top, bottom);
    }
}
