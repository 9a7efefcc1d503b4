//! Exact signs of sums of products: the last word where an enclosure can not decide.
//!
//! A product of two floats is an integer of 106 bits times a power of two between `2^-2148` and `2^1942`. All of them are
//! added up as one fixed-point number, so nothing is rounded, overflows or underflows. Idea: Kulisch's long accumulator.

use core::cmp::Ordering;

/// Bits of a digit; a digit has room for the carries of 2^30 products.
const DIGIT: u32 = 32;

/// The exponent of the lowest bit.
const LOWEST: i32 = -2148;

/// `2148 + 1942 + 106` bits and the carries of 2^26 products.
const DIGITS: usize = 134;

/// The sign of the exact `sum_k a_k b_k` of up to 2^26 products of finite numbers.
pub(crate) fn sign_of_sum(products: impl Iterator<Item = (f64, f64)>) -> Ordering {
    let mut digits = [0_i64; DIGITS];
    for (a, b) in products {
        let ((a_digits, a_exponent), (b_digits, b_exponent)) = (parts(a), parts(b));
        let negative = a.is_sign_negative() != b.is_sign_negative();
        let shift = (a_exponent + b_exponent - LOWEST) as u32;
        let mut rest = u128::from(a_digits) * u128::from(b_digits);
        // The lowest digit takes what is left of it after the shift, the others a whole digit each.
        let mut k = (shift / DIGIT) as usize;
        let mut taken = DIGIT - shift % DIGIT;
        let mut place = shift % DIGIT;
        while rest != 0 {
            let part = ((rest & ((1 << taken) - 1)) << place) as i64;
            digits[k] += if negative { -part } else { part };
            rest >>= taken;
            (k, taken, place) = (k + 1, DIGIT, 0);
        }
    }
    let mut carry = 0;
    let mut zero = true;
    for digit in digits {
        let sum = digit + carry;
        carry = sum >> DIGIT;
        zero &= sum & ((1 << DIGIT) - 1) == 0;
    }
    match carry {
        0 if zero => Ordering::Equal,
        0.. => Ordering::Greater,
        _ => Ordering::Less,
    }
}

/// Compares the exact `sum a_j x_j` with a number; an infinite one is beyond every sum.
pub(crate) fn compare_dot(a: &[f64], x: &[f64], with: f64) -> Ordering {
    if with.is_infinite() {
        return 0.0_f64.total_cmp(&with);
    }
    sign_of_sum(a.iter().copied().zip(x.iter().copied()).chain([(with, -1.0)]))
}

/// The modulus of a finite number as an integer times a power of two.
fn parts(value: f64) -> (u64, i32) {
    let (digits, exponent) = (value.to_bits() & ((1 << 52) - 1), ((value.to_bits() >> 52) & 0x7ff) as i32);
    if exponent == 0 { (digits, -1074) } else { (digits | 1 << 52, exponent - 1075) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sign(products: &[(f64, f64)]) -> Ordering {
        sign_of_sum(products.iter().copied())
    }

    #[test]
    fn the_last_bit_decides() {
        let big = f64::MAX;
        let tiny = f64::from_bits(1);
        assert_eq!(sign(&[]), Ordering::Equal);
        assert_eq!(sign(&[(big, big), (tiny, tiny), (-big, big)]), Ordering::Greater);
        assert_eq!(sign(&[(big, big), (tiny, -tiny), (-big, big)]), Ordering::Less);
        assert_eq!(sign(&[(big, big), (-0.0, big), (-big, big)]), Ordering::Equal);
        assert_eq!(sign(&[(big, 2.0), (-big, 1.0), (-big, 1.0), (tiny, tiny)]), Ordering::Greater);
        // 0.1 + 0.2 - 0.3 is 2^-55 and a half of an ulp of 0.3, as numbers.
        assert_eq!(sign(&[(0.1, 1.0), (0.2, 1.0), (0.3, -1.0)]), Ordering::Greater);
        assert_eq!(sign(&[(0.1, 10.0), (1.0, -1.0)]), Ordering::Greater);
        assert_eq!(sign(&[(1.0 / 3.0, 3.0), (1.0, -1.0)]), Ordering::Less);
    }

    #[test]
    fn many_carries_are_kept() {
        let products = (0..100_000).flat_map(|_| [(f64::MAX, f64::MAX), (-1e-300, 1e-8)]);
        assert_eq!(sign_of_sum(products.clone()), Ordering::Greater);
        let back = (0..100_000).flat_map(|_| [(-f64::MAX, f64::MAX), (1e-300, 1e-8)]);
        assert_eq!(sign_of_sum(products.chain(back)), Ordering::Equal);
    }

    #[test]
    fn infinite_ends_are_beyond_every_sum() {
        assert_eq!(compare_dot(&[1.0], &[1.0], f64::INFINITY), Ordering::Less);
        assert_eq!(compare_dot(&[1.0], &[1.0], f64::NEG_INFINITY), Ordering::Greater);
        assert_eq!(compare_dot(&[0.1, 0.2], &[1.0, 1.0], 0.3), Ordering::Greater);
    }
}
