//! The checkerboard: a chequered floor up to the horizon.
//!
//! **What.** The squares become smaller than pixels and end in even grey. Nothing is sampled but the pixel.
//!
//! **Axes.** The pixel (2).
//!
//! **What it teaches.** Aliasing: samples on a regular grid make patterns of the fine squares, random ones noise, stratified ones less noise.
//!
//! **Paper.** R. L. Cook, Stochastic Sampling in Computer Graphics, ACM Trans. Graph. 5(1) (1986), doi 10.1145/7529.8927.

use super::tracer::{Camera, Colour, Lamp, Surface, Thing, Vector, View, World};
use super::{Part, Scene};
use crate::catalogue::{About, Entry, Paper};

/// The scene `checkerboard`.
pub struct Checkerboard;

static ABOUT: About = About {
    key: "checkerboard",
    title: "Checkerboard",
    summary: "A chequered floor up to the horizon, finer than any pixel; axes: pixel.",
    file: "scenes/checkerboard.rs",
    source: include_str!("checkerboard.rs"),
    papers: &[Paper {
        authors: "R. L. Cook",
        year: 1986,
        title: "Stochastic Sampling in Computer Graphics",
        venue: "ACM Transactions on Graphics 5(1), 51-72",
        doi: Some("10.1145/7529.8927"),
    }],
};

impl Entry for Checkerboard {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scene for Checkerboard {
    fn parts(&self) -> &'static [Part] {
        &[Part::Image]
    }

    fn world(&self) -> World {
        World {
            things: vec![Thing::floor(Surface::Checker {
                even: Colour::new(0.86, 0.84, 0.78),
                odd: Colour::new(0.08, 0.1, 0.14),
                side: 1.0,
            })],
            lamps: vec![Lamp::Sun { towards: Vector::new(0.0, 0.0, 1.0), colour: Colour::grey(0.85) }],
            ambient: Colour::grey(0.1),
            sky: [Colour::new(0.62, 0.72, 0.84), Colour::new(0.2, 0.36, 0.62)],
            camera: Camera::new(&View {
                eye: Vector::new(0.3, 0.0, 1.6),
                target: Vector::new(2.0, 10.0, -0.6),
                spread: 0.5,
                lens: 0.0,
                focus: 1.0,
            }),
        }
    }
}
