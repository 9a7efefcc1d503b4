//! Convex hull of points of a grid in space, one point after another, in exact integer arithmetic.

use std::collections::BTreeMap;

/// Largest coordinate of a grid point: determinants of differences stay below `2^126`.
pub(super) const REACH: i64 = 1 << 39;

/// A point of the grid.
pub(super) type Point = [i64; 3];

/// A triangle by its corners, counterclockwise from outside.
#[derive(Debug, Clone)]
pub(super) struct Facet {
    pub(super) corners: [usize; 3],
    pub(super) alive: bool,
}

/// A closed surface of triangles around the points so far.
#[derive(Debug, Clone)]
pub(super) struct Hull {
    pub(super) points: Vec<Point>,
    pub(super) facets: Vec<Facet>,
    /// The facet on the left of each directed edge.
    left_of: BTreeMap<(usize, usize), usize>,
}

impl Hull {
    /// The tetrahedron of four points.
    pub(super) fn tetrahedron(points: [Point; 4]) -> Self {
        let mut hull = Self { points: points.to_vec(), facets: Vec::new(), left_of: BTreeMap::new() };
        let positive = hull.height([0, 1, 2], points[3]) > 0;
        for corners in [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]] {
            hull.push(if positive { corners } else { [corners[1], corners[0], corners[2]] });
        }
        hull
    }

    /// The outward normal `(b - a) x (c - a)`.
    pub(super) fn normal(&self, corners: [usize; 3]) -> [i128; 3] {
        let [a, b, c] = corners.map(|k| self.points[k]);
        cross(minus(b, a), minus(c, a))
    }

    /// `normal'(p - a)`: how far a point lies above a triangle, in multiples of the normal's length.
    pub(super) fn height(&self, corners: [usize; 3], p: Point) -> i128 {
        let offset = minus(p, self.points[corners[0]]);
        self.normal(corners).iter().zip(offset).map(|(n, x)| n * i128::from(x)).sum()
    }

    /// Adds a point that lies above facet `seen`: the facets below it fall, and their rim is joined to the point.
    pub(super) fn insert(&mut self, p: Point, seen: usize) {
        let new = self.points.len();
        self.points.push(p);
        let (mut stack, mut horizon) = (vec![seen], Vec::new());
        self.facets[seen].alive = false;
        let mut visible = vec![seen];
        while let Some(k) = stack.pop() {
            for edge in edges(self.facets[k].corners) {
                // A closed surface has a facet on both sides of every edge.
                let Some(&other) = self.left_of.get(&(edge.1, edge.0)) else { continue };
                if !self.facets[other].alive {
                    continue;
                }
                if self.height(self.facets[other].corners, p) > 0 {
                    self.facets[other].alive = false;
                    visible.push(other);
                    stack.push(other);
                } else {
                    horizon.push(edge);
                }
            }
        }
        for k in visible {
            for edge in edges(self.facets[k].corners) {
                self.left_of.remove(&edge);
            }
        }
        for (a, b) in horizon {
            self.push([a, b, new]);
        }
    }

    fn push(&mut self, corners: [usize; 3]) {
        for edge in edges(corners) {
            self.left_of.insert(edge, self.facets.len());
        }
        self.facets.push(Facet { corners, alive: true });
    }
}

fn edges([a, b, c]: [usize; 3]) -> [(usize, usize); 3] {
    [(a, b), (b, c), (c, a)]
}

pub(super) fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn cross(a: Point, b: Point) -> [i128; 3] {
    let wide = |x: Point| x.map(i128::from);
    let (a, b) = (wide(a), wide(b));
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The corners of a cube and points inside: 12 triangles whose volumes sum to the cube's, whatever the order.
    #[test]
    fn a_cube_from_its_corners() {
        let corners: Vec<Point> = (0..8).map(|k| [k & 1, k >> 1 & 1, k >> 2].map(|x| (2 * x - 1) * REACH)).collect();
        let mut hull = Hull::tetrahedron([corners[0], corners[3], corners[5], corners[7]]);
        for p in corners.iter().copied().chain([[0, 0, 0], [REACH, 5, 7]]) {
            let seen =
                (0..hull.facets.len()).find(|&k| hull.facets[k].alive && hull.height(hull.facets[k].corners, p) > 0);
            if let Some(seen) = seen {
                hull.insert(p, seen);
            }
        }
        let alive: Vec<[usize; 3]> = hull.facets.iter().filter(|f| f.alive).map(|f| f.corners).collect();
        assert_eq!(alive.len(), 12);
        let volume: i128 = alive.iter().map(|&corners| -hull.height(corners, [0, 0, 0])).sum();
        assert_eq!(volume, 6 * (2 * i128::from(REACH)).pow(3));
    }
}
