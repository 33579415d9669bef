//! The contact equations at given ends, and their solution: pressures, and how singular they are at each end.
//!
//! The first terms of groups of intervals, and where nothing is even the second ones, are told by resultants and moments. All other terms are unknowns,
//! and so are the intensities q of the singular pressures at the ends, the moments under punches that do not turn, and the force of a punch of which something else is
//! prescribed. The rows of the unknown terms are
//! symmetric and positive definite; as many other rows are left as there are other unknowns: of the first and second terms, of the tests with k = 0,
//! and of gaps to be closed. Bodies that may turn add an angle, and the test that tells it.
use std::cell::{OnceCell, RefCell};
use std::ops::Range;
use std::rc::Rc;

use faer::Mat;

use crate::contact::integrals::layout::Layout;
use crate::contact::integrals::samples::Samples;
use crate::contact::intervals::columns::Columns;
use crate::contact::intervals::pressure::{Pressure, Tip};
use crate::contact::intervals::short_waves::ShortWaves;
use crate::contact::intervals::support::{ContactInterval, Intervals, Parity};
use crate::contact::intervals::waves::{AT_ONCE, Long};
use crate::contact::problem::{Group, Problem};
use crate::numeric::dot;

/// Numbers in columns at wavenumbers that are kept at most, 8 bytes each: others are made again where they are needed.
const KEPT: usize = 1 << 21;

/// The equations of one support.
pub(super) struct Equations<'a> {
    pub(super) problem: &'a Problem<'a>,
    pub(super) layout: &'a Layout,
    /// Of each contact, none where the pressure is given.
    pub(super) columns: Vec<Columns<'a>>,
    /// Of each laminate, whether the unknowns of the contact below are what it has more than the contact above.
    pub(super) linked: Vec<bool>,
    /// Whether nothing is even.
    pub(super) moves: bool,
    /// The unknown moments and forces of punches.
    pub(super) loads: Vec<Load>,
    /// The contacts and groups of intervals at which bodies turn against each other.
    pub(super) turning: Vec<(usize, usize)>,
    /// Columns at the first wavenumbers, and of each contact columns at short waves and what tests see of punches, as far as they have been asked for.
    blocks: RefCell<Vec<Rc<Sampled>>>,
    short_waves: Vec<OnceCell<Option<Vec<ShortWaves>>>>,
    slopes: Vec<OnceCell<Vec<f64>>>,
    pub(super) sunk: OnceCell<Vec<Sunk>>,
    /// How many numbers of columns are kept at most: none of columns that are used once.
    pub(super) keeps: usize,
    /// Where unknowns and rows stand, of each contact.
    pub(super) places: Vec<Places>,
}

/// What a punch carries, if that is unknown, by the group of intervals under it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Load {
    /// The moment about the middle of the first interval under a punch that does not turn, or of the slope of an opening.
    Moment { contact: usize, group: usize },
    /// The force, over the one that is expected.
    Force(usize),
}

impl Load {
    /// The contact and the group.
    fn place(self) -> (usize, usize) {
        match self {
            Self::Moment { contact, group } => (contact, group),
            Self::Force(group) => (0, group),
        }
    }
}

/// The columns of all contacts at some wavenumbers.
pub(super) struct Sampled {
    /// What resultants, moments and rotations do to long waves left out; of a given pressure one column.
    pub(super) waves: Vec<Samples>,
    /// What is left out, and the tests that it belongs to as they are.
    pub(super) long: Vec<Long>,
    pub(super) whole: Vec<Samples>,
}

/// What the equations tell.
#[derive(Clone)]
pub(super) struct Solved {
    /// Of each interval.
    pub(super) pressures: Vec<Pressure>,
    /// The unknown moments and forces of punches, and the angles by which bodies turn.
    pub(super) loads: Vec<f64>,
    pub(super) angles: Vec<f64>,
    /// By how much the slope of the gap of each contact grows since bodies turn, for each group of intervals.
    pub(super) rotations: Vec<Vec<f64>>,
    /// The forces that are to be found, over what is expected of them.
    pub(super) forces: Vec<f64>,
    /// The force of all over the one that is given or expected.
    pub(super) force: f64,
}

