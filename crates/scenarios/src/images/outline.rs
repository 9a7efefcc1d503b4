//! Outlines and areas of planar sets, in plain floating point.

use setrep::{SetError, SupportFunction, Workspace};

/// Edges that no support vector leaves by more than this share of the set's extent are final.
const FLATNESS: f64 = 1e-11;

/// The vertices of a planar set, counterclockwise: support vectors in the normals of the edges found so far, until none is new.
///
/// # Errors
/// Those of the support function.
pub fn outline(set: &dyn SupportFunction, workspace: &mut Workspace) -> Result<Vec<[f64; 2]>, SetError> {
    let mut support = |direction: [f64; 2]| -> Result<[f64; 2], SetError> {
        let mut point = [0.0; 2];
        set.support_vector(&direction, &mut point, workspace)?;
        Ok(point)
    };
    let start = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    let corners = start.iter().map(|d| support(*d)).collect::<Result<Vec<_>, _>>()?;
    let extent = (corners[0][0] - corners[2][0]).abs() + (corners[1][1] - corners[3][1]).abs();
    let mut vertices = Vec::new();
    let mut edges: Vec<([f64; 2], [f64; 2])> = (0..4).rev().map(|k| (corners[k], corners[(k + 1) % 4])).collect();
    while let Some((p, q)) = edges.pop() {
        let normal = [q[1] - p[1], p[0] - q[0]];
        let length = normal[0].hypot(normal[1]);
        // NaN ends the edge, too.
        let long = length > FLATNESS * extent;
        if long {
            let unit = normal.map(|x| x / length);
            let s = support(unit)?;
            if unit[0] * (s[0] - p[0]) + unit[1] * (s[1] - p[1]) > FLATNESS * extent {
                edges.push((s, q));
                edges.push((p, s));
                continue;
            }
            vertices.push(p);
        }
    }
    if vertices.is_empty() {
        vertices.push(corners[0]);
    }
    Ok(vertices)
}

/// Area of a polygon, positive counterclockwise.
#[must_use]
pub fn area(vertices: &[[f64; 2]]) -> f64 {
    let Some(&origin) = vertices.first() else { return 0.0 };
    let edge = |k: usize| [vertices[k][0] - origin[0], vertices[k][1] - origin[1]];
    let cross = |k: usize| edge(k)[0] * edge(k + 1)[1] - edge(k)[1] * edge(k + 1)[0];
    0.5 * (1..vertices.len().saturating_sub(1)).map(cross).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use setrep::{Matrix, Zonotope};

    use super::*;

    #[test]
    fn a_hexagon_has_six_vertices_and_its_area() {
        let generators = Matrix::from_rows(&[&[1.0, 0.0, 1.0], &[0.0, 1.0, 1.0]]).unwrap();
        let hexagon = Zonotope::new(&[5.0, -3.0], &generators).unwrap();
        let vertices = outline(&hexagon, &mut Workspace::new()).unwrap();
        assert_eq!(vertices.len(), 6);
        assert!((area(&vertices) - 12.0).abs() < 1e-12);
    }

    #[test]
    fn flat_sets_have_no_area() {
        let segment = Zonotope::new(&[1.0, 1.0], &Matrix::from_rows(&[&[1.0], &[2.0]]).unwrap()).unwrap();
        assert!(area(&outline(&segment, &mut Workspace::new()).unwrap()).abs() < 1e-12);
        let point = Zonotope::point(&[1.0, 1.0]).unwrap();
        assert_eq!(outline(&point, &mut Workspace::new()).unwrap(), [[1.0, 1.0]]);
    }
}
