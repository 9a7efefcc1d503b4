//! Problems that 16 digits do not solve: entries over many decades, rows that are nearly dependent.

use crate::common::exact::{Exact, rational};
use crate::common::random::Random;
use crate::common::{cases, dot, norm1};
use boxlp::{Emptiness, Problem, Solver, Status};
use num_traits::ToPrimitive;

/// Rows of `N` entries, each followed by its range.
fn problem<const N: usize>(rows: &[([f64; N], f64, f64)]) -> Problem {
    let mut problem = Problem::new(N).unwrap();
    for (row, lower, upper) in rows {
        problem.push_row(row, *lower, *upper).unwrap();
    }
    problem
}

/// How far the bound is above the exact maximum, as a share of `|c|_1`.
fn excess(problem: &Problem, c: &[f64]) -> f64 {
    let optimum = Exact::new(problem).maximize(c).unwrap();
    let mut solver = Solver::new(problem.clone());
    let solution = solver.maximize(c).unwrap();
    assert!(solution.status == Status::Optimal && rational(solution.bound) >= optimum, "{solution:?}");
    (rational(solution.bound) - optimum).to_f64().unwrap() / norm1(c)
}

/// Bounds that were 1.5 and 1e-6 too high, in some orders of the variables: vertices on rows that meet at angles of 1e-8.
#[test]
fn sharp_vertices_are_found() {
    let four = problem(&[
        (
            [0.001221660532550928, 29102524.73075535, 0.009969965527654327, -8.788845964580442],
            2.910252745277256e7,
            5.820505490654516e7,
        ),
        (
            [20.20445278510194, -2.9313479005109383e-5, 0.00035611264518683723, -38866318.045775615],
            8.047981831080448e6,
            1.2012073783436848e7,
        ),
        (
            [79.71684381034272, -114180.77705019923, -570.8301107256735, -1706204.0396754427],
            4.1291382313731627e5,
            6.776712516754859e5,
        ),
        (
            [-0.0015069250668954728, 1.946249567513494, 78179.79134945928, 0.10801003128489102],
            3.703213667694356e4,
            3.953792425973801e4,
        ),
    ]);
    let band = problem(&[
        (
            [0.00021716251644488883, -2.743650890668571, 0.0, 0.0, -184080.6396423705],
            -184080.64001241064,
            -184080.64001241061,
        ),
        (
            [1.1668327094709172e-5, -0.00015287762790113532, 74492952.7016622, 0.0, 1.7876313567990167],
            68644289.21816318,
            74492953.6576934,
        ),
    ]);
    assert!(excess(&four, &[-4.4761752020502414e-8, 0.0, 0.0, 0.0]) <= 1e-14);
    assert!(excess(&band, &[0.0, 0.030667519079137673, 0.2823121750060409, 0.0, -0.32319594970348664]) <= 1e-14);
}

/// A contradiction between rows of very different sizes, once undecided.
#[test]
fn contradictions_across_scales_are_proven() {
    let empty = problem(&[
        (
            [
                -346418.0924409833,
                -80014940.82816914,
                5806.267888678278,
                -2.8818814662185187e-7,
                3.8333356092957877e-7,
                0.0001448696754539011,
            ],
            80355552.65286563,
            80367165.18864447,
        ),
        (
            [
                -332.4172203959493,
                51862227.48841078,
                90.56620588733544,
                635471.9217413152,
                36700244.567305796,
                -0.0025333758976468497,
            ],
            -87926758.28549413,
            -23101720.569843806,
        ),
        (
            [
                522800.57268382725,
                0.0015822408840514364,
                561200.8449132976,
                8.271733520315934e-8,
                103311.36777138831,
                -300.4334832791443,
            ],
            -1187613.2204339507,
            -1187015.0839780814,
        ),
        (
            [
                4.132656842116895,
                -1.1741531260927492e-5,
                0.6198598046315373,
                -14615387.431296315,
                -19.567008256552437,
                4.9883422503546414e-5,
            ],
            -14615411.750882868,
            -14615372.616743078,
        ),
        (
            [
                1.854150240246145,
                2.519647425319337,
                1.1983045681659434,
                0.7737304774437945,
                -0.7242379240051104,
                2.8188991034369404,
            ],
            -9.888969738617288,
            -6.881331770461831,
        ),
    ]);
    let mut solver = Solver::new(empty.clone());
    assert!(matches!(solver.emptiness(), Emptiness::Empty(certificate) if certificate.verify(&empty)));
    assert!(Exact::new(&empty).maximize(&[0.0; 6]).is_none());
}

/// Entries over 16 decades: optimal bounds are those of the exact maximum over rows loosened by a few roundings, in either order
/// of the variables, for one objective after another.
#[test]
fn bounds_are_as_tight_as_the_rows_are_known() {
    let (mut answers, mut optimal) = (0, 0);
    for seed in 0..cases(500) as u64 {
        let mut random = Random::new(seed + 40_000);
        let (n, m) = (1 + random.below(7), 1 + random.below(5));
        let inner: Vec<f64> =
            (0..n).map(|_| if random.below(4) == 0 { random.sign() } else { random.symmetric() }).collect();
        let sparse = random.below(2) == 0;
        let mut entry = || if sparse && random.below(3) > 0 { 0.0 } else { random.sign() * random.scale(-8.0, 8.0) };
        let rows: Vec<Vec<f64>> = (0..m).map(|_| (0..n).map(|_| entry()).collect()).collect();
        let mut objectives: Vec<Vec<f64>> = (0..3).map(|_| (0..n).map(|_| entry()).collect()).collect();
        objectives.push(objectives[0].iter().map(|c| -c).collect());
        let (mut set, mut loose, mut turned) =
            (Problem::new(n).unwrap(), Problem::new(n).unwrap(), Problem::new(n).unwrap());
        for row in &rows {
            let (norm, middle) = (norm1(row), dot(row, &inner));
            let width = norm * 1e-15 + if random.below(2) == 0 { 0.0 } else { middle.abs() * random.unit() };
            set.push_row(row, middle - width, middle + width).unwrap();
            let wider = width + norm * 5e-14;
            loose.push_row(row, middle - wider, middle + wider).unwrap();
            turned.push_row(&reversed(row), middle - width, middle + width).unwrap();
        }
        let (mut exact, mut loosened) = (Exact::new(&set), Exact::new(&loose));
        let (mut straight, mut backward) = (Solver::new(set), Solver::new(turned));
        for c in &objectives {
            let optimum = exact.maximize(c).unwrap();
            let most = loosened.maximize(c).unwrap() + rational(1e-10 * norm1(c));
            for (solver, c) in [(&mut straight, c.clone()), (&mut backward, reversed(c))] {
                let solution = solver.maximize(&c).unwrap();
                let bound = rational(solution.bound);
                answers += 1;
                assert!(solution.status != Status::Empty && bound >= optimum, "seed {seed}");
                if solution.status == Status::Optimal {
                    optimal += 1;
                    let excess = || (bound.clone() - &most).to_f64().unwrap() / norm1(&c);
                    assert!(bound <= most, "seed {seed}: {:e} too high", excess());
                }
            }
        }
    }
    println!("{answers} answers, {optimal} optimal");
    assert!(optimal * 1000 >= answers * 999);
}

fn reversed(x: &[f64]) -> Vec<f64> {
    x.iter().rev().copied().collect()
}
