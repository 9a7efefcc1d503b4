//! Triangle meshes of the projection of a set on three coordinates.

use scalars::Interval;
use scalars::rounding::{div_up, sqrt_down};

use super::hull::{Hull, Point, REACH, cross, minus};
use super::outline::{ordered, simplified};
use super::rim::{self, check_axes, finite};
use crate::{HPolytope, Matrix, SetError, SupportFunction, Workspace};

/// Steps of the grid by which a point must stick out of a facet to refine it.
const STEPS: i128 = 8;

/// Most vertices.
const MAX_VERTICES: usize = 20_000;

/// The projection of a convex set on three coordinates as a closed surface of triangles; also of a polygon (both sides), a segment (two
/// vertices, no triangle) or a point (one vertex).
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Support vectors of the set, rounded to a grid of about `1e-12` of its widths: members up to that.
    pub vertices: Vec<[f64; 3]>,
    /// Indices of the corners of each triangle, counterclockwise from outside.
    pub triangles: Vec<[usize; 3]>,
    /// Half-spaces that contain the projection, proven: one a triangle in order, more for sets without interior.
    pub outer: HPolytope,
    /// How far the outer half-spaces reach beyond the triangles at most (an upper bound of the distance of their planes).
    pub gap: f64,
}

impl Mesh {
    /// The mesh of the projection on the coordinates `axes`.
    ///
    /// The hull of support vectors is refined along the normals of its facets until no support vector lies beyond one by more than
    /// rounding. The hull is computed on a grid in exact integers, so the surface is closed and oriented whatever the set.
    ///
    /// **Guarantee:** the projection is a subset of `outer`; `gap` bounds how far each of its planes is from its triangle.
    ///
    /// # Errors
    /// [`SetError::Dimension`] unless the axes are three different coordinates; [`SetError::EmptySet`], proven;
    /// [`SetError::Overflow`] for sets not proven bounded; [`SetError::OverBudget`] beyond 20,000 vertices; what the set's own supports
    /// say.
    ///
    /// ```
    /// # use setrep::{Matrix, Mesh, Workspace, Zonotope};
    /// let generators = Matrix::from_rows(&[&[1.0, 0.0, 0.0, 1.0], &[0.0, 1.0, 0.0, 1.0], &[0.0, 0.0, 1.0, 1.0]])?;
    /// let dodecahedron = Zonotope::new(&[0.0; 3], &generators)?;
    /// let mesh = Mesh::new(&dodecahedron, [0, 1, 2], &mut Workspace::new())?;
    /// // Twelve rhombi, fourteen vertices.
    /// assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (14, 24));
    /// assert!(mesh.gap < 1e-10);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn new(set: &dyn SupportFunction, axes: [usize; 3], workspace: &mut Workspace) -> Result<Self, SetError> {
        check_axes(set, &axes)?;
        let mut grid = Grid { set, axes, origin: [0.0; 3], steps: [1.0; 3], workspace };
        grid.fit()?;
        let all: Vec<[f64; 3]> = (0..27_i32).map(|k| [k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1].map(f64::from)).collect();
        let around: Vec<[f64; 3]> = all.into_iter().filter(|d| *d != [0.0; 3]).collect();
        let (mut contacts, mut points) = grid.ask(&grid.to_space(&around))?;
        loop {
            let frame = Frame::of(&points);
            if let Frame::Space(corners) = frame {
                return grid.refine(corners, &points);
            }
            let (more, found) = grid.ask(&grid.to_space(&frame.across()))?;
            contacts.extend(more);
            let before = frame.rank();
            points.extend(found);
            if Frame::of(&points).rank() == before {
                return grid.flat(&frame, contacts);
            }
        }
    }
}

/// A half-space that touches the projection.
#[derive(Debug, Clone)]
struct Contact {
    direction: [f64; 3],
    support: f64,
}

fn signed_axes() -> Vec<[f64; 3]> {
    let axis = |k: usize| core::array::from_fn(|i| if i == k / 2 { 1.0 - 2.0 * (k % 2) as f64 } else { 0.0 });
    (0..6).map(axis).collect()
}

