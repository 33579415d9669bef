//! The pressure between bodies that lie on each other while nothing comes apart and nothing else presses.
use std::f64::consts::PI;

use crate::numeric::waves::Waves;

/// The pressure between bodies that lie on each other, from weights and from dents that are pressed flat.
pub(crate) struct ClosedPressure<'a> {
    /// In units of μ₀P'.
    pub(crate) weight: f64,
    /// In stress over x in length, if there are dents; and the units L and μ₀P', and where x = 0 is.
    pub(crate) by_dents: Option<&'a Waves>,
    pub(crate) length: f64,
    pub(crate) unit: f64,
    pub(crate) origin: f64,
}

impl ClosedPressure<'_> {
    /// At a place, in units of L and of μ₀P'.
    pub(crate) fn at(&self, x: f64) -> f64 {
        self.weight + self.by_dents.map_or(0.0, |waves| waves.at((x + self.origin) * self.length)[0] / self.unit)
    }

    /// −∫ p cos kφ dφ over an interval, for ascending k from 0 on.
    pub(crate) fn tests(&self, middle: f64, half: f64, orders: &[usize]) -> Vec<f64> {
        let highest = orders.last().copied().unwrap_or(0);
        // a pressure that is the same everywhere has a mean and no other term; one by dents is as smooth as these are
        let places = if self.by_dents.is_some() { 4 * highest + 64 } else { 1 };
        let angle = |q: usize| PI * (q as f64 + 0.5) / places as f64;
        let pressures: Vec<f64> = (0..places).map(|q| self.at(middle + half * angle(q).cos())).collect();
        let test = |k: usize| {
            let terms = pressures.iter().enumerate().map(|(q, pressure)| pressure * (k as f64 * angle(q)).cos());
            -PI / places as f64 * terms.sum::<f64>()
        };
        orders.iter().map(|k| if *k == 0 || places > 1 { test(*k) } else { 0.0 }).collect()
    }
}
