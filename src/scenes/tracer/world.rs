//! Worlds: things, lamps and a camera, and the light that reaches one point of the image.
//!
//! Surfaces are matte (Lambert) or glow; light goes from a lamp to a surface to the eye. What comes from elsewhere is a constant, so that no
//! shadow is black. Nothing here is random: a sample is a point of the unit cube, and the radiance is a function of it.

use super::{Camera, Colour, Lamp, Ray, Shape, Vector};

/// What a surface does with light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// It reflects this part of the light, equally in all directions.
    Matte(Colour),
    /// Matte, in squares of two colours over the first two axes.
    Checker {
        /// The colour of the square from (0, 0) to (side, side).
        even: Colour,
        /// The colour of its neighbours.
        odd: Colour,
        /// The side of a square.
        side: f64,
    },
    /// It shines with this radiance, onto the film but on no other surface, and casts no shadow.
    Glow(Colour),
}

/// A shape with a surface, perhaps on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thing {
    /// Where it is at time 0.
    pub shape: Shape,
    /// What it does with light.
    pub surface: Surface,
    /// How far it goes from time 0 to time 1.
    pub velocity: Vector,
}

impl Thing {
    /// A thing at rest.
    pub const fn new(shape: Shape, surface: Surface) -> Self {
        Self { shape, surface, velocity: Vector::new(0.0, 0.0, 0.0) }
    }

    /// A sphere at rest.
    pub const fn sphere(centre: Vector, radius: f64, surface: Surface) -> Self {
        Self::new(Shape::Sphere { centre, radius }, surface)
    }

    /// A box at rest between two corners.
    pub const fn cuboid(low: Vector, high: Vector, surface: Surface) -> Self {
        Self::new(Shape::Box { low, high }, surface)
    }

    /// The floor at height 0.
    pub const fn floor(surface: Surface) -> Self {
        let normal = Vector::new(0.0, 0.0, 1.0);
        Self::new(Shape::Plane { point: Vector::new(0.0, 0.0, 0.0), normal }, surface)
    }

    /// It, going so far from time 0 to time 1.
    #[must_use]
    pub const fn moving(self, velocity: Vector) -> Self {
        Self { velocity, ..self }
    }

    /// The ray as this thing meets it at `time`.
    #[inline]
    fn follow(&self, ray: &Ray, time: f64) -> Ray {
        Ray { origin: ray.origin - self.velocity * time, ..*ray }
    }
}

/// What is looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    /// The things.
    pub things: Vec<Thing>,
    /// The lamps; each sampled one is sampled by the same (u, v).
    pub lamps: Vec<Lamp>,
    /// The light that comes from everywhere above; half of it reaches a wall.
    pub ambient: Colour,
    /// What a ray that meets nothing sees level with the eye, and overhead.
    pub sky: [Colour; 2],
    /// The camera.
    pub camera: Camera,
}

/// Where and when to look: one sample of the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// The point of the image, from the left and from the top, in the unit square.
    pub image: [f64; 2],
    /// The point of the lens, in the unit square.
    pub lens: [f64; 2],
    /// When, in [0, 1).
    pub time: f64,
}

impl World {
    /// Writes the indices of the things that can be seen in the part of the image around `image` into `seen`: those that no ray can meet
    /// are left out. `size` is the part's width and height, with the image's side as unit.
    pub fn see(&self, image: [f64; 2], size: [f64; 2], aspect: f64, seen: &mut Vec<usize>) {
        let beam = self.camera.beam(image, size, aspect);
        seen.clear();
        seen.extend((0..self.things.len()).filter(|&k| {
            let thing = &self.things[k];
            thing.shape.ball().is_none_or(|(centre, radius)| {
                // The ball around all places from time 0 to time 1.
                let (half, way) = (thing.velocity * 0.5, 0.5 * thing.velocity.length());
                beam.may_meet(centre + half, radius + way)
            })
        }));
    }

