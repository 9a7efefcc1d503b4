//! Laws of the algebra as equalities of sets, the same for every type: one line a type at the end.
//!
//! Two sets are equal if their supports are; each support is an upper bound, so the two agree to the width of that bound and neither is
//! below the exact value at a member. The numbers are multiples of 1/8, so members of sums and images are exact.

use setrep::{
    ConstrainedZonotope, HPolytope, IntervalVector, Matrix, SupportFunction, VPolytope, Workspace, Zonotope,
    ZonotopeBundle,
};

use crate::common::dyadic::Dyadic;
use crate::common::exact::{exact, image, member, sum, times};
use crate::common::random::{Random, cases};

const SEED: u64 = 13;

/// A type whose operations are put to the test; an operation that a type does not have is `None`.
trait Lawful: SupportFunction + Clone + core::fmt::Debug {
    /// Supports of equal sets agree to this share of the sets' size.
    const AGREEMENT: f64;

    /// A set that contains the origin, and a member.
    fn draw(random: &mut Random, n: usize) -> (Self, Vec<Dyadic>);

    fn plus(&self, _other: &Self) -> Option<Self> {
        None
    }

    fn mapped(&self, _map: &Matrix) -> Option<Self> {
        None
    }

    fn met(&self, _other: &Self) -> Option<Self> {
        None
    }

    fn times(&self, factor: f64) -> Option<Self> {
        self.mapped(&Matrix::from_diagonal(&vec![factor; self.dim()]))
    }
}

/// Multiples of 1/8 in `[-2, 2]`.
fn eighths(random: &mut Random, rows: usize, cols: usize) -> Matrix {
    let data: Vec<f64> = (0..rows * cols).map(|_| random.between(0, 32) as f64 / 8.0 - 2.0).collect();
    Matrix::from_column_slice(rows, cols, &data).unwrap()
}

/// A zonotope around the origin: its center is minus a point of the centered one.
fn zonotope(random: &mut Random, n: usize) -> (Zonotope, Vec<f64>) {
    let m = random.between(1, 6);
    let generators = eighths(random, n, m);
    let xi: Vec<f64> = (0..m).map(|_| random.between(0, 8) as f64 / 8.0 - 0.5).collect();
    let center: Vec<f64> = times(&generators, &xi).iter().map(|x| -x.approx()).collect();
    (Zonotope::new(&center, &generators).unwrap(), xi)
}

impl Lawful for IntervalVector {
    const AGREEMENT: f64 = 1e-14;

    fn draw(random: &mut Random, n: usize) -> (Self, Vec<Dyadic>) {
        let (set, _) = zonotope(random, n);
        let x = member(&set, random).x;
        (set.interval_hull(), x)
    }

    fn met(&self, other: &Self) -> Option<Self> {
        Some(self.iter().zip(other.iter()).map(|(a, b)| a.intersection(*b)).collect())
    }
}

impl Lawful for Zonotope {
    const AGREEMENT: f64 = 1e-14;

    fn draw(random: &mut Random, n: usize) -> (Self, Vec<Dyadic>) {
        let (set, _) = zonotope(random, n);
        let x = member(&set, random).x;
        (set, x)
    }

    fn plus(&self, other: &Self) -> Option<Self> {
        Some(self.minkowski_sum(other).unwrap())
    }

    fn mapped(&self, map: &Matrix) -> Option<Self> {
        Some(self.linear_map(map).unwrap())
    }

    fn times(&self, factor: f64) -> Option<Self> {
        let mut scaled = self.clone();
        scaled.scale(factor).unwrap();
        Some(scaled)
    }
}

impl Lawful for ConstrainedZonotope {
    const AGREEMENT: f64 = 1e-11;

    fn draw(random: &mut Random, n: usize) -> (Self, Vec<Dyadic>) {
        let (body, xi) = zonotope(random, n);
        let x = member(&body, random);
        // A row whose range holds the origin and the member.
        let row = eighths(random, 1, body.num_generators());
        let ends = [&times(&row, &xi)[0], &times(&row, &x.xi)[0]].map(Dyadic::approx);
        let range = scalars::Interval::point(ends[0]).hull(scalars::Interval::point(ends[1])).inflate(0.125);
        (Self::with_constraints(&body, &row, &[range]).unwrap(), x.x)
    }

    fn plus(&self, other: &Self) -> Option<Self> {
        Some(self.minkowski_sum(other).unwrap())
    }

    fn mapped(&self, map: &Matrix) -> Option<Self> {
        Some(self.linear_map(map).unwrap())
    }

    fn met(&self, other: &Self) -> Option<Self> {
        let mut both = self.clone();
        both.intersect(&Matrix::identity(self.dim()), other, &mut Workspace::new()).unwrap();
        Some(both)
    }

