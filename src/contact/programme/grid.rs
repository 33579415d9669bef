//! Elements on which pressures are constant.
use crate::contact::problem::twin::Twin;
use crate::contact::programme::UNRESOLVED;

/// Elements grow by this factor from the middle outwards.
const GROWTH: f64 = 1.15;
/// The first ends at this part of the shortest contact.
const FIRST: f64 = 0.05;
/// Elements at most: a factor of ten between the shortest and the longest length takes some 17 of them.
const MOST: usize = 2000;

/// The edges of all elements, from x = 0 on, in units of L.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    edges: Vec<f64>,
    shortest: f64,
    twin: Twin,
}

impl Grid {
    /// For contacts from a length to another; the punch may have an edge. `None` if the lengths are no positive, finite
    /// numbers, or so different that there would be too many elements.
    pub(super) fn new(shortest: f64, end: f64, edge: Option<f64>, twin: Twin) -> Option<Self> {
        let first = FIRST * shortest;
        if !(first.is_normal() && first > 0.0 && end.is_finite()) {
            return None;
        }
        let mut edges = vec![0.0, first];
        let mut width = first;
        while edges[edges.len() - 1] < end {
            let edge = edges[edges.len() - 1];
            // as long as the first until they may be longer
            width = width.max((GROWTH - 1.0) * edge);
            if edges.len() > MOST {
                return None;
            }
            edges.push(edge + width);
        }
        let mut grid = Self { edges, shortest, twin };
        if let Some(edge) = edge {
            grid.insert(edge);
        }
        Some(grid)
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

    /// The shortest contact it is made for.
    pub(super) fn shortest(&self) -> f64 {
        self.shortest
    }

    pub(super) fn elements(&self) -> usize {
        self.edges.len() - 1
    }

    pub(super) fn edges(&self) -> &[f64] {
        &self.edges
    }

    /// Strips, or rings about an axis.
    pub(super) fn twin(&self) -> Twin {
        self.twin
    }

    /// The resultant of a pressure 1 on an element.
    pub(super) fn resultant(&self, e: usize) -> f64 {
        self.twin.element(self.element(e))
    }

    pub(super) fn element(&self, e: usize) -> [f64; 2] {
        [self.edges[e], self.edges[e + 1]]
    }

    /// The same, and some more.
    pub(super) fn longer(mut self, factor: f64) -> Self {
        let end = factor * self.edges[self.edges.len() - 1];
        while self.edges[self.edges.len() - 1] < end && self.edges.len() <= MOST {
            self.edges.push(GROWTH * self.edges[self.edges.len() - 1]);
        }
        self
    }

    /// Halves the elements around some edges that are longer than is allowed there. Whether there were any.
    pub(super) fn refine(&mut self, around: &[(usize, f64)]) -> bool {
        let mut more: Vec<f64> = Vec::new();
        for e in 0..self.elements() {
            let [from, to] = self.element(e);
            let is_near = |edge: usize| (edge.saturating_sub(UNRESOLVED)..edge + UNRESOLVED).contains(&e);
            if around.iter().any(|(edge, longest)| is_near(*edge) && to - from > *longest) {
                more.push(0.5 * (from + to));
            }
        }
        let found = !more.is_empty();
        self.edges.extend(more);
        self.edges.sort_by(f64::total_cmp);
        found
    }

    /// Which elements touch, if an element touches where the element of a coarser grid that contains it does.
    pub(super) fn inherit(&self, coarse: &Self, touching: &[Vec<bool>]) -> Vec<Vec<bool>> {
        let parent = |e: usize| {
            let [from, to] = self.element(e);
            coarse.edges.partition_point(|edge| *edge < 0.5 * (from + to)) - 1
        };
        let parents: Vec<usize> = (0..self.elements()).map(parent).collect();
        let inherited = |own: &Vec<bool>| parents.iter().map(|e| own.get(*e).is_some_and(|touches| *touches)).collect();
        touching.iter().map(inherited).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_ends_whatever_it_is_made_for() {
        assert!(Grid::new(1e-3, 1e3, Some(2.0), Twin::Plane).is_some());
        for (shortest, end) in
            [(0.0, 1.0), (1.0, f64::INFINITY), (f64::NAN, 1.0), (1.0, f64::NAN), (1e-300, 1e300), (f64::INFINITY, 1.0)]
        {
            assert!(Grid::new(shortest, end, None, Twin::Plane).is_none(), "{shortest} {end}");
        }
    }
}
