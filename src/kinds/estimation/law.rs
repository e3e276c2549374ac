//! Laws of one variable that can be sampled by inversion: a few by formula, any other from the expression of its density.

use crate::diag::Code;
use crate::integrands::Function;
use crate::kinds::{Failure, Problems};
use crate::parameters::choices;
use crate::stats::quadrature::integrate;
use crate::stats::{normal, portable};

/// Into how many panels the support of a written density is cut.
const PANELS: usize = 1024;

choices! {
    /// A law that has a name.
    pub enum Named {
        /// Constant from end to end.
        Uniform = "uniform",
        /// Rising to the middle and falling again, along straight lines.
        Triangular = "triangular",
        /// exp(-x) for all x >= 0.
        Exponential = "exponential",
        /// The standard normal law.
        Normal = "normal",
    }
}

impl Named {
    /// Its name.
    pub fn name(self) -> &'static str {
        self.word()
    }

    /// Between which ends it is shown if nothing else is said.
    pub fn ends(self) -> (f64, f64) {
        match self {
            Self::Uniform | Self::Triangular => (0.0, 1.0),
            Self::Exponential => (0.0, 5.0),
            Self::Normal => (-4.0, 4.0),
        }
    }
}

/// A law with its density, its distribution function and the inverse of that.
pub enum Law {
    /// One with a name; of the uniform and the triangular law, the ends.
    Named(Named, (f64, f64)),
    /// One whose density was written.
    Written(Density),
}

impl Law {
    /// The density at `x`.
    pub fn density(&self, x: f64) -> f64 {
        let (named, (from, to)) = match self {
            Self::Written(density) => return density.height(x),
            Self::Named(named, ends) => (named, *ends),
        };
        let (width, inside) = (to - from, (from..=to).contains(&x));
        match named {
            Named::Uniform => f64::from(inside) / width,
            Named::Triangular => f64::from(inside) * (2.0 - 4.0 * ((x - from) / width - 0.5).abs()) / width,
            Named::Exponential => f64::from(x >= 0.0) * portable::exp(-x.max(0.0)),
            Named::Normal => normal::density(x, 0.0, 1.0),
        }
    }

    /// The probability of at most `x`.
    pub fn distribution(&self, x: f64) -> f64 {
        let (named, (from, to)) = match self {
            Self::Written(density) => return density.distribution(x),
            Self::Named(named, ends) => (named, *ends),
        };
        let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
        match named {
            Named::Uniform => t,
            Named::Triangular if t < 0.5 => 2.0 * t * t,
            Named::Triangular => 1.0 - 2.0 * (1.0 - t) * (1.0 - t),
            Named::Exponential => 1.0 - portable::exp(-x.max(0.0)),
            Named::Normal => normal::distribution(x),
        }
    }

    /// The x that is exceeded with probability 1 - `u`, for `u` in [0, 1).
    pub fn inverse(&self, u: f64) -> f64 {
        let (named, (from, to)) = match self {
            Self::Written(density) => return density.inverse(u),
            Self::Named(named, ends) => (named, *ends),
        };
        let along = |t: f64| from + (to - from) * t;
        match named {
            Named::Uniform => along(u),
            Named::Triangular if u < 0.5 => along((0.5 * u).sqrt()),
            Named::Triangular => along(1.0 - (0.5 * (1.0 - u)).sqrt()),
            Named::Exponential => -portable::ln(1.0 - u),
            // The normal law has no smallest value: 0 stands for the middle
            // of the first of 2^53 equal parts.
            Named::Normal => normal::quantile(u.max(0.5 / 9_007_199_254_740_992.0)),
        }
    }
}

/// A law from the expression of its density, known up to its factor.
///
/// The mass is found by quadrature on each of equal panels. Between them the distribution function is the cubic that has the
/// right values and the right densities at both ends, so that its inverse needs no more quadrature.
pub struct Density {
    function: Function,
    from: f64,
    to: f64,
    /// The mass before it is made 1, with a bound on its error.
    pub mass: (f64, f64),
    cumulated: Vec<f64>,
    /// The densities at the borders of panels, in units of a panel.
    slopes: Vec<f64>,
}

