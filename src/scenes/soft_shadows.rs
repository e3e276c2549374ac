//! Soft shadows: a post, a ball and a box under a square lamp.
//!
//! **What.** A white floor under a lamp of 2 x 2, which each point of the floor sees whole, in part, or not at all. The shadow of the post
//! is sharp at its foot and widens towards its tip: the penumbra is as wide as the lamp seen through the edge.
//!
//! **Axes.** The pixel (2) and the lamp (2).
//!
//! **What it teaches.** In the penumbra the light samples decide, at edges the image samples, elsewhere nothing varies but the
//! distance to the lamp, so that stratifying gains there most.
//!
//! **Paper.** R. L. Cook, T. Porter and L. Carpenter, Distributed Ray Tracing, SIGGRAPH 1984, doi 10.1145/800031.808590.

use super::tracer::{Camera, Colour, Lamp, Surface, Thing, Vector, View, World};
use super::{Part, Scene};
use crate::catalogue::{About, Entry, Paper};

/// The scene `soft-shadows`.
pub struct SoftShadows;

static ABOUT: About = About {
    key: "soft-shadows",
    title: "Soft shadows",
    summary: "A post, a ball and a box under a square lamp; axes: pixel, lamp.",
    file: "scenes/soft_shadows.rs",
    source: include_str!("soft_shadows.rs"),
    papers: &[Paper {
        authors: "R. L. Cook, T. Porter and L. Carpenter",
        year: 1984,
        title: "Distributed Ray Tracing",
        venue: "SIGGRAPH 1984, 137-145",
        doi: Some("10.1145/800031.808590"),
    }],
};

impl Entry for SoftShadows {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scene for SoftShadows {
    fn parts(&self) -> &'static [Part] {
        &[Part::Image, Part::Light]
    }

    fn world(&self) -> World {
        let matte = |r, g, b| Surface::Matte(Colour::new(r, g, b));
        World {
            things: vec![
                Thing::floor(matte(0.78, 0.76, 0.72)),
                Thing::cuboid(Vector::new(-1.8, 0.0, 0.0), Vector::new(-1.6, 0.2, 1.9), matte(0.15, 0.4, 0.62)),
                Thing::sphere(Vector::new(0.7, 0.3, 0.65), 0.65, matte(0.85, 0.45, 0.16)),
                Thing::cuboid(Vector::new(-0.45, -1.35, 0.0), Vector::new(0.1, -0.8, 0.45), matte(0.3, 0.55, 0.36)),
            ],
            lamps: vec![Lamp::Rectangle {
                corner: Vector::new(-4.4, -3.0, 3.6),
                right: Vector::new(0.0, 1.6, 0.0),
                down: Vector::new(1.3, 0.0, 0.95),
                radiance: Colour::new(27.0, 26.2, 24.5),
            }],
            ambient: Colour::new(0.1, 0.115, 0.14),
            sky: [Colour::new(0.5, 0.55, 0.62), Colour::new(0.3, 0.4, 0.55)],
            camera: Camera::new(&View {
                eye: Vector::new(0.3, -6.5, 3.6),
                target: Vector::new(0.15, 0.5, 0.5),
                spread: 0.26,
                lens: 0.0,
                focus: 1.0,
            }),
        }
    }
}
