//! Random sets with points that are known exactly, and the check of points against supports.

use nonlin_bounds::Workspace;
use num_rational::BigRational;
use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Zonotope};

use crate::common::polynomial::rational;
use crate::common::random::Random;

/// A constrained zonotope with points of it; every number is a multiple of a small power of two, so that the points are exact.
pub(crate) struct Generated {
    pub(crate) set: ConstrainedZonotope,
    pub(crate) points: Vec<Vec<f64>>,
}

/// A multiple of `1 / 64` in `[-1, 1]`, the ends now and then.
fn sixty_fourth(random: &mut Random) -> f64 {
    (64.0 * random.unit()).round() / 64.0
}

impl Generated {
    /// A set of up to five generators within about `center +- radius`, with up to two constraints.
    pub(crate) fn within(center: &[f64], radius: &[f64], constraints: bool, random: &mut Random) -> Self {
        let n = center.len();
        let center: Vec<f64> = center.iter().map(|c| (1024.0 * c).round() / 1024.0).collect();
        let columns = 1 + random.below(5);
        let scale = 0.125 * 0.5_f64.powi(random.below(8) as i32);
        let unit = |r: f64| if r > 0.0 { scale * 2.0_f64.powi(r.log2().floor() as i32) } else { 0.0 };
        let mut generators = Matrix::zeros(n, columns);
        for j in 0..columns {
            for i in 0..n {
                generators[(i, j)] = unit(radius[i]) * sixty_fourth(random);
            }
        }
        let remainder: Vec<f64> =
            radius.iter().map(|&r| if random.below(3) == 0 { 0.25 * unit(r) } else { 0.0 }).collect();
        let samples: Vec<Vec<f64>> = (0..24).map(|_| (0..columns).map(|_| sixty_fourth(random)).collect()).collect();
        let rows = if constraints { 1 + random.below(2) } else { 0 };
        let mut matrix = Matrix::zeros(rows, columns);
        let mut ranges = Vec::new();
        for i in 0..rows {
            (0..columns).for_each(|j| matrix[(i, j)] = sixty_fourth(random));
            let value = |xi: &[f64]| (0..columns).map(|j| matrix[(i, j)] * xi[j]).sum::<f64>();
            // A range that holds at least the first sample, now and then a point.
            let middle = value(&samples[0]);
            let (below, above) = match random.below(4) {
                0 => (0.0, 0.0),
                _ => (0.25 * random.below(8) as f64, 0.25 * random.below(8) as f64),
            };
            ranges.push(Interval::new(middle - below, middle + above).unwrap());
        }
        let member = |xi: &Vec<f64>| {
            (0..rows).all(|i| ranges[i].contains((0..columns).map(|j| matrix[(i, j)] * xi[j]).sum::<f64>()))
        };
        let points = samples
            .iter()
            .filter(|xi| member(xi))
            .map(|xi| {
                let point = |i: usize| {
                    let e = remainder[i] * sixty_fourth(random);
                    (0..columns).fold(center[i] + e, |x, j| x + generators[(i, j)] * xi[j])
                };
                (0..n).map(point).collect()
            })
            .collect();
        let body = Zonotope::with_remainder(&center, &generators, &remainder).unwrap();
        Self { set: ConstrainedZonotope::with_constraints(&body, &matrix, &ranges).unwrap(), points }
    }
}

/// A polytope around a set: a few directions with their supports.
pub(crate) struct Supports(Vec<(Vec<f64>, f64)>);

impl Supports {
    /// The axes and four diagonals, each both ways.
    pub(crate) fn of(set: &ConstrainedZonotope, random: &mut Random, workspace: &mut Workspace) -> Self {
        let n = set.dim();
        let mut directions: Vec<Vec<f64>> =
            (0..n).map(|i| (0..n).map(|k| if i == k { 1.0 } else { 0.0 }).collect()).collect();
        directions.extend((0..4).map(|_| (0..n).map(|_| sixty_fourth(random)).collect::<Vec<f64>>()));
        let mut optimizer = set.optimizer(&mut workspace.sets).unwrap();
        let both = directions.into_iter().flat_map(|d| [d.iter().map(|x| -x).collect(), d]);
        Self(both.map(|d: Vec<f64>| (optimizer.support(&d).unwrap(), d)).map(|(h, d)| (d, h)).collect())
    }

    /// The direction in which an exact point is proven to lie outside.
    pub(crate) fn refute(&self, x: &[BigRational]) -> Option<&[f64]> {
        let outside = |(d, h): &&(Vec<f64>, f64)| {
            d.iter().zip(x).map(|(&d, x)| rational(d) * x).sum::<BigRational>() > rational(*h)
        };
        self.0.iter().find(outside).map(|(d, _)| d.as_slice())
    }

    /// The direction in which a box is proven to lie outside as a whole.
    pub(crate) fn refute_box(&self, x: &[Interval]) -> Option<&[f64]> {
        let outside =
            |(d, h): &&(Vec<f64>, f64)| d.iter().zip(x).fold(Interval::ZERO, |sum, (&d, x)| sum + x.scale(d)).lo() > *h;
        self.0.iter().find(outside).map(|(d, _)| d.as_slice())
    }
}
