//! The zonotope of estimation errors and its step, shared by the filters with a gain.
//!
//! `H+ = [(A - L C) R_s(H), D_w H_w, -L D_v H_v]`, paper 000 (10d). The set of the step is built in a second buffer and exchanged
//! at the end, so an error on the way leaves the current set as it was; in steady state nothing is allocated.

use nalgebra::{DMatrix, SMatrix, SVector};
use setrep::{Matrix, Reduction, SetError, Workspace, Zonotope};

use crate::EstimatorError;
use crate::error::{check_finite, check_size};
use crate::gain::{Gain, f_radius_gain, place};

/// Up to this order memory is reserved beforehand, so that no step allocates; beyond it sets grow as they need to.
const RESERVED_ORDER: usize = 4096;

/// A placed gain with the pair it belongs to.
#[derive(Debug, Clone)]
struct Placed<const N: usize, const M: usize> {
    a: SMatrix<f64, N, N>,
    c: SMatrix<f64, M, N>,
    gain: SMatrix<f64, N, M>,
}

/// The set of errors of `N` coordinates, corrected by `M` outputs.
#[derive(Debug, Clone)]
pub(crate) struct ErrorSet<const N: usize, const M: usize> {
    current: Zonotope,
    next: Zonotope,
    reduction: Option<(Reduction, usize)>,
    gain: Gain<N, M>,
    placed: Option<Placed<N, M>>,
    map: Matrix,
    process: Matrix,
    output: Matrix,
    covariation: Matrix,
    workspace: Workspace,
}

impl<const N: usize, const M: usize> ErrorSet<N, M> {
    /// Starts with `initial`, whose box remainder becomes generators; the noises have `process` and `output` generators.
    pub(crate) fn new(initial: &Zonotope, process: usize, output: usize) -> Result<Self, EstimatorError> {
        check_size("initial set", N, initial.dim())?;
        let mut current = initial.clone();
        current.materialize();
        Ok(Self {
            next: current.clone(),
            current,
            reduction: None,
            gain: Gain::FRadius,
            placed: None,
            map: Matrix::zeros(N, N),
            process: Matrix::zeros(N, process),
            output: Matrix::zeros(N, output),
            covariation: Matrix::zeros(N, N),
            workspace: Workspace::new(),
        })
    }

    pub(crate) fn set(&self) -> &Zonotope {
        &self.current
    }

    pub(crate) fn gain_rule(&self) -> &Gain<N, M> {
        &self.gain
    }

    pub(crate) fn set_gain_rule(&mut self, gain: Gain<N, M>) {
        self.gain = gain;
        self.placed = None;
    }

    pub(crate) fn reduction(&self) -> Option<(Reduction, usize)> {
        self.reduction
    }

    /// `None`: no reduction, the order grows with every step.
    pub(crate) fn set_reduction(&mut self, reduction: Option<(Reduction, usize)>) -> Result<(), EstimatorError> {
        if let Some((_, order)) = reduction {
            if order < N {
                return Err(SetError::TooFewGenerators { max_generators: order, dim: N }.into());
            }
            // An order that no run reaches must not reserve memory that no run needs.
            let columns = order.min(RESERVED_ORDER) + N + self.process.cols() + self.output.cols();
            self.current.reserve_generators(columns.saturating_sub(self.current.num_generators()));
            self.next.reserve_generators(columns.saturating_sub(self.next.num_generators()));
        }
        self.reduction = reduction;
        Ok(())
    }

    /// `next = R_s(current)`.
    pub(crate) fn begin(&mut self) -> Result<(), EstimatorError> {
        self.next.clone_from(&self.current);
        if let Some((method, order)) = self.reduction {
            self.next.reduce(method, order, &mut self.workspace)?;
        }
        Ok(())
    }

    /// `next = next + x`; exact where the center of `next` is 0 or `-x`.
    pub(crate) fn translate(&mut self, x: &SVector<f64, N>) -> Result<(), EstimatorError> {
        Ok(self.next.translate(x.as_slice())?)
    }

    /// The gain for the reduced set, by the rule. `whole_step`: `a` is the model's, not the identity of an update alone.
    pub(crate) fn gain(
        &mut self,
        a: &SMatrix<f64, N, N>,
        c: &SMatrix<f64, M, N>,
        q_v: &SMatrix<f64, M, M>,
        whole_step: bool,
    ) -> Result<SMatrix<f64, N, M>, EstimatorError> {
        match &self.gain {
            Gain::FRadius => {
                self.next.covariation_into(&mut self.covariation);
                f_radius_gain(a, &self.covariation.to_smatrix()?, c, q_v)
            }
            Gain::Fixed(gain) => {
                check_finite("fixed gain", gain.as_slice())?;
                Ok(*gain)
            }
            Gain::Poles(_) if !whole_step => Err(EstimatorError::GainNeedsInput),
            Gain::Poles(poles) => match &self.placed {
                Some(placed) if placed.a == *a && placed.c == *c => Ok(placed.gain),
                _ => {
                    let pair = (
                        DMatrix::from_column_slice(N, N, a.as_slice()),
                        DMatrix::from_column_slice(M, N, c.as_slice()),
                    );
                    let gain = SMatrix::from_column_slice(place(&pair.0, &pair.1, poles)?.as_slice());
                    self.placed = Some(Placed { a: *a, c: *c, gain });
                    Ok(gain)
                }
            },
        }
    }

    /// `next = map next`.
    pub(crate) fn map(&mut self, map: &SMatrix<f64, N, N>) -> Result<(), EstimatorError> {
        self.map.assign(map);
        Ok(self.next.linear_map_in_place(&self.map, &mut self.workspace)?)
    }

    /// `next = next + { sum_j column(j) xi_j }` over the generators of the process noise.
    pub(crate) fn add_process(&mut self, column: impl FnMut(usize) -> SVector<f64, N>) -> Result<(), EstimatorError> {
        fill(&mut self.process, column);
        Ok(self.next.append_generators(&self.process)?)
    }

    /// `next = next + { sum_j column(j) xi_j }` over the generators of the output noise.
    pub(crate) fn add_output(&mut self, column: impl FnMut(usize) -> SVector<f64, N>) -> Result<(), EstimatorError> {
        fill(&mut self.output, column);
        Ok(self.next.append_generators(&self.output)?)
    }

    /// `current = next`.
    pub(crate) fn commit(&mut self) {
        std::mem::swap(&mut self.current, &mut self.next);
    }
}

fn fill<const N: usize>(matrix: &mut Matrix, mut column: impl FnMut(usize) -> SVector<f64, N>) {
    for j in 0..matrix.cols() {
        matrix.col_mut(j).copy_from_slice(column(j).as_slice());
    }
}

/// The generators of a noise set of dimension `dim` around 0, box remainder included.
pub(crate) fn noise_generators(what: &'static str, noise: &Zonotope, dim: usize) -> Result<Matrix, EstimatorError> {
    check_size(what, dim, noise.dim())?;
    check_centered(what, noise)?;
    let mut noise = noise.clone();
    noise.materialize();
    Ok(noise.generators().clone())
}

/// `Ok` if the center of the set is 0.
pub(crate) fn check_centered(what: &'static str, set: &Zonotope) -> Result<(), EstimatorError> {
    match set.center().iter().position(|c| *c != 0.0) {
        None => Ok(()),
        Some(index) => Err(EstimatorError::NotCentered { what, index, value: set.center()[index] }),
    }
}
