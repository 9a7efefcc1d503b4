//! Single steps of random polynomial systems from states that are floats, against exact rationals: ten thousand for all filters together,
//! and for each of them in a soak of factor 4.

use estimators::{
    CzFilter, CzOptions, Estimator, LinearCz, LinearOptions, LinearSystem, Method, Rcz, RczOptions, Relation,
    SetFilter, System, Tier, Zf, ZfOptions, ZonotopeFilter, ZonotopeOptions,
};
use nonlin_bounds::{Form, Function};
use num_rational::BigRational;
use scalars::{Interval, Scalar};
use setrep::{Complexity, ConstrainedZonotope, Matrix, StripRule, SupportFunction, Workspace, Zonotope};

use crate::support::{Random, cases};

/// The exact value of a finite number.
fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

/// A monomial: coefficient and exponents.
type Monomial = (f64, Vec<i32>);

/// Sums of monomials, one sum an output.
#[derive(Debug, Clone)]
struct Polynomials {
    variables: usize,
    outputs: Vec<Vec<Monomial>>,
}

impl Polynomials {
    /// Up to four monomials an output, of degree three at most, in the first `states` variables, and `s_i(x) w_i` for each of the others that
    /// there is an output for: noises enter linearly, with a constant factor now and then.
    fn random(states: usize, noises: usize, outputs: usize, random: &mut Random) -> Self {
        let variables = states + noises;
        let monomial = |degree: usize, random: &mut Random| {
            let mut exponents = vec![0; variables];
            for _ in 0..random.below(degree + 1) {
                exponents[random.below(states)] += 1;
            }
            (random.unit(), exponents)
        };
        let output = |i: usize, random: &mut Random| {
            let mut sum: Vec<Monomial> = (0..=random.below(4)).map(|_| monomial(3, random)).collect();
            if i < noises {
                let (_, mut exponents) = monomial(random.below(2), random);
                exponents[states + i] = 1;
                sum.push((1.0 + 0.5 * random.unit(), exponents));
            }
            sum
        };
        Self { variables, outputs: (0..outputs).map(|i| output(i, random)).collect() }
    }

    /// The exact value of an output.
    fn exact(&self, output: usize, x: &[BigRational]) -> BigRational {
        let monomial = |(a, exponents): &Monomial| {
            let powers = exponents.iter().zip(x).filter(|(k, _)| **k > 0);
            powers.fold(rational(*a), |product, (&k, x)| product * x.pow(k))
        };
        self.outputs[output].iter().map(monomial).sum()
    }
}

impl Function for Polynomials {
    fn variables(&self) -> usize {
        self.variables
    }
    fn outputs(&self) -> usize {
        self.outputs.len()
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        for (y, monomials) in y.iter_mut().zip(&self.outputs) {
            *y = monomials.iter().fold(S::zero(), |sum, (a, exponents)| {
                let powers = exponents.iter().zip(x).filter(|(k, _)| **k > 0);
                sum + powers.fold(S::from_f64(*a), |product, (&k, &x)| product * x.powi(k))
            });
        }
    }
}

/// A system, a first set, a state of it, a measurement of that state and the state that follows.
struct Case {
    system: System,
    set: ConstrainedZonotope,
    x: Vec<f64>,
    y: Vec<f64>,
    next: Vec<BigRational>,
}

/// A multiple of `1 / 64` in `[-1, 1]`, the ends often.
fn coordinate(random: &mut Random) -> f64 {
    if random.below(3) == 0 { random.sign() } else { (64.0 * random.unit()).round() / 64.0 }
}

/// A zonotope of small dyadic numbers around a center, and a point of it, exactly.
fn zonotope(center: &[f64], columns: usize, scale: f64, random: &mut Random) -> (Zonotope, Vec<f64>) {
    let n = center.len();
    let (mut generators, mut point) = (Matrix::zeros(n, columns), center.to_vec());
    for j in 0..columns {
        let xi = coordinate(random);
        for (i, x) in point.iter_mut().enumerate() {
            generators[(i, j)] = scale * (64.0 * random.unit()).round() / 64.0;
            *x += generators[(i, j)] * xi;
        }
    }
    (Zonotope::new(center, &generators).unwrap(), point)
}

