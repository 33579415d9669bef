//! Sequences of layers that are repeated: where a wave is long, many repetitions are one body.
//!
//! From the bottom of a sequence to its top the state changes by x ↦ P x + p, with p due to equal loads. The transfer through two
//! sequences is P² and P p + p, so that 2^k of them take k products. A body of 2m sequences has the state in its middle for
//! amplitudes, like a thin layer: P^m above it and P^(−m) below. By reciprocity P^(−1) has the entries of P, some with the
//! other sign: nothing is inverted, and entries small like powers of λh keep all their digits.
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use nalgebra::{Matrix4, Vector4};
use recede_layers::{FaceStates, Key, Layer, Wave};

use super::junction::Junction;
use crate::solution::Stats;

/// Longest sequence that is recognised, in layers.
const LONGEST: usize = 16;
/// Fewer repetitions save nothing.
const FEWEST: usize = 4;
/// Largest trace of P^m, 4 cosh 1, which a homogeneous layer has at λh = 1: beyond it, rounding errors of growing solutions exceed the
/// decaying solutions. Laminates of unlike layers have solutions that grow much faster.
const LARGEST: f64 = 6.2;
/// Relative tolerance within which the amplitudes of a layer have to be states inside it.
const RECIPROCAL: f64 = 1e-13;

/// A sequence of bonded layers, repeated.
#[derive(Clone, Debug)]
pub(super) struct Repeat {
    /// The layers of all repetitions.
    layers: Range<usize>,
    /// Number of layers of one sequence.
    period: usize,
    /// Thickness of one sequence.
    thickness: f64,
}

/// Layers that are evaluated together.
pub(super) struct JoinedLayers {
    pub(super) layers: Range<usize>,
    pub(super) states: FaceStates,
}

/// The transfer of the state from the bottom of a sequence to its top.
#[derive(Clone, Copy)]
struct Transfer {
    matrix: Matrix4<f64>,
    uniform: Vector4<f64>,
}

/// Finds repeated sequences in a chain of layers.
pub(super) fn find(layers: &[Arc<dyn Layer>], junctions: &[Junction]) -> Vec<Repeat> {
    let kinds = kinds(layers);
    let bonded = |i: usize| junctions[i].is_bonded();
    let mut repeats = Vec::new();
    let mut first = 0;
    while first + FEWEST <= layers.len() {
        // the end of the layers that are bonded to the next and equal to that one period before
        let end = |period: usize| {
            let like = |i: &usize| kinds[*i].is_some() && kinds[*i] == kinds[*i - period] && bonded(*i - 1);
            let inside = (first + 1..first + period).all(|i| kinds[i].is_some() && bonded(i - 1));
            let after = (first + period..layers.len()).take_while(like).count();
            if kinds[first].is_some() && inside { first + (period + after) / period * period } else { first }
        };
        let found = (1..=LONGEST.min((layers.len() - first) / FEWEST)).map(|period| (period, end(period)));
        let enough = found.filter(|(period, end)| end - first >= FEWEST * period);
        match enough.max_by_key(|(period, end)| (*end, std::cmp::Reverse(*period))) {
            Some((period, end)) => {
                let thicknesses = layers[first..first + period].iter().map(|layer| layer.thickness().unwrap_or(0.0));
                repeats.push(Repeat { layers: first..end, period, thickness: thicknesses.sum() });
                first = end;
            }
            None => first += 1,
        }
    }
    repeats
}

/// Equal numbers for equal layers; none for layers without a key.
fn kinds(layers: &[Arc<dyn Layer>]) -> Vec<Option<usize>> {
    let mut first: HashMap<Key, usize> = HashMap::new();
    let kind = |(i, layer): (usize, &Arc<dyn Layer>)| {
        // a base is not repeated
        layer.thickness()?;
        Some(*first.entry(layer.key()?).or_insert(i))
    };
    layers.iter().enumerate().map(kind).collect()
}

/// Some layers of a chain as bodies, top down, for one wave.
pub(super) struct Bodies<'a> {
    layers: &'a [Arc<dyn Layer>],
    /// Layers that are evaluated as one body, with the index of the transfer through their upper half, if they are several.
    pieces: Vec<(Range<usize>, Option<usize>)>,
    /// Layers after these, each of which is a body.
    single: Range<usize>,
    /// Sequences of repeats, each 1, 2, 4, ... times.
    powers: Vec<Transfer>,
    /// Number of layers evaluated, and of those that repeat others.
    evaluated: usize,
    repeated: usize,
}

