//! The printed block matrix is the one that is computed.
//!
//! Goal: the symbolic matrix of a stack, filled with the layers' face states at one wavenumber and solved as a dense
//! system, moves the faces as the elimination along chains does, to nine digits.
//!
//! ```text
//!   row:    punch S     +S(top)                          = -p0
//!           punch T     +T(top)                          =  0       A x = b, one column b for each contact
//!           1|2 U       +U(bottom)   -U(top)             =  0
//!           ...            ↑ 1×4        ↑ 1×4
//!           2|3 S above              +S(bottom)          = -p1      V at a face = row V of its states · x
//!   column:             layer 1      layer 2      half-plane
//! ```
use nalgebra::{DMatrix, DVector, RowDVector};
use proptest::prelude::*;
use recede::layers::Body;
use recede::{
    BaseChain, BlockSystem, Exponential, Face, FaceStates, FreeChain, HalfPlane, Homogeneous, InterfaceSide, Item,
    Plane, Quantity, Relation, RightHandSide, Scene, Spring, Stack, Wave, Winkler,
};

/// Relative error allowed: the dense system is solved without any care for digits.
const SAME: f64 = 1e-9;

/// A quantity at a face as a linear function of the layer's amplitudes.
fn row(body: &Body, face: Face, quantity: Quantity, wave: &Wave) -> RowDVector<f64> {
    let index = quantity.index();
    let states = match body {
        Body::Layer(layer) => layer.face_states(wave),
        Body::Support(support) => FaceStates::HalfPlane { top: support.face_states(wave) },
    };
    match (states, face) {
        (FaceStates::Finite { top, .. }, Face::Top) => RowDVector::from_iterator(4, top.row(index).iter().copied()),
        (FaceStates::Finite { bottom, .. }, Face::Bottom) => {
            RowDVector::from_iterator(4, bottom.row(index).iter().copied())
        }
        (FaceStates::HalfPlane { top }, Face::Top) => RowDVector::from_iterator(2, top.row(index).iter().copied()),
        (FaceStates::HalfPlane { .. }, Face::Bottom) => panic!("a half-plane has no bottom"),
    }
}

/// The block system at one wavenumber, solved for a unit pressure at each contact.
struct Dense<'a> {
    system: &'a BlockSystem,
    wave: Wave,
    solutions: Vec<DVector<f64>>,
}

impl<'a> Dense<'a> {
    fn new(system: &'a BlockSystem, contacts: usize, wave: Wave) -> Self {
        let n = system.unknowns();
        let mut matrix = DMatrix::<f64>::zeros(n, n);
        let mut loads = DMatrix::zeros(n, contacts);
        for (i, row_) in system.rows().iter().enumerate() {
            for block in row_.blocks.iter() {
                let column = &system.columns()[block.column];
                assert_eq!(column.number(), block.layer);
                let states = row(column.body(), block.face, block.quantity, &wave);
                // the states are displacements times λμ₀
                let stiffness = block.stiffness.map_or(1.0, |k| k / (wave.wavenumber * wave.modulus));
                let sign = if block.negative { -stiffness } else { stiffness };
                for (amplitude, state) in column.amplitudes().zip(states.iter()) {
                    matrix[(i, amplitude - 1)] += sign * state;
                }
            }
            match row_.right {
                Some(RightHandSide::Pressure(contact)) => loads[(i, contact)] = -1.0,
                // as the displacements, times λμ₀
                Some(RightHandSide::Gap(contact)) => loads[(i, contact)] = 1.0,
                None => {}
            }
        }
        // amplitudes differ in size from layer to layer
        let scales: Vec<f64> = matrix.column_iter().map(|column| column.norm().recip()).collect();
        for (mut column, scale) in matrix.column_iter_mut().zip(&scales) {
            column *= *scale;
        }
        let scaled = matrix.full_piv_lu().solve(&loads).expect("a regular block matrix");
        let unscaled = |column: usize| DVector::from_fn(n, |i, _| scales[i] * scaled[(i, column)]);
        Self { system, wave, solutions: (0..contacts).map(unscaled).collect() }
    }

    /// λμ₀V at a face of a layer under a unit pressure at a contact.
    fn deflection(&self, number: usize, face: Face, contact: usize) -> f64 {
        self.amplitude(number, face, Quantity::V, contact)
    }

