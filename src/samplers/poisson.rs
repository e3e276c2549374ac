//! What the Poisson-disk samplers share: distances on the torus of up to four dimensions, buckets of
//! points, and the search for a radius that gives n points.

use super::{Refused, refused};
use crate::seed::{Random, Seed};
use crate::stats::portable;

/// The most dimensions: of these the densest packing is known in closed form and small.
pub const MOST_DIMENSIONS: usize = 4;

/// The most points in 1, 2, 3 and 4 dimensions.
const MOST: [usize; MOST_DIMENSIONS] = [1 << 24, 1 << 24, 1 << 20, 1 << 16];

/// Checks n and d for the Poisson-disk samplers: d from 1 to 4, n at most 2^24 in the plane, 2^20
/// and 2^16 in three and four dimensions.
pub(super) fn check(n: usize, d: usize) -> Result<(), Refused> {
    refused::check(n, d, MOST_DIMENSIONS)?;
    let rule = match d {
        3 => "at most 1048576 in three dimensions",
        4 => "at most 65536 in four dimensions",
        _ => "at most 16777216",
    };
    let most = MOST[d - 1];
    if n > most { Err(Refused::Count { n, below: Some(most), above: None, rule }) } else { Ok(()) }
}

/// A point of the unit torus of D dimensions.
pub type Place<const D: usize> = [f64; D];

/// The coordinates of the points that `$places::<D>(..)` gives, with D the number of dimensions.
macro_rules! in_dimensions {
    ($d:expr, $places:ident($($argument:expr),*)) => {
        match $d {
            1 => $places::<1>($($argument),*).map(Vec::into_flattened),
            2 => $places::<2>($($argument),*).map(Vec::into_flattened),
            3 => $places::<3>($($argument),*).map(Vec::into_flattened),
            _ => $places::<4>($($argument),*).map(Vec::into_flattened),
        }
    };
}
pub(super) use in_dimensions;

/// The largest distance that n points of the unit torus can keep: that of a hexagonal lattice,
/// sqrt(2 / (sqrt(3) n)).
pub fn hexagonal(n: usize) -> f64 {
    (2.0 / (3.0_f64.sqrt() * n as f64)).sqrt()
}

/// The distance of neighbours in the densest lattice of n points of the unit torus in `d`
/// dimensions: 1/n on the line, [`hexagonal`] in the plane, that of the face-centred cubic lattice
/// in three dimensions and of D4 in four (J. H. Conway and N. J. A. Sloane, Sphere Packings,
/// Lattices and Groups, doi 10.1007/978-1-4757-6568-7). `None` in more, and of no points.
pub fn densest(n: usize, d: usize) -> Option<f64> {
    let volume = 1.0 / n as f64;
    match d {
        _ if n == 0 => None,
        1 => Some(volume),
        2 => Some(hexagonal(n)),
        3 => Some(portable::pow(2.0_f64.sqrt() * volume, 1.0 / 3.0)),
        4 => Some((2.0 * volume).sqrt().sqrt()),
        _ => None,
    }
}

/// The d-th root of `x >= 0`.
fn root(x: f64, d: usize) -> f64 {
    match d {
        1 => x,
        2 => x.sqrt(),
        4 => x.sqrt().sqrt(),
        _ => portable::pow(x, 1.0 / d as f64),
    }
}

/// The squared distance of two points of the unit torus.
#[inline]
pub fn squared_distance<const D: usize>(a: Place<D>, b: Place<D>) -> f64 {
    let mut sum = 0.0;
    for axis in 0..D {
        let difference = (a[axis] - b[axis]).abs();
        let wrapped = difference.min(1.0 - difference);
        sum += wrapped * wrapped;
    }
    sum
}

/// Points of the torus in a grid of cubic buckets, to find neighbours.
pub struct Buckets<const D: usize> {
    side: usize,
    heads: Vec<u32>,
    next: Vec<u32>,
    places: Vec<Place<D>>,
}

/// No point: the end of a bucket's list.
const NONE: u32 = u32::MAX;

impl<const D: usize> Buckets<D> {
    /// Empty buckets, `side` of them along each axis: at least one, at most 2^28 in all.
    pub fn new(side: usize) -> Self {
        let side = side.clamp(1, 1 << (28 / D.max(1)));
        Self { side, heads: vec![NONE; side.pow(D as u32)], next: Vec::new(), places: Vec::new() }
    }

