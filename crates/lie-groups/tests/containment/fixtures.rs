//! Single boxes at the edges of the case distinctions.

use lie_groups::{Coeff, LieGroup, SE2, SO2};
use nalgebra::{Matrix2, Vector3};
use scalars::Interval;

use crate::boxes::interval;
use crate::support::dd::Dd;
use crate::support::dense::Dense;

const PI: f64 = std::f64::consts::PI;

/// Every angle at which a formula, a branch of monotonicity or a series changes, and its neighbours.
#[test]
fn coefficients_at_the_seams() {
    let seams = [0.0, 5e-324, f64::MIN_POSITIVE, 1.4901161193847656e-8, 2.0, 2.331122370414423, PI, 4.49, 6.0];
    for seam in seams {
        for theta in [seam, seam.next_up(), seam.next_down().max(0.0), -seam] {
            let z = Dense::exact(&Matrix2::new(0.0, -theta, theta, 0.0));
            let point = Interval::point(theta);
            let (phi1, phi2) = Interval::phi1_phi2(point);
            let (psi1, psi2) = Interval::psi1_psi2(point).unwrap();
            let inverse = z.phi(1).inverse();
            for (what, exact, range) in
                [("phi_1", z.phi(1), phi1), ("phi_2", z.phi(2), phi2), ("psi_1", inverse.clone(), psi1)]
            {
                assert_eq!(exact.escapes(&range.to_matrix()), None, "{what} at {theta:e}: {range:?}");
            }
            // The real part, 1/2, is no more than rounding in the reference.
            assert!(inverse.multiply(&z.phi(2)).get(1, 0).in_interval(&psi2.im), "psi_2 at {theta:e}: {psi2:?}");
            assert_eq!(psi2.re, Interval::point(0.5));
        }
    }
}

/// Ranges over boxes with a turning point inside reach it: the largest `(1 - cos t) / t` and `(t - sin t) / t^2`.
#[test]
fn turning_points_are_reached() {
    let (phi1, phi2) = Interval::phi1_phi2(interval(1.0, 4.0));
    assert!(phi1.im.contains(0.7246113537767084) && phi1.im.hi() < 0.72461135377671);
    assert!(phi2.im.contains(std::f64::consts::FRAC_1_PI) && phi2.im.hi() < 0.31830988618380);
}

/// Far out everything stays bounded by what the functions can be there.
#[test]
fn huge_boxes() {
    let (phi1, phi2) = Interval::phi1_phi2(interval(-1e300, 1e300));
    assert!(interval(-0.21723, 1.0).subset_of(&phi1.re) && phi1.re.subset_of(&interval(-0.2228, 1.0)));
    assert!(phi1.im.mag() <= 0.7246113537767086 && phi2.re.subset_of(&interval(0.0, 0.5)));
    assert!(phi2.im.mag() <= 0.31830988618379075);
    let (phi1, _) = Interval::phi1_phi2(interval(1e300, 1e301));
    assert!(phi1.re.mag() < 1.1e-300 && phi1.im.mag() < 2.1e-300);
}

/// Exact cases stay exact: zero angle, identity.
#[test]
fn exact_points() {
    let straight = Vector3::new(Interval::ZERO, Interval::point(3.0), Interval::point(-2.0));
    let pose = SE2::exp(&straight);
    assert_eq!(pose.rotation().unit().re, Interval::ONE);
    assert_eq!(pose.rotation().unit().im, Interval::ZERO);
    assert_eq!(SE2::<Interval>::identity().log().unwrap(), Vector3::from_element(Interval::ZERO));
    for (found, wanted) in pose.log().unwrap().iter().zip(straight.iter()) {
        assert!(wanted.subset_of(found) && found.width() < 4e-15);
    }
}

/// Headings up to the last number before a half turn have a log.
#[test]
fn next_to_a_half_turn() {
    let heading = interval(3.0, PI);
    let log = SE2::from_pose(heading, Interval::ONE, Interval::ZERO).log().unwrap();
    assert!(heading.subset_of(&log[0]) && log[0].width() < 0.1416);
}

/// Of a loose box of cosines and sines only the arc counts.
#[test]
fn boxes_shrink_to_their_arc() {
    let rotation = SO2::from_cos_sin(interval(-0.1, 1.0), interval(0.0, 0.1)).unwrap();
    assert!(rotation.unit().re.lo() > 0.99 && rotation.angle().unwrap().hi() < 0.1002);
    // Across the half turn there is an arc but no log.
    let back = SO2::from_cos_sin(interval(-1.0, -0.9), interval(-0.1, 0.1)).unwrap();
    assert!(back.angle().is_err() && back.turn().arc().width() < 0.21);
    assert!(back.compose(&back).angle().unwrap().mag() < 0.21);
    // The whole circle.
    let any = SO2::from_cos_sin(interval(-1.0, 1.0), interval(-1.0, 1.0)).unwrap();
    assert!(interval(-PI, PI).subset_of(&any.turn().arc()));
}

/// Whole turns are taken off with an enclosure of `2 pi`, not with the `f64` number next to it.
#[test]
fn angles_of_many_turns() {
    // pi in double-double.
    let pi = Dd { hi: PI, lo: 1.2246467991473532e-16 };
    for theta in [7.0, -50.0, 100.0, 1e4, 1e6] {
        let turns = (theta / (2.0 * PI)).round();
        let exact = Dd::from(theta) - pi * (2.0 * turns).into();
        let angle = SO2::from_angle(Interval::point(theta)).angle().unwrap();
        assert!(exact.in_interval(&angle), "{theta}: {exact:?} is not in {angle:?}");
        assert!(angle.width() <= 4.0 * f64::EPSILON * theta.abs());
    }
}
