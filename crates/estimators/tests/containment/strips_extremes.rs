//! The filter of strips with very many measurements, and with numbers at the end of their range.

use estimators::{
    Estimator, EstimatorError, InvariantStrips, PlanarBox, PlanarIncrement, PlanarMeasurement, StripsOptions,
};
use scalars::Interval;

use crate::hard_truth::Truth;
use crate::support::Random;

/// Many measurements of one instant, most of them twice.
#[test]
fn crowds_of_measurements_are_contained() {
    let mut truth = Truth::new(7);
    let options = StripsOptions { memory: usize::MAX, ..StripsOptions::pose() };
    let mut filter = InvariantStrips::new(&truth.prior(), options).unwrap();
    let readings: Vec<_> = (0..300).map(|_| truth.measure()).collect();
    filter.update(&[&readings[..], &readings[50..]].concat()).unwrap();
    assert!(!filter.excludes(&truth.state).unwrap());
}

/// Rows that would overflow in new coordinates stop the filter, and do not get lost.
#[test]
fn positions_at_the_end_of_the_numbers() {
    let (zero, side) = (Interval::ZERO, Interval::new(-1.0, 1.0).unwrap());
    let prior = PlanarBox::scale_and_lever_arm(zero, Interval::point(1e200), [zero; 2], [zero; 2]);
    let mut filter = InvariantStrips::new(&prior, StripsOptions::pose()).unwrap();
    filter.update(&[PlanarMeasurement::position([0.0; 2], [side; 2])]).unwrap();
    let noise = side.scale(1e95);
    let far = Interval::point(1.7e108);
    filter.predict(&PlanarIncrement::odometry(zero, [far, zero], zero, [noise; 2])).unwrap();
    let before = (filter.enclosure().clone(), filter.num_rows());
    for _ in 0..2 {
        let measured = PlanarMeasurement::position([1.7e308, 0.0], [side.scale(1e300); 2]);
        assert!(matches!(filter.update(&[measured]), Err(EstimatorError::NotFinite { .. })));
        assert_eq!(before, (filter.enclosure().clone(), filter.num_rows()));
    }
}

/// Headings of any size are the same heading.
#[test]
fn huge_headings_are_not_excluded_by_rounding() {
    let mut random = Random::new(1);
    for power in 0..25 {
        for _ in 0..20 {
            let heading = Interval::point(10_f64.powi(power) * random.unit());
            let (sin, cos) = heading.sin_cos();
            let origin = [Interval::ZERO; 2];
            let filter =
                InvariantStrips::new(&PlanarBox::se2(sin.atan2(cos), [Interval::ZERO; 2]), StripsOptions::pose())
                    .unwrap();
            assert!(!filter.excludes(&PlanarBox::se2(heading, origin)).unwrap(), "{heading:?}");
        }
    }
}