    /// A quantity at a face of a layer where a contact has a unit pressure or gap; displacements times λμ₀.
    fn amplitude(&self, number: usize, face: Face, quantity: Quantity, contact: usize) -> f64 {
        let column = self.system.columns().iter().find(|column| column.number() == number).expect("a layer");
        let first = column.amplitudes().start() - 1;
        let states = row(column.body(), face, quantity, &self.wave);
        states.iter().enumerate().map(|(i, state)| state * self.solutions[contact][first + i]).sum()
    }
}

/// Where weights press layers together, the printed gap rows make the pressures of the inverse of all compliances, and a pressure on top the pressures below.
#[test]
fn gaps_that_are_prescribed_make_pressures() {
    let layer = |modulus: f64| {
        format!("Homogeneous(thickness: 0.7, shear_modulus: {modulus:?}, poisson: 0.25, specific_weight: 1)")
    };
    let text = format!(
        "Scene(geometry: PlaneStrain, load: Line, force: 1.0, stack: [{}, Receding, {}, Bonded, {}, Receding, {}, Receding, HalfPlane(shear_modulus: 0.9, poisson: 0.3)])",
        layer(1.0),
        layer(2.0),
        layer(0.5),
        layer(3.0)
    );
    let stack = Scene::from_ron(&text).unwrap().stack().unwrap();
    for wavenumber in [0.3, 1.0, 4.0] {
        let wave = Wave { wavenumber, modulus: 1.7, plane: stack.plane() };
        let (system, pressed) = (BlockSystem::new(&stack), BlockSystem::pressed(&stack));
        assert!(pressed.to_string().contains("= g3") && !pressed.to_string().contains("= -p1"), "{pressed}");
        let dense = Dense::new(&pressed, 4, wave);
        // λμ₀ times the gap that pressures on all contacts make, the one on top with the number 0
        let mut gaps = DMatrix::<f64>::zeros(4, 4);
        for (i, laminate) in FreeChain::all(&system).iter().enumerate() {
            let chain = laminate.flexibility(&wave).unwrap();
            gaps[(i, i)] += chain.top;
            gaps[(i + 1, i + 1)] -= chain.bottom;
            (gaps[(i, i + 1)], gaps[(i + 1, i)]) = (chain.coupling, chain.coupling);
        }
        gaps[(3, 3)] += BaseChain::of(&system).flexibility(&wave).unwrap();
        let below = gaps.view((1, 1), (3, 3)).into_owned();
        let inverse = below.try_inverse().unwrap();
        let largest = inverse.amax();
        for (i, number) in [(0, 1), (1, 3), (2, 4)] {
            for j in 0..3 {
                let found = -dense.amplitude(number, Face::Bottom, Quantity::S, j + 1);
                assert!((found - inverse[(i, j)]).abs() < 1e-9 * largest, "{i} {j}: {found} {}", inverse[(i, j)]);
            }
            let carried = -(0..3).map(|j| inverse[(i, j)] * gaps[(j + 1, 0)]).sum::<f64>();
            let found = -dense.amplitude(number, Face::Bottom, Quantity::S, 0);
            assert!((found - carried).abs() < 1e-9, "{i}: {found} {carried}");
        }
    }
}

/// Compares all faces that a contact can move.
fn examine(stack: &Stack, wavenumber: f64) -> Result<(), String> {
    examine_system(&BlockSystem::new(stack), stack, wavenumber)
}

