//! What short waves do next to graded faces, where kernels fall like 1/ζ, within each interval.
//!
//! Columns and tests of one interval have the same phase exp(iζ middle), which drops out of their products: products of Bessel functions of one argument
//! are left, and the integrals over these go on in a [`Tail`]. Terms and tests of odd orders do nothing to tests and terms of even orders. Products of different
//! intervals oscillate, and the first powers of 1/ζ are taken out of their kernel as a sum of exponentials: what these do is found in space, for different
//! intervals with closed forms, and for each interval with itself from the wavenumbers and the tail here.
use std::f64::consts::PI;

use crate::contact::integrals::layout::Layout;
use crate::contact::integrals::products::product;
use crate::contact::integrals::samples::Samples;
use crate::contact::integrals::tail::{Tail, Weights};
use crate::contact::intervals::columns::{Columns, Other};
use crate::contact::intervals::space::InSpace;
use crate::contact::intervals::support::ContactInterval;
use crate::kernel::Kernel;
use crate::numeric::bessel;

/// The columns of one interval at short waves, and the weights of the kernel there.
pub(super) struct ShortWaves {
    table: Samples,
    weights: Weights,
}

impl Columns<'_> {
    /// The short waves of each interval of a contact: beyond the wavenumbers of a layout, and what was taken out of the kernel there; empty if there are none.
    /// `None` if that takes too many nodes.
    pub(super) fn short_waves(&self, kernel: &Kernel, layout: &Layout, contact: usize) -> Option<Vec<ShortWaves>> {
        let (own, from) = (&layout.own[contact], layout.tails_from[contact]);
        let (_, taken) = &own.exponentials;
        if from.is_infinite() && taken.is_empty() {
            return Some(Vec::new());
        }
        let of = |(number, interval): (usize, &ContactInterval)| {
            let orders = self.orders(number);
            let mut weights = Weights::default();
            weights.plain.extend(taken);
            let mut tail = Tail::default();
            if from.is_finite() {
                tail = Tail::new((kernel, contact), interval.half, orders, [from, kernel.is_smooth_from(contact)])?;
                tail.extend(&mut weights, |zeta| kernel.remainder(contact, zeta));
            }
            let table = table(kernel, &layout.zeta[..taken.len()], &tail, interval, orders);
            Some(ShortWaves { table, weights })
        };
        self.intervals.iter().enumerate().map(of).collect()
    }

    /// Adds what the kernel of a contact does at short waves, in units of its limit, with the columns as they are, of each interval to its own tests.
    pub(super) fn add_short_waves(&self, space: &mut InSpace, short_waves: &[ShortWaves], limit: f64) {
        for (number, (interval, ShortWaves { table, weights })) in self.intervals.iter().zip(short_waves).enumerate() {
            let (half, count, orders) = (interval.half, self.counts[number], self.orders(number));
            let factor = 4.0 / (PI * limit * interval.images() * half * half);
            let tests =
                (0..count).map(|m| (self.first(number) + m, interval.order(m), 0.5 * half * interval.transform(m)));
            let mean = self.place(Other::Mean(number)).map(|row| (row, 0, 1.0));
            let (pressing, tested) = (self.pressing(number), 0..interval.wanted().below(orders));
            if let Some(amplitudes) = space.amplitudes {
                // what columns of even orders, or of odd ones, do with the amplitudes
                let made = |is_odd: bool| {
                    let mut pressed = vec![0.0; table.rows()];
                    for own in pressing.iter().filter(|own| own.is_odd == is_odd) {
                        let factor = own.part * amplitudes[own.column];
                        pressed.iter_mut().zip(table.column(own.place)).for_each(|(sum, value)| *sum += factor * value);
                    }
                    table.test(&weights.weighted(&pressed))
                };
                let [odd, even] = interval.has_orders();
                let all = [(even, false), (odd, true)]
                    .map(|(is_there, is_odd)| if is_there { made(is_odd) } else { Vec::new() });
                for (row, k, part) in tests.chain(mean) {
                    space.matrix[(row, 0)] += factor * part * all[k % 2][interval.among_wanted(k)];
                }
                continue;
            }
            let products = product(table.part(tested), weights, table.part(0..table.count()));
            for (row, k, part) in tests.chain(mean) {
                let factor = factor * part;
                for own in pressing.iter().filter(|own| own.is_odd == (k % 2 == 1)) {
                    space.matrix[(row, own.column)] +=
                        factor * own.part * products.column(own.place)[interval.among_wanted(k)];
                }
            }
        }
    }

    /// Orders of Bessel functions that the terms of an interval need.
    fn orders(&self, number: usize) -> usize {
        self.intervals[number].order(self.counts[number] - 1) + 1
    }

    /// What presses on an interval at short waves, as columns of [`table`].
    fn pressing(&self, number: usize) -> Vec<Pressing> {
        let interval = &self.intervals[number];
        let (first, singular) = (self.first(number), interval.wanted().below(self.orders(number)));
        let term = |m: usize| {
            let j = interval.order(m);
            Pressing {
                column: first + m,
                place: interval.among_wanted(j),
                is_odd: j % 2 == 1,
                part: 0.5 * interval.half * interval.transform(m),
            }
        };
        let half = 0.5 * interval.half;
        let ends = (self.terms() + self.end(number)..).zip(interval.sides()).flat_map(|(column, side)| {
            let images = if interval.is_even() { 2.0 } else { 1.0 };
            let odd = Pressing { column, place: singular, is_odd: true, part: half * images };
            let even = Pressing { column, place: singular + 1, is_odd: false, part: -half * images * side };
            [odd, even].into_iter().zip(interval.has_orders()).filter(|(_, is_there)| *is_there).map(|(own, _)| own)
        });
        (0..self.counts[number]).map(term).chain(ends).collect()
    }
}

/// A part of a column.
struct Pressing {
    column: usize,
    /// In the table.
    place: usize,
    /// Whether it acts on tests of odd orders only, or of even ones.
    is_odd: bool,
    part: f64,
}

/// J of all orders that are wanted, then ζ J_0 and ζ J_1 of singular pressures, at the real wavenumbers and in the rows of a tail.
fn table(kernel: &Kernel, real: &[f64], tail: &Tail, interval: &ContactInterval, orders: usize) -> Samples {
    let (first, rows) = (real.len(), real.len() + tail.rows());
    let (half, wanted) = (interval.half, interval.wanted());
    let count = wanted.below(orders);
    let mut table = Samples::new(rows, count + 2, &kernel.workspace);
    let arguments: Vec<f64> = real.iter().map(|zeta| zeta * half).collect();
    bessel::scaled_orders(orders, wanted, &arguments, 1.0, rows, &mut table.values);
    tail.tabulate(&kernel.workspace, (half, 1.0), (wanted, orders), (first, rows), &mut table.values);
    for order in 0..2 {
        let [column, into] = table.two_mut(order, count + order);
        into.copy_from_slice(column);
        into.iter_mut().zip(real).for_each(|(value, zeta)| *value *= zeta);
        tail.times_wavenumbers(&mut into[first..]);
    }
    table
}
