//! The programme against the solver: nothing in common but the kernels.
use crate::contact::punch::Indentation;
use crate::contact::start;
use crate::kernel::Kernel;
use crate::stress::{Ranges, scene};
use crate::{Model, Options};

use super::{FINE, zones};

/// Ends are right to so many elements.
const ELEMENTS: f64 = 3.0;

#[test]
fn half_lengths_are_those_of_the_convex_programme() {
    let mut compared = 0;
    for number in 0.. {
        if compared == 100 {
            break;
        }
        let scene = scene(&Ranges::moderate(), 5, number).scene().unwrap();
        let stack = scene.stack().unwrap();
        let options = Options { tolerance: 1e-6, ..Options::default() };
        let Ok(solution) = Model::new(stack.clone()).unwrap().press_with(&scene.punch, scene.force, &options) else {
            continue;
        };
        let kernel = Kernel::new(&stack).unwrap();
        let indentation = Indentation::new(&scene.punch, &kernel, scene.force.number());
        let expected = start::half_lengths(&kernel, &indentation).unwrap();
        let zones = zones(&kernel, &indentation, &expected, 0.0).unwrap();
        for (zones, contact) in zones.iter().zip(solution.contacts()) {
            assert_eq!(zones.apart.len(), 1, "{number}: {zones:?}");
            let error = zones.end() * kernel.length() / contact.half_length - 1.0;
            assert!(error.abs() < ELEMENTS * FINE, "{number}, {}: {error}", contact.interface);
        }
        compared += 1;
    }
}
