//! The ray tracer: shapes, lamps with soft shadows, a thin lens, things that move.

mod camera;
mod lamp;
pub mod maps;
mod shape;
mod vector;
mod world;

pub use camera::{Beam, Camera, View};
pub use lamp::{Arrival, Lamp};
pub use shape::{NEAR, Ray, Shape};
pub use vector::{Colour, Vector};
pub use world::{Look, Surface, Thing, World};
