//! Shapes and where rays meet them: spheres, planes and boxes.

use super::Vector;

/// A half line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vector,
    /// Where it goes, of length 1, so that parameters along it are distances.
    pub direction: Vector,
}

impl Ray {
    /// The point at `distance`.
    #[inline]
    pub fn at(&self, distance: f64) -> Vector {
        self.origin + self.direction * distance
    }
}

/// A ray that leaves a surface does not meet that surface again before this distance.
pub const NEAR: f64 = 1e-7;

/// A surface in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// All points at one distance from a centre.
    Sphere {
        /// The centre.
        centre: Vector,
        /// The radius, above 0.
        radius: f64,
    },
    /// A plane.
    Plane {
        /// One of its points.
        point: Vector,
        /// The direction that it faces, of length 1.
        normal: Vector,
    },
    /// A box with faces across the axes.
    Box {
        /// The corner of smallest coordinates.
        low: Vector,
        /// The corner of largest coordinates.
        high: Vector,
    },
}

impl Shape {
    /// The smallest distance between [`NEAR`] and `far`, both excluded, at which `ray` meets the surface.
    #[inline]
    pub fn meet(&self, ray: &Ray, far: f64) -> Option<f64> {
        let within = |distance: f64| (distance > NEAR && distance < far).then_some(distance);
        match *self {
            Self::Sphere { centre, radius } => {
                let start = ray.origin - centre;
                let along = start.dot(ray.direction);
                // The nearest point of the line to the centre, taken first, keeps small spheres far away accurate.
                let nearest = start - ray.direction * along;
                let half = radius * radius - nearest.dot(nearest);
                if half < 0.0 {
                    return None;
                }
                let half = half.sqrt();
                within(-along - half).or_else(|| within(-along + half))
            }
            Self::Plane { point, normal } => within((point - ray.origin).dot(normal) / ray.direction.dot(normal)),
            Self::Box { low, high } => {
                let slabs = [
                    slab(ray.origin.x, ray.direction.x, low.x, high.x),
                    slab(ray.origin.y, ray.direction.y, low.y, high.y),
                    slab(ray.origin.z, ray.direction.z, low.z, high.z),
                ];
                let enter = slabs[0].0.max(slabs[1].0).max(slabs[2].0);
                let leave = slabs[0].1.min(slabs[1].1).min(slabs[2].1);
                if enter > leave { None } else { within(enter).or_else(|| within(leave)) }
            }
        }
    }

    /// The centre and the radius of a ball around it, if there is one.
    pub fn ball(&self) -> Option<(Vector, f64)> {
        match *self {
            Self::Sphere { centre, radius } => Some((centre, radius)),
            Self::Plane { .. } => None,
            Self::Box { low, high } => Some(((low + high) * 0.5, 0.5 * (high - low).length())),
        }
    }

    /// The outward direction, of length 1, at the point `at` of the surface.
    #[inline]
    pub fn normal(&self, at: Vector) -> Vector {
        match *self {
            Self::Sphere { centre, radius } => (at - centre) * (1.0 / radius),
            Self::Plane { normal, .. } => normal,
            Self::Box { low, high } => {
                let sides = [
                    (low.x - at.x, Vector::new(-1.0, 0.0, 0.0)),
                    (at.x - high.x, Vector::new(1.0, 0.0, 0.0)),
                    (low.y - at.y, Vector::new(0.0, -1.0, 0.0)),
                    (at.y - high.y, Vector::new(0.0, 1.0, 0.0)),
                    (low.z - at.z, Vector::new(0.0, 0.0, -1.0)),
                    (at.z - high.z, Vector::new(0.0, 0.0, 1.0)),
                ];
                // The point lies on the face that it is least below.
                sides.iter().fold(sides[0], |best, side| if side.0 > best.0 { *side } else { best }).1
            }
        }
    }
}

