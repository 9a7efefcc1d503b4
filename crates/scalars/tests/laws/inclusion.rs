//! Inclusion isotonicity: a subset of the arguments has a subset of the image. And: no operation makes something of the
//! empty set.

use proptest::prelude::*;
use scalars::Interval;

use crate::boxes::{interval, settings};

type Unary = (&'static str, fn(Interval) -> Interval);
type Binary = (&'static str, fn(Interval, Interval) -> Interval);

const UNARY: &[Unary] = &[
    ("neg", |x| -x),
    ("sqr", Interval::sqr),
    ("recip", Interval::recip),
    ("sqrt", Interval::sqrt),
    ("abs", Interval::abs),
    ("powi(-3)", |x| x.powi(-3)),
    ("powi(-2)", |x| x.powi(-2)),
    ("powi(3)", |x| x.powi(3)),
    ("powi(4)", |x| x.powi(4)),
    ("scale", |x| x.scale(-0.3)),
    ("add_f64", |x| x.add_f64(0.3)),
    ("exp", Interval::exp),
    ("ln", Interval::ln),
    ("sin", Interval::sin),
    ("cos", Interval::cos),
    ("tan", Interval::tan),
    ("asin", Interval::asin),
    ("acos", Interval::acos),
    ("atan", Interval::atan),
    ("sinh", Interval::sinh),
    ("cosh", Interval::cosh),
    ("tanh", Interval::tanh),
    ("inflate", |x| x.inflate(0.25)),
];

const BINARY: &[Binary] = &[
    ("add", |x, y| x + y),
    ("sub", |x, y| x - y),
    ("mul", |x, y| x * y),
    ("div", |x, y| x / y),
    ("min", Interval::min),
    ("max", Interval::max),
    ("atan2", Interval::atan2),
    ("intersection", Interval::intersection),
];

proptest! {
    #![proptest_config(settings())]

    /// Any two boxes and the part they share.
    #[test]
    fn unary_operations_are_isotonic(x in interval(), y in interval()) {
        let part = x.intersection(y);
        for (name, f) in UNARY {
            prop_assert!(f(part).subset_of(&f(x)), "{}: {:?} in {:?}, image {:?} not in {:?}", name, part, x, f(part), f(x));
        }
    }

    #[test]
    fn binary_operations_are_isotonic(x in interval(), y in interval(), p in interval(), q in interval()) {
        let (a, b) = (x.intersection(p), y.intersection(q));
        for (name, f) in BINARY {
            prop_assert!(f(a, b).subset_of(&f(x, y)), "{}: {:?}, {:?} gives {:?}, not in {:?}", name, a, b, f(a, b), f(x, y));
        }
    }
}

#[test]
fn the_empty_set_stays_empty() {
    for (name, f) in UNARY {
        assert!(f(Interval::EMPTY).is_empty(), "{name}");
    }
    for (name, f) in BINARY {
        for y in [Interval::EMPTY, Interval::ZERO, Interval::ONE, Interval::ENTIRE] {
            assert!(f(Interval::EMPTY, y).is_empty() && f(y, Interval::EMPTY).is_empty(), "{name} with {y:?}");
        }
    }
}
