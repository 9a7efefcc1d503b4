//! Two-frame groups: a frame with vectors fixed in space and vectors fixed in the body.

use nalgebra::{DMatrix, SMatrix, SVector};

use crate::lie_group::checked_vee;
use crate::small::{apply, part, put};
use crate::{Coeff, FrameGroup, GroupError, LieGroup};

/// A frame `g` of the group `G` with `NX` vectors `x_i` in fixed coordinates and `NB` vectors `X_j` in body coordinates.
///
/// One law for SE(d), SE_K(d), Sim(d) and the groups of a robot with lever arms and unknown wheel scale:
///
/// ```text
/// (g, x, X) (h, y, Y) = (g h, x + g * y, Y + h^-1 * X)
/// ```
///
/// - **Tangent:** `xi = (w, u_1 .. u_NX, U_1 .. U_NB)`: the frame's coordinates (rotation, then log-scale), then the fixed-frame vectors, then the
///   body-frame vectors; `N = DG + D (NX + NB)`, checked when the type is used.
/// - **Storage:** `g`, `x_i`, `X_j`, so that a body vector that does not change keeps its bits.
/// - **Acts on** points of `R^D` through the first fixed-frame vector: `g * p + x_1`; through any by [`act_through`](Self::act_through).
/// - **Matrix:** `[rho(g), x_i .., g * X_j ..; 0, I]` of size `D + NX + NB`: seen from the fixed frame, `g * X_j` is one more vector of the
///   semidirect product, with the same tangent coordinates.
///
/// | operation | formula, `V = phi_1(w*)` |
/// |---|---|
/// | `exp xi` | `(exp w, V(w) u_i, V(-w) U_j)` |
/// | `log X` | `(w, V(w)^-1 x_i, V(-w)^-1 X_j)`, `w = log g` |
/// | `X^-1` | `(g^-1, -g^-1 * x_i, -g * X_j)` |
/// | `Ad_X` | `[Ad_g 0; -B(x_i) Ad_g, rho(g); -B(g * X_j) Ad_g, rho(g)]` |
/// | `ad_xi` | `[ad_w 0; -B(u) w*]` a block row for every vector |
/// | `Jl(xi)` | `[Jl(w) 0; Q(w, u) V(w)]` a block row for every vector, `V(w)` for those of the body too |
/// | `Jl(xi)^-1` | `[Jl(w)^-1 0; -V^-1 Q Jl(w)^-1, V^-1]` |
///
/// **Guarantee:** over `Interval` every operation returns a superset of the image of the set of elements.
/// **Source:** paper 002, section III (two-frames groups); Barrau, Bonnabel, The geometry of navigation problems, arXiv 2009.05394.
///
/// ```
/// use lie_groups::{LieGroup, RPlus, SO2, ScaledSO2, TfgScaleLever2};
/// use nalgebra::Vector2;
///
/// // Heading, wheel scale, position and lever arm of the antenna.
/// let frame = ScaledSO2::new(SO2::from_angle(0.3), RPlus::from_scale(0.95)?);
/// let state = TfgScaleLever2::new(frame, [Vector2::new(10.0, -4.0)], [Vector2::new(0.5, 0.3)]);
/// let error = state.inverse().compose(&state).log()?;
/// assert!(error.norm() < 1e-14);
/// # Ok::<(), lie_groups::GroupError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoFrame<G, S, const D: usize, const NX: usize, const NB: usize, const DG: usize, const N: usize> {
    frame: G,
    fixed: [SVector<S, D>; NX],
    body: [SVector<S, D>; NB],
}

impl<G, S, const D: usize, const NX: usize, const NB: usize, const DG: usize, const N: usize>
    TwoFrame<G, S, D, NX, NB, DG, N>
