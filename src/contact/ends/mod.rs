//! The ends of the contacts: Newton's method, iterated Galerkin sweeps, ends that nothing depends on.
pub(crate) mod broyden;
pub(crate) mod converged;
pub(crate) mod frozen;
pub(crate) mod newton;
pub(crate) mod sweeps;
