//! Sobol's sequence with the direction numbers of Joe and Kuo.
//!
//! **What.** Each axis has a binary generator matrix; point i is the sum without carries (XOR) of
//! the columns at the set bits of i, in natural order, not that of a Gray code. Point 0, the
//! origin, stays: without it the first 2^m points are no net (Owen 2020).
//!
//! **Formula.** With a primitive polynomial z^s + a_1 z^(s-1) + ... + a_(s-1) z + 1 over the field
//! of two elements and odd m_1 ... m_s, m_k < 2^k: m_k = 2 a_1 m_(k-1) XOR ... XOR 2^(s-1) a_(s-1)
//! m_(k-s+1) XOR 2^s m_(k-s) XOR m_(k-s), and column k is m_k 2^(-k).
//!
//! **Guarantees.** The first m of n points are the m points; every aligned block of 2^m points is a
//! (t, m, d)-net in base 2, with t the sum of (s - 1) over the axes: 0 in one and two dimensions, 1
//! in three. Deterministic.
//!
//! **Cost.** One XOR for each coordinate of a batch, one for each set bit of the index at random.
//!
//! **Limits.** At most 256 dimensions. Its rates need n = 2^m. Some pairs of late axes are poor
//! until n is large.
//!
//! **Papers.** I. M. Sobol', USSR Comput. Math. Math. Phys. 7(4) (1967), doi
//! 10.1016/0041-5553(67)90144-9; S. Joe and F. Y. Kuo, SIAM J. Sci. Comput. 30 (2008), doi
//! 10.1137/070709359; point 0: A. B. Owen, On Dropping the First Sobol' Point (2020), arXiv
//! 2008.08051.
//!
//! ```
//! use workbook::samplers::sobol::sobol;
//! let first: Vec<[f64; 2]> = (0..4).map(|i| [sobol(i, 0), sobol(i, 1)]).collect();
//! assert_eq!(first, [[0.0, 0.0], [0.5, 0.5], [0.25, 0.75], [0.75, 0.25]]);
//! ```

use super::digits::GRAIN;
use super::{Digital, Digits, Feature, Guarantee, Net, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};

/// The most dimensions.
pub const MOST_DIMENSIONS: usize = 256;

/// The binary digits of a coordinate, and hence the columns of a matrix.
const DIGITS: usize = 53;

/// The table of Joe and Kuo; its licence lies beside it.
const TABLE: &str = include_str!("sobol/joe_kuo.txt");

/// For each axis the columns of its generator matrix, as whole numbers below 2^53 whose first digit
/// is the highest bit; and the degree of its polynomial.
static MATRICES: [([u64; DIGITS], u32); MOST_DIMENSIONS] = matrices(TABLE.as_bytes());

/// The sampler `sobol`, and its digits.
pub struct Sobol;

static ABOUT: About = About {
    key: "sobol",
    title: "Sobol'",
    summary: "The digital sequence in base 2 with the direction numbers of Joe and Kuo, in natural order.",
    file: "samplers/sobol.rs",
    source: include_str!("sobol.rs"),
    papers: &[
        Paper {
            authors: "I. M. Sobol'",
            year: 1967,
            title: "On the Distribution of Points in a Cube and the Approximate Evaluation of Integrals",
            venue: "USSR Computational Mathematics and Mathematical Physics 7(4), 86-112",
            doi: Some("10.1016/0041-5553(67)90144-9"),
        },
        Paper {
            authors: "S. Joe and F. Y. Kuo",
            year: 2008,
            title: "Constructing Sobol Sequences with Better Two-Dimensional Projections",
            venue: "SIAM Journal on Scientific Computing 30(5), 2635-2654",
            doi: Some("10.1137/070709359"),
        },
        Paper {
            authors: "A. B. Owen",
            year: 2020,
            title: "On Dropping the First Sobol' Point",
            venue: "Monte Carlo and Quasi-Monte Carlo Methods 2020, 71-86",
            doi: Some("10.1007/978-3-030-98319-2_4"),
        },
    ],
};

impl Entry for Sobol {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Sobol {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Prefix, Guarantee::Net, Guarantee::Deterministic]
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // By the inequality of Koksma and Hlawka.
        (feature != Feature::Edge).then_some(-1.0)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, MOST_DIMENSIONS)
    }

    fn net(&self, d: usize) -> Option<Net> {
        // Axis 0 has the identity, which is as good as degree 1.
        let t = MATRICES.iter().take(d).map(|(_, degree)| degree - 1).sum();
        Some(Net { base: 2, t })
    }

    fn digits(&self) -> Digits {
        Digits::Binary
    }

    fn digital(&self, _n: usize, _d: usize) -> Option<Box<dyn Digital>> {
        Some(Box::new(Sobol))
    }
}

impl Digital for Sobol {
    fn numerator(&self, index: u64, axis: usize) -> u64 {
        sobol_bits(index, axis)
    }

    fn numerators(&self, first: u64, axis: usize, out: &mut [u64]) {
        let mut bits = sobol_bits(first, axis);
        let columns = &MATRICES[axis].0;
        for (index, numerator) in (first..).zip(out) {
            *numerator = bits;
            // From i to i + 1 the bits up to the lowest zero flip.
            let flipped = (index.trailing_ones() as usize + 1).min(DIGITS);
            bits = columns[..flipped].iter().fold(bits, |bits, column| bits ^ column);
        }
    }
}