    /// The radiance that arrives from where `look` looks, of the things `seen` (see [`see`](Self::see)). The lamps are sampled at each
    /// pair of `lights`, all points of the unit square, and the mean is taken. `aspect` is the image's width over its height.
    pub fn radiance(&self, look: &Look, aspect: f64, lights: &[f64], seen: &[usize]) -> Colour {
        let ray = self.camera.ray(look.image, aspect, look.lens);
        let Some((thing, distance)) = self.nearest(&ray, look.time, seen) else { return self.missed(&ray) };
        let at = ray.at(distance);
        let own = at - thing.velocity * look.time;
        let reflected = match thing.surface {
            Surface::Glow(colour) => return colour,
            Surface::Matte(colour) => colour,
            Surface::Checker { even, odd, side } => {
                let squares = (own.x / side).floor() + (own.y / side).floor();
                if (squares * 0.5).floor() * 2.0 == squares { even } else { odd }
            }
        };
        let normal = thing.shape.normal(own);
        let normal = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };
        reflected.times(self.arriving(at, normal, look.time, lights) + self.ambient * (0.5 + 0.5 * normal.z))
    }

    /// The irradiance over pi, from the lamps.
    fn arriving(&self, at: Vector, normal: Vector, time: f64, lights: &[f64]) -> Colour {
        let mut total = Colour::default();
        for lamp in &self.lamps {
            if lamp.is_sampled() {
                let pairs = lights.chunks_exact(2);
                let part = 1.0 / pairs.len().max(1) as f64;
                for pair in pairs {
                    total = total + self.lit(lamp, at, normal, time, (pair[0], pair[1])) * part;
                }
            } else {
                total = total + self.lit(lamp, at, normal, time, (0.0, 0.0));
            }
        }
        total
    }

    /// The light from one point of a lamp, if nothing is in the way.
    #[inline]
    fn lit(&self, lamp: &Lamp, at: Vector, normal: Vector, time: f64, (u, v): (f64, f64)) -> Colour {
        let arrival = lamp.arrival(at, u, v);
        let cosine = arrival.towards.dot(normal);
        if cosine <= 0.0 || arrival.colour == Colour::default() {
            return Colour::default();
        }
        let ray = Ray { origin: at, direction: arrival.towards };
        let blocks = |thing: &Thing| {
            let opaque = !matches!(thing.surface, Surface::Glow(_));
            opaque && thing.shape.meet(&thing.follow(&ray, time), arrival.distance).is_some()
        };
        let blocked = self.things.iter().any(blocks);
        if blocked { Colour::default() } else { arrival.colour * cosine }
    }

    /// The nearest thing of `seen` that the ray meets at `time`, and how far away that is.
    #[inline]
    fn nearest(&self, ray: &Ray, time: f64, seen: &[usize]) -> Option<(&Thing, f64)> {
        let mut nearest = None;
        let mut far = f64::INFINITY;
        for thing in seen.iter().filter_map(|&k| self.things.get(k)) {
            if let Some(distance) = thing.shape.meet(&thing.follow(ray, time), far) {
                far = distance;
                nearest = Some((thing, distance));
            }
        }
        nearest
    }

    /// What a ray that meets nothing sees.
    fn missed(&self, ray: &Ray) -> Colour {
        let height = ray.direction.z.clamp(0.0, 1.0);
        self.sky[0] * (1.0 - height) + self.sky[1] * height
    }
}

#[cfg(test)]
mod tests {
    use super::super::View;
    use super::*;
    use crate::seed::Seed;
    use crate::stats::moments::Moments;

    const WHITE: Surface = Surface::Matte(Vector::new(1.0, 1.0, 1.0));

    /// A camera that looks straight at the floor's point (x, 0) from the side, without any other light.
    fn world(things: Vec<Thing>, lamp: Lamp, x: f64) -> World {
        let view = View {
            eye: Vector::new(x, -5.0, 1.0),
            target: Vector::new(x, 0.0, 0.0),
            spread: 0.1,
            lens: 0.0,
            focus: 1.0,
        };
        let camera = Camera::new(&view);
        World { things, lamps: vec![lamp], ambient: Colour::default(), sky: [Colour::default(); 2], camera }
    }

    /// More than there are things in any world of these tests.
    const ALL: [usize; 4] = [0, 1, 2, 3];

    const CENTRE: Look = Look { image: [0.5, 0.5], lens: [0.5, 0.5], time: 0.0 };

    /// The mean over uniform light samples.
    fn mean(world: &World, look: &Look) -> Moments {
        let mut random = Seed::new(9).named("world").generator();
        (0..20_000).map(|_| world.radiance(look, 1.0, &[random.uniform(), random.uniform()], &ALL).x).collect()
    }

