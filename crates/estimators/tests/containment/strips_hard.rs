//! The filter of strips where bounds are hardest to keep (see [`hard_truth`](crate::hard_truth)): all sensors at once, wrong measurements in
//! between.

use estimators::{Estimator, EstimatorError, Evidence, InvariantStrips, PlanarMeasurement, StripsOptions};
use scalars::Interval;

use crate::hard_truth::{Truth, difference};
use crate::support::cases;

/// All that can be seen of a filter.
fn look(filter: &InvariantStrips) -> String {
    let rows = filter.clone().polytope().map(|p| format!("{p:?}"));
    format!("{:?} {} {} {rows:?}", filter.enclosure(), filter.num_rows(), filter.reference_heading_rad())
}

#[derive(Debug, Default)]
struct Counts {
    steps: usize,
    wrong: usize,
    found: usize,
    unproven: usize,
    refused: usize,
    polygons: usize,
}

fn run(seed: u64, steps: usize, counts: &mut Counts) {
    let mut truth = Truth::new(seed);
    let prior = truth.prior();
    let options = match seed % 4 {
        0 => StripsOptions::calibration(),
        1 => StripsOptions::fast_pose(),
        2 => StripsOptions { memory: usize::MAX, support_life: usize::MAX, refresh: 2, ..StripsOptions::pose() },
        _ => StripsOptions { refresh: 2, ..StripsOptions::pose() },
    };
    let mut filter = InvariantStrips::new(&prior, options).unwrap();
    assert!(!filter.excludes(&truth.state).unwrap(), "seed {seed}: prior");
    for k in 0..steps {
        counts.steps += 1;
        let step = truth.advance();
        if let Err(error) = filter.predict(&step) {
            assert!(truth.unit > 1e100, "seed {seed}, step {k}: {error}");
            counts.refused += 1;
            return;
        }
        assert!(!filter.excludes(&truth.state).unwrap(), "seed {seed}, step {k}, predicted {prior:?} {step:?}");
        let many = [0, 1, 1, 2, 3, 9][truth.random.below(6)];
        let readings: Vec<_> = (0..many).map(|_| truth.measure()).collect();
        let before = look(&filter);
        for wrong in [
            PlanarMeasurement::position([f64::NAN, 0.0], [Interval::ONE; 2]),
            PlanarMeasurement::position([0.0; 2], [Interval::EMPTY, Interval::ONE]),
            PlanarMeasurement::position([0.0; 2], [Interval::ENTIRE, Interval::ONE]),
            PlanarMeasurement::position([f64::INFINITY, 0.0], [Interval::ONE; 2]),
            PlanarMeasurement::position([0.0; 2], [Interval::ONE; 2]).of_vector(usize::MAX),
            PlanarMeasurement::position([0.0; 2], [Interval::ONE; 2]).with_unknown_arm(usize::MAX),
            PlanarMeasurement::position([0.0; 2], [Interval::ONE; 2]).with_arm([f64::NAN, 0.0]),
            PlanarMeasurement::range_bearing([Interval::ONE; 2], Interval::EMPTY, Interval::ONE),
            PlanarMeasurement::range_bearing([Interval::ONE; 2], Interval::ONE, Interval::EMPTY),
            PlanarMeasurement::range_bearing([Interval::ONE; 2], Interval::ENTIRE, Interval::ONE),
            PlanarMeasurement::range_bearing([Interval::EMPTY; 2], Interval::ONE, Interval::ONE),
            PlanarMeasurement::landmark([Interval::ONE; 2], [f64::NAN; 2], [Interval::ONE; 2]),
        ] {
            let all: Vec<_> = readings.iter().copied().chain([wrong]).collect();
            assert!(filter.update(&all).is_err(), "seed {seed}: {wrong:?}");
        }
        assert_eq!(before, look(&filter));
        // A measurement of another place: if it is found to be wrong, the filter is as before.
        let mut other = filter.clone();
        let y = truth.state.fixed[0].map(|x| x.mid() + truth.unit * 7.0);
        let wrong = PlanarMeasurement::position(y, [Interval::point(0.1 * truth.unit); 2]);
        counts.wrong += 1;
        if let Err(error) = other.update(&[&readings[..], &[wrong]].concat()) {
            if let EstimatorError::Inconsistent(proof) = &error {
                counts.found += 1;
                // Bounds may cross by less than a proof can show.
                if matches!(proof.evidence, Evidence::Propagation { .. }) {
                    counts.unproven += 1;
                } else {
                    assert!(proof.verify(), "seed {seed}, step {k}: {proof:?}");
                }
            }
            assert_eq!(before, look(&other), "seed {seed}, step {k}: {error}");
            assert!(!other.excludes(&truth.state).unwrap(), "seed {seed}, step {k}");
            filter = other;
        }
        if let Err(error) = filter.update(&readings) {
            assert!(
                truth.unit > 1e100 && !matches!(error, EstimatorError::Inconsistent(_)),
                "seed {seed}, step {k}: {error}\n{prior:?}\n{step:?}\n{readings:?}"
            );
            counts.refused += 1;
            return;
        }
        assert!(!filter.excludes(&truth.state).unwrap(), "seed {seed}, step {k}: {prior:?} {step:?} {readings:?}");
        if truth.random.below(4) == 0 {
            let place = truth.state.fixed[0].map(|x| x.mid());
            if let Ok(polygon) = filter.polygon(0, 3 + truth.random.below(9)) {
                let far = truth.state.fixed[0].iter().all(|x| x.rad() == 0.0);
                counts.polygons += 1;
                if far {
                    assert_ne!(
                        polygon.membership(&place.map(Interval::point)).unwrap(),
                        setrep::Membership::ProvenOutside,
                        "seed {seed}"
                    );
                }
            }
            let from = truth.vector(5.0).map(|x| x.mid());
            let away = difference(truth.state.fixed[0], from.map(Interval::point));
            let least = (away[0].sqr() + away[1].sqr()).sqrt().lo();
            match filter.max_distance_from(from) {
                Ok(most) => assert!(most >= least, "seed {seed}, step {k}: {most} {least}"),
                Err(error) => println!("seed {seed}, step {k}, unit {}: distance: {error}", truth.unit),
            }
        }
    }
}

#[test]
fn hard_cases_are_contained() {
    let mut counts = Counts::default();
    for seed in 0..cases(48) as u64 {
        run(seed, if seed % 16 == 5 { 40 } else { 8 }, &mut counts);
    }
    println!("{counts:?}");
    assert!(100 * counts.unproven <= counts.found, "{counts:?}");
}

/// The same cases with noises of the odometry up to a tenth beyond what the filter is told: the checks above can fail.
#[test]
fn hard_cases_with_broken_bounds_are_lost() {
    let mut lost = 0;
    for seed in 0..40 {
        let mut truth = Truth { declared: 0.9, ..Truth::new(seed) };
        let mut filter = InvariantStrips::new(&truth.prior(), StripsOptions::pose()).unwrap();
        for _ in 0..8 {
            let told = truth.advance();
            let readings: Vec<_> = (0..3).map(|_| truth.measure()).collect();
            filter.predict(&told).unwrap();
            if filter.excludes(&truth.state).unwrap()
                || filter.update(&readings).is_err()
                || filter.excludes(&truth.state).unwrap()
            {
                lost += 1;
                break;
            }
        }
    }
    println!("{lost} of 40 lost");
    assert!(lost > 10, "{lost}");
}
