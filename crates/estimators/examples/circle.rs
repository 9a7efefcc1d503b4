//! The example of the README: `cargo run --release -p estimators --example circle`.

use estimators::{Estimator, EstimatorError, InZsmf, Left, Outputs};
use lie_groups::{LieGroup, SE2};
use nalgebra::{Vector2, Vector3};
use setrep::{Reduction, Zonotope};

fn main() -> Result<(), EstimatorError> {
    let increment = Vector3::new(0.004, 0.08, 0.0); // per step: turn [rad], forward and sideways [m]
    let first = Zonotope::from_box(&[0.0; 3], &[0.5, 2.0, 2.0])?;
    let odometry = Zonotope::from_box(&[0.0; 3], &[0.001; 3])?;
    let receiver = Zonotope::from_box(&[0.0; 2], &[1.0; 2])?;
    let start = SE2::from_pose(0.3, 1.0, 0.0);
    let mut filter: InZsmf<SE2<f64>, 3, 2, Left> =
        InZsmf::new(start, &first, Outputs::position(), &odometry, &receiver)?
            .with_reduction(Reduction::Girard, 100)?;
    let mut truth = SE2::identity();
    for _ in 0..300 {
        filter.step(&increment, truth.translation().as_slice())?;
        truth = truth.compose(&SE2::exp(&increment));
    }
    let ([x1, x2], heading) = (filter.world_hull(&Vector2::zeros())?, filter.tangent_set().interval_hull()[0]);
    println!("truth    {:.3} {:.3}", truth.translation()[0], truth.translation()[1]);
    println!("position {x1} x {x2}");
    let unit = filter.estimate().rotation().unit();
    println!("heading  {:.3} +- {:.3} rad", unit.im.atan2(unit.re), heading.rad());
    Ok(())
}
