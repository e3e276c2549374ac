//! What the page of a sampler claims: what the sampler declares and what theory says of such, each able to fail.

use super::sampler::{SETS, Subject};
use crate::samplers::{Feature, Guarantee, Net};

/// A value's name, and its bound as TOML.
type Claim = (String, String);

/// How values are called that there are one of for each count.
fn each(subject: &Subject) -> String {
    if subject.counts.len() > 1 { format!("{}.*", subject.key) } else { subject.key.to_owned() }
}

fn holds(value: String) -> Claim {
    (value, "holds = true".to_owned())
}

/// The net that sets of `n` points are, if they are one.
fn net(subject: &Subject, n: usize) -> Option<Net> {
    let whole = |base: u32| crate::samplers::digits::logarithm(n as u64, base).is_some();
    let net = subject.method.net(subject.d).or_else(|| subject.method.whole_net(n, subject.d))?;
    whole(net.base).then_some(net)
}

/// Whether sets of every count of the page are nets of the best quality in base 2.
fn binary_nets(subject: &Subject) -> bool {
    let best = Some(Net { base: 2, t: 0 });
    subject.counts.iter().all(|&n| net(subject, n) == best)
}

/// What is declared was never seen to fail; what is declared of the sampler itself is named.
pub(super) fn guarantees(subject: &Subject, n: usize) -> Vec<Claim> {
    let named = |guarantee: &Guarantee| match guarantee {
        Guarantee::Latin => Some("latin"),
        Guarantee::Strata if subject.d == 1 || n.isqrt().pow(2) == n => (subject.d > 1).then_some("cells"),
        Guarantee::Prefix => Some("prefix"),
        Guarantee::Net | Guarantee::Whole => net(subject, n).filter(|net| net.t == 0).map(|_| "net"),
        Guarantee::Deterministic => Some("fixed"),
        _ => None,
    };
    let own = subject
        .method
        .guarantees()
        .iter()
        .filter_map(named)
        .map(|word| holds(format!("{word}.{}", subject.key)))
        .collect::<Vec<_>>();
    own.into_iter().chain([holds("consistent".to_owned())]).collect()
}

/// The strata are kept that it promises.
pub(super) fn points(subject: &Subject) -> Vec<Claim> {
    let squares = subject.d == 1 || subject.counts.iter().all(|n| n.isqrt().pow(2) == *n);
    let (nets, each) = (binary_nets(subject), each(subject));
    let cells = squares && (nets || subject.has(Guarantee::Strata));
    let slabs = nets || subject.has(Guarantee::Latin);
    let cells = cells.then(|| holds(format!("one-per-cell.{each}")));
    cells.into_iter().chain(slabs.then(|| holds(format!("one-per-slab.{each}")))).collect()
}

/// Strata and distances leave little power at low frequencies; independent points have the same at all.
pub(super) fn spectrum(subject: &Subject) -> Vec<Claim> {
    let key = subject.key;
    let apart = subject.method.guarantees().iter().any(|guarantee| matches!(guarantee, Guarantee::Separated { .. }));
    if apart || subject.has(Guarantee::Strata) || subject.method.net(2).is_some_and(|net| net.t == 0) {
        return vec![(format!("low.{key}"), "below = 1".to_owned())];
    }
    let flat =
        [Feature::Smooth, Feature::Edge].iter().all(|&feature| subject.method.sampler().rate(feature, 2) == Some(-0.5));
    // Of forty rings the farthest, in standard errors.
    if flat && !subject.has(Guarantee::Latin) && !subject.method.sampler().searches() {
        return vec![(format!("flatness.z.{key}"), "below = 5".to_owned())];
    }
    Vec::new()
}

/// The quality of nets, the bound on the discrepancy of those of the plane, and the distance that is promised.
pub(super) fn measures(subject: &Subject) -> Vec<Claim> {
    let (key, several) = (subject.key, subject.counts.len() > 1);
    let named =
        |quantity: &str, n: usize| if several { format!("{quantity}.{key}.{n}") } else { format!("{quantity}.{key}") };
    let mut claims = Vec::new();
    for &n in &subject.counts {
        let Some(Net { base: 2, t }) = net(subject, n) else { continue };
        claims.push((named("t", n), format!("below = \"{t} + 1/2\"")));
        if t == 0 && subject.d == 2 {
            claims.push((named("dstar", n), format!("below = \"({}/3 + 19/9)/{n}\"", n.trailing_zeros())));
        }
    }
    let percent = subject.method.guarantees().into_iter().find_map(|guarantee| match guarantee {
        Guarantee::Separated { percent } => Some(percent),
        _ => None,
    });
    claims.extend(percent.map(|percent| (format!("radius.{}", each(subject)), format!("above = \"{percent}/100\""))));
    claims
}

/// The rates of theory; and that a random sampler's mean is right, which a smooth integrand shows.
pub(super) fn convergence(subject: &Subject, counts: &[usize]) -> Vec<Claim> {
    let key = subject.key;
    let features = [Feature::Smooth, Feature::Additive, Feature::Kink, Feature::Edge];
    let shown = subject.integrands();
    let integrands = [shown[0], shown[1], shown[2], if subject.d == 1 { "step" } else { "disk" }];
    let mut claims = Vec::new();
    for (feature, integrand) in features.into_iter().zip(integrands) {
        let Some(rate) = subject.method.sampler().rate(feature, subject.d) else { continue };
        // Four standard errors of the fitted slope, with some room for what is not yet asymptotic.
        let within = 4.0 * slope_error(counts, if subject.is_slow() { SETS / 4 } else { SETS / 2 }) + 0.06;
        let bound = if subject.method.is_random() {
            format!("near = {rate:?}, within = {within:.2}")
        } else {
            // One run has the luck of its counts.
            format!("below = {:?}", rate + 0.25)
        };
        claims.push((format!("slope.{key}.{integrand}"), bound));
    }
    if subject.has(Guarantee::Unbiased) {
        claims.push((format!("mean.{key}.*.{}", shown[0]), format!("agrees = \"exact.{}\", within = 5", shown[0])));
    }
    claims
}

/// The standard error of a slope that is fitted to errors at `counts`, each measured over so many runs.
fn slope_error(counts: &[usize], runs: usize) -> f64 {
    let x: Vec<f64> = counts.iter().map(|&n| crate::stats::portable::log2(n as f64)).collect();
    let mean = x.iter().sum::<f64>() / x.len().max(1) as f64;
    let spread: f64 = x.iter().map(|x| (x - mean) * (x - mean)).sum();
    let one = std::f64::consts::LOG2_E / (2.0 * runs as f64).sqrt();
    one / spread.sqrt()
}