/// Where the unknowns and rows of one contact stand among all.
pub(super) struct Places {
    /// Columns of the unknown terms, and the place of the first one.
    pub(super) terms: (Vec<usize>, usize),
    /// The place of the first end; loads, and then rotations, stand behind all ends.
    pub(super) ends: usize,
    /// Columns of the other rows, and the place of the first one.
    pub(super) left: (Vec<usize>, usize),
    /// The columns whose amplitudes are told.
    pub(super) told: Vec<Told>,
}

/// A column whose amplitude is told by a resultant or a moment.
pub(super) struct Told {
    pub(super) column: usize,
    pub(super) known: f64,
    /// Per unit of each unknown load.
    pub(super) by_loads: Vec<f64>,
}

impl Told {
    /// What it is more than the same column of the contact above.
    fn count_from(&mut self, above: &Self) {
        self.known -= above.known;
        self.by_loads.iter_mut().zip(&above.by_loads).for_each(|(own, above)| *own -= above);
    }
}

/// What the depth of a punch follows from, in units of L and per unit of P'.
pub(super) struct Sunk {
    /// Of each contact a row with what each column adds to it.
    pub(super) by_columns: Vec<Mat<f64>>,
    /// The same of each angle by which bodies turn.
    pub(super) by_angles: Vec<f64>,
    /// How much higher than its lowest point the punch is about the middle of its contact.
    pub(super) height: f64,
}

impl Sunk {
    /// The depth with some amplitudes of all columns, and some angles.
    pub(super) fn with(&self, amplitudes: &[Vec<f64>], angles: &[f64]) -> f64 {
        let of = |(by, amplitudes): (&Mat<f64>, &Vec<f64>)| {
            amplitudes.iter().enumerate().map(|(column, amplitude)| by[(0, column)] * amplitude).sum::<f64>()
        };
        let turned = dot(&self.by_angles, angles);
        self.height + turned + self.by_columns.iter().zip(amplitudes).map(of).sum::<f64>()
    }
}

/// Two thirds of some numbers of terms.
pub(super) fn fewer(counts: &[usize]) -> Vec<usize> {
    counts.iter().map(|count| count - count / 3).collect()
}

impl<'a> Equations<'a> {
    pub(super) fn new(
        problem: &'a Problem<'a>,
        layout: &'a Layout,
        support: &'a Intervals,
        counts: &'a [usize],
    ) -> Self {
        let moves = !problem.is_even() || support.0.iter().any(|interval| interval.parity == Parity::None);
        let mut next = 0;
        let columns = (0..problem.contacts()).map(|contact| {
            let intervals = support.of(contact);
            let counts = &counts[next..next + intervals.len()];
            next += intervals.len();
            Columns::new(intervals, counts, moves)
        });
        let columns: Vec<Columns> = columns.collect();
        let is_linked =
            |(laminate, pair): (usize, &[Columns])| support.are_alike(laminate) && pair[0].are_like(&pair[1]);
        let linked = columns.windows(2).enumerate().map(is_linked).collect();
        let moment = |contact: usize| {
            let is_unknown =
                move |group: &usize| problem.group(contact, *group).is_some_and(|own| own.moment.is_none());
            let of = move |group: usize| Load::Moment { contact, group };
            (0..columns[contact].groups.len()).filter(is_unknown).map(of).collect::<Vec<_>>()
        };
        let own = (0..columns.len()).filter(|contact| moves && (*contact == 0 || problem.is_opened(*contact)));
        let moments = own.flat_map(moment);
        let loads = moments.chain(problem.prescribed.iter().map(|(punch, _)| Load::Force(*punch))).collect();
        let of = |contact: usize| {
            let turning = problem.groups(contact).into_iter().enumerate().filter(|(_, group)| moves && group.turns);
            turning.map(move |(group, _)| (contact, group))
        };
        let turning = (0..problem.contacts()).flat_map(of).collect();
        let (short_waves, slopes) = columns.iter().map(|_| (OnceCell::new(), OnceCell::new())).unzip();
        let (blocks, sunk) = Default::default();
        let (keeps, places) = (KEPT, Vec::new());
        let mut all = Self {
            problem,
            layout,
            columns,
            linked,
            moves,
            loads,
            turning,
            blocks,
            short_waves,
            slopes,
            sunk,
            keeps,
            places,
        };
        all.places = all.placed();
        all
    }