fn examine_system(system: &BlockSystem, stack: &Stack, wavenumber: f64) -> Result<(), String> {
    let wave = Wave { wavenumber, modulus: 1.7, plane: stack.plane() };
    let contacts = stack.contacts().len();
    let dense = Dense::new(system, contacts, wave);
    let same = |what: &str, found: f64, expected: f64, scale: f64| {
        let error = (found - expected).abs();
        let legal = error <= SAME * scale;
        legal.then_some(()).ok_or(format!("λ = {wavenumber}: {what}: {found:e} is not {expected:e}\n{system}"))
    };
    let free = FreeChain::all(system);
    assert_eq!(free.len(), stack.laminates().len());
    for (i, laminate) in stack.laminates().iter().enumerate() {
        let chain = free[i].flexibility(&wave).expect("finite");
        let (first, last) = (laminate.layers()[0].number, laminate.layers().last().expect("a layer").number);
        // pressure p = 1 is S = −1
        let c_tt = -dense.deflection(first, Face::Top, i);
        let c_tb = -dense.deflection(first, Face::Top, i + 1);
        let c_bt = -dense.deflection(last, Face::Bottom, i);
        let c_bb = -dense.deflection(last, Face::Bottom, i + 1);
        let scale = (c_tt * c_bb).abs().sqrt();
        same("top", c_tt, chain.top, chain.top)?;
        same("bottom", c_bb, chain.bottom, chain.bottom.abs())?;
        same("top under a load on the bottom", c_tb, chain.coupling, scale)?;
        same("bottom under a load on the top", c_bt, -chain.coupling, scale)?;
        same("top under equal loads", c_tt + c_tb, chain.equal_top, chain.top)?;
        same("bottom under equal loads", c_bt + c_bb, chain.equal_bottom, chain.bottom.abs())?;
    }
    let base = stack.base();
    let expected = BaseChain::of(system).flexibility(&wave).expect("finite");
    match base.layers().first().or(base.foundation().half_plane()) {
        Some(top) => same("base", -dense.deflection(top.number, Face::Top, contacts - 1), expected, expected),
        // nothing there that could move
        None => same("rigid base", 0.0, expected, 0.0),
    }
}

fn layer() -> impl Strategy<Value = Item> {
    let steepness = prop_oneof![Just(0.0), Just(1e-12), -3.0..3.0];
    (0.1..3.0f64, 0.05..20.0f64, 0.0..=0.5f64, steepness).prop_map(|(thickness, modulus, poisson, steepness)| {
        if steepness == 0.0 {
            Item::layer(Homogeneous::new(thickness, modulus, poisson).unwrap())
        } else {
            Item::layer(Exponential::new(thickness, modulus, poisson, steepness / thickness).unwrap())
        }
    })
}

fn interface() -> impl Strategy<Value = Item> {
    let stiffness = || (1e-3f64.ln()..1e3f64.ln()).prop_map(f64::exp);
    let springs = (stiffness(), prop::option::of(stiffness()))
        .prop_map(|(normal, tangential)| Item::Spring(Spring::new(normal, tangential).unwrap()));
    prop_oneof![
        3 => Just(Item::Bonded),
        2 => Just(Item::Receding),
        1 => Just(Item::Sliding),
        1 => springs,
    ]
}

fn base() -> impl Strategy<Value = Item> {
    let ground = |(modulus, poisson)| Item::layer(HalfPlane::new(modulus, poisson).unwrap());
    let springs = |(stiffness, along)| Item::support(Winkler::new(stiffness).unwrap().sticking(along).unwrap());
    prop_oneof![
        Just(Item::Rigid),
        (0.05..20.0f64, 0.0..=0.5f64).prop_map(ground),
        (0.05..20.0f64, 0.05..20.0f64).prop_map(springs)
    ]
}

