//! Errors of this crate.

/// Why a layer could not be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LayerError {
    /// A number outside its range.
    #[error("{field}: {reason}")]
    Field {
        /// The field's name as in the scene file.
        field: &'static str,
        /// What was found and what is allowed.
        #[source]
        reason: crate::quantity::OutOfRange,
    },
    /// A graded layer whose modulus varies by more than double precision can carry.
    #[error("beta * thickness is {found:?}; allowed is |beta * thickness| <= {limit:?}")]
    TooSteep {
        /// The product of the grading exponent and the thickness, dimensionless.
        found: f64,
        /// The largest magnitude allowed.
        limit: f64,
    },
    /// A graded layer whose modulus varies by more than double precision can carry.
    #[error("shear_modulus varies by a factor of {found:e}; allowed is {limit:e} or less")]
    VariesTooMuch {
        /// The largest modulus over the smallest, dimensionless.
        found: f64,
        /// The largest ratio allowed.
        limit: f64,
    },
    /// A text that is no name of a layer.
    #[error("found {found:?}, allowed is {allowed}")]
    Name {
        /// The text.
        found: Box<str>,
        /// What is allowed, in words.
        allowed: &'static str,
    },
    /// Two fields of which exactly one is to be given.
    #[error("found {found} of `{}` and `{}`; allowed is one of them", .fields[0], .fields[1])]
    EitherOr {
        /// How many of them: `none` or `both`.
        found: &'static str,
        /// Their names as in the scene file.
        fields: [&'static str; 2],
    },
    /// Rows that make no table.
    #[error(transparent)]
    Table(#[from] TableError),
    /// A table that does not reach the bottom of its layer.
    #[error("{field}: the table ends at depth {depth:?}; allowed is the thickness, {thickness:?}, or more")]
    TableEnds {
        /// The field's name as in the scene file.
        field: &'static str,
        /// The last depth of the table, in length.
        depth: f64,
        /// The thickness of the layer, in length.
        thickness: f64,
    },
    /// A table in parts of the thickness that does not reach the bottom of its layer.
    #[error("{field}: the table ends at {part:?} of the thickness; allowed is 1 or more")]
    RelativeTableEnds {
        /// The field's name as in the scene file.
        field: &'static str,
        /// The last depth of the table, in parts of the thickness.
        part: f64,
    },
    /// A Poisson's ratio too large for the Young's moduli.
    #[error("{field}: found {found:?}, allowed is -{limit:?} < {field} < {limit:?}")]
    Unstable {
        /// Which of them.
        field: &'static str,
        /// The ratio.
        found: f64,
        /// Its bound, the root of a ratio of Young's moduli.
        limit: f64,
    },
    /// An orthotropic material that would expand under pressure from all sides.
    #[error("these Poisson's ratios together make a material that expands under pressure; try smaller ones")]
    NegativeEnergy {
        /// The determinant of the compliances, scaled; it must not be negative.
        found: f64,
    },
}

/// Rows that make no table.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum TableError {
    /// Fewer than two rows.
    #[error("the table has {0} rows; allowed are two or more")]
    Rows(usize),
    /// The first row is not at the top face.
    #[error("the table begins at depth {0:?}; allowed is 0")]
    Begin(f64),
    /// A depth that is not below the one before.
    #[error("in the table depth {below:?} follows {above:?}; allowed are increasing depths")]
    Order {
        /// The depth before, in length.
        above: f64,
        /// The depth, in length.
        below: f64,
    },
}

impl LayerError {
    /// The number given for `field` is out of its range.
    pub fn field(field: &'static str, reason: crate::quantity::OutOfRange) -> Self {
        Self::Field { field, reason }
    }

    /// Checks the number given for `field`: what a constructor does with its arguments.
    ///
    /// # Errors
    /// [`LayerError::Field`] if it is out of its range.
    pub fn checked<Q: TryFrom<f64, Error = crate::quantity::OutOfRange>>(
        field: &'static str,
        value: f64,
    ) -> Result<Q, Self> {
        Q::try_from(value).map_err(|reason| Self::field(field, reason))
    }
}