impl Density {
    /// The law on [`from`, `to`] whose density is proportional to `function`, which `parameter` holds.
    pub fn new(function: &Function, from: f64, to: f64, parameter: &'static str) -> Result<Self, Failure> {
        let width = (to - from) / PANELS as f64;
        let wrong = |what: &str, help: &str| {
            Failure::of(parameter, format!("`{}` is no density from {from} to {to}: {what}", function.text()))
                .help(help)
        };
        let mut cumulated = vec![0.0];
        let (mut mass, mut error) = (0.0, 0.0);
        for panel in 0..PANELS {
            let start = from + width * panel as f64;
            for part in 0..4 {
                let x = start + width * f64::from(part) / 3.0;
                if function.evaluate(&[x]) < 0.0 {
                    let what = format!("it is negative at x = {x:.4}");
                    return Err(wrong(&what, "write a function that is nowhere negative"));
                }
            }
            let part = integrate(1, |u| function.evaluate(&[start + width * u[0]]));
            let part = part.ok_or_else(|| {
                let what = format!("its mass from {start:.4} to {:.4} cannot be computed", start + width);
                wrong(&what, "write a function that is finite and has no jumps")
            })?;
            mass += part.value * width;
            error += part.error * width;
            cumulated.push(mass);
        }
        if mass.is_nan() || mass <= 0.0 {
            return Err(wrong("it has no mass", "write a function that is somewhere positive"));
        }
        for part in &mut cumulated {
            *part /= mass;
        }
        let slope = |panel: usize| function.evaluate(&[(from + width * panel as f64).min(to)]) / mass * width;
        let slopes = (0..=PANELS).map(slope).collect();
        Ok(Self { function: function.clone(), from, to, mass: (mass, error), cumulated, slopes })
    }

    /// The density at `x`; 0 outside of the ends.
    pub fn height(&self, x: f64) -> f64 {
        if (self.from..=self.to).contains(&x) { self.function.evaluate(&[x]) / self.mass.0 } else { 0.0 }
    }

    /// The probability of at most `x`.
    pub fn distribution(&self, x: f64) -> f64 {
        let along = ((x - self.from) / (self.to - self.from)).clamp(0.0, 1.0) * PANELS as f64;
        let panel = (along as usize).min(PANELS - 1);
        self.cubic(panel).at(along - panel as f64).0
    }

    /// The x that is exceeded with probability 1 - `u`: Newton's method, kept between ends that close in on it.
    pub fn inverse(&self, u: f64) -> f64 {
        let panel = self.cumulated.partition_point(|part| *part <= u).clamp(1, PANELS) - 1;
        let cubic = self.cubic(panel);
        let (mut low, mut high) = (0.0, 1.0);
        let mut at = cubic.chord(u).clamp(0.0, 1.0);
        for _ in 0..60 {
            let (value, slope) = cubic.at(at);
            if value <= u {
                low = at;
            } else {
                high = at;
            }
            let newton = at - (value - u) / slope;
            let next = if newton > low && newton < high { newton } else { f64::midpoint(low, high) };
            let step = (next - at).abs();
            at = next;
            if step < 1e-15 {
                break;
            }
        }
        self.from + (self.to - self.from) * ((panel as f64 + at) / PANELS as f64)
    }

    /// The distribution function on one panel.
    fn cubic(&self, panel: usize) -> Cubic {
        let (start, end) = (self.cumulated[panel], self.cumulated[panel + 1]);
        let (first, last, rise) = (self.slopes[panel], self.slopes[panel + 1], end - start);
        Cubic { start, end, slope: first, square: 3.0 * rise - 2.0 * first - last, cube: first + last - 2.0 * rise }
    }
}

/// A cubic on [0, 1] that rises from `start` to `end`.
struct Cubic {
    start: f64,
    end: f64,
    slope: f64,
    square: f64,
    cube: f64,
}

impl Cubic {
    /// The value and the slope at `t`.
    fn at(&self, t: f64) -> (f64, f64) {
        let value = self.start + t * (self.slope + t * (self.square + t * self.cube));
        (value.clamp(self.start, self.end), self.slope + t * (2.0 * self.square + 3.0 * t * self.cube))
    }

    /// Where the straight line from end to end reaches `value`.
    fn chord(&self, value: f64) -> f64 {
        (value - self.start) / (self.end - self.start)
    }
}

/// Complains of a density, which the parameter `name` holds, that has more than one variable.
pub fn check_density(density: &Function, name: &str, index: Option<usize>, problems: &mut Problems<'_, '_>) {
    if let Some(d) = density.dimensions().filter(|d| *d > 1) {
        let message = format!("`{}` has {d} variables; a density here has one, x", density.text());
        match index {
            Some(index) => problems.element(name, index, Code::Combination, message, None),
            None => problems.at(name, Code::Combination, message, None),
        }
    }
}

/// Complains of ends that are not in order.
pub fn check_ends(from: f64, to: f64, name: &str, problems: &mut Problems<'_, '_>) {
    if from >= to {
        let message = format!("{to} is not after {from}");
        problems.at(name, Code::OutOfRange, message, Some("the first end must be less than the second".to_owned()));
    }
}
