//! The rival of the benchmark: the fast way to assemble its equations gives what the literal one does.
#[path = "bench/literal/mod.rs"]
mod literal;

use literal::determinants::Paper;
use literal::{Collocation, Problem, Settings, vectorised};

#[test]
fn matrix_products_give_the_literal_answer() {
    for (h1, h2, beta, start) in [(1.0, 0.0, 0.0, [1.3, 1.9]), (1.0, 1.0, -1.0, [1.6, 3.5])] {
        let paper = Paper { h1, h2, beta, kappa: 2.0, mu3: 1.0 };
        let slope = |x: f64| x / 500.0;
        let problem = Problem { transforms: &paper, slope: &slope, force: 0.002, start: &start };
        let settings = Settings { nodes: 20, ..Settings::USUAL };
        let apart = literal::difference(&problem, &settings);
        assert!(apart < 1e-11, "h2 = {h2}: {apart:e}");
        let ways: [Collocation; 2] = [literal::collocate, vectorised::collocate];
        let [one, other] = ways.map(|way| literal::solve(&problem, &settings, way));
        assert!(one.converged && other.converged && one.iterations == other.iterations);
        for (one, other) in one.values().into_iter().zip(other.values()) {
            assert!((one / other - 1.0).abs() < 1e-8, "h2 = {h2}: {one} is not {other}");
        }
    }
}
