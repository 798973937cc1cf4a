//! A line of the table: expected, allowed, measured.

use super::not_reached::{self, NotReached};

/// What theory expects of a figure, and how far off it may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Expected {
    /// A value, give or take a fraction of it.
    Share {
        /// The value.
        value: f64,
        /// The fraction of it that a measurement may be off.
        tolerance: f64,
    },
    /// A value, give or take so much.
    Value {
        /// The value.
        value: f64,
        /// What a measurement may be off, in the figure's unit.
        tolerance: f64,
    },
    /// At most this.
    AtMost(f64),
    /// At least this.
    AtLeast(f64),
    /// From the first to the second.
    Between(f64, f64),
}

impl Expected {
    /// Whether `measured` is allowed; what is not a number never is.
    pub fn allows(&self, measured: f64) -> bool {
        let (low, high) = self.range();
        low <= measured && measured <= high
    }

    /// The least and the most that is allowed.
    pub fn range(&self) -> (f64, f64) {
        match *self {
            Expected::Share { value, tolerance } => {
                let off = (value * tolerance).abs();
                (value - off, value + off)
            }
            Expected::Value { value, tolerance } => (value - tolerance, value + tolerance),
            Expected::AtMost(limit) => (f64::NEG_INFINITY, limit),
            Expected::AtLeast(limit) => (limit, f64::INFINITY),
            Expected::Between(low, high) => (low, high),
        }
    }
}

/// One figure of one case.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What it is called in the list of rows that are not reached.
    pub id: String,
    /// The measured quantity, as a phrase.
    pub what: String,
    /// What theory expects.
    pub expected: Expected,
    /// What came out.
    pub measured: f64,
    /// The unit of both; empty for a ratio.
    pub unit: &'static str,
    /// Where the expected value comes from, or what else is worth saying.
    pub note: String,
    /// Whether the document's table has the row while it holds.
    pub is_listed: bool,
}

/// How a row ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Within its tolerance.
    Holds,
    /// Outside, and known to be.
    NotReached(&'static NotReached),
    /// Outside.
    Fails,
}

impl Row {
    /// A row without a unit and a note.
    pub fn new(
        id: impl Into<String>,
        what: impl Into<String>,
        expected: Expected,
        measured: f64,
    ) -> Row {
        Row {
            id: id.into(),
            what: what.into(),
            expected,
            measured,
            unit: "",
            note: String::new(),
            is_listed: true,
        }
    }

    /// The same in this unit.
    #[must_use]
    pub fn in_unit(mut self, unit: &'static str) -> Row {
        self.unit = unit;
        self
    }

    /// The same with this note.
    #[must_use]
    pub fn noting(mut self, note: impl Into<String>) -> Row {
        self.note = note.into();
        self
    }

    /// The same, which the document's table has only where it does not hold.
    #[must_use]
    pub fn unlisted(mut self) -> Row {
        self.is_listed = false;
        self
    }

    /// Within its tolerance with all figures of its note measured, or not, or known not to be.
    pub fn verdict(&self) -> Verdict {
        if self.expected.allows(self.measured) && !self.note.contains("NaN") {
            Verdict::Holds
        } else {
            not_reached::find(&self.id).map_or(Verdict::Fails, Verdict::NotReached)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tolerance_is_an_interval() {
        let share = Expected::Share {
            value: -2.0,
            tolerance: 0.1,
        };
        assert!(share.allows(-2.19) && share.allows(-1.81));
        assert!(!share.allows(-2.21) && !share.allows(-1.79));
        let value = Expected::Value {
            value: 1.0,
            tolerance: 0.5,
        };
        assert!(value.allows(0.5) && value.allows(1.5) && !value.allows(1.6));
        assert!(Expected::AtMost(0.0).allows(-1.0) && !Expected::AtMost(0.0).allows(0.1));
        assert!(Expected::AtLeast(1.0).allows(1.0) && !Expected::AtLeast(1.0).allows(0.9));
        assert!(Expected::Between(1.5, 5.0).allows(2.0));
        assert!(!Expected::Between(1.5, 5.0).allows(5.1));
    }

    #[test]
    fn nan_is_never_allowed() {
        for expected in [
            Expected::AtMost(1.0),
            Expected::AtLeast(1.0),
            Expected::Between(0.0, 1.0),
        ] {
            assert!(!expected.allows(f64::NAN));
        }
        let row = Row::new("no such row", "", Expected::AtMost(1.0), f64::NAN);
        assert_eq!(row.verdict(), Verdict::Fails);
        let row = Row::new("no such row", "", Expected::AtMost(1.0), 0.5);
        let noting = |value: f64| row.clone().noting(format!("L50 {value:.2} m")).verdict();
        assert_eq!(
            [1.5, f64::NAN].map(noting),
            [Verdict::Holds, Verdict::Fails]
        );
    }
}
