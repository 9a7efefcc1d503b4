//! Volumes of the candidates for a strip: shared minors against determinants of every candidate.

use nalgebra::DMatrix;
use scalars::Interval;
use setrep::{Matrix, SetError, StripCut, StripRule, Workspace, Zonotope};

use crate::common::random::{Random, cases};

/// `2^n` times the sum of the absolute determinants of all `n`-subsets of columns: (37), one at a time.
fn volume(columns: &[Vec<f64>]) -> f64 {
    let n = columns[0].len();
    let mut sum = 0.0;
    for mask in 0_u32..1 << columns.len() {
        if mask.count_ones() as usize == n {
            let chosen = (0..columns.len()).filter(|j| mask >> j & 1 == 1);
            let entries: Vec<f64> = chosen.flat_map(|j| columns[j].iter().copied()).collect();
            sum += DMatrix::from_column_slice(n, n, &entries).determinant().abs();
        }
    }
    2_f64.powi(n as i32) * sum
}

/// The generators of candidate `j`, (35).
fn candidate(columns: &[Vec<f64>], j: usize, a: &[f64], half_width: f64) -> Vec<Vec<f64>> {
    let along = |g: &[f64]| a.iter().zip(g).map(|(a, g)| a * g).sum::<f64>();
    let (pivot, scale) = (columns[j].clone(), along(&columns[j]));
    let changed = |(i, g): (usize, &Vec<f64>)| -> Vec<f64> {
        let share = along(g) / scale;
        g.iter().zip(&pivot).map(|(g, p)| if i == j { half_width * p / scale } else { g - share * p }).collect()
    };
    columns.iter().enumerate().map(changed).collect()
}

fn random_columns(n: usize, m: usize, random: &mut Random) -> Vec<Vec<f64>> {
    (0..m).map(|_| (0..n).map(|_| random.moderate()).collect()).collect()
}

fn set_of(columns: &[Vec<f64>]) -> Zonotope {
    let n = columns[0].len();
    Zonotope::new(&vec![0.0; n], &Matrix::from_column_slice(n, columns.len(), &columns.concat()).unwrap()).unwrap()
}

/// Relative 1e-12, n = 1..6, but for candidates whose own columns are differences of numbers ten times as long.
#[test]
fn shared_minors_are_the_volumes_of_all_candidates() {
    let (mut workspace, mut compared) = (Workspace::new(), 0);
    for case in 0..cases(400) {
        let mut random = Random::new(71, case);
        let n = random.between(1, 6);
        let columns = random_columns(n, n + random.below(7), &mut random);
        let a: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        let half_width = 0.1 + random.moderate().abs();
        let found = set_of(&columns).approx_candidate_volumes(&a, half_width, &mut workspace).unwrap().to_vec();
        assert_eq!(found.len(), columns.len() + 1);
        let whole = volume(&columns);
        assert!((found[0] - whole).abs() <= 1e-12 * whole, "case {case}: {} {whole}", found[0]);
        for j in 0..columns.len() {
            let direct = volume(&candidate(&columns, j, &a, half_width));
            let along = |g: &[f64]| a.iter().zip(g).map(|(a, g)| a * g).sum::<f64>();
            let growth = columns.iter().map(|g| (along(g) / along(&columns[j])).abs()).fold(1.0, f64::max);
            if growth <= 10.0 {
                compared += 1;
                assert!((found[j + 1] - direct).abs() <= 1e-12 * direct, "case {case}, {j}: {} {direct}", found[j + 1]);
            }
        }
    }
    println!("{compared} candidates compared");
    assert!(compared > 1000);
}

