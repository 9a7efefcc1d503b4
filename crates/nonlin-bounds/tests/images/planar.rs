//! Areas of planar sets from support values.

use setrep::{ConstrainedZonotope, Workspace};

/// Area of a planar set: the polygon of its tangents in many directions, an upper bound that converges quadratically.
pub(crate) fn area(set: &ConstrainedZonotope, workspace: &mut Workspace) -> f64 {
    // Directions orthogonal to the generators and to those through the constraints are unknown: refine until the polygon is flat.
    let mut optimizer = set.optimizer(workspace).unwrap();
    let mut support = |angle: f64| optimizer.support(&[angle.cos(), angle.sin()]).unwrap();
    let mut lines: Vec<(f64, f64)> = (0..16)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 16.0 + 0.1)
        .map(|angle| (angle, support(angle)))
        .collect();
    let meet = |a: (f64, f64), b: (f64, f64)| {
        let determinant = (b.0 - a.0).sin();
        let x = (a.1 * b.0.sin() - b.1 * a.0.sin()) / determinant;
        let y = (b.1 * a.0.cos() - a.1 * b.0.cos()) / determinant;
        (x, y)
    };
    // Insert the direction between two neighbours until their corner is a point of the set.
    for _ in 0..40 {
        let mut refined = Vec::new();
        let mut changed = false;
        for k in 0..lines.len() {
            let (a, mut b) = (lines[k], lines[(k + 1) % lines.len()]);
            if b.0 < a.0 {
                b.0 += std::f64::consts::TAU;
            }
            refined.push(a);
            if b.0 - a.0 > 1e-7 {
                let angle = 0.5 * (a.0 + b.0);
                let (x, y) = meet(a, b);
                let value = support(angle);
                if value < angle.cos() * x + angle.sin() * y - 1e-12 {
                    refined.push((angle % std::f64::consts::TAU, value));
                    changed = true;
                }
            }
        }
        refined.sort_by(|a, b| a.0.total_cmp(&b.0));
        lines = refined;
        if !changed {
            break;
        }
    }
    let corners: Vec<(f64, f64)> = (0..lines.len())
        .map(|k| {
            let (a, mut b) = (lines[k], lines[(k + 1) % lines.len()]);
            if b.0 < a.0 {
                b.0 += std::f64::consts::TAU;
            }
            meet(a, b)
        })
        .collect();
    let twice: f64 = (0..corners.len())
        .map(|k| {
            let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
            a.0 * b.1 - a.1 * b.0
        })
        .sum();
    0.5 * twice
}
