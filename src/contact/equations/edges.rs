//! What a punch with sharp corners adds to the equations: a pressure that is singular there, with an amplitude q to be
//! found in place of the half-length, which is known.
use crate::contact::equations::assemble::{Equations, Rows};
use crate::numeric::buffer::Buffer;

impl Equations<'_> {
    /// The same under a punch with sharp corners, where the pressure is singular with the amplitude q: 1 on a half-plane.
    pub(crate) fn with_corners(mut self, amplitude: Option<f64>) -> Self {
        self.corners = amplitude.map(|amplitude| (amplitude, self.bases[0].corners()));
        self
    }

    /// q; 0 without corners.
    pub(crate) fn amplitude(&self) -> f64 {
        self.corners.as_ref().map_or(0.0, |(amplitude, _)| *amplitude)
    }

    /// What so many rows of each contact change by with q; nothing without corners.
    pub(crate) fn corner_rows(&self, counts: &[usize]) -> Option<Vec<Rows>> {
        let (_, corners) = self.corners.as_ref()?;
        let mut rows: Vec<Rows> = counts.iter().map(|count| Buffer::zeros(*count)).collect();
        let mut response = self.layout.own[0].unit.over(self.bases[0].rows(), corners);
        if let Some(coupling) = self.layout.coupling.first() {
            coupling.add_times(1.0, corners, &mut response);
            let mut below = coupling.over(self.bases[1].rows(), corners);
            below.iter_mut().for_each(|value| *value = -*value);
            rows[1] = self.bases[1].test(&below, counts[1]);
        }
        rows[0] = self.bases[0].test(&response, counts[0]);
        rows[0][0] += self.half_plane_row(0, 0, 1.0);
        Some(rows)
    }

    /// What g∞ makes of corners with the amplitude q in row m of contact i.
    fn half_plane_row(&self, i: usize, m: usize, amplitude: f64) -> f64 {
        if i == 0 && m == 0 { -amplitude * self.cauchy(0, 0) } else { 0.0 }
    }

    /// What g∞ makes of the modes in row m of contact i.
    pub(crate) fn own_row(&self, i: usize, m: usize, y: f64) -> f64 {
        self.cauchy(i, m) * y + self.half_plane_row(i, m, self.amplitude())
    }
}