/// The coordinate of point `index` on the axis `axis < 256`, in [0, 1).
pub fn sobol(index: u64, axis: usize) -> f64 {
    sobol_bits(index, axis) as f64 * GRAIN
}

/// The 53 binary digits of that coordinate, as a whole number: the XOR of the
/// matrix' columns at the set bits of the index.
#[inline]
pub fn sobol_bits(index: u64, axis: usize) -> u64 {
    let columns = &MATRICES[axis].0;
    let mut rest = index & ((1 << DIGITS) - 1);
    let mut bits = 0;
    while rest > 0 {
        bits ^= columns[rest.trailing_zeros() as usize];
        rest &= rest - 1;
    }
    bits
}

/// Axes whose tables lie side by side.
const ABREAST: usize = 4;

/// For each four axes and each group of four index bits, the XOR of the columns at the set bits: 32
/// digits, the first highest, of one axis after the other.
static NIBBLES: [[[[u32; ABREAST]; 16]; 8]; MOST_DIMENSIONS / ABREAST] = nibbles();

#[expect(clippy::large_stack_arrays, reason = "it lives in the compiler only")]
const fn nibbles() -> [[[[u32; ABREAST]; 16]; 8]; MOST_DIMENSIONS / ABREAST] {
    let mut table = [[[[0; ABREAST]; 16]; 8]; MOST_DIMENSIONS / ABREAST];
    let mut at = 0;
    while at < MOST_DIMENSIONS * 8 * 16 {
        let (axis, group, set) = (at / 128, at / 16 % 8, at % 16);
        let mut bit = 0;
        while bit < 4 {
            if set >> bit & 1 == 1 {
                let column = MATRICES[axis].0[4 * group + bit];
                table[axis / ABREAST][group][set][axis % ABREAST] ^= (column >> 21) as u32;
            }
            bit += 1;
        }
        at += 1;
    }
    table
}

/// The first 32 digits of a coordinate, by eight looks into a table: fast whatever the index.
#[inline]
pub fn first_digits(index: u32, axis: usize) -> u32 {
    let table = &NIBBLES[axis / ABREAST];
    (0..8).fold(0, |digits, group| digits ^ table[group][(index >> (4 * group) & 15) as usize][axis % ABREAST])
}

/// The same of the axes 4 `four` to 4 `four` + 3, by as many looks as for one; `four` < 64.
#[inline]
pub fn four_first_digits(index: u32, four: usize) -> [u32; ABREAST] {
    let mut digits = [0; ABREAST];
    for (group, table) in NIBBLES[four].iter().enumerate() {
        let found = &table[(index >> (4 * group) & 15) as usize];
        for axis in 0..ABREAST {
            digits[axis] ^= found[axis];
        }
    }
    digits
}

/// The columns of the generator matrix of the axis `axis < 256`, the first digit in bit 52.
pub fn columns(axis: usize) -> &'static [u64; DIGITS] {
    &MATRICES[axis].0
}

/// All matrices, from the text of the table, while the crate is compiled.
#[expect(clippy::large_stack_arrays, reason = "it lives in the compiler only")]
const fn matrices(text: &[u8]) -> [([u64; DIGITS], u32); MOST_DIMENSIONS] {
    let mut matrices = [([0; DIGITS], 1); MOST_DIMENSIONS];
    // The first axis is not in the table: the identity, the van der Corput sequence.
    let mut k = 0;
    while k < DIGITS {
        matrices[0].0[k] = 1 << (DIGITS - 1 - k);
        k += 1;
    }
    let mut at = 0;
    while text[at] != b'\n' {
        at += 1;
    }
    let mut axis = 1;
    while axis < MOST_DIMENSIONS {
        let (_, after) = number(text, at);
        let (degree, after) = number(text, after);
        let (coefficients, after) = number(text, after);
        at = after;
        let mut m = [0; DIGITS];
        let mut k = 0;
        while k < degree as usize {
            (m[k], at) = number(text, at);
            k += 1;
        }
        matrices[axis] = (extend(m, degree as usize, coefficients), degree as u32);
        axis += 1;
    }
    matrices
}

/// The columns of one matrix from its first `degree` numbers m and the inner coefficients of its
/// polynomial.
const fn extend(mut m: [u64; DIGITS], degree: usize, coefficients: u64) -> [u64; DIGITS] {
    let mut k = degree;
    while k < DIGITS {
        m[k] = m[k - degree] ^ (m[k - degree] << degree);
        let mut j = 1;
        while j < degree {
            if coefficients >> (degree - 1 - j) & 1 == 1 {
                m[k] ^= m[k - j] << j;
            }
            j += 1;
        }
        k += 1;
    }
    let mut k = 0;
    while k < DIGITS {
        m[k] <<= DIGITS - 1 - k;
        k += 1;
    }
    m
}

/// The next whole number in `text` from `at`, and where it ends.
const fn number(text: &[u8], mut at: usize) -> (u64, usize) {
    while !text[at].is_ascii_digit() {
        at += 1;
    }
    let mut value = 0;
    while at < text.len() && text[at].is_ascii_digit() {
        value = 10 * value + (text[at] - b'0') as u64;
        at += 1;
    }
    (value, at)
}