    fn times(&self, factor: f64) -> Option<Self> {
        let mut scaled = self.clone();
        scaled.scale(factor).unwrap();
        Some(scaled)
    }
}

impl Lawful for ZonotopeBundle {
    const AGREEMENT: f64 = 1e-11;

    /// Two zonotopes around the origin and a vertex `x` of the first: the second is one around the origin plus the segment to `x`.
    fn draw(random: &mut Random, n: usize) -> (Self, Vec<Dyadic>) {
        let ((first, _), (second, _)) = (zonotope(random, n), zonotope(random, n));
        let signs: Vec<f64> =
            (0..first.num_generators()).map(|_| if random.below(2) == 0 { 1.0 } else { -1.0 }).collect();
        let x = sum(&exact(first.center()), &times(first.generators(), &signs));
        let half: Vec<f64> = x.iter().map(|x| 0.5 * x.approx()).collect();
        let segment = Zonotope::new(&half, &Matrix::from_columns(&[&half]).unwrap()).unwrap();
        (Self::new(vec![first, second.minkowski_sum(&segment).unwrap()]).unwrap(), x)
    }

    fn mapped(&self, map: &Matrix) -> Option<Self> {
        Some(self.linear_map(map).unwrap())
    }

    fn met(&self, other: &Self) -> Option<Self> {
        let mut both = self.clone();
        both.intersect_bundle(other).unwrap();
        Some(both)
    }
}

impl Lawful for VPolytope {
    const AGREEMENT: f64 = 1e-12;

    /// With the origin inside: cuts of flat hulls by rounded half-spaces enclose, but are not equal to rounding.
    fn draw(random: &mut Random, n: usize) -> (Self, Vec<Dyadic>) {
        let m = random.between(1, 6);
        let mut points = eighths(random, n, m);
        for k in 0..2 * n {
            let axis: Vec<f64> = (0..n).map(|i| if i == k / 2 { 0.125 - 0.25 * (k % 2) as f64 } else { 0.0 }).collect();
            points.push_col(&axis).unwrap();
        }
        let x = exact(points.col(random.below(points.cols())));
        (Self::new(points).unwrap(), x)
    }

    fn plus(&self, other: &Self) -> Option<Self> {
        (self.dim() == 2).then(|| self.minkowski_sum_2d(other).unwrap())
    }

    fn mapped(&self, map: &Matrix) -> Option<Self> {
        Some(self.linear_map(map).unwrap())
    }

    fn met(&self, other: &Self) -> Option<Self> {
        Some(self.intersection(&other.to_h_polytope().unwrap()).unwrap())
    }
}

impl Lawful for HPolytope {
    const AGREEMENT: f64 = 1e-11;

    fn draw(random: &mut Random, n: usize) -> (Self, Vec<Dyadic>) {
        let m = random.between(1, 6);
        let mut points = eighths(random, n, m);
        points.push_col(&vec![0.0; n]).unwrap();
        let x = exact(points.col(random.below(m + 1)));
        (VPolytope::new(points).unwrap().to_h_polytope().unwrap(), x)
    }

    fn met(&self, other: &Self) -> Option<Self> {
        Some(self.intersection(other).unwrap())
    }
}

/// One draw: three sets of a type with members, a map, directions.
struct Draw<T> {
    sets: [(T, Vec<Dyadic>); 3],
    map: Matrix,
    directions: Matrix,
    context: String,
}

fn for_each_draw<T: Lawful>(law: impl Fn(&Draw<T>, &mut Workspace)) {
    let mut workspace = Workspace::new();
    for case in 0..cases(150) {
        let mut random = Random::new(SEED, case);
        let n = random.between(1, 4);
        let sets = core::array::from_fn(|_| T::draw(&mut random, n));
        let (map, directions) = (eighths(&mut random, n, n), eighths(&mut random, n, 6));
        law(&Draw { sets, map, directions, context: format!("seed {SEED} case {case}") }, &mut workspace);
    }
}

impl<T: Lawful> Draw<T> {
    /// Equal sets, both with the given member.
    fn assert_same(&self, left: Option<T>, right: Option<T>, x: &[Dyadic], workspace: &mut Workspace) {
        let (Some(left), Some(right)) = (left, right) else { return };
        let mut points = Matrix::zeros(0, 0);
        let a = left.support_vectors(&self.directions, &mut points, workspace).unwrap();
        let b = right.support_vectors(&self.directions, &mut points, workspace).unwrap();
        let hull = left.interval_hull(workspace).unwrap();
        for (k, d) in self.directions.columns().enumerate() {
            let magnitude: f64 = d.iter().zip(hull.iter()).map(|(d, side)| d.abs() * (1.0 + side.mag())).sum();
            let close = (a[k] - b[k]).abs() <= T::AGREEMENT * magnitude;
            assert!(
                close,
                "{}: supports {} and {} in {d:?} of {left:?} and {right:?}, from {:?}",
                self.context, a[k], b[k], self.sets
            );
            let reached = exact(d).iter().zip(x).fold(Dyadic::zero(), |sum, (d, x)| &sum + &(d * x));
            let above = Dyadic::from(a[k]) >= reached && Dyadic::from(b[k]) >= reached;
            assert!(above, "{}: a member is at {} beyond {} or {}", self.context, reached.approx(), a[k], b[k]);
        }
    }
}

