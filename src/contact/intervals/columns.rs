//! What is tested and what presses on the intervals of one contact, as columns.
//!
//! The pressure of an interval is p = Σ y_j (unit/j) sin jφ, x = middle + half cos φ, unit sin φ having the resultant 1 on the interval and
//! its mirror image together; at its ends it may be singular, q unit (1 ± cos φ)/(2 sin φ). A column is ζ times the transform ∫ p exp(iζx) dx: its
//! real part, and if nothing is even its imaginary part below. The slope of a gap is tested with (2/πw) cos kφ on each interval, which makes 2 J_k(ζw)/w
//! times a phase of a wave exp(iζx), as sin jφ makes 2 J_j(ζw)/w: all tests with k > 0 are columns, too. The others are the tests with k = 0, and of
//! the closing of gaps between two intervals.
//!
//! Only the first column of a group of intervals has a resultant, and if nothing is even only the first two have a moment about x = 0: from all others as
//! much of both is subtracted as they have, in such a way that long waves, which feel resultants and moments most, lose no digits.
use std::f64::consts::PI;
use std::ops::Range;

use crate::contact::intervals::pressure::{Pressure, Tip};
use crate::contact::intervals::support::{ContactInterval, Parity};

/// The intervals of one contact, with the numbers of terms on each.
pub(super) struct Columns<'a> {
    pub(super) intervals: &'a [ContactInterval],
    pub(super) counts: &'a [usize],
    /// Whether nothing is even, so that there are moments.
    moves: bool,
    /// What is subtracted from columns, and then from other tests, one after the other, so that only the first ones of a group have a resultant, a
    /// moment or, as a test, a rotation.
    pub(super) subtracted: Vec<Subtracted>,
    /// The intervals under each punch, or all of them between layers.
    pub(super) groups: Vec<Range<usize>>,
    /// The tests that are no columns, group by group.
    pub(super) others: Vec<Other>,
    /// Resultants and moments of the terms and then of the singular pressures at the ends; no moments of what is even.
    pub(super) carried: Vec<Carried>,
}

/// A test that is no column.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Other {
    /// The test of an interval with k = 0.
    Mean(usize),
    /// The closing of the gap between an interval and the next.
    Closing(usize),
}

/// So much of one column, or row, is subtracted from another.
pub(super) struct Subtracted {
    pub(super) into: usize,
    pub(super) from: usize,
    pub(super) part: f64,
}

/// Resultant and moment.
pub(super) type Carried = [f64; 2];

impl<'a> Columns<'a> {
    pub(super) fn new(intervals: &'a [ContactInterval], counts: &'a [usize], moves: bool) -> Self {
        let mut next = 0;
        let groups = intervals.chunk_by(ContactInterval::is_grouped_with).map(|group| {
            next += group.len();
            next - group.len()..next
        });
        let groups: Vec<Range<usize>> = groups.collect();
        let others = groups.iter().flat_map(|group| {
            let is_tested = |number: &usize| intervals[*number].has_orders()[1];
            let beside = group.clone().filter(is_tested).map(Other::Mean);
            beside.chain((group.start..group.end - 1).map(Other::Closing))
        });
        let others = others.collect();
        let (subtracted, carried) = (Vec::new(), carried(intervals, counts));
        let mut columns = Self { intervals, counts, moves, subtracted, groups, others, carried };
        columns.subtracted = columns.all_subtracted();
        columns
    }
}

