//! A stack made ready to be pressed: kernels computed once, used for any punch and load.
