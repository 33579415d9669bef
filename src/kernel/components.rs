//! Where the components of kernels stand among the values at a wavenumber.

/// The order of the components: diagonals, responses under equal pressures, couplings, and the sum of the responses of contacts under equal pressures.
///
/// In contacts between laminates pressures make gaps, and neighbours are coupled by the laminate between them. Openings between laminates that lie on each other below these, see
/// [`super::openings`], are coupled with all of their kind and with the lowest contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Components {
    /// The lowest contact.
    pub(super) lowest: usize,
    /// Contacts, and openings below each other.
    pub(super) contacts: usize,
}

impl Components {
    /// How many there are.
    pub(super) fn count(self) -> usize {
        2 * self.contacts + self.pairs() + 1
    }

    /// How many couplings there are.
    pub(super) fn pairs(self) -> usize {
        let openings = self.contacts - 1 - self.lowest;
        self.lowest + openings * (openings + 1) / 2
    }

    /// The response of contact i under equal pressures; of openings the diagonal again, since these have no pressures in common.
    pub(super) fn equal(self, i: usize) -> usize {
        self.contacts + i
    }

    pub(super) fn coupling(self, pair: usize) -> usize {
        2 * self.contacts + pair
    }

    pub(super) fn squeezed(self) -> usize {
        2 * self.contacts + self.pairs()
    }

    /// Whether it is an opening, where slopes of the gap make pressures.
    pub(super) fn is_opening(self, contact: usize) -> bool {
        contact > self.lowest
    }

    /// The power of ζ that makes a component finite at ζ = 0: long waves bend free laminates, λC ~ λ⁻³, or λC ~ λ⁻¹ under equal loads, but not laminates that lie on each other.
    pub(super) fn power(self, component: usize) -> i32 {
        let is_bent = |contact: usize| self.lowest > 0 && !self.is_opening(contact);
        match component / self.contacts {
            _ if component == self.squeezed() => 0,
            0 if is_bent(component) => 3,
            1 if is_bent(component - self.contacts) => 1,
            0 | 1 => 0,
            _ if component - self.coupling(0) < self.lowest => 3,
            _ => 0,
        }
    }

    /// The two that a coupling couples, the upper one first.
    pub(super) fn pair(self, pair: usize) -> [usize; 2] {
        let Some(among_openings) = pair.checked_sub(self.lowest) else { return [pair, pair + 1] };
        let mut all = (self.lowest..self.contacts).flat_map(|i| (i + 1..self.contacts).map(move |j| [i, j]));
        all.nth(among_openings).unwrap_or_default()
    }

    /// What a contact is coupled with, with the number of the coupling.
    pub(super) fn neighbours(self, contact: usize) -> impl Iterator<Item = (usize, usize)> + use<> {
        let own = move |pair: usize| {
            let [above, below] = self.pair(pair);
            if above == contact { Some((below, pair)) } else { (below == contact).then_some((above, pair)) }
        };
        (0..self.pairs()).filter_map(own)
    }

    /// The couplings that are parts of the response of a contact under equal pressures.
    pub(super) fn shared(self, contact: usize) -> impl Iterator<Item = usize> + use<> {
        self.neighbours(contact).map(|(_, pair)| pair).filter(move |pair| *pair < self.lowest)
    }
}

/// What is sampled at a wavenumber.
pub(super) struct Sample {
    /// Diagonals, equal-pressure responses, couplings, and the sum of all equal-pressure responses.
    pub(super) components: Vec<f64>,
    /// Whether equal pressures bend a laminate, at this wavenumber or another one since [`Sample::new`]: its equal-pressure response is then
    /// no more accurate than the rounding error of its bending response.
    pub(super) bent: Vec<bool>,
    /// Below the lowest contact, the largest bending response of a laminate that equal pressures bend, over 1 + ζ²: the compliance there has its rounding error.
    pub(super) cancelled: f64,
    /// The responses of the lowest contact and of openings under equal pressures, as far as they are due to what is below that contact, and the bending responses of the laminates there.
    pub(super) closed: [Vec<f64>; 2],
}

impl Sample {
    pub(super) fn new(order: Components) -> Self {
        let (components, bent) = (vec![0.0; order.count()], vec![false; order.contacts - 1]);
        Self { components, bent, cancelled: 0.0, closed: Default::default() }
    }
}
