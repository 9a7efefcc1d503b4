//! Noises that mix: their generators are kept, not boxed.

use estimators::{Estimator, Rcz, RczOptions, Relation, System};
use setrep::{Matrix, Zonotope};

use crate::plants::{Draw, PlanarOutput, PlanarStep, planar_start, radius, value};
use crate::support::Random;

/// Two noises that nearly move together.
fn skew() -> Zonotope {
    Zonotope::new(&[0.0; 2], &Matrix::from_rows(&[&[0.3, 0.02, 0.0], &[0.25, 0.0, 0.03]]).unwrap()).unwrap()
}

fn system(process: Zonotope, output: Zonotope) -> System {
    System::new(Relation::new(PlanarStep), process, Relation::new(PlanarOutput), output).unwrap()
}

/// `G xi` for random coordinates.
fn draw(random: &mut Random) -> Vec<f64> {
    let noise = skew();
    let mut v = vec![0.0; 2];
    for column in noise.generators().columns() {
        let xi = Draw::Uniform.noise(1.0, random);
        v.iter_mut().zip(column).for_each(|(v, g)| *v += g * xi);
    }
    v
}

/// States and measurements of example 5.1 with such noises.
fn run(steps: usize, random: &mut Random) -> Vec<(Vec<f64>, Vec<f64>)> {
    let mut x = vec![5.2, 0.65];
    let mut run = Vec::new();
    for _ in 0..steps {
        let y = value(&PlanarOutput, &[&x[..], &draw(random)].concat(), &[]);
        let next = value(&PlanarStep, &[&x[..], &draw(random)].concat(), &[]);
        run.push((std::mem::replace(&mut x, next), y));
    }
    run
}

/// Mean radius along a run, which stays inside.
fn mean_radius(system: System, run: &[(Vec<f64>, Vec<f64>)]) -> f64 {
    let mut filter = Rcz::new(system, planar_start(), RczOptions::fast(2)).unwrap();
    let mut sum = 0.0;
    for (x, y) in run {
        filter.update(y).unwrap();
        assert!(filter.hull().iter().zip(x).all(|(side, &x)| side.contains(x)));
        sum += radius(filter.hull());
        filter.predict(&[]).unwrap();
    }
    sum / run.len() as f64
}

#[test]
fn noises_that_mix_are_tighter_than_their_boxes() {
    let mut random = Random::new(95);
    let boxed = || Zonotope::from_intervals(&skew().interval_hull()).unwrap();
    let (mut mixed, mut boxes) = (0.0, 0.0);
    for _ in 0..10 {
        let run = run(12, &mut random);
        mixed += mean_radius(system(skew(), skew()), &run) / 10.0;
        boxes += mean_radius(system(boxed(), boxed()), &run) / 10.0;
    }
    println!("mean radius {mixed:.4}, with boxes {boxes:.4}");
    assert!(mixed < 0.9 * boxes, "{mixed} {boxes}");
}

#[test]
fn a_step_with_mixing_noise_allocates_nothing() {
    let mut random = Random::new(96);
    let run = run(40, &mut random);
    for options in [RczOptions::fast(2), RczOptions::slow(2), RczOptions::cheap(2)] {
        let mut filter = Rcz::new(system(skew(), skew()), planar_start(), options).unwrap();
        let start = filter.state().clone();
        let once = |filter: &mut Rcz| {
            for (_, y) in &run {
                filter.step(&[], y).unwrap();
            }
        };
        // Buffers change places: each has to have been the largest once.
        for _ in 0..6 {
            once(&mut filter);
            filter.restore(&start).unwrap();
        }
        let info = allocation_counter::measure(|| once(&mut filter));
        assert_eq!(info.count_total, 0, "{:?}", options.tier);
    }
}
