//! The power spectrum of a point set on the torus: the periodogram itself, no transform of binned
//! points.
//!
//! **Formula.** P(w) = (1/n) | sum_i exp(-2 pi i w.x_i) |^2 at whole frequencies w = (u, v); P(0) =
//! n, and 1 is the mean for independent points. Expected for jittered points on a k x k grid: 1 -
//! prod sinc^2(w_j / k).
//!
//! **Algorithm.** exp(-2 pi i (u x + v y)) is a product of a factor in x and one in y, so that the
//! sums for all (u, v) are a product of two matrices over the points. P(-w) = P(w), and the four
//! products of cos and sin in a quarter of the plane give the other quarters.
//!
//! **Radial means.** [`Spectrum::radial`] averages over rings of width 1 with their counts; the
//! anisotropy of a ring is the variance of P over the ring, relative to the square of its mean, in
//! decibels.
//!
//! **Papers.** R. A. Ulichney, Dithering with Blue Noise, Proc. IEEE 76(1) (1988), doi
//! 10.1109/5.3288; T. Schloemer and O. Deussen, Accurate Spectral Analysis of Two-Dimensional Point
//! Sets, J. Graphics, GPU and Game Tools 15(3) (2011), doi 10.1080/2151237X.2011.609773.
//!
//! ```
//! use workbook::{metrics::spectrum::power, points::Points};
//! let grid = Points::from_rows(2, vec![0.0, 0.0, 0.5, 0.0, 0.0, 0.5, 0.5, 0.5]).unwrap();
//! let spectrum = power(&grid, 2).unwrap();
//! assert_eq!((spectrum.at(0, 0), spectrum.at(2, 0)), (4.0, 4.0));
//! assert!(spectrum.at(1, 0) < 1e-28);
//! ```

use super::{Unmeasured, check};
use crate::points::Points;
use crate::stats::portable;
use multiversion::multiversion;
use std::f64::consts::TAU;

/// The highest frequency that may be asked for.
pub const HIGHEST: usize = 4096;

/// The power at all whole frequencies up to `reach` in both axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    reach: usize,
    /// Rows v = 0 ..= reach of columns u = -reach ..= reach.
    half: Vec<f64>,
}

impl Spectrum {
    /// The highest frequency.
    pub fn reach(&self) -> usize {
        self.reach
    }

    /// P(u, v), for |u| and |v| up to the reach; NaN beyond.
    pub fn at(&self, u: i32, v: i32) -> f64 {
        let (u, v) = if v < 0 { (-u, -v) } else { (u, v) };
        let column = i64::from(u) + self.reach as i64;
        let inside = (0..=2 * self.reach as i64).contains(&column) && v as usize <= self.reach;
        if inside { self.half[v as usize * (2 * self.reach + 1) + column as usize] } else { f64::NAN }
    }

    /// The mean over several spectra of the same reach; `None` of none, or where they differ.
    pub fn average(spectra: &[Self]) -> Option<Self> {
        let reach = spectra.first()?.reach;
        if spectra.iter().any(|spectrum| spectrum.reach != reach) {
            return None;
        }
        let places = 0..spectra[0].half.len();
        let mean = |at: usize| spectra.iter().map(|spectrum| spectrum.half[at]).sum::<f64>() / spectra.len() as f64;
        Some(Self { reach, half: places.map(mean).collect() })
    }

    /// For each ring of frequencies r - 1/2 <= |w| < r + 1/2, r = 1 ..= reach: count, mean power
    /// and anisotropy.
    pub fn radial(&self) -> Vec<Ring> {
        let reach = self.reach as i32;
        let mut rings = vec![Vec::new(); self.reach + 1];
        for v in -reach..=reach {
            for u in -reach..=reach {
                let length = f64::from(u * u + v * v).sqrt();
                if let Some(ring) = rings.get_mut((length + 0.5) as usize) {
                    ring.push(self.at(u, v));
                }
            }
        }
        rings[1..].iter().map(|powers| Ring::new(powers)).collect()
    }
}

/// One ring of a radial mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// How many frequencies lie in it.
    pub count: usize,
    /// Their mean power.
    pub mean: f64,
    /// Their variance over the square of the mean, in decibels; about 0 for one realisation without
    /// a direction, lower by 10 log10 of the number of realisations averaged.
    pub anisotropy: f64,
}

impl Ring {
    fn new(powers: &[f64]) -> Self {
        let count = powers.len();
        let mean = powers.iter().sum::<f64>() / count as f64;
        let variance =
            powers.iter().map(|power| (power - mean) * (power - mean)).sum::<f64>() / (count - 1).max(1) as f64;
        Self { count, mean, anisotropy: 10.0 * portable::log10(variance / (mean * mean)) }
    }
}

