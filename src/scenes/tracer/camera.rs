//! The camera: a thin lens that focuses on a plane, and a shutter.
//!
//! All rays through one point of the image that pass the lens meet in one point of the plane in focus; the lens is a disk, sampled by an
//! area-preserving map (R. L. Cook, T. Porter and L. Carpenter, Distributed Ray Tracing, SIGGRAPH 1984, doi 10.1145/800031.808590; M.
//! Potmesil and I. Chakravarty, SIGGRAPH 1981, doi 10.1145/800224.806818).

use super::{Ray, Vector, maps};

/// A camera as it is placed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The middle of the lens.
    pub eye: Vector,
    /// The point in the middle of the image.
    pub target: Vector,
    /// Half the height of what is seen, over its distance.
    pub spread: f64,
    /// The radius of the lens; 0 is a pinhole.
    pub lens: f64,
    /// The distance of the plane in focus along the axis; any for a pinhole.
    pub focus: f64,
}

/// A camera with its directions worked out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    eye: Vector,
    /// From the eye to the middle of the plane in focus.
    forward: Vector,
    /// From there to the right edge of a square image, and to its lower edge.
    right: Vector,
    down: Vector,
    /// The lens's radius along the image's two axes.
    across: Vector,
    along: Vector,
    pinhole: bool,
}

impl Camera {
    /// The camera of `view`, held upright: the third axis of space is up.
    pub fn new(view: &View) -> Self {
        let forward = (view.target - view.eye).unit();
        let right = forward.cross(Vector::new(0.0, 0.0, 1.0)).unit();
        let down = forward.cross(right);
        let half = view.spread * view.focus;
        Self {
            eye: view.eye,
            forward: forward * view.focus,
            right: right * half,
            down: down * half,
            across: right * view.lens,
            along: down * view.lens,
            pinhole: view.lens == 0.0,
        }
    }

    /// All rays for the part of the image around `image` of this `size`, with the image's sides as units.
    pub fn beam(&self, image: [f64; 2], size: [f64; 2], aspect: f64) -> Beam {
        let middle = self.ray(image, aspect, [0.5, 0.5]);
        let focus = self.forward.length();
        let half = self.right * (size[0] * aspect) + self.down * size[1];
        Beam { middle, axis: self.forward * (1.0 / focus), focus, lens: self.across.length(), part: half.length() }
    }

    /// The ray for the point (x, y) of the image, 0 to 1 from the left and from the top, through the point (u, v) of the lens, both in
    /// the unit square. `aspect` is the width over the height.
    #[inline]
    pub fn ray(&self, [x, y]: [f64; 2], aspect: f64, [u, v]: [f64; 2]) -> Ray {
        let sharp = self.forward + self.right * ((2.0 * x - 1.0) * aspect) + self.down * (2.0 * y - 1.0);
        if self.pinhole {
            return Ray { origin: self.eye, direction: sharp.unit() };
        }
        let (a, b) = maps::disk(u, v);
        let offset = self.across * a + self.along * b;
        Ray { origin: self.eye + offset, direction: (sharp - offset).unit() }
    }
}

/// The rays through the lens and through a part of the image: see [`Camera::beam`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// The ray in the middle.
    middle: Ray,
    /// The direction in which depth is measured.
    axis: Vector,
    /// The depth of the plane in focus.
    focus: f64,
    /// The radius of the lens.
    lens: f64,
    /// How far from the middle the part of the image reaches, in the plane in focus.
    part: f64,
}

impl Beam {
    /// Whether a ray of the beam may meet the ball: never false where one does.
    #[inline]
    pub fn may_meet(&self, centre: Vector, radius: f64) -> bool {
        let gap = centre - self.middle.origin;
        let along = gap.dot(self.middle.direction);
        let off = gap - self.middle.direction * along;
        let depth = gap.dot(self.axis);
        // At a depth z, no ray is farther from the middle than lens |1 - z/focus| + part z/focus, which is convex in z.
        let wide = |z: f64| (self.lens * (1.0 - z / self.focus).abs()) + self.part * (z / self.focus).abs();
        let reach = radius + wide(depth - radius).max(wide(depth + radius));
        depth + radius >= 0.0 && off.dot(off) <= reach * reach * (1.0 + 1e-9)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VIEW: View = View {
        eye: Vector::new(0.0, -4.0, 1.0),
        target: Vector::new(0.0, 0.0, 1.0),
        spread: 0.5,
        lens: 0.2,
        focus: 4.0,
    };

    #[test]
    fn the_plane_in_focus_is_sharp() {
        let camera = Camera::new(&VIEW);
        let seen = |lens: [f64; 2], y: f64| {
            let ray = camera.ray([0.3, 0.8], 1.5, lens);
            ray.at((y - ray.origin.y) / ray.direction.y)
        };
        let lenses = [[0.5, 0.5], [0.0, 0.0], [0.9, 0.1], [0.2, 0.7]];
        let sharp = seen(lenses[0], 0.0);
        // 0.3 and 0.8 of an image of 6 x 4: -1.2 to the right, 1.2 below the height 1.
        assert!((sharp - Vector::new(-1.2, 0.0, -0.2)).length() < 1e-14, "{sharp:?}");
        for lens in lenses {
            assert!((seen(lens, 0.0) - sharp).length() < 1e-14);
        }
        // Twice as far, the circle of confusion is as large as the lens.
        let edge = seen([0.0, 0.5], 4.0) - seen([0.5, 0.5], 4.0);
        assert!((edge.length() - 0.2).abs() < 1e-13, "{}", edge.length());
    }

    /// Rays of a beam are drawn at random: every ball that one of them meets may be met.
    #[test]
    fn a_beam_holds_its_rays() {
        use crate::scenes::tracer::Shape;
        let camera = Camera::new(&VIEW);
        let mut random = crate::seed::Seed::new(11).named("beam").generator();
        let mut number = |low: f64, high: f64| low + (high - low) * random.uniform();
        let (mut met, mut missed) = (0, 0);
        for _ in 0..3000 {
            let (x, y, side) = (number(0.0, 1.0), number(0.0, 1.0), number(0.0, 0.1));
            let centre = Vector::new(number(-3.0, 3.0), number(-5.0, 6.0), number(-2.0, 4.0));
            let radius = number(0.0, 0.6);
            let beam = camera.beam([x, y], [side, side], 1.5);
            let may = beam.may_meet(centre, radius);
            missed += usize::from(!may);
            for _ in 0..20 {
                let image = [x + side * number(-0.5, 0.5), y + side * number(-0.5, 0.5)];
                let ray = camera.ray(image, 1.5, [number(0.0, 1.0), number(0.0, 1.0)]);
                let meets = Shape::Sphere { centre, radius }.meet(&ray, 1e9).is_some();
                met += usize::from(meets);
                assert!(may || !meets, "{centre:?} {radius}");
            }
        }
        assert!(met > 300 && missed > 1000, "{met} {missed}");
    }

    #[test]
    fn the_image_is_upright_and_not_mirrored() {
        let camera = Camera::new(&View { lens: 0.0, ..VIEW });
        let left_top = camera.ray([0.0, 0.0], 1.0, [0.5, 0.5]).direction;
        let right_bottom = camera.ray([1.0, 1.0], 1.0, [0.5, 0.5]).direction;
        assert!(left_top.x < 0.0 && left_top.z > 0.0);
        assert!(right_bottom.x > 0.0 && right_bottom.z < 0.0);
        assert!((left_top.length() - 1.0).abs() < 1e-15);
    }
}
