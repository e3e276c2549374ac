//! Depth of field: a row of balls on a chequered floor, seen through a wide lens.
//!
//! **What.** Seven balls stand at growing distances, the third in the plane of focus; small lamps far behind show the lens itself, as disks.
//! Sun and sky light the scene without a sample.
//!
//! **Axes.** The pixel (2) and the lens (2): the four dimensions of Cook's lens.
//!
//! **What it teaches.** What is in focus needs samples of the image, what is out of focus samples of the lens, and no pair of axes alone is enough.
//!
//! **Papers.** R. L. Cook, T. Porter and L. Carpenter, Distributed Ray Tracing, SIGGRAPH 1984, doi 10.1145/800031.808590; M. Potmesil and I.
//! Chakravarty, A Lens and Aperture Camera Model for Synthetic Image Generation, SIGGRAPH 1981, doi 10.1145/800224.806818.

use super::tracer::{Camera, Colour, Lamp, Surface, Thing, Vector, View, World};
use super::{Part, Scene};
use crate::catalogue::{About, Entry, Paper};

/// The scene `depth-of-field`.
pub struct DepthOfField;

static ABOUT: About = About {
    key: "depth-of-field",
    title: "Depth of field",
    summary: "A row of balls on a chequered floor through a wide lens; axes: pixel, lens.",
    file: "scenes/depth_of_field.rs",
    source: include_str!("depth_of_field.rs"),
    papers: &[
        Paper {
            authors: "R. L. Cook, T. Porter and L. Carpenter",
            year: 1984,
            title: "Distributed Ray Tracing",
            venue: "SIGGRAPH 1984, 137-145",
            doi: Some("10.1145/800031.808590"),
        },
        Paper {
            authors: "M. Potmesil and I. Chakravarty",
            year: 1981,
            title: "A Lens and Aperture Camera Model for Synthetic Image Generation",
            venue: "SIGGRAPH 1981, 297-305",
            doi: Some("10.1145/800224.806818"),
        },
    ],
};

impl Entry for DepthOfField {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scene for DepthOfField {
    fn parts(&self) -> &'static [Part] {
        &[Part::Image, Part::Lens]
    }

    fn world(&self) -> World {
        let colours = [
            Colour::new(0.8, 0.28, 0.12),
            Colour::new(0.85, 0.55, 0.12),
            Colour::new(0.2, 0.5, 0.75),
            Colour::new(0.85, 0.82, 0.75),
            Colour::new(0.25, 0.6, 0.45),
            Colour::new(0.6, 0.25, 0.5),
            Colour::new(0.8, 0.45, 0.2),
        ];
        let ball = |(k, colour): (usize, &Colour)| {
            let k = k as f64;
            let centre = Vector::new(-1.45 + 0.42 * k + 0.05 * k * k, -2.2 + 1.15 * k + 0.12 * k * k, 0.5);
            Thing::sphere(centre, 0.5, Surface::Matte(*colour))
        };
        let lamp = |k: usize| {
            let k = k as f64;
            let centre = Vector::new(-6.3 + 1.75 * k, 15.0, 1.3 + 0.9 * ((k * 0.618).fract()));
            Thing::sphere(centre, 0.14, Surface::Glow(Colour::new(3.2, 2.5 - 0.12 * k, 1.2 + 0.18 * k)))
        };
        let floor = Surface::Checker { even: Colour::grey(0.7), odd: Colour::new(0.16, 0.18, 0.22), side: 0.9 };
        let things = std::iter::once(Thing::cuboid(Vector::new(-9.0, -9.0, -1.0), Vector::new(9.0, 9.0, 0.0), floor))
            .chain(colours.iter().enumerate().map(ball));
        World {
            things: things.chain((0..8).map(lamp)).collect(),
            lamps: vec![Lamp::Sun {
                towards: Vector::new(-0.5, -0.45, 0.74).unit(),
                colour: Colour::new(0.85, 0.8, 0.7),
            }],
            ambient: Colour::new(0.24, 0.28, 0.36),
            sky: [Colour::new(0.14, 0.18, 0.28), Colour::new(0.03, 0.05, 0.12)],
            camera: Camera::new(&View {
                eye: Vector::new(-0.6, -6.0, 1.5),
                target: Vector::new(0.0, 1.0, 0.55),
                spread: 0.3,
                lens: 0.17,
                focus: 6.1,
            }),
        }
    }
}
