//! Pressures from the unknowns of the equations and the other way round, and by how much pressures miss the equations.
use crate::contact::intervals::columns::Columns;
use crate::contact::intervals::equations::{Equations, Load, Places, Solved, Told};
use crate::contact::intervals::pressure::Pressure;
use crate::contact::intervals::support::ContactInterval;
use crate::contact::intervals::system::{Rows, Unknowns};
use crate::contact::problem::Prescribed;
use crate::numeric::{dot, largest};

impl Equations<'_> {
    /// The amplitudes of all columns of all contacts, the first ones of which tell resultants and moments; 1 of a given pressure.
    fn amplitudes_of(&self, Unknowns { x, q }: &Unknowns) -> Vec<Vec<f64>> {
        let loads = &q[q.len() - self.turning.len() - self.loads.len()..];
        let mut all: Vec<Vec<f64>> = Vec::with_capacity(self.places.len());
        for (contact, (columns, places)) in self.columns.iter().zip(&self.places).enumerate() {
            let told = |told: &Told| told.known + dot(&told.by_loads, loads);
            if columns.intervals.is_empty() {
                all.push(places.told.iter().map(told).collect());
                continue;
            }
            let mut amplitudes = vec![0.0; columns.terms()];
            let (terms, first) = &places.terms;
            terms.iter().zip(&x[*first..]).for_each(|(term, value)| amplitudes[*term] = *value);
            places.told.iter().for_each(|own| amplitudes[own.column] = told(own));
            amplitudes.extend(&q[places.ends..places.ends + columns.ends()]);
            if self.chain(contact).len() > 1 {
                amplitudes.iter_mut().zip(&all[contact - 1]).for_each(|(own, above)| *own += above);
            }
            all.push(amplitudes);
        }
        all
    }

    /// Pressures from unknowns, with `counts` terms on the intervals.
    pub(super) fn solved(&self, unknowns: &Unknowns, counts: &[usize]) -> Solved {
        let mut counts = counts.iter();
        let (others, angles) = unknowns.q.split_at(unknowns.q.len() - self.turning.len());
        let loads = &others[others.len() - self.loads.len()..];
        let mut amplitudes = self.amplitudes_of(unknowns);
        let mut of = |contact: usize| {
            let (columns, amplitudes) = (&self.columns[contact], &mut amplitudes[contact]);
            columns.as_they_are(amplitudes);
            let (terms, singular) = amplitudes.split_at(columns.terms());
            let mut pressures = columns.pressures(terms, singular);
            for ((pressure, interval), count) in pressures.iter_mut().zip(columns.intervals).zip(counts.by_ref()) {
                pressure.terms.truncate(*count);
                pressure.tip = self.tip(contact, interval);
                let terms = pressure.terms.iter_mut().enumerate();
                terms.for_each(|(m, y)| *y -= pressure.tip.term(interval, m));
            }
            pressures
        };
        let rotation = |contact: usize, group: usize| {
            self.angles_of(contact, group).into_iter().map(|(angle, sign)| sign * angles[angle]).sum()
        };
        let of_contact = |(contact, columns): (usize, &Columns)| {
            (0..columns.groups.len()).map(|group| rotation(contact, group)).collect()
        };
        let rotations = self.columns.iter().enumerate().map(of_contact).collect();
        let of_load = |(load, value): (&Load, &f64)| match load {
            Load::Force(punch) => Some((*punch, *value)),
            Load::Moment { .. } => None,
        };
        let found: Vec<(usize, f64)> = self.loads.iter().zip(loads).filter_map(of_load).collect();
        let groups = self.problem.groups(0);
        let force = 1.0 + found.iter().map(|(punch, value)| groups[*punch].share * (value - 1.0)).sum::<f64>();
        let forces = found.into_iter().map(|(_, value)| value).collect();
        let (loads, angles) = (loads.to_vec(), angles.to_vec());
        let mut pressures: Vec<Pressure> = self.problem.unknown().flat_map(&mut of).collect();
        for (punch, prescribed) in &self.problem.prescribed {
            let Prescribed::End { side, .. } = *prescribed else { continue };
            // as the last rows say, but for rounding
            let [interval, end] = self.held_end(*punch, side);
            pressures[interval].singular[end] = 0.0;
        }
        Solved { pressures, loads, angles, rotations, forces, force }
    }

    /// The unknowns of pressures, but for tips, which are where they are; what resultants and moments tell is left out.
    pub(super) fn unknowns(&self, solved: &Solved) -> Unknowns {
        let (mut x, mut q) = (vec![0.0; self.unknown_terms()], Vec::new());
        let mut pressures = solved.pressures.iter();
        let of = |(contact, columns): (usize, &Columns)| -> Vec<Pressure> {
            let all = columns.intervals.iter().zip(columns.counts).zip(pressures.by_ref());
            let of = |((interval, count), pressure): ((&ContactInterval, &usize), &Pressure)| {
                let mut terms = pressure.terms.clone();
                terms.resize(*count, 0.0);
                Pressure { terms, tip: self.tip(contact, interval), ..pressure.clone() }
            };
            all.map(of).collect()
        };
        let pressures: Vec<Pressure> = self.columns.iter().enumerate().flat_map(of).collect();
        let amplitudes = self.told_amplitudes(&pressures);
        for contact in self.problem.unknown() {
            let (columns, places) = (&self.columns[contact], &self.places[contact]);
            let above = if self.chain(contact).len() > 1 { &amplitudes[contact - 1][..] } else { &[] };
            let own = |column: usize| amplitudes[contact][column] - above.get(column).unwrap_or(&0.0);
            let (terms, first) = &places.terms;
            x[*first..].iter_mut().zip(terms).for_each(|(x, term)| *x = own(*term));
            q.extend((columns.terms()..columns.terms() + columns.ends()).map(own));
        }
        q.extend(solved.loads.iter().chain(&solved.angles));
        Unknowns { x, q }
    }

    /// What the tests of each contact miss, and last what is missing of what is prescribed, with each of some unknowns: zero if these solve the equations. `None` if short
    /// waves take too many wavenumbers.
    pub(super) fn residuals(&self, all: &[Unknowns]) -> Option<Vec<Vec<Vec<f64>>>> {
        let sets: Vec<Vec<Vec<f64>>> = all.iter().map(|unknowns| self.amplitudes_of(unknowns)).collect();
        let zeros: Vec<Vec<f64>> = self.columns.iter().map(|columns| vec![0.0; columns.rows()]).collect();
        let mut missed = vec![zeros; all.len()];
        self.responses(&sets, |[set, contact], _, sampled, response| {
            let mut tested = sampled.waves[contact].test(response);
            let whole = sampled.whole[contact].test(response);
            sampled.long[contact].places.iter().zip(whole).for_each(|(place, value)| tested[*place] = value);
            missed[set][contact].iter_mut().zip(tested).for_each(|(row, value)| *row -= value);
        });
        for ((rows, amplitudes), unknowns) in missed.iter_mut().zip(&sets).zip(all) {
            let angles = self.angles_among(unknowns);
            for contact in self.problem.unknown() {
                self.add_in_space_of(contact, &amplitudes[contact], angles, &mut rows[contact])?;
            }
            rows.push(self.unmet(amplitudes, unknowns));
        }
        Some(missed)
    }

    /// By how much pressures without what is singular at some ends miss a depth that is prescribed, relative.
    pub(super) fn missed(&self, solved: &Solved, without: &[bool]) -> f64 {
        let depths = self.problem.prescribed.iter().filter_map(|(_, prescribed)| prescribed.depth());
        let mut regular = solved.clone();
        let ends = regular.pressures.iter_mut().flat_map(|pressure| &mut pressure.singular);
        ends.zip(without).filter(|(_, without)| **without).for_each(|(q, _)| *q = 0.0);
        let unknowns = self.unknowns(&regular);
        let amplitudes = self.amplitudes_of(&unknowns);
        let sunk = self.sunk().iter().map(|sunk| sunk.with(&amplitudes, self.angles_among(&unknowns)));
        largest(sunk.zip(depths).map(|(own, depth)| (own / depth - 1.0).abs()))
    }

    /// The angles among some unknowns.
    fn angles_among<'a>(&self, unknowns: &'a Unknowns) -> &'a [f64] {
        &unknowns.q[unknowns.q.len() - self.turning.len()..]
    }

    /// What is missing of what is prescribed of punches in place of their forces.
    fn unmet(&self, amplitudes: &[Vec<f64>], unknowns: &Unknowns) -> Vec<f64> {
        let mut sunk = self.sunk().iter().map(|sunk| sunk.with(amplitudes, self.angles_among(unknowns)));
        let of = |(punch, prescribed): &(usize, Prescribed)| match prescribed {
            Prescribed::End { side, .. } => -unknowns.q[self.prescribed_end(*punch, *side)],
            Prescribed::Depth(depth) => depth - sunk.next().unwrap_or(0.0),
        };
        self.problem.prescribed.iter().map(of).collect()
    }

    /// Where the end of a contact that is as far out as prescribed stands among the unknowns.
    pub(super) fn prescribed_end(&self, punch: usize, side: f64) -> usize {
        let [interval, end] = self.held_end(punch, side);
        self.places[0].ends + self.columns[0].end(interval) + end
    }

    /// The interval under a punch that ends where it is prescribed, and which of its ends that is: where all is even the right one of the innermost interval.
    fn held_end(&self, punch: usize, side: f64) -> [usize; 2] {
        let (columns, group) = (&self.columns[0], &self.columns[0].groups[punch]);
        let is_first = side < 0.0 || !self.moves;
        let interval = if is_first { group.start } else { group.end - 1 };
        [interval, if side < 0.0 { 0 } else { columns.intervals[interval].sides().len() - 1 }]
    }

    /// Adds what tests of a contact miss in space with some amplitudes and angles.
    fn add_in_space_of(&self, contact: usize, amplitudes: &[f64], angles: &[f64], rows: &mut [f64]) -> Option<()> {
        let (columns, limit) = (&self.columns[contact], self.layout.own[contact].limit);
        let mut as_they_are = amplitudes.to_vec();
        columns.as_they_are(&mut as_they_are);
        let matrix = self.in_space(contact, Some(&as_they_are))?.matrix;
        let pressed = self.load(contact).iter().zip(matrix.col_as_slice(0));
        rows.iter_mut().zip(pressed).for_each(|(row, (load, pressed))| *row += load - limit * pressed);
        for (row, other) in rows[columns.terms() + columns.ends()..].iter_mut().zip(&columns.others) {
            let Some(group) = columns.tells_rotation_of(*other) else { continue };
            let turned: f64 = self.angles_of(contact, group).iter().map(|(angle, sign)| sign * angles[*angle]).sum();
            *row += turned * columns.rotation(*other);
        }
        Some(())
    }

    /// The rows of all unknowns, from the tests of each contact.
    pub(super) fn rows_of(&self, tested: &[Vec<f64>]) -> Rows {
        let mut all = Rows::zeros(self.unknown_terms(), self.border());
        for contact in self.problem.unknown() {
            for Places { terms, left, .. } in &self.places[self.chain(contact)] {
                let add = |(into, row): (&mut f64, &usize)| *into += tested[contact][*row];
                all.terms[terms.1..].iter_mut().zip(&terms.0).for_each(add);
                all.left[left.1..].iter_mut().zip(&left.0).for_each(add);
            }
        }
        // the last rows
        let unmet = &tested[self.columns.len()];
        let first = all.left.len() - unmet.len();
        all.left[first..].copy_from_slice(unmet);
        all
    }

    /// The unknown terms that make up for what tests miss on half-planes, where each term acts on its own test alone.
    pub(super) fn on_half_planes(&self, tested: &[Vec<f64>]) -> Vec<f64> {
        let mut all = Vec::new();
        let mut above: Vec<f64> = Vec::new();
        for contact in self.problem.unknown() {
            let columns = &self.columns[contact];
            let of = |(interval, count): (&ContactInterval, &usize)| {
                let limit = self.layout.own[contact].limit;
                (0..*count).map(|m| (limit * interval.on_half_plane(m)).recip()).collect::<Vec<f64>>()
            };
            let compliances = columns.intervals.iter().zip(columns.counts).flat_map(of);
            let own: Vec<f64> = compliances.zip(&tested[contact]).map(|(compliance, row)| compliance * row).collect();
            let is_linked = self.chain(contact).len() > 1;
            let more = |term: &usize| own[*term] - if is_linked { above[*term] } else { 0.0 };
            all.extend(self.places[contact].terms.0.iter().map(more));
            above = own;
        }
        all
    }
}
