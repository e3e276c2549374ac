//! A point set: n points of d coordinates in the unit cube.

/// `n x d` coordinates, row-major: point `i` is `coordinates[i * d..(i + 1) * d]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Points {
    d: usize,
    coordinates: Vec<f64>,
}

impl Points {
    /// Wraps row-major coordinates of dimension `d`; `None` unless `d > 0` and the rows are whole.
    pub fn from_rows(d: usize, coordinates: Vec<f64>) -> Option<Self> {
        (d > 0 && coordinates.len().is_multiple_of(d)).then_some(Self { d, coordinates })
    }

    /// The number of points, n.
    pub fn len(&self) -> usize {
        self.coordinates.len() / self.d
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.coordinates.is_empty()
    }

    /// The number of dimensions, d.
    pub fn dimensions(&self) -> usize {
        self.d
    }

    /// The points in order, each a slice of d coordinates.
    pub fn rows(&self) -> std::slice::ChunksExact<'_, f64> {
        self.coordinates.chunks_exact(self.d)
    }

    /// The coordinates on axis `j < d`, in the order of the points.
    pub fn axis(&self, j: usize) -> impl Iterator<Item = f64> + '_ {
        self.coordinates.iter().copied().skip(j).step_by(self.d)
    }

    /// All coordinates, row-major.
    pub fn coordinates(&self) -> &[f64] {
        &self.coordinates
    }
}

/// The slab `0..n` of equal width 1/n that holds `x` in [0, 1), by comparison with the borders k/n
/// as they are in `f64`.
///
/// The product `x * n` alone may round up onto the next border.
#[inline]
pub fn slab(x: f64, n: usize) -> usize {
    let guess = ((x * n as f64) as usize).min(n.saturating_sub(1));
    if x < guess as f64 / n as f64 {
        guess.saturating_sub(1)
    } else if guess + 1 < n && x >= (guess + 1) as f64 / n as f64 {
        guess + 1
    } else {
        guess
    }
}

/// The largest `f32` not above `x` in [0, 1): single precision that never rounds up to 1.
///
/// Rounding to nearest would turn 1 - 2^-26 into 1.
#[inline]
pub fn single(x: f64) -> f32 {
    let nearest = x as f32;
    if f64::from(nearest) > x { nearest.next_down() } else { nearest }
}
