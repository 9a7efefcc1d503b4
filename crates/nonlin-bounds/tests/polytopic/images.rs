//! Containment of images of exact points.

use nonlin_bounds::{DynFunction, Expansion, Function, Jet, Order, Workspace, polytopic_image};
use scalars::Interval;
use setrep::{IntervalVector, Matrix, Membership, VPolytope};

use crate::common::functions::{Domain, Visitor, each};
use crate::common::random::{Random, cases};
use crate::polynomials::{Polynomials, expansion_point, member, polytope};

const SEED: u64 = 41;

/// The image of a member with few bits is an exact float vector; half-spaces and vertices of the enclosure hold it.
#[test]
fn images_of_exact_members_under_polynomials_are_inside() {
    let (mut workspace, mut points) = (Workspace::new(), 0);
    for case in 0..cases(800) {
        let random = &mut Random::new(SEED, case);
        let (n, m) = (1 + random.below(3), 1 + random.below(3));
        let (f, set) = (Polynomials::random(random, n, m), polytope(random, n));
        let at = expansion_point(random, &set);
        let image = polytopic_image(&f, &set, Expansion::Point(&at), &[], &mut workspace).unwrap();
        let half_spaces = image.to_h_polytope().unwrap();
        for k in 0..30 {
            let y = IntervalVector::point(&f.exact(&member(random, &set)));
            assert_ne!(
                half_spaces.membership(&y).unwrap(),
                Membership::ProvenOutside,
                "seed {SEED}, case {case}: {y:?}"
            );
            if k == 0 {
                assert_ne!(image.membership(&y).unwrap(), Membership::ProvenOutside, "seed {SEED}, case {case}");
            }
            points += 1;
        }
    }
    assert!(points >= 20_000);
}

struct Smooth<'a> {
    workspace: &'a mut Workspace,
    points: usize,
}

impl Visitor for Smooth<'_> {
    /// Points of the box as vertices, vertices as members: their images are enclosed, and proven outside if disjoint.
    fn visit<F: Function + 'static>(&mut self, f: F, domain: Domain) {
        let n = Function::variables(&f);
        if n > 4 || Function::outputs(&f) > 4 {
            return;
        }
        let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
        let mut jet = Jet::new();
        for case in 0..cases(40) {
            let random = &mut Random::new(SEED, case);
            let sides = random.subbox(&domain.center, &domain.radius);
            let mut vertices = Matrix::zeros(n, 0);
            (0..2 + random.below(5)).for_each(|_| vertices.push_col(&random.point(&sides)).unwrap());
            let set = VPolytope::new(vertices).unwrap();
            let at = expansion_point(random, &set);
            let image = polytopic_image(&f, &set, Expansion::Point(&at), &p, self.workspace).unwrap();
            let half_spaces = image.to_h_polytope().unwrap();
            for vertex in set.vertices().columns() {
                f.enclose(Order::Value, &IntervalVector::point(vertex), &p, &mut jet).unwrap();
                let verdict = half_spaces.membership(jet.values()).unwrap();
                assert_ne!(verdict, Membership::ProvenOutside, "{}, seed {SEED}, case {case}", domain.name);
                self.points += 1;
            }
        }
    }
}

#[test]
fn images_under_the_models_are_inside() {
    let mut smooth = Smooth { workspace: &mut Workspace::new(), points: 0 };
    each(&mut smooth);
    assert!(smooth.points > 1000);
}
