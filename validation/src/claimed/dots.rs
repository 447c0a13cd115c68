//! A dot: the error that a bar claims, and the true one.

use coque::Verdict;
use coque::accuracy::{OnLattice, bar};
use serde::Serialize;

use super::OnLattices;
use crate::Metric;
use crate::judge::Case;
use crate::methods::METHODS;

/// Relative difference of two references that are one.
const SAME: f64 = 1e-9;
/// Digits up to which a reference is one that was printed, and known to half of its last.
const PRINTED: usize = 6;

/// All of it, in percent.
const WHOLE: f64 = 100.0;
/// Judged errors in percent that are none of an answer: of balances, of noise, from one run to the next.
const NO_ANSWERS: [&str; 13] = [
    "balance",
    "spread",
    "drift",
    "change",
    "rms",
    "density",
    "taken",
    "damage",
    "energy",
    "deviation",
    "area by",
    "outside",
    "greatest error of pressure",
];

/// Cases, or single metrics of them, whose references are of another theory than what is run, which no lattice approaches, and of which.
const OTHER_THEORIES: [(&str, &str); 55] = [
    ("turek-hron", "a plane solid"),
    ("clamped-strip", "a beam without shear"),
    ("heavy-end", "a beam without shear"),
    ("joined-cantilevers", "a beam without shear"),
    ("initial-stress", "beams and plates without shear"),
    ("heat", "plates without shear, a strip that bends along alone"),
    ("cantilever-on-flat", "a beam without shear"),
    ("two-cantilevers", "beams without shear"),
    ("touched-modes", "beams without shear"),
    ("strip-lifted", "a beam of small slope"),
    ("flap-on-sill", "a beam without shear"),
    ("fold-pressed", "the elastica, which does not stretch"),
    ("collapsed-ring", "the elastica, which does not stretch"),
    ("wrapped-strip", "the elastica, which does not stretch"),
    ("gate-alone", "a slender cantilever"),
    ("cantilever-end-shear", "the elastica, which does not stretch"),
    ("twisted-beam", "a beam"),
    ("external-pressure", "inextensible rings, shallow waves of cylinders"),
    ("shortened", "a plate beyond buckling by one wave"),
    ("panel", "the mesh of another program"),
    ("panel-laminated", "the mesh of another program"),
    ("panel-snap-back", "the mesh of another program"),
    ("clamped-cap", "the mesh of another program"),
    ("hemisphere-on-flat", "the mesh of another program"),
    ("hemisphere-large", "the mesh of another program"),
    ("open-cylinder", "the mesh of another program"),
    ("pinched-cylinder-large", "the mesh of another program"),
    ("thin-ring: Sze table, largest", "the mesh of another program"),
    ("shell-and-solid: limit load of bricks", "the mesh of another program"),
    ("hemisphere-yielding", "the mesh of another program"),
    ("plate-yielding", "the mesh of another program"),
    ("roof-collapsing", "the mesh of another program"),
    ("cylinder-yielding", "the mesh of another program"),
    ("cook-yielding", "the mesh of another program"),
    ("disc-yielding", "a rigid, plastic plate"),
    ("tube-crushed", "rigid arms and hinges"),
    ("strip-springback", "a section without slices"),
    ("plate-stability", "plates without a horizon"),
    ("column-solid", "a column without shear"),
    ("cantilever-solid", "a beam"),
    ("galerkin-nodes", "beams and plates without shear"),
    ("plate-solid", "a plate without shear"),
    ("pressed-ring", "the elastica, which does not stretch"),
    ("hydrostatic-column: the same over the closed form of a thin strip", "a thin strip"),
    ("wall-impact", "an experiment"),
    ("torsion-of-a-rod", "a rod whose clamped section warps freely"),
    ("couette: the same against that of μ u'", "friction whose stress is not symmetric"),
    ("elliptical-drop", "a drop that keeps its area, of which it is 1 % off on any lattice"),
    ("dam-break-front", "an experiment"),
    ("dam-break-obstacle", "an experiment"),
    ("elastic-gate", "an experiment"),
    ("elastic-wedge", "other programs, and impact without gravity"),
    ("baffle-breaks", "another program"),
    ("source-settings", "an experiment"),
    ("dam-break-on-plate", "other programs, which spread by a fifth"),
];

