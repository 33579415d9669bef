//! Elements on which pressures are constant.
use crate::contact::problem::Expected;
use crate::contact::programme::UNRESOLVED;
use crate::contact::programme::patch::Patch;

/// Elements grow by this factor from the middle outwards.
const GROWTH: f64 = 1.15;
/// The first ends at this part of the shortest contact.
const FIRST: f64 = 0.05;

/// The edges of all elements, from left to right, or from x = 0 on where all is even; in units of L.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    edges: Vec<f64>,
    /// Where contacts are expected, and their half-lengths: elements grow with the distance from the nearest one.
    about: Vec<[f64; 2]>,
    patch: Patch,
}

impl Grid {
    /// From one place to another, with elements that grow with the distance from some places, next to which they are short against a length; with ends of elements at others. `None` if
    /// lengths are no positive, finite numbers, or so different that there would be too many elements.
    pub(super) fn new(about: Vec<[f64; 2]>, [from, to]: [f64; 2], at: &[f64], patch: Patch) -> Option<Self> {
        let is_length = |half: f64| (FIRST * half).is_normal() && half > 0.0;
        if about.is_empty() || !about.iter().all(|[_, half]| is_length(*half)) || !(to - from).is_finite() {
            return None;
        }
        let mut grid = Self { edges: vec![from], about, patch };
        while grid.last() < to {
            if grid.is_full() {
                return None;
            }
            let width = grid.growing(grid.last());
            // towards one of the places they become shorter
            grid.edges.push(grid.last() + width.min(grid.growing(grid.last() + width)));
        }
        at.iter().for_each(|x| grid.insert(*x));
        Some(grid)
    }

    /// How long an element at x is at first.
    fn growing(&self, x: f64) -> f64 {
        let of = |[place, half]: &[f64; 2]| (FIRST * half).max((GROWTH - 1.0) * (x - place).abs());
        self.about.iter().map(of).fold(f64::INFINITY, f64::min)
    }

    /// Whether there are as many elements as there may be: a factor of ten between the shortest and the longest length takes some 17 of them.
    fn is_full(&self) -> bool {
        self.edges.len() > 2000
    }

    fn last(&self) -> f64 {
        self.edges[self.edges.len() - 1]
    }

    /// Ends an element at x, in place of the nearest other end.
    fn insert(&mut self, x: f64) {
        let next = self.edges.partition_point(|edge| *edge < x);
        if next >= self.edges.len() {
            return;
        }
        let nearest = if next > 1 && x - self.edges[next - 1] < self.edges[next] - x { next - 1 } else { next };
        self.edges[nearest] = x;
    }

    /// The shortest length it is made for.
    pub(super) fn shortest(&self) -> f64 {
        self.about.iter().fold(f64::INFINITY, |shortest, [_, half]| shortest.min(*half))
    }

    /// How far x is from the nearest place where a contact is expected.
    pub(super) fn distance(&self, x: f64) -> f64 {
        self.about.iter().map(|[place, _]| (x - place).abs()).fold(f64::INFINITY, f64::min)
    }

    /// Whether a contact is expected about a place between others.
    pub(super) fn is_about(&self, [from, to]: [f64; 2]) -> bool {
        self.about.iter().any(|[place, _]| (from..=to).contains(place))
    }

    pub(super) fn elements(&self) -> usize {
        self.edges.len() - 1
    }

    pub(super) fn edges(&self) -> &[f64] {
        &self.edges
    }

    /// What the elements are.
    pub(super) fn patch(&self) -> Patch {
        self.patch
    }

    /// Resultant and moment of a pressure 1 on an element.
    pub(super) fn carried(&self, e: usize) -> [f64; 2] {
        self.patch.element(self.element(e))
    }

    pub(super) fn element(&self, e: usize) -> [f64; 2] {
        [self.edges[e], self.edges[e + 1]]
    }

    /// The same, and some more.
    pub(super) fn longer(mut self, factor: f64) -> Self {
        let [from, to] = [self.edges[0], self.last()].map(|end| factor * end);
        while self.last() < to && !self.is_full() {
            self.edges.push(self.last() + self.growing(self.last()));
        }
        while self.edges[0] > from && !self.is_full() {
            self.edges.insert(0, self.edges[0] - self.growing(self.edges[0]));
        }
        self
    }

    /// Halves the elements around some edges that are longer than is allowed there, and quarters those next to these edges that are more than twice as long. Whether there were any.
    pub(super) fn refine(&mut self, around: &[(usize, f64)]) -> bool {
        let mut more: Vec<f64> = Vec::new();
        for e in 0..self.elements() {
            let [from, to] = self.element(e);
            let is_near = |edge: usize, by: usize| (edge.saturating_sub(by)..edge + by).contains(&e);
            let is_long = |by: usize, times: f64| {
                around.iter().any(|(edge, longest)| is_near(*edge, by) && to - from > times * longest)
            };
            let parts = if is_long(1, 2.0) { 4 } else { 1 + usize::from(is_long(UNRESOLVED, 1.0)) };
            more.extend((1..parts).map(|k| from + (to - from) * k as f64 / parts as f64));
        }
        let found = !more.is_empty();
        self.edges.extend(more);
        self.edges.sort_by(f64::total_cmp);
        found
    }

    /// Which elements are at least in part where a contact is expected.
    pub(super) fn within(&self, expected: &[Expected], contact: usize) -> Vec<bool> {
        let is_there = |pair: &[f64]| {
            expected.iter().any(|own| own.contact == contact && own.ends[0] < pair[1] && pair[0] < own.ends[1])
        };
        self.edges.windows(2).map(is_there).collect()
    }

    /// Which elements touch, if an element touches where the element of a coarser grid that contains it does.
    pub(super) fn inherit(&self, coarse: &Self, touching: &[Vec<bool>]) -> Vec<Vec<bool>> {
        let parent = |e: usize| {
            let [from, to] = self.element(e);
            coarse.edges.partition_point(|edge| *edge < 0.5 * (from + to)).checked_sub(1)
        };
        let parents: Vec<Option<usize>> = (0..self.elements()).map(parent).collect();
        let inherited = |own: &Vec<bool>| {
            parents.iter().map(|e| e.and_then(|e| own.get(e)).is_some_and(|touches| *touches)).collect()
        };
        touching.iter().map(inherited).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_ends_whatever_it_is_made_for() {
        let grid = |half: f64, end: f64| Grid::new(vec![[0.0, half]], [0.0, end], &[2.0], Patch::Pair);
        assert!(grid(1e-3, 1e3).is_some_and(|grid| grid.edges().contains(&2.0)));
        for (half, end) in
            [(0.0, 1.0), (1.0, f64::INFINITY), (f64::NAN, 1.0), (1.0, f64::NAN), (1e-300, 1e300), (f64::INFINITY, 1.0)]
        {
            assert!(grid(half, end).is_none(), "{half} {end}");
        }
        // next to each of two places elements are as short as its length asks for
        let about = vec![[-50.0, 0.1], [3.0, 2.0]];
        let grid = Grid::new(about, [-300.0, 20.0], &[-49.9], Patch::Strip).unwrap().longer(6.0);
        assert!(grid.edges().is_sorted() && grid.edges()[0] <= -1800.0 && grid.edges().contains(&-49.9));
        for e in 0..grid.elements() {
            let [from, to] = grid.element(e);
            assert!(to - from <= 0.1 + 0.2 * grid.distance(0.5 * (from + to)), "{from} {to}");
        }
    }
}
