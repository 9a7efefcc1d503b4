//! A list of poles, checked and paired.

use nalgebra::Complex;

use crate::EstimatorError;
use crate::error::check_finite;

/// One real pole, or a complex one that stands for itself and its conjugate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Pole {
    Real(f64),
    /// The member with positive imaginary part.
    Pair(Complex<f64>),
}

impl Pole {
    /// Number of eigenvalues it stands for.
    pub(super) fn count(self) -> usize {
        match self {
            Self::Real(_) => 1,
            Self::Pair(_) => 2,
        }
    }
}

/// The poles in the order given, conjugates joined; each at most `rank` times.
pub(super) fn pair_up(poles: &[Complex<f64>], states: usize, rank: usize) -> Result<Vec<Pole>, EstimatorError> {
    if poles.len() != states {
        return Err(EstimatorError::PoleCount { expected: states, found: poles.len() });
    }
    for (index, pole) in poles.iter().enumerate() {
        check_finite("poles", &[pole.re, pole.im]).map_err(|_| EstimatorError::NotFinite {
            what: "poles",
            index,
            value: pole.re + pole.im,
        })?;
    }
    let count = |p: Complex<f64>| poles.iter().filter(|q| **q == p).count();
    for &p in poles {
        if p.im != 0.0 && count(p) != count(p.conj()) {
            return Err(EstimatorError::PoleNotConjugate { re: p.re, im: p.im });
        }
        if count(p) > rank {
            return Err(EstimatorError::PoleMultiplicity { re: p.re, im: p.im, multiplicity: count(p), rank });
        }
    }
    Ok(poles
        .iter()
        .filter(|p| p.im >= 0.0)
        .map(|&p| if p.im == 0.0 { Pole::Real(p.re) } else { Pole::Pair(p) })
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conjugates_are_joined_in_order() {
        let poles = [(0.5, -0.1), (0.9, 0.0), (0.5, 0.1), (0.9, -0.0)].map(|(re, im)| Complex::new(re, im));
        let paired = pair_up(&poles, 4, 2).unwrap();
        assert_eq!(paired, [Pole::Real(0.9), Pole::Pair(Complex::new(0.5, 0.1)), Pole::Real(0.9)]);
        assert_eq!(paired.iter().map(|p| p.count()).sum::<usize>(), 4);
    }
}
