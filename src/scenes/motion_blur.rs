//! Motion blur: balls that roll and fall while the shutter is open, in the light of a round lamp.
//!
//! **What.** One ball flies to the right, one falls, one rests; a disk of light makes their shadows soft, and those of the moving balls move.
//!
//! **Axes.** The pixel (2), the time (1) and the lamp (2).
//!
//! **What it teaches.** The axes meet in one pixel: along the track of a ball its shadow depends on time and lamp together, which padding does not stratify.
//!
//! **Paper.** R. L. Cook, T. Porter and L. Carpenter, Distributed Ray Tracing, SIGGRAPH 1984, doi 10.1145/800031.808590.

use super::tracer::{Camera, Colour, Lamp, Surface, Thing, Vector, View, World};
use super::{Part, Scene};
use crate::catalogue::{About, Entry, Paper};

/// The scene `motion-blur`.
pub struct MotionBlur;

static ABOUT: About = About {
    key: "motion-blur",
    title: "Motion blur",
    summary: "Balls that move while the shutter is open, with soft shadows; axes: pixel, time, lamp.",
    file: "scenes/motion_blur.rs",
    source: include_str!("motion_blur.rs"),
    papers: &[Paper {
        authors: "R. L. Cook, T. Porter and L. Carpenter",
        year: 1984,
        title: "Distributed Ray Tracing",
        venue: "SIGGRAPH 1984, 137-145",
        doi: Some("10.1145/800031.808590"),
    }],
};

impl Entry for MotionBlur {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scene for MotionBlur {
    fn parts(&self) -> &'static [Part] {
        &[Part::Image, Part::Time, Part::Light]
    }

    fn world(&self) -> World {
        let matte = |r, g, b| Surface::Matte(Colour::new(r, g, b));
        World {
            things: vec![
                Thing::floor(Surface::Checker {
                    even: Colour::new(0.72, 0.7, 0.64),
                    odd: Colour::new(0.4, 0.44, 0.46),
                    side: 0.75,
                }),
                Thing::sphere(Vector::new(-1.7, -0.4, 0.45), 0.45, matte(0.85, 0.36, 0.14))
                    .moving(Vector::new(0.8, 0.0, 0.0)),
                Thing::sphere(Vector::new(1.35, 0.5, 1.9), 0.42, matte(0.16, 0.45, 0.7))
                    .moving(Vector::new(0.0, 0.0, -0.7)),
                Thing::sphere(Vector::new(0.2, 1.3, 0.55), 0.55, matte(0.8, 0.76, 0.66)),
            ],
            lamps: vec![Lamp::Disk {
                centre: Vector::new(-2.4, -2.2, 4.6),
                right: Vector::new(0.0, 0.8, 0.0),
                down: Vector::new(0.8, 0.0, 0.0),
                radiance: Colour::new(26.0, 25.2, 23.5),
            }],
            ambient: Colour::new(0.12, 0.13, 0.16),
            sky: [Colour::new(0.45, 0.52, 0.6), Colour::new(0.25, 0.36, 0.52)],
            camera: Camera::new(&View {
                eye: Vector::new(0.1, -6.8, 3.0),
                target: Vector::new(0.1, 0.4, 0.7),
                spread: 0.28,
                lens: 0.0,
                focus: 1.0,
            }),
        }
    }
}