/// The set seen on a grid `origin + steps k`, `|k| <= REACH`.
struct Grid<'a> {
    set: &'a dyn SupportFunction,
    axes: [usize; 3],
    origin: [f64; 3],
    steps: [f64; 3],
    workspace: &'a mut Workspace,
}

impl Grid<'_> {
    /// Puts origin and steps to the widths of the set, no step finer than the noise of the support vectors.
    fn fit(&mut self) -> Result<(), SetError> {
        let directions = signed_axes();
        let (contacts, vectors) = self.ask_vectors(&directions)?;
        let ends = |k: usize| (contacts[2 * k].support, -contacts[2 * k + 1].support);
        for k in 0..3 {
            let (hi, lo) = ends(k);
            self.origin[k] = 0.5 * hi + 0.5 * lo;
            let miss = |j: usize| (contacts[j].support - directions[j][k] * vectors[(self.axes[k], j)]).abs();
            let noise = miss(2 * k).max(miss(2 * k + 1)).max(f64::EPSILON * hi.abs().max(lo.abs()));
            let half = 0.5 * hi - 0.5 * lo;
            self.steps[k] = (half * (1.0 + 1e-9) / REACH as f64).max(noise).max(f64::MIN_POSITIVE);
        }
        Ok(())
    }

    /// Supports of directions of the space, and the support vectors as grid points.
    fn ask(&mut self, directions: &[[f64; 3]]) -> Result<(Vec<Contact>, Vec<Point>), SetError> {
        let (contacts, vectors) = self.ask_vectors(directions)?;
        let snap = |x: f64, k: usize| {
            let steps = ((x - self.origin[k]) / self.steps[k]).round();
            (steps as i64).clamp(-REACH, REACH)
        };
        let points = vectors.columns().map(|v| core::array::from_fn(|k| snap(v[self.axes[k]], k))).collect();
        Ok((contacts, points))
    }

    /// Supports of directions of the space, and the support vectors as columns.
    fn ask_vectors(&mut self, directions: &[[f64; 3]]) -> Result<(Vec<Contact>, Matrix), SetError> {
        let mut columns = Matrix::zeros(self.set.dim(), directions.len());
        for (j, d) in directions.iter().enumerate() {
            (0..3).for_each(|k| columns.col_mut(j)[self.axes[k]] = d[k]);
        }
        let mut vectors = Matrix::zeros(0, 0);
        let supports = self.set.support_vectors(&columns, &mut vectors, self.workspace)?;
        let mut contacts = Vec::with_capacity(directions.len());
        for (j, (&support, &direction)) in supports.iter().zip(directions).enumerate() {
            contacts.push(Contact { direction, support: finite(support, self.axes[j / 2 % 3])? });
        }
        Ok((contacts, vectors))
    }

    /// Directions of the grid as directions of the space: `d'k = (d / steps)'x` up to a constant; near 1 in size.
    fn to_space(&self, directions: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let scaled = |d: &[f64; 3]| {
            let smallest = self.steps.iter().copied().fold(f64::INFINITY, f64::min);
            let d: [f64; 3] = core::array::from_fn(|k| d[k] * (smallest / self.steps[k]));
            let largest = d.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            d.map(|x| if largest > 0.0 { x / largest } else { 0.0 })
        };
        directions.iter().map(scaled).collect()
    }

    fn place(&self, p: Point) -> [f64; 3] {
        core::array::from_fn(|k| self.origin[k] + self.steps[k] * p[k] as f64)
    }

    /// Refines a tetrahedron until all its facets are final.
    fn refine(&mut self, corners: [Point; 4], points: &[Point]) -> Result<Mesh, SetError> {
        let mut hull = Hull::tetrahedron(corners);
        for &p in points {
            add(&mut hull, p, 0);
        }
        let mut contacts: Vec<Option<Contact>> = vec![None; hull.facets.len()];
        loop {
            let open: Vec<usize> =
                (0..hull.facets.len()).filter(|&k| hull.facets[k].alive && contacts[k].is_none()).collect();
            if open.is_empty() {
                break;
            }
            let normal = |&k: &usize| hull.normal(hull.facets[k].corners).map(|x| x as f64);
            let (found, points) = self.ask(&self.to_space(&open.iter().map(normal).collect::<Vec<_>>()))?;
            for ((k, contact), p) in open.into_iter().zip(found).zip(points) {
                contacts[k] = Some(contact);
                add(&mut hull, p, STEPS);
                contacts.resize(hull.facets.len(), None);
            }
            if hull.points.len() > MAX_VERTICES {
                return Err(SetError::OverBudget { count: hull.points.len(), limit: MAX_VERTICES });
            }
        }
        let alive: Vec<usize> = (0..hull.facets.len()).filter(|&k| hull.facets[k].alive).collect();
        let mut names = vec![usize::MAX; hull.points.len()];
        let (mut vertices, mut triangles, mut outside) = (Vec::new(), Vec::new(), Vec::new());
        for &k in &alive {
            triangles.push(hull.facets[k].corners.map(|corner| {
                if names[corner] == usize::MAX {
                    names[corner] = vertices.len();
                    vertices.push(self.place(hull.points[corner]));
                }
                names[corner]
            }));
            outside.extend(contacts[k].clone());
        }
        let touch: Vec<[f64; 3]> = triangles.iter().map(|triangle| vertices[triangle[0]]).collect();
        mesh(vertices, triangles, &outside, &touch)
    }

    /// The mesh of a set without interior.
    fn flat(&mut self, frame: &Frame, mut contacts: Vec<Contact>) -> Result<Mesh, SetError> {
        let (vertices, triangles) = match *frame {
            Frame::Point(p) => (vec![self.place(p)], Vec::new()),
            Frame::Line(p, q) => (vec![self.place(p), self.place(q)], Vec::new()),
            Frame::Plane(p, q, r) => {
                // Seen along the axis in which the plane is steepest, the polygon keeps its shape.
                let normal = cross(minus(q, p), minus(r, p));
                let drop = (0..3).max_by_key(|&k| normal[k].abs()).unwrap_or(2);
                let (i, j) = ((drop + 1) % 3, (drop + 2) % 3);
                let (rim, resolution) = rim::contacts(self.set, [self.axes[i], self.axes[j]], self.workspace)?;
                let mut plane = Matrix::zeros(2, 0);
                for contact in &rim {
                    plane.push_col(&[contact.point[self.axes[i]], contact.point[self.axes[j]]])?;
                    let mut direction = [0.0; 3];
                    [direction[i], direction[j]] = contact.direction;
                    contacts.push(Contact { direction, support: contact.support });
                }
                let corner = |v: [f64; 2]| {
                    let found = plane.columns().position(|x| x == v).unwrap_or(0);
                    self.axes.map(|axis| rim[found].point[axis])
                };
                let order = simplified(&ordered(plane.clone())?, resolution);
                let vertices: Vec<[f64; 3]> = order.into_iter().map(corner).collect();
                let fan = 2..vertices.len();
                (vertices, fan.flat_map(|k| [[0, k - 1, k], [0, k, k - 1]]).collect())
            }
            // Not reached: a frame of the space is refined.
            Frame::Space(_) => (Vec::new(), Vec::new()),
        };
        let far = |contact: &Contact| {
            let reach = |v: &&[f64; 3]| (0..3).map(|k| contact.direction[k] * v[k]).sum::<f64>();
            vertices.iter().max_by(|v, w| reach(v).total_cmp(&reach(w))).copied().unwrap_or_default()
        };
        let touch: Vec<[f64; 3]> = contacts.iter().map(far).collect();
        mesh(vertices, triangles, &contacts, &touch)
    }
}

