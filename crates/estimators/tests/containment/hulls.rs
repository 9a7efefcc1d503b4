//! Boxes of invariant sets against images of their points.

use estimators::{ErrorSide, Estimator, InZsmf, Left, Outputs, Right};
use lie_groups::{LieGroup, SE2};
use nalgebra::{Vector2, Vector3};

use crate::support::{Random, boxed, cases, increment};

type Filter<Side> = InZsmf<SE2<f64>, 3, 2, Side>;

fn filter<Side: ErrorSide>(radii: [f64; 3]) -> Filter<Side> {
    let start = SE2::from_pose(0.7, 3.0, -2.0);
    InZsmf::new(start, &boxed(&radii), Outputs::position(), &boxed(&[0.01; 3]), &boxed(&[0.5; 2])).unwrap()
}

/// A point of the tangent set, up to rounding.
fn draw<Side: ErrorSide>(filter: &Filter<Side>, random: &mut Random) -> Vector3<f64> {
    let extreme = random.below(2) == 0;
    filter.tangent_set().generators().columns().fold(Vector3::zeros(), |sum, generator| {
        let xi = if extreme { random.sign() } else { random.unit() };
        sum + Vector3::from_column_slice(generator) * xi
    })
}

/// Images of points of the set lie in the box, from narrow headings to headings of more than a turn.
fn images_lie_in_the_world_hull<Side: ErrorSide>(seed: u64) {
    let mut random = Random::new(seed);
    let bodies = [Vector2::zeros(), Vector2::new(1.5, -0.5)];
    for heading in [1e-9, 1e-3, 0.3, 2.0, 3.2, 4.5, 10.0] {
        let mut filter = filter::<Side>([heading, 1.0, 2.0]);
        filter.step(&increment(), &[3.5, -2.0]).unwrap();
        let hulls = bodies.map(|p| filter.world_hull(&p).unwrap());
        for _ in 0..cases(2000) {
            let state: SE2<f64> = Side::apply(filter.estimate(), &draw(&filter, &mut random));
            for (p, hull) in bodies.iter().zip(&hulls) {
                let image = state.act(p);
                for i in 0..2 {
                    let slack = 1e-13 * (1.0 + hull[i].mag());
                    assert!(hull[i].inflate(slack).contains(image[i]), "heading {heading}: {image} {hull:?}");
                }
            }
        }
    }
}

#[test]
fn images_lie_in_the_world_hull_left() {
    images_lie_in_the_world_hull::<Left>(51);
}

#[test]
fn images_lie_in_the_world_hull_right() {
    images_lie_in_the_world_hull::<Right>(52);
}

/// For a narrow heading the two boxes agree to second order, on both sides; for a wide one the linear box misses states.
#[test]
fn the_linear_hull_is_of_first_order() {
    fn excess<Side: ErrorSide>(heading: f64) -> f64 {
        let filter = filter::<Side>([heading, 0.0, heading]);
        let (linear, world) =
            (filter.world_hull_approx(&Vector2::zeros()), filter.world_hull(&Vector2::zeros()).unwrap());
        (0..2)
            .map(|i| (world[i].hi() - linear[i].hi()).abs().max((world[i].lo() - linear[i].lo()).abs()))
            .fold(0.0, f64::max)
    }
    for heading in [1e-4, 1e-3, 1e-2] {
        assert!(excess::<Left>(heading) < 2.0 * heading * heading);
        assert!(excess::<Right>(heading) < 8.0 * heading * heading);
    }
    let wide = filter::<Left>([2.0, 3.0, 0.0]);
    let state = wide.estimate().compose(&SE2::exp(&Vector3::new(2.0, 3.0, 0.0)));
    let (linear, world) = (wide.world_hull_approx(&Vector2::zeros()), wide.world_hull(&Vector2::zeros()).unwrap());
    let image = state.translation();
    assert!((0..2).any(|i| !linear[i].contains(image[i])));
    assert!((0..2).all(|i| world[i].contains(image[i])));
}
