//! Tests of the film: samples, whole images, and the errors that wrong samples make.

use super::{Image, Pixels, Randomisation, Rendering, Sampling, Unfit};
use crate::catalogue;
use crate::samplers::Method;
use crate::scenes::{Part, SCENES, Scene, axes};
use crate::seed::Seed;
use crate::stats::{fourier, moments, regression};

fn scene(key: &str) -> &'static dyn Scene {
    catalogue::find(SCENES, key).expect("a scene")
}

fn sampling(method: &str, looks: usize) -> Sampling {
    let method = Method::parse(method).expect("a method");
    Sampling { method, looks, lights: 1, randomisation: Randomisation::Pixel, padded: false }
}

fn image(key: &str, size: [usize; 2], sampling: Sampling, seed: u64) -> Image {
    Rendering::new(scene(key), size, sampling, Seed::new(seed)).and_then(|it| it.image()).expect("an image")
}

/// The errors in luminance against a reference of 1024 samples by another method.
fn errors(key: &str, sampling: Sampling) -> Vec<f64> {
    let size = [48, 36];
    let reference = image(key, size, self::sampling("sobol+owen-hash", 1024), 99).luminance();
    image(key, size, sampling, 7).luminance().iter().zip(reference).map(|(a, b)| a - b).collect()
}

#[test]
fn every_scene_is_finite_and_neither_black_nor_white() {
    for scene in SCENES {
        assert_eq!(scene.parts().first(), Some(&Part::Image));
        assert!(!scene.parts()[..scene.parts().len() - 1].contains(&Part::Light), "the lamp comes last");
        let image = image(scene.about().key, [40, 30], sampling("independent", 8), 1);
        let light: Vec<f64> = image.luminance();
        assert!(light.iter().all(|light| light.is_finite() && *light >= 0.0));
        let mean = moments::mean(&light);
        assert!((0.1..0.8).contains(&mean) && moments::variance(&light) > 1e-3, "{scene:?}: {mean}");
    }
}

/// Leaving out what a pixel cannot see changes nothing.
#[test]
fn what_is_left_out_is_not_seen() {
    for scene in SCENES {
        let world = scene.world();
        let all: Vec<usize> = (0..world.things.len()).collect();
        let mut random = Seed::new(3).named("seen").generator();
        let (mut seen, mut fewer) = (Vec::new(), 0);
        for _ in 0..2000 {
            let (size, aspect) = ([1.0 / 48.0, 1.0 / 36.0], 4.0 / 3.0);
            let middle = [random.uniform(), random.uniform()];
            world.see(middle, size, aspect, &mut seen);
            fewer += usize::from(seen.len() < all.len());
            let mut near = |k: usize| middle[k] + (random.uniform() - 0.5) * size[k];
            let image = [near(0), near(1)];
            let look = crate::scenes::tracer::Look {
                image,
                lens: [random.uniform(), random.uniform()],
                time: random.uniform(),
            };
            let lights = [random.uniform(), random.uniform()];
            assert_eq!(world.radiance(&look, aspect, &lights, &seen), world.radiance(&look, aspect, &lights, &all));
        }
        assert!(fewer > 1000 || all.len() == 1, "{scene:?}: {fewer}");
    }
}

/// The samples of every pixel lie in the cube, and those of a sequence are the ones that fall into the pixel.
#[test]
fn one_sequence_serves_the_whole_image() {
    for (method, columns, rows) in [("halton", 16, 27), ("sobol", 16, 16)] {
        let sampling = Sampling { randomisation: Randomisation::Sequence, ..sampling(method, 4) };
        let parts = scene("soft-shadows").parts();
        let pixels = Pixels::new(sampling, parts, [columns, rows], Seed::new(1)).expect("a sequence");
        // The plain points of the sequence, each put into its pixel by hand.
        let count = 4 * columns * rows;
        let points = Method::parse(method).expect("it").points(count, 4, Seed::new(1)).expect("points");
        let mut found = vec![Vec::new(); columns * rows];
        for point in points.rows() {
            let (x, y) = (point[0] * columns as f64, point[1] * rows as f64);
            found[y as usize * columns + x as usize].extend([x.fract(), y.fract(), point[2], point[3]]);
        }
        for (pixel, found) in found.iter().enumerate() {
            let samples = pixels.samples(pixel % columns, pixel / columns).expect("samples").looks;
            assert_eq!(samples.len(), found.len(), "{method}: {pixel}");
            assert!(samples.iter().zip(found).all(|(a, b)| (a - b).abs() < 1e-9), "{method}: {samples:?} {found:?}");
        }
    }
}

#[test]
fn samples_are_in_the_cube_and_as_many_as_asked() {
    let parts = scene("motion-blur").parts();
    for randomisation in
        [Randomisation::Pixel, Randomisation::Shift, Randomisation::Same, Randomisation::Tiled, Randomisation::Diagonal]
    {
        for (lights, padded) in [(1, false), (4, false), (4, true), (1, true)] {
            let sampling = Sampling { lights, randomisation, padded, ..sampling("sobol+xor", 16) };
            let pixels = Pixels::new(sampling, parts, [20, 20], Seed::new(5)).expect("samples");
            let (a, b) = (pixels.samples(1, 2).expect("samples"), pixels.samples(9, 10).expect("samples"));
            assert_eq!(a.looks.len(), 16 * if lights > 1 { 3 } else { 5 });
            assert_eq!(a.lights.len(), if lights > 1 { 16 * 4 * 2 } else { 0 });
            assert!(a.looks.iter().chain(&a.lights).all(|x| (0.0..1.0).contains(x)));
            // (1, 2) and (9, 10) have one place in the tiles.
            let alike = matches!(randomisation, Randomisation::Same | Randomisation::Tiled);
            assert_eq!(a == b, alike, "{randomisation:?}");
        }
    }
}

