//! Questions about point sets at the edge of sense: each is answered or refused in words, and threads never show.

use crate::asked::outcome;
use crate::parameters::plan;
use crate::point_kinds::drawn;
use workbook::chart::Drawing;

/// Nothing that an author can write makes a kind panic, and what cannot be is said in words.
#[test]
fn degenerate_questions_are_answered_or_refused_in_words() {
    let good = [
        "kind = \"points\"\nsampler = \"halton\"\nn = 1\norder = true\nlabels = true\ndisks = true\nworst = true\nprojections = true",
        "kind = \"points\"\nsampler = \"sobol\"\nn = 5\ndimensions = 1\nelementary = [2, 0]\nworst = true\norder = true",
        "kind = \"points\"\nsampler = \"sobol\"\nn = 4096\ndisks = true\nradius = 0.5",
        "kind = \"projections\"\nsampler = \"grid\"\nn = 4\npairs = [[1, 2]]",
        "kind = \"spectrum\"\nsampler = \"grid\"\nn = 16\nreach = 8\nshow = \"anisotropy\"",
        "kind = \"spectrum\"\nsampler = \"centred-grid\"\nn = 16\nreach = 8\nshow = \"logarithmic\"",
        "kind = \"spectrum\"\nsampler = \"independent\"\nn = 1\nreplicates = 1\nreach = 4",
        "kind = \"discrepancy\"\nsampler = \"independent\"\nn = 1\nreplicates = 1",
        "kind = \"discrepancy\"\nsampler = \"sobol\"\nn = \"2^1..2^4\"\nmeasure = \"t-value\"",
        "kind = \"discrepancy\"\nsampler = \"grid\"\nn = [4, 16]\nmeasure = \"largest-correlation\"",
        "kind = \"measures\"\nsampler = \"independent\"\nn = 1\ndimensions = 1",
        "kind = \"measures\"\nsampler = \"independent\"\nn = 7\ndimensions = 3\nreplicates = 3\nmeasures = \"l2-star\"",
        "kind = \"koksma-hlawka\"\nsampler = \"centred-grid\"\nintegrand = \"x\"\nn = 1\nform = \"figure\"",
        "kind = \"digits\"\nbase = 36\nfrom = 4294967295\nn = 1\ndecimals = 0",
        "kind = \"bit-reversal\"\nindices = 1",
        "kind = \"occupancy\"\nsampler = \"independent\"\nn = 2",
        "kind = \"guarantees\"\nsampler = \"independent\"\nn = 2\ndimensions = 1\nseeds = 1\nproperties = [\"pairs\", \"separated\", \"cells\"]",
        "kind = \"enumeration\"\ndigits = [1, 1]\nsamples = 1\nrows = 1",
        "kind = \"strata-count\"\nper_axis = [1, 1000000]\ndimensions = 64",
    ];
    for fence in good {
        match drawn(fence).0 {
            Drawing::Table(table) => assert!(!table.rows.is_empty(), "{fence}"),
            Drawing::Figure(figure) => assert!(figure.svg.contains("<svg"), "{fence}"),
            _ => panic!("{fence}"),
        }
    }
    let wrong = [
        "kind = \"points\"\nsampler = \"halton\"\nelementary = [24, 24]",
        "kind = \"points\"\nsampler = \"halton\"\nelementary = 3",
        "kind = \"points\"\nsampler = \"halton\"\nelementary = [1, 2, 3]",
        "kind = \"projections\"\nsampler = \"halton\"\npairs = [[3, 3]]",
        "kind = \"projections\"\nsampler = \"halton\"\npairs = [1, 2]",
        "kind = \"projections\"\nsampler = \"halton\"\npairs = [[1, 9]]\ndimensions = 4",
        "kind = \"spectrum\"\nsampler = \"jittered\"\nn = 10",
        "kind = \"spectrum\"\nsampler = \"independent\"\nreach = 256\nreplicates = 10000",
        "kind = \"discrepancy\"\nsampler = \"halton\"\nmeasure = \"star\"",
        "kind = \"koksma-hlawka\"\nsampler = \"halton\"\nintegrand = \"x + y\"",
        "kind = \"digits\"\nbases = [2, 3, 5, 7, 11]",
        "kind = \"enumeration\"\nsampler = \"sobol\"\nsamples = 3",
        "kind = \"enumeration\"\ndigits = [12, 12]",
        "kind = \"convergence\"\nsampler = \"halton\"\nintegrand = \"xy\"\nn = [3, 5]\npowers = 2",
    ];
    for fence in wrong {
        let complaints = plan(fence).err().unwrap_or_else(|| panic!("{fence} is accepted"));
        assert!(complaints.iter().all(|complaint| complaint.message.len() > 15), "{fence}: {complaints:#?}");
    }
}

#[test]
fn the_number_of_threads_never_shows() {
    let fences = [
        "kind = \"spectrum\"\nsamplers = [\"independent\", \"bridson\"]\nn = 64\nreplicates = 20\nreach = 8",
        "kind = \"discrepancy\"\nsamplers = [\"independent\", \"halton\"]\nn = \"2^2..2^6\"",
        "kind = \"guarantees\"\nsamplers = [\"multi-jittered\", \"sobol+xor\"]\nseeds = 20",
    ];
    for fence in fences {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            pool.install(|| outcome(fence)).bytes
        };
        assert!(on(1) == on(3), "{fence}");
    }
}
