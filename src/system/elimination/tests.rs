//! There are as many rows as amplitudes, and fields inside the layers satisfy the rows that are printed.
use proptest::prelude::*;
use recede_layers::{Exponential, HalfPlane, Homogeneous, Plane, State, Wave};

use super::{BaseChain, FaceLoad, FreeChain};
use crate::scene::{Item, Spring};
use crate::stack::Stack;
use crate::system::{Block, BlockSystem, Component, Face};

/// The states at the top and at the bottom face of each layer of a chain; of a half-plane twice at the top.
type AtFaces = Vec<Vec<State>>;

fn depths(component: &Component<'_>) -> Vec<Vec<f64>> {
    let of = |thickness: Option<f64>| vec![0.0, thickness.unwrap_or(0.0)];
    component.columns().iter().map(|column| of(column.body().layer().and_then(|layer| layer.thickness()))).collect()
}

/// Rows may be wrong by this part of their largest term ...
const OF_TERMS: f64 = 1e-8;
/// ... and by this part of the loads, of which stresses keep eleven digits.
const OF_LOADS: f64 = 1e-11;

/// The largest residual of the rows of a component under loads S on its faces, in parts of what is allowed.
fn residual(component: &Component<'_>, states: &AtFaces, loads: [f64; 2], wave: &Wave) -> f64 {
    let place = |layer: usize| component.columns().iter().position(|column| column.number() == layer).unwrap();
    let mut worst: f64 = 0.0;
    for interface in 0..=component.columns().len() {
        for row in component.rows_at(interface) {
            let right = match (row.right, interface) {
                (None, _) => 0.0,
                (Some(_), 0) => loads[0],
                _ => loads[1],
            };
            let (mut sum, mut largest) = (-right, 0.0);
            for block in row.blocks.iter() {
                let state = states[place(block.layer)][if block.face == Face::Top { 0 } else { 1 }];
                let factor = block.stiffness.map_or(1.0, |stiffness| stiffness / (wave.wavenumber * wave.modulus));
                let term = factor * state[block.quantity.index()] * if block.negative { -1.0 } else { 1.0 };
                sum += term;
                largest = f64::max(largest, term.abs());
            }
            let allowed = OF_TERMS * largest + OF_LOADS * loads[0].abs().max(loads[1].abs());
            worst = worst.max(sum.abs() / allowed);
        }
    }
    worst
}

fn interface() -> impl Strategy<Value = Item> {
    let springs = (0.01..100.0f64, prop::option::of(0.01..100.0f64))
        .prop_map(|(normal, tangential)| Item::Spring(Spring::new(normal, tangential).unwrap()));
    prop_oneof![2 => Just(Item::Bonded), 1 => Just(Item::Receding), 1 => Just(Item::Sliding), 1 => springs]
}

fn layer() -> impl Strategy<Value = Item> {
    (0.1..3.0f64, 0.05..20.0f64, -3.0..3.0f64).prop_map(|(thickness, modulus, steepness)| {
        if steepness < 0.0 {
            Item::layer(Homogeneous::new(thickness, modulus, 0.3).unwrap())
        } else {
            Item::layer(Exponential::new(thickness, modulus, 0.3, steepness / thickness).unwrap())
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn fields_inside_obey_the_rows(
        above in prop::collection::vec((layer(), interface()), 1..7),
        rigid in any::<bool>(),
        lambda_h in (0.3f64.ln()..20f64.ln()).prop_map(f64::exp),
    ) {
        let stack = above.into_iter().fold(Stack::builder(Plane::Strain), |stack, (layer, interface)| {
            stack.item(layer).item(interface)
        });
        let stack = if rigid { stack.rigid() } else { stack.layer(HalfPlane::new(0.7, 0.3).unwrap()) }.build().unwrap();
        let system = BlockSystem::new(&stack);
        prop_assert_eq!(system.rows().len(), system.unknowns());
        // a block next to the diagonal at most: the matrix is a chain
        let is_next = |pair: &[Block]| [0, 1].contains(&(pair[1].column - pair[0].column));
        let mut rows = system.rows().iter();
        prop_assert!(rows.all(|row| matches!(row.blocks.len(), 1..=3) && row.blocks.windows(2).all(is_next)));
        let wave = Wave { wavenumber: lambda_h / stack.total_thickness(), modulus: 1.7, plane: Plane::Strain };
        let components = system.components();
        let free = FreeChain::all(&system);
        for (component, chain) in components.iter().filter(|component| component.is_free()).zip(&free) {
            for load in [
                FaceLoad { top: 1.0, bottom: 0.0, equal: 0.0 },
                FaceLoad { top: 0.0, bottom: 1.0, equal: 0.0 },
                FaceLoad { top: 0.2, bottom: -0.1, equal: 1.0 },
            ] {
                let states = chain.states(&wave, &depths(component), &load).unwrap();
                let found = residual(component, &states, [load.top + load.equal, load.bottom + load.equal], &wave);
                prop_assert!(found < 1.0, "{found:e}\n{system}");
            }
        }
        if let Some(component) = components.iter().find(|component| !component.is_free()) {
            let states = BaseChain::of(&system).states(&wave, &depths(component), 1.0).unwrap();
            let found = residual(component, &states, [1.0, 0.0], &wave);
            prop_assert!(found < 1.0, "{found:e}\n{system}");
        }
    }
}
