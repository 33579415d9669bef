//! What short waves do next to graded faces, where kernels fall like 1/ζ, within each interval.
//!
//! Columns and tests of one interval have the same phase exp(iζ middle), which drops out of their products: products of Bessel functions of one argument
//! are left, and the integrals over these go on in a [`Tail`]. Terms and tests of odd orders do nothing to tests and terms of even orders. Products of different
//! intervals oscillate, and the first powers of 1/ζ are taken out of their kernel as a sum of exponentials: what these do is found in space, for different
//! intervals with closed forms, and for each interval with itself from the wavenumbers and the tail here.
use std::f64::consts::PI;

use crate::contact::integrals::columns::Columns as Table;
use crate::contact::integrals::layout::Layout;
use crate::contact::integrals::products::product;
use crate::contact::integrals::tail::{Ends, Tail, Weights};
use crate::contact::intervals::columns::{Columns, Other};
use crate::contact::intervals::space::InSpace;
use crate::contact::problem::modes::alternating;
use crate::kernel::Kernel;
use crate::numeric::bessel::{self, Wanted};

impl Columns<'_> {
    /// Adds what the kernel of a contact does, in units of its limit, with the columns as they are, of each interval to its own tests: beyond the
    /// wavenumbers of a layout, and what was taken out of the kernel there. `None` if that takes too many nodes.
    pub(super) fn add_short_waves(
        &self,
        space: &mut InSpace,
        kernel: &Kernel,
        layout: &Layout,
        contact: usize,
    ) -> Option<()> {
        let (own, from) = (&layout.own[contact], layout.tails_from[contact]);
        let (_, taken) = &own.exponentials;
        if from.is_infinite() && taken.is_empty() {
            return Some(());
        }
        for (number, interval) in self.intervals.iter().enumerate() {
            let (half, count) = (interval.half, self.counts[number]);
            let orders = interval.order(count - 1) + 1;
            let mut weights = Weights::default();
            weights.plain.extend(taken);
            let mut tail = Tail::default();
            if from.is_finite() {
                let ends = Ends { from, coupled: 0.0, to: kernel.is_smooth_from(contact) };
                tail = Tail::new(kernel, &[contact], [half; 2], orders, ends)?;
                tail.extend(&mut weights, |zeta| kernel.remainder(contact, zeta));
            }
            let table = table(kernel, &layout.zeta[..taken.len()], &tail, half, orders);
            let factor = 4.0 / (PI * own.limit * interval.images() * half * half);
            let sign = |order: usize| alternating(order / 2);
            let tests = (0..count).map(|m| (self.first(number) + m, interval.order(m)));
            let mean = self.place(Other::Mean(number)).map(|row| (row, 0));
            let pressing = self.pressing(number, orders);
            // what presses with each column, or with some amplitudes: sums of columns of even orders, and of odd ones
            let products = match space.amplitudes {
                None => product(table.part(0..orders), &weights, table.all()),
                Some(amplitudes) => {
                    let mut sums = Table::zeros(table.rows(), 2);
                    for Pressing { column, place, is_odd, part } in &pressing {
                        let sum = sums.column_mut(usize::from(*is_odd)).iter_mut().zip(table.column(*place));
                        sum.for_each(|(sum, value)| *sum += part * amplitudes[*column] * value);
                    }
                    product(table.part(0..orders), &weights, sums.all())
                }
            };
            for (row, k) in tests.chain(mean) {
                let factor = factor * sign(k);
                if space.amplitudes.is_some() {
                    space.matrix[(row, 0)] += factor * products.column(k % 2)[k];
                    continue;
                }
                for own in pressing.iter().filter(|own| own.is_odd == (k % 2 == 1)) {
                    space.matrix[(row, own.column)] += factor * own.part * products.column(own.place)[k];
                }
            }
        }
        Some(())
    }

    /// What presses on an interval at short waves, as columns of [`table`].
    fn pressing(&self, number: usize, orders: usize) -> Vec<Pressing> {
        let interval = &self.intervals[number];
        let first = self.first(number);
        let term = |m: usize| {
            let j = interval.order(m);
            Pressing { column: first + m, place: j, is_odd: j % 2 == 1, part: alternating(j / 2) }
        };
        let half = 0.5 * interval.half;
        let ends = (self.terms() + self.end(number)..).zip(interval.sides()).flat_map(|(column, side)| {
            let images = if interval.is_even() { 2.0 } else { 1.0 };
            let odd = Pressing { column, place: orders, is_odd: true, part: half * images };
            let even = Pressing { column, place: orders + 1, is_odd: false, part: -half * side };
            [odd, even]
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

/// J of all orders, then ζ J_0 and ζ J_1 of singular pressures, at the real wavenumbers and in the rows of a tail.
fn table(kernel: &Kernel, real: &[f64], tail: &Tail, half: f64, orders: usize) -> Table {
    let (first, rows) = (real.len(), real.len() + tail.rows());
    let mut table = Table::new(rows, orders + 2, &kernel.workspace);
    let arguments: Vec<f64> = real.iter().map(|zeta| zeta * half).collect();
    bessel::scaled_orders(orders, Wanted::ALL, &arguments, 1.0, rows, &mut table.values);
    tail.tabulate((half, 1.0), (Wanted::ALL, orders), (first, rows), &mut table.values);
    for order in 0..2 {
        let [column, into] = table.two_mut(order, orders + order);
        into.copy_from_slice(column);
        into.iter_mut().zip(real).for_each(|(value, zeta)| *value *= zeta);
        tail.times_wavenumbers(&mut into[first..]);
    }
    table
}
