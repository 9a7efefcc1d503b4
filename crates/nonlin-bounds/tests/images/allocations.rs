//! Enclosures, images and solution sets allocate nothing once the buffers have grown.

use allocation_counter::measure;
use nonlin_bounds::{AffineEnclosure, Copies, Domain, Form, QuadraticEnclosure, Rows, Workspace};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Zonotope};

use crate::common::functions::{Attitude, AttitudeOutput};

#[test]
fn warm_enclosures_allocate_nothing() {
    let (n, noises) = (4, 3);
    let mut generators = Matrix::zeros(n, 0);
    for j in 0..6 {
        generators.push_col(&[0.02, 0.01 * f64::from(j), -0.01, 0.005 * f64::from(3 - j)]).unwrap();
    }
    let mut rows = Matrix::zeros(2, 6);
    rows.as_mut_slice().iter_mut().enumerate().for_each(|(k, x)| *x = (k % 5) as f64 - 2.0);
    let body = Zonotope::with_remainder(&[0.0, 1.0, 0.0, 0.0], &generators, &[1e-3, 0.0, 1e-16, 0.0]).unwrap();
    let start = ConstrainedZonotope::with_constraints(&body, &rows, &[Interval::point(0.0).inflate(0.5); 2]).unwrap();
    let noise = ConstrainedZonotope::from_box(&[0.0; 3], &[3e-3; 3]).unwrap();
    let mut skew = noise.clone();
    skew.materialize();
    let stacked = start.cartesian_product(&noise);
    let inputs = [0.3, -0.1, 0.05].map(Interval::point);
    let (mut w, mut enclosure, mut bounds) = (Workspace::new(), AffineEnclosure::new(), Rows::new());
    let (mut hull, mut wide) = (vec![Interval::ZERO; n], vec![Interval::ZERO; n + noises]);
    let at = [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let values = [Interval::point(0.0).inflate(1.0); 6];
    let target = ConstrainedZonotope::from_box(&[0.0; 6], &[1.0; 6]).unwrap();
    let mut quadratic = None;
    let (mut set, mut plain) = (stacked.clone(), stacked.unconstrained().clone());
    let mut step = || {
        stacked.interval_hull_into(&mut wide, &mut w.sets).unwrap();
        let domain = Domain::new(&wide, &at).with_parameters(&inputs).with_noises(noises);
        for form in [Form::Natural, Form::MeanValue, Form::Slope, Form::Taylor] {
            enclosure.enclose(form, &Attitude, &domain, &mut w).unwrap();
            set.clone_from(&stacked);
            enclosure.image_in_place(&mut set, &mut w).unwrap();
            plain.clone_from(stacked.unconstrained());
            enclosure.image_in_place(&mut plain, &mut w).unwrap();
            // The noises as boxes, and as a set of their own.
            set.clone_from(&start);
            enclosure.image_in_place(&mut set, &mut w).unwrap();
            set.clone_from(&start);
            enclosure.intersect_with_noise(&mut set, &values[..4], &skew, &mut w).unwrap();
        }
        enclosure.enclose_where_possible(&Attitude, &domain, &mut w).unwrap();
        start.interval_hull_into(&mut hull, &mut w.sets).unwrap();
        let domain = Domain::new(&hull, &at[..n]);
        enclosure.enclose(Form::Taylor, &AttitudeOutput, &domain, &mut w).unwrap();
        enclosure.rows_into(n, &values, &mut bounds).unwrap();
        set.clone_from(&start);
        bounds.intersect(&mut set, &mut w).unwrap();
        set.clone_from(&start);
        enclosure.intersect(&mut set, &values, &mut w).unwrap();
        set.clone_from(&start);
        enclosure.intersect_set(&mut set, &target, &mut w).unwrap();
        let quadratic = match &mut quadratic {
            None => quadratic
                .insert(QuadraticEnclosure::new(&AttitudeOutput, &start, &domain, Copies::Separate, &mut w).unwrap()),
            Some(quadratic) => {
                quadratic.renew(&AttitudeOutput, &start, &domain, Copies::Separate, &mut w).unwrap();
                quadratic
            }
        };
        set.clone_from(&start);
        quadratic.image_in_place(&mut set, &mut w).unwrap();
        set.clone_from(&start);
        quadratic.intersect(&mut set, &values, &mut w).unwrap();
        quadratic.box_curvature(&mut w).unwrap();
        set.clone_from(&start);
        quadratic.intersect(&mut set, &values, &mut w).unwrap();
        set.center()[0]
    };
    let expected: f64 = (0..10).map(|_| step()).sum();
    let mut sum = 0.0;
    let count = measure(|| (0..10).for_each(|_| sum += step()));
    assert!(expected.is_finite() && sum.is_finite());
    assert_eq!(count.count_total, 0);
}
