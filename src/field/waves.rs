//! The wavenumbers over which a field is summed: panels of Gauss points, up to the cut-offs of the pressures.
use crate::numeric::quadrature::{self, Rule};

/// The accuracy to which a field is summed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Precision {
    /// Truncation error allowed beyond the last wavenumber, in parts of the mean pressure: inside, and on a loaded face.
    pub(super) inside: f64,
    pub(super) on_face: f64,
    /// Exponentially small terms are left out beyond this exponent.
    pub(super) exponent: f64,
    /// Points of a panel that spans a short phase.
    pub(super) points: usize,
    /// Largest ratio of the width of a panel to its distance from 0.
    pub(super) growth: f64,
    /// Whether displacements are wanted, too.
    pub(super) displacements: bool,
    /// Most evaluations of layers, all wavenumbers together: a sum that needs more is rejected.
    pub(super) evaluations: f64,
}

/// Each of the some forty sums of a search for the largest shear stress may take as many evaluations of layers, at 1 to 10 µs
/// each: all together a minute at the very worst. Three layers take some 2000; twice the limit is twice that minute.
const SEARCHED: f64 = 2e5;

/// Full accuracy.
pub(super) const FULL: Precision = Precision {
    inside: 1e-10,
    on_face: 1e-8,
    exponent: 36.0,
    points: 16,
    growth: 2.0,
    displacements: true,
    evaluations: f64::INFINITY,
};
/// Stresses to some nine digits.
pub(super) const STRESSES: Precision = Precision {
    inside: 1e-9,
    on_face: 1e-8,
    exponent: 24.0,
    points: 12,
    growth: 3.0,
    displacements: false,
    evaluations: SEARCHED,
};
/// Stresses to some four digits.
pub(super) const LOW: Precision = Precision {
    inside: 1e-5,
    on_face: 1e-5,
    exponent: 14.0,
    points: 12,
    growth: 3.0,
    displacements: false,
    evaluations: SEARCHED,
};

/// Stresses to some two digits.
pub(super) const COARSE: Precision = Precision {
    inside: 1e-3,
    on_face: 1e-3,
    exponent: 8.0,
    points: 8,
    growth: 3.0,
    displacements: false,
    evaluations: SEARCHED,
};

/// Largest phase of a panel, and the phase up to which half as many points or fewer suffice.
const PHASE: f64 = 56.0;
const SHORT_PHASE: f64 = 16.0;
/// The first panel spans this phase.
const FIRST: f64 = 0.25;
/// Largest product of a wavenumber and the distance over which it oscillates; larger ones are rejected.
const MOST: f64 = 4e5;
/// The first panel is no shorter than this part of the whole axis: some hundred panels grow from there, and the integral
/// over less than that is below rounding.
const LEAST: f64 = 1e-40;

/// Next to λ = 0 a power λ^α is integrated in t, λ ~ t^STRETCH: any α > -0.95 leaves a positive power of t, and three
/// more powers of λ are still of the degree that [`STRETCHED`] points integrate exactly.
const STRETCH: i32 = 20;
const STRETCHED: usize = 32;

/// The behaviour of fields at λ = 0.
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
    /// Number of its wavenumbers.
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
pub(super) struct CutOff {
    /// The wavenumber beyond which the pressure is left out.
    pub(super) end: f64,
    /// The largest x at which a field is requested plus the half-length of the pressure: over it the integrand oscillates.
    pub(super) extent: f64,
}

/// Panels from 0 to the largest cut-off of all pressures. Their width grows as far as the oscillation of cos λx and of the transforms of
/// pressures below their cut-off allows; `None` if there would be too many.
///
/// The number of panels is bounded whatever the arguments: the first one is at least a fixed part of the whole, the next
/// ones grow by the factor `precision.growth` until each spans the phase that is allowed.
pub(super) fn panels(cut_offs: &[CutOff], origin: Origin, precision: &Precision) -> Option<Vec<Panel>> {
    let product = |cut: &CutOff| cut.end * cut.extent;
    if cut_offs.iter().any(|cut| cut.end.is_infinite() || product(cut).is_nan() || product(cut) > MOST) {
        return None;
    }
    let end = cut_offs.iter().fold(0.0, |end: f64, cut| end.max(cut.end));
    let extent_at =
        |lo: f64| cut_offs.iter().filter(|cut| cut.end > lo).fold(0.0, |extent: f64, cut| extent.max(cut.extent));
    let shortest = origin.first.min(FIRST / extent_at(0.0)).max(LEAST * end);
    let (mut panels, mut lo) = (Vec::new(), 0.0);
    while lo < end {
        let extent = extent_at(lo);
        let width = if lo == 0.0 { shortest } else { (precision.growth * lo).min(PHASE / extent) };
        let width = width.min(end - lo);
        let power = origin.power && lo == 0.0;
        let points = if power {
            STRETCHED
        } else if width * extent <= SHORT_PHASE {
            precision.points
        } else {
            32
        };
        panels.push(Panel { lo, hi: lo + width, rule: quadrature::rule(points), power });
        lo += width;
    }
    Some(panels)
}

/// The largest wavenumber for an extent, and the largest extent for a wavenumber.
pub(super) fn most(extent: f64) -> f64 {
    0.5 * MOST / extent
}
