//! The contact equations at given ends, and their solution: pressures, and how singular they are at each end.
//!
//! All terms but the first of each contact, which are known, are unknowns, and so are the intensities q of the singular pressures at the
//! ends. The rows of the unknown terms are symmetric and positive definite; as many other rows are left as there are ends: of the first
//! terms, of the tests with k = 0, and of gaps to be closed.
use std::f64::consts::PI;
use std::ops::Range;

use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef, Side};

use crate::contact::integrals::basis::TOGETHER;
use crate::contact::integrals::layout::Layout;
use crate::contact::intervals::columns::{Columns, InSpace};
use crate::contact::intervals::pressure::Pressure;
use crate::contact::intervals::support::Support;
use crate::contact::problem::Problem;
use crate::numeric::dot;

/// The equations of one support.
pub(super) struct Equations<'a> {
    pub(super) problem: &'a Problem<'a>,
    pub(super) layout: &'a Layout,
    /// Of each contact, none where the pressure is given.
    pub(super) columns: Vec<Columns<'a>>,
}

/// Where the unknowns and rows of each contact stand among all.
struct Places {
    /// Unknown terms, all but the first one.
    terms: Vec<Range<usize>>,
    /// Ends, and the remaining rows, as many as there are ends.
    ends: Vec<Range<usize>>,
}

/// [A E; B D] [x; q] = [f; b].
struct System {
    a: Mat<f64>,
    e: Mat<f64>,
    b: Mat<f64>,
    d: Mat<f64>,
    f: Vec<f64>,
    left: Vec<f64>,
}

/// Columns of one contact at some wavenumbers.
struct Waves {
    columns: Mat<f64>,
    /// The known transform of the resultant 1, less 1.
    first: Vec<f64>,
}

impl<'a> Equations<'a> {
    pub(super) fn new(problem: &'a Problem<'a>, layout: &'a Layout, support: &'a Support, counts: &'a [usize]) -> Self {
        let mut next = 0;
        let columns = (0..problem.contacts()).map(|contact| {
            let intervals = support.of(contact);
            let counts = &counts[next..next + intervals.len()];
            next += intervals.len();
            Columns { intervals, counts }
        });
        Self { problem, layout, columns: columns.collect() }
    }

    fn places(&self) -> Places {
        let (mut term, mut end) = (0, 0);
        let mut places = Places { terms: Vec::new(), ends: Vec::new() };
        for columns in &self.columns {
            let (terms, ends) = (columns.terms().saturating_sub(1), columns.ends());
            places.terms.push(term..term + terms);
            places.ends.push(end..end + ends);
            (term, end) = (term + terms, end + ends);
        }
        places
    }

    /// The pressures of all intervals; `None` if there are none in double precision.
    pub(super) fn solve(&self) -> Option<Vec<Pressure>> {
        let places = self.places();
        let System { a, e, b, d, f, left } = self.system(&places);
        let (size, ends) = (a.nrows(), e.ncols());
        let llt = a.llt(Side::Lower).ok()?;
        let right = Mat::from_fn(size, ends + 1, |row, column| if column < ends { e[(row, column)] } else { f[row] });
        let solved = llt.solve(&right);
        let (by_ends, regular) = (solved.subcols(0, ends), solved.subcols(ends, 1));
        let border = &d - &b * by_ends;
        let residual = &b * regular;
        let residual = Mat::from_fn(ends, 1, |row, _| left[row] - residual[(row, 0)]);
        let q = border.partial_piv_lu().solve(&residual);
        let x = regular - by_ends * &q;
        let is_finite = |column: MatRef<'_, f64>| column.col(0).iter().all(|value| value.is_finite());
        (is_finite(x.as_ref()) && is_finite(q.as_ref())).then(|| self.pressures(&places, &x, &q))
    }

    /// Amplitudes from unknowns: what all others have of the first column is taken from it.
    fn pressures(&self, places: &Places, x: &Mat<f64>, q: &Mat<f64>) -> Vec<Pressure> {
        let of = |contact: usize| {
            let columns = &self.columns[contact];
            let singular = &q.col_as_slice(0)[places.ends[contact].clone()];
            let others = &x.col_as_slice(0)[places.terms[contact].clone()];
            let later: f64 = (1..columns.intervals.len()).map(|number| others[columns.first(number) - 1]).sum();
            let first = 1.0 - later - dot(&columns.resultants(), singular);
            columns.pressures(&[&[first], others].concat(), singular)
        };
        self.problem.unknown().flat_map(of).collect()
    }

