//! Polygons around and inside the projection of a set on two coordinates.

use super::rim::{self, Contact, dot};
use crate::{HPolytope, Matrix, SetError, SupportFunction, VPolytope, Workspace};

/// A gap below this share of the largest coordinate needs no more half-planes.
const NARROW: f64 = 1e-10;

/// The projection of a convex set on two coordinates, from outside and from inside; vertices counterclockwise, each once. A segment
/// has two inner vertices, a point one.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// A polygon that contains the projection, proven.
    pub outer: Vec<[f64; 2]>,
    /// Support vectors of the set: members up to rounding, and all vertices of the projection that stick out of their neighbours'
    /// edge by more than `1e-9` of its width.
    pub inner: Vec<[f64; 2]>,
    /// The largest distance of an outer vertex from the inner polygon (plain floating point): rounding, for a resolved set.
    pub gap: f64,
}

impl Outline {
    /// The outline of the projection on the coordinates `axes`.
    ///
    /// The support vectors of the four axis directions are refined along the normals of the edges between them. The half-planes of
    /// the edges, with supports as offsets, meet in the outer polygon; its vertices come from the rigorous
    /// [`HPolytope::to_v_polytope`], widened by their rounding.
    ///
    /// **Guarantee:** the projection is a subset of the hull of `outer`.
    ///
    /// # Errors
    /// [`SetError::Dimension`] unless the axes are two different coordinates; [`SetError::EmptySet`], proven;
    /// [`SetError::Overflow`] for sets not proven bounded; what the set's own supports say.
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Outline, Workspace};
    /// let mut workspace = Workspace::new();
    /// let mut set = ConstrainedZonotope::from_box(&[0.0; 3], &[1.0; 3])?;
    /// set.intersect_half_space(&[1.0, 1.0, 0.0], 1.0, &mut workspace)?;
    /// let outline = Outline::new(&set, [0, 1], &mut workspace)?;
    /// assert_eq!(outline.inner.len(), 5);
    /// assert!(outline.gap < 1e-12);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn new(set: &dyn SupportFunction, axes: [usize; 2], workspace: &mut Workspace) -> Result<Self, SetError> {
        let (contacts, resolution) = rim::contacts(set, axes, workspace)?;
        let mut points = Matrix::zeros(2, 0);
        for contact in &contacts {
            points.push_col(&axes.map(|axis| contact.point[axis]))?;
        }
        let inner = simplified(&ordered(points)?, resolution);
        let gap = |outer: &[[f64; 2]]| outer.iter().map(|&x| distance(x, &inner)).fold(0.0, f64::max);
        let size = inner.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        // The half-planes of the edges are enough, unless the set is flat, or so thin that they meet far away: then those of the
        // vertices help.
        let edges: Vec<&Contact> = contacts.iter().filter(|contact| contact.is_edge).collect();
        let outer = match polygon(&edges) {
            Ok(outer) if inner.len() > 2 && gap(&outer) <= NARROW * size => outer,
            _ => polygon(&contacts.iter().collect::<Vec<_>>())?,
        };
        let gap = gap(&outer);
        Ok(Self { outer, inner, gap })
    }
}

/// The vertices of the intersection of half-planes, widened by their rounding.
fn polygon(contacts: &[&Contact]) -> Result<Vec<[f64; 2]>, SetError> {
    let mut normals = Matrix::zeros(contacts.len(), 2);
    for (i, contact) in contacts.iter().enumerate() {
        (0..2).for_each(|k| normals[(i, k)] = contact.direction[k]);
    }
    let offsets: Vec<f64> = contacts.iter().map(|contact| contact.support).collect();
    let exact = HPolytope::new(normals, &offsets)?.to_v_polytope()?;
    let r = exact.remainder();
    if r.iter().all(|&r| r == 0.0) {
        return ordered(exact.vertices().clone());
    }
    let mut corners = Matrix::zeros(2, 0);
    for v in exact.vertices().columns() {
        for [right, up] in [[true, true], [false, true], [false, false], [true, false]] {
            let move_out = |x: f64, r: f64, forth: bool| if forth { (x + r).next_up() } else { (x - r).next_down() };
            corners.push_col(&[move_out(v[0], r[0], right), move_out(v[1], r[1], up)])?;
        }
    }
    ordered(corners)
}

/// The vertices of a convex polygon that stick out of the chord of their neighbours by more than the resolution.
pub(super) fn simplified(polygon: &[[f64; 2]], resolution: [f64; 2]) -> Vec<[f64; 2]> {
    let flat = |p: [f64; 2], x: [f64; 2], q: [f64; 2]| {
        let (chord, offset) = ([q[0] - p[0], q[1] - p[1]], [x[0] - p[0], x[1] - p[1]]);
        let height = offset[0] * chord[1] - offset[1] * chord[0];
        height <= chord[1].abs() * resolution[0] + chord[0].abs() * resolution[1]
    };
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(polygon.len());
    for &v in polygon {
        while kept.len() > 1 && flat(kept[kept.len() - 2], kept[kept.len() - 1], v) {
            kept.pop();
        }
        kept.push(v);
    }
    // Around the corner between the last and the first.
    while kept.len() > 2 && flat(kept[kept.len() - 2], kept[kept.len() - 1], kept[0]) {
        kept.pop();
    }
    while kept.len() > 2 && flat(kept[kept.len() - 1], kept[0], kept[1]) {
        kept.remove(0);
    }
    if let [p, q] = kept[..]
        && (0..2).all(|k| (p[k] - q[k]).abs() <= resolution[k])
    {
        kept.pop();
    }
    kept
}

/// The vertices of the hull, counterclockwise.
pub(super) fn ordered(points: Matrix) -> Result<Vec<[f64; 2]>, SetError> {
    let outline = VPolytope::new(points)?.outline_2d()?;
    Ok(outline.columns().map(|v| [v[0], v[1]]).collect())
}

/// Distance of a point from a convex polygon; zero inside.
fn distance(x: [f64; 2], polygon: &[[f64; 2]]) -> f64 {
    let minus = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
    let (mut nearest, mut inside) = (f64::INFINITY, polygon.len() > 2);
    for (k, &p) in polygon.iter().enumerate() {
        let edge = minus(polygon[(k + 1) % polygon.len()], p);
        let offset = minus(x, p);
        inside &= edge[0] * offset[1] - edge[1] * offset[0] >= 0.0;
        let length = dot(edge, edge);
        let t = if length > 0.0 { (dot(edge, offset) / length).clamp(0.0, 1.0) } else { 0.0 };
        nearest = nearest.min((offset[0] - t * edge[0]).hypot(offset[1] - t * edge[1]));
    }
    if inside { 0.0 } else { nearest }
}
