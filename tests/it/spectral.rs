//! Errors from spectra, held against exact variances.

use crate::asked::{error, number, outcome, planned, z};
use workbook::chart::{Drawing, Sheet};

/// The modified Bessel function I0, by its series.
fn bessel(x: f64) -> f64 {
    let term = |term: &mut f64, k: u32| {
        *term *= (x / 2.0) * (x / 2.0) / f64::from(k * k);
        Some(*term)
    };
    1.0 + (1..40).scan(1.0, term).sum::<f64>()
}

#[test]
fn spectra_predict_the_variance_of_estimates() {
    let fence = "kind = 'spectral-error'\nsamplers = ['independent', 'jittered', 'sobol', 'latin-hypercube']\nn = 64\nreplicates = 300";
    let outcome = outcome(fence);
    // The integral of exp(cos a + cos b) is I0(1)^2, that of its square I0(2)^2.
    let (integral, squares) = (bessel(1.0) * bessel(1.0), bessel(2.0) * bessel(2.0));
    assert!((number(&outcome, "integral") - integral).abs() < 1e-12);
    let variance = (squares - integral * integral) / 64.0;
    for (name, exact) in [("measured", variance), ("predicted", variance)] {
        let name = format!("{name}.independent");
        assert!(z(&outcome, &name, exact).abs() < 4.0, "{name} ± {}", error(&outcome, &name));
    }
    for method in ["independent", "jittered", "sobol", "latin-hypercube"] {
        assert!(number(&outcome, &format!("z.{method}")).abs() < 4.0, "{method}");
    }
    assert!(number(&outcome, "predicted.jittered") < 0.3 * variance);
    let drawing =
        planned(&format!("{fence}\nshow = 'overlap'")).draw(&outcome, &Sheet::new("fig-a", "A title", "Words"));
    assert!(matches!(drawing, Ok(Drawing::Figure(figure)) if figure.svg.contains("integrand")));
}

#[test]
fn a_lattice_errs_by_its_dual_alone() {
    // The points i/5, 2i/5 see the wave (2, -1), which repeats on them, and miss all others of its length.
    let outcome = outcome(
        "kind = 'spectral-error'\nsamplers = 'korobov(generator=2)'\nn = 5\nreach = 4\n\
         integrand = 'cos(6.283185307179586*(2*x - y)) + cos(6.283185307179586*x)'",
    );
    assert!((number(&outcome, "predicted.korobov(generator=2)") - 0.5).abs() < 1e-12);
    assert!(number(&outcome, "z.korobov(generator=2)").abs() < 4.0);
}
