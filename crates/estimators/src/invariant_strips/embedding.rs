//! The linear embedding: which coordinates of the polytope stand for what.

/// Coordinates `(z, q_0, .., xi_0, ..)`, two real ones for each: the heading times the scale, the vectors of the world, those of the body.
///
/// The matrices of the groups, with `z = s e^{i phi}`: `SE_K(2)` is `[[z, x_0 .. x_K-1], [0, I]]` with `s = 1`, and a frame group acting on a
/// body vector as well has the block `xi = e^{i phi} X`. Composition with a known increment, change of the reference heading and
/// measurement of positions are linear in these entries; only `s1 <= |z| <= s2` and the place of `X` are not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Embedding {
    fixed: usize,
    body: usize,
}

impl Embedding {
    pub(super) fn new(fixed: usize, body: usize) -> Self {
        Self { fixed, body }
    }

    /// Number of real coordinates.
    pub(super) fn dim(self) -> usize {
        2 * (1 + self.fixed + self.body)
    }

    /// First coordinate of vector `j` of the world.
    pub(super) fn fixed(self, j: usize) -> usize {
        2 + 2 * j
    }

    /// First coordinate of vector `l` of the body.
    pub(super) fn body(self, l: usize) -> usize {
        2 + 2 * self.fixed + 2 * l
    }
}