    /// The points `places` in buckets as [`new`](Self::new) makes them.
    pub fn holding(side: usize, places: &[Place<D>]) -> Self {
        let mut buckets = Self::new(side);
        for &place in places {
            buckets.add(place);
        }
        buckets
    }

    /// The points so far, in the order of their coming.
    pub fn places(&self) -> &[Place<D>] {
        &self.places
    }

    /// The points, in the order of their coming.
    pub fn into_places(self) -> Vec<Place<D>> {
        self.places
    }

    /// Adds a point.
    pub fn add(&mut self, place: Place<D>) {
        let bucket = (0..D).rev().fold(0, |bucket, axis| bucket * self.side + self.row(place[axis]));
        self.next.push(self.heads[bucket]);
        self.heads[bucket] = self.places.len() as u32;
        self.places.push(place);
    }

    fn row(&self, x: f64) -> usize {
        ((x * self.side as f64) as usize).min(self.side - 1)
    }

    /// `at` - `back` modulo the side, for both less than about twice the side: without a division.
    fn wrap(&self, at: usize, back: usize) -> usize {
        let mut bucket = at + 2 * self.side - back;
        while bucket >= self.side {
            bucket -= self.side;
        }
        bucket
    }

    /// Whether some point is nearer to `place` than `radius`.
    pub fn any_within(&self, place: Place<D>, radius: f64) -> bool {
        let reach = ((radius * self.side as f64).ceil() as usize).min(self.side / 2);
        self.smallest(place, reach, radius * radius) < radius * radius
    }

    /// The squared distance to the nearest point; infinite if there is none.
    pub fn nearest(&self, place: Place<D>) -> f64 {
        self.nearest_below(place, f64::INFINITY)
    }

    /// The same where it is below `limit`, otherwise `limit`.
    pub fn nearest_below(&self, place: Place<D>, limit: f64) -> f64 {
        let mut best = limit;
        for ring in 0..=self.side.div_ceil(2) {
            best = self.ring(place, ring, best);
            // What is not yet seen is at least `ring` whole buckets away.
            let seen = ring as f64 / self.side as f64;
            if best <= seen * seen {
                break;
            }
        }
        best
    }

    /// The smallest squared distance to a point at most `reach` buckets away, or anything below
    /// `enough`.
    fn smallest(&self, place: Place<D>, reach: usize, enough: f64) -> f64 {
        let mut best = f64::INFINITY;
        for ring in 0..=reach {
            best = self.ring(place, ring, best);
            if best < enough {
                break;
            }
        }
        best
    }

    /// The smaller of `best` and the squared distances to points in the shell of buckets `ring`
    /// away.
    fn ring(&self, place: Place<D>, ring: usize, best: f64) -> f64 {
        let rows = place.map(|x| self.row(x));
        let span = 2 * ring;
        let mut best = best;
        // The offsets of the axes behind the first, which is walked along.
        let mut offsets = [0; D];
        loop {
            // Only where another axis is at an end of the shell is the line whole.
            let whole = offsets[1..].iter().any(|&offset| offset == 0 || offset == span);
            let step = if whole { 1 } else { span.max(1) };
            let line =
                (1..D).rev().fold(0, |line, axis| line * self.side + self.wrap(rows[axis] + offsets[axis], ring));
            for right in (0..=span).step_by(step) {
                let mut at = self.heads[line * self.side + self.wrap(rows[0] + right, ring)];
                while at != NONE {
                    best = best.min(squared_distance(place, self.places[at as usize]));
                    at = self.next[at as usize];
                }
            }
            let Some(axis) = (1..D).find(|&axis| offsets[axis] < span) else { return best };
            offsets[axis] += 1;
            offsets[1..axis].fill(0);
        }
    }
}

/// A uniform point.
pub fn uniform<const D: usize>(random: &mut Random) -> Place<D> {
    std::array::from_fn(|_| random.uniform())
}

/// Runs of an algorithm, whose count varies, before the last points are made to fit.
const RUNS: u64 = 8;

/// Runs at all.
const MOST_RUNS: u64 = 64;

/// Radii that are tried for the last points.
const STEPS: u64 = 64;