    /// A strip of light over a half plane that hides the part of it beyond a known line: the visible part is a
    /// smaller rectangle, whose form factor is known.
    #[test]
    fn a_penumbra_is_as_deep_as_the_part_of_the_lamp_that_is_seen() {
        let factor = |a: f64, b: f64, c: f64| {
            use crate::stats::portable::atan;
            let (x, y) = (a / c, b / c);
            let (p, q) = ((1.0 + x * x).sqrt(), (1.0 + y * y).sqrt());
            (x / p * atan(y / p) + y / q * atan(x / q)) / std::f64::consts::TAU
        };
        // The lamp: 2 x 2 at height 2, over the origin. The wall: at height 1, everything with x > 0.25.
        let lamp = Lamp::Rectangle {
            corner: Vector::new(-1.0, -1.0, 2.0),
            right: Vector::new(0.0, 2.0, 0.0),
            down: Vector::new(2.0, 0.0, 0.0),
            radiance: Vector::grey(1.0),
        };
        let wall = Thing::cuboid(Vector::new(0.25, -9.0, 1.0), Vector::new(9.0, 9.0, 1.0 + 1e-9), WHITE);
        let world = world(vec![Thing::floor(WHITE), wall], lamp, 0.0);
        // Seen from the origin, the wall's edge stands before x = 0.5 of the lamp: seen are -1 .. 0.5.
        let expected = 2.0 * (factor(1.0, 1.0, 2.0) + factor(0.5, 1.0, 2.0));
        let found = mean(&world, &CENTRE);
        assert!((found.mean() - expected).abs() < 4.0 * found.standard_error(), "{found:?} {expected}");
        assert!(found.standard_error() < 0.002);
    }

    #[test]
    fn under_a_roof_it_is_dark_and_in_the_open_it_is_lit() {
        let lamp = Lamp::Disk {
            centre: Vector::new(0.0, 0.0, 3.0),
            right: Vector::new(0.0, 0.5, 0.0),
            down: Vector::new(0.5, 0.0, 0.0),
            radiance: Vector::grey(1.0),
        };
        let ball = Thing::sphere(Vector::new(0.0, 0.0, 1.5), 0.6, WHITE);
        assert_eq!(mean(&world(vec![Thing::floor(WHITE), ball], lamp, 0.0), &CENTRE).mean(), 0.0);
        let open = mean(&world(vec![Thing::floor(WHITE)], lamp, 0.0), &CENTRE);
        assert!((open.mean() - 0.25 / 9.25).abs() < 4.0 * open.standard_error());
    }

    #[test]
    fn a_mirrored_world_gives_the_mirrored_radiance() {
        let at = |x: f64| Thing::sphere(Vector::new(x, 0.4, 0.7), 0.5, WHITE);
        let lamp = |sign: f64| Lamp::Rectangle {
            corner: Vector::new(sign, 0.0, 3.0) + Vector::new(-0.5, -0.5, 0.0),
            right: Vector::new(0.0, 1.0, 0.0),
            down: Vector::new(1.0, 0.0, 0.0),
            radiance: Vector::grey(2.0),
        };
        let (left, right) = (
            world(vec![Thing::floor(WHITE), at(-0.3)], lamp(-0.25), 0.0),
            world(vec![Thing::floor(WHITE), at(0.3)], lamp(0.25), 0.0),
        );
        let mut random = Seed::new(10).named("mirror").generator();
        let mut lit = 0;
        for _ in 0..2000 {
            let [x, y, u, v] = [(); 4].map(|()| random.uniform());
            let look = |x: f64| Look { image: [x, y], lens: [0.5, 0.5], time: 0.0 };
            // Down is along the x axis: v is mirrored with it.
            let a = left.radiance(&look(x), 1.0, &[u, v], &ALL).x;
            let b = right.radiance(&look(1.0 - x), 1.0, &[u, 1.0 - v], &ALL).x;
            assert!((a - b).abs() < 1e-9, "{a} {b}");
            lit += usize::from(a > 0.0);
        }
        assert!(lit > 200, "{lit}");
    }

    #[test]
    fn what_moves_is_where_it_is_at_its_time() {
        let lamp = Lamp::Sun { towards: Vector::new(0.0, 0.0, 1.0), colour: Vector::grey(1.0) };
        let glow = Surface::Glow(Vector::new(3.0, 0.0, 0.0));
        let ball = Thing::sphere(Vector::new(-1.0, 0.0, 0.2), 0.2, glow).moving(Vector::new(2.0, 0.0, 0.0));
        let world = world(vec![Thing::floor(WHITE), ball], lamp, 0.0);
        let seen = |time: f64| world.radiance(&Look { time, ..CENTRE }, 1.0, &[], &ALL).x;
        assert_eq!([seen(0.0), seen(0.5), seen(0.9)].map(|x| x == 3.0), [false, true, false]);
        // In the sun and off the shadow, the white floor shows the sun's colour.
        assert!((seen(0.0) - 1.0).abs() < 1e-12);
    }
}
