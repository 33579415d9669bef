//! Where the components of kernels stand among the values at a wavenumber.

/// Which kernels they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Of contacts between laminates: pressures make gaps. Neighbours are coupled by the laminate between them.
    Contacts,
    /// Of openings between laminates that lie on each other, below one contact: see [`super::openings`]. All are coupled with all.
    Openings,
}

/// The order of the components: diagonals, responses under equal pressures, couplings, and the sum of all responses under equal pressures.
#[derive(Clone, Copy, Debug)]
pub(super) struct Components {
    pub(super) kind: Kind,
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
        match self.kind {
            Kind::Contacts => self.contacts - 1,
            Kind::Openings => self.contacts * (self.contacts - 1) / 2,
        }
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

    /// Whether the response of a contact is a part of the last component: of an opening that is a pressure.
    pub(super) fn is_squeezed(self, contact: usize) -> bool {
        contact == 0 || self.kind == Kind::Contacts
    }

    /// The power of ζ that makes a component finite at ζ = 0: long waves bend free laminates, λC ~ λ⁻³, or λC ~ λ⁻¹ under equal loads, but not laminates that lie on each other.
    pub(super) fn power(self, component: usize) -> i32 {
        match component / self.contacts {
            _ if self.contacts == 1 || self.kind == Kind::Openings || component == self.squeezed() => 0,
            1 => 1,
            _ => 3,
        }
    }

    /// The two that a coupling couples, the upper one first.
    pub(super) fn pair(self, pair: usize) -> [usize; 2] {
        match self.kind {
            Kind::Contacts => [pair, pair + 1],
            Kind::Openings => {
                let mut all = (0..self.contacts).flat_map(|i| (i + 1..self.contacts).map(move |j| [i, j]));
                all.nth(pair).unwrap_or_default()
            }
        }
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
        let all = self.neighbours(contact).filter(move |_| self.kind == Kind::Contacts);
        all.map(|(_, pair)| pair)
    }
}
