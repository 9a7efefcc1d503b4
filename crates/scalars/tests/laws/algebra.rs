//! Arithmetic laws: exact ones as equality, those that rounding breaks as overlap of two enclosures of one set.

use num_traits::{One, Zero};
use proptest::prelude::*;
use scalars::Interval;

use crate::boxes::{interval, settings};

/// Two enclosures of one set: both empty or both with a common member.
fn overlap(a: Interval, b: Interval) -> bool {
    a.is_empty() == b.is_empty() && (a.is_empty() || !a.disjoint(&b))
}

proptest! {
    #![proptest_config(settings())]

    #[test]
    fn addition_and_multiplication_commute(x in interval(), y in interval()) {
        prop_assert_eq!(x + y, y + x);
        prop_assert_eq!(x * y, y * x);
    }

    #[test]
    fn both_associate_up_to_rounding(x in interval(), y in interval(), z in interval()) {
        prop_assert!(overlap((x + y) + z, x + (y + z)));
        prop_assert!(overlap((x * y) * z, x * (y * z)));
    }

    #[test]
    fn multiplication_is_subdistributive(x in interval(), y in interval(), z in interval()) {
        prop_assert!(overlap(x * (y + z), x * y + x * z));
    }

    #[test]
    fn neutral_elements_stay_inside(x in interval()) {
        prop_assert!(x.subset_of(&(x + Interval::zero())) && x.subset_of(&(x * Interval::one())));
        prop_assert!(x.subset_of(&x.scale(1.0)) && x.subset_of(&x.add_f64(0.0)));
        prop_assert!((x * Interval::ZERO).is_zero() || x.is_empty());
    }

    #[test]
    fn negation_is_exact(x in interval(), y in interval()) {
        prop_assert_eq!(-(-x), x);
        prop_assert_eq!(x - y, x + -y);
        prop_assert_eq!((-x) * y, -(x * y));
        prop_assert_eq!((-x) / y, -(x / y));
        prop_assert_eq!(x.scale(-2.5), -x.scale(2.5));
    }

    #[test]
    fn a_difference_and_a_quotient_of_equals_contain_their_value(x in interval()) {
        if !x.is_empty() {
            prop_assert!((x - x).contains(0.0));
            prop_assert!(x == Interval::ZERO || (x / x).contains(1.0));
        }
    }

    #[test]
    fn special_operations_refine_general_ones(x in interval(), n in 0..6_i32) {
        prop_assert!(overlap(x.sqr(), x * x) || x.is_empty());
        prop_assert!(overlap(x.recip(), Interval::ONE / x));
        prop_assert!(x.is_empty() || (x.sqr().lo() >= 0.0 && x.abs().lo() >= 0.0));
        let product = (0..n).fold(x.powi(0), |p, _| p * x);
        prop_assert!(overlap(x.powi(n), product));
        prop_assert!(overlap(x.powi(-n), x.powi(n).recip()));
    }

    #[test]
    fn assignment_is_the_operation(x in interval(), y in interval()) {
        let mut z = x;
        z += y;
        prop_assert_eq!(z, x + y);
        z -= y;
        prop_assert_eq!(z, x + y - y);
        z = x;
        z *= y;
        prop_assert_eq!(z, x * y);
        z /= y;
        prop_assert_eq!(z, x * y / y);
    }

    #[test]
    fn inverse_functions_return(x in interval()) {
        prop_assert!(x.subset_of(&x.exp().ln()) || x.is_empty() || x.lo() < -700.0);
        prop_assert!(x.subset_of(&x.atan().tan()));
        let unit = x.intersection(Interval::new(-1.0, 1.0).unwrap());
        prop_assert!(unit.subset_of(&unit.asin().sin()) && unit.subset_of(&unit.acos().cos()));
        let positive = x.intersection(Interval::new(0.0, f64::INFINITY).unwrap());
        prop_assert!(positive.subset_of(&positive.sqrt().sqr()));
    }

    #[test]
    fn identities_of_elementary_functions_overlap(x in interval()) {
        let (sin, cos) = x.sin_cos();
        prop_assert!(x.is_empty() || (sin.sqr() + cos.sqr()).contains(1.0));
        prop_assert!(x.is_empty() || !(x.cosh().sqr() - x.sinh().sqr()).disjoint(&Interval::ONE));
        prop_assert!(overlap(x.tanh(), x.sinh() / x.cosh()));
        let quarter = x.asin() + x.acos();
        prop_assert!(quarter.is_empty() || !quarter.disjoint(&Interval::FRAC_PI_2));
        prop_assert_eq!((-x).sin(), -x.sin());
        prop_assert_eq!((-x).cos(), x.cos());
    }
}