impl<'a> Bodies<'a> {
    pub(super) fn new(layers: &'a [Arc<dyn Layer>], repeats: &[Repeat], range: Range<usize>, wave: &Wave) -> Self {
        let mut bodies =
            Self { layers, pieces: Vec::new(), single: range, powers: Vec::new(), evaluated: 0, repeated: 0 };
        for repeat in repeats {
            bodies.join(repeat, wave);
        }
        bodies.evaluated += bodies.single.len();
        bodies
    }

    /// Counts the layers.
    pub(super) fn count(&self, stats: &mut Stats) {
        stats.layers += self.evaluated;
        stats.repeated += self.repeated;
    }

    /// Makes bodies of the repetitions within these layers.
    fn join(&mut self, repeat: &Repeat, wave: &Wave) {
        // a sequence begins wherever it is cut
        let first = repeat.layers.start.max(self.single.start);
        let count = repeat.layers.end.min(self.single.end).saturating_sub(first) / repeat.period;
        if count < FEWEST || wave.wavenumber * repeat.thickness > 1.0 {
            return;
        }
        let once = Transfer::of(&self.layers[first..first + repeat.period], wave);
        let first_power = self.powers.len();
        let doubled = std::iter::successors(once, |power| Some(power.after(power)));
        let most = (count / 2).ilog2() as usize + 1;
        self.powers.extend(doubled.take(most).take_while(|power| power.matrix.trace() <= LARGEST));
        if self.powers.len() == first_power {
            return;
        }
        let before = self.single.start..first;
        self.evaluated += before.len() + repeat.period;
        self.pieces.extend(before.map(|i| (i..i + 1, None)));
        let (mut next, mut left) = (first, count);
        for power in (first_power..self.powers.len()).rev() {
            let together = 2 << (power - first_power);
            while left >= together {
                let layers = next..next + together * repeat.period;
                (next, left) = (layers.end, left - together);
                self.pieces.push((layers, Some(power)));
            }
        }
        self.repeated += next - first - repeat.period;
        self.single.start = next;
    }

    /// Top down, or the other way round.
    pub(super) fn iter(&self, wave: &Wave) -> impl DoubleEndedIterator<Item = JoinedLayers> {
        let one = |i: usize| JoinedLayers { layers: i..i + 1, states: self.layers[i].face_states(wave) };
        let pieces = self.pieces.iter().map(move |(layers, power)| match power {
            Some(power) => JoinedLayers { layers: layers.clone(), states: self.powers[*power].about_the_middle() },
            None => one(layers.start),
        });
        pieces.chain(self.single.clone().map(one))
    }
}

impl Transfer {
    /// The transfer through a few layers, top down; `None` if the amplitudes of one of them are no states inside it.
    fn of(layers: &[Arc<dyn Layer>], wave: &Wave) -> Option<Self> {
        let mut all: Option<Self> = None;
        for layer in layers {
            let FaceStates::Finite { top, bottom, uniform: [at_top, at_bottom] } = layer.face_states(wave) else {
                return None;
            };
            let form = adjoint(&bottom) * bottom;
            let size = form[(0, 0)];
            let off = (form - Matrix4::identity() * size).amax();
            if off > RECIPROCAL * size.abs() || !off.is_finite() {
                return None;
            }
            let matrix = top * adjoint(&bottom) / size;
            let through = Self { matrix, uniform: at_top - matrix * at_bottom };
            all = Some(all.map_or(through, |above| above.after(&through)));
        }
        all
    }

    /// The transfer through this sequence above another one.
    fn after(&self, below: &Self) -> Self {
        Self { matrix: self.matrix * below.matrix, uniform: self.uniform + self.matrix * below.uniform }
    }

    /// The face states of twice this sequence, as functions of the state in its middle.
    fn about_the_middle(&self) -> FaceStates {
        let bottom = adjoint(&self.matrix);
        FaceStates::Finite { top: self.matrix, bottom, uniform: [self.uniform, -(bottom * self.uniform)] }
    }
}

/// −J Xᵀ J with the form xᵀ J y = U₁T₂ − T₁U₂ + V₁S₂ − S₁V₂, the work of two fields on each other, which is the same in all
/// depths: the inverse of a transfer matrix.
fn adjoint(matrix: &Matrix4<f64>) -> Matrix4<f64> {
    let sign = |i: usize| if i < 2 { 1.0 } else { -1.0 };
    Matrix4::from_fn(|i, k| sign(i) * sign(k) * matrix[(3 - k, 3 - i)])
}

#[cfg(test)]
mod tests {
    use recede_layers::{Exponential, Flexibility, HalfPlane, Homogeneous, Plane};

    use super::super::{BaseChain, FreeChain};
    use super::*;
    use crate::scene::Item;
    use crate::stack::Stack;
    use crate::system::BlockSystem;

    fn free(stack: &Stack) -> FreeChain {
        FreeChain::all(&BlockSystem::new(stack)).remove(0)
    }

