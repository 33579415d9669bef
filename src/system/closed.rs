//! Laminates that lie on each other and on a base: what pressures on top and gaps between them do to the pressures between them.
//!
//! Written with the responses e_i of contacts under equal pressures of their neighbours and the bending compliances w_i of laminates, the equations of the pressures p_i are the ones of a
//! chain of conductances, e_i p_i + w_(i−1) (p_i − p_(i−1)) + w_i (p_i − p_(i+1)) = s_i, where s_i is the slope of a gap. Conductances in series and in parallel need no differences.

/// The contacts from the top down, the one on top with the number 0, at one wavenumber.
#[derive(Clone, Debug)]
pub(crate) struct ClosedContacts {
    /// Conductances from each contact downwards, and from each one below the first upwards to a top without pressure.
    down: Vec<f64>,
    up: Vec<f64>,
    bending: Vec<f64>,
}

impl ClosedContacts {
    /// From responses under equal pressures, one for each contact, and bending compliances, one for each laminate.
    pub(crate) fn new(equal: &[f64], bending: &[f64]) -> Self {
        let (mut down, mut up) = (equal.to_vec(), equal.to_vec());
        for i in (0..bending.len()).rev() {
            down[i] += in_series(bending[i], down[i + 1]);
        }
        for i in 1..equal.len() {
            up[i] += if i == 1 { bending[0] } else { in_series(bending[i - 1], up[i - 1]) };
        }
        Self { down, up, bending: bending.to_vec() }
    }

    /// The slope on top that a unit pressure there makes.
    pub(crate) fn compliance(&self) -> f64 {
        self.down[0]
    }

    /// The part of a pressure on top that contact i carries.
    pub(crate) fn carried(&self, i: usize) -> f64 {
        (0..i).map(|laminate| self.passed(laminate)).product()
    }

    /// The part that it does not carry.
    pub(crate) fn lost(&self, i: usize) -> f64 {
        let mut carried = 1.0;
        let of = |laminate: usize| {
            let lost = carried * part(self.down[laminate + 1], self.bending[laminate]);
            carried *= self.passed(laminate);
            lost
        };
        (0..i).map(of).sum()
    }

    /// The pressure on contact j that a unit slope of the gap at contact i makes, which is the pressure on i that one at j makes; i, j > 0.
    pub(crate) fn pressure(&self, i: usize, j: usize) -> f64 {
        let (first, last) = (i.min(j), i.max(j));
        let below = self.bending.get(first).map_or(0.0, |bending| in_series(*bending, self.down[first + 1]));
        let own = (self.up[first] + below).recip();
        own * (first..last).map(|laminate| self.passed(laminate)).product::<f64>()
    }

    /// The part of a pressure that passes a laminate.
    fn passed(&self, laminate: usize) -> f64 {
        part(self.bending[laminate], self.down[laminate + 1])
    }
}

/// Two conductances in series.
fn in_series(a: f64, b: f64) -> f64 {
    a * part(b, a)
}

/// a/(a + b), 0 where nothing conducts.
fn part(a: f64, b: f64) -> f64 {
    if a == 0.0 { 0.0 } else { a / (a + b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pressures_solve_the_equations_of_the_chain() {
        let (equal, bending) = ([0.7, 0.2, 1.3, 0.4], [5.0, 0.3, 20.0]);
        let closed = ClosedContacts::new(&equal, &bending);
        let residual = |p: [f64; 4], i: usize| {
            let above = if i > 0 { bending[i - 1] * (p[i] - p[i - 1]) } else { 0.0 };
            equal[i] * p[i] + above + if i < 3 { bending[i] * (p[i] - p[i + 1]) } else { 0.0 }
        };
        let under_pressure: [f64; 4] = std::array::from_fn(|i| closed.carried(i));
        assert!((residual(under_pressure, 0) - closed.compliance()).abs() < 1e-14);
        assert!((1..4).all(|i| residual(under_pressure, i).abs() < 1e-14));
        assert!((0..4).all(|i| (closed.carried(i) + closed.lost(i) - 1.0).abs() < 1e-15));
        for gap in 1..4 {
            let mut p = [0.0; 4];
            (1..4).for_each(|i| p[i] = closed.pressure(i, gap));
            let expected = |i: usize| if i == gap { 1.0 } else { 0.0 };
            assert!((1..4).all(|i| (residual(p, i) - expected(i)).abs() < 1e-14), "{gap}");
            // what a gap does to the top is what the top does to the gap, with the other sign
            assert!((residual(p, 0) + closed.carried(gap)).abs() < 1e-14);
        }
    }
}
