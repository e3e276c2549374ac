//! The checks of the battery: functions from points to a verdict, so that `bite.rs` can try them on
//! samplers that are broken on purpose.

use workbook::points::{Points, slab};
use workbook::stats::moments::Moments;
use workbook::stats::portable;

/// All coordinates in [0, 1).
pub fn in_range(points: &Points) -> bool {
    points.coordinates().iter().all(|x| (0.0..1.0).contains(x))
}

/// Every interval of the 1/n grid on every axis holds one point.
pub fn is_latin(points: &Points) -> bool {
    let n = points.len();
    (0..points.dimensions()).all(|axis| {
        let mut hit = vec![false; n];
        points.axis(axis).for_each(|x| hit[slab(x, n)] = true);
        hit.iter().all(|&hit| hit)
    })
}

/// Every cell of the grid with `cuts[j]` slabs on axis j holds one point, and there are n cells.
pub fn is_stratified(points: &Points, cuts: &[usize]) -> bool {
    cuts.iter().product::<usize>() == points.len() && occupancy(points.rows(), cuts).iter().all(|&count| count == 1)
}

/// How many points fall in each box of the grid with `cuts[j]` slabs on axis j.
fn occupancy<'a>(rows: impl Iterator<Item = &'a [f64]>, cuts: &[usize]) -> Vec<u32> {
    let mut counts = vec![0; cuts.iter().product()];
    for row in rows {
        let cell = row.iter().zip(cuts).rev().fold(0, |cell, (&x, &k)| cell * k + slab(x, k));
        counts[cell] += 1;
    }
    counts
}

/// All ways to write `total` as a sum of `parts` whole numbers.
pub fn compositions(total: u32, parts: usize) -> Vec<Vec<u32>> {
    if parts == 1 {
        return vec![vec![total]];
    }
    (0..=total)
        .flat_map(|first| {
            compositions(total - first, parts - 1).into_iter().map(move |mut rest| {
                rest.insert(0, first);
                rest
            })
        })
        .collect()
}

/// Every elementary interval of volume b^(t-m) holds b^t of the b^m points of each aligned block.
pub fn is_net(points: &Points, base: u32, t: u32) -> bool {
    let (n, d) = (points.len(), points.dimensions());
    let blocks = (t..).map(|m| (base as usize).pow(m)).take_while(|&block| block <= n);
    blocks.into_iter().all(|block| {
        points
            .coordinates()
            .chunks_exact(block * d)
            .all(|rows| is_block_net(&Points::from_rows(d, rows.to_vec()).expect("whole rows"), base, t))
    })
}

/// The points together are a net: every elementary interval of volume b^(t-m) holds b^t of the b^m
/// points.
pub fn is_block_net(points: &Points, base: u32, t: u32) -> bool {
    let (n, d, base) = (points.len(), points.dimensions(), base as usize);
    let Some(m) = (0..32).find(|&m| base.pow(m) == n) else { return false };
    compositions(m.saturating_sub(t), d).iter().all(|shape| {
        let cuts: Vec<usize> = shape.iter().map(|&k| base.pow(k)).collect();
        occupancy(points.rows(), &cuts).iter().all(|&count| count as usize == base.pow(t.min(m)))
    })
}

/// Of every b1^k1 ... bd^kd consecutive points, wherever they start, one lies in each box, for all
/// exponents that fit.
pub fn fills_boxes(points: &Points, bases: &[usize]) -> bool {
    let (n, d) = (points.len(), points.dimensions());
    let mut shapes = vec![vec![]];
    for &base in &bases[..d] {
        shapes = shapes
            .into_iter()
            .flat_map(|shape: Vec<usize>| {
                std::iter::successors(Some(1), move |cuts| Some(cuts * base)).take_while(|&cuts| cuts <= n).map(
                    move |cuts| {
                        let mut shape = shape.clone();
                        shape.push(cuts);
                        shape
                    },
                )
            })
            .filter(|shape| shape.iter().product::<usize>() <= n)
            .collect();
    }
    shapes.iter().all(|cuts| {
        let run: usize = cuts.iter().product();
        [0, 1, (n - run) / 2, n - run].iter().filter(|&&start| start + run <= n).all(|start| {
            let rows = points.rows().skip(*start).take(run);
            occupancy(rows, cuts).iter().all(|&count| count == 1)
        })
    })
}

