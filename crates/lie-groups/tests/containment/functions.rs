//! exp, Jacobians and their inverses over boxes of tangent vectors contain the dense double-double images of their points.

use lie_groups::{GroupError, LieGroup, Rn, SE2, SO2};
use nalgebra::SVector;
use scalars::Interval;

use crate::boxes::{Boxed, point_of, tangents};
use crate::support::dense::Dense;
use crate::support::random::{Random, SEED, cases};

/// Points per box.
const POINTS: usize = 10;

/// Points judged.
#[derive(Default)]
struct Counts {
    all: usize,
    inverses: usize,
}

fn sweep<B: Boxed<N, D>, const N: usize, const D: usize>(name: &str) {
    let mut random = Random::new(name);
    let mut counts = Counts::default();
    // Not every box has inverse Jacobians: more boxes until these too have seen their number of points.
    while counts.inverses < cases(100_000) {
        let bounds: SVector<Interval, N> = tangents(&mut random);
        let exp = B::exp(&bounds).matrix();
        let adjoint = B::exp(&bounds).adjoint();
        let (jl, jr) = (B::jl(&bounds), B::jr(&bounds));
        let inverses = match (B::jl_inv(&bounds), B::jr_inv(&bounds)) {
            (Ok(left), Ok(right)) => Some((left, right)),
            (Err(GroupError::FullTurn { .. }), Err(GroupError::FullTurn { .. })) => {
                assert!(bounds[0].mag() > std::f64::consts::TAU, "{bounds:?}");
                None
            }
            other => panic!("{name} at {bounds:?}: {other:?}"),
        };
        for _ in 0..POINTS {
            let xi = point_of(&mut random, &bounds);
            let judge = |what: &str, escape: Option<(usize, usize)>| {
                assert!(escape.is_none(), "{name}: {what} of {xi:?} in {bounds:?} escapes at {escape:?}");
            };
            judge("exp", Dense::exact(&B::Point::hat(&xi)).phi(0).escapes(&exp));
            let ad = Dense::exact(&B::Point::ad(&xi));
            let (left, right) = ad.phi_both_signs(1);
            judge("Ad exp", ad.exp_from_phi1(&left).escapes(&adjoint));
            judge("Jl", left.escapes(&jl));
            judge("Jr", right.escapes(&jr));
            counts.all += 1;
            if let Some((jl_inv, jr_inv)) = &inverses {
                judge("Jl^-1", left.inverse().escapes(jl_inv));
                judge("Jr^-1", right.inverse().escapes(jr_inv));
                counts.inverses += 1;
            }
        }
    }
    println!(
        "{name}: seed {SEED:#x}, {} points through exp, Ad, Jl, Jr, {} through the inverses",
        counts.all, counts.inverses
    );
}

#[test]
fn so2_contains_exact_images() {
    sweep::<SO2<Interval>, 1, 2>("SO2");
}

#[test]
fn se2_contains_exact_images() {
    sweep::<SE2<Interval>, 3, 2>("SE2");
}

#[test]
fn rn_contains_exact_images() {
    sweep::<Rn<Interval, 3>, 3, 3>("R3");
}
