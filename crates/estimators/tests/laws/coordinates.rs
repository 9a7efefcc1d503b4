//! One filter in two forms: InZSMF on R^n and the ZSMF of the same linear model.

use estimators::{Estimator, InZsmf, Left, Outputs, Right, Zsmf};
use lie_groups::Rn;
use nalgebra::{Matrix3, Vector3};
use setrep::{Reduction, Zonotope};

use crate::support::{Linear, Random, boxed};

/// On a vector space both sides of the invariant filter are the linear filter with `A = I`, to the last bit.
#[test]
fn on_a_vector_space_the_invariant_filter_is_the_linear_one() {
    let mut random = Random::new(21);
    let (errors, process, noise) = (boxed(&[2.0, 1.0, 0.5]), boxed(&[0.1, 0.2, 0.3]), boxed(&[0.5, 0.6, 0.7]));
    let start = Vector3::new(1.0, 2.0, 3.0);
    let outputs = Outputs::position();
    let reduction = Reduction::Combastel;
    let mut left: InZsmf<Rn<f64, 3>, 3, 3, Left> =
        InZsmf::new(Rn::new(start), &errors, outputs.clone(), &process, &noise)
            .unwrap()
            .with_reduction(reduction, 12)
            .unwrap();
    let mut right: InZsmf<Rn<f64, 3>, 3, 3, Right> =
        InZsmf::new(Rn::new(start), &errors, outputs, &process, &noise).unwrap().with_reduction(reduction, 12).unwrap();
    let model = Linear { a: Matrix3::identity(), c: Matrix3::identity(), d: Matrix3::identity() };
    let initial = Zonotope::from_box(start.as_slice(), &[2.0, 1.0, 0.5]).unwrap();
    let mut linear = Zsmf::new(model, &initial, &process, &noise).unwrap().with_reduction(reduction, 12).unwrap();
    for _ in 0..50 {
        let (u, y) = (random.matrix::<3, 1>(), random.matrix::<3, 1>() * 3.0);
        left.step(&u, y.as_slice()).unwrap();
        right.step(&u, y.as_slice()).unwrap();
        linear.step(&u, y.as_slice()).unwrap();
        assert!((left.estimate().vector() - linear.estimate()).amax() < 1e-12);
        assert_eq!(left.estimate(), right.estimate());
        assert_eq!(left.tangent_set(), right.tangent_set());
        assert_eq!(left.tangent_set().generators(), linear.enclosure().generators());
        assert_eq!(linear.enclosure().center(), linear.estimate().as_slice());
    }
}
