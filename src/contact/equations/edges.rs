//! The edge singularity at the sharp corners of a punch: its intensity q is the unknown of a contact whose half-length is
//! known.
use crate::contact::equations::assemble::{Equations, Rows};

impl Equations<'_> {
    /// Adds the edge singularity of contact i to a pressure.
    pub(super) fn add_edge(&self, i: usize, pressure: &mut [f64]) {
        if let Some(edge) = &self.edges[i] {
            pressure.iter_mut().zip(edge.rows.iter()).for_each(|(sum, row)| *sum += edge.intensity * row);
        }
    }

    /// Derivatives of the first `counts` rows of each contact with respect to the intensity of contact i; `None` if it has no edge
    /// singularity.
    pub(super) fn edge_rows(&self, i: usize, counts: &[usize]) -> Option<Vec<Rows>> {
        let edge = self.edges[i].as_ref()?;
        let mut rows: Vec<Rows> = counts.iter().map(|count| vec![0.0; *count]).collect();
        let response = self.spread(i, &edge.rows, &mut rows);
        rows[i] = self.bases[i].test(&response, counts[i]);
        rows[i][0] += self.half_plane_row(i, 0, 1.0);
        Some(rows)
    }

    /// What all edge singularities add to the first `counts` rows of each contact, in the order of the matrix.
    pub(super) fn edge_load(&self, counts: &[usize]) -> Vec<f64> {
        let mut load = vec![0.0; self.size()];
        for (i, edge) in self.edges.iter().enumerate() {
            if let (Some(edge), Some(rows)) = (edge, self.edge_rows(i, counts)) {
                self.add_rows(edge.intensity, &rows, &mut load);
            }
        }
        load
    }

    /// What g∞ makes of an edge singularity in row m of contact i.
    fn half_plane_row(&self, i: usize, m: usize, intensity: f64) -> f64 {
        if m == 0 { -intensity * self.cauchy(i, 0) } else { 0.0 }
    }

    /// What g∞ makes of the pressure in row m of contact i.
    pub(crate) fn own_row(&self, i: usize, m: usize, y: f64) -> f64 {
        let edge = self.edges[i].as_ref().map_or(0.0, |edge| self.half_plane_row(i, m, edge.intensity));
        self.cauchy(i, m) * y + edge
    }
}