    /// All rows: waves block by block of wavenumbers, then half-planes.
    fn system(&self, places: &Places) -> System {
        let size = places.terms.last().map_or(0, |last| last.end);
        let ends = places.ends.last().map_or(0, |last| last.end);
        let mut system = System {
            a: Mat::zeros(size, size),
            e: Mat::zeros(size, ends),
            b: Mat::zeros(ends, size),
            d: Mat::zeros(ends, ends),
            f: vec![0.0; size],
            left: vec![0.0; ends],
        };
        let all = self.layout.zeta.len();
        for first in (0..all).step_by(TOGETHER) {
            let waves: Vec<Waves> =
                (0..self.columns.len()).map(|contact| self.waves(contact, first..all.min(first + TOGETHER))).collect();
            for contact in 0..self.columns.len() {
                self.add_waves(places, &mut system, contact, first, &waves);
            }
        }
        for contact in self.problem.unknown() {
            self.add_in_space(places, &mut system, contact);
        }
        system
    }

    fn waves(&self, contact: usize, nodes: Range<usize>) -> Waves {
        let reach = self.layout.own[contact].reach;
        let zeta = &self.layout.zeta[nodes.start.min(reach)..nodes.end.min(reach)];
        match self.problem.sides[contact].given() {
            Some(given) => Waves {
                columns: Mat::zeros(zeta.len(), 0),
                first: zeta.iter().map(|zeta| given.transform_minus_one(*zeta)).collect(),
            },
            None => {
                Waves { columns: self.columns[contact].waves(zeta), first: self.columns[contact].first_minus_one(zeta) }
            }
        }
    }

    /// The neighbours of a contact, with the laminates between.
    fn neighbours(&self, contact: usize) -> impl Iterator<Item = (usize, usize)> + use<> {
        let below = (contact + 1 < self.columns.len()).then_some((contact + 1, contact));
        contact.checked_sub(1).map(|above| (above, above)).into_iter().chain(below)
    }

    /// Weights of a coupling from a wavenumber on, as many as there are.
    fn coupling(&self, laminate: usize, first: usize) -> &[f64] {
        let weights = &self.layout.coupling[laminate].plain;
        &weights[first.min(weights.len())..]
    }

    fn own(&self, contact: usize, first: usize) -> &[f64] {
        let weights = &self.layout.own[contact].unit.plain;
        &weights[first.min(weights.len())..]
    }

    /// Adds what waves, from wavenumber number `first` on, do to the rows of one contact.
    fn add_waves(&self, places: &Places, system: &mut System, contact: usize, first: usize, waves: &[Waves]) {
        let columns = &waves[contact].columns;
        let nodes = columns.nrows();
        if columns.ncols() == 0 || nodes == 0 {
            return;
        }
        let mut weights = vec![0.0; nodes];
        weights.iter_mut().zip(self.own(contact, first)).for_each(|(sum, weight)| *sum += weight);
        let zeta = &self.layout.zeta[first..first + nodes];
        // what the known resultants do
        let known = weights.iter().zip(zeta).zip(&waves[contact].first);
        let mut known: Vec<f64> = known.map(|((weight, zeta), first)| weight * zeta * (1.0 + first)).collect();
        for (other, laminate) in self.neighbours(contact) {
            let coupling = self.coupling(laminate, first);
            weights.iter_mut().zip(coupling).for_each(|(sum, weight)| *sum += weight);
            let firsts = waves[contact].first.iter().zip(&waves[other].first);
            for (((known, weight), zeta), (own, other)) in known.iter_mut().zip(coupling).zip(zeta).zip(firsts) {
                *known += weight * zeta * (own - other);
            }
            let count = coupling.len().min(nodes).min(waves[other].columns.nrows());
            if waves[other].columns.ncols() > 0 && count > 0 {
                let block = product(columns, &coupling[..count], &waves[other].columns);
                self.add(places, system, (contact, other), &block, -1.0 / PI);
            }
        }
        let block = product(columns, &weights, columns);
        self.add(places, system, (contact, contact), &block, 1.0 / PI);
        let known = MatRef::from_column_major_slice(&known, nodes, 1);
        let rows = columns.transpose() * known;
        self.add_right(places, system, contact, |row| -rows[(self.row(contact, row), 0)] / PI);
    }

    /// The number of the column with which a row is tested: terms, then ends, then the other tests.
    fn row(&self, contact: usize, row: Row) -> usize {
        let columns = &self.columns[contact];
        match row {
            Row::Term(term) => term,
            Row::Left(0) => 0,
            Row::Left(other) => columns.terms() + columns.ends() + other - 1,
        }
    }

    /// Adds to the right-hand sides of a contact.
    fn add_right(&self, places: &Places, system: &mut System, contact: usize, value: impl Fn(Row) -> f64) {
        for (term, place) in (1..).zip(places.terms[contact].clone()) {
            system.f[place] += value(Row::Term(term));
        }
        for (row, place) in (0..).zip(places.ends[contact].clone()) {
            system.left[place] += value(Row::Left(row));
        }
    }

