//! Intervals as sets: a lattice under hull and intersection, and what midpoint, radius and bounds mean for members.

use proptest::prelude::*;
use scalars::Interval;

use crate::boxes::{float, interval, settings};

proptest! {
    #![proptest_config(settings())]

    #[test]
    fn hull_and_intersection_form_a_lattice(x in interval(), y in interval(), z in interval()) {
        prop_assert_eq!(x.hull(y), y.hull(x));
        prop_assert_eq!(x.intersection(y), y.intersection(x));
        prop_assert_eq!(x.hull(y.hull(z)), x.hull(y).hull(z));
        prop_assert_eq!(x.intersection(y.intersection(z)), x.intersection(y).intersection(z));
        prop_assert_eq!(x.hull(x.intersection(y)), x);
        prop_assert_eq!(x.intersection(x.hull(y)), x);
        prop_assert_eq!((x.hull(Interval::EMPTY), x.intersection(Interval::ENTIRE)), (x, x));
    }

    #[test]
    fn predicates_agree(x in interval(), y in interval()) {
        prop_assert_eq!(x.subset_of(&y), x.intersection(y) == x);
        prop_assert_eq!(x.disjoint(&y), x.intersection(y).is_empty());
        prop_assert_eq!(x == y, x.subset_of(&y) && y.subset_of(&x));
        prop_assert!(!x.interior_of(&y) || x.subset_of(&y));
    }

    #[test]
    fn membership_is_that_of_the_bounds(x in interval(), a in float()) {
        prop_assert_eq!(x.contains(a), Interval::point(a).subset_of(&x));
        prop_assert!(!x.contains(f64::NAN) && !x.contains(f64::INFINITY));
    }

    #[test]
    fn midpoint_and_radius_cover(x in interval()) {
        if x.is_empty() {
            prop_assert!(x.mid().is_nan() && x.rad().is_nan() && x.width().is_nan() && x.mag().is_nan() && x.mig().is_nan());
        } else {
            prop_assert!(x.contains(x.mid()));
            prop_assert!(x.subset_of(&Interval::point(x.mid()).inflate(x.rad())));
            prop_assert!(!x.is_bounded() || x.lo() + x.width() >= x.hi());
            prop_assert!(x.width() <= 2.0 * x.rad() || x.width() < 1e-300);
        }
    }

    #[test]
    fn magnitudes_bound_members(x in interval()) {
        if !x.is_empty() {
            prop_assert_eq!((x.abs().lo(), x.abs().hi()), (x.mig(), x.mag()));
            prop_assert!(x.mig() <= x.mid().abs() && x.mid().abs() <= x.mag());
        }
    }

    #[test]
    fn inflation_grows(x in interval(), r in 0.0..1e3_f64) {
        prop_assert!(x.subset_of(&x.inflate(r)));
        prop_assert!(x.is_empty() || x.inflate(r).width() >= r);
        prop_assert_eq!(x.inflate(0.0), x);
    }
}
