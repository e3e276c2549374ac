//! Loops for the widest registers that the processor has, with the same bits for all.
//!
//! A function in `vectorised!` is compiled for AVX-512, for AVX2 and for the processors that the
//! program is built for, and the best version is chosen when it is called. Rust rounds every
//! operation as written, and the loops keep one order of operations whatever the registers, so that
//! all versions give the same bits. [`at_most`] keeps to narrower ones, for tests of just this and
//! for measuring.

use std::cell::Cell;

/// The instructions that a vectorised loop uses, from the least.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Path {
    /// What every processor of the architecture has: SSE2 on x86-64.
    Baseline,
    /// AVX2 with BMI.
    Avx2,
    /// AVX-512 F, BW, DQ and VL.
    Avx512,
}

impl Path {
    /// All, from the least.
    pub const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];

    /// Whether this processor has it.
    pub fn is_available(self) -> bool {
        #[cfg(target_arch = "x86_64")]
        {
            let has_avx2 = is_x86_feature_detected!("avx2")
                && is_x86_feature_detected!("bmi1")
                && is_x86_feature_detected!("bmi2");
            let has_avx512 = is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512bw")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx512vl");
            match self {
                Self::Baseline => true,
                Self::Avx2 => has_avx2,
                Self::Avx512 => has_avx512,
            }
        }
        #[cfg(not(target_arch = "x86_64"))]
        {
            self == Self::Baseline
        }
    }
}

thread_local! {
    static LIMIT: Cell<Path> = const { Cell::new(Path::Avx512) };
}

/// Runs `work` with nothing wider than `path` in this thread.
///
/// ```
/// use workbook::vectors::{Path, at_most};
/// use workbook::{samplers::Method, seed::Seed};
/// let sobol = Method::parse("sobol")?;
/// let points = |path| at_most(path, || sobol.points(100, 7, Seed::new(1)));
/// assert_eq!(points(Path::Baseline)?, points(Path::Avx512)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn at_most<T>(path: Path, work: impl FnOnce() -> T) -> T {
    let before = LIMIT.replace(path);
    let result = work();
    LIMIT.set(before);
    result
}

/// The widest path that is there and allowed.
#[inline]
pub(crate) fn widest() -> Path {
    match LIMIT.get() {
        Path::Avx512 if Path::Avx512.is_available() => Path::Avx512,
        Path::Avx512 | Path::Avx2 if Path::Avx2.is_available() => Path::Avx2,
        _ => Path::Baseline,
    }
}

/// Compiles a function for each [`Path`], and calls the widest that is there and allowed.
macro_rules! vectorised {
    ($(#[$doc:meta])* $vis:vis fn $name:ident $(<$generic:ident: $bound:path>)? ($($argument:ident: $type:ty),* $(,)?)
        $(-> $result:ty)? $body:block
    ) => {
        $(#[$doc])*
        $vis fn $name $(<$generic: $bound>)? ($($argument: $type),*) $(-> $result)? {
            #[inline(always)]
            fn body $(<$generic: $bound>)? ($($argument: $type),*) $(-> $result)? $body

            #[multiversion::multiversion(targets("x86_64+avx512f+avx512bw+avx512dq+avx512vl"))]
            fn avx512 $(<$generic: $bound>)? ($($argument: $type),*) $(-> $result)? {
                body($($argument),*)
            }

            #[multiversion::multiversion(targets("x86_64+avx2+bmi1+bmi2"))]
            fn avx2 $(<$generic: $bound>)? ($($argument: $type),*) $(-> $result)? {
                body($($argument),*)
            }

            match $crate::vectors::widest() {
                $crate::vectors::Path::Avx512 => avx512($($argument),*),
                $crate::vectors::Path::Avx2 => avx2($($argument),*),
                $crate::vectors::Path::Baseline => body($($argument),*),
            }
        }
    };
}

pub(crate) use vectorised;