/// The power spectrum of points of the plane up to the frequency `reach` in both axes.
pub fn power(points: &Points, reach: usize) -> Result<Spectrum, Unmeasured> {
    check(points)?;
    let n = points.len();
    if points.dimensions() != 2 {
        return Err(Unmeasured::Kind("the power spectrum is computed in two dimensions"));
    }
    if reach > HIGHEST {
        return Err(Unmeasured::Size { n, d: 2, limit: "frequencies go up to 4096" });
    }
    let side = reach + 1;
    let mut sums = [(); 4].map(|()| vec![0.0; side * side]);
    let mut waves: Vec<[Waves; 2]> = (0..BLOCK).map(|_| [Waves::new(side), Waves::new(side)]).collect();
    let mut rows = points.rows();
    loop {
        let block: Vec<&[f64]> = rows.by_ref().take(BLOCK).collect();
        if block.is_empty() {
            break;
        }
        for (k, [columns, rows]) in waves.iter_mut().enumerate() {
            if let Some(point) = block.get(k) {
                columns.set(point[0]);
                rows.set(point[1]);
            } else {
                // Places without a point add nothing.
                columns.clear();
                rows.clear();
            }
        }
        accumulate(&mut sums, &waves, side);
    }
    Ok(Spectrum { reach, half: combine(&sums, reach, n as f64) })
}

/// Points taken together: each sum is loaded and stored once for all of them.
const BLOCK: usize = 8;

/// Adds the products cos cos, sin sin, sin cos and cos sin of u x and v y, for all u, v >= 0, over
/// the points of a block, in their order.
#[multiversion(targets("x86_64+avx512f+avx512bw+avx512dq+avx512vl", "x86_64+avx2+bmi1+bmi2"))]
fn accumulate(sums: &mut [Vec<f64>; 4], waves: &[[Waves; 2]], side: usize) {
    let [cc, ss, sc, cs] = sums;
    for v in 0..side {
        let row = v * side..(v + 1) * side;
        let (cc, ss, sc, cs) = (&mut cc[row.clone()], &mut ss[row.clone()], &mut sc[row.clone()], &mut cs[row]);
        for pair in waves.chunks_exact(2) {
            let ([a, p], [b, q]) = (&pair[0], &pair[1]);
            let (pc, ps, qc, qs) = (p.cos[v], p.sin[v], q.cos[v], q.sin[v]);
            let (ac, asin, bc, bsin) = (&a.cos[..side], &a.sin[..side], &b.cos[..side], &b.sin[..side]);
            for u in 0..side {
                cc[u] += ac[u] * pc + bc[u] * qc;
                ss[u] += asin[u] * ps + bsin[u] * qs;
                sc[u] += asin[u] * pc + bsin[u] * qc;
                cs[u] += ac[u] * ps + bc[u] * qs;
            }
        }
    }
}

/// The power in the upper half plane from the sums in the quarter: cos(a + b) = cos a cos b - sin a
/// sin b, and so on.
fn combine([cc, ss, sc, cs]: &[Vec<f64>; 4], reach: usize, n: f64) -> Vec<f64> {
    let side = reach + 1;
    let power = |v: usize, column: usize| {
        let (u, negative) = if column < reach { (reach - column, true) } else { (column - reach, false) };
        let at = v * side + u;
        let (re, im) = if negative { (cc[at] + ss[at], cs[at] - sc[at]) } else { (cc[at] - ss[at], sc[at] + cs[at]) };
        (re * re + im * im) / n
    };
    (0..side).flat_map(|v| (0..=2 * reach).map(move |column| (v, column))).map(|(v, column)| power(v, column)).collect()
}

/// cos and sin of 2 pi w x for consecutive w.
struct Waves {
    cos: Vec<f64>,
    sin: Vec<f64>,
}

/// Frequencies between two that are computed anew; rounding grows with the distance.
const STRIDE: usize = 16;

impl Waves {
    fn new(count: usize) -> Self {
        Self { cos: vec![0.0; count], sin: vec![0.0; count] }
    }

    /// Sets all waves to 0.
    fn clear(&mut self) {
        self.cos.fill(0.0);
        self.sin.fill(0.0);
    }

    /// Sets the waves of the coordinate `x` for the frequencies 0, 1, ...
    fn set(&mut self, x: f64) {
        let (cos, sin) = turn(x);
        for (block, (cosines, sines)) in self.cos.chunks_mut(STRIDE).zip(self.sin.chunks_mut(STRIDE)).enumerate() {
            let (mut c, mut s) = turn((block * STRIDE) as f64 * x);
            for (cosine, sine) in cosines.iter_mut().zip(sines) {
                (*cosine, *sine) = (c, s);
                (c, s) = (c * cos - s * sin, c * sin + s * cos);
            }
        }
    }
}

/// cos and sin of `turns` turns; whole turns are taken off first, which is exact.
fn turn(turns: f64) -> (f64, f64) {
    let angle = TAU * (turns - turns.round());
    (portable::cos(angle), portable::sin(angle))
}
