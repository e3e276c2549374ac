//! Elementary functions that give the same bits on every machine.
//!
//! The platform's mathematics library may round otherwise on another system, and one bit moves a
//! lock file. These forward to `pxfm`, whose results are correctly rounded up to a few parts in a
//! million, on all platforms alike. Everything in the crate that needs a transcendental function
//! takes it from here; `clippy.toml` bans the others.

/// The sine of `x` radians.
#[inline]
pub fn sin(x: f64) -> f64 {
    pxfm::f_sin(x)
}

/// The cosine of `x` radians.
#[inline]
pub fn cos(x: f64) -> f64 {
    pxfm::f_cos(x)
}

/// The tangent of `x` radians.
#[inline]
pub fn tan(x: f64) -> f64 {
    pxfm::f_tan(x)
}

/// The angle in [-pi/2, pi/2] whose sine is `x`; NaN outside [-1, 1].
#[inline]
pub fn asin(x: f64) -> f64 {
    pxfm::f_asin(x)
}

/// The angle in [0, pi] whose cosine is `x`; NaN outside [-1, 1].
#[inline]
pub fn acos(x: f64) -> f64 {
    pxfm::f_acos(x)
}

/// The angle in (-pi/2, pi/2) whose tangent is `x`.
#[inline]
pub fn atan(x: f64) -> f64 {
    pxfm::f_atan(x)
}

/// The hyperbolic sine of `x`.
#[inline]
pub fn sinh(x: f64) -> f64 {
    pxfm::f_sinh(x)
}

/// The hyperbolic cosine of `x`.
#[inline]
pub fn cosh(x: f64) -> f64 {
    pxfm::f_cosh(x)
}

/// The hyperbolic tangent of `x`.
#[inline]
pub fn tanh(x: f64) -> f64 {
    pxfm::f_tanh(x)
}

/// e to the power `x`.
#[inline]
pub fn exp(x: f64) -> f64 {
    pxfm::f_exp(x)
}

/// The natural logarithm of `x`.
#[inline]
pub fn ln(x: f64) -> f64 {
    pxfm::f_log(x)
}

/// The logarithm of `x` to base 2.
#[inline]
pub fn log2(x: f64) -> f64 {
    pxfm::f_log2(x)
}

/// The logarithm of `x` to base 10.
#[inline]
pub fn log10(x: f64) -> f64 {
    pxfm::f_log10(x)
}

/// `x` to the real power `y`.
#[inline]
pub fn pow(x: f64, y: f64) -> f64 {
    pxfm::f_pow(x, y)
}

/// The error function, 2/sqrt(pi) times the integral of exp(-t^2) from 0 to `x`.
#[inline]
pub fn erf(x: f64) -> f64 {
    pxfm::f_erf(x)
}

/// The complement 1 - erf(x), without cancellation for large `x`.
#[inline]
pub fn erfc(x: f64) -> f64 {
    pxfm::f_erfc(x)
}

/// The gamma function.
#[inline]
pub fn gamma(x: f64) -> f64 {
    pxfm::f_tgamma(x)
}

/// The natural logarithm of the absolute value of the gamma function.
#[inline]
pub fn ln_gamma(x: f64) -> f64 {
    pxfm::f_lgamma(x)
}

/// `x` to the whole power `exponent`, by repeated squaring from the lowest bit: a fixed order of
/// roundings.
#[inline]
pub fn power(x: f64, exponent: i32) -> f64 {
    let mut square = x;
    let mut result = 1.0;
    let mut left = exponent.unsigned_abs();
    while left > 0 {
        if left & 1 == 1 {
            result *= square;
        }
        square *= square;
        left >>= 1;
    }
    if exponent < 0 { 1.0 / result } else { result }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn power_multiplies() {
        assert_eq!(power(3.0, 5), 243.0);
        assert_eq!(power(2.0, -3), 0.125);
        assert_eq!(power(7.0, 0), 1.0);
        assert_eq!(power(1.0, i32::MIN), 1.0);
    }

    /// Values to 17 digits from the tables of Abramowitz and Stegun.
    #[test]
    fn known_values() {
        assert_eq!(exp(1.0), std::f64::consts::E);
        assert_eq!(ln(10.0), std::f64::consts::LN_10);
        assert_eq!(sin(1.0), 0.841_470_984_807_896_5);
        assert_eq!(cos(1.0), 0.540_302_305_868_139_8);
        assert_eq!(pow(2.0, 0.5), std::f64::consts::SQRT_2);
        assert_eq!(log2(1024.0), 10.0);
        assert_eq!(log10(1e-3), -3.0);
        assert_eq!(erf(1.0), 0.842_700_792_949_714_9);
        assert_eq!([gamma(5.0), gamma(1.0), ln_gamma(1.0)], [24.0, 1.0, 0.0]);
        assert_eq!(gamma(0.5), 1.772_453_850_905_516);
        assert!((gamma(4.0 / 3.0) - 0.892_979_511_569_249_2).abs() < 1e-15);
        assert!((ln_gamma(101.0) - 363.739_375_555_563_5).abs() < 1e-12);
    }
}