    /// Adds what the columns of one contact do to the rows of another, given as products of all columns of both.
    fn add(
        &self,
        places: &Places,
        system: &mut System,
        (rows, columns): (usize, usize),
        block: &Mat<f64>,
        factor: f64,
    ) {
        let terms = self.columns[columns].terms();
        let add = |row: usize, into: &mut Mat<f64>, singular: &mut Mat<f64>, place: usize| {
            for (column, at) in (1..).zip(places.terms[columns].clone()) {
                into[(place, at)] += factor * block[(row, column)];
            }
            for (column, at) in (terms..).zip(places.ends[columns].clone()) {
                singular[(place, at)] += factor * block[(row, column)];
            }
        };
        for (term, place) in (1..).zip(places.terms[rows].clone()) {
            add(self.row(rows, Row::Term(term)), &mut system.a, &mut system.e, place);
        }
        for (left, place) in (0..).zip(places.ends[rows].clone()) {
            add(self.row(rows, Row::Left(left)), &mut system.b, &mut system.d, place);
        }
    }

    /// Adds what half-planes do, and the slope of the punch.
    fn add_in_space(&self, places: &Places, system: &mut System, contact: usize) {
        let columns = &self.columns[contact];
        let limit = self.layout.own[contact].limit;
        let InSpace { matrix, load } = columns.in_space(self.problem.sides[contact].profile());
        let (terms, ends) = (columns.terms(), columns.ends());
        // rows as of waves, none of ends
        let row = |row: usize| row.checked_sub(terms + ends).map_or(row, |other| terms + other);
        let block = Mat::from_fn(terms + ends + columns.others(), terms + ends, |at, column| {
            if (terms..terms + ends).contains(&at) { 0.0 } else { matrix[(row(at), column)] }
        });
        self.add(places, system, (contact, contact), &block, limit);
        self.add_right(places, system, contact, |at| {
            let at = row(self.row(contact, at));
            load[at] - limit * matrix[(at, 0)]
        });
    }

    /// Slopes of waves outside contacts, weights included, what half-planes do left out.
    pub(super) fn response(&self, contact: usize, pressures: &[Pressure]) -> Vec<f64> {
        let mut response = vec![0.0; self.layout.own[contact].reach];
        for first in (0..response.len()).step_by(TOGETHER) {
            let nodes = first..response.len().min(first + TOGETHER);
            let part = &mut response[nodes.clone()];
            let zeta = &self.layout.zeta[nodes.clone()];
            let own = self.field(contact, nodes.clone(), pressures);
            let weights = self.own(contact, first);
            for (((out, weight), zeta), field) in part.iter_mut().zip(weights).zip(zeta).zip(&own) {
                *out += weight / PI * (zeta + field);
            }
            for (other, laminate) in self.neighbours(contact) {
                let field = self.field(other, nodes.clone(), pressures);
                let between = own.iter().zip(&field);
                for ((out, weight), (own, field)) in part.iter_mut().zip(self.coupling(laminate, first)).zip(between) {
                    *out += weight / PI * (own - field);
                }
            }
        }
        response
    }

    /// The amplitudes of all columns of a contact, of the pressures of all intervals.
    pub(super) fn amplitudes(&self, contact: usize, pressures: &[Pressure]) -> Vec<f64> {
        let first: usize = self.columns[..contact].iter().map(|columns| columns.intervals.len()).sum();
        let columns = &self.columns[contact];
        columns.amplitudes(&pressures[first..first + columns.intervals.len()])
    }

    /// ζ times the transform of the pressure of a contact less its resultant.
    fn field(&self, contact: usize, nodes: Range<usize>, pressures: &[Pressure]) -> Vec<f64> {
        let Waves { columns, first } = self.waves(contact, nodes.clone());
        let mut field: Vec<f64> =
            first.iter().zip(&self.layout.zeta[nodes]).map(|(first, zeta)| first * zeta).collect();
        for (column, amplitude) in self.amplitudes(contact, pressures).iter().enumerate().skip(1) {
            field.iter_mut().zip(columns.col_as_slice(column)).for_each(|(sum, value)| *sum += amplitude * value);
        }
        field
    }
}

/// A row of the equations: the test with an unknown term, or one of the remaining rows, as many as there are ends.
#[derive(Clone, Copy)]
enum Row {
    Term(usize),
    Left(usize),
}

/// leftᵀ · weights · right, over as many wavenumbers as there are weights.
fn product(left: &Mat<f64>, weights: &[f64], right: &Mat<f64>) -> Mat<f64> {
    let count = weights.len();
    let mut weighted = Mat::zeros(count, right.ncols());
    for column in 0..right.ncols() {
        let values = right.col_as_slice(column).iter().zip(weights);
        weighted
            .col_as_slice_mut(column)
            .iter_mut()
            .zip(values)
            .for_each(|(out, (value, weight))| *out = value * weight);
    }
    left.as_ref().subrows(0, count).transpose() * &weighted
}
