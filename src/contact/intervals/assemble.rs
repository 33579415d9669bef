//! The rows of the contact equations: what waves and half-planes do to all tests.
//!
//! The elastic energy of a laminate between two contacts with the transforms u and v of their pressures is a part of u², one of v², and one of (u − v)², in which no part is
//! large for long waves unless u and v differ. So where two contacts have the same list of intervals, the unknowns of the lower one are
//! what it has more than the upper one: a laminate that bends easily takes no digits from what both have in common.
use std::f64::consts::PI;
use std::ops::Range;

use faer::Mat;

use crate::contact::integrals::samples::Samples;
use crate::contact::intervals::equations::{Equations, Places, Sampled};
use crate::contact::intervals::space::InSpace;
use crate::contact::intervals::system::{Rows, System};
use crate::contact::intervals::waves::{AT_ONCE, Weighted, differences};
use crate::contact::problem::Prescribed;

impl Equations<'_> {
    /// All rows: waves block by block of wavenumbers, then half-planes.
    pub(super) fn system(&self) -> Option<System> {
        let (size, border) = (self.unknown_terms(), self.border());
        let mut system = System {
            a: Mat::zeros(size, size),
            e: Mat::zeros(size, border),
            b: Mat::zeros(border, size),
            d: Mat::zeros(border, border),
            right: Rows::zeros(size, border),
            is_symmetric: !self.problem.kernel.has_openings(),
        };
        let mut sums = self.sums();
        for number in 0..self.layout.zeta.len().div_ceil(AT_ONCE) {
            self.add_waves(&mut sums, number);
        }
        for sums in sums {
            let Sums { rows, columns, factor, .. } = &sums;
            let (rows, columns, factor, all) = (rows.clone(), columns.clone(), *factor, sums.whole());
            for (row, rows, sign) in &rows {
                for (column, columns, other) in &columns {
                    let block = Block { all: &all, first: [*row, *column], factor: factor * sign * other / PI };
                    self.add(&mut system, (rows.clone(), columns.clone()), &block);
                }
            }
        }
        for contact in self.problem.unknown() {
            self.add_in_space(&mut system, contact)?;
        }
        let angles = border - self.turning.len();
        for contact in self.problem.unknown() {
            let columns = &self.columns[contact];
            let first = self.places[contact].left.1 + self.places[contact].told.len();
            for (place, other) in (first..).zip(&columns.others) {
                let Some(group) = columns.tells_rotation_of(*other) else { continue };
                for (angle, sign) in self.angles_of(contact, group) {
                    for row in self.chain(contact) {
                        let place = self.places[row].left.1 + place - self.places[contact].left.1;
                        system.d[(place, angles + angle)] -= sign * columns.rotation(*other);
                    }
                }
            }
        }
        self.add_prescribed(&mut system);
        Some(system)
    }

    /// How many unknown terms there are.
    pub(super) fn unknown_terms(&self) -> usize {
        self.places.last().map_or(0, |last| last.terms.1 + last.terms.0.len())
    }

    /// How many rows there are that are not the ones of unknown terms, and as many unknowns.
    pub(super) fn border(&self) -> usize {
        self.places.last().map_or(0, |last| last.left.1 + last.left.0.len()) + self.problem.prescribed.len()
    }

    /// Adds the rows that tell the forces of punches from what is prescribed: the last ones.
    fn add_prescribed(&self, system: &mut System) {
        let (first, mut all_sunk) = (system.d.nrows() - self.problem.prescribed.len(), self.sunk().iter());
        for (row, (punch, prescribed)) in (first..).zip(&self.problem.prescribed) {
            match prescribed {
                Prescribed::End { side, .. } => system.d[(row, self.prescribed_end(*punch, *side))] = 1.0,
                Prescribed::Depth(depth) => {
                    let rows = Places { terms: Default::default(), ends: 0, left: (vec![0], row), told: Vec::new() };
                    let Some(sunk) = all_sunk.next() else { continue };
                    for (contact, all) in sunk.by_columns.iter().enumerate() {
                        let block = Block { all, first: [0; 2], factor: 1.0 };
                        for own in self.chain(contact) {
                            self.add_columns(&rows, system, own, &block);
                        }
                    }
                    let angles = system.d.ncols() - self.turning.len();
                    (angles..).zip(&sunk.by_angles).for_each(|(angle, part)| system.d[(row, angle)] += part);
                    system.right.left[row] += depth - sunk.height;
                }
            }
        }
    }

    /// Products that are to be summed over the wavenumbers: of each contact with itself under equal pressures of its neighbours and with neighbours, and of
    /// laminates with what pressures on both of their faces differ by.
    fn sums(&self) -> Vec<Sums> {
        let rows = |contact: usize| self.columns[contact].rows();
        let of_contact = |contact: usize| {
            let chain = vec![(0, self.chain(contact), 1.0)];
            let told = self.columns[contact].told();
            let mut own = Sums::new([chain.clone(), chain.clone()], 1.0, [rows(contact); 2], told.clone());
            own.told_columns = Some(Mat::zeros(rows(contact), told.len()));
            let neighbour = move |(other, _): (usize, usize)| {
                let columns = if self.problem.is_known(other) { 1 } else { rows(other) };
                let both = [chain.clone(), vec![(0, self.chain(other), 1.0)]];
                Sums::new(both, -1.0, [rows(contact), columns], told.clone())
            };
            std::iter::once(own).chain(self.unlinked(contact).map(neighbour)).collect::<Vec<_>>()
        };
        let of_laminate = |laminate: usize| {
            let lower = rows(laminate);
            let both = vec![(0, self.chain(laminate), 1.0), (lower, laminate + 1..laminate + 2, -1.0)];
            let below = self.columns[laminate + 1].told().into_iter().map(|place| lower + place);
            let told = self.columns[laminate].told().into_iter().chain(below).collect();
            Sums::new([both.clone(), both], 1.0, [2 * lower; 2], told)
        };
        let linked = (0..self.linked.len()).filter(|laminate| self.linked[*laminate]);
        self.problem.unknown().flat_map(of_contact).chain(linked.map(of_laminate)).collect()
    }

    /// What a contact is coupled with, but for contacts that its unknowns are counted from.
    fn unlinked(&self, contact: usize) -> impl Iterator<Item = (usize, usize)> {
        let is_linked = |pair: usize| self.linked.get(pair).is_some_and(|linked| *linked);
        self.problem.kernel.neighbours(contact).filter(move |(_, pair)| !is_linked(*pair))
    }

    /// Adds a block of wavenumbers to [`Self::sums`].
    fn add_waves(&self, sums: &mut [Sums], number: usize) {
        let (workspace, first) = (&self.problem.kernel.workspace, number * AT_ONCE);
        let nodes = first..first + AT_ONCE;
        let sampled = self.sampled(number);
        let Sampled { waves, long, whole: tests } = &*sampled;
        let mut sums = sums.iter_mut();
        let mut add = |columns: &Weighted, left: &Samples, told: &Samples| {
            sums.by_ref().take(1).for_each(|sums| sums.add(columns, left, told));
        };
        for contact in self.problem.unknown() {
            let (parts, pressed, tests) = (self.columns[contact].parts(), &waves[contact], &tests[contact]);
            let mut own = vec![0.0; self.zeta(contact, nodes.clone()).len()];
            own.iter_mut().zip(self.own(contact, first)).for_each(|(sum, weight)| *sum += weight);
            let mut weights = own.clone();
            for pair in self.problem.kernel.shared(contact).filter(|pair| !self.linked[*pair]) {
                weights.iter_mut().zip(self.coupling(pair, first)).for_each(|(sum, weight)| *sum += weight);
            }
            // neighbours carry the same resultants and moments, which do nothing between them
            let mut columns = Weighted::new(pressed, &weights, parts, workspace);
            columns.add(&Weighted::new(&long[contact].values, &own, parts, workspace), &long[contact].places);
            add(&columns, pressed, tests);
            for (other, pair) in self.unlinked(contact) {
                let met = self.met(&sampled, other, contact);
                let columns = met.as_ref().unwrap_or(&waves[other]);
                add(&Weighted::new(columns, self.coupling(pair, first), parts, workspace), pressed, tests);
            }
        }
        for laminate in (0..self.linked.len()).filter(|laminate| self.linked[*laminate]) {
            let (coupling, parts) = (self.coupling(laminate, first), self.columns[laminate].parts());
            let reach = |contact: usize| self.zeta(contact, nodes.clone()).len();
            let count = coupling.len().min(reach(laminate)).min(reach(laminate + 1));
            let differ = |of: &[Samples]| differences(&of[laminate], &of[laminate + 1], count, parts, workspace);
            let pressed = differ(waves);
            add(&Weighted::new(&pressed, coupling, parts, workspace), &pressed, &differ(tests));
        }
    }

    /// Adds what the columns of some contacts do to the rows of others, given as products of all columns of two of them.
    fn add(&self, system: &mut System, (rows, columns): (Range<usize>, Range<usize>), block: &Block) {
        for rows in rows.map(|contact| &self.places[contact]) {
            for contact in columns.clone() {
                self.add_columns(rows, system, contact, block);
            }
        }
    }

    /// The same for the rows of one contact and the columns of one.
    fn add_columns(&self, rows: &Places, system: &mut System, contact: usize, block: &Block) {
        let own = &self.places[contact];
        let (terms, ends) = (self.columns[contact].terms(), self.columns[contact].ends());
        let loads = system.e.ncols() - self.turning.len() - self.loads.len();
        let System { a, e, b, d, right, .. } = system;
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
            for (at, part) in (loads..).zip(&told.by_loads) {
                block.add(told.column, *part, &rows.terms, e.col_as_slice_mut(at));
                block.add(told.column, *part, &rows.left, d.col_as_slice_mut(at));
            }
        }
    }

    /// Adds what half-planes and short waves do, and the slope of the punch.
    fn add_in_space(&self, system: &mut System, contact: usize) -> Option<()> {
        let (matrix, load) = (self.in_space(contact, None)?.matrix, self.load(contact));
        let block = Block { all: &matrix, first: [0; 2], factor: self.layout.own[contact].limit };
        self.add(system, (self.chain(contact), self.chain(contact)), &block);
        for Places { terms, left, .. } in &self.places[self.chain(contact)] {
            let add = |(right, row): (&mut f64, &usize)| *right += load[*row];
            system.right.terms[terms.1..].iter_mut().zip(&terms.0).for_each(add);
            system.right.left[left.1..].iter_mut().zip(&left.0).for_each(add);
        }
        Some(())
    }

    /// What half-planes, in units of the limit of the kernel, and short waves do to the tests of a contact: each column, or all of them with some amplitudes. `None` if short waves take too many wavenumbers.
    pub(super) fn in_space<'a>(&self, contact: usize, amplitudes: Option<&'a [f64]>) -> Option<InSpace<'a>> {
        let (columns, own) = (&self.columns[contact], &self.layout.own[contact]);
        let mut space = columns.in_space(&own.exponentials_over_limit(), amplitudes);
        columns.add_short_waves(&mut space, self.short_waves(contact)?, own.limit);
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

