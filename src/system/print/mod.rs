//! The block matrix as it is shown: as text and in LaTeX.
mod latex;
mod text;
