//! One model, written once: images of a set by several methods, and the states that a measurement leaves.
//!
//! `cargo run --release -p nonlin-bounds --example enclosures`

use nonlin_bounds::{
    BoundError, Copies, Domain, Expansion, Form, Function, QuadraticEnclosure, Workspace, affine_image,
    polytopic_image, polytopic_solution,
};
use scalars::{Interval, Scalar};
use setrep::{ConstrainedZonotope, HPolytope, Matrix, VPolytope};

/// A predator-prey step of paper 003, equation (15).
struct Planar;

impl Function for Planar {
    const VARIABLES: Option<usize> = Some(2);

    fn outputs(&self) -> usize {
        2
    }

    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        let share = x[0] * x[1] / x[0].add_f64(4.0);
        y[0] = x[0].scale(3.0) - x[0].sqr() * S::ratio(1, 7) - share.scale(4.0);
        y[1] = share.scale(3.0) - x[1].scale(2.0);
    }
}

fn main() -> Result<(), BoundError> {
    let mut workspace = Workspace::new();

    // A triangle, as a constrained zonotope and by its corners.
    let generators = Matrix::from_rows(&[&[0.5, 1.0, -0.5], &[0.5, 0.5, 0.0]])?;
    let row = Matrix::from_rows(&[&[-1.0, 1.0, -1.0]])?;
    let set = ConstrainedZonotope::from_cg_rep(&[5.0, 0.5], &generators, &row, &[2.0])?;
    let corners = VPolytope::new(Matrix::from_columns(&[&[6.5, 1.0], &[5.5, 0.5], &[5.0, 0.0]])?)?;

    println!("hulls of the image:");
    for form in [Form::MeanValue, Form::Taylor] {
        let image = affine_image(form, &Planar, &set, Expansion::HullCenter, &[], &mut workspace)?;
        print_hull(&format!("{form:?}"), &image.interval_hull(&mut workspace.sets)?);
    }
    let hull = set.interval_hull(&mut workspace.sets)?;
    let domain = Domain::new(&hull, set.center());
    let quadratic = QuadraticEnclosure::new(&Planar, &set, &domain, Copies::Shared, &mut workspace)?;
    let image = quadratic.image(&set, &mut workspace)?;
    print_hull("quadratic", &image.interval_hull(&mut workspace.sets)?);
    let image = polytopic_image(&Planar, &corners, Expansion::HullCenter, &[], &mut workspace)?;
    print_hull("polytopic", &image.interval_hull());

    // The states whose image has a second coordinate of at most -0.1.
    let y = HPolytope::new(Matrix::from_rows(&[&[0.0, 1.0]])?, &[-0.1])?;
    let left = polytopic_solution(&Planar, &corners, &y, Expansion::HullCenter, &[], &mut workspace)?;
    println!("states with f_2 <= -0.1:");
    print_hull("polytopic", &left.interval_hull());
    Ok(())
}

fn print_hull(name: &str, hull: &[Interval]) {
    println!("  {name:10} {:.4} x {:.4}", hull[0], hull[1]);
}
