//! Speed of the samplers and measures, beside the public crates that do the same, in one run:
//! `cargo bench --manifest-path benches/sampling/Cargo.toml`.
//!
//! Times are for a whole batch; the counters give items a second, where an item is one coordinate
//! (or one pair, or one frequency of one point). What is compiled for several sets of instructions
//! is measured on each that the processor has.

#![allow(clippy::unwrap_used, reason = "a benchmark stops at the first mistake")]

use divan::{Bencher, black_box, counter::ItemsCount};
use workbook::integrands::Function;
use workbook::metrics::{l2, spectrum, star};
use workbook::points::Points;
use workbook::samplers::batch::{Finish, binary};
use workbook::samplers::{Method, Sampler, halton::Halton, sobol::Sobol, zero_two::ZeroTwo};
use workbook::seed::Seed;
use workbook::vectors::{Path, at_most};

fn main() {
    divan::main();
}

/// Each case on each path of instructions that the processor has: `Avx2 sobol 64`.
fn on_paths(cases: &[&str]) -> Vec<String> {
    let paths = || Path::ALL.into_iter().filter(|path| path.is_available());
    cases.iter().flat_map(|case| paths().map(move |path| format!("{path:?} {case}"))).collect()
}

/// The path of a case, and its words.
fn case(text: &str) -> (Path, Vec<&str>) {
    let mut words = text.split(' ');
    let name = words.next().unwrap();
    (Path::ALL.into_iter().find(|path| format!("{path:?}") == name).unwrap(), words.collect())
}

fn points(name: &str, n: usize, d: usize) -> Points {
    Method::parse(name).unwrap().points(n, d, Seed::new(1)).unwrap()
}

/// Into memory that is there already: the generators alone.
#[divan::bench(args = on_paths(&["sobol 64", "sobol 2", "zero-two 2", "xor 64", "owen-hash 64", "owen-hash 2"]))]
fn fill(bencher: Bencher, what: &str) {
    let (path, words) = case(what);
    let (kind, d) = (words[0], words[1].parse::<usize>().unwrap());
    let n = (1 << 16) / d;
    let finish = match kind {
        "xor" => Finish::Mask(12345 << 21),
        "owen-hash" => Finish::Hash(12345),
        _ => Finish::Plain,
    };
    let digital = if kind == "zero-two" { ZeroTwo.digital(n, d) } else { Sobol.digital(n, d) }.unwrap();
    let mut out = vec![0.0; n * d];
    bencher
        .counter(ItemsCount::new(n * d))
        .bench_local(|| at_most(path, || binary(digital.as_ref(), &vec![finish; d], black_box(&mut out))));
}

/// 4096 points, allocation included.
#[divan::bench(args = [
    "independent 8", "jittered 2", "multi-jittered 2", "correlated-multi-jittered 2", "latin-hypercube 8", "sobol 8", "sobol+xor 8", "sobol+owen-hash 8",
    "sobol+owen-shuffled 8", "sobol+owen 8", "sobol+linear 8", "halton 8", "halton+permutation 8", "halton+owen 8", "halton+xor 8", "faure 8", "hammersley 8", "pmj02 2",
    "kronecker 8", "korobov 8", "bridson 2", "dart-throwing 2", "maximal-poisson 2",
])]
fn batch(bencher: Bencher, what: &str) {
    let (name, d) = what.split_once(' ').unwrap();
    let (d, method): (usize, _) = (d.parse().unwrap(), Method::parse(name).unwrap());
    bencher.counter(ItemsCount::new(4096 * d)).bench(|| method.points(4096, d, Seed::new(1)).unwrap());
}

/// Random access, one coordinate at a time, 4 axes of 1024 points; ours and `sobol_burley`.
#[divan::bench(args = ["sobol+owen-hash", "sobol+owen-shuffled", "sobol+owen", "sobol", "halton"])]
fn random_access(bencher: Bencher, name: &str) {
    let sample = Method::parse(name).unwrap().sample(1 << 16, 4, Seed::new(1)).unwrap();
    bencher.counter(ItemsCount::new(4096_u32)).bench(|| {
        (0..1024)
            .flat_map(|i| (0..4).map(move |axis| (i, axis)))
            .map(|(i, axis)| sample(black_box(i), axis))
            .sum::<f64>()
    });
}

/// Our random access as a plain function, without a method's name.
#[divan::bench]
fn random_access_direct(bencher: Bencher) {
    bencher.counter(ItemsCount::new(4096_u32)).bench(|| {
        let mut sum = 0.0;
        for i in 0..1024 {
            for axis in 0..4 {
                sum += workbook::scrambles::owen_shuffled::sample(black_box(i), axis, 7);
            }
        }
        sum
    });
}

#[divan::bench]
fn random_access_four_at_once(bencher: Bencher) {
    bencher.counter(ItemsCount::new(4096_u32)).bench(|| {
        let point = |i| workbook::scrambles::owen_shuffled::sample_four(black_box(i), 0, 7);
        (0..1024).map(point).map(|x| x.iter().sum::<f64>()).sum::<f64>()
    });
}

#[divan::bench]
fn their_random_access_sobol_burley(bencher: Bencher) {
    bencher.counter(ItemsCount::new(4096_u32)).bench(|| {
        let mut sum = 0.0;
        for i in 0..1024 {
            for axis in 0..4 {
                sum += sobol_burley::sample(black_box(i), axis, 7);
            }
        }
        sum
    });
}