/// Any t axes show every cell of the grid with n^(1/t) slabs once.
pub fn has_strength(points: &Points, t: usize) -> bool {
    let (n, d) = (points.len(), points.dimensions());
    let Some(s) = (1..=n).find(|s| s.pow(t as u32) == n) else { return false };
    let chosen: Vec<Vec<usize>> = subsets(d, t.min(d));
    chosen.iter().all(|axes| {
        let rows: Vec<Vec<f64>> = points.rows().map(|row| axes.iter().map(|&axis| row[axis]).collect()).collect();
        let due = s.pow((t - axes.len()) as u32);
        occupancy(rows.iter().map(Vec::as_slice), &vec![s; axes.len()]).iter().all(|&count| count as usize == due)
    })
}

/// The subsets of `0..d` of size `size`.
fn subsets(d: usize, size: usize) -> Vec<Vec<usize>> {
    let all = (0_u32..1 << d).filter(|mask| mask.count_ones() as usize == size);
    all.map(|mask| (0..d).filter(|&axis| mask >> axis & 1 == 1).collect()).collect()
}

/// The smallest distance on the torus over that of the densest lattice in one to four dimensions:
/// its density is 1, pi / sqrt 12, pi / sqrt 18 and pi^2 / 16.
pub fn relative_radius(points: &Points) -> f64 {
    let wrapped = |difference: f64| difference.abs().min(1.0 - difference.abs());
    let rows: Vec<&[f64]> = points.rows().collect();
    let pairs = rows.iter().enumerate().flat_map(|(i, a)| rows[..i].iter().map(move |b| (a, b)));
    let squares = pairs.map(|(a, b)| a.iter().zip(*b).map(|(x, y)| wrapped(x - y) * wrapped(x - y)).sum::<f64>());
    let pi = std::f64::consts::PI;
    // Of the densest packing, and of the ball of radius 1.
    let (density, ball) = [
        (1.0, 2.0),
        (pi / 12.0_f64.sqrt(), pi),
        (pi / 18.0_f64.sqrt(), 4.0 * pi / 3.0),
        (pi * pi / 16.0, pi * pi / 2.0),
    ][points.dimensions() - 1];
    let radius = portable::pow(density / (ball * points.len() as f64), 1.0 / points.dimensions() as f64);
    squares.fold(f64::INFINITY, f64::min).sqrt() / (2.0 * radius)
}

/// By how many standard errors the moments of pooled points are off, at worst, over 400 seeds.
pub fn worst_moment(points: impl Fn(u64) -> Points) -> f64 {
    let d = points(0).dimensions();
    let mut moments = vec![[Moments::default(); 3]; d];
    for seed in 0..400 {
        let points = points(seed);
        for (axis, moments) in moments.iter_mut().enumerate() {
            let mean = |f: &dyn Fn(&[f64]) -> f64| points.rows().map(f).sum::<f64>() / points.len() as f64;
            moments[0].push(mean(&|x| x[axis] - 0.5));
            moments[1].push(mean(&|x| (x[axis] - 0.5) * (x[axis] - 0.5) - 1.0 / 12.0));
            if d > 1 {
                moments[2].push(mean(&|x| (x[axis] - 0.5) * (x[(axis + 1) % d] - 0.5)));
            }
        }
    }
    let scores = moments
        .iter()
        .flatten()
        .filter(|moments| moments.count() > 0)
        .map(|moments| moments.mean().abs() / moments.standard_error());
    scores.fold(0.0, f64::max)
}
