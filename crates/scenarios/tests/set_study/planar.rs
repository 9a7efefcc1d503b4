//! Example 5.1 of paper 003 against an independent computation and the bars of our filter.

use scenarios::cz_planar::{contenders, plant};
use scenarios::noise::NoiseKind;
use scenarios::set_study::Trajectory;

use crate::{mean, named, radii, random};

fn trajectory(run: usize) -> Trajectory {
    plant::simulate(NoiseKind::Uniform, 10, &mut random("planar", run)).unwrap()
}

/// Radii of every run of a filter, up to k = 10.
fn runs(method: &str, count: usize) -> Vec<Vec<f64>> {
    let contenders = contenders().unwrap();
    (0..count).map(|run| radii(&trajectory(run), named(&contenders, method))).collect()
}

/// Zonotope filters never cut anything here: their radii depend on nothing.
#[test]
fn zonotope_filters_have_the_radii_of_an_independent_computation() {
    for (method, expected) in [("zmv", &[2.0, 4.02, 10.69, 58.3][..]), ("zfo", &[2.0, 3.015, 5.515, 13.95])] {
        for radii in runs(method, 3) {
            println!("{method}: {radii:.4?}");
            for (k, expected) in expected.iter().enumerate() {
                assert!(
                    (radii[k] / expected - 1.0).abs() < 0.01,
                    "{method} at {k}: {} instead of {expected}",
                    radii[k]
                );
            }
            assert!(radii[9].is_infinite());
        }
    }
}

/// Bands of an independent computation over its seeds.
#[test]
fn constrained_zonotope_filters_stay_in_their_bands() {
    for (method, at_two, from_five, average) in
        [("czmv", 0.42..0.53, 0.42..0.53, 0.45..0.60), ("czfo", 0.42..0.69, 0.42..0.53, 0.45..0.60)]
    {
        let runs = runs(method, 6);
        let averages: Vec<f64> = runs.iter().map(|run| mean(run)).collect();
        println!("{method}: k=2 {:.3?}", runs.iter().map(|run| run[2]).collect::<Vec<_>>());
        println!("{method}: k=10 {:.3?}, averages {averages:.3?}", runs.iter().map(|run| run[10]).collect::<Vec<_>>());
        let at = |k: usize| mean(&runs.iter().map(|run| run[k]).collect::<Vec<_>>());
        assert!(at_two.contains(&at(2)), "{method}: {}", at(2));
        assert!((5..11).all(|k| from_five.contains(&at(k))), "{method}");
        assert!(average.contains(&mean(&averages)), "{method}: {averages:?}");
    }
}

#[test]
fn rcz_is_at_the_linearised_optimum() {
    let averages: Vec<f64> = runs("rcz", 6).iter().map(|run| mean(run)).collect();
    println!("{averages:.4?}, mean {:.4}", mean(&averages));
    assert!(mean(&averages) <= 0.415 && mean(&averages) > 0.36);
    assert!(averages.iter().all(|&average| average <= 0.45));
}