impl Columns<'_> {
    /// Whether there are as many columns and tests of each kind as of another contact, the intervals of which are alike.
    pub(super) fn are_like(&self, other: &Self) -> bool {
        !self.intervals.is_empty() && self.counts == other.counts && self.groups.len() == other.groups.len()
    }

    /// Number of terms.
    pub(super) fn terms(&self) -> usize {
        self.counts.iter().sum()
    }

    /// Number of ends.
    pub(super) fn ends(&self) -> usize {
        self.intervals.iter().map(|interval| interval.sides().len()).sum()
    }

    /// Number of all tests, and of singular pressures, which are none.
    pub(super) fn rows(&self) -> usize {
        self.terms() + self.ends() + self.others.len()
    }

    /// Number of the first term of an interval.
    pub(super) fn first(&self, interval: usize) -> usize {
        self.counts[..interval].iter().sum()
    }

    /// Number of the first end of an interval.
    pub(super) fn end(&self, interval: usize) -> usize {
        self.intervals[..interval].iter().map(|interval| interval.sides().len()).sum()
    }

    /// The real part of a column alone, or the imaginary one as well.
    pub(super) fn parts(&self) -> usize {
        if self.moves() { 2 } else { 1 }
    }

    /// Whether nothing is even, so that there are moments.
    pub(super) fn moves(&self) -> bool {
        self.moves
    }

    /// Whether what presses is odd: then a column has an imaginary part alone.
    pub(super) fn are_odd(&self) -> bool {
        self.intervals.first().is_some_and(ContactInterval::is_odd)
    }

    /// The place of a test that is no column, behind all columns.
    pub(super) fn place(&self, wanted: Other) -> Option<usize> {
        let place = self.others.iter().position(|other| *other == wanted);
        place.map(|place| self.terms() + self.ends() + place)
    }

    /// The first interval of the group of an interval.
    fn head(&self, interval: usize) -> usize {
        self.groups.iter().find(|group| group.contains(&interval)).map_or(interval, |group| group.start)
    }

    /// The gap between an interval and the next.
    pub(super) fn gap(&self, interval: usize) -> [f64; 2] {
        [self.intervals[interval].to(), self.intervals[interval + 1].from()]
    }

    /// Resultants and moments of tests that are no columns: how long waves exp(iζx) are tested. Without the constant that any rotation makes, of which
    /// as much of the test of the first interval is subtracted.
    pub(super) fn carried_by(&self, other: Other) -> Carried {
        match other {
            // pressures have no resultant that is odd
            Other::Mean(_) if self.are_odd() => [0.0; 2],
            Other::Mean(number) => {
                let ContactInterval { middle, half, .. } = self.intervals[number];
                [2.0 * middle / half, 0.5 * half + middle * middle / half]
            }
            Other::Closing(number) => {
                let [from, to] = self.gap(number);
                let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
                let factor = 4.0 / (PI * half);
                [factor * middle, factor * (0.5 * middle * middle + half * half / 6.0)]
            }
        }
    }

    /// The slope of a rotation in a test that is no column.
    pub(super) fn rotation(&self, other: Other) -> f64 {
        match other {
            Other::Mean(number) => 2.0 / self.intervals[number].half,
            Other::Closing(number) => {
                let [from, to] = self.gap(number);
                8.0 / (PI * (to - from))
            }
        }
    }

    /// The number of the group whose rotation is told by a test: where nothing is even, by the one with k = 0 of the first interval.
    pub(super) fn tells_rotation_of(&self, other: Other) -> Option<usize> {
        let Other::Mean(number) = other else { return None };
        let group = self.groups.iter().position(|group| group.start == number);
        group.filter(|_| self.moves())
    }

    /// The interval of each term, then of each singular pressure.
    fn interval_of_columns(&self) -> Vec<usize> {
        let all = 0..self.intervals.len();
        let terms = all.clone().flat_map(|number| vec![number; self.counts[number]]);
        terms.chain(all.flat_map(|number| vec![number; self.intervals[number].sides().len()])).collect()
    }

    /// See [`Self::subtracted`].
    fn all_subtracted(&self) -> Vec<Subtracted> {
        let Self { carried, others, .. } = self;
        let mut all: Vec<Subtracted> = Vec::new();
        for (into, interval) in self.interval_of_columns().into_iter().enumerate() {
            all.extend(self.subtracted_from(into, interval, carried[into], carried));
        }
        for (number, other) in others.iter().enumerate().filter(|(_, other)| self.tells_rotation_of(**other).is_none())
        {
            let (Other::Mean(interval) | Other::Closing(interval)) = *other;
            let into = carried.len() + number;
            let head = Other::Mean(self.head(interval));
            let mut own = self.carried_by(*other);
            if let Some(from) = self.place(head).filter(|_| self.moves()) {
                let part = self.rotation(*other) / self.rotation(head);
                all.push(Subtracted { into, from, part });
                own.iter_mut().zip(self.carried_by(head)).for_each(|(own, first)| *own -= part * first);
            }
            all.extend(self.subtracted_from(into, interval, own, carried));
        }
        all
    }

    /// What is subtracted from one of them, which has this resultant and moment.
    fn subtracted_from(&self, into: usize, interval: usize, own: Carried, carried: &[Carried]) -> Vec<Subtracted> {
        if own == [0.0; 2] {
            return Vec::new();
        }
        let first = self.first(self.head(interval));
        let mut all = vec![Subtracted { into, from: first, part: own[0] }];
        if self.moves() {
            // the first column keeps its moment: far from x = 0 the second one would be large without that
            let left = own[1] - own[0] * carried[first][1];
            all.push(Subtracted { into, from: first + 1, part: left / carried[first + 1][1] });
        }
        all.retain(|one| one.into != one.from && one.part != 0.0);
        all
    }

    /// Amplitudes of columns less what is subtracted become amplitudes of the columns as they are.
    pub(super) fn as_they_are(&self, amplitudes: &mut [f64]) {
        // a column that loses a part of another one takes as much from its amplitude
        let subtracted = self.subtracted.iter().rev().filter(|one| one.into < amplitudes.len());
        let all: Vec<&Subtracted> = subtracted.collect();
        all.into_iter().for_each(|Subtracted { into, from, part }| amplitudes[*from] -= part * amplitudes[*into]);
    }

    /// The other way round: the amplitudes of the first columns tell resultant and moment.
    pub(super) fn as_told(&self, amplitudes: &mut [f64]) {
        let subtracted = self.subtracted.iter().filter(|one| one.into < amplitudes.len());
        let all: Vec<&Subtracted> = subtracted.collect();
        all.into_iter().for_each(|Subtracted { into, from, part }| amplitudes[*from] += part * amplitudes[*into]);
    }

    /// The amplitudes of terms, then of singular pressures, of the pressures of its intervals.
    pub(super) fn amplitudes(&self, pressures: &[Pressure]) -> Vec<f64> {
        let all = pressures.iter().zip(self.intervals);
        let of = |(own, interval): (&Pressure, &ContactInterval)| -> Vec<f64> {
            own.terms.iter().enumerate().map(|(m, y)| y + own.tip.term(interval, m)).collect()
        };
        all.flat_map(of).chain(pressures.iter().flat_map(|own| own.singular.iter().copied())).collect()
    }

    /// The pressures with these amplitudes.
    pub(super) fn pressures(&self, terms: &[f64], singular: &[f64]) -> Vec<Pressure> {
        let (mut terms, mut singular) = (terms.iter().copied(), singular.iter().copied());
        let of = |(interval, count): (&ContactInterval, &usize)| Pressure {
            terms: terms.by_ref().take(*count).collect(),
            singular: singular.by_ref().take(interval.sides().len()).collect(),
            tip: Tip::default(),
        };
        self.intervals.iter().zip(self.counts).map(of).collect()
    }
}

/// Resultants and moments of the terms and then of the singular pressures at the ends; no moments of what is even.
fn carried(intervals: &[ContactInterval], counts: &[usize]) -> Vec<Carried> {
    let moment = |interval: &ContactInterval, arm: f64| {
        if interval.parity == Parity::None { interval.middle + arm } else { 0.0 }
    };
    let term = |(number, m): (usize, usize)| {
        let interval = &intervals[number];
        match interval.order(m) {
            1 => [1.0, moment(interval, 0.0)],
            2 => [0.0, moment(interval, 0.25 * interval.half) - moment(interval, 0.0)],
            _ => [0.0; 2],
        }
    };
    let terms = (0..intervals.len()).flat_map(|number| (0..counts[number]).map(move |m| (number, m)));
    let ends = intervals.iter().flat_map(|interval| {
        let resultant = match (interval.is_even(), interval.opens) {
            (true, false) => 2.0,
            (true, true) => 0.0,
            _ => 1.0,
        };
        interval.sides().iter().map(move |side| [resultant, moment(interval, 0.5 * side * interval.half)])
    });
    terms.map(term).chain(ends).collect()
}