/// Kinds of interfaces that no scene can write, each told by its relations alone: what has one is printed, taken apart into
/// chains and eliminated like any other.
fn new_kinds() -> [(&'static str, [Relation; 4]); 3] {
    use InterfaceSide::{Above, Below};
    use Quantity::{S, T, U, V};
    let continuous = |quantity| Relation::zero([Above.of(quantity), -Below.of(quantity)]);
    let zero = |side: InterfaceSide, quantity| Relation::zero([side.of(quantity)]);
    [
        // no wave stretches it, so the shear stress jumps
        ("an inextensible film", [zero(Above, U), continuous(V), continuous(S), zero(Below, U)]),
        (
            "fibres held by springs",
            [
                continuous(U),
                continuous(V),
                continuous(S),
                Relation::zero([Above.of(T), -Below.of(T), -Above.of(U).times(0.6)]),
            ],
        ),
        // pins in slots: u is continuous, and nothing presses
        ("slots", [continuous(U), zero(Above, S), continuous(T), zero(Below, S)]),
    ]
}

#[test]
fn a_new_kind_of_interface_is_its_relations() {
    let strip = |thickness, modulus| Homogeneous::new(thickness, modulus, 0.3).unwrap();
    let graded = Exponential::new(0.5, 2.0, 0.2, 1.5).unwrap();
    let above = || Stack::builder(Plane::Strain).layer(strip(0.7, 1.0)).bonded().layer(graded).bonded();
    let ground = HalfPlane::new(0.5, 0.3).unwrap();
    let stacks = [
        above().layer(strip(0.4, 3.0)).receding().layer(strip(0.8, 1.0)).bonded().layer(ground),
        above().layer(strip(0.4, 3.0)).bonded().rigid(),
        above().layer(ground),
    ];
    for (name, relations) in new_kinds() {
        for stack in stacks.clone().map(|stack| stack.build().unwrap()) {
            let system = BlockSystem::with_joints(&stack, |_| relations).unwrap();
            assert_eq!(system.rows().len(), system.unknowns(), "{name}\n{system}");
            for wavenumber in [0.1, 0.4, 1.0, 3.0, 10.0] {
                examine_system(&system, &stack, wavenumber).unwrap_or_else(|error| panic!("{name}: {error}"));
            }
        }
    }
}

#[test]
fn conditions_are_as_many_as_determine_the_amplitudes() {
    use InterfaceSide::{Above, Below};
    use Quantity::{S, T, U, V};
    let strip = |thickness| Homogeneous::new(thickness, 1.0, 0.3).unwrap();
    let two = || Stack::builder(Plane::Strain).layer(strip(0.7)).bonded().layer(strip(0.4));
    let on_rigid = two().bonded().rigid().build().unwrap();
    let on_ground = two().bonded().layer(HalfPlane::new(0.5, 0.3).unwrap()).build().unwrap();
    let count = |stack: &Stack, relations: [Relation; 4]| {
        let error = BlockSystem::with_joints(stack, |_| relations).unwrap_err();
        (error.layer, error.face, error.found, error.needed)
    };
    let continuous = |quantity| Relation::zero([Above.of(quantity), -Below.of(quantity)]);
    // nothing said of T
    let too_few = [continuous(U), continuous(V), continuous(S), Relation::zero([])];
    assert_eq!(count(&on_ground, too_few), (1, Face::Bottom, 3, 4));
    // between layers these are four conditions, and on a rigid base as many, two too many
    let too_many = [U, V, S, T].map(|quantity| Relation::zero([Above.of(quantity), -Below.of(U)]));
    assert_eq!(count(&on_rigid, too_many), (2, Face::Bottom, 4, 2));
    assert!(BlockSystem::with_joints(&on_ground, |_| too_many).is_ok());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn chains_solve_the_printed_matrix(
        above in prop::collection::vec((layer(), interface()), 1..7),
        base in base(),
        plane in prop_oneof![Just(Plane::Strain), Just(Plane::Stress)],
        reach in (0.3f64.ln()..20f64.ln()).prop_map(f64::exp),
    ) {
        let stack_ends_loose = matches!(above.last(), Some((_, Item::Receding)));
        let mut stack = Stack::builder(plane);
        for (layer, interface) in above {
            stack = stack.item(layer).item(interface);
        }
        // nothing lies loose on springs
        prop_assume!(!matches!((&base, stack_ends_loose), (Item::Support(_), true)));
        let stack = stack.item(base).build().unwrap();
        let examined = examine(&stack, reach / stack.total_thickness());
        prop_assert!(examined.is_ok(), "{}", examined.unwrap_err());
    }
}

#[test]
fn the_stack_of_the_paper() {
    let stack = Stack::builder(Plane::Strain)
        .layer(Homogeneous::new(1.0, 1.0, 0.25).unwrap())
        .bonded()
        .layer(Exponential::new(1.0, 1.0, 0.25, -1.0).unwrap())
        .receding()
        .layer(HalfPlane::new(1.0, 0.25).unwrap())
        .build()
        .unwrap();
    for wavenumber in [0.15, 0.5, 1.0, 2.0, 5.0, 10.0] {
        examine(&stack, wavenumber).unwrap();
    }
}

#[test]
fn twenty_layers() {
    let mut stack = Stack::builder(Plane::Strain);
    for i in 0..20 {
        let modulus = [0.3, 1.0, 4.0][i % 3];
        stack = stack.layer(Homogeneous::new(0.05, modulus, 0.3).unwrap());
        stack = if i == 9 { stack.receding() } else { stack.bonded() };
    }
    let stack = stack.layer(HalfPlane::new(2.0, 0.3).unwrap()).build().unwrap();
    for wavenumber in [0.3, 1.0, 3.0, 20.0] {
        examine(&stack, wavenumber).unwrap();
    }
}
