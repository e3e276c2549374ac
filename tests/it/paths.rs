//! The same bits on every path of instructions: all that is compiled for several is computed on each
//! that the processor has.

use std::fmt::Debug;
use workbook::metrics::{l2, spectrum, star};
use workbook::points::Points;
use workbook::samplers::batch::{Finish, binary};
use workbook::samplers::{Method, Sampler, sobol::Sobol};
use workbook::seed::Seed;
use workbook::vectors::{Path, at_most};

/// Computes on every path that there is, and compares.
fn same_on_all<T: PartialEq + Debug>(what: &str, compute: impl Fn() -> T) {
    let baseline = at_most(Path::Baseline, &compute);
    for path in Path::ALL.into_iter().filter(|path| path.is_available()) {
        // Not `assert_eq!`: a difference in a thousand numbers says nothing more.
        assert!(at_most(path, &compute) == baseline, "{what} on {path:?}");
    }
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|x| x.to_bits()).collect()
}

fn points(name: &str, n: usize, d: usize) -> Points {
    Method::parse(name).expect(name).points(n, d, Seed::new(8)).expect(name)
}

#[test]
fn at_most_is_for_its_work_only() {
    let nested = at_most(Path::Baseline, || {
        at_most(Path::Avx2, || ());
        points("sobol+xor", 100, 3)
    });
    assert_eq!(nested, points("sobol+xor", 100, 3));
    assert!(Path::Baseline.is_available());
}

#[test]
fn all_methods_give_the_same_points() {
    for method in Method::all() {
        for (n, d) in [(1, 1), (16, 2), (100, 2), (125, 3), (256, 2), (1000, 7), (257, 64)] {
            if method.points(n, d, Seed::new(8)).is_ok() {
                same_on_all(&format!("{} {n} {d}", method.name()), || {
                    method.points(n, d, Seed::new(8)).map(|points| bits(points.coordinates())).ok()
                });
            }
        }
    }
}

/// Against the digits one by one, for counts that leave parts of registers over.
#[test]
fn fast_binary_points_are_the_slow_ones() {
    use workbook::scrambles::owen_hash::scramble;
    for (n, d) in [(1, 1), (3, 1), (63, 1), (65, 3), (129, 5), (1000, 2), (77, 64)] {
        let digital = Sobol.digital(n, d).expect("digits");
        for finish in [Finish::Plain, Finish::Mask(0x1b_adca_fe12_3457), Finish::Hash(0x89ab_cdef)] {
            let fast = || {
                let mut out = vec![0.0; n * d];
                assert!(binary(digital.as_ref(), &vec![finish; d], &mut out));
                bits(&out)
            };
            let slow = |at: usize| {
                let numerator = digital.numerator((at / d) as u64, at % d) >> 21 << 21;
                match finish {
                    Finish::Plain => numerator as f64 / 9_007_199_254_740_992.0,
                    Finish::Mask(mask) => (numerator ^ mask) as f64 / 9_007_199_254_740_992.0,
                    Finish::Hash(key) => f64::from(scramble((numerator >> 21) as u32, key)) / 4_294_967_296.0,
                }
            };
            assert_eq!(fast(), bits(&(0..n * d).map(slow).collect::<Vec<_>>()), "{finish:?} {n} {d}");
            same_on_all(&format!("{finish:?} {n} {d}"), fast);
        }
    }
}

#[test]
fn all_measures_have_the_same_value() {
    for (n, d) in [(1, 2), (31, 2), (33, 3), (500, 2), (200, 3), (64, 5)] {
        let points = points("independent", n, d);
        same_on_all(&format!("L2 {n} {d}"), || {
            bits(&[l2::star(&points), l2::centred(&points), l2::wrap_around(&points)])
        });
        if d < 4 {
            same_on_all(&format!("D* {n} {d}"), || star::star_discrepancy(&points).expect("valid"));
        }
        if d == 2 {
            same_on_all(&format!("spectrum {n}"), || bits(&spectrum::power_rows(&points, 21, 0..22).expect("plane")));
        }
    }
}
