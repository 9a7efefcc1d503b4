//! The constrained zonotopes that are timed: random ones, and ones as a chain of filter steps leaves them.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Workspace, Zonotope};

use crate::draw::Draw;

/// Dimension, generators and constraints of a set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Dimension.
    pub n: usize,
    /// Generators.
    pub ng: usize,
    /// Constraints.
    pub nc: usize,
}

impl std::fmt::Display for Size {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "n{}_g{}_c{}", self.n, self.ng, self.nc)
    }
}

/// The four sizes of the stored peer comparison.
pub const SIZES: [Size; 4] = [
    Size { n: 2, ng: 8, nc: 3 },
    Size { n: 4, ng: 12, nc: 5 },
    Size { n: 10, ng: 40, nc: 10 },
    Size { n: 20, ng: 200, nc: 40 },
];

/// A set with normal generators and constraints `A xi = A xi_0`, `|xi_0| <= 0.8`: never empty.
pub fn random(size: Size, seed: u64) -> ConstrainedZonotope {
    let Size { n, ng, nc } = size;
    let mut draw = Draw::new(seed);
    let inner: Vec<f64> = (0..ng).map(|_| draw.symmetric(0.8)).collect();
    let generators = matrix(n, ng, &mut draw);
    let constraints = matrix(nc, ng, &mut draw);
    let b: Vec<f64> =
        (0..nc).map(|i| inner.iter().enumerate().map(|(j, xi)| constraints.col(j)[i] * xi).sum()).collect();
    ConstrainedZonotope::from_cg_rep(&vec![0.0; n], &generators, &constraints, &b).expect("finite, sizes agree")
}

/// A set as a filter leaves it: `steps` times a map, a noise of two generators, and a measured strip through the middle.
pub fn chain(n: usize, steps: usize, seed: u64) -> ConstrainedZonotope {
    let mut draw = Draw::new(seed);
    let mut workspace = Workspace::new();
    let mut set = ConstrainedZonotope::from_box(&vec![0.0; n], &vec![1.0; n]).expect("a box");
    for _ in 0..steps {
        let mut map = matrix(n, n, &mut draw);
        map.as_mut_slice().iter_mut().for_each(|entry| *entry *= (0.5 / n as f64).sqrt());
        let noise = Zonotope::new(&vec![0.0; n], &matrix(n, 2, &mut draw)).expect("finite");
        let strip = matrix(1, n, &mut draw);
        let band = Interval::point(draw.symmetric(0.1)).inflate(0.3);
        set.linear_map_in_place(&map, &mut workspace).expect("sizes agree");
        set.add_assign(&noise.into()).expect("sizes agree");
        set.intersect_rows(&strip, &[band], &mut workspace).expect("sizes agree");
    }
    set
}

fn matrix(rows: usize, cols: usize, draw: &mut Draw) -> Matrix {
    Matrix::from_column_slice(rows, cols, &draw.normals(rows * cols)).expect("the sizes agree")
}
