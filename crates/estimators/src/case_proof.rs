//! [`Case`]: a contradiction that is proven part by part.

use scalars::Interval;

use crate::Evidence;

/// A part of where a quantity may be, and what excludes it there: the evidence rests on rows that hold if the quantity is in `part`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Case {
    /// The part, ends included.
    pub part: Interval,
    /// Why the quantity is not there.
    pub evidence: Evidence,
}

impl Case {
    /// Whether every number of `cover` is in the part of some case. Ends are compared as they are: nothing is rounded.
    pub(crate) fn leave_nothing(cover: &Interval, cases: &[Self]) -> bool {
        if cover.is_empty() || !cover.is_bounded() {
            return false;
        }
        let mut reached = cover.lo();
        loop {
            let here = cases.iter().map(|case| &case.part).filter(|part| part.contains(reached));
            let farthest = here.map(Interval::hi).fold(f64::NEG_INFINITY, f64::max);
            if farthest >= cover.hi() {
                return true;
            }
            // Nothing is here, or nothing leads on.
            if farthest <= reached {
                return false;
            }
            reached = farthest;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cases(parts: &[[f64; 2]]) -> Vec<Case> {
        let one = |part: &[f64; 2]| Case {
            part: Interval::new(part[0], part[1]).unwrap(),
            evidence: Evidence::Disjoint { predicted: Interval::ZERO, required: Interval::ONE },
        };
        parts.iter().map(one).collect()
    }

    #[test]
    fn gaps_and_false_parts_are_found() {
        let cover = Interval::new(-1.0, 2.0).unwrap();
        let whole = cases(&[[0.5, 2.5], [-1.0, 0.0], [-0.5, 0.5]]);
        assert!(Case::leave_nothing(&cover, &whole));
        assert!(!Case::leave_nothing(&cover, &whole[..2]) && !Case::leave_nothing(&cover, &[]));
        assert!(!Case::leave_nothing(&cover, &cases(&[[-1.0, 0.5], [0.5_f64.next_up(), 2.0]])));
        assert!(!Case::leave_nothing(&cover, &cases(&[[-1.0, 2.0_f64.next_down()]])));
        assert!(!Case::leave_nothing(&cover, &cases(&[[(-1.0_f64).next_down(), -1.0], [0.0, 3.0]])));
        assert!(Case::leave_nothing(&Interval::ONE, &cases(&[[1.0, 1.0]])));
        assert!(!Case::leave_nothing(&Interval::ENTIRE, &whole));
        let proof = Evidence::Cases { cover, cases: whole.clone() };
        assert!(proof.verify() && proof.margin() == 1.0);
        let mut broken = whole;
        broken[1].evidence = Evidence::Propagation { hull: vec![] };
        let open = Evidence::Cases { cover, cases: broken };
        assert!(!open.verify() && open.margin() == 0.0);
    }
}
