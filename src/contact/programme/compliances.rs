//! The kernels of neighbouring contacts, as the programme sees them.
use std::ops::Range;

use crate::kernel::Kernel;

/// p̂/P − 1 of a given pressure, at a wavenumber.
type TransformMinusOne<'a> = Box<dyn Fn(f64) -> f64 + 'a>;

/// The kernels of some contacts, one below the other. What presses on their laminates from the next contact, above or
/// below, is given.
pub(super) struct Compliances<'a> {
    kernel: &'a Kernel,
    contacts: Range<usize>,
    given: TransformMinusOne<'a>,
}

impl<'a> Compliances<'a> {
    /// Of all contacts.
    pub(super) fn all(kernel: &'a Kernel) -> Self {
        Self { kernel, contacts: 0..kernel.contacts(), given: Box::new(|_| 0.0) }
    }

    /// Of all contacts but that under the punch, with the pressure there.
    pub(super) fn below_first(kernel: &'a Kernel, first: impl Fn(f64) -> f64 + 'a) -> Self {
        Self { kernel, contacts: 1..kernel.contacts(), given: Box::new(first) }
    }

    /// How many contacts there are.
    pub(super) fn contacts(&self) -> usize {
        self.contacts.len()
    }

    /// Whether the first of them is the contact under the punch.
    pub(super) fn is_topmost(&self) -> bool {
        self.contacts.start == 0
    }

    /// What the kernel of contact i tends to for short waves.
    pub(super) fn limit(&self, i: usize) -> f64 {
        self.kernel.asymptote(self.contacts.start + i).limit
    }

    /// The kernel of contact i if its neighbours have the same pressure.
    pub(super) fn own(&self, i: usize, zeta: f64) -> f64 {
        self.limit(i) + self.kernel.remainder(self.contacts.start + i, zeta)
    }

    /// The coupling of contact i and one of which the pressure is given.
    pub(super) fn coupled(&self, i: usize, zeta: f64) -> f64 {
        let contact = self.contacts.start + i;
        let above = if i == 0 { contact.checked_sub(1) } else { None };
        let below = (contact + 1 == self.contacts.end && contact + 1 < self.kernel.contacts()).then_some(contact);
        above.into_iter().chain(below).map(|laminate| -self.kernel.coupling(laminate, zeta)).sum()
    }

    /// p̂/P − 1 of the pressure that is given.
    pub(super) fn given(&self, zeta: f64) -> f64 {
        (self.given)(zeta)
    }

    /// The coupling of contacts i and i + 1.
    pub(super) fn coupling(&self, i: usize, zeta: f64) -> f64 {
        -self.kernel.coupling(self.contacts.start + i, zeta)
    }
}
