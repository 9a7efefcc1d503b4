//! Serialisation for self-describing formats: `[lo, hi]`, infinities as `"-inf"` and `"inf"`, the empty set as null.
//!
//! Bounds come back bit by bit (JSON: with `serde_json`'s feature `float_roundtrip`).

use serde::{Deserialize, Serialize};

use crate::{Interval, ScalarError};

#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Bound {
    Finite(f64),
    Infinite(Infinity),
}

#[derive(Serialize, Deserialize)]
enum Infinity {
    #[serde(rename = "-inf")]
    Negative,
    #[serde(rename = "inf")]
    Positive,
}

impl From<f64> for Bound {
    fn from(x: f64) -> Self {
        if x.is_finite() {
            Self::Finite(x)
        } else {
            Self::Infinite(if x > 0.0 { Infinity::Positive } else { Infinity::Negative })
        }
    }
}

impl From<Bound> for f64 {
    fn from(bound: Bound) -> Self {
        match bound {
            Bound::Finite(x) => x,
            Bound::Infinite(Infinity::Negative) => Self::NEG_INFINITY,
            Bound::Infinite(Infinity::Positive) => Self::INFINITY,
        }
    }
}

/// The wire form.
#[derive(Serialize, Deserialize)]
pub(crate) struct Bounds(Option<(Bound, Bound)>);

impl From<Interval> for Bounds {
    fn from(x: Interval) -> Self {
        Self((!x.is_empty()).then(|| (x.lo.into(), x.hi.into())))
    }
}

impl TryFrom<Bounds> for Interval {
    type Error = ScalarError;
    fn try_from(bounds: Bounds) -> Result<Self, ScalarError> {
        bounds.0.map_or(Ok(Self::EMPTY), |(lo, hi)| Self::new(lo.into(), hi.into()))
    }
}
