//! Maps from the unit square to lenses and lights that keep areas: uniform samples stay uniform, and strata stay strata.
//!
//! The disk is P. Shirley and K. Chiu's concentric map, A Low Distortion Map Between Disk and Square, Journal of Graphics Tools
//! 2(3) (1997), doi 10.1080/10867651.1997.10487479. It takes squares around the centre to circles, so that the cells of a grid keep their
//! neighbours and nearly their shape; polar coordinates (sqrt(u), 2 pi v) keep areas too, but tear the square open.

use crate::stats::portable;
use std::f64::consts::FRAC_PI_4;

/// The point of the disk of radius 1 around 0 for the point (u, v) of the unit square. The density of the image of uniform points is 1/pi.
#[inline]
pub fn disk(u: f64, v: f64) -> (f64, f64) {
    let (a, b) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    // The larger of the two is the radius; their quotient, in [-1, 1], is the angle in its quarter.
    if a.abs() > b.abs() {
        let angle = FRAC_PI_4 * (b / a);
        (a * portable::cos(angle), a * portable::sin(angle))
    } else if b == 0.0 {
        (0.0, 0.0)
    } else {
        let angle = FRAC_PI_4 * (a / b);
        (b * portable::sin(angle), b * portable::cos(angle))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::seed::Seed;
    use crate::stats::inference::chi_square;

    /// The area of the image of a small square, by the cross product of its diagonals.
    fn stretch(u: f64, v: f64, h: f64) -> f64 {
        let corner = |i: f64, j: f64| disk(u + i * h, v + j * h);
        let (p, q) = (corner(0.0, 0.0), corner(1.0, 1.0));
        let (r, s) = (corner(1.0, 0.0), corner(0.0, 1.0));
        0.5 * ((q.0 - p.0) * (s.1 - r.1) - (q.1 - p.1) * (s.0 - r.0)) / (h * h)
    }

    #[test]
    fn the_disk_keeps_areas_everywhere() {
        let mut random = Seed::new(3).named("disk").generator();
        for _ in 0..1000 {
            let (u, v) = (0.999 * random.uniform(), 0.999 * random.uniform());
            let stretch = stretch(u, v, 1e-5);
            // Squares across a diagonal of the square are bent there.
            let bent = ((2.0 * u - 1.0).abs() - (2.0 * v - 1.0).abs()).abs() < 1e-4;
            assert!(bent || (stretch - std::f64::consts::PI).abs() < 1e-3, "{u} {v}: {stretch}");
        }
    }

    #[test]
    fn the_edge_goes_to_the_edge_and_the_centre_to_the_centre() {
        for t in [0.0, 0.1, 0.25, 0.5, 0.8, 1.0] {
            for (u, v) in [(t, 0.0), (t, 1.0), (0.0, t), (1.0, t)] {
                let (x, y) = disk(u, v);
                assert!((x * x + y * y - 1.0).abs() < 1e-15, "{u} {v}");
            }
        }
        assert_eq!(disk(0.5, 0.5), (0.0, 0.0));
        let (x, y) = disk(0.25, 0.5);
        assert_eq!((x, y), (-0.5, 0.0));
    }

    #[test]
    fn uniform_points_are_uniform_on_the_disk() {
        // Eight rings of equal area times eight sectors.
        let mut random = Seed::new(4).named("disk").generator();
        let mut counts = vec![0; 64];
        for _ in 0..64_000 {
            let (x, y) = disk(random.uniform(), random.uniform());
            let ring = ((x * x + y * y) * 8.0).min(7.0) as usize;
            let sector = usize::from(x > 0.0) + 2 * usize::from(y > 0.0) + 4 * usize::from(x.abs() > y.abs());
            counts[ring * 8 + sector] += 1;
        }
        let verdict = chi_square(&counts).expect("counts");
        assert!(verdict.probability > 1e-3, "{verdict:?}");
    }
}
