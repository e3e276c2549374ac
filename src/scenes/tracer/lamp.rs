//! Lamps: flat lights that send light to one side, and a far one whose rays are parallel.

use super::{Colour, Vector, maps};

/// A source of light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lamp {
    /// A parallelogram, shining towards `right` x `down`.
    Rectangle {
        /// The corner for (u, v) = (0, 0).
        corner: Vector,
        /// The edge along u.
        right: Vector,
        /// The edge along v.
        down: Vector,
        /// The radiance that it sends out.
        radiance: Colour,
    },
    /// A disk, shining towards `right` x `down`.
    Disk {
        /// The centre.
        centre: Vector,
        /// A radius.
        right: Vector,
        /// The radius at a right angle to it, as long.
        down: Vector,
        /// The radiance that it sends out.
        radiance: Colour,
    },
    /// So far away that all its rays are parallel: its shadows are hard and need no sample.
    Sun {
        /// The direction towards it, of length 1.
        towards: Vector,
        /// The irradiance on a surface that faces it, over pi.
        colour: Colour,
    },
}

/// Light that arrives at a point if nothing is in the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// The direction towards the light, of length 1.
    pub towards: Vector,
    /// How far away it is.
    pub distance: f64,
    /// What a white matte surface that faces the light would show: an estimate of the irradiance over pi.
    pub colour: Colour,
}

impl Lamp {
    /// Whether samples (u, v) choose a point of it.
    pub fn is_sampled(&self) -> bool {
        !matches!(self, Self::Sun { .. })
    }

    /// The light at the point `at` from the point (u, v) of the lamp: for uniform (u, v), the mean is the irradiance over pi
    /// when weighed with the cosine at the surface.
    #[inline]
    pub fn arrival(&self, at: Vector, u: f64, v: f64) -> Arrival {
        match *self {
            Self::Rectangle { corner, right, down, radiance } => {
                from(at, corner + right * u + down * v, right.cross(down), radiance)
            }
            Self::Disk { centre, right, down, radiance } => {
                let (x, y) = maps::disk(u, v);
                let facing = right.cross(down) * std::f64::consts::PI;
                from(at, centre + right * x + down * y, facing, radiance)
            }
            Self::Sun { towards, colour } => Arrival { towards, distance: f64::INFINITY, colour },
        }
    }
}

/// The light from one point of a flat lamp, whose `facing` is its direction times its area.
#[inline]
fn from(at: Vector, source: Vector, facing: Vector, radiance: Colour) -> Arrival {
    let gap = source - at;
    let square = gap.dot(gap);
    let distance = square.sqrt();
    let towards = gap * (1.0 / distance);
    // The cosine at the lamp; its back is dark.
    let weight = (-towards.dot(facing)).max(0.0) / (std::f64::consts::PI * square);
    Arrival { towards, distance, colour: radiance * weight }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::seed::Seed;
    use crate::stats::moments::Moments;

    /// The mean of the estimate at a point that faces up, with its standard error.
    fn lit(lamp: &Lamp, at: Vector) -> Moments {
        let mut random = Seed::new(5).named("lamp").generator();
        let estimate = |_| {
            let arrival = lamp.arrival(at, random.uniform(), random.uniform());
            arrival.colour.x * arrival.towards.z.max(0.0)
        };
        (0..40_000).map(estimate).collect()
    }

    /// The form factor of a rectangle a x b at the height c over its corner, seen from a parallel small patch
    /// (J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3).
    fn corner_factor(a: f64, b: f64, c: f64) -> f64 {
        use crate::stats::portable::atan;
        let (x, y) = (a / c, b / c);
        let (p, q) = ((1.0 + x * x).sqrt(), (1.0 + y * y).sqrt());
        (x / p * atan(y / p) + y / q * atan(x / q)) / std::f64::consts::TAU
    }

    #[test]
    fn a_rectangle_lights_as_its_form_factor_says() {
        let (a, b, c) = (2.0, 3.0, 1.5);
        let lamp = Lamp::Rectangle {
            corner: Vector::new(0.0, 0.0, c),
            right: Vector::new(0.0, b, 0.0),
            down: Vector::new(a, 0.0, 0.0),
            radiance: Vector::grey(1.0),
        };
        let at_corner = lit(&lamp, Vector::default());
        let expected = corner_factor(a, b, c);
        assert!((at_corner.mean() - expected).abs() < 4.0 * at_corner.standard_error(), "{at_corner:?} {expected}");
        // Under the middle it is four rectangles of a quarter each.
        let at_middle = lit(&lamp, Vector::new(a / 2.0, b / 2.0, 0.0));
        let expected = 4.0 * corner_factor(a / 2.0, b / 2.0, c);
        assert!((at_middle.mean() - expected).abs() < 4.0 * at_middle.standard_error(), "{at_middle:?} {expected}");
        // From above its back is dark.
        assert_eq!(lit(&lamp, Vector::new(0.0, 0.0, 4.0)).mean(), 0.0);
    }

    #[test]
    fn a_disk_lights_as_its_form_factor_says() {
        // Over the centre: r^2 / (r^2 + h^2) (Howell, B-12).
        let (r, h) = (1.2, 2.0);
        let lamp = Lamp::Disk {
            centre: Vector::new(0.0, 0.0, h),
            right: Vector::new(0.0, r, 0.0),
            down: Vector::new(r, 0.0, 0.0),
            radiance: Vector::grey(1.0),
        };
        let below = lit(&lamp, Vector::default());
        let expected = r * r / (r * r + h * h);
        assert!((below.mean() - expected).abs() < 4.0 * below.standard_error(), "{below:?} {expected}");
    }
}
