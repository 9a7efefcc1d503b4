//! Bounded noises: four ways to draw a vector from the closed box `{ v : |v_i| <= bound_i }`, of a fixed dimension or of any.

use rand::{Rng, RngExt};

/// Distance kept from every bound: a noise "at its bound" `b` is at `b - MARGIN`.
///
/// Small enough to count as the bound (within 1e-12), large enough that the rounding of a simulated step (see
/// [`crate::truth`]) leaves the noise inside.
pub const MARGIN: f64 = 8e-13;

/// Standard deviations of the truncated Gaussian that fit between zero and the bound.
const SIGMAS_TO_THE_BOUND: f64 = 3.0;

/// How a noise vector is drawn from its box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoiseKind {
    /// Every component uniform between its bounds.
    Uniform,
    /// At every step a vertex of the box, each with the same probability.
    Vertices,
    /// One vertex, drawn once, at every step: the worst case of many filters.
    ConstantVertex,
    /// Gaussian of standard deviation `bound / 3`, drawn again while outside the box.
    TruncatedGaussian,
}

impl NoiseKind {
    /// All kinds, in the order of the reports.
    pub const ALL: [Self; 4] = [Self::Uniform, Self::Vertices, Self::ConstantVertex, Self::TruncatedGaussian];

    /// The name used in rows and tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Vertices => "vertices",
            Self::ConstantVertex => "constant vertex",
            Self::TruncatedGaussian => "truncated gaussian",
        }
    }
}

/// A source of noise vectors in a box of `N` dimensions.
#[derive(Clone, Debug)]
pub struct BoundedNoise<const N: usize> {
    kind: NoiseKind,
    /// The bounds, moved inwards by [`MARGIN`].
    inner: [f64; N],
    /// The vertex of [`NoiseKind::ConstantVertex`], once drawn.
    held: Option<[f64; N]>,
}

impl<const N: usize> BoundedNoise<N> {
    /// A noise in `{ v : |v_i| <= bounds_i }`; bounds are finite and not negative (the sign is dropped).
    #[must_use]
    pub fn new(kind: NoiseKind, bounds: [f64; N]) -> Self {
        Self { kind, inner: bounds.map(|bound| (bound.abs() - MARGIN).max(0.0)), held: None }
    }

    /// The next vector.
    ///
    /// **Guarantee:** `|v_i| <= max(bound_i - MARGIN, 0)`, up to one rounding.
    pub fn draw<R: Rng>(&mut self, rng: &mut R) -> [f64; N] {
        match self.kind {
            NoiseKind::Uniform => self.inner.map(|bound| bound * (2.0 * rng.random::<f64>() - 1.0)),
            NoiseKind::Vertices => vertex(&self.inner, rng),
            NoiseKind::ConstantVertex => *self.held.get_or_insert_with(|| vertex(&self.inner, rng)),
            NoiseKind::TruncatedGaussian => self.inner.map(|bound| bound * truncated_gaussian(rng)),
        }
    }
}

/// A source of noise vectors in a box of any dimension: every kind is drawn entry by entry.
#[derive(Clone, Debug)]
pub struct BoxNoise {
    entries: Vec<BoundedNoise<1>>,
}

impl BoxNoise {
    /// A noise in `{ v : |v_i| <= bounds_i }`, as [`BoundedNoise::new`].
    #[must_use]
    pub fn new(kind: NoiseKind, bounds: &[f64]) -> Self {
        Self { entries: bounds.iter().map(|&bound| BoundedNoise::new(kind, [bound])).collect() }
    }

    /// The next vector.
    ///
    /// **Guarantee:** as [`BoundedNoise::draw`].
    pub fn draw<R: Rng>(&mut self, rng: &mut R) -> Vec<f64> {
        self.entries.iter_mut().map(|entry| entry.draw(rng)[0]).collect()
    }
}

/// One of the `2^N` vertices of the box.
fn vertex<const N: usize, R: Rng>(bounds: &[f64; N], rng: &mut R) -> [f64; N] {
    bounds.map(|bound| if rng.random::<bool>() { bound } else { -bound })
}

/// A Gaussian of standard deviation 1/3, given that it lies in `[-1, 1]` (rejection: 0.3 % are drawn again).
fn truncated_gaussian<R: Rng>(rng: &mut R) -> f64 {
    loop {
        let value = standard_normal(rng) / SIGMAS_TO_THE_BOUND;
        if value.abs() <= 1.0 {
            return value;
        }
    }
}

/// A Gaussian of mean 0 and standard deviation 1, without bounds (Box-Muller).
pub fn standard_normal<R: Rng>(rng: &mut R) -> f64 {
    // 1 - u lies in (0, 1], where the logarithm is finite.
    let radius = (-2.0 * (1.0 - rng.random::<f64>()).ln()).sqrt();
    radius * (std::f64::consts::TAU * rng.random::<f64>()).cos()
}
