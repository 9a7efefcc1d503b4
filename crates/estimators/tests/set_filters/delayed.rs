//! Delayed measurements: bit for bit the run in time, refusals that leave everything as it was, allocations.

use estimators::{
    DelayedFilter, Estimator, EstimatorError, Method, Rcz, RczOptions, Relation, SetFilter, System, ZonotopeFilter,
    ZonotopeOptions,
};
use nonlin_bounds::function;
use setrep::ConstrainedZonotope;

use crate::plants::{AttitudeSample, Draw, attitude, attitude_run, attitude_start, cube};
use crate::support::Random;

/// A measurement, the step it belongs to and the step at which it arrives.
struct Delivery {
    step: usize,
    arrival: usize,
    output: Vec<Option<f64>>,
}

/// Some outputs in time, the others up to `delay` steps later, or never.
fn deliveries(run: &[AttitudeSample], delay: usize, random: &mut Random) -> Vec<Delivery> {
    let mut list = Vec::new();
    for (step, (_, y, _)) in run.iter().enumerate() {
        let late = random.below(6);
        let part = |keep: &dyn Fn(usize) -> bool| y.iter().enumerate().map(|(i, &y)| keep(i).then_some(y)).collect();
        list.push(Delivery { step, arrival: step, output: part(&|i| i < late) });
        let arrival = step + random.below(delay + 1);
        if arrival < run.len() {
            list.push(Delivery { step, arrival, output: part(&|i| i >= late) });
        }
    }
    list.sort_by_key(|delivery| delivery.arrival);
    list
}

fn late_is_in_time<M: Method>(start: SetFilter<M>, draw: Draw, seed: u64)
where
    M::Set: PartialEq,
    M::Memory: PartialEq,
{
    let mut random = Random::new(seed);
    let run = attitude_run(0.15, draw, 24, &mut random);
    let list = deliveries(&run, 3, &mut random);
    let mut filter = DelayedFilter::new(start.clone(), 3);
    for k in 0..run.len() {
        if k > 0 {
            filter.predict(&run[k - 1].2).unwrap();
        }
        for delivery in list.iter().filter(|delivery| delivery.arrival == k && delivery.step == k) {
            filter.update_some(&delivery.output, &[]).unwrap();
        }
        for delivery in list.iter().filter(|delivery| delivery.arrival == k && delivery.step < k) {
            filter.update_at(delivery.step as u64, &delivery.output, &[]).unwrap();
        }
    }
    let mut expected = start;
    for k in 0..run.len() {
        if k > 0 {
            expected.predict(&run[k - 1].2).unwrap();
        }
        for delivery in list.iter().filter(|delivery| delivery.step == k) {
            expected.update_some(&delivery.output, &[]).unwrap();
        }
    }
    assert_eq!(filter.filter().state(), expected.state());
    assert_eq!(format!("{:?}", filter.filter().state()), format!("{:?}", expected.state()));
}

#[test]
fn late_measurements_give_the_run_in_time_bit_for_bit() {
    for (seed, draw) in [(71, Draw::Uniform), (72, Draw::Vertex)] {
        for options in [RczOptions::fast(4), RczOptions::slow(4)] {
            late_is_in_time(Rcz::new(attitude(0.15), attitude_start(), options).unwrap(), draw, seed);
        }
        let start = attitude_start().unconstrained().clone();
        let options = ZonotopeOptions::zfo(12).with_consistency();
        late_is_in_time(ZonotopeFilter::new(attitude(0.15), start, options).unwrap(), draw, seed);
    }
}

/// After every single step, what is known is what a run in time of the measurements so far knows; cuts with the invariant and reductions
/// on the way are repeated as well.
#[test]
fn every_step_is_that_of_the_run_in_time() {
    let mut random = Random::new(73);
    let run = attitude_run(0.15, Draw::Uniform, 14, &mut random);
    let start = Rcz::new(attitude(0.15), attitude_start(), RczOptions::fast(4)).unwrap();
    let mut filter = DelayedFilter::new(start.clone(), 4);
    // One measurement in three is two steps late.
    let delivery = |step: usize| Delivery {
        step,
        arrival: step + if step.is_multiple_of(3) { 2 } else { 0 },
        output: run[step].1.iter().map(|&y| Some(y)).collect(),
    };
    let list: Vec<Delivery> = (0..run.len()).map(delivery).collect();
    for k in 0..run.len() {
        if k > 0 {
            filter.predict(&run[k - 1].2).unwrap();
        }
        if list[k].arrival == k {
            filter.update(&run[k].1).unwrap();
        }
        if k >= 2 && list[k - 2].arrival == k {
            filter.update_at(k as u64 - 2, &list[k - 2].output, &[]).unwrap();
        }
        // Steps with these are not among the late ones, so that the order at one step is that of the run in time.
        if k % 5 == 4 && k % 3 != 0 {
            filter.consistency().unwrap();
        }
        if k % 7 == 6 && k % 3 != 0 {
            filter.reduce().unwrap();
        }
        let mut expected = start.clone();
        for j in 0..=k {
            if j > 0 {
                expected.predict(&run[j - 1].2).unwrap();
            }
            if list[j].arrival <= k {
                expected.update(&run[j].1).unwrap();
            }
            if j % 5 == 4 && j % 3 != 0 {
                expected.consistency().unwrap();
            }
            if j % 7 == 6 && j % 3 != 0 {
                expected.reduce().unwrap();
            }
        }
        assert_eq!(filter.filter().state(), expected.state(), "step {k}");
    }
}