/// Exactly `n` points by `run(start, radius, random)`, which adds points to those of `start` until
/// no more fit at this radius, so that its count falls as the radius grows.
///
/// The radius is corrected from run to run. Where no run hits n, the one that came nearest from
/// below is completed. Nothing is ever taken away: whatever holds of a run, as that it
/// is maximal, holds of what is returned, at its own radius.
pub fn exactly<const D: usize>(
    n: usize,
    seed: Seed,
    share: f64,
    run: impl Fn(&[Place<D>], f64, &mut Random) -> Vec<Place<D>>,
) -> Result<Vec<Place<D>>, Refused> {
    let mut radius = share * densest(n, D).unwrap_or(1.0);
    let mut best: (f64, Vec<Place<D>>) = (radius, Vec::new());
    for k in 0..MOST_RUNS {
        let places = run(&[], radius, &mut seed.at(k).generator());
        if places.len() == n {
            return Ok(places);
        }
        let correction = root(places.len() as f64 / n as f64, D);
        if places.len() < n && places.len() > best.1.len() {
            best = (radius, places);
        }
        if k >= RUNS && !best.1.is_empty() {
            let (radius, start) = std::mem::take(&mut best);
            if let Some(places) = complete(n, radius, start, seed.named("complete").at(k), &run) {
                return Ok(places);
            }
        }
        // Once near, part of the correction: the count is noisy.
        let weight = if k < 3 { 1.0 } else { 0.3 };
        radius *= 1.0 + weight * (correction - 1.0);
        if k >= RUNS {
            radius *= 1.01;
        }
    }
    Err(Refused::Count { n, below: None, above: None, rule: "a count that some radius gives" })
}

/// More points to the fewer than `n` of `start`, to which none can be added at `radius`: the radius
/// shrinks until holes open for as many as are missing.
///
/// A radius at which too many fit is too small, and the next is tried between it and the last at
/// which too few did; in the end holes open one by one. `None` if two keep opening together.
fn complete<const D: usize>(
    n: usize,
    radius: f64,
    start: Vec<Place<D>>,
    seed: Seed,
    run: &impl Fn(&[Place<D>], f64, &mut Random) -> Vec<Place<D>>,
) -> Option<Vec<Place<D>>> {
    let (mut small, mut large, mut places) = (None, radius, start);
    for k in 0..STEPS {
        let radius = small.map_or(0.99 * large, |small: f64| f64::midpoint(small, large));
        let more = run(&places, radius, &mut seed.at(k).generator());
        match more.len().cmp(&n) {
            std::cmp::Ordering::Equal => return Some(more),
            std::cmp::Ordering::Less => (large, places) = (radius, more),
            std::cmp::Ordering::Greater => small = Some(radius),
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lattices of their own: n points at that distance, and not nearer.
    #[test]
    fn densest_lattices_have_their_distance() {
        let cubic: Vec<Place<3>> = vec![[0.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.5, 0.0, 0.5], [0.0, 0.5, 0.5]];
        let smallest = |places: &[Place<3>]| {
            let pairs = places.iter().enumerate().flat_map(|(i, a)| places[..i].iter().map(move |b| (a, b)));
            pairs.map(|(a, b)| squared_distance(*a, *b)).fold(f64::INFINITY, f64::min).sqrt()
        };
        assert!((smallest(&cubic) - densest(4, 3).unwrap()).abs() < 1e-15);
        // D4: all points of halves with an even sum of twice the coordinates.
        let halves = |k: u32| [0, 1, 2, 3].map(|axis| f64::from(k >> axis & 1) * 0.5);
        let even: Vec<Place<4>> = (0..16).filter(|k: &u32| k.count_ones().is_multiple_of(2)).map(halves).collect();
        let nearest = even[1..].iter().map(|&b| squared_distance(even[0], b)).fold(f64::INFINITY, f64::min).sqrt();
        assert!((nearest - densest(8, 4).unwrap()).abs() < 1e-15);
        assert_eq!((densest(5, 1), densest(5, 5), densest(0, 2)), (Some(0.2), None, None));
    }

    fn neighbours_agree<const D: usize>() {
        let mut random = Seed::new(D as u64).generator();
        for side in [1, 2, 3, 5, 8] {
            let mut buckets = Buckets::<D>::new(side);
            for _ in 0..60 {
                let place = uniform(&mut random);
                let force = buckets.places().iter().map(|&other| squared_distance(place, other));
                let force = force.fold(f64::INFINITY, f64::min);
                assert_eq!(buckets.nearest(place), force);
                for radius in [0.01, 0.2, 0.45] {
                    assert_eq!(buckets.any_within(place, radius), force < radius * radius, "{D}, {side}, {radius}");
                }
                buckets.add(place);
            }
        }
    }

    #[test]
    fn buckets_find_what_a_search_finds() {
        neighbours_agree::<1>();
        neighbours_agree::<2>();
        neighbours_agree::<3>();
        neighbours_agree::<4>();
    }
}