/// The rule takes the least of them; the set keeps its number of generators, and its volume is the one announced.
#[test]
fn the_volume_rule_takes_the_least() {
    let mut workspace = Workspace::new();
    let (mut cut, mut kept, mut other) = (0, 0, 0);
    for case in 0..cases(500) {
        let mut random = Random::new(72, case);
        let n = random.between(2, 4);
        let columns = random_columns(n, n + random.below(6), &mut random);
        let set = set_of(&columns);
        let a: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        let reach = set.reach(&a, &mut workspace).unwrap();
        let strip = Interval::point(0.2 * reach.rad()).inflate(reach.rad() * (0.05 + random.moderate().abs()));
        let volumes = set.approx_candidate_volumes(&a, strip.rad(), &mut workspace).unwrap();
        let least = volumes.iter().copied().fold(f64::INFINITY, f64::min);
        let mut by_volume = set.clone();
        match by_volume.intersect_whole_strip(&a, strip, StripRule::Volume, &mut workspace).unwrap() {
            StripCut::Cut => cut += 1,
            _ => kept += 1,
        }
        assert_eq!(by_volume.num_generators(), set.num_generators());
        let found = by_volume.volume().unwrap();
        assert!((found.mid() - least).abs() <= 1e-9 * least, "case {case}: {found} {least}");
        let mut by_determinant = set;
        let _ = by_determinant.intersect_whole_strip(&a, strip, StripRule::Determinant, &mut workspace).unwrap();
        other += usize::from(by_determinant.volume().unwrap().lo() > found.hi());
    }
    println!("{cut} cut, {kept} kept, {other} smaller than by determinant");
    assert!(cut > 50 && kept > 50 && other > 20);
}

/// The box remainder counts in the volumes and keeps its place; a flat set is cut within its span; a strip of width 0 still chooses.
#[test]
fn remainders_and_flat_sets_are_seen() {
    let mut workspace = Workspace::new();
    let generators = Matrix::from_columns(&[&[1.0, 0.5]]).unwrap();
    let set = Zonotope::with_remainder(&[0.0, 0.0], &generators, &[0.0, 0.25]).unwrap();
    let volumes = set.approx_candidate_volumes(&[1.0, 0.0], 0.5, &mut workspace).unwrap();
    assert_eq!(volumes, [1.0, 0.5]);
    let flat = Zonotope::new(&[0.0, 0.0], &Matrix::from_columns(&[&[1.0, 1.0], &[0.5, 0.5]]).unwrap()).unwrap();
    let mut cut = flat.clone();
    let strip = Interval::ZERO.inflate(0.25);
    assert_eq!(cut.intersect_strip(&[1.0, 0.0], strip, StripRule::Volume, &mut workspace), Ok(StripCut::Cut));
    assert!(cut.interval_hull()[0].rad() < flat.interval_hull()[0].rad());
    let mut square = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0]).unwrap();
    square.materialize();
    assert_eq!(
        square.intersect_strip(&[1.0, 0.0], Interval::ZERO, StripRule::Volume, &mut workspace),
        Ok(StripCut::Cut)
    );
    assert!(square.interval_hull()[0].rad() < 1e-14);
}

/// More minors than the limit: an error of the volumes, another rule for the cut.
#[test]
fn too_many_minors_are_refused_and_the_cut_goes_on() {
    let mut workspace = Workspace::new();
    let mut random = Random::new(73, 0);
    let columns = random_columns(4, 200, &mut random);
    let mut set = set_of(&columns);
    let a = [1.0, 0.0, 0.0, 0.0];
    let refused = set.approx_candidate_volumes(&a, 1.0, &mut workspace).unwrap_err();
    assert!(matches!(refused, SetError::TooManySubsets { .. }));
    assert_eq!(
        set.intersect_strip(&a, Interval::ZERO.inflate(0.1), StripRule::Volume, &mut workspace),
        Ok(StripCut::Cut)
    );
    assert!(set.approx_candidate_volumes(&[1.0], 1.0, &mut workspace).is_err());
    assert!(set.approx_candidate_volumes(&[1.0, f64::NAN, 0.0, 0.0], 1.0, &mut workspace).is_err());
}

/// The search allocates nothing in steady state.
#[test]
fn the_search_allocates_nothing() {
    for n in 2..6 {
        let mut random = Random::new(74, n);
        let set = set_of(&random_columns(n, n + 8, &mut random));
        let (mut workspace, mut cut) = (Workspace::new(), set.clone());
        let a = vec![1.0; n];
        let mut step = || {
            cut.clone_from(&set);
            let _ =
                cut.intersect_whole_strip(&a, Interval::ZERO.inflate(0.1), StripRule::Volume, &mut workspace).unwrap();
        };
        step();
        let counted = allocation_counter::measure(step);
        assert_eq!(counted.count_total, 0, "n = {n}");
    }
}