fn sums_commute_and_associate<T: Lawful>() {
    for_each_draw::<T>(|draw, workspace| {
        let [(x, p), (y, q), (z, r)] = &draw.sets;
        draw.assert_same(x.plus(y), y.plus(x), &sum(p, q), workspace);
        let left = x.plus(y).and_then(|xy| xy.plus(z));
        let right = y.plus(z).and_then(|yz| x.plus(&yz));
        draw.assert_same(left, right, &sum(&sum(p, q), r), workspace);
    });
}

fn maps_are_linear<T: Lawful>() {
    for_each_draw::<T>(|draw, workspace| {
        let [(x, p), (y, q), _] = &draw.sets;
        let whole = x.plus(y).and_then(|sum| sum.mapped(&draw.map));
        let parts = x.mapped(&draw.map).zip(y.mapped(&draw.map)).and_then(|(x, y)| x.plus(&y));
        draw.assert_same(whole, parts, &image(&draw.map, &sum(p, q)), workspace);
        let scaled_first = x.times(-1.5).and_then(|x| x.mapped(&draw.map));
        let scaled_last = x.mapped(&draw.map).and_then(|x| x.times(-1.5));
        let scaled = image(&Matrix::from_diagonal(&vec![-1.5; p.len()]), &image(&draw.map, p));
        draw.assert_same(scaled_first, scaled_last, &scaled, workspace);
        // 2 X = X + X, as X is convex.
        draw.assert_same(x.times(2.0), x.plus(x), &sum(p, p), workspace);
    });
}

fn intersections_are_those_of_sets<T: Lawful>() {
    for_each_draw::<T>(|draw, workspace| {
        let [(x, _), (y, _), (z, _)] = &draw.sets;
        // All three contain the origin.
        let origin = vec![Dyadic::zero(); x.dim()];
        draw.assert_same(x.met(y), y.met(x), &origin, workspace);
        let left = x.met(y).and_then(|xy| xy.met(z));
        let right = y.met(z).and_then(|yz| x.met(&yz));
        draw.assert_same(left, right, &origin, workspace);
        draw.assert_same(x.met(x), Some(x.clone()), &origin, workspace);
        // Absorption: X and (X and Y) is X and Y.
        let again = x.met(y).and_then(|both| x.met(&both));
        draw.assert_same(again, x.met(y), &origin, workspace);
    });
}

fn hulls_are_monotone<T: Lawful>() {
    for_each_draw::<T>(|draw, workspace| {
        let [(x, p), (y, _), _] = &draw.sets;
        let hull = x.interval_hull(workspace).unwrap();
        assert!(
            p.iter().zip(hull.iter()).all(|(x, side)| Dyadic::from(side.lo()) <= *x && *x <= Dyadic::from(side.hi()))
        );
        if let Some(both) = x.met(y) {
            let slack = T::AGREEMENT * (1.0 + hull.iter().map(scalars::Interval::mag).fold(0.0, f64::max));
            for (inner, outer) in both.interval_hull(workspace).unwrap().iter().zip(hull.iter()) {
                assert!(inner.subset_of(&outer.inflate(slack)), "{}: {inner} in {outer}", draw.context);
            }
        }
        for d in draw.directions.columns() {
            let reach = hull.support(d, workspace).unwrap();
            let slack = T::AGREEMENT * (1.0 + reach.abs()) * 8.0;
            assert!(x.support(d, workspace).unwrap() <= reach + slack, "{}: a hull is around its set", draw.context);
        }
    });
}

macro_rules! laws_of {
    ($($name:ident: $set:ty;)*) => {
        $(mod $name {
            #[test] fn sums() { super::sums_commute_and_associate::<$set>(); }
            #[test] fn maps() { super::maps_are_linear::<$set>(); }
            #[test] fn intersections() { super::intersections_are_those_of_sets::<$set>(); }
            #[test] fn hulls() { super::hulls_are_monotone::<$set>(); }
        })*
    };
}

laws_of! {
    boxes: setrep::IntervalVector;
    zonotopes: setrep::Zonotope;
    constrained_zonotopes: setrep::ConstrainedZonotope;
    bundles: setrep::ZonotopeBundle;
    vertex_polytopes: setrep::VPolytope;
    half_space_polytopes: setrep::HPolytope;
}