/// Padding keeps the strata of each part, though the sampler alone could not serve all axes.
#[test]
fn padding_keeps_the_strata_of_each_part() {
    let parts = scene("depth-of-field").parts();
    let sampling = sampling("larcher-pillichshammer+xor", 16);
    assert!(sampling.arrange(parts).expect("padding").padded);
    let samples = Pixels::new(sampling, parts, [4, 4], Seed::new(5)).and_then(|it| it.samples(3, 1)).expect("samples");
    for first in [0, 2] {
        let mut cells: Vec<usize> =
            samples.looks.chunks(4).map(|x| (x[first] * 4.0) as usize * 4 + (x[first + 1] * 4.0) as usize).collect();
        cells.sort_unstable();
        assert_eq!(cells, (0..16).collect::<Vec<_>>());
    }
    // The two parts are in different orders: joined, they are no copies of each other.
    assert!(samples.looks.chunks(4).any(|x| (x[0] * 4.0) as usize != (x[2] * 4.0) as usize));
}

#[test]
fn what_cannot_be_is_refused() {
    let refused = |key: &str, sampling: Sampling| sampling.arrange(scene(key).parts()).expect_err("refused");
    assert_eq!(refused("checkerboard", Sampling { lights: 4, ..sampling("independent", 4) }), Unfit::Lights);
    assert!(matches!(refused("soft-shadows", sampling("jittered", 15)), Unfit::Refused(_)));
    let sequence = Sampling { randomisation: Randomisation::Sequence, ..sampling("sobol+xor", 4) };
    assert_eq!(refused("soft-shadows", sequence), Unfit::Sequence);
    assert!(matches!(refused("soft-shadows", Sampling { lights: 3, ..sampling("jittered", 16) }), Unfit::Refused(_)));
}

/// The errors of random samples fall like n^(-1/2); those of stratified ones are smaller from the start.
#[test]
fn random_errors_fall_with_the_root_and_strata_help() {
    let counts = [4, 16, 64];
    let rmse = |method: &str, n: usize| moments::root_mean_square(&errors("soft-shadows", sampling(method, n)));
    let logs = |values: &[f64]| values.iter().map(|value| crate::stats::portable::log2(*value)).collect::<Vec<_>>();
    let random = counts.map(|n| rmse("independent", n));
    let line = regression::least_squares(&logs(&counts.map(|n| n as f64)), &logs(&random)).expect("a line");
    assert!((line.slope + 0.5).abs() < 0.06, "{line:?}");
    // The standard error of these errors is about 3 % each: the gains are ten times that and more.
    assert!(rmse("jittered", 16) < 0.7 * random[1] && rmse("sobol+owen-hash", 16) < 0.6 * random[1]);
}

/// The same points in every pixel: errors are alike in neighbours, and their spectrum is high at low frequencies, where that of
/// independent pixels is flat.
#[test]
fn wrong_randomisation_shows_in_the_spectrum() {
    let low = |randomisation| {
        let errors = errors("soft-shadows", Sampling { randomisation, ..sampling("halton+permutation", 16) });
        let power = fourier::power(&errors, 48);
        let near = |k: usize, n: usize| k.min(n - k) <= 4;
        let low = (1..errors.len()).filter(|&at| near(at % 48, 48) && near(at / 48, 36));
        moments::mean(&low.map(|at| power[at]).collect::<Vec<_>>())
    };
    // 80 frequencies, in pairs of equals: the mean of a flat spectrum is 1 with a standard error of 0.16.
    let right = [low(Randomisation::Pixel), low(Randomisation::Shift)];
    assert!(right.iter().all(|right| (right - 1.0).abs() < 0.6), "{right:?}");
    let wrong = low(Randomisation::Same);
    assert!(wrong > 3.0, "{wrong}");
}

/// The mean of many images that are shifted rightly nears the truth; with one random number for all axes it stays off.
#[test]
fn the_diagonal_is_biased() {
    let size = [24, 18];
    let exact = image("soft-shadows", size, sampling("sobol+owen-hash", 1024), 1).luminance();
    let off = |randomisation| {
        let mut sum = vec![0.0; exact.len()];
        for seed in 0..200 {
            let image = image("soft-shadows", size, Sampling { randomisation, ..sampling("sobol", 4) }, seed);
            sum.iter_mut().zip(image.luminance()).for_each(|(sum, light)| *sum += light / 200.0);
        }
        let errors: Vec<f64> = sum.iter().zip(&exact).map(|(mean, exact)| mean - exact).collect();
        moments::root_mean_square(&errors)
    };
    let (right, wrong) = (off(Randomisation::Shift), off(Randomisation::Diagonal));
    assert!(wrong > 2.0 * right, "{right} {wrong}");
}

#[test]
fn the_axes_of_every_scene_are_counted() {
    let counts: Vec<usize> = SCENES.iter().map(|scene| axes(scene.parts())).collect();
    assert_eq!(counts, [2, 4, 4, 5]);
}