    /// The contacts whose pressures the unknowns of a contact are part of, from the uppermost one of which they are counted.
    pub(super) fn chain(&self, contact: usize) -> Range<usize> {
        let linked = (0..contact).rev().take_while(|laminate| self.linked[*laminate]).count();
        contact - linked..contact + 1
    }

    /// Where unknowns and rows of all contacts stand.
    fn placed(&self) -> Vec<Places> {
        let (mut term, mut end, mut row) = (0, 0, 0);
        let mut all = Vec::new();
        for (contact, columns) in self.columns.iter().enumerate() {
            let mut told = self.told(contact);
            if self.chain(contact).len() > 1 {
                told.iter_mut().zip(self.told(contact - 1)).for_each(|(own, above)| own.count_from(&above));
            }
            let is_told = |term: usize| told.iter().any(|told| told.column == term);
            let terms: Vec<usize> = (0..columns.terms()).filter(|term| !is_told(*term)).collect();
            let first = columns.terms() + columns.ends();
            let others = first..first + columns.others.len();
            let of_told = told.iter().map(|told| told.column).filter(|_| !columns.intervals.is_empty());
            let left: Vec<usize> = of_told.chain(others).collect();
            let next = (term + terms.len(), end + columns.ends(), row + left.len());
            all.push(Places { terms: (terms, term), ends: end, left: (left, row), told });
            (term, end, row) = next;
        }
        all
    }

    /// The columns of a contact whose amplitudes are told.
    fn told(&self, contact: usize) -> Vec<Told> {
        let columns = &self.columns[contact];
        if self.problem.is_known(contact) {
            return vec![Told { column: 0, known: 1.0, by_loads: vec![0.0; self.loads.len()] }];
        }
        let has_resultant = |group: &Range<usize>| columns.intervals[group.start].has_orders()[0];
        let groups = columns.groups.iter().enumerate().filter(|(_, group)| has_resultant(group));
        let own =
            groups.filter_map(|(number, group)| Some((number, self.problem.group(contact, number)?, group.start)));
        own.flat_map(|(number, own, start)| self.told_of(contact, (number, &own), columns.first(start))).collect()
    }

    /// The columns whose amplitudes the resultant of a group of intervals tells, and its moment if nothing is even: the first ones.
    fn told_of(&self, contact: usize, (number, own): (usize, &Group), first: usize) -> Vec<Told> {
        let carried = &self.columns[contact].carried;
        // what presses on top is carried by all contacts, but each opening by itself
        let is_by_itself = contact == 0 || self.problem.is_opened(contact);
        let is_carried = |load: &Load| match load.place() {
            place if is_by_itself => place == (contact, number),
            (above, _) => above == 0,
        };
        let unit = |load: &Load| if is_carried(load) { self.carried_by(*load) } else { [0.0; 2] };
        let by_loads: Vec<[f64; 2]> = self.loads.iter().map(unit).collect();
        // what is known is all less what the unknown loads have where they count from
        let mut known = [own.share, own.moment.unwrap_or(0.0)];
        for (load, unit) in self.loads.iter().zip(&by_loads) {
            match load {
                Load::Force(_) => known.iter_mut().zip(unit).for_each(|(known, unit)| *known -= unit),
                Load::Moment { contact: 0, group } if is_carried(load) => {
                    known[1] += self.carried_by(Load::Force(*group))[1]
                }
                Load::Moment { .. } => {}
            }
        }
        let by_resultants = by_loads.iter().map(|[resultant, _]| *resultant).collect();
        let mut told = vec![Told { column: first, known: known[0], by_loads: by_resultants }];
        if self.moves {
            let about_first = |[resultant, moment]: &[f64; 2]| {
                (moment - resultant * carried[first][1]) * carried[first + 1][1].recip()
            };
            let by_loads = by_loads.iter().map(about_first).collect();
            told.push(Told { column: first + 1, known: about_first(&known), by_loads });
        }
        told
    }

