//! The contact problem: half-lengths and pressures of all contacts, for one punch and force on prepared kernels.
mod admissible;
mod basis;
mod galerkin;
mod layout;
mod newton;
mod punch;
mod start;

pub(crate) use newton::press;
