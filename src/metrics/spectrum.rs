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
use crate::vectors::vectorised;
use std::f64::consts::TAU;
use std::ops::Range;

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

    /// The spectrum of all its rows, as [`power_rows`] gives them, in their order; `None` where
    /// their length is not that of rows 0 ..= `reach`.
    pub fn from_rows(reach: usize, rows: Vec<f64>) -> Option<Self> {
        (rows.len() == (reach + 1) * (2 * reach + 1)).then_some(Self { reach, half: rows })
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
    Ok(Spectrum { reach, half: power_rows(points, reach, 0..reach + 1)? })
}

/// The rows v of the spectrum alone, those of `rows` up to the reach: P(u, v) for u = -reach ..=
/// reach of the first row, then of the next. The same bits as all at once, so that several can
/// share the work, and [`Spectrum::from_rows`] puts it together.
pub fn power_rows(points: &Points, reach: usize, rows: Range<usize>) -> Result<Vec<f64>, Unmeasured> {
    check(points)?;
    let n = points.len();
    if points.dimensions() != 2 {
        return Err(Unmeasured::Kind("the power spectrum is computed in two dimensions"));
    }
    if reach > HIGHEST {
        return Err(Unmeasured::Size { n, d: 2, limit: "frequencies go up to 4096" });
    }
    let rows = rows.start.min(reach + 1)..rows.end.min(reach + 1);
    let tiles = (reach + 1).div_ceil(LANES);
    let mut sums = vec![[[0.0; LANES]; 4]; rows.len() * tiles];
    let mut block = Block { columns: vec![Default::default(); tiles], rows: vec![Default::default(); rows.len()] };
    for points in points.coordinates().chunks(4 * PAIRS) {
        if points.len() < 4 * PAIRS {
            // Places without a point add nothing.
            block.columns.fill(Default::default());
        }
        for (place, point) in points.chunks_exact(2).enumerate() {
            block.set(place, point, rows.start);
        }
        accumulate(&mut sums, &block);
    }
    Ok(combine(&sums, reach, n as f64))
}

/// Frequencies u side by side.
const LANES: usize = 8;

/// Pairs of points taken together: each sum is loaded and stored once for all of them.
const PAIRS: usize = 4;

/// The waves of a few points, laid out as the sums go through them.
struct Block {
    /// For each tile of frequencies u and each pair of points: cos and sin of the first, cos and
    /// sin of the second.
    columns: Vec<[[[f64; LANES]; 4]; PAIRS]>,
    /// For each frequency v and each pair of points: the same.
    rows: Vec<[[f64; 4]; PAIRS]>,
}

impl Block {
    /// Sets the waves of the point in the place `place`, with the rows from `first` on.
    fn set(&mut self, place: usize, point: &[f64], first: usize) {
        let (pair, part) = (place / 2, place % 2 * 2);
        waves(point[0], 0..self.columns.len() * LANES, |u, (cos, sin)| {
            let tile = &mut self.columns[u / LANES][pair];
            (tile[part][u % LANES], tile[part + 1][u % LANES]) = (cos, sin);
        });
        waves(point[1], first..first + self.rows.len(), |v, (cos, sin)| {
            let row = &mut self.rows[v - first][pair];
            (row[part], row[part + 1]) = (cos, sin);
        });
    }
}

vectorised! {
    /// Adds the products cos cos, sin sin, sin cos and cos sin of u x and v y, for all u >= 0 and
    /// the rows v, over the points of a block, in their order.
    fn accumulate(sums: &mut [[[f64; LANES]; 4]], block: &Block) {
        for (sums, row) in sums.chunks_exact_mut(block.columns.len()).zip(&block.rows) {
            for (sums, columns) in sums.iter_mut().zip(&block.columns) {
                let [mut cc, mut ss, mut sc, mut cs] = *sums;
                for ([ac, asin, bc, bsin], [pc, ps, qc, qs]) in columns.iter().zip(row) {
                    for u in 0..LANES {
                        cc[u] += ac[u] * pc + bc[u] * qc;
                        ss[u] += asin[u] * ps + bsin[u] * qs;
                        sc[u] += asin[u] * pc + bsin[u] * qc;
                        cs[u] += ac[u] * ps + bc[u] * qs;
                    }
                }
                *sums = [cc, ss, sc, cs];
            }
        }
    }
}

/// The power in rows of the upper half plane from the sums in the quarter: cos(a + b) = cos a cos b
/// - sin a sin b, and so on.
fn combine(sums: &[[[f64; LANES]; 4]], reach: usize, n: f64) -> Vec<f64> {
    let power = |row: &[[[f64; LANES]; 4]], column: usize| {
        let u = column.abs_diff(reach);
        let [cc, ss, sc, cs] = row[u / LANES].map(|sums| sums[u % LANES]);
        let (re, im) = if column < reach { (cc + ss, cs - sc) } else { (cc - ss, sc + cs) };
        (re * re + im * im) / n
    };
    let rows = sums.chunks_exact((reach + 1).div_ceil(LANES));
    rows.flat_map(|row| (0..=2 * reach).map(move |column| power(row, column))).collect()
}

/// Frequencies between two that are computed anew; rounding grows with the distance.
const STRIDE: usize = 16;

/// Gives the frequencies `range` with cos and sin of 2 pi w `x` to `take`.
fn waves(x: f64, range: Range<usize>, mut take: impl FnMut(usize, (f64, f64))) {
    let (cos, sin) = turn(x);
    let mut from = range.start / STRIDE * STRIDE;
    while from < range.end {
        let (mut c, mut s) = turn(from as f64 * x);
        for w in from..(from + STRIDE).min(range.end) {
            if w >= range.start {
                take(w, (c, s));
            }
            (c, s) = (c * cos - s * sin, c * sin + s * cos);
        }
        from += STRIDE;
    }
}

/// cos and sin of `turns` turns; whole turns are taken off first, which is exact.
fn turn(turns: f64) -> (f64, f64) {
    let angle = TAU * (turns - turns.round());
    (portable::cos(angle), portable::sin(angle))
}