where
    S: Coeff,
    G: FrameGroup<S, D, DG>,
{
    const SIZES: () =
        assert!(N == DG + D * (NX + NB), "the tangent of a two-frame group has DG + D (NX + NB) coordinates");

    /// Rows and columns of the matrix form.
    const MATRIX: usize = D + NX + NB;

    /// The element `(g, x_1 .. x_NX, X_1 .. X_NB)`.
    #[inline]
    pub fn new(frame: G, fixed: [SVector<S, D>; NX], body: [SVector<S, D>; NB]) -> Self {
        let () = Self::SIZES;
        Self { frame, fixed, body }
    }

    /// The frame `g`.
    #[inline]
    pub fn frame(&self) -> G {
        self.frame
    }

    /// The fixed-frame vectors `x_i`.
    #[inline]
    pub fn fixed(&self) -> &[SVector<S, D>; NX] {
        &self.fixed
    }

    /// The body-frame vectors `X_j`.
    #[inline]
    pub fn body(&self) -> &[SVector<S, D>; NB] {
        &self.body
    }

    /// Action on a point through the fixed-frame vector `i`: `g * p + x_i`; just `g * p` for `i >= NX`.
    #[inline]
    pub fn act_through(&self, i: usize, p: &SVector<S, D>) -> SVector<S, D> {
        let turned = self.frame.act(p);
        match self.fixed.get(i) {
            Some(x) => turned.zip_map(x, |a, b| a + b),
            None => turned,
        }
    }

    /// Action from the right on a point of the body through the body-frame vector `j`: `g^-1 * q + X_j`; just `g^-1 * q` for `j >= NB`.
    ///
    /// `(X Y)` acts as `X` and then `Y`: it is what an output in body coordinates transforms by.
    #[inline]
    pub fn act_body(&self, j: usize, q: &SVector<S, D>) -> SVector<S, D> {
        let turned = self.frame.act_inv(q);
        match self.body.get(j) {
            Some(x) => turned.zip_map(x, |a, b| a + b),
            None => turned,
        }
    }

    /// Vector `k` of a tangent vector, fixed-frame ones first.
    #[inline]
    fn vector(xi: &SVector<S, N>, k: usize) -> SVector<S, D> {
        part(xi, DG + D * k)
    }

    /// `[head 0; column(k), block]` with a block row for every vector.
    #[inline]
    fn block_lower(
        head: &SMatrix<S, DG, DG>,
        block: &SMatrix<S, D, D>,
        column: impl Fn(usize) -> SMatrix<S, D, DG>,
    ) -> SMatrix<S, N, N> {
        let () = Self::SIZES;
        let mut matrix = SMatrix::from_element(S::zero());
        put(&mut matrix, 0, 0, head);
        for k in 0..NX + NB {
            let row = DG + D * k;
            put(&mut matrix, row, 0, &column(k));
            put(&mut matrix, row, row, block);
        }
        matrix
    }

    /// `[top, columns ..; 0, bottom]` of the size of the matrix form.
    fn homogeneous(top: &DMatrix<S>, bottom: S, column: impl Fn(usize) -> SVector<S, D>) -> DMatrix<S> {
        let columns: Vec<_> = (0..NX + NB).map(column).collect();
        DMatrix::from_fn(Self::MATRIX, Self::MATRIX, |row, col| match (row < D, col < D) {
            (true, true) => top[(row, col)],
            (true, false) => columns[col - D][row],
            (false, _) if row == col => bottom,
            (false, _) => S::zero(),
        })
    }
}

impl<G, S, const D: usize, const NX: usize, const NB: usize, const DG: usize, const N: usize> LieGroup<S, N, D>
    for TwoFrame<G, S, D, NX, NB, DG, N>
