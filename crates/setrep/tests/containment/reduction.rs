//! Containment of exact images: reduction.

use setrep::{Matrix, Reduction, Workspace, Zonotope};

use crate::SEED;
use crate::common::dyadic::Dyadic;
use crate::common::exact::{Member, exact, is_witness, lies_in_centered, member, solve, times};
use crate::common::random::{Random, cases};

/// What the members of a reduced set are proven with.
struct Split {
    /// Coordinates of the kept columns, which are columns of the original set.
    kept: Vec<f64>,
    /// `B xi` over the columns that were enclosed.
    enclosed: Vec<Dyadic>,
}

/// Matches the first columns of the reduced set with columns of the original one.
fn split(set: &Zonotope, reduced: &Zonotope, kept: usize, member: &Member) -> Split {
    let n = set.dim();
    let mut left: Vec<usize> = (0..set.num_generators()).collect();
    let mut xi = Vec::new();
    for column in reduced.generators().columns().take(kept) {
        let position =
            left.iter().position(|&j| set.generators().col(j) == column).expect("a kept column is an original one");
        xi.push(member.xi[left.swap_remove(position)]);
    }
    let columns: Vec<&[f64]> = left.iter().map(|&j| set.generators().col(j)).collect();
    let rest: Vec<f64> = left.iter().map(|&j| member.xi[j]).collect();
    let enclosed = if columns.is_empty() {
        vec![Dyadic::zero(); n]
    } else {
        times(&Matrix::from_columns(&columns).unwrap(), &rest)
    };
    Split { kept: xi, enclosed }
}

/// The row and length of a column along an axis.
fn axis(column: &[f64]) -> Option<(usize, f64)> {
    let mut nonzero = column.iter().enumerate().filter(|(_, x)| **x != 0.0);
    let (row, &length) = nonzero.next()?;
    nonzero.next().is_none().then_some((row, length))
}

/// Proves that the member lies in the reduced set. A box tail contains `B xi` if each row is at most its length; a general frame is
/// solved exactly, the coordinates are rounded, and the remainder must absorb the rounding.
fn is_enclosed(set: &Zonotope, reduced: &Zonotope, kept: usize, member: &Member) -> bool {
    let n = set.dim();
    let Split { kept: xi, enclosed } = split(set, reduced, kept, member);
    let tail: Vec<&[f64]> = reduced.generators().columns().skip(kept).collect();
    if let Some(axes) = tail.iter().map(|g| axis(g)).collect::<Option<Vec<_>>>() {
        let mut lengths = vec![Dyadic::zero(); n];
        axes.iter().for_each(|&(row, length)| lengths[row] += &Dyadic::from(length).abs());
        let slack = |k: usize| &Dyadic::from(reduced.remainder()[k]) - &Dyadic::from(set.remainder()[k]);
        return (0..n).all(|k| enclosed[k].clone().abs() <= &lengths[k] + &slack(k) && slack(k) >= Dyadic::zero());
    }
    // Zero columns of the frame were dropped: axes stand for them, whose coordinates must come out as nothing.
    let mut frames = (0_u32..1 << n).filter(|rows| rows.count_ones() as usize == n - tail.len());
    frames.any(|rows| {
        let mut frame: Vec<Vec<Dyadic>> = tail.iter().map(|g| exact(g)).collect();
        frame.extend((0..n).filter(|k| rows >> k & 1 == 1).map(|k| exact(Matrix::identity(n).col(k))));
        let Some(zeta) = solve(&frame, &enclosed) else { return false };
        let mut witness = xi.clone();
        witness.extend(&zeta[..tail.len()]);
        is_witness(reduced, &witness, &member.x)
    }) || {
        // An ill-conditioned frame: the rounded solution is no witness. All facets of the frame with the slack decide.
        let frame: Vec<Vec<Dyadic>> = tail.iter().map(|g| exact(g)).collect();
        let slack = |k: usize| &Dyadic::from(reduced.remainder()[k]) - &Dyadic::from(set.remainder()[k]);
        lies_in_centered(&frame, &(0..n).map(slack).collect::<Vec<_>>(), &enclosed)
    }
}

fn battery(method: Reduction, seed: u64, default: usize) {
    let mut workspace = Workspace::new();
    let (mut frames, mut stripped) = (0, 0);
    for case in 0..cases(default) {
        let mut random = Random::new(seed, case);
        let n = random.between(1, 4);
        let m = random.between(n + 1, 14);
        let order = random.between(n, m - 1);
        let set = random.set(n, m);
        let mut reduced = set.clone();
        reduced.reduce(method, order, &mut workspace).unwrap();
        assert!(reduced.num_generators() <= order);
        let kept = order - n;
        let member = member(&set, &mut random);
        let context = || format!("{method:?} seed {seed} case {case} order {order}: {set:?} -> {reduced:?}");
        assert!(is_enclosed(&set, &reduced, kept, &member), "{}", context());
        // The remainder grows by rounding only.
        for k in 0..n {
            let extent: f64 = set.generators().columns().map(|g| g[k].abs()).sum();
            let growth = reduced.remainder()[k] - set.remainder()[k];
            assert!(growth <= 1e-9 * extent + 1e-15 * set.remainder()[k], "{}", context());
        }
        if reduced.remainder() != set.remainder() {
            frames += 1;
            let bare = Zonotope::with_remainder(reduced.center(), reduced.generators(), set.remainder()).unwrap();
            stripped += usize::from(!is_enclosed(&set, &bare, kept, &member));
        }
    }
    let oblique = matches!(method, Reduction::Pca | Reduction::Method4);
    assert!(!oblique || frames > default / 3, "{method:?} used its frame only {frames} times");
    assert!(!oblique || stripped > 0, "{method:?}: no case needs the rounding term");
}

#[test]
fn combastel_encloses() {
    battery(Reduction::Combastel, SEED + 10, 10_000);
}

#[test]
fn girard_encloses() {
    battery(Reduction::Girard, SEED + 11, 10_000);
}

#[test]
fn pca_encloses() {
    battery(Reduction::Pca, SEED + 12, 10_000);
}

#[test]
fn method4_encloses() {
    battery(Reduction::Method4, SEED + 13, 10_000);
}

/// With signed instead of absolute sums, as some codes of the papers have it, opposite generators cancel and the set is lost.
#[test]
fn sums_are_of_absolute_values() {
    let generators = Matrix::from_rows(&[&[4.0, 1.0, -1.0, 0.5], &[0.0, 1.0, -1.0, 0.5]]).unwrap();
    let mut set = Zonotope::new(&[0.0, 0.0], &generators).unwrap();
    set.reduce(Reduction::Combastel, 3, &mut Workspace::new()).unwrap();
    assert!(set.interval_hull()[1].contains(2.5));
}
