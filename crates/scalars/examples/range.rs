//! The range of a model over a box, and decimal constants that are not floating-point numbers.
//!
//! `cargo run --release -p scalars --example range`

use scalars::{Interval, Scalar, ScalarError};

/// Height of a projectile after `t` seconds: speed 20 m/s, elevation in radians, gravity 9.81 m/s^2. Written once, for
/// numbers and for intervals; the constant is the decimal, not the float next to it.
fn height<S: Scalar>(t: S, elevation: S) -> S {
    elevation.sin().scale(20.0) * t - S::decimal("9.81").scale(0.5) * t.sqr()
}

/// Encloses a range by cutting the first argument into pieces: less overestimation, still a superset.
fn height_in_pieces(t: Interval, elevation: Interval, pieces: u32) -> Interval {
    let cut = |i: u32| t.lo() + (t.hi() - t.lo()) * f64::from(i) / f64::from(pieces);
    (0..pieces).fold(Interval::EMPTY, |range, i| {
        let hi = if i + 1 == pieces { t.hi() } else { cut(i + 1) };
        let piece = Interval::new(cut(i), hi).unwrap_or(t);
        range.hull(height(piece, elevation))
    })
}

fn main() -> Result<(), ScalarError> {
    let t: Interval = "[0.9, 1.1]".parse()?;
    let elevation = Interval::pi().scale(0.25).inflate(0.01);
    println!("t = {t} s, elevation = {elevation:.4} rad");
    println!("at the midpoint  {:.6} m", height(t.mid(), elevation.mid()));
    for pieces in [1, 10, 100] {
        println!("in {pieces:>3} pieces    {:.6} m", height_in_pieces(t, elevation, pieces));
    }

    let tenth = Interval::decimal("0.1");
    let ten_tenths = (0..10).fold(Interval::ZERO, |sum, _| sum + tenth);
    println!("ten times 0.1    {ten_tenths}");
    println!("1/7              {}", Interval::ratio(1, 7));
    println!("1 / [-1, 2]      {}", Interval::ONE / Interval::new(-1.0, 2.0)?);
    println!("sqrt [-1, 4]     {:.3}", Interval::new(-1.0, 4.0)?.sqrt());
    println!("ln [-2, -1]      {}", Interval::new(-2.0, -1.0)?.ln());
    Ok(())
}