where
    S: Coeff,
    G: FrameGroup<S, D, DG>,
{
    #[inline]
    fn identity() -> Self {
        let zero = SVector::from_element(S::zero());
        Self::new(G::identity(), [zero; NX], [zero; NB])
    }

    #[inline]
    fn exp(xi: &SVector<S, N>) -> Self {
        let (frame, forth, back) = G::exp_maps(&part(xi, 0));
        let fixed = std::array::from_fn(|i| apply(&forth, &Self::vector(xi, i)));
        let body = std::array::from_fn(|j| apply(&back, &Self::vector(xi, NX + j)));
        Self::new(frame, fixed, body)
    }

    #[inline]
    fn log(&self) -> Result<SVector<S, N>, GroupError> {
        let (w, forth, back) = self.frame.log_maps()?;
        let mut xi = SVector::<S, N>::from_element(S::zero());
        for row in 0..DG {
            xi[row] = w[row];
        }
        for k in 0..NX + NB {
            let start = DG + D * k;
            let (map, vector) = if k < NX { (&forth, &self.fixed[k]) } else { (&back, &self.body[k - NX]) };
            let image = apply(map, vector);
            for row in 0..D {
                vector[row].check_finite(start + row)?;
                xi[start + row] = image[row];
            }
        }
        Ok(xi)
    }

    #[inline]
    fn compose(&self, other: &Self) -> Self {
        let fixed = std::array::from_fn(|i| self.frame.act(&other.fixed[i]).zip_map(&self.fixed[i], |a, b| a + b));
        let body = std::array::from_fn(|j| other.frame.act_inv(&self.body[j]).zip_map(&other.body[j], |a, b| a + b));
        Self { frame: self.frame.compose(&other.frame), fixed, body }
    }

    #[inline]
    fn inverse(&self) -> Self {
        let fixed = std::array::from_fn(|i| self.frame.act_inv(&self.fixed[i]).map(|v| -v));
        let body = std::array::from_fn(|j| self.frame.act(&self.body[j]).map(|v| -v));
        Self { frame: self.frame.inverse(), fixed, body }
    }

    #[inline]
    fn act(&self, p: &SVector<S, D>) -> SVector<S, D> {
        self.act_through(0, p)
    }

    #[inline]
    fn act_linear(&self) -> SMatrix<S, D, D> {
        self.frame.act_linear()
    }

    /// `[B(p), I, 0 ..]`.
    #[inline]
    fn act_jacobian(p: &SVector<S, D>) -> SMatrix<S, D, N> {
        let turned = G::act_jacobian(p);
        SMatrix::from_fn(|row, col| {
            if col < DG {
                turned[(row, col)]
            } else if NX > 0 && col == DG + row {
                S::one()
            } else {
                S::zero()
            }
        })
    }

    #[inline]
    fn adjoint(&self) -> SMatrix<S, N, N> {
        Self::block_lower(&self.frame.adjoint(), &self.frame.act_linear(), |k| {
            if k < NX {
                self.frame.coupling_adjoint(&self.fixed[k])
            } else {
                self.frame.coupling_adjoint(&self.frame.act(&self.body[k - NX]))
            }
        })
    }

    #[inline]
    fn ad(xi: &SVector<S, N>) -> SMatrix<S, N, N> {
        let w = part(xi, 0);
        Self::block_lower(&G::ad(&w), &G::rep(&w), |k| G::act_jacobian(&Self::vector(xi, k)).map(|v| -v))
    }

    #[inline]
    fn jl(xi: &SVector<S, N>) -> SMatrix<S, N, N> {
        let (head, block, slopes) = G::jl_parts(&part(xi, 0));
        Self::block_lower(&head, &block, |k| G::coupling(&slopes, &Self::vector(xi, k)))
    }

    #[inline]
    fn jl_inv(xi: &SVector<S, N>) -> Result<SMatrix<S, N, N>, GroupError> {
        let (head, block, slopes) = G::jl_inv_parts(&part(xi, 0))?;
        Ok(Self::block_lower(&head, &block, |k| G::coupling_inv(&slopes, &Self::vector(xi, k))))
    }

    fn hat(xi: &SVector<S, N>) -> DMatrix<S> {
        Self::homogeneous(&G::hat(&part(xi, 0)), S::zero(), |k| Self::vector(xi, k))
    }

    fn vee(matrix: &DMatrix<S>) -> Result<SVector<S, N>, GroupError> {
        let size = Self::MATRIX;
        let (found_rows, found_cols) = matrix.shape();
        if (found_rows, found_cols) != (size, size) {
            return Err(GroupError::Shape { expected: size, found_rows, found_cols });
        }
        let w = G::vee(&matrix.view((0, 0), (D, D)).clone_owned())?;
        checked_vee(
            matrix,
            size,
            |m| SVector::from_fn(|row, _| if row < DG { w[row] } else { m[((row - DG) % D, D + (row - DG) / D)] }),
            Self::hat,
        )
    }

    fn matrix(&self) -> DMatrix<S> {
        Self::homogeneous(&self.frame.matrix(), S::one(), |k| {
            if k < NX { self.fixed[k] } else { self.frame.act(&self.body[k - NX]) }
        })
    }
}
