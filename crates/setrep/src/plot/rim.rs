//! The boundary of a set's projection on two coordinates, by refinement of support vectors.

use crate::{Matrix, Part, SetError, SupportFunction, Workspace};

/// Support vectors are sought until none sticks out of its edge by more than this share of the width.
const RESOLUTION: f64 = 1e-9;

/// Most directions; the edges of a set with more vertices stay unresolved.
const MAX_DIRECTIONS: usize = 4096;

/// One half-plane that touches the projection.
#[derive(Debug, Clone)]
pub(super) struct Contact {
    /// Its outward normal in the plane.
    pub(super) direction: [f64; 2],
    /// Upper bound of the support.
    pub(super) support: f64,
    /// The support vector in all coordinates.
    pub(super) point: Vec<f64>,
    /// Whether the half-plane holds an edge.
    pub(super) is_edge: bool,
    /// Whether nothing is left to refine between this contact and the next.
    done: bool,
}

/// The contacts, counterclockwise from the direction of the first axis, and the distance in each coordinate below which points are one.
pub(super) fn contacts(
    set: &dyn SupportFunction,
    axes: [usize; 2],
    workspace: &mut Workspace,
) -> Result<(Vec<Contact>, [f64; 2]), SetError> {
    check_axes(set, &axes)?;
    let mut search = Search { set, axes, resolution: [0.0; 2], workspace };
    let mut contacts = search.ask(&[[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]])?;
    for k in 0..2 {
        let (hi, lo) = (contacts[k].support, -contacts[k + 2].support);
        // Where a vector misses its bound, there is noise of that size.
        let miss = |contact: &Contact| (contact.support - dot(contact.direction, search.plane(contact))).abs();
        let noise = 4.0 * miss(&contacts[k]).max(miss(&contacts[k + 2]));
        search.resolution[k] = RESOLUTION * (hi - lo) + 8.0 * f64::EPSILON * hi.abs().max(lo.abs()) + noise;
    }
    loop {
        let normals: Vec<Option<[f64; 2]>> = (0..contacts.len()).map(|k| search.open_edge(&mut contacts, k)).collect();
        let directions: Vec<[f64; 2]> = normals.iter().flatten().copied().collect();
        if directions.is_empty() || contacts.len() + directions.len() > MAX_DIRECTIONS {
            return Ok((contacts, search.resolution));
        }
        let mut found = search.ask(&directions)?.into_iter();
        let mut next = Vec::with_capacity(contacts.len() + directions.len());
        for (mut contact, normal) in contacts.into_iter().zip(normals) {
            let new = normal.and_then(|_| found.next());
            if let Some(mut new) = new {
                let (d, start) = (new.direction, search.plane(&contact));
                let height = dot(d, search.plane(&new)) - dot(d, start);
                // Judged by the vector, not by the bound: only a new point is progress.
                let beyond = height > d[0].abs() * search.resolution[0] + d[1].abs() * search.resolution[1];
                (contact.done, new.done, new.is_edge) = (!beyond, !beyond, !beyond);
                next.extend([contact, new]);
            } else {
                contact.done = true;
                next.push(contact);
            }
        }
        contacts = next;
    }
}

/// `Ok` if the axes are coordinates of the set's space, no two the same.
pub(super) fn check_axes(set: &dyn SupportFunction, axes: &[usize]) -> Result<(), SetError> {
    if let Some(&axis) = axes.iter().find(|&&axis| axis >= set.dim()) {
        return Err(SetError::Dimension { part: Part::Output, expected: set.dim(), found: axis + 1 });
    }
    let repeated = (1..axes.len()).any(|k| axes[..k].contains(&axes[k]));
    if repeated { Err(SetError::Dimension { part: Part::Output, expected: axes.len(), found: 1 }) } else { Ok(()) }
}

/// A finite support, or why there is none; `axis` names the direction in errors.
pub(super) fn finite(support: f64, axis: usize) -> Result<f64, SetError> {
    match support {
        f64::NEG_INFINITY => Err(SetError::EmptySet),
        value if value.is_finite() => Ok(value),
        _ => Err(SetError::Overflow { row: axis }),
    }
}

pub(super) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

struct Search<'a> {
    set: &'a dyn SupportFunction,
    axes: [usize; 2],
    /// Points nearer than this in each coordinate are one.
    resolution: [f64; 2],
    workspace: &'a mut Workspace,
}

impl Search<'_> {
    fn ask(&mut self, directions: &[[f64; 2]]) -> Result<Vec<Contact>, SetError> {
        let mut columns = Matrix::zeros(self.set.dim(), directions.len());
        for (j, d) in directions.iter().enumerate() {
            (0..2).for_each(|k| columns.col_mut(j)[self.axes[k]] = d[k]);
        }
        let mut points = Matrix::zeros(0, 0);
        let supports = self.set.support_vectors(&columns, &mut points, self.workspace)?;
        let contact = |(j, support): (usize, f64)| {
            let support = finite(support, self.axes[j % 2])?;
            let point = points.col(j).to_vec();
            Ok(Contact { direction: directions[j], support, point, is_edge: false, done: false })
        };
        supports.into_iter().enumerate().map(contact).collect()
    }

    fn plane(&self, contact: &Contact) -> [f64; 2] {
        self.axes.map(|axis| contact.point[axis])
    }

    /// The outward normal of the edge from contact `k` to the next, if there is one to refine.
    fn open_edge(&self, contacts: &mut [Contact], k: usize) -> Option<[f64; 2]> {
        if contacts[k].done {
            return None;
        }
        let (p, q) = (self.plane(&contacts[k]), self.plane(&contacts[(k + 1) % contacts.len()]));
        let edge = [q[0] - p[0], q[1] - p[1]];
        if (0..2).all(|k| edge[k].abs() <= self.resolution[k]) {
            return None;
        }
        // Normals of a size near 1, whatever the units.
        let largest = edge[0].abs().max(edge[1].abs());
        let normal = [edge[1] / largest, -edge[0] / largest];
        normal.iter().all(|x| x.is_finite()).then_some(normal)
    }
}