impl Case {
    /// A case; none if no measurement near the value was proven to be one.
    fn random(random: &mut Random) -> Option<Self> {
        let n = 1 + random.below(3);
        let noises = 1 + random.below(n);
        let dynamics = Polynomials::random(n, noises, n, random);
        let outputs = 1 + random.below(3);
        let measurement = Polynomials::random(n, outputs, outputs, random);
        let center: Vec<f64> = (0..n).map(|_| (32.0 * random.unit()).round() / 16.0).collect();
        let scale = 0.5_f64.powi(random.below(12) as i32);
        let (set, x) = zonotope(&center, n + random.below(3), scale, random);
        let exact: Vec<BigRational> = x.iter().map(|&x| rational(x)).collect();

        let wind = 0.25 * 0.5_f64.powi(random.below(12) as i32);
        let (process, w) = if random.below(2) == 0 {
            // Noises that mix.
            zonotope(&vec![0.0; noises], noises + 1, wind, random)
        } else {
            let w: Vec<f64> = (0..noises).map(|_| wind * coordinate(random)).collect();
            (Zonotope::from_box(&vec![0.0; noises], &vec![wind; noises]).unwrap(), w)
        };
        let bound = 0.5_f64.powi(random.below(12) as i32);
        let v: Vec<f64> = (0..outputs).map(|_| bound * coordinate(random)).collect();
        let variables: Vec<BigRational> = exact.iter().cloned().chain(v.iter().map(|&v| rational(v))).collect();
        let y: Option<Vec<f64>> = (0..outputs).map(|i| measured(&measurement, i, &exact, &variables, bound)).collect();

        let variables: Vec<BigRational> = exact.into_iter().chain(w.iter().map(|&w| rational(w))).collect();
        let next = (0..n).map(|i| dynamics.exact(i, &variables)).collect();
        let output = Zonotope::from_box(&vec![0.0; outputs], &vec![bound; outputs]).unwrap();
        let system = System::new(Relation::new(dynamics), process, Relation::new(measurement), output).unwrap();
        Some(Self { system, set: set.into(), x, y: y?, next })
    }
}

/// A float `y` near `g_i(x, v)` with `y = g_i(x, v')` for a `v'` proven within the bound: often one at the bound.
fn measured(g: &Polynomials, i: usize, x: &[BigRational], variables: &[BigRational], bound: f64) -> Option<f64> {
    let at = |v: f64| {
        let mut variables: Vec<BigRational> = x.to_vec();
        variables.resize(g.variables, rational(0.0));
        variables[x.len() + i] = rational(v);
        g.exact(i, &variables)
    };
    let (below, above) = (at(-bound).min(at(bound)), at(-bound).max(at(bound)));
    let middle = to_f64(&at(0.0));
    let mut y = to_f64(&g.exact(i, variables));
    for _ in 0..4 {
        if (&below..=&above).contains(&&rational(y)) {
            return Some(y);
        }
        y = if y > middle { y.next_down() } else { y.next_up() };
    }
    None
}

/// The number nearest to a rational, up to an ulp.
fn to_f64(x: &BigRational) -> f64 {
    use num_traits::ToPrimitive;
    x.to_f64().unwrap()
}

/// The exact state lies in the hull, and within the supports of the set in some directions.
fn check<S: SupportFunction>(hull: &[Interval], set: &S, x: &[BigRational], random: &mut Random, what: &str) {
    let inside = |side: &Interval, x: &BigRational| {
        side.is_bounded() && (&rational(side.lo())..=&rational(side.hi())).contains(&x)
    };
    assert!(hull.iter().zip(x).all(|(side, x)| inside(side, x)), "hull, {what}");
    let mut workspace = Workspace::new();
    for _ in 0..4 {
        let direction: Vec<f64> = (0..x.len()).map(|_| random.unit()).collect();
        let support = set.support(&direction, &mut workspace).unwrap();
        let along: BigRational = direction.iter().zip(x).map(|(&d, x)| rational(d) * x).sum();
        assert!(support == f64::INFINITY || along <= rational(support), "support along {direction:?}, {what}");
    }
}

