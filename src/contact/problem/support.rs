//! Where the contacts are: half-lengths, and what is known of their ends.

/// What the end of a contact is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum End {
    /// The pressure falls to zero there, and Newton's method moves it.
    Free,
    /// The corner of a punch, where the pressure is singular: the intensity of the singularity, 1 on a half-plane, is the
    /// unknown in place of the half-length.
    Edge { intensity: f64 },
    /// The pressure decays before an end is found, and nothing depends on it: it stays where it is.
    Frozen(Decay),
    /// Of a given pressure.
    Given,
}

/// How the pressure decays towards a frozen end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Decay {
    /// What may depend on the end, relative.
    pub(crate) sensitivity: f64,
    /// The length over which the pressure falls to a third, over the half-length.
    pub(crate) length: f64,
}

/// Where the contacts are, one interval about x = 0 each, from the top down.
#[derive(Clone, Debug)]
pub(crate) struct Support {
    /// In units of L.
    pub(crate) half_lengths: Vec<f64>,
    pub(crate) ends: Vec<End>,
}

impl Support {
    /// Takes a step: in the logarithms of the half-lengths, and in the intensities of edges.
    pub(crate) fn advance(&mut self, step: &[f64]) {
        step.iter().enumerate().for_each(|(i, step)| self.advance_one(i, *step));
    }

    /// Takes the step of contact i.
    pub(crate) fn advance_one(&mut self, i: usize, step: f64) {
        match &mut self.ends[i] {
            End::Edge { intensity } => *intensity += step,
            _ => self.half_lengths[i] *= step.exp(),
        }
    }

    /// The longest of the steps in the logarithms of the half-lengths; all is linear in the intensities of edges.
    pub(crate) fn longest(&self, step: &[f64]) -> f64 {
        let lengths = step.iter().zip(&self.ends).filter(|(_, end)| !matches!(end, End::Edge { .. }));
        longest(lengths.map(|(step, _)| *step))
    }

    /// Which ends have an unknown.
    pub(crate) fn free(&self) -> impl Iterator<Item = usize> {
        let free = |end: &End| matches!(end, End::Free | End::Edge { .. });
        (0..self.ends.len()).filter(move |i| free(&self.ends[*i]))
    }

    /// The intensity of the edge singularity of contact i, if it has one.
    pub(crate) fn intensity(&self, i: usize) -> Option<f64> {
        if let End::Edge { intensity } = self.ends[i] { Some(intensity) } else { None }
    }

    /// How the pressure of contact i decays, if its end is frozen.
    pub(crate) fn decay(&self, i: usize) -> Option<Decay> {
        if let End::Frozen(decay) = self.ends[i] { Some(decay) } else { None }
    }
}

/// The largest absolute value; a step that is no number leads nowhere, and is longer than any.
pub(crate) fn longest(step: impl IntoIterator<Item = f64>) -> f64 {
    step.into_iter().fold(0.0, |longest: f64, step| if step.is_nan() { f64::INFINITY } else { longest.max(step.abs()) })
}

/// How far out, in units of L, gaps are looked at.
pub(crate) fn span(half_lengths: &[f64]) -> f64 {
    2.0 * longest(half_lengths.iter().copied()) + 2.0
}