    /// This number of layers bonded to each other, of the kinds of the sequence in turn.
    fn layers(count: usize, sequence: &[Item]) -> crate::stack::StackBuilder {
        let layer = |i: usize| sequence[i % sequence.len()].clone();
        (1..count).fold(Stack::builder(Plane::Strain).item(layer(0)), |stack, i| stack.bonded().item(layer(i)))
    }

    fn strip(thickness: f64, modulus: f64, poisson: f64) -> Item {
        Item::layer(Homogeneous::new(thickness, modulus, poisson).unwrap())
    }

    fn waves() -> impl Iterator<Item = Wave> {
        (-32..=24).map(|k| Wave { wavenumber: 10f64.powf(0.25 * f64::from(k)), modulus: 1.3, plane: Plane::Strain })
    }

    #[test]
    fn repeated_sequences_are_found() {
        let [a, b, c] = [strip(0.01, 1.0, 0.3), strip(0.02, 3.0, 0.2), strip(0.01, 1.0, 0.31)];
        let found = |items: &[Item]| {
            let stack = layers(items.len(), items).receding().rigid().build().unwrap();
            let chain = free(&stack);
            find(&chain.layers, &chain.junctions).iter().map(|repeat| (repeat.layers.clone(), repeat.period)).collect()
        };
        let of = |names: &str| -> Vec<(Range<usize>, usize)> {
            let item = |name| match name {
                'a' => a.clone(),
                'b' => b.clone(),
                _ => c.clone(),
            };
            found(&names.chars().map(item).collect::<Vec<_>>())
        };
        assert_eq!(of("abababab"), [(0..8, 2)]);
        assert_eq!(of("cababababa"), [(1..9, 2)]);
        assert_eq!(of("abcabcabcabcacacacac"), [(0..12, 3), (12..20, 2)]);
        assert_eq!(of("abacab"), []);
        // a sequence across an interface that slides is no repetition
        let spring = Item::Sliding;
        let stack = layers(4, &[a.clone(), b.clone()]).item(spring).item(a.clone());
        let stack = (1..4).fold(stack, |stack, i| stack.bonded().item([&a, &b][i % 2].clone()));
        let stack = stack.receding().rigid().build().unwrap();
        let chain = free(&stack);
        assert!(find(&chain.layers, &chain.junctions).is_empty());
    }

    #[test]
    fn sequences_of_many_layers_are_evaluated_once_and_keep_their_digits() {
        let graded = |beta: f64| Item::layer(Exponential::new(0.03, 1.0, 0.3, beta).unwrap());
        for (count, sequence) in [
            (100, vec![strip(0.01, 1.0, 0.25), strip(0.01, 2.0, 0.25)]),
            (77, vec![strip(0.01, 1.0, 0.49), strip(0.03, 500.0, 0.1), strip(0.001, 0.02, -0.3)]),
            (64, vec![graded(20.0), strip(0.01, 3.0, 0.3)]),
        ] {
            let stack = layers(count, &sequence).receding().rigid().build().unwrap();
            let chain = free(&stack);
            let plain = FreeChain { repeats: Vec::new(), ..chain.clone() };
            let on_ground = layers(count, &sequence).bonded().layer(HalfPlane::new(0.7, 0.3).unwrap()).build().unwrap();
            let base = BaseChain::of(&BlockSystem::new(&on_ground));
            let plain_base = BaseChain { repeats: Vec::new(), ..base.clone() };
            for wave in waves() {
                let [mut taken, mut all] = [Stats::default(), Stats::default()];
                let found = chain.counted_flexibility(&wave, &mut taken).unwrap();
                let expected = plain.counted_flexibility(&wave, &mut all).unwrap();
                assert_eq!((all.repeated, all.layers), (0, taken.layers + taken.repeated));
                if wave.wavenumber < 1.0 {
                    assert!(3 * taken.layers < all.layers, "{taken:?}");
                }
                let parts = |c: &Flexibility| [c.top, c.bottom, c.equal_top, c.equal_bottom, c.coupling];
                for (k, (value, expected)) in parts(&found).into_iter().zip(parts(&expected)).enumerate() {
                    // a laminate of unlike layers bends under equal loads: its response has the rounding error of bending
                    let bending = if k == 2 || k == 3 { 1e-14 * found.top } else { 0.0 };
                    assert!((value - expected).abs() <= 5e-14 * expected.abs() + bending, "{count} {wave:?}: {k}");
                }
                let [found, expected] = [&base, &plain_base].map(|base| base.flexibility(&wave).unwrap());
                assert!((found / expected - 1.0).abs() < 5e-14, "{count} {wave:?}: base");
            }
        }
    }
}
