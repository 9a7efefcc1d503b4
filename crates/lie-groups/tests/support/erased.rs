//! Groups behind one object type: the batteries are compiled once for all groups, not once for each.

use std::any::Any;
use std::marker::PhantomData;
use std::rc::Rc;

use lie_groups::{Coeff, GroupError, LieGroup};
use nalgebra::{Const, DMatrix, DVector, Matrix, RawStorage, SVector};

/// An element of any group.
pub(crate) type Element = Rc<dyn Any>;

/// A group over the scalar `S` as an object; vectors and matrices have the sizes of the group.
pub(crate) trait Group<S: Coeff> {
    /// `(N, D)`: dimensions of the tangent and of the space acted on.
    fn dims(&self) -> (usize, usize);
    fn identity(&self) -> Element;
    fn exp(&self, xi: &DVector<S>) -> Element;
    fn log(&self, x: &Element) -> Result<DVector<S>, GroupError>;
    fn compose(&self, x: &Element, y: &Element) -> Element;
    fn inverse(&self, x: &Element) -> Element;
    fn act(&self, x: &Element, p: &DVector<S>) -> DVector<S>;
    fn act_linear(&self, x: &Element) -> DMatrix<S>;
    fn act_jacobian(&self, p: &DVector<S>) -> DMatrix<S>;
    fn adjoint(&self, x: &Element) -> DMatrix<S>;
    fn ad(&self, xi: &DVector<S>) -> DMatrix<S>;
    fn jl(&self, xi: &DVector<S>) -> DMatrix<S>;
    fn jr(&self, xi: &DVector<S>) -> DMatrix<S>;
    fn jl_inv(&self, xi: &DVector<S>) -> Result<DMatrix<S>, GroupError>;
    fn jr_inv(&self, xi: &DVector<S>) -> Result<DMatrix<S>, GroupError>;
    fn hat(&self, xi: &DVector<S>) -> DMatrix<S>;
    fn vee(&self, m: &DMatrix<S>) -> Result<DVector<S>, GroupError>;
    fn matrix(&self, x: &Element) -> DMatrix<S>;
    fn interpolate(&self, a: &Element, b: &Element, t: S) -> Result<Element, GroupError>;
}

/// The group `G`.
pub(crate) struct Erased<G, const N: usize, const D: usize>(PhantomData<G>);

impl<G, const N: usize, const D: usize> Erased<G, N, D> {
    pub(crate) fn new() -> Self {
        Self(PhantomData)
    }
}

fn fixed<S: Coeff, const K: usize>(v: &DVector<S>) -> SVector<S, K> {
    SVector::from_column_slice(v.as_slice())
}

fn dynamic<S: Coeff, const R: usize, const C: usize, T>(m: &Matrix<S, Const<R>, Const<C>, T>) -> DMatrix<S>
where
    T: RawStorage<S, Const<R>, Const<C>>,
{
    DMatrix::from_fn(R, C, |row, col| m[(row, col)])
}

fn vector<S: Coeff, const K: usize>(v: &SVector<S, K>) -> DVector<S> {
    DVector::from_column_slice(v.as_slice())
}

fn element<G: 'static>(x: &Element) -> &G {
    x.downcast_ref().unwrap()
}

impl<G, S, const N: usize, const D: usize> Group<S> for Erased<G, N, D>
where
    G: LieGroup<S, N, D> + 'static,
    S: Coeff,
{
    fn dims(&self) -> (usize, usize) {
        (N, D)
    }
    fn identity(&self) -> Element {
        Rc::new(G::identity())
    }
    fn exp(&self, xi: &DVector<S>) -> Element {
        Rc::new(G::exp(&fixed(xi)))
    }
    fn log(&self, x: &Element) -> Result<DVector<S>, GroupError> {
        element::<G>(x).log().map(|xi| vector(&xi))
    }
    fn compose(&self, x: &Element, y: &Element) -> Element {
        Rc::new(element::<G>(x).compose(element(y)))
    }
    fn inverse(&self, x: &Element) -> Element {
        Rc::new(element::<G>(x).inverse())
    }
    fn act(&self, x: &Element, p: &DVector<S>) -> DVector<S> {
        vector(&element::<G>(x).act(&fixed(p)))
    }
    fn act_linear(&self, x: &Element) -> DMatrix<S> {
        dynamic(&element::<G>(x).act_linear())
    }
    fn act_jacobian(&self, p: &DVector<S>) -> DMatrix<S> {
        dynamic(&G::act_jacobian(&fixed(p)))
    }
    fn adjoint(&self, x: &Element) -> DMatrix<S> {
        dynamic(&element::<G>(x).adjoint())
    }
    fn ad(&self, xi: &DVector<S>) -> DMatrix<S> {
        dynamic(&G::ad(&fixed(xi)))
    }
    fn jl(&self, xi: &DVector<S>) -> DMatrix<S> {
        dynamic(&G::jl(&fixed(xi)))
    }
    fn jr(&self, xi: &DVector<S>) -> DMatrix<S> {
        dynamic(&G::jr(&fixed(xi)))
    }
    fn jl_inv(&self, xi: &DVector<S>) -> Result<DMatrix<S>, GroupError> {
        G::jl_inv(&fixed(xi)).map(|m| dynamic(&m))
    }
    fn jr_inv(&self, xi: &DVector<S>) -> Result<DMatrix<S>, GroupError> {
        G::jr_inv(&fixed(xi)).map(|m| dynamic(&m))
    }
    fn hat(&self, xi: &DVector<S>) -> DMatrix<S> {
        G::hat(&fixed(xi))
    }
    fn vee(&self, m: &DMatrix<S>) -> Result<DVector<S>, GroupError> {
        G::vee(m).map(|xi| vector(&xi))
    }
    fn matrix(&self, x: &Element) -> DMatrix<S> {
        element::<G>(x).matrix()
    }
    fn interpolate(&self, a: &Element, b: &Element, t: S) -> Result<Element, GroupError> {
        Ok(Rc::new(G::interpolate(element(a), element(b), t)?))
    }
}
