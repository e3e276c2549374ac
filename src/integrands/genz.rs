//! The parameters of Genz's families: how hard an integrand is on each axis, and where its feature
//! lies.
//!
//! The course fixes them, so that a name means one function: difficulty 3/2, 2, 5/2 and shift 3/10,
//! 5/10, 7/10, repeated along the axes.

/// The difficulty a_j of axis j.
pub fn difficulty(axis: usize) -> f64 {
    [1.5, 2.0, 2.5][axis % 3]
}

/// The shift u_j of axis j.
pub fn shift(axis: usize) -> f64 {
    [0.3, 0.5, 0.7][axis % 3]
}

/// The product over `d` axes of `factor(a_j, u_j)`.
pub fn product(d: usize, factor: impl Fn(f64, f64) -> f64) -> f64 {
    (0..d).map(|axis| factor(difficulty(axis), shift(axis))).product()
}

/// The sum over the coordinates of `x` of `term(x_j, a_j, u_j)`.
pub fn sum(x: &[f64], term: impl Fn(f64, f64, f64) -> f64) -> f64 {
    x.iter().enumerate().map(|(axis, &x)| term(x, difficulty(axis), shift(axis))).sum()
}