/// One update and one prediction of a filter.
fn single_step<M: Method>(filter: SetFilter<M>, case: &Case, random: &mut Random, what: &str) {
    single_step_of(filter, SetFilter::hull, (&case.x, &case.y, &case.next), random, what);
}

/// The same for any filter with a hull, from a state, its measurement and the state that follows.
fn single_step_of<E>(
    mut filter: E,
    hull: impl Fn(&E) -> &[Interval],
    (x, y, next): (&[f64], &[f64], &[BigRational]),
    random: &mut Random,
    what: &str,
) where
    E: Estimator<Input = [f64], Output = [f64], Set: SupportFunction>,
{
    let state: Vec<BigRational> = x.iter().map(|&x| rational(x)).collect();
    filter.update(y).unwrap_or_else(|error| panic!("update, {what}: {error}"));
    check(hull(&filter), filter.enclosure(), &state, random, &format!("update, {what}"));
    filter.predict(&[]).unwrap_or_else(|error| panic!("prediction, {what}: {error}"));
    check(hull(&filter), filter.enclosure(), next, random, &format!("prediction, {what}"));
}

const SEED: u64 = 61;

#[test]
fn single_steps_of_rcz_contain_the_exact_states() {
    let mut random = Random::new(SEED);
    let (mut steps, mut cut) = (0, 0);
    for index in 0..cases(2_625) {
        let Some(case) = Case::random(&mut random) else { continue };
        let n = case.x.len();
        let tier = if index % 4 == 3 { Tier::Rescaling } else { Tier::LinearPrograms };
        let options = RczOptions { tier, ..if index % 2 == 0 { RczOptions::fast(n) } else { RczOptions::slow(n) } };
        let filter = Rcz::new(case.system.clone(), case.set.clone(), options).unwrap();
        // The measurement says something.
        if index % 8 == 0 {
            let mut updated = filter.clone();
            updated.update(&case.y).unwrap();
            let width = |filter: &Rcz| filter.hull().iter().map(Interval::width).sum::<f64>();
            cut += usize::from(width(&updated) < 0.9 * width(&filter));
        }
        single_step(filter, &case, &mut random, &format!("seed {SEED}, case {index}"));
        steps += 1;
    }
    println!("{steps} steps; of every eighth, {cut} updates narrowed the hull by a tenth");
    assert!(steps >= cases(2_500));
    assert!(cut * 8 >= steps / 4, "{cut}");
}

#[test]
fn single_steps_of_czmv_and_czfo_contain_the_exact_states() {
    let mut random = Random::new(SEED + 1);
    let mut steps = 0;
    for index in 0..cases(2_625) {
        let Some(case) = Case::random(&mut random) else { continue };
        let limit = Some(Complexity { generators: 8, constraints: 3 });
        let options = if index % 2 == 0 { CzOptions::czmv(limit) } else { CzOptions::czfo(limit) };
        let filter = CzFilter::new(case.system.clone(), case.set.clone(), options).unwrap();
        single_step(filter, &case, &mut random, &format!("seed {SEED}+1, case {index}"));
        steps += 1;
    }
    println!("{steps} steps");
    assert!(steps >= cases(2_500));
}

