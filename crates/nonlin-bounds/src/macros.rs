//! [`function!`](crate::function): a function without a type of its own.

/// A [`Function`](crate::Function) from a closure-like body.
///
/// `function!(|x: n| -> m { [..; m] })`, or with parameters `function!(|x: n, p: q| -> m { [..; m] })`. `x` and `p` are arrays (any
/// pattern), the body gives the array of outputs, and `S` names the number type, for constants as `S::ratio(1, 7)`. Nothing is captured:
/// what changes from call to call is a parameter.
///
/// ```
/// use nonlin_bounds::{DynFunction, Jet, Order, function};
/// use scalars::Interval;
///
/// let pendulum = function!(|[angle, rate]: 2, [damping]: 1| -> 2 {
///     [rate, -S::decimal("9.81") * angle.sin() - damping * rate]
/// });
/// let mut jet = Jet::new();
/// let x = [Interval::new(-0.1, 0.1)?, Interval::new(0.0, 1.0)?];
/// pendulum.enclose(Order::Jacobian, &x, &[Interval::point(0.5)], &mut jet)?;
/// assert_eq!(jet.jacobian()[0], Interval::ZERO);
/// assert_eq!(jet.jacobian()[1], Interval::ONE);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[macro_export]
macro_rules! function {
    (|$x:tt: $n:literal| -> $m:literal $body:block) => {
        $crate::function!(|$x: $n, []: 0| -> $m $body)
    };
    (|$x:tt: $n:literal, $p:tt: $q:literal| -> $m:literal $body:block) => {{
        #[derive(Debug, Clone, Copy)]
        struct Body;
        impl $crate::Function for Body {
            const VARIABLES: Option<usize> = Some($n);
            fn parameters(&self) -> usize {
                $q
            }
            fn outputs(&self) -> usize {
                $m
            }
            fn eval<S: $crate::scalars::Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
                let $x: [S; $n] = std::array::from_fn(|i| x[i]);
                let $p: [S; $q] = std::array::from_fn(|i| p[i]);
                let values: [S; $m] = $body;
                y.copy_from_slice(&values);
            }
        }
        Body
    }};
}
