//! The same collocation equations as in [`super::collocate`], with the same nodes, wavenumbers and weights, assembled as fast
//! as they can be: sin λ(ar − bs) is split by the addition theorem, so that each contact needs one table of sines and one
//! of cosines, and every integral over the wavenumber becomes an entry of a matrix product. The pressures are even in s, so
//! that half of the nodes are enough.
use std::f64::consts::PI;

use faer::linalg::matmul::matmul;
use faer::linalg::solvers::Solve;
use faer::{Accum, Mat, Par};

use super::{Problem, Table};

/// P(s_k) of every contact at all nodes, and the residuals of the resultants.
pub fn collocate(problem: &Problem, table: &Table, half_lengths: &[f64], nodes: usize) -> (Vec<Vec<f64>>, Vec<f64>) {
    let (contacts, half) = (half_lengths.len(), nodes / 2);
    let s: Vec<f64> = (1..=half).map(|k| (PI * k as f64 / (nodes + 1) as f64).cos()).collect();
    let r: Vec<f64> = (1..=half).map(|j| (PI * (2 * j - 1) as f64 / (2 * (nodes + 1)) as f64).cos()).collect();
    // both s and −s count
    let weights: Vec<f64> = s.iter().map(|s| 2.0 * (1.0 - s * s) / (nodes + 1) as f64).collect();
    let waves = table.lambda.len();
    let at = |points: &[f64], a: f64, of: fn(f64) -> f64| {
        Mat::from_fn(waves, half, |wave, k| of(table.lambda[wave] * (a * points[k])))
    };
    let cosines: Vec<Mat<f64>> = half_lengths.iter().map(|a| at(&s, *a, f64::cos)).collect();
    let mut matrix = Mat::zeros(contacts * half, contacts * half);
    let mut right = Mat::<f64>::zeros(contacts * half, 1);
    let mut weighted = Mat::zeros(waves, half);
    for (i, a) in half_lengths.iter().enumerate() {
        let sines = at(&r, *a, f64::sin);
        for l in i.saturating_sub(1)..contacts.min(i + 2) {
            let kernel = if l == i { &table.own[i] } else { &table.coupling[i.min(l)][usize::from(l < i)] };
            for k in 0..half {
                let columns = weighted.col_as_slice_mut(k).iter_mut().zip(sines.col_as_slice(k)).zip(kernel);
                columns.for_each(|((weighted, sine), weight)| *weighted = weight * sine);
            }
            let mut block = matrix.as_mut().submatrix_mut(i * half, l * half, half, half);
            let scale = if l == i { table.limits[i] * a } else { half_lengths[l] };
            matmul(block.as_mut(), Accum::Replace, weighted.transpose(), &cosines[l], scale, Par::Seq);
            for k in 0..half {
                for j in 0..half {
                    if l == i {
                        // half of 1/(r − s) + 1/(r + s)
                        block[(j, k)] += table.limits[i] * r[j] / (r[j] * r[j] - s[k] * s[k]);
                    }
                    block[(j, k)] *= weights[k];
                }
            }
        }
        if i == 0 {
            (0..half).for_each(|j| right[(j, 0)] = (problem.slope)(a * r[j]));
        }
    }
    let solution = matrix.partial_piv_lu().solve(&right);
    let upper = |i: usize| (0..half).map(move |k| (i * half + k, k));
    let residual = |i: usize| {
        let sum: f64 = upper(i).map(|(row, k)| weights[k] * solution[(row, 0)]).sum();
        PI * half_lengths[i] / problem.force * sum - 1.0
    };
    let unknown = |i: usize| upper(i).chain(upper(i).rev()).map(|(row, _)| solution[(row, 0)]).collect();
    ((0..contacts).map(unknown).collect(), (0..contacts).map(residual).collect())
}