/// The distances at which a ray enters and leaves the slab `low ..= high` of one axis.
#[inline]
fn slab(origin: f64, direction: f64, low: f64, high: f64) -> (f64, f64) {
    if direction == 0.0 {
        let inside = low <= origin && origin <= high;
        return if inside { (f64::NEG_INFINITY, f64::INFINITY) } else { (f64::INFINITY, f64::NEG_INFINITY) };
    }
    let (a, b) = ((low - origin) / direction, (high - origin) / direction);
    if a < b { (a, b) } else { (b, a) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
        let vector = |[x, y, z]: [f64; 3]| Vector::new(x, y, z);
        Ray { origin: vector(origin), direction: vector(direction).unit() }
    }

    #[test]
    fn spheres_are_met_from_outside_and_inside() {
        let sphere = Shape::Sphere { centre: Vector::new(0.0, 5.0, 0.0), radius: 2.0 };
        assert_eq!(sphere.meet(&ray([0.0; 3], [0.0, 1.0, 0.0]), 1e9), Some(3.0));
        assert_eq!(sphere.meet(&ray([0.0, 5.0, 0.0], [0.0, 1.0, 0.0]), 1e9), Some(2.0));
        assert_eq!(sphere.meet(&ray([0.0, 8.0, 0.0], [0.0, 1.0, 0.0]), 1e9), None);
        assert_eq!(sphere.meet(&ray([2.1, 0.0, 0.0], [0.0, 1.0, 0.0]), 1e9), None);
        assert_eq!(sphere.meet(&ray([0.0; 3], [0.0, 1.0, 0.0]), 2.9), None, "beyond the far end");
        // At height 1 the chord begins sqrt(3) before the centre.
        let height = sphere.meet(&ray([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]), 1e9).expect("a hit");
        assert!((height - (5.0 - 3.0_f64.sqrt())).abs() < 1e-14);
        // The tangent from the origin touches at the distance sqrt(21).
        let slope = 2.0 / 21.0_f64.sqrt();
        let tangent = sphere.meet(&ray([0.0; 3], [slope - 1e-9, 1.0, 0.0]), 1e9).expect("a hit");
        assert!((tangent - 21.0_f64.sqrt()).abs() < 1e-3, "{tangent}");
    }

    #[test]
    fn points_where_rays_meet_lie_on_the_surface() {
        let mut random = crate::seed::Seed::new(7).named("shapes").generator();
        let mut number = || 4.0 * random.uniform() - 2.0;
        let (centre, radius) = (Vector::new(0.2, 0.3, -0.1), 0.8);
        let (low, high) = (Vector::new(-0.5, -0.7, -0.9), Vector::new(0.4, 0.6, 0.8));
        let (mut spheres, mut boxes) = (0, 0);
        for _ in 0..2000 {
            let towards = ray([number(), number(), number()], [number(), number(), number()]);
            let sphere = Shape::Sphere { centre, radius };
            if let Some(distance) = sphere.meet(&towards, 1e9) {
                spheres += 1;
                let at = towards.at(distance);
                assert!(((at - centre).length() - radius).abs() < 1e-12);
                assert!(((at - centre).unit() - sphere.normal(at)).length() < 1e-12);
            }
            let cuboid = Shape::Box { low, high };
            if let Some(distance) = cuboid.meet(&towards, 1e9) {
                boxes += 1;
                let at = towards.at(distance);
                let over = (low.x - at.x).max(at.x - high.x).max(low.y - at.y).max(at.y - high.y);
                let over = over.max(low.z - at.z).max(at.z - high.z);
                assert!(over.abs() < 1e-12, "on the surface: {over}");
                // A step along the normal leaves the box, a step against it enters.
                let inside = |p: Vector| {
                    p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y && p.z > low.z && p.z < high.z
                };
                let step = cuboid.normal(at) * 1e-6;
                assert!(!inside(at + step) && inside(at - step));
            }
        }
        assert!(spheres > 100 && boxes > 100, "{spheres} {boxes}");
    }

    #[test]
    fn planes_and_flat_rays() {
        let floor = Shape::Plane { point: Vector::default(), normal: Vector::new(0.0, 0.0, 1.0) };
        let distance = floor.meet(&ray([0.0, 0.0, 3.0], [0.0, 4.0, -3.0]), 1e9).expect("a hit");
        assert!((distance - 5.0).abs() < 1e-14);
        assert_eq!(floor.meet(&ray([0.0, 0.0, 3.0], [0.0, 1.0, 0.0]), 1e9), None);
        assert_eq!(floor.meet(&ray([0.0, 0.0, 3.0], [0.0, 1.0, 1.0]), 1e9), None);
        let cuboid = Shape::Box { low: Vector::grey(-1.0), high: Vector::grey(1.0) };
        assert_eq!(cuboid.meet(&ray([0.0, -3.0, 0.0], [0.0, 1.0, 0.0]), 1e9), Some(2.0));
        assert_eq!(cuboid.meet(&ray([0.0; 3], [0.0, 1.0, 0.0]), 1e9), Some(1.0));
        assert_eq!(cuboid.meet(&ray([0.0, -3.0, 1.5], [0.0, 1.0, 0.0]), 1e9), None);
    }
}