    /// Resultant and moment about x = 0 of an unknown load, per unit of it: a force acts in the middle of the first interval where the moment is counted from there.
    fn carried_by(&self, load: Load) -> [f64; 2] {
        let Load::Force(group) = load else { return [0.0, 1.0] };
        let (own, first) = (&self.problem.groups(0)[group], self.columns[0].groups[group].start);
        [own.share, own.moment.unwrap_or(own.share * self.columns[0].intervals[first].middle)]
    }

    /// The places of the unknown terms that are among the first ones of each interval, as many as `counts` says.
    pub(super) fn kept(&self, counts: &[usize]) -> Vec<usize> {
        let mut next = counts.iter();
        let mut kept = Vec::new();
        for (columns, Places { terms: (terms, first), .. }) in self.columns.iter().zip(&self.places) {
            let last = columns.counts.iter().zip(next.by_ref()).enumerate();
            let ranges: Vec<Range<usize>> =
                last.map(|(interval, (_, count))| columns.first(interval)..columns.first(interval) + count).collect();
            let is_kept = |term: &usize| ranges.iter().any(|range| range.contains(term));
            kept.extend((*first..).zip(terms).filter(|(_, term)| is_kept(term)).map(|(place, _)| place));
        }
        kept
    }

    /// The angles by which bodies turn against each other at a group of intervals, with their signs: a punch that does not turn is turned against
    /// the layer below by what all layers turn.
    pub(super) fn angles_of(&self, contact: usize, group: usize) -> Vec<(usize, f64)> {
        if let Some(own) = self.turning.iter().position(|turning| *turning == (contact, group)) {
            return vec![(own, 1.0)];
        }
        let below = self.turning.iter().enumerate().filter(|(_, (other, _))| *other > contact);
        below.map(|(angle, _)| (angle, -1.0)).collect()
    }

    /// What the sharp tip of a punch, if there is one within an interval, makes on a half-plane: its terms follow from their own rows.
    pub(super) fn tip(&self, contact: usize, interval: &ContactInterval) -> Tip {
        let tip = self.problem.tip(contact, interval.punch);
        let of = |(at, jump): (f64, f64)| {
            let strength = interval.twin.under_jump * jump / (interval.unit() * self.layout.own[contact].limit);
            Tip { strength, at: (at - interval.middle) / interval.half }
        };
        tip.map(of).filter(|tip| tip.at.abs() < 1.0).unwrap_or_default()
    }

    /// What sharp tips make on each interval of a contact.
    pub(super) fn tips(&self, contact: usize) -> Vec<Tip> {
        self.columns[contact].intervals.iter().map(|interval| self.tip(contact, interval)).collect()
    }

    pub(super) fn zeta(&self, contact: usize, nodes: Range<usize>) -> &[f64] {
        let reach = self.layout.own[contact].reach;
        &self.layout.zeta[nodes.start.min(reach)..nodes.end.min(reach)]
    }

    /// The columns at the wavenumbers of block `number`.
    pub(super) fn sampled(&self, number: usize) -> Rc<Sampled> {
        if let Some(kept) = self.blocks.borrow().get(number) {
            return kept.clone();
        }
        let (first, workspace) = (number * AT_ONCE, &self.problem.kernel.workspace);
        let nodes = first..self.layout.zeta.len().min(first + AT_ONCE);
        let all = 0..self.columns.len();
        let waves: Vec<Samples> = all.clone().map(|contact| self.waves(contact, nodes.clone())).collect();
        // of a given pressure none
        let long = |contact: usize| {
            let zeta = self.zeta(contact, nodes.clone());
            // openings meet resultants and moments as well
            let is_met = self.problem.kernel.neighbours(contact).any(|(other, _)| self.problem.is_opened(other));
            match self.problem.sides[contact].given().filter(|_| is_met) {
                Some(given) => Long::of_given(given.moment, zeta, self.parts(), workspace),
                None => self.columns[contact].long_waves(zeta, workspace),
            }
        };
        let long: Vec<Long> = all.map(long).collect();
        let whole = waves.iter().zip(&long).map(|(waves, long)| long.whole(waves, workspace)).collect();
        let size: usize = waves.iter().map(|waves| waves.values.len()).sum();
        let sampled = Rc::new(Sampled { waves, long, whole });
        let mut blocks = self.blocks.borrow_mut();
        if blocks.len() == number && (number + 1) * size <= self.keeps {
            blocks.push(sampled.clone());
        }
        sampled
    }

