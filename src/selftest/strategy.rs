//! Scenes drawn at random from ranges.
use std::ops::RangeInclusive;

use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use recede_layers::Plane;

use super::load;
use super::scenario::{Ply, Scenario, ScenarioUnits};

/// Ranges of the numbers of a random scene. Ratios are spread evenly on a logarithmic scale, and the ends of
/// a range are drawn more often than their share.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranges {
    /// How many layers there are above the base.
    pub layers: RangeInclusive<usize>,
    /// How many interfaces are receding at most.
    pub receding: usize,
    /// Ratio of two layers' thicknesses at most, dimensionless.
    pub thickness_ratio: f64,
    /// Ratio of the shear moduli of two layers, or of a layer and the half-plane, at most, dimensionless; the modulus of a graded
    /// layer is taken at its top face.
    pub modulus_ratio: f64,
    /// Largest |βh| of a graded layer, dimensionless.
    pub steepness: f64,
    /// Poisson's ratios, dimensionless.
    pub poisson: RangeInclusive<f64>,
    /// Half-length under the punch over the thickness of all layers, a/H, dimensionless. The half-length obtained differs from
    /// the one aimed at by some ten per cent.
    pub half_length: RangeInclusive<f64>,
    /// Radius of the punch over half-length, R/a, dimensionless.
    pub radius: RangeInclusive<f64>,
    /// In which units: other units make other numbers of the same scenes.
    pub units: ScenarioUnits,
}

impl Default for Ranges {
    /// The ranges that the solver is designed for.
    fn default() -> Self {
        Self {
            layers: 1..=6,
            receding: 3,
            thickness_ratio: 1e3,
            modulus_ratio: 1e4,
            steepness: 8.0,
            poisson: -0.5..=0.5,
            half_length: 1.2e-4..=8.5,
            radius: 2.0..=1e4,
            units: ScenarioUnits::default(),
        }
    }
}

impl Ranges {
    /// Scenes as they occur in practice: few layers of similar thickness and stiffness, contacts shorter than they are
    /// thick.
    pub fn moderate() -> Self {
        Self {
            layers: 1..=3,
            thickness_ratio: 25.0,
            modulus_ratio: 25.0,
            steepness: 3.0,
            poisson: 0.0..=0.5,
            half_length: 0.01..=1.0,
            radius: 20.0..=5e3,
            ..Self::default()
        }
    }
}

/// Random legal scenes: homogeneous and graded layers, bonded and receding, on a half-plane or a rigid base, in plane
/// strain and plane stress, under either punch.
pub fn scenes(ranges: &Ranges) -> impl Strategy<Value = Scenario> + use<> {
    let stack = {
        let (ply, receding) = (ply(ranges), ranges.receding);
        ranges.layers.clone().prop_flat_map(move |count| {
            let places: Vec<usize> = (0..count).collect();
            let receding = prop::sample::subsequence(places, 0..=receding.min(count));
            (prop::collection::vec(ply.clone(), count), receding)
        })
    };
    let half_plane = (even(1.0 / ranges.modulus_ratio.sqrt()..=ranges.modulus_ratio.sqrt()), poisson(ranges));
    let base = prop_oneof![2 => half_plane.prop_map(Some), 1 => Just(None)];
    let plane = prop_oneof![Just(Plane::Strain), Just(Plane::Stress)];
    let punch = (any::<bool>(), even(ranges.radius.clone()), even(ranges.half_length.clone()));
    let units = ranges.units;
    (stack, base, plane, punch).prop_map(move |((mut layers, receding), base, plane, (cylinder, blunt, long))| {
        receding.into_iter().for_each(|i| layers[i].receding = true);
        let mut scenario = Scenario { plane, layers, base, cylinder, radius: 1.0, force: 1.0 };
        let half_length = long * scenario.thickness();
        scenario.radius = blunt * half_length;
        scenario.force = load::force(&scenario, half_length);
        scenario.in_units(units)
    })
}

/// One of the [`scenes`]: the same seed and number give the same scene, whatever else is drawn.
pub fn scene(ranges: &Ranges, seed: u64, number: u64) -> Scenario {
    drawn(&scenes(ranges), seed, number)
}

/// The value of a strategy for a seed and a number.
pub(super) fn drawn<S: Strategy>(strategy: &S, seed: u64, number: u64) -> S::Value {
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    bytes[8..16].copy_from_slice(&number.to_le_bytes());
    let source = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    let mut runner = TestRunner::new_with_rng(Config::default(), source);
    loop {
        // nothing is filtered out, so the first is always there
        if let Ok(tree) = strategy.new_tree(&mut runner) {
            return tree.current();
        }
    }
}

fn ply(ranges: &Ranges) -> impl Strategy<Value = Ply> + Clone + use<> {
    let spread = |ratio: f64| even(1.0 / ratio.sqrt()..=ratio.sqrt());
    let steep = ranges.steepness;
    let steepness = prop_oneof![
        10 => Just(None),
        7 => (-steep..=steep).prop_map(Some),
        1 => Just(Some(-steep)),
        1 => Just(Some(steep)),
        // next to homogeneous, where closed forms are in danger
        1 => (even(1e-12..=1.0), any::<bool>()).prop_map(|(size, up)| Some(if up { size } else { -size })),
    ];
    (spread(ranges.thickness_ratio), spread(ranges.modulus_ratio), poisson(ranges), steepness).prop_map(
        |(thickness, modulus, poisson, steepness)| Ply { thickness, modulus, poisson, steepness, receding: false },
    )
}

fn poisson(ranges: &Ranges) -> impl Strategy<Value = f64> + Clone + use<> {
    let (least, most) = (*ranges.poisson.start(), *ranges.poisson.end());
    prop_oneof![7 => least..=most, 1 => Just(least), 1 => Just(most), 1 => Just(0.0)]
}

/// Positive numbers, evenly on a logarithmic scale.
fn even(range: RangeInclusive<f64>) -> impl Strategy<Value = f64> + Clone + use<> {
    let (least, most) = range.into_inner();
    prop_oneof![
        8 => (least.ln()..=most.ln()).prop_map(f64::exp),
        1 => Just(least),
        1 => Just(most),
    ]
}
