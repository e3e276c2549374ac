//! The card of a book: the picture that stands for it where somebody links to it. Points, evenly placed, as on its icon.

use crate::raster::Raster;
use crate::samplers::Method;
use crate::seed::Seed;
use crate::sources::Digest;

/// The size that those who show cards ask for, in pixels.
const SIZE: (usize, usize) = (1200, 630);
/// How many points.
const POINTS: usize = 128;
/// The radius of a point, in pixels.
const RADIUS: f64 = 11.0;
/// The colours of the ground and of the points: those of the icon.
const GROUND: [u8; 3] = [0x17, 0x51, 0x8a];
const POINT: [u8; 3] = [0xff, 0xff, 0xff];
/// The points of every book, scrambled by its title.
const METHOD: &str = "sobol+owen";

/// The card of the book with this title, as a PNG file; each title has its own.
pub(super) fn png(title: &str) -> Option<Vec<u8>> {
    let digest = Digest::of(title.as_bytes());
    let seed = digest.bytes().iter().take(8).fold(0_u64, |seed, byte| seed << 8 | u64::from(*byte));
    let points = Method::parse(METHOD).ok()?.points(POINTS, 2, Seed::new(seed)).ok()?;
    let (width, height) = SIZE;
    let mut pixels: Vec<u8> = GROUND.iter().copied().cycle().take(3 * width * height).collect();
    for point in points.rows() {
        disc(&mut pixels, point[0] * width as f64, point[1] * height as f64);
    }
    Raster::colour(width as u32, height as u32, pixels).png().ok().map(|png| png.bytes)
}

/// Draws a point: within a pixel of its edge, the ground shows through.
fn disc(pixels: &mut [u8], x: f64, y: f64) {
    let (width, height) = SIZE;
    let reach = |centre: f64, size: usize| {
        let from = (centre - RADIUS - 1.0).max(0.0) as usize;
        from..((centre + RADIUS + 1.0).max(0.0) as usize + 1).min(size)
    };
    for row in reach(y, height) {
        for column in reach(x, width) {
            let (dx, dy) = (column as f64 + 0.5 - x, row as f64 + 0.5 - y);
            let cover = (RADIUS + 0.5 - (dx * dx + dy * dy).sqrt()).clamp(0.0, 1.0);
            let at = 3 * (row * width + column);
            for (channel, point) in pixels[at..at + 3].iter_mut().zip(POINT) {
                let ground = f64::from(*channel);
                *channel = (ground + cover * (f64::from(point) - ground)).round() as u8;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_title_has_its_card() {
        let (one, other) = (png("One").unwrap(), png("Other").unwrap());
        assert!(one != other && one == png("One").unwrap());
        assert!(one.len() < 60_000, "{}", one.len());
        let image = image::load_from_memory(&one).unwrap().to_rgb8();
        assert_eq!((image.width() as usize, image.height() as usize), SIZE);
        let white = image.pixels().filter(|pixel| pixel.0 == POINT).count() as f64;
        let share = POINTS as f64 * std::f64::consts::PI * RADIUS * RADIUS / (SIZE.0 * SIZE.1) as f64;
        let found = white / (SIZE.0 * SIZE.1) as f64;
        assert!((0.5 * share..share).contains(&found), "{found} of the card is white, points cover {share}");
    }
}
