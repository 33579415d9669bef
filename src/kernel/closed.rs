//! The compliance of a stack whose contacts are all closed, and of its parts: what formulas estimate contacts from.
use crate::system::FreeChain;

use super::Kernel;

/// Waves as long as this, or longer, see a laminate as a beam.
const LONG: f64 = 1e-4;
/// The compliance that longer waves meet is known otherwise to this part of itself. Without it the starting points of contacts of more than
/// 1e4 thicknesses differ in their last digits.
const ABOUT: f64 = 0.01;

impl Kernel {
    /// The compliance λμ₀C of the whole stack at its top face, at one wavenumber, as if no interface opened.
    ///
    /// What interpolation leaves of a laminate is rounding over a power of ζ where waves are very long. There the stack is no softer than its base
    /// and the compression of its layers, and no stiffer than the base below all the laminates as beams.
    pub(crate) fn closed(&self, zeta: f64) -> f64 {
        let compliance = self.compliances(zeta)[0];
        let base = if zeta < LONG { self.chains.base.flexibility(&self.chains.wave(zeta)) } else { None };
        let Some(base) = base else { return compliance };
        let laminates = self.laminates();
        let beams: f64 = laminates.iter().map(|(_, bending)| bending * zeta.powi(3)).sum();
        // equal pressures squeeze a laminate by the same displacement in all long waves
        let squeezed: f64 = (0..laminates.len()).map(|laminate| self.compression(laminate, LONG) * zeta / LONG).sum();
        let stiffest = (1.0 - ABOUT) * (self.punch + base / (1.0 + beams * base));
        let softest = (1.0 + ABOUT) * (self.punch + base + squeezed);
        // what is no number is bounded, too
        compliance.max(stiffest).min(softest)
    }

    /// For each contact the compliance λμ₀C of all bodies below it and of the laminate above it, at one wavenumber, as
    /// if the interfaces further down slid without opening: the equal-pressure responses of two neighbouring contacts, the response of the lower one
    /// in series with the bending of the laminate between them.
    pub(crate) fn compliances(&self, zeta: f64) -> Vec<f64> {
        let at = self.at(zeta);
        let mut compliances: Vec<f64> =
            (0..self.contacts()).map(|i| self.asymptotes[i].limit + self.remainder_at(i, zeta, at.as_ref())).collect();
        for i in (0..self.contacts() - 1).rev() {
            let bending = -at.as_ref().map_or(0.0, |at| at.coupling(i));
            let below = compliances[i + 1];
            // springs in series; below a laminate that bends when it is compressed the compliance may be negative, as long as the laminate
            // bends more easily
            compliances[i] +=
                if bending > 0.0 && bending + below > 0.0 { bending / (bending + below) * below } else { 0.0 };
        }
        compliances
    }

    /// Compliance λμ₀C of the lower face of a laminate under equal pressures on both faces, at one wavenumber.
    pub(crate) fn equal_pressure_bottom(&self, laminate: usize, zeta: f64) -> f64 {
        self.chains.laminates[laminate].flexibility(&self.chains.wave(zeta)).map_or(0.0, |c| -c.equal_bottom)
    }

    /// Compliance λμ₀C of the thickness of a laminate under equal pressures on both faces, at one wavenumber.
    pub(crate) fn compression(&self, laminate: usize, zeta: f64) -> f64 {
        let flexibility = self.chains.laminates[laminate].flexibility(&self.chains.wave(zeta));
        flexibility.map_or(0.0, |c| (c.equal_top - c.equal_bottom).abs())
    }

    /// Thickness in units of L and bending stiffness in units of μ₀L³ of the laminates, top down.
    pub(crate) fn laminates(&self) -> Vec<(f64, f64)> {
        // λμ₀C = μ₀L³/(D ζ³)
        let at = self.at(LONG);
        let thickness = |chain: &FreeChain| {
            chain.layers().iter().map(|layer| layer.thickness().unwrap_or(0.0)).sum::<f64>() / self.chains.length
        };
        let bending = |i: usize| -(at.as_ref().map_or(0.0, |at| at.coupling(i)) * LONG.powi(3)).recip();
        self.chains.laminates.iter().enumerate().map(|(i, chain)| (thickness(chain), bending(i))).collect()
    }
}

#[cfg(test)]
mod tests {
    use recede_layers::{HalfPlane, Homogeneous, Plane, PowerHalfPlane};

    use super::*;
    use crate::stack::Stack;

    #[test]
    fn waves_of_any_length_meet_no_less_than_the_base_nor_more() {
        let strip = |modulus: f64| Homogeneous::new(0.7, modulus, 0.3).unwrap();
        let stack = || Stack::builder(Plane::Strain).layer(strip(1.0));
        let graded = || PowerHalfPlane::new(5.0, 0.3, 1.2, 0.2).unwrap();
        for (stack, softest) in [
            (stack().receding().layer(HalfPlane::new(0.01, 0.3).unwrap()), 1.0),
            (stack().receding().layer(graded()), 1.0),
            (stack().bonded().layer(strip(30.0)).receding().layer(graded()), 1.0),
            (stack().receding().layer(strip(1e-3)).receding().layer(graded()), 1e-3),
        ] {
            let kernel = Kernel::new(&stack.build().unwrap()).unwrap();
            for power in 5..250 {
                let zeta = 10f64.powi(-power);
                let (closed, base) =
                    (kernel.closed(zeta), kernel.chains.base.flexibility(&kernel.chains.wave(zeta)).unwrap());
                // strips of unit thickness in all are compressed by less than if all were of the softest material
                let most = base + zeta / softest;
                assert!(0.98 * base < closed && closed < 1.02 * most, "{power}: {closed:e} {base:e} {most:e}");
            }
        }
    }
}