/// What is in the names of metrics that hold a run against its own figures of the last review.
const OWN_FIGURES: [&str; 2] = ["known", "what it was"];

/// Families whose runs are no shells, unless by a method of shells.
const OTHERS: [&str; 6] = [
    "Peridynamic solids",
    "Cracks in peridynamic solids",
    "Peridynamic plates",
    "Galerkin solids",
    "Fluids",
    "Fluids and structures",
];

/// The half of the cases that a dot belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Half {
    /// On which the rule was chosen.
    Chosen,
    /// On which it is judged.
    Judged,
}

/// A number with the error that its bar claims and the one that it has.
#[derive(Clone, Debug, Serialize)]
pub struct Dot {
    /// Case, run and metric.
    pub name: String,
    /// Family of the case.
    pub family: &'static str,
    /// Whether a shell in no fluid is run, of whatever family its case is.
    pub shell: bool,
    /// Half of the case.
    pub half: Half,
    /// The theory of the reference, where it is another than that of the run.
    pub theory: Option<&'static str>,
    /// The number, in the unit of its metric.
    pub value: f64,
    /// The reference.
    pub reference: f64,
    /// What errors are shares of: the size of the reference, of an error in percent a hundred.
    pub scale: f64,
    /// Half of the last digit of a printed reference.
    pub rounding: f64,
    /// The bar; none where the numbers grow with refinement or are not found.
    pub bar: Option<f64>,
    /// What the lattices tell.
    pub verdict: Verdict,
    /// Answers on the lattices, the scene's own first, and their spacings.
    pub answers: Vec<[f64; 2]>,
}

impl Dot {
    /// The true error, what the reference is rounded by left out.
    pub fn error(&self) -> f64 {
        ((self.value - self.reference).abs() - self.rounding).max(0.0)
    }

    /// Whether the bar holds the true error; none without a bar.
    pub fn inside(&self) -> Option<bool> {
        Some(self.error() <= self.bar?)
    }
}

/// The dots of a run from the metrics that its case finds on each lattice.
pub(super) fn of(case: &Case, ran: &OnLattices, metrics: &[Vec<Metric>]) -> Vec<Dot> {
    let Some((own, others)) = metrics.split_first() else { return Vec::new() };
    let dot = |metric: &Metric| {
        let reference = reference(metric)?;
        let off = (metric.value? - reference).abs();
        let compared = metric.error.is_some_and(|error| (error - off).abs() <= SAME * error);
        let place = worst(metric);
        let value = at(metric, place)?;
        if OWN_FIGURES.iter().any(|words| metric.name.contains(words)) || !compared {
            return None;
        }
        let mut answers = vec![OnLattice { spacing: 1.0, value }];
        for (found, spacing) in others.iter().zip(&ran.spacings[1..]) {
            let same = found.iter().find(|other| other.name == metric.name)?;
            // What is held against another run of ours is no reference.
            if (same.reference.unwrap_or(0.0) - reference).abs() > SAME * reference.abs() {
                return None;
            }
            answers.extend(at(same, place).map(|value| OnLattice { spacing: *spacing, value }));
        }
        let scale = if metric.reference.is_some() { reference.abs() } else { WHOLE };
        let found = bar(answers[0], &answers[1..], scale, ran.most);
        Some(Dot {
            name: format!("{}: {} {}: {}", case.name, ran.variant.method, ran.variant.grid, metric.name),
            family: case.family,
            shell: !OTHERS.contains(&case.family)
                || METHODS.iter().any(|known| known.method == ran.variant.method),
            half: half(case.name),
            theory: theory(case.name, &metric.name),
            value,
            reference,
            scale,
            rounding: rounding(reference),
            bar: found.bar,
            verdict: found.verdict,
            answers: answers.iter().map(|answer| [answer.spacing, answer.value]).collect(),
        })
    };
    own.iter().filter_map(dot).collect()
}

