//! The linear system of the contact equations, and the solutions of it with all unknown terms or with some of them.
use faer::linalg::solvers::{Llt, PartialPivLu, Solve};
use faer::{Mat, Side};

/// [A E; B D] [x; q] = [f; b].
pub(super) struct System {
    pub(super) a: Mat<f64>,
    pub(super) e: Mat<f64>,
    pub(super) b: Mat<f64>,
    pub(super) d: Mat<f64>,
    pub(super) right: Rows,
    /// Whether A is: pressures and openings do the opposite to each other.
    pub(super) is_symmetric: bool,
}

/// What stands in the rows of the unknown terms, and in the other rows.
#[derive(Clone)]
pub(super) struct Rows {
    pub(super) terms: Vec<f64>,
    pub(super) left: Vec<f64>,
}

/// The unknown terms; intensities, then moments, then angles.
#[derive(Clone)]
pub(super) struct Unknowns {
    pub(super) x: Vec<f64>,
    pub(super) q: Vec<f64>,
}

impl Rows {
    pub(super) fn zeros(terms: usize, left: usize) -> Self {
        Self { terms: vec![0.0; terms], left: vec![0.0; left] }
    }

    /// The rows of some of the unknown terms, and all others.
    pub(super) fn part(&self, kept: &[usize]) -> Self {
        Self { terms: kept.iter().map(|place| self.terms[*place]).collect(), left: self.left.clone() }
    }
}

impl System {
    /// The rows and columns of some of the unknown terms.
    pub(super) fn part(&self, kept: &[usize]) -> Self {
        let (size, border) = (kept.len(), self.d.nrows());
        Self {
            a: Mat::from_fn(size, size, |row, column| self.a[(kept[row], kept[column])]),
            e: Mat::from_fn(size, border, |row, column| self.e[(kept[row], column)]),
            b: Mat::from_fn(border, size, |row, column| self.b[(row, kept[column])]),
            d: self.d.clone(),
            right: self.right.part(kept),
            is_symmetric: self.is_symmetric,
        }
    }

    /// `None` if it cannot be factorised in double precision.
    pub(super) fn factorised(&self) -> Option<Factors> {
        let terms = match self.is_symmetric {
            true => TermFactors::Symmetric(self.a.llt(Side::Lower).ok()?),
            false => TermFactors::Other(self.a.partial_piv_lu()),
        };
        let by_border = terms.solve(&self.e);
        let reduced = (&self.d - &self.b * &by_border).partial_piv_lu();
        Some(Factors { terms, by_border, reduced, b: self.b.clone() })
    }
}

/// The factors of A.
enum TermFactors {
    Symmetric(Llt<f64>),
    Other(PartialPivLu<f64>),
}

impl TermFactors {
    fn solve(&self, right: &Mat<f64>) -> Mat<f64> {
        match self {
            Self::Symmetric(factors) => factors.solve(right),
            Self::Other(factors) => factors.solve(right),
        }
    }
}

/// The factors of a system.
pub(super) struct Factors {
    terms: TermFactors,
    /// A⁻¹E.
    by_border: Mat<f64>,
    /// The factors of D − BA⁻¹E.
    reduced: PartialPivLu<f64>,
    b: Mat<f64>,
}

impl Factors {
    /// x and q for right-hand sides; `None` if there are none in double precision.
    pub(super) fn solve(&self, Rows { terms, left }: &Rows) -> Option<Unknowns> {
        let column = |values: &[f64]| Mat::from_fn(values.len(), 1, |row, _| values[row]);
        let regular = self.terms.solve(&column(terms));
        let q = self.reduced.solve(column(left) - &self.b * &regular);
        let x = regular - &self.by_border * &q;
        let [x, q] = [x, q].map(|column| column.col_as_slice(0).to_vec());
        x.iter().chain(&q).all(|value| value.is_finite()).then_some(Unknowns { x, q })
    }
}
