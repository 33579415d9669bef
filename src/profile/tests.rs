//! Manufactured solutions: from pressures and ends that are chosen follow the profile of a punch and the gap between layers that make them.
use std::f64::consts::PI;

use faer::linalg::solvers::Solve;
use faer::{Col, Mat};
use recede_layers::{Exponential, HalfPlane, Homogeneous};

use crate::Model;
use crate::field::{FULL, FaceSide, Field};
use crate::geometry::Geometry;
use crate::numeric::largest;
use crate::scene::{Load, Punch};
use crate::solution::{Contact, Interface, Interval, Solution, Strip};
use crate::stack::{Stack, StackBuilder};

/// Terms of the polynomials that profile and gap are made of.
const TERMS: usize = 10;
/// Rows of the tables, and how far these reach, in half-lengths.
const ROWS: usize = 300;
const BEYOND: f64 = 1.05;
/// Slopes of a table of this number of rows, and so pressures, are right to this part.
const TABLE: f64 = 1e-6;
/// Half-lengths of the two contacts, and the force.
const ENDS: [f64; 2] = [0.5, 0.8];
const FORCE: f64 = 0.01;
/// What the second and third term of each pressure are of the first.
const SHAPES: [[f64; 2]; 2] = [[0.15, -0.04], [-0.1, 0.03]];

/// The pressure of a contact as it is chosen.
fn strip(contact: usize, is_round: bool) -> Strip {
    let (half, [second, third]) = (ENDS[contact], SHAPES[contact]);
    let first = FORCE / if is_round { 2.0 * PI / 3.0 * half * half } else { 0.5 * PI * half };
    Strip { is_round, ..Strip::series(half, vec![first, first * second, first * third]) }
}

/// A table of the even polynomial that is as high above x = 0 as a function is at some places up to the end of a contact, and by how much it misses the function between
/// these, over its height at the end.
fn table(end: f64, heights: impl Fn(&[f64]) -> Vec<f64>) -> (Punch, f64) {
    // every other place is a node
    let place = |k: usize| (0.25 * PI * k as f64 / TERMS as f64).sin();
    let heights = heights(&(0..=2 * TERMS).map(|k| end * place(k)).collect::<Vec<f64>>());
    let power = |s: f64, term: usize| s.powi(2 * (term as i32 + 1));
    let nodes = Mat::from_fn(TERMS, TERMS, |k, term| power(place(2 * k + 2), term));
    let terms = nodes.partial_piv_lu().solve(Col::from_fn(TERMS, |k| heights[2 * k + 2] - heights[0]));
    let height = |s: f64| (0..TERMS).map(|term| terms[term] * power(s, term)).sum::<f64>();
    let missed = largest((0..=2 * TERMS).map(|k| (heights[0] + height(place(k)) - heights[k]).abs()));
    // beyond the table there is no body that could touch
    let row = |k: usize| {
        let s = BEYOND * k as f64 / ROWS as f64;
        (end * s, height(s))
    };
    (Punch::table(&(0..=ROWS).map(row).collect::<Vec<_>>()).unwrap(), missed / height(1.0).abs())
}

#[test]
fn the_chosen_pressures_are_found() {
    for geometry in [Geometry::PlaneStrain, Geometry::Axisymmetric] {
        let is_round = geometry.is_axisymmetric();
        let strip_layer = || Homogeneous::new(1.0, 1.0, 0.25).unwrap();
        let thin = || Stack::builder(geometry).layer(strip_layer());
        // next to a graded face displacements are no polynomials
        let graded = || Exponential::new(0.7, 1.0, 0.25, 0.8).unwrap();
        let thick = || thin().bonded().layer(graded()).bonded().layer(strip_layer());
        let ground = |above: StackBuilder| above.layer(HalfPlane::new(0.7, 0.3).unwrap()).build().unwrap();
        let coated = |above: StackBuilder| {
            above.layer(Homogeneous::new(0.8, 3.0, 0.2).unwrap()).bonded().rigid().build().unwrap()
        };
        let gapless = [ground(thin().receding()), coated(thick().receding())];
        for (number, stack) in gapless.into_iter().enumerate() {
            // the field of the chosen pressures, in a solution of another load
            let model = Model::new(stack.clone()).unwrap();
            let solved = model.press(Load::uniform(0.3).unwrap(), FORCE).unwrap();
            let contact = |(k, interface): (usize, Interface)| {
                let intervals = vec![Interval::new([-ENDS[k], 0.0], [ENDS[k], 0.0])];
                Contact::new(interface, intervals, vec![strip(k, is_round)], Some(0.0), [1.0, 0.0], Vec::new())
            };
            let contacts: Vec<Contact> = stack.contacts().into_iter().enumerate().map(contact).collect();
            let field = Field::new(&stack, &Solution { contacts, ..solved });
            let last = stack.laminates()[0].layers().len();
            let face = |layer: usize, side: FaceSide, x: &[f64]| -> Vec<f64> {
                let faces = field.faces(x, &FULL).unwrap();
                let own = faces.iter().find(|face| face.layer == layer && face.side == side).unwrap();
                own.points.iter().map(|point| point.v).collect()
            };
            let (punch, missed) = table(ENDS[0], |x| face(1, FaceSide::Top, x));
            let (gap, missed_gap) = table(ENDS[1], |x| {
                let [above, below] = [face(last, FaceSide::Bottom, x), face(last + 1, FaceSide::Top, x)];
                below.iter().zip(&above).map(|(below, above)| below - above).collect()
            });
            assert!(100.0 * missed.max(missed_gap) < TABLE, "{geometry:?} {number}: {missed} {missed_gap}");
            let with_gap = match number {
                0 => ground(thin().receding_from(gap)),
                _ => coated(thick().receding_from(gap)),
            };
            let found = Model::new(with_gap).unwrap().press(punch, FORCE).unwrap();
            for (k, contact) in found.contacts().iter().enumerate() {
                assert!(
                    (contact.reach() / ENDS[k] - 1.0).abs() < TABLE,
                    "{geometry:?} {number} {k}: {}",
                    contact.reach()
                );
                let expected = strip(k, is_round);
                let middle = expected.pressure(0.0);
                for x in [0.0, 0.3, 0.6, 0.9].map(|part| part * ENDS[k]) {
                    let (found, expected) = (contact.pressure(x), expected.pressure(x));
                    assert!(
                        (found - expected).abs() < TABLE * middle,
                        "{geometry:?} {number} {k} {x}: {found} {expected}"
                    );
                }
            }
        }
    }
}