#[divan::bench]
fn their_random_access_sobol_burley_four_at_once(bencher: Bencher) {
    bencher.counter(ItemsCount::new(4096_u32)).bench(|| {
        (0..1024).map(|i| sobol_burley::sample_4d(black_box(i), 0, 7)).map(|x| x.iter().sum::<f32>()).sum::<f32>()
    });
}

#[divan::bench]
fn their_halton(bencher: Bencher) {
    bencher.counter(ItemsCount::new(4096_u32 * 8)).bench(|| {
        let mut sequences: Vec<_> = [2, 3, 5, 7, 11, 13, 17, 19].into_iter().map(halton::Sequence::new).collect();
        (0..4096)
            .flat_map(|_| sequences.iter_mut().map(|sequence| sequence.next().unwrap()).collect::<Vec<f64>>())
            .collect::<Vec<f64>>()
    });
}

#[divan::bench]
fn their_bridson_fast_poisson(bencher: Bencher) {
    let radius = 0.72 * (2.0 / (3.0_f64.sqrt() * 4096.0)).sqrt();
    let count = fast_poisson::Poisson2D::new().with_dimensions([1.0, 1.0], radius).with_seed(1).generate().len();
    bencher
        .counter(ItemsCount::new(2 * count))
        .bench(|| fast_poisson::Poisson2D::new().with_dimensions([1.0, 1.0], radius).with_seed(1).generate());
}

/// One run of ours at the same radius, on the torus.
#[divan::bench(args = [4096, 65536])]
fn bridson_run(bencher: Bencher, n: usize) {
    let radius = 0.72 * workbook::samplers::poisson::hexagonal(n);
    let count = workbook::samplers::bridson::grow(radius, &mut Seed::new(1).generator()).len();
    bencher
        .counter(ItemsCount::new(2 * count))
        .bench(|| workbook::samplers::bridson::grow(radius, &mut Seed::new(1).generator()));
}

#[divan::bench]
fn their_quasirandom_r2(bencher: Bencher) {
    bencher.counter(ItemsCount::new(4096_u32 * 2)).bench(|| {
        let mut sequence = quasirandom::Qrng::<(f64, f64)>::new(0.5);
        (0..4096).map(|_| sequence.r#gen()).collect::<Vec<(f64, f64)>>()
    });
}

#[divan::bench]
fn their_sobol_qmc(bencher: Bencher) {
    use sobol_qmc::Sobol;
    use sobol_qmc::params::JoeKuoD6;
    let params = JoeKuoD6::MINIMAL;
    bencher
        .counter(ItemsCount::new(4096_u32 * 8))
        .bench(|| Sobol::<f64>::new(8, &params).unwrap().take(4096).collect::<Vec<_>>());
}

#[divan::bench]
fn their_rand_xoshiro(bencher: Bencher) {
    use rand::{RngExt, SeedableRng};
    let mut generator = rand::rngs::Xoshiro256PlusPlus::seed_from_u64(1);
    bencher
        .counter(ItemsCount::new(32768_u32))
        .bench_local(|| (0..32768).map(|_| generator.random::<f64>()).collect::<Vec<f64>>());
}

#[divan::bench(args = on_paths(&["4096 2", "100000 2", "1024 3", "100 4"]), sample_count = 10, sample_size = 1)]
fn star_discrepancy(bencher: Bencher, what: &str) {
    let (path, words) = case(what);
    let [n, d] = [0, 1].map(|at| words[at].parse::<usize>().unwrap());
    let points = points("sobol+owen-hash", n, d);
    bencher.counter(ItemsCount::new(n)).bench(|| at_most(path, || star::star_discrepancy(&points).unwrap()));
}

#[divan::bench(args = on_paths(&["centred 2", "wrap 2", "star 3"]))]
fn l2_pairs(bencher: Bencher, what: &str) {
    let (path, words) = case(what);
    let points = points("sobol+owen-hash", 4096, words[1].parse().unwrap());
    let measure = match words[0] {
        "centred" => l2::centred,
        "wrap" => l2::wrap_around,
        _ => l2::star,
    };
    bencher.counter(ItemsCount::new(4096_u32 * 4097 / 2)).bench(|| at_most(path, || measure(&points)));
}

#[divan::bench(args = [4096, 65536])]
fn l2_star_in_the_plane(bencher: Bencher, n: usize) {
    let points = points("sobol+owen-hash", n, 2);
    bencher.counter(ItemsCount::new(n)).bench(|| l2::star(&points));
}

/// Per point and frequency of the whole plane; the number is that of the points.
#[divan::bench(args = on_paths(&["1024", "4096"]))]
fn power_spectrum(bencher: Bencher, what: &str) {
    let (path, words) = case(what);
    let points = points("jittered", words[0].parse().unwrap(), 2);
    bencher
        .counter(ItemsCount::new(points.len() * 257 * 257))
        .bench(|| at_most(path, || spectrum::power(&points, 128).unwrap()));
}

#[divan::bench(args = ["exp(sin(3*x^2))", "exp-sin"])]
fn integrand(bencher: Bencher, text: &str) {
    let (function, points) = (Function::parse(text).unwrap(), points("independent", 4096, 1));
    bencher.counter(ItemsCount::new(4096_u32)).bench(|| points.rows().map(|x| function.evaluate(x)).sum::<f64>());
}

#[divan::bench]
fn halton_into_memory(bencher: Bencher) {
    bencher.counter(ItemsCount::new(4096_u32 * 32)).bench(|| Halton.points(4096, 32, Seed::new(1)).unwrap());
}