/// Where along a path the greatest error of a metric was found; none where it is one number.
fn worst(metric: &Metric) -> Option<f64> {
    metric.signed.iter().max_by(|a, b| a[1].abs().total_cmp(&b[1].abs())).map(|[at, _]| *at)
}

/// The number of a metric, of one along a path the error with its sign at a place: that is what a bar of a curve is held against there.
fn at(metric: &Metric, place: Option<f64>) -> Option<f64> {
    let Some(place) = place else { return metric.value };
    let near = |at: f64| (at - place).abs() <= SAME * place.abs();
    metric.signed.iter().find(|[at, _]| near(*at)).map(|[_, error]| *error)
}

/// What a metric is held against; zero for a judged error in percent of a truth. A reference of zero is that of a balance.
fn reference(metric: &Metric) -> Option<f64> {
    let answer = || NO_ANSWERS.iter().all(|word| !metric.name.contains(word));
    match metric.reference {
        Some(reference) => Some(reference).filter(|&reference| reference != 0.0),
        None => (metric.tolerance.is_some() && metric.unit.starts_with('%') && answer()).then_some(0.0),
    }
}

/// The theory of a reference, where it is another than that of the run.
fn theory(case: &str, metric: &str) -> Option<&'static str> {
    let of = |name: &str| match name.split_once(": ") {
        Some(both) => both == (case, metric),
        None => name == case,
    };
    OTHER_THEORIES.iter().find(|(name, _)| of(name)).map(|(_, theory)| *theory)
}

/// The half of a case: by the last bit of the sum of the bytes of its name, each mixed in by a prime (FNV-1a).
pub(super) fn half(name: &str) -> Half {
    let hash = name.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    // The last bit alone is the parity of the bytes.
    if (hash ^ (hash >> 32)) & 1 == 0 { Half::Chosen } else { Half::Judged }
}

/// Half of the last digit of a number that has few; zero of one that was computed.
fn rounding(reference: f64) -> f64 {
    let text = format!("{reference:e}");
    let Some((digits, power)) = text.split_once('e') else { return 0.0 };
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let power: i32 = power.parse().unwrap_or(0);
    // A whole number of one digit, such as a count or a limit of one, is exact.
    if decimals == 0 || decimals >= PRINTED {
        0.0
    } else {
        0.5 * libm::pow(10.0, f64::from(power - decimals as i32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_printed_reference_is_known_to_half_its_last_digit() {
        for (reference, known) in
            [(0.3024, 5e-5), (2.222, 5e-4), (1.0, 0.0), (std::f64::consts::PI, 0.0), (1850.0, 5.0)]
        {
            assert!((rounding(reference) - known).abs() < 1e-12, "{reference}");
        }
    }

    #[test]
    fn a_theory_is_that_of_a_case_or_of_one_of_its_metrics() {
        assert!(theory("turek-hron", "down").is_some());
        assert!(theory("couette", "the same against that of μ u'").is_some());
        assert_eq!(theory("couette", "torque on the outer cylinder"), None);
        // What a run is held against when it was last reviewed is its own number.
        assert!(crate::metric_names::KNOWN.contains(OWN_FIGURES[0]));
    }

    #[test]
    fn the_greatest_error_along_a_path_is_held_where_it_is() {
        let of = |errors: [(f64, Option<f64>); 2]| Metric::greatest("P", errors, "%").shown("made up");
        let (own, other) =
            (of([(0.5, Some(0.2)), (1.0, Some(-0.3))]), of([(0.5, Some(0.9)), (1.0, Some(-0.4))]));
        assert_eq!((at(&own, worst(&own)), at(&other, worst(&own))), (Some(-0.3), Some(-0.4)));
        let lone = Metric::error("P", Some(0.7), "%").shown("made up");
        assert_eq!(at(&lone, worst(&lone)), Some(0.7));
        assert_eq!(at(&other, Some(0.7)), None);
    }

    #[test]
    fn the_halves_are_about_as_large() {
        let names: Vec<String> = (0..200).map(|i| format!("case-{i}")).collect();
        let chosen = names.iter().filter(|name| half(name) == Half::Chosen).count();
        assert!((70..130).contains(&chosen), "{chosen}");
    }
}
