//! The quarter disk x^2 + y^2 < 2/pi.
//!
//! **What.** 1 inside, 0 outside: a curved edge, which no elementary interval follows.
//!
//! **Integral and variance.** The radius sqrt(2/pi) = 0.798 is below 1, so that the area is
//! (pi/4)(2/pi) = 1/2; the variance of a function of two equally likely values 0 and 1 is 1/4.

use super::Integrand;
use crate::catalogue::{About, Entry, Paper};
use std::f64::consts::FRAC_2_PI;

/// The integrand `disk`.
pub struct Disk;

static ABOUT: About = About {
    key: "disk",
    title: "Disk",
    summary: "1 inside the quarter disk of area 1/2, 0 outside: a curved edge.",
    file: "integrands/disk.rs",
    source: include_str!("disk.rs"),
    papers: &[Paper {
        authors: "P. Christensen, A. Kensler and C. Kilpatrick",
        year: 2018,
        title: "Progressive Multi-Jittered Sample Sequences",
        venue: "Computer Graphics Forum 37(4), 21-33",
        doi: Some("10.1111/cgf.13472"),
    }],
};

impl Entry for Disk {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for Disk {
    fn dimensions(&self) -> Option<usize> {
        Some(2)
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        f64::from(x[0] * x[0] + x[1] * x[1] < FRAC_2_PI)
    }

    fn integral(&self, _d: usize) -> Option<f64> {
        Some(0.5)
    }

    fn variance(&self, _d: usize) -> Option<f64> {
        Some(0.25)
    }

    fn formula(&self) -> &'static str {
        r"\left[x^2 + y^2 < 2/\pi\right]"
    }
}
