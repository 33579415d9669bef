//! Which wavenumbers a field is summed over: panels of Gauss points, and how far each depth has to go.
use crate::numeric::quadrature::{self, Rule};

/// How closely a field is summed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Precision {
    /// What is left out beyond the last wavenumber, in parts of the mean pressure: inside, and on a loaded face.
    pub(super) inside: f64,
    pub(super) on_face: f64,
    /// Exponentially small terms are left out beyond this exponent.
    pub(super) felt: f64,
    /// Points of a panel that spans a short phase.
    points: usize,
    /// The next panel is wider than its distance from 0 by this factor, at most.
    growth: f64,
    /// Whether displacements are wanted, too.
    pub(super) displacements: bool,
    /// A sum that would evaluate layers more often than this, all wavenumbers together, is refused.
    pub(super) evaluations: f64,
}

/// Each of the some forty sums of a search for the largest shear stress may take as many evaluations of layers, at 1 to 10 µs
/// each: all together a minute at the very worst. Three layers take some 2000; twice the limit is twice that minute.
const SEARCHED: f64 = 2e5;

/// All that there is.
pub(super) const FULL: Precision = Precision {
    inside: 1e-10,
    on_face: 1e-8,
    felt: 36.0,
    points: 16,
    growth: 2.0,
    displacements: true,
    evaluations: f64::INFINITY,
};
/// Stresses to some nine digits.
pub(super) const STRESSES: Precision = Precision {
    inside: 1e-9,
    on_face: 1e-8,
    felt: 24.0,
    points: 12,
    growth: 3.0,
    displacements: false,
    evaluations: SEARCHED,
};
/// Stresses to some four digits.
pub(super) const ROUGH: Precision = Precision {
    inside: 1e-5,
    on_face: 1e-5,
    felt: 14.0,
    points: 12,
    growth: 3.0,
    displacements: false,
    evaluations: SEARCHED,
};

/// Stresses to some two digits.
pub(super) const COARSE: Precision = Precision {
    inside: 1e-3,
    on_face: 1e-3,
    felt: 8.0,
    points: 8,
    growth: 3.0,
    displacements: false,
    evaluations: SEARCHED,
};

/// Phase that a panel may span, and up to which it needs half as many points or fewer.
const PHASE: f64 = 56.0;
const SHORT_PHASE: f64 = 16.0;
/// The first panel spans this phase.
const FIRST: f64 = 0.25;
/// Wavenumbers times reach beyond this are refused.
const MOST: f64 = 4e5;
/// The first panel is no shorter than this part of the whole axis: some hundred panels grow from there, and the integral
/// over less than that is below rounding.
const LEAST: f64 = 1e-40;

/// Next to λ = 0 a power λ^α is integrated in t, λ ~ t^STRETCH: any α > -0.95 leaves a positive power of t, and three
/// more powers of λ are still of the degree that [`STRETCHED`] points integrate exactly.
const STRETCH: i32 = 20;
const STRETCHED: usize = 32;

/// How fields begin at λ = 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Origin {
    /// A wavenumber below which they are smooth, besides a power of λ; infinite if there is none.
    pub(super) first: f64,
    /// Whether there may be such a power.
    pub(super) power: bool,
}

/// A panel of the wavenumber axis.
pub(super) struct Panel {
    pub(super) lo: f64,
    pub(super) hi: f64,
    rule: &'static Rule,
    /// Whether it begins at 0 with a power of λ.
    power: bool,
}

impl Panel {
    /// At how many wavenumbers.
    pub(super) fn count(&self) -> usize {
        self.rule.on(self.lo, self.hi).count()
    }

    /// Wavenumbers and weights.
    pub(super) fn points(&self) -> (Vec<f64>, Vec<f64>) {
        if !self.power {
            return self.rule.on(self.lo, self.hi).unzip();
        }
        let stretched = |(t, weight): (f64, f64)| {
            let before = self.hi * t.powi(STRETCH - 1);
            (before * t, f64::from(STRETCH) * before * weight)
        };
        self.rule.on(0.0, 1.0).map(stretched).unzip()
    }
}

/// The cut-off of a pressure.
#[derive(Clone, Copy, Debug)]
pub(super) struct Felt {
    /// The wavenumber beyond which it is not.
    pub(super) end: f64,
    /// The largest x at which a field is wanted, and the half-length of the pressure.
    pub(super) reach: f64,
}

/// Panels from 0 to the largest cut-off of all pressures, growing in width up to what cos λx and p̂ of those below their cut-off
/// allow; `None` if there would be too many.
///
/// The number of panels is bounded whatever the arguments: the first one is at least a fixed part of the whole, the next
/// ones grow by the factor `precision.growth` until each spans the phase that is allowed.
pub(super) fn panels(felt: &[Felt], origin: Origin, precision: &Precision) -> Option<Vec<Panel>> {
    let product = |felt: &Felt| felt.end * felt.reach;
    if felt.iter().any(|felt| felt.end.is_infinite() || product(felt).is_nan() || product(felt) > MOST) {
        return None;
    }
    let end = felt.iter().fold(0.0, |end: f64, felt| end.max(felt.end));
    let reach_at =
        |lo: f64| felt.iter().filter(|felt| felt.end > lo).fold(0.0, |reach: f64, felt| reach.max(felt.reach));
    let shortest = origin.first.min(FIRST / reach_at(0.0)).max(LEAST * end);
    let (mut panels, mut lo) = (Vec::new(), 0.0);
    while lo < end {
        let reach = reach_at(lo);
        let width = if lo == 0.0 { shortest } else { (precision.growth * lo).min(PHASE / reach) };
        let width = width.min(end - lo);
        let power = origin.power && lo == 0.0;
        let points = if power {
            STRETCHED
        } else if width * reach <= SHORT_PHASE {
            precision.points
        } else {
            32
        };
        panels.push(Panel { lo, hi: lo + width, rule: quadrature::rule(points), power });
        lo += width;
    }
    Some(panels)
}

/// The largest wavenumber at a reach, and the largest reach for a wavenumber.
pub(super) fn most(reach: f64) -> f64 {
    0.5 * MOST / reach
}