/// A pendulum whose steps last as long as the parameter says: variables `(angle, rate, w)`; its angle is seen.
fn pendulum() -> System {
    let swing = function!(|[angle, rate, w]: 3, [dt]: 1| -> 2 {
        [angle + dt * rate, rate - dt * (angle.sin().scale(4.0) + rate.scale(0.5)) + dt * w]
    });
    let seen = function!(|[angle, _rate, v]: 3| -> 1 { [angle + v] });
    System::new(Relation::new(swing), cube(1, 0.01), Relation::new(seen), cube(1, 0.02)).unwrap()
}

#[test]
fn steps_may_last_as_long_as_they_like() {
    let start = ConstrainedZonotope::from_box(&[0.5, 0.0], &[0.3, 0.3]).unwrap();
    let mut expected = Rcz::new(pendulum(), start, RczOptions::fast(2)).unwrap();
    let mut filter = DelayedFilter::new(expected.clone(), 2);
    let durations = [0.05, 0.01, 0.125, 0.04];
    let (mut angle, mut rate) = (0.6_f64, 0.1_f64);
    let mut seen = Vec::new();
    for dt in durations {
        seen.push(angle);
        filter.predict(&[dt]).unwrap();
        if seen.len() >= 2 {
            filter.update_at(seen.len() as u64 - 2, &[Some(seen[seen.len() - 2])], &[]).unwrap();
        }
        (angle, rate) = (angle + dt * rate, rate - dt * (4.0 * angle.sin() + 0.5 * rate));
    }
    for (k, dt) in durations.into_iter().enumerate() {
        if k + 1 < seen.len() {
            expected.update(&[seen[k]]).unwrap();
        }
        expected.predict(&[dt]).unwrap();
    }
    assert_eq!(filter.filter().state(), expected.state());
    assert!(filter.filter().hull()[0].contains(angle) && filter.filter().hull()[1].contains(rate));
}

/// Too old, not yet, contradictory or malformed: a typed error, and everything as before, also for what comes later.
#[test]
fn what_is_refused_changes_nothing() {
    let mut random = Random::new(74);
    let run = attitude_run(0.15, Draw::Uniform, 12, &mut random);
    let start = Rcz::new(attitude(0.15), attitude_start(), RczOptions::fast(4)).unwrap();
    let (mut filter, mut other) = (DelayedFilter::new(start.clone(), 3), DelayedFilter::new(start, 3));
    let all = |k: usize| -> Vec<Option<f64>> { run[k].1.iter().map(|&y| Some(y)).collect() };
    for k in 0..run.len() {
        if k > 0 {
            filter.predict(&run[k - 1].2).unwrap();
            other.predict(&run[k - 1].2).unwrap();
        }
        filter.update(&run[k].1).unwrap();
        other.update(&run[k].1).unwrap();
        let step = k as u64;
        if k >= 4 {
            let refused = filter.update_at(step - 4, &all(k - 4), &[]);
            assert_eq!(refused, Err(EstimatorError::OutOfReach { step: step - 4, oldest: step - 3, newest: step }));
        }
        assert!(matches!(filter.update_at(step + 1, &all(k), &[]), Err(EstimatorError::OutOfReach { .. })));
        if k >= 2 {
            let mut wrong = all(k - 2);
            wrong[1] = wrong[1].map(|y| y + 3.0);
            assert!(matches!(filter.update_at(step - 2, &wrong, &[]), Err(EstimatorError::Inconsistent(_))));
            assert!(filter.update_at(step - 2, &all(k)[..3], &[]).is_err());
            wrong[1] = Some(f64::NAN);
            assert!(matches!(filter.update_at(step - 2, &wrong, &[]), Err(EstimatorError::NotFinite { index: 1, .. })));
            assert!(filter.step(&[f64::NAN; 3], &run[k].1).is_err());
        }
        assert_eq!(filter.filter().state(), other.filter().state(), "step {k}");
        if k >= 3 {
            filter.update_at(step - 3, &all(k - 3), &[]).unwrap();
            other.update_at(step - 3, &all(k - 3), &[]).unwrap();
            assert_eq!(filter.filter().state(), other.filter().state(), "step {k}");
        }
    }
    assert_eq!(filter.oldest_step(), 9);
    filter.system_mut();
    assert_eq!(filter.oldest_step(), 12);
    assert!(matches!(filter.update_at(11, &all(11), &[]), Err(EstimatorError::OutOfReach { oldest: 12, .. })));
    filter.update_at(12, &all(12), &[]).unwrap();
    // Without a memory only the step under way is in reach.
    let mut forgetful = DelayedFilter::new(filter.into_filter(), 0);
    forgetful.step(&run[0].2, &run[12].1).unwrap();
    assert_eq!(forgetful.oldest_step(), 13);
}

#[test]
fn late_measurements_allocate_nothing_in_steady_state() {
    let calm =
        function!(|[x, y, w]: 3| -> 2 { [x.scale(0.5) + y.scale(0.125) + w, y.scale(0.625) - x.sqr().scale(0.125)] });
    let seen = function!(|[x, y, v]: 3| -> 2 { [x + v, y + x * v] });
    let system = System::new(Relation::new(calm), cube(1, 0.1), Relation::new(seen), cube(1, 0.05)).unwrap();
    let filter = ZonotopeFilter::new(system, cube(2, 1.0), ZonotopeOptions::zmv(8)).unwrap();
    let mut filter = DelayedFilter::new(filter, 3);
    let mut go = || {
        for k in 0..40 {
            let now = filter.filter().step_index();
            if now >= 3 {
                filter.update_at(now - 3, &[Some(0.02), None], &[]).unwrap();
            }
            if k % 3 == 0 {
                filter.update(&[0.0, 0.01]).unwrap();
            }
            filter.predict(&[]).unwrap();
        }
    };
    (0..4).for_each(|_| go());
    assert_eq!(allocation_counter::measure(go).count_total, 0);
}
