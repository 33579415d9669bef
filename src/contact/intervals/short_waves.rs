//! What short waves do next to graded faces, where kernels fall like 1/ζ, within each interval.
//!
//! Columns and tests of one interval have the same phase exp(iζ middle), which drops out of their products: products of Bessel functions of one argument
//! are left, and the integrals over these go on in a [`Tail`]. Terms and tests of odd orders do nothing to tests and terms of even orders. Products of different
//! intervals oscillate, and the first powers of 1/ζ are taken out of their kernel as a sum of exponentials: what these do is found in space, for different
//! intervals with closed forms, and for each interval with itself from the wavenumbers and the tail here.
use std::f64::consts::PI;

use faer::Mat;

use crate::contact::integrals::columns::Columns as Table;
use crate::contact::integrals::layout::Layout;
use crate::contact::integrals::products::product;
use crate::contact::integrals::tail::{Ends, Tail, Weights};
use crate::contact::intervals::columns::{Columns, Other};
use crate::contact::problem::modes::alternating;
use crate::kernel::Kernel;
use crate::numeric::bessel::{self, Wanted};

impl Columns<'_> {
    /// Adds what the kernel of a contact does, in units of its limit, to the columns as they are, of each interval to its own tests: beyond the
    /// wavenumbers of a layout, and what was taken out of the kernel there. `None` if that takes too many nodes.
    pub(super) fn add_short_waves(
        &self,
        matrix: &mut Mat<f64>,
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
            // the table: J of all orders, then ζ J_0 and ζ J_1 of singular pressures
            let (first, rows) = (taken.len(), taken.len() + tail.rows());
            let mut table = Table::zeros(rows, orders + 2);
            let real = &layout.zeta[..first];
            let arguments: Vec<f64> = real.iter().map(|zeta| zeta * half).collect();
            bessel::scaled_orders(orders, Wanted::ALL, &arguments, 1.0, rows, &mut table.values);
            tail.tabulate((half, 1.0), (Wanted::ALL, orders), (first, rows), &mut table.values);
            for order in 0..2 {
                let mut column = table.column(order).to_vec();
                column.iter_mut().zip(real).for_each(|(value, zeta)| *value *= zeta);
                tail.times_wavenumbers(&mut column[first..]);
                table.column_mut(orders + order).copy_from_slice(&column);
            }
            let products = product(table.part(0..orders), &weights, table.part(0..orders + 2));
            let factor = 4.0 / (PI * own.limit * interval.images() * half * half);
            let tests = (0..count).map(|m| (self.first(number) + m, interval.order(m)));
            let mean = self.place(Other::Mean(number)).map(|row| (row, 0));
            for (row, k) in tests.chain(mean) {
                let sign = alternating(k / 2);
                for (m, column) in (self.first(number)..).take(count).enumerate() {
                    let j = interval.order(m);
                    if (k + j).is_multiple_of(2) {
                        matrix[(row, column)] += factor * sign * alternating(j / 2) * products.column(j)[k];
                    }
                }
                let end = self.terms() + self.end(number);
                for (place, side) in interval.sides().iter().enumerate() {
                    let singular = match (k.is_multiple_of(2), interval.is_even()) {
                        (false, true) => 2.0 * products.column(orders)[k],
                        (false, false) => products.column(orders)[k],
                        (true, _) => -side * products.column(orders + 1)[k],
                    };
                    matrix[(row, end + place)] += 0.5 * half * factor * sign * singular;
                }
            }
        }
        Some(())
    }
}
