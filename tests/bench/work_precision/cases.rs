//! The scenes of the diagram, what is known of each, and how the paper's method sees it.
use std::collections::BTreeMap;
use std::path::Path;

use recede::{BaseChain, BlockSystem, Flexibility, FreeChain, Item, Model, Options, Plane, Scene, Stack, Wave};

use super::literal::Transforms;
use super::literal::determinants::Paper;

/// One scene.
pub struct Case {
    pub title: &'static str,
    pub scene: Scene,
    /// Half-lengths and pressures at x = 0, contact by contact.
    pub truth: Vec<f64>,
    /// Its transforms from the paper's determinants, if it is one of the paper's scenes; else from `chains`.
    pub literal: Option<Paper>,
    /// The same transforms from the library's flexibilities, which take less time.
    pub chains: Chains,
    /// Thickness that sets the cut-offs of the literal method.
    pub thinnest: f64,
}

/// Title, file below `tests`, and the paper's parameters if the scene is one of its own.
const CASES: [(&str, &str, Option<Paper>); 6] = [
    ("Table 1 (500, 1000)", "data/scenes/table1_R500_load1000.ron", Some(paper(1.0, 0.0, 0.0))),
    ("Table 2 (β = −1, 500, 100)", "data/scenes/table2_beta-1_R500_load100.ron", Some(paper(0.0, 1.0, -1.0))),
    ("full model, β = −1", "data/scenes/full_beta-1_R500.ron", Some(paper(1.0, 1.0, -1.0))),
    ("full model, β = 1", "data/scenes/full_beta1_R500.ron", Some(paper(1.0, 1.0, 1.0))),
    ("thin coating", "bench/scenes/thin_coating.ron", None),
    ("two receding interfaces", "data/scenes/two_strips_loose.ron", None),
];

const fn paper(h1: f64, h2: f64, beta: f64) -> Paper {
    Paper { h1, h2, beta, kappa: 2.0, mu3: 1.0 }
}

/// An independent value is the truth if it claims fewer errors than this; else the Galerkin solver's tightest answer is.
const TRUSTED: f64 = 1e-13;

#[derive(serde::Deserialize)]
struct Known {
    half_length: Vec<f64>,
    half_length_err: Vec<f64>,
    peak_pressure: Vec<f64>,
    peak_pressure_err: Vec<f64>,
}

/// Reads all scenes and finds the truth about each.
pub fn all() -> Vec<Case> {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let text = std::fs::read_to_string(tests.join("data/contact.json")).expect("reference values");
    let known: BTreeMap<String, Known> = serde_json::from_str(&text).expect("reference values");
    let case = |(title, file, paper): (&'static str, &str, Option<Paper>)| {
        let file = tests.join(file);
        let scene = Scene::read(&file).expect("a scene of the project");
        let name = file.file_stem().expect("a file has a name").to_string_lossy().into_owned();
        let stack = scene.stack().expect("a legal stack");
        let truth = truth(&scene, known.get(&name));
        let chains = Chains::new(&stack);
        if let Some(paper) = &paper {
            same(paper, &chains);
        }
        Case { title, truth, literal: paper, chains, thinnest: thinnest(&stack), scene }
    };
    CASES.into_iter().map(case).collect()
}

impl Case {
    /// The transforms as the literal method has them.
    pub fn literal(&self) -> &dyn Transforms {
        self.literal.as_ref().map_or(&self.chains as &dyn Transforms, |paper| paper)
    }
}

/// Half-lengths and pressures at x = 0 of a solution.
pub fn values(solution: &recede::Solution) -> Vec<f64> {
    solution.contacts().iter().flat_map(|contact| [contact.half_length().unwrap(), contact.central_pressure]).collect()
}

fn truth(scene: &Scene, known: Option<&Known>) -> Vec<f64> {
    let model = Model::new(scene.stack().expect("a legal stack")).expect("a legal model");
    let options = Options { tolerance: 1e-13 };
    let solution = model.press_with(&scene.top, scene.force, &options).expect("a solution");
    let mut truth = values(&solution);
    if let Some(known) = known {
        for i in 0..known.half_length.len() {
            let listed = [
                (known.half_length[i], known.half_length_err[i]),
                (known.peak_pressure[i], known.peak_pressure_err[i]),
            ];
            for (k, (value, error)) in listed.into_iter().enumerate() {
                let off = (truth[2 * i + k] / value - 1.0).abs();
                assert!(off < 1e-11 + 2.0 * error, "{:?}: off the reference by {off:e}", scene.name);
                if error < TRUSTED {
                    truth[2 * i + k] = value;
                }
            }
        }
    }
    truth
}

fn thinnest(stack: &Stack) -> f64 {
    let layers = stack.laminates().iter().flat_map(|laminate| laminate.layers().iter()).chain(stack.base().layers());
    layers.filter_map(|placed| placed.layer.thickness()).fold(f64::INFINITY, f64::min)
}

/// The paper's determinants and the library's chains are the same functions.
fn same(paper: &Paper, chains: &Chains) {
    let all = |(own, coupling): (Vec<f64>, Vec<[f64; 2]>)| [own, coupling.concat()].concat();
    for lambda in [0.1, 1.0, 5.0] {
        for (one, other) in all(paper.at(lambda)).into_iter().zip(all(chains.at(lambda))) {
            assert!((one - other).abs() < 1e-8 * other.abs(), "λ = {lambda}: {one} is not {other}");
        }
    }
    for (one, other) in paper.limits().into_iter().zip(chains.limits()) {
        assert!((one / other - 1.0).abs() < 1e-8, "limit {one} is not {other}");
    }
}

/// Any other stack: the same transforms, from the library's flexibilities.
pub struct Chains {
    laminates: Vec<FreeChain>,
    base: BaseChain,
    plane: Plane,
}

impl Chains {
    pub fn new(stack: &Stack) -> Self {
        let system = BlockSystem::new(stack);
        Self { laminates: FreeChain::all(&system), base: BaseChain::of(&system), plane: system.plane() }
    }
}

impl Transforms for Chains {
    fn at(&self, lambda: f64) -> (Vec<f64>, Vec<[f64; 2]>) {
        let wave = Wave { wavenumber: lambda, modulus: 1.0, plane: self.plane };
        let laminates: Vec<Flexibility> =
            self.laminates.iter().map(|chain| chain.flexibility(&wave).expect("a flexibility")).collect();
        let base = self.base.flexibility(&wave).expect("a flexibility");
        let mut own: Vec<f64> = laminates.iter().map(|c| c.top).chain([base]).collect();
        laminates.iter().enumerate().for_each(|(i, c)| own[i + 1] -= c.bottom);
        (own, laminates.iter().map(|c| [c.coupling; 2]).collect())
    }

    fn limits(&self) -> Vec<f64> {
        self.at(1e9).0
    }
}

/// So many bonded layers that rest on a half-plane: stiff and soft ones in turn, of thickness 1 in all, each stiffer than the
/// one before it by this part besides.
pub fn bonded_layers(count: usize, difference: f64) -> Stack {
    let layer = |i: usize| {
        let modulus = if i.is_multiple_of(2) { 1.0 } else { 2.0 } * (1.0 + difference * i as f64);
        Item::layer(recede::Homogeneous::new(1.0 / count as f64, modulus, 0.25).expect("a layer"))
    };
    let mut builder = Stack::builder(Plane::Strain).item(layer(0));
    for i in 1..count {
        builder = builder.bonded().item(layer(i));
    }
    builder.receding().layer(recede::HalfPlane::new(1.0, 0.25).expect("a half-plane")).build().expect("a stack")
}