#[test]
fn single_steps_of_zonotope_filters_contain_the_exact_states() {
    let mut random = Random::new(SEED + 2);
    let (mut steps, mut cut) = (0, 0);
    for index in 0..cases(2_625) {
        let Some(case) = Case::random(&mut random) else { continue };
        let set = case.set.unconstrained().clone();
        let what = format!("seed {SEED}+2, case {index}");
        let before: f64 = case.set.unconstrained().interval_hull().iter().map(Interval::width).sum();
        let mut narrowed = |hull: &[Interval]| {
            cut += usize::from(hull.iter().map(Interval::width).sum::<f64>() < 0.9 * before);
        };
        if index % 2 == 0 {
            let options = if index % 4 == 0 { ZonotopeOptions::zmv(8) } else { ZonotopeOptions::zfo(8) };
            let options = if index % 8 < 4 { options.with_rows() } else { options };
            let filter = ZonotopeFilter::new(case.system.clone(), set, options).unwrap();
            let mut updated = filter.clone();
            updated.update(&case.y).unwrap();
            narrowed(updated.hull());
            single_step(filter, &case, &mut random, &what);
        } else {
            let options = ZfOptions {
                strips: [Form::MeanValue, Form::Taylor, Form::Natural][index % 3],
                tighten: index % 4 == 1,
                ..ZfOptions::new(8).with_rule([StripRule::Volume, StripRule::Segments][index / 4 % 2])
            };
            let filter = Zf::new(case.system.clone(), set, options).unwrap();
            let mut updated = filter.clone();
            updated.update(&case.y).unwrap();
            narrowed(updated.hull());
            single_step(filter, &case, &mut random, &what);
        }
        steps += 1;
    }
    println!("{steps} steps, {cut} updates narrowed the hull by a tenth");
    assert!(steps >= cases(2_500));
    assert!(cut * 8 >= steps, "{cut}");
}

/// `[A B]` as the coefficients of sums of monomials.
fn linear(a: &Matrix, b: &Matrix) -> Polynomials {
    let variables = a.cols() + b.cols();
    let monomial = |k: usize, a: f64| (a, (0..variables).map(|j| i32::from(j == k)).collect());
    let row = |i: usize| {
        let states = (0..a.cols()).map(|k| monomial(k, a[(i, k)]));
        states.chain((0..b.cols()).map(|k| monomial(a.cols() + k, b[(i, k)]))).collect()
    };
    Polynomials { variables, outputs: (0..a.rows()).map(row).collect() }
}

#[test]
fn single_steps_of_the_linear_filter_contain_the_exact_states() {
    let mut random = Random::new(SEED + 3);
    let mut steps = 0;
    for index in 0..cases(2_625) {
        let (n, m, noises) = (1 + random.below(3), 1 + random.below(2), 1 + random.below(2));
        let mut matrix = |rows: usize, cols: usize| {
            let entries: Vec<f64> = (0..rows * cols).map(|_| random.unit()).collect();
            Matrix::from_column_slice(rows, cols, &entries).unwrap()
        };
        let (a, b_w, c) = (matrix(n, n), matrix(n, noises), matrix(m, n));
        let (set, x) = zonotope(&vec![0.25; n], n + random.below(3), 1.0, &mut random);
        let (w, w_at) = zonotope(&vec![0.0; noises], noises + 1, 0.125, &mut random);
        let bound = 0.5_f64.powi(random.below(12) as i32);
        let exact: Vec<BigRational> = x.iter().map(|&x| rational(x)).collect();
        let measurement = linear(&c, &Matrix::identity(m));
        let drawn = (0..m).map(|_| rational(bound * coordinate(&mut random)));
        let variables: Vec<BigRational> = exact.iter().cloned().chain(drawn).collect();
        let y: Option<Vec<f64>> = (0..m).map(|i| measured(&measurement, i, &exact, &variables, bound)).collect();
        let Some(y) = y else { continue };
        let variables: Vec<BigRational> = exact.into_iter().chain(w_at.iter().map(|&w| rational(w))).collect();
        let dynamics = linear(&a, &b_w);
        let next: Vec<BigRational> = (0..n).map(|i| dynamics.exact(i, &variables)).collect();

        let v = Zonotope::from_box(&vec![0.0; m], &vec![bound; m]).unwrap();
        let still = ConstrainedZonotope::from_box(&vec![0.0; n], &vec![0.0; n]).unwrap();
        let system = LinearSystem { b_w, w: w.into(), ..LinearSystem::new(a, still, c, v.into()).unwrap() };
        let limit = (index % 2 == 0).then_some(Complexity { generators: 6, constraints: 2 });
        let filter = LinearCz::new(system, set.into(), LinearOptions { limit, ..LinearOptions::default() }).unwrap();
        let what = format!("seed {SEED}+3, case {index}");
        single_step_of(filter, LinearCz::hull, (&x, &y, &next), &mut random, &what);
        steps += 1;
    }
    println!("{steps} steps");
    assert!(steps >= cases(2_500));
}