    /// The columns of a contact at some wavenumbers.
    fn waves(&self, contact: usize, nodes: Range<usize>) -> Samples {
        let (zeta, workspace) = (self.zeta(contact, nodes), &self.problem.kernel.workspace);
        let Some(given) = self.problem.sides[contact].given() else {
            return self.columns[contact].waves(zeta, workspace);
        };
        let mut column = Samples::new(self.parts() * zeta.len(), 1, workspace);
        let even = zeta.iter().map(|zeta| zeta * given.transform_minus_one(*zeta));
        let odd = zeta.iter().filter(|_| self.moves).map(|zeta| zeta * given.odd_transform_less_moment(*zeta));
        column.values.iter_mut().zip(even.chain(odd)).for_each(|(into, value)| *into = value);
        column
    }

    /// What the columns of a contact are at short waves; `None` if these take too many wavenumbers.
    pub(super) fn short_waves(&self, contact: usize) -> Option<&[ShortWaves]> {
        let made = || self.columns[contact].short_waves(self.problem.kernel, self.layout, contact);
        self.short_waves[contact].get_or_init(made).as_deref()
    }

    /// What the tests of a contact see of the slope of the punch.
    pub(super) fn load(&self, contact: usize) -> &[f64] {
        self.slopes[contact].get_or_init(|| {
            let (columns, own) = (&self.columns[contact], &self.layout.own[contact]);
            let exponentials = own.exponentials_over_limit();
            columns.load(&self.problem.sides[contact], &self.tips(contact), own.limit, &exponentials)
        })
    }

    /// The real part of exp(iζx) alone, or the imaginary one as well.
    pub(super) fn parts(&self) -> usize {
        if self.moves { 2 } else { 1 }
    }

    /// Weights of a coupling from a wavenumber on, as many as there are.
    pub(super) fn coupling(&self, laminate: usize, first: usize) -> &[f64] {
        let weights = &self.layout.coupling[laminate];
        &weights[first.min(weights.len())..]
    }

    pub(super) fn own(&self, contact: usize, first: usize) -> &[f64] {
        let weights = &self.layout.own[contact].unit;
        &weights[first.min(weights.len())..]
    }

    /// The amplitudes of all columns of a contact, of the pressures of all intervals.
    pub(super) fn amplitudes(&self, contact: usize, pressures: &[Pressure]) -> Vec<f64> {
        self.columns[contact].amplitudes(self.pressures_of(contact, pressures))
    }

    /// The pressures of the intervals of a contact, of the pressures of all intervals.
    pub(super) fn pressures_of<'b>(&self, contact: usize, pressures: &'b [Pressure]) -> &'b [Pressure] {
        let first: usize = self.columns[..contact].iter().map(|columns| columns.intervals.len()).sum();
        &pressures[first..first + self.columns[contact].intervals.len()]
    }

    /// The amplitudes of all columns of all contacts, so that the first ones tell resultants and moments; 1 of a given pressure.
    pub(super) fn told_amplitudes(&self, pressures: &[Pressure]) -> Vec<Vec<f64>> {
        let of = |contact: usize| {
            if self.problem.is_known(contact) {
                return vec![1.0];
            }
            let mut amplitudes = self.amplitudes(contact, pressures);
            self.columns[contact].as_told(&mut amplitudes);
            amplitudes
        };
        (0..self.columns.len()).map(of).collect()
    }
}
