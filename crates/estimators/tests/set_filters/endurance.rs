//! Long runs: memory stays constant, radii stay bounded.

use estimators::{Estimator, Rcz, RczOptions};

use crate::plants::{Draw, PlanarOutput, PlanarStep, planar, planar_start, radius, value};
use crate::support::{Random, cases};

/// Example 5.1 for ten thousand steps (a million in a soak of factor 100).
#[test]
fn a_long_run_keeps_its_memory_and_its_radius() {
    let (steps, mut random) = (cases(10_000), Random::new(71));
    let mut filter = Rcz::new(planar(), planar_start(), RczOptions::fast(2)).unwrap();
    let (mut x, mut largest, mut sum) = (vec![5.2, 0.65], 0.0_f64, 0.0);
    let (mut allocations, mut growth) = (0, 0);
    for k in 0..steps {
        let draw = if k / 100 % 2 == 0 { Draw::Uniform } else { Draw::Vertex };
        let [v, w] = [(); 2].map(|()| [draw.noise(0.4, &mut random), draw.noise(0.4, &mut random)]);
        let y = value(&PlanarOutput, &[&x[..], &v].concat(), &[]);
        let info = allocation_counter::measure(|| filter.update(&y).unwrap());
        let inside = filter.hull().iter().zip(&x).all(|(side, x)| side.contains(*x));
        assert!(inside, "step {k}: {x:?} {:?}", filter.hull());
        largest = largest.max(radius(filter.hull()));
        sum += radius(filter.hull());
        let after = allocation_counter::measure(|| filter.predict(&[]).unwrap());
        // Buffers grow to the largest set of the run; that comes early.
        if k >= steps / 2 {
            allocations += info.count_total + after.count_total;
            growth += info.bytes_current + after.bytes_current;
        }
        x = value(&PlanarStep, &[&x[..], &w].concat(), &[]);
    }
    println!(
        "{steps} steps: mean radius {:.4}, largest {largest:.4}; second half: {allocations} allocations",
        sum / steps as f64
    );
    assert_eq!((allocations, growth), (0, 0));
    assert!(largest < 1.0 && sum < 0.45 * steps as f64, "largest {largest}");
}
