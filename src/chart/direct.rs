//! Names at the ends of lines, moved apart where they would collide.

/// The room a name needs, in units.
pub(super) const LINE: f64 = 19.0;
/// The room that a few words at the end of a line need: figures have no letters that reach below.
pub(super) const TAIL: f64 = 15.0;

/// Places for names that want to be at `wanted`, at least `gap` apart and within `low..=high`, each as near to where it wants
/// to be as the others allow. `None` if there is no room.
pub(super) fn spread(wanted: &[f64], gap: f64, low: f64, high: f64) -> Option<Vec<f64>> {
    let count = wanted.len();
    if count == 0 || gap * (count - 1) as f64 > high - low {
        return (count == 0).then(Vec::new);
    }
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&a, &b| wanted[a].total_cmp(&wanted[b]));
    // Without the gaps the places must only be in order: pool neighbours that are not (isotonic regression).
    let mut pools: Vec<(f64, usize)> = Vec::with_capacity(count);
    for (rank, &index) in order.iter().enumerate() {
        pools.push((wanted[index] - gap * rank as f64, 1));
        while let [.., (a, m), (b, n)] = pools[..]
            && a > b
        {
            pools.truncate(pools.len() - 2);
            pools.push(((a * m as f64 + b * n as f64) / (m + n) as f64, m + n));
        }
    }
    let last = high - gap * (count - 1) as f64;
    let ranked = pools.iter().flat_map(|&(at, n)| std::iter::repeat_n(at.clamp(low, last), n));
    let mut places = vec![0.0; count];
    for ((rank, &index), at) in order.iter().enumerate().zip(ranked) {
        places[index] = at + gap * rank as f64;
    }
    Some(places)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_keep_their_distance() {
        let places = spread(&[50.0, 52.0, 10.0, 51.0], 10.0, 0.0, 100.0).unwrap();
        assert_eq!(places, [41.0, 61.0, 10.0, 51.0]);
    }

    #[test]
    fn names_stay_within() {
        assert_eq!(spread(&[0.0, 0.0], 10.0, 0.0, 100.0).unwrap(), [0.0, 10.0]);
        assert_eq!(spread(&[99.0, 100.0], 10.0, 0.0, 100.0).unwrap(), [90.0, 100.0]);
        assert_eq!(spread(&[1.0, 2.0, 3.0], 60.0, 0.0, 100.0), None);
        assert_eq!(spread(&[], 60.0, 0.0, 100.0), Some(Vec::new()));
    }
}
