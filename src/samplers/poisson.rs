//! What the Poisson-disk samplers share: distances on the torus, buckets of points, and the search
//! for a radius that gives n points.

use crate::seed::{Random, Seed};

/// A point of the unit torus.
pub type Place = [f64; 2];

/// The largest distance that n points of the unit torus can keep: that of a hexagonal lattice,
/// sqrt(2 / (sqrt(3) n)).
pub fn hexagonal(n: usize) -> f64 {
    (2.0 / (3.0_f64.sqrt() * n as f64)).sqrt()
}

/// The squared distance of two points of the unit torus.
#[inline]
pub fn squared_distance(a: Place, b: Place) -> f64 {
    let wrapped = |difference: f64| {
        let difference = difference.abs();
        difference.min(1.0 - difference)
    };
    let (dx, dy) = (wrapped(a[0] - b[0]), wrapped(a[1] - b[1]));
    dx * dx + dy * dy
}

/// Points of the torus in a grid of square buckets, to find neighbours.
pub struct Buckets {
    side: usize,
    heads: Vec<u32>,
    next: Vec<u32>,
    places: Vec<Place>,
}

/// No point: the end of a bucket's list.
const NONE: u32 = u32::MAX;

impl Buckets {
    /// Empty buckets, `side` x `side` of them, at least one.
    pub fn new(side: usize) -> Self {
        let side = side.clamp(1, 1 << 14);
        Self { side, heads: vec![NONE; side * side], next: Vec::new(), places: Vec::new() }
    }

    /// The points so far, in the order of their coming.
    pub fn places(&self) -> &[Place] {
        &self.places
    }

    /// Adds a point.
    pub fn add(&mut self, place: Place) {
        let bucket = self.row(place[1]) * self.side + self.row(place[0]);
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
    pub fn any_within(&self, place: Place, radius: f64) -> bool {
        let reach = ((radius * self.side as f64).ceil() as usize).min(self.side / 2);
        self.smallest(place, reach, radius * radius) < radius * radius
    }

    /// The squared distance to the nearest point; infinite if there is none.
    pub fn nearest(&self, place: Place) -> f64 {
        self.nearest_below(place, f64::INFINITY)
    }

    /// The same where it is below `limit`, otherwise `limit`.
    pub fn nearest_below(&self, place: Place, limit: f64) -> f64 {
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
    fn smallest(&self, place: Place, reach: usize, enough: f64) -> f64 {
        let mut best = f64::INFINITY;
        for ring in 0..=reach {
            best = self.ring(place, ring, best);
            if best < enough {
                break;
            }
        }
        best
    }

    /// The smaller of `best` and the squared distances to points in the square ring of buckets
    /// `ring` away.
    fn ring(&self, place: Place, ring: usize, best: f64) -> f64 {
        let (column, row) = (self.row(place[0]), self.row(place[1]));
        let span = 2 * ring;
        let mut best = best;
        for down in 0..=span {
            // Only the first and last row of the ring are whole.
            let step = if down == 0 || down == span { 1 } else { span };
            let y = self.wrap(row + down, ring);
            for right in (0..=span).step_by(step.max(1)) {
                let x = self.wrap(column + right, ring);
                let mut at = self.heads[y * self.side + x];
                while at != NONE {
                    best = best.min(squared_distance(place, self.places[at as usize]));
                    at = self.next[at as usize];
                }
            }
        }
        best
    }
}

/// A uniform point.
pub fn uniform(random: &mut Random) -> Place {
    [random.uniform(), random.uniform()]
}

/// Runs of an algorithm, whose count varies, until one gives `n` points.
const RUNS: u64 = 8;

/// Exactly `n` points by `run(radius, random)`, whose count falls as the radius grows: the radius
/// is corrected from run to run. Where no run hits `n`, the one that came nearest from above loses
/// what is too much, at random places of its order, which keeps all distances.
pub fn exactly(n: usize, seed: Seed, share: f64, run: impl Fn(f64, &mut Random) -> Vec<Place>) -> Vec<Place> {
    let mut radius = share * hexagonal(n);
    let mut best: Vec<Place> = Vec::new();
    for k in 0.. {
        let mut random = seed.at(k).generator();
        let mut places = run(radius, &mut random);
        if places.len() == n {
            return places;
        }
        let correction = (places.len() as f64 / n as f64).sqrt();
        if places.len() > n && (best.is_empty() || places.len() < best.len()) {
            random.shuffle(&mut places);
            best = places;
        }
        if k >= RUNS && !best.is_empty() {
            best.truncate(n);
            return best;
        }
        // Once near, part of the correction: the count is noisy.
        let weight = if k < 3 { 1.0 } else { 0.3 };
        radius *= 1.0 + weight * (correction - 1.0);
        if k >= RUNS {
            radius *= 0.99;
        }
    }
    best
}
