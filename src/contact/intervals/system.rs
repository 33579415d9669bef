//! The linear system of the contact equations, and the solutions of it with all unknown terms or with some of them.
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// [A E; B D] [x; q] = [f; b].
pub(super) struct System {
    pub(super) a: Mat<f64>,
    pub(super) e: Mat<f64>,
    pub(super) b: Mat<f64>,
    pub(super) d: Mat<f64>,
    pub(super) f: Vec<f64>,
    pub(super) left: Vec<f64>,
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
            f: kept.iter().map(|place| self.f[*place]).collect(),
            left: self.left.clone(),
        }
    }

    /// x and q; `None` if there are none in double precision.
    pub(super) fn solve(&self) -> Option<(Vec<f64>, Vec<f64>)> {
        let Self { a, e, b, d, f, left } = self;
        let (size, border) = (a.nrows(), e.ncols());
        let llt = a.llt(Side::Lower).ok()?;
        let right =
            Mat::from_fn(size, border + 1, |row, column| if column < border { e[(row, column)] } else { f[row] });
        let solved = llt.solve(&right);
        let (by_border, regular) = (solved.subcols(0, border), solved.subcols(border, 1));
        let reduced = d - b * by_border;
        let residual = b * regular;
        let residual = Mat::from_fn(border, 1, |row, _| left[row] - residual[(row, 0)]);
        let q = reduced.partial_piv_lu().solve(&residual);
        let x = regular - by_border * &q;
        let [x, q] = [x, q].map(|column| column.col_as_slice(0).to_vec());
        x.iter().chain(&q).all(|value| value.is_finite()).then_some((x, q))
    }
}
