//! A part of the rows of a sweep, so that many machines can share it.
use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// One of several contiguous parts into which rows are divided.
///
/// Parts of the same sweep differ in length by one row at most, and together they are all rows once. Where there are more
/// parts than rows, some are empty.
///
/// ```
/// use recede::Part;
/// let part: Part = "2/3".parse()?;
/// assert_eq!((part.rows(9), part.rows(10)), (3..6, 3..6));
/// assert_eq!(part.to_string(), "2/3");
/// let all: Vec<usize> = (1..=3).flat_map(|number| Part::new(number, 3).unwrap().rows(10)).collect();
/// assert!(all.into_iter().eq(0..10));
/// let error = "4/3".parse::<Part>().unwrap_err();
/// assert_eq!(error.to_string(), "`4/3`: found part 4 of 3, allowed are parts 1 to 3");
/// # Ok::<(), recede::PartError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Part {
    number: usize,
    of: usize,
}

/// Why something is no part of a sweep.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{part}`: {reason}")]
pub struct PartError {
    /// The part as written.
    pub part: String,
    /// What was found, and what is allowed.
    pub reason: String,
}

impl Part {
    /// Part `number`, counted from 1, of `of` parts.
    ///
    /// # Errors
    /// [`PartError`] if `of` is 0, or `number` is not from 1 to `of`.
    pub fn new(number: usize, of: usize) -> Result<Self, PartError> {
        let failed = |reason: String| PartError { part: format!("{number}/{of}"), reason };
        if of == 0 {
            return Err(failed("found 0 parts, allowed are 1 or more".into()));
        }
        if !(1..=of).contains(&number) {
            return Err(failed(format!("found part {number} of {of}, allowed are parts 1 to {of}")));
        }
        Ok(Self { number, of })
    }

    /// The numbers, from 0, of the rows of this part, if there are `len` rows in all.
    pub fn rows(self, len: usize) -> Range<usize> {
        // the product of two numbers need not fit into their type, and the quotient is no more than `len`
        let end = |number: usize| (number as u128 * len as u128 / self.of as u128) as usize;
        end(self.number - 1)..end(self.number)
    }
}

impl FromStr for Part {
    type Err = PartError;

    /// Reads `K/N`.
    fn from_str(text: &str) -> Result<Self, PartError> {
        let number = |text: &str| text.trim().parse::<usize>().ok();
        let numbers = text.split_once('/').and_then(|(part, of)| Some((number(part)?, number(of)?)));
        let Some((part, of)) = numbers else {
            let reason = "K/N is expected, two whole numbers with 1 <= K <= N, such as 17/400".to_owned();
            return Err(PartError { part: text.to_owned(), reason });
        };
        Self::new(part, of)
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}