/// Adds a point to the hull if it lies above a facet by more than some steps.
fn add(hull: &mut Hull, p: Point, steps: i128) {
    let above = |k: &usize| {
        let facet = &hull.facets[*k];
        let height = if facet.alive { hull.height(facet.corners, p) } else { 0 };
        height > 0 && height > steps * hull.normal(facet.corners).iter().map(|n| n.abs()).sum::<i128>()
    };
    // The newest facets are the likeliest.
    if let Some(seen) = (0..hull.facets.len()).rev().find(above) {
        hull.insert(p, seen);
    }
}

/// The mesh with its outer half-spaces; `touch` holds a point of the mesh on each of their planes, up to the gap.
fn mesh(
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[usize; 3]>,
    contacts: &[Contact],
    touch: &[[f64; 3]],
) -> Result<Mesh, SetError> {
    let mut normals = Matrix::zeros(contacts.len(), 3);
    let mut offsets = Vec::with_capacity(contacts.len());
    let mut gap = 0.0_f64;
    for (i, (contact, v)) in contacts.iter().zip(touch).enumerate() {
        let (mut slack, mut square) = (Interval::point(contact.support), Interval::ZERO);
        for k in 0..3 {
            normals[(i, k)] = contact.direction[k];
            slack -= Interval::point(contact.direction[k]).scale(v[k]);
            square += Interval::point(contact.direction[k]).sqr();
        }
        offsets.push(contact.support);
        if slack.hi() > 0.0 {
            gap = gap.max(div_up(slack.hi(), sqrt_down(square.lo())));
        }
    }
    Ok(Mesh { vertices, triangles, outer: HPolytope::new(normals, &offsets)?, gap })
}

