//! The rows of the contact equations: what waves and half-planes do to all tests.
//!
//! The elastic energy of a laminate between two contacts with the transforms u and v of their pressures is a part of u², one of v², and one of (u − v)², in which no part is
//! large for long waves unless u and v differ (see [`crate::contact::equations`]). So where two contacts have the same list of intervals, the unknowns of the lower one are
//! what it has more than the upper one: a laminate that bends easily takes no digits from what both have in common.
use std::f64::consts::PI;
use std::ops::Range;

use faer::Mat;

use crate::contact::integrals::columns::Columns as Table;
use crate::contact::intervals::equations::{Equations, Places};
use crate::contact::intervals::space::InSpace;
use crate::contact::intervals::system::{Rows, System};
use crate::contact::intervals::waves::{AT_ONCE, Long, Weighted, differences};

impl Equations<'_> {
    /// All rows: waves block by block of wavenumbers, then half-planes.
    pub(super) fn system(&self, places: &[Places]) -> Option<System> {
        let size = places.last().map_or(0, |last| last.terms.1 + last.terms.0.len());
        let border = places.last().map_or(0, |last| last.left.1 + last.left.0.len());
        let mut system = System {
            a: Mat::zeros(size, size),
            e: Mat::zeros(size, border),
            b: Mat::zeros(border, size),
            d: Mat::zeros(border, border),
            right: Rows::zeros(size, border),
        };
        let all = self.layout.zeta.len();
        for first in (0..all).step_by(AT_ONCE) {
            let nodes = first..all.min(first + AT_ONCE);
            let waves: Vec<Table> =
                (0..self.columns.len()).map(|contact| self.waves(contact, nodes.clone())).collect();
            self.add_waves(places, &mut system, first, &waves);
        }
        for contact in self.problem.unknown() {
            self.add_in_space(places, &mut system, contact)?;
        }
        let angles = border - self.turning.len();
        for contact in self.problem.unknown() {
            let columns = &self.columns[contact];
            let first = places[contact].left.1 + places[contact].told.len();
            for (place, other) in (first..).zip(columns.others()) {
                let Some(group) = columns.tells_rotation_of(other) else { continue };
                for (angle, sign) in self.angles_of(contact, group) {
                    for row in self.chain(contact) {
                        let place = places[row].left.1 + place - places[contact].left.1;
                        system.d[(place, angles + angle)] -= sign * columns.rotation(other);
                    }
                }
            }
        }
        Some(system)
    }

    /// Adds what waves, from wavenumber number `first` on, do to all rows: kernels under equal pressures of neighbours to each contact, and laminates to
    /// what pressures on both of their faces differ by.
    fn add_waves(&self, places: &[Places], system: &mut System, first: usize, waves: &[Table]) {
        let workspace = &self.problem.kernel.workspace;
        let zeta = |contact: usize| self.zeta(contact, first..first + AT_ONCE);
        // of a given pressure none
        let long = |contact: usize| self.columns[contact].long_waves(zeta(contact), workspace);
        let long: Vec<Long> = (0..waves.len()).map(long).collect();
        let tests: Vec<Long> = waves.iter().zip(&long).map(|(waves, long)| long.whole(waves, workspace)).collect();
        for contact in self.problem.unknown().filter(|contact| !zeta(*contact).is_empty()) {
            let (parts, pressed, tests) = (self.columns[contact].parts(), &waves[contact], &tests[contact]);
            let mut own = vec![0.0; zeta(contact).len()];
            own.iter_mut().zip(self.own(contact, first)).for_each(|(sum, weight)| *sum += weight);
            let mut weights = own.clone();
            for (other, laminate) in self.neighbours(contact).filter(|(_, laminate)| !self.linked[*laminate]) {
                let coupling = self.coupling(laminate, first);
                weights.iter_mut().zip(coupling).for_each(|(sum, weight)| *sum += weight);
                let columns = Weighted::new(&waves[other], coupling, parts, workspace);
                let mut block = columns.tested(pressed);
                tests.put_rows(&mut block, &columns);
                let block = Block { all: &block, first: [0; 2], factor: -1.0 / PI };
                self.add(places, system, (self.chain(contact), self.chain(other)), &block);
            }
            let columns = Weighted::new(pressed, &weights, parts, workspace);
            let mut block = columns.symmetric(pressed);
            tests.put_rows(&mut block, &columns);
            // neighbours carry the same resultants and moments, which do nothing between them
            let own = Weighted::new(&long[contact].values, &own, parts, workspace);
            long[contact].add_columns(&mut block, tests, &own, pressed);
            let block = Block { all: &block, first: [0; 2], factor: 1.0 / PI };
            self.add(places, system, (self.chain(contact), self.chain(contact)), &block);
        }
        for laminate in (0..self.linked.len()).filter(|laminate| self.linked[*laminate]) {
            let (coupling, parts) = (self.coupling(laminate, first), self.columns[laminate].parts());
            let count = coupling.len().min(zeta(laminate).len()).min(zeta(laminate + 1).len());
            let pressed = differences(&waves[laminate], &waves[laminate + 1], count, parts, workspace);
            let columns = Weighted::new(&pressed, coupling, parts, workspace);
            let mut block = columns.symmetric(&pressed);
            let lower = block.nrows() / 2;
            let [upper_tests, lower_tests] = [&tests[laminate], &tests[laminate + 1]];
            let values = differences(&upper_tests.values, &lower_tests.values, count, parts, workspace);
            let below = lower_tests.places.iter().map(|place| lower + place);
            let all = upper_tests.places.iter().copied().chain(below).collect();
            Long { places: all, values }.put_rows(&mut block, &columns);
            let both = [(0, self.chain(laminate), 1.0), (lower, laminate + 1..laminate + 2, -1.0)];
            for (row, rows, sign) in &both {
                for (column, columns, other) in &both {
                    let block = Block { all: &block, first: [*row, *column], factor: sign * other / PI };
                    self.add(places, system, (rows.clone(), columns.clone()), &block);
                }
            }
        }
    }

    /// Adds what the columns of some contacts do to the rows of others, given as products of all columns of two of them.
    fn add(
        &self,
        places: &[Places],
        system: &mut System,
        (rows, columns): (Range<usize>, Range<usize>),
        block: &Block,
    ) {
        for rows in rows.map(|contact| &places[contact]) {
            for contact in columns.clone() {
                self.add_columns(rows, system, contact, &places[contact], block);
            }
        }
    }

    /// The same for the rows of one contact and the columns of one.
    fn add_columns(&self, rows: &Places, system: &mut System, contact: usize, own: &Places, block: &Block) {
        let (terms, ends) = (self.columns[contact].terms(), self.columns[contact].ends());
        let moments = system.e.ncols() - self.turning.len() - self.free.len();
        let System { a, e, b, d, right } = system;
        for (column, at) in own.terms.0.iter().zip(own.terms.1..) {
            block.add(*column, 1.0, &rows.terms, a.col_as_slice_mut(at));
            block.add(*column, 1.0, &rows.left, b.col_as_slice_mut(at));
        }
        for (column, at) in (terms..terms + ends).zip(own.ends..) {
            block.add(column, 1.0, &rows.terms, e.col_as_slice_mut(at));
            block.add(column, 1.0, &rows.left, d.col_as_slice_mut(at));
        }
        for told in &own.told {
            block.add(told.column, -told.known, &rows.terms, &mut right.terms);
            block.add(told.column, -told.known, &rows.left, &mut right.left);
            for (at, part) in (moments..).zip(&told.by_moments) {
                block.add(told.column, *part, &rows.terms, e.col_as_slice_mut(at));
                block.add(told.column, *part, &rows.left, d.col_as_slice_mut(at));
            }
        }
    }

    /// Adds what half-planes and short waves do, and the slope of the punch.
    fn add_in_space(&self, places: &[Places], system: &mut System, contact: usize) -> Option<()> {
        let InSpace { matrix, load, .. } = self.in_space(contact, None)?;
        let block = Block { all: &matrix, first: [0; 2], factor: self.layout.own[contact].limit };
        self.add(places, system, (self.chain(contact), self.chain(contact)), &block);
        for Places { terms, left, .. } in &places[self.chain(contact)] {
            let add = |(right, row): (&mut f64, &usize)| *right += load[*row];
            system.right.terms[terms.1..].iter_mut().zip(&terms.0).for_each(add);
            system.right.left[left.1..].iter_mut().zip(&left.0).for_each(add);
        }
        Some(())
    }

    /// What half-planes, in units of the limit of the kernel, and short waves do to the tests of a contact, and the slope of the punch: each column, or
    /// all of them with some amplitudes. `None` if short waves take too many wavenumbers.
    pub(super) fn in_space<'a>(&self, contact: usize, amplitudes: Option<&'a [f64]>) -> Option<InSpace<'a>> {
        let (columns, own) = (&self.columns[contact], &self.layout.own[contact]);
        let per_limit = own.exponentials.0.iter().map(|[b, c]| [*b, c / own.limit]);
        let exponentials: Vec<[f64; 2]> = per_limit.collect();
        let mut space = columns.in_space(&self.problem.sides[contact], &exponentials, amplitudes);
        columns.add_short_waves(&mut space, self.problem.kernel, self.layout, contact)?;
        columns.subtract(&mut space);
        Some(space)
    }
}

/// A factor times a part of a matrix, a column for each column of a contact and a row for each test.
struct Block<'a> {
    all: &'a Mat<f64>,
    /// Its first row and column.
    first: [usize; 2],
    factor: f64,
}

impl Block<'_> {
    /// Adds a multiple of some rows of a column to as many places from a first one on.
    fn add(&self, column: usize, times: f64, (rows, first): &(Vec<usize>, usize), into: &mut [f64]) {
        let values = &self.all.col_as_slice(self.first[1] + column)[self.first[0]..];
        let factor = self.factor * times;
        rows.iter().zip(&mut into[*first..]).for_each(|(row, into)| *into += factor * values[*row]);
    }
}
