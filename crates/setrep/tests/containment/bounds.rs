//! Containment of exact images: bounds.

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::exact::{member, support};
use crate::common::random::{Random, cases};

/// Support function, interval hull and F-radius are at least the exact values, and above them by rounding only.
#[test]
fn bounds_are_above_the_exact_values_and_tight() {
    let mut rounded_down = 0;
    for case in 0..cases(15_000) {
        let mut random = Random::new(SEED + 6, case);
        let (n, m) = (random.between(1, 5), random.between(0, 12));
        let set = random.set(n, m);
        let style = random.below(4);
        let direction: Vec<f64> = (0..n).map(|_| random.entry(style)).collect();
        let (h, exact) = (set.support(&direction).unwrap(), support(&set, &direction));
        assert!(Dyadic::from(h) >= exact, "seed {SEED}+6 case {case}: h = {h} along {direction:?} of {set:?}");
        let scale: f64 = (0..n)
            .map(|k| {
                let row: f64 = set.generators().columns().map(|g| g[k].abs()).sum();
                direction[k].abs() * (set.center()[k].abs() + row + set.remainder()[k])
            })
            .sum();
        assert!(
            (&Dyadic::from(h) - &exact).approx() <= 2e-14 * scale,
            "seed {SEED}+6 case {case}: loose by more than rounding"
        );
        let plain: f64 =
            (0..n).map(|k| direction[k] * set.center()[k] + direction[k].abs() * set.remainder()[k]).sum::<f64>()
                + set
                    .generators()
                    .columns()
                    .map(|g| direction.iter().zip(g).map(|(d, g)| d * g).sum::<f64>().abs())
                    .sum::<f64>();
        rounded_down += usize::from(Dyadic::from(plain) < exact);

        let (hull, x) = (set.interval_hull(), member(&set, &mut random).x);
        let mut into = hull.clone();
        set.interval_hull_into(&mut into).unwrap();
        for k in 0..n {
            let mut axis = vec![0.0; n];
            axis[k] = 1.0;
            let (high, low) = (support(&set, &axis), -support(&set, &axis.iter().map(|x| -x).collect::<Vec<_>>()));
            for side in [hull[k], into[k]] {
                let (lo, hi) = (Dyadic::from(side.lo()), Dyadic::from(side.hi()));
                assert!(lo <= low && high <= hi && lo <= x[k] && x[k] <= hi, "seed {SEED}+6 case {case}: {set:?}");
                assert!(
                    (&hi - &high).approx() <= 1e-14 * (side.mag() + side.width()),
                    "seed {SEED}+6 case {case}: loose hull"
                );
            }
        }

        let radius = Dyadic::from(set.f_radius());
        let entries = set.generators().as_slice().iter().chain(set.remainder());
        let squares = entries.fold(Dyadic::zero(), |sum, &x| &sum + &(&Dyadic::from(x) * &Dyadic::from(x)));
        assert!(&radius * &radius >= squares, "seed {SEED}+6 case {case}: F-radius of {set:?}");
        assert!((&(&radius * &radius) - &squares).approx() <= 1e-13 * squares.approx());
    }
    assert!(rounded_down > 100, "plain evaluation never falls short: the battery proves nothing");
}