/// Affinely independent points, as many as there are.
#[derive(Debug, Clone, Copy)]
enum Frame {
    Point(Point),
    Line(Point, Point),
    Plane(Point, Point, Point),
    Space([Point; 4]),
}

impl Frame {
    fn of(points: &[Point]) -> Self {
        let first = points.iter().min().copied().unwrap_or_default();
        let size = |x: [i128; 3]| x.iter().map(|x| x.unsigned_abs()).sum::<u128>();
        let far = |p: &Point| size(minus(*p, first).map(i128::from));
        // Nearer than the grid resolves is the same.
        let steps = STEPS.unsigned_abs();
        let Some(&p) = points.iter().max_by_key(|p| far(p)).filter(|p| far(p) > steps) else {
            return Self::Point(first);
        };
        let area = |q: &Point| size(cross(minus(p, first), minus(*q, first)));
        let Some(&q) = points.iter().max_by_key(|q| area(q)).filter(|q| area(q) > steps * far(&p)) else {
            return Self::Line(first, p);
        };
        let normal = cross(minus(p, first), minus(q, first));
        let height = |r: &Point| {
            minus(*r, first).iter().zip(normal).map(|(&x, n)| n * i128::from(x)).sum::<i128>().unsigned_abs()
        };
        match points.iter().max_by_key(|r| height(r)).filter(|r| height(r) > steps * size(normal)) {
            Some(&r) => Self::Space([first, p, q, r]),
            None => Self::Plane(first, p, q),
        }
    }

    fn rank(&self) -> usize {
        match self {
            Self::Point(_) => 0,
            Self::Line(..) => 1,
            Self::Plane(..) => 2,
            Self::Space(_) => 3,
        }
    }

    /// Directions across the frame, in which a point out of it would show.
    fn across(&self) -> Vec<[f64; 3]> {
        let both = |d: [f64; 3]| [d, d.map(|x| -x)];
        match *self {
            Self::Plane(p, q, r) => both(cross(minus(q, p), minus(r, p)).map(|x| x as f64)).to_vec(),
            Self::Line(p, q) => {
                // The cross products with the axes span the normal plane.
                let axis = |k: usize| core::array::from_fn(|i| i64::from(i == k));
                let normals = (0..3).map(|k| cross(minus(q, p), axis(k)).map(|x| x as f64));
                normals.filter(|d| *d != [0.0; 3]).flat_map(both).collect()
            }
            Self::Point(_) | Self::Space(_) => signed_axes(),
        }
    }
}
