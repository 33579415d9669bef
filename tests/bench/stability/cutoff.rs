//! What is left of a receding half-length if the kernels are integrated one by one from a lowest wavenumber on.
//!
//! The equations are those of the paper: p and q at Chebyshev nodes, slopes at the places between, kernels as integrals
//! over the wavenumber that diverge at 0 like λ⁻³ λ and are therefore cut off; then Newton's method until both
//! resultants are the force. The flexibilities are those of the library, to rounding, so that the cut-off alone is seen.
use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};
use recede::numeric::quadrature;
use recede::{BaseChain, BlockSystem, FreeChain, Scene, Wave};

/// A homogeneous strip of thickness 1 on a half-plane of the same material.
pub const SCENE: &str = "Scene(
    geometry: PlaneStrain,
    punch: Cylinder(radius: 500.0),
    force: 0.002,
    stack: [
        Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25),
        Receding,
        HalfPlane(shear_modulus: 1.0, poisson: 0.25),
    ],
)";
/// Nodes for p, and as many for q.
const NODES: usize = 48;
/// Beyond this wavenumber kernels are at their limits.
const LAST: f64 = 45.0;
/// Half-lengths that are off by less do no harm here.
const ENOUGH: f64 = 1e-13;

/// Flexibilities at the wavenumbers of a quadrature.
struct Sample {
    lambda: f64,
    weight: f64,
    /// λC of the strip without its limit; λC_tb; λ(C_bb − C_base) without its limit.
    top: f64,
    coupling: f64,
    lower: f64,
}

/// The receding half-length with kernels cut off below `lowest`, started from half-lengths that are right.
pub fn receding_half_length(lowest: f64, start: [f64; 2]) -> Option<f64> {
    let scene = Scene::from_ron(SCENE).ok()?;
    let stack = scene.stack().ok()?;
    let system = BlockSystem::new(&stack);
    let (strip, base) = (FreeChain::all(&system).remove(0), BaseChain::of(&system));
    // (κ + 1)/(4μ) with κ = 2
    let limit = 0.75;
    let mut samples = Vec::new();
    let mut from = lowest;
    while from < LAST {
        let to = (2.0 * from).min(from + 2.0).min(LAST);
        for (lambda, weight) in quadrature::rule(16).on(from, to) {
            let wave = Wave { wavenumber: lambda, modulus: 1.0, plane: scene.geometry.plane() };
            let (c, base) = (strip.flexibility(&wave)?, base.flexibility(&wave)?);
            let (top, lower) = (c.top - limit, c.bottom - base + 2.0 * limit);
            samples.push(Sample { lambda, weight, top, coupling: c.coupling, lower });
        }
        from = to;
    }
    let mut logarithms = start.map(f64::ln);
    for _ in 0..30 {
        let at = |shift: [f64; 2]| {
            let half_lengths = [0, 1].map(|i| (logarithms[i] + shift[i]).exp());
            resultants(&samples, limit, half_lengths, &scene)
        };
        let (now, step) = (at([0.0, 0.0])?, 1e-6);
        let [da, db] = [at([step, 0.0])?, at([0.0, step])?].map(|moved| [0, 1].map(|i| (moved[i] - now[i]) / step));
        let determinant = da[0] * db[1] - db[0] * da[1];
        let change = [(now[0] * db[1] - db[0] * now[1]) / determinant, (da[0] * now[1] - now[0] * da[1]) / determinant];
        if !change.iter().all(|change| change.is_finite()) {
            return None;
        }
        logarithms = [0, 1].map(|i| logarithms[i] - change[i].clamp(-0.3, 0.3));
        if change.iter().all(|change| change.abs() < ENOUGH) {
            break;
        }
    }
    Some(logarithms[1].exp())
}

/// Resultants of p and q over the force, less 1.
fn resultants(samples: &[Sample], limit: f64, half_lengths: [f64; 2], scene: &Scene) -> Option<[f64; 2]> {
    let half = NODES / 2;
    let node = |k: usize| ((k + 1) as f64 * PI / (NODES + 1) as f64).cos();
    let place = |j: usize| ((2 * j + 1) as f64 * PI / (2 * (NODES + 1)) as f64).cos();
    let weight = |k: usize| (1.0 - node(k).powi(2)) / (NODES + 1) as f64;
    let mut matrix = DMatrix::zeros(2 * half, 2 * half);
    // each node stands for itself and its mirror image
    for j in 0..half {
        for k in 0..half {
            let cauchy = weight(k) * (1.0 / (place(j) - node(k)) + 1.0 / (place(j) + node(k)));
            matrix[(j, k)] = limit * cauchy;
            matrix[(half + j, half + k)] = -2.0 * limit * cauchy;
        }
    }
    for Sample { lambda, weight: d, top, coupling, lower } in samples {
        let [cosines, sines] = [0, 1].map(|of_places| {
            half_lengths.map(|a| {
                let value =
                    |i| if of_places == 1 { (lambda * a * place(i)).sin() } else { (lambda * a * node(i)).cos() };
                (0..half).map(value).collect::<Vec<f64>>()
            })
        });
        for j in 0..half {
            for k in 0..half {
                let transform = [0, 1].map(|i| 2.0 * half_lengths[i] * weight(k) * cosines[i][k] * d);
                matrix[(j, k)] += top * transform[0] * sines[0][j];
                matrix[(j, half + k)] += coupling * transform[1] * sines[0][j];
                matrix[(half + j, k)] -= coupling * transform[0] * sines[1][j];
                matrix[(half + j, half + k)] += lower * transform[1] * sines[1][j];
            }
        }
    }
    let mut slopes = DVector::zeros(2 * half);
    for j in 0..half {
        slopes[j] = scene.top.punch().expect("a punch").slope(half_lengths[0] * place(j));
    }
    let pressures = matrix.lu().solve(&slopes)?;
    let force = scene.force.given()?;
    Some([0, 1].map(|i| {
        let sum: f64 = (0..half).map(|k| 2.0 * weight(k) * pressures[i * half + k]).sum();
        PI * half_lengths[i] * sum / force - 1.0
    }))
}
