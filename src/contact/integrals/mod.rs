//! Integrals over the wavenumber of kernels times the transforms of pressures and tests.
pub(crate) mod layout;
pub(crate) mod products;
pub(crate) mod samples;
pub(crate) mod tail;
