//! Volumes, and numbers of vertices and facets, of sets in the plane and in space.

use rand_chacha::ChaCha8Rng;
use setrep::{Mesh, Outline, SetError, SupportFunction, Workspace};

use crate::set_study::{Cell, Contender, Measure, SetEstimator, Trajectory, study};
use crate::{Context, ScenarioError};

/// Facets whose unit normals differ by less are one.
const SAME_NORMAL: f64 = 1e-6;

/// Area or volume of the set; plain floating point, of the support vectors that resolve it to rounding.
pub const VOLUME: Measure =
    Measure { name: "volume", unit: "", of: |filter, workspace| volume(filter.region(), workspace) };
/// Number of vertices of the set.
pub const VERTICES: Measure =
    Measure { name: "vertices", unit: "", of: |filter, workspace| Ok(faces(filter, workspace)?.0) };
/// Number of facets of the set.
pub const FACETS: Measure =
    Measure { name: "facets", unit: "", of: |filter, workspace| Ok(faces(filter, workspace)?.1) };

/// A study of volumes; of V-H also of vertices and facets (measures 1 and 2), which other forms of sets make costly to count.
///
/// # Errors
/// Those of [`study()`].
pub fn study_sizes<F>(
    context: &Context<'_>,
    label: &str,
    runs: usize,
    simulate: F,
    contenders: Vec<Contender>,
) -> Result<Vec<Cell>, ScenarioError>
where
    F: Fn(&mut ChaCha8Rng) -> Result<Trajectory, ScenarioError> + Sync,
{
    let order: Vec<String> = contenders.iter().map(|contender| contender.method.clone()).collect();
    let (vertices, others): (Vec<Contender>, Vec<Contender>) =
        contenders.into_iter().partition(|contender| contender.method.starts_with("vh"));
    let mut cells = study(context, label, runs, &simulate, &others, &[VOLUME])?;
    cells.extend(study(context, label, runs, &simulate, &vertices, &[VOLUME, VERTICES, FACETS])?);
    cells.sort_by_key(|cell| order.iter().position(|method| *method == cell.method));
    Ok(cells)
}

/// Area of a planar set, volume of one in space; zero in other dimensions.
///
/// # Errors
/// As [`Outline::new`] and [`Mesh::new`].
pub fn volume(set: &dyn SupportFunction, workspace: &mut Workspace) -> Result<f64, SetError> {
    Ok(match set.dim() {
        2 => area(&Outline::new(set, [0, 1], workspace)?.outer),
        3 => {
            let mesh = Mesh::new(set, [0, 1, 2], workspace)?;
            let Some(&origin) = mesh.vertices.first() else { return Ok(0.0) };
            let edge = |i: usize| minus(mesh.vertices[i], origin);
            mesh.triangles.iter().map(|&[i, j, k]| dot(edge(i), cross(edge(j), edge(k)))).sum::<f64>() / 6.0
        }
        _ => 0.0,
    })
}

/// Area of a polygon, counterclockwise.
fn area(polygon: &[[f64; 2]]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
}

/// Numbers of vertices and facets; facets of nearly the same normal are one.
fn faces(filter: &dyn SetEstimator, workspace: &mut Workspace) -> Result<(f64, f64), SetError> {
    let set = filter.region();
    Ok(match set.dim() {
        2 => {
            let corners = Outline::new(set, [0, 1], workspace)?.inner.len() as f64;
            (corners, corners)
        }
        3 => {
            let mesh = Mesh::new(set, [0, 1, 2], workspace)?;
            let mut normals: Vec<[f64; 3]> = Vec::new();
            let mut around: Vec<Vec<usize>> = vec![Vec::new(); mesh.vertices.len()];
            // In units of the widths, so that the angles of a flat set count.
            let unit: Vec<f64> = filter.hull().iter().map(|side| 1.0 / side.rad().max(f64::MIN_POSITIVE)).collect();
            let scaled = |i: usize| [0, 1, 2].map(|k| mesh.vertices[i][k] * unit[k]);
            for corners in &mesh.triangles {
                let [p, q, r] = corners.map(scaled);
                let normal = cross(minus(q, p), minus(r, p));
                let length = dot(normal, normal).sqrt();
                // Slivers between other triangles have no normal of their own.
                if length < SAME_NORMAL {
                    continue;
                }
                let normal = normal.map(|x| x / length);
                let known = normals.iter().position(|&known| {
                    let off = minus(known, normal);
                    dot(off, off).sqrt() < SAME_NORMAL
                });
                let facet = known.unwrap_or_else(|| {
                    normals.push(normal);
                    normals.len() - 1
                });
                for &corner in corners {
                    if !around[corner].contains(&facet) {
                        around[corner].push(facet);
                    }
                }
            }
            // A vertex lies on three facets at least; others are points of edges or facets.
            let vertices = around.iter().filter(|facets| facets.len() > 2).count();
            (vertices as f64, normals.len() as f64)
        }
        _ => (set.columns() as f64, 0.0),
    })
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