/// Sums over wavenumbers of products of tests with weighted columns.
struct Sums {
    /// To the rows of which contacts the tests from a first one on are added, with a sign.
    rows: Vec<(usize, Range<usize>, f64)>,
    /// The contacts the unknowns of which the columns from a first one on belong to.
    columns: Vec<(usize, Range<usize>, f64)>,
    factor: f64,
    /// The lower half, if tests are columns.
    all: Mat<f64>,
    is_symmetric: bool,
    /// The tests of resultants, moments and rotations as they are, and where they stand.
    told: Mat<f64>,
    places: Vec<usize>,
    /// The columns there with all rows, if they are not like the tests.
    told_columns: Option<Mat<f64>>,
}

impl Sums {
    fn new(
        [rows, columns]: [Vec<(usize, Range<usize>, f64)>; 2],
        factor: f64,
        [tests, count]: [usize; 2],
        places: Vec<usize>,
    ) -> Self {
        let (all, told) = (Mat::zeros(tests, count), Mat::zeros(places.len(), count));
        let is_symmetric = rows == columns;
        Self { rows, columns, factor, all, is_symmetric, told, places, told_columns: None }
    }

    fn add(&mut self, columns: &Weighted, left: &Samples, told: &Samples) {
        if self.is_symmetric {
            columns.add_symmetric(left, &mut self.all);
        } else {
            columns.add_tested(left, &mut self.all);
        }
        columns.add_tested(told, &mut self.told);
        if let Some(all_rows) = &mut self.told_columns {
            columns.part(&self.places).add_tested(left, all_rows);
        }
    }

    /// All products.
    fn whole(mut self) -> Mat<f64> {
        if self.is_symmetric {
            for column in 0..self.all.ncols() {
                for row in column + 1..self.all.nrows() {
                    self.all[(column, row)] = self.all[(row, column)];
                }
            }
        }
        for (number, place) in self.places.iter().enumerate() {
            if let Some(columns) = &self.told_columns {
                self.all.col_as_slice_mut(*place).copy_from_slice(columns.col_as_slice(number));
            }
        }
        for (number, place) in self.places.iter().enumerate() {
            (0..self.told.ncols()).for_each(|column| self.all[(*place, column)] = self.told[(number, column)]);
        }
        self.all
    }
}
