//! The judge: runs scenes, holds their results against references, and says which tolerance is missed.
//!
//! Data flow one way: [`Case`] (what to run, what to compare with) → [`Run`] (what came out) → [`Record`] (metrics with
//! verdicts) → table, JSON, report.
//!
//! | where is | look in |
//! |---|---|
//! | a benchmark: its runs, references, tolerances with their reasons | `cases/shell/*.rs`, `cases/hard/*.rs`, one file each |
//! | what a case and a variant are, how runs share the cores, what is asked of each | `judge/*.rs` |
//! | what a run leaves behind, whoever solved it | `judge/outcome.rs` |
//! | what a verdict is; three times the measured error | `judge/metric.rs`; the errors by run: `judge/measured.rs` |
//! | interpolation, order of convergence, frontier | `judge/measure.rs` |
//! | the methods that are compared, and their names | `methods.rs` |
//! | scenes, meshes, bare shells, comparisons that cases share | `support/*.rs` |
//! | the four answers side by side, the survival table, the printed table | `tables/*.rs` |
//! | charts and shapes that a case may show | `figures/*.rs` |
//! | the HTML report | `report/*.rs` |
//! | what is stored of a run for review, and the page of what changed | `review/*.rs` |
//! | what each option costs | `cases/option_cost/*.rs` |
//! | what an error bar claims, and the true error | `claimed/*.rs` |
//!
//! `main.rs` hands the cases to the judge, which names none of them.
//!
//! ```
//! use validation::Metric;
//! use validation::judge::measure;
//!
//! // A limit load of 2.2219 against the published 2.222, judged to half a per cent.
//! let metric = Metric::compared("limit load", Some(2.2219), "kN", 2.222)
//!     .within(0.011, "half a per cent: the spread of the published values");
//! assert!(metric.pass && metric.error.is_some_and(|error| error < 2e-4));
//!
//! // Errors that fall with the square of the spacing are of order two.
//! let order = measure::order_of_convergence(&[(0.4, 0.16), (0.2, 0.04), (0.1, 0.01)]);
//! assert!(order.is_some_and(|order| (order - 2.0).abs() < 1e-12));
//! ```
//!
//! # Verdicts
//!
//! A [`Metric`] has a value, a unit and, where there is one, a reference:
//!
//! ```text
//! error = |value − reference|              Metric::compared
//!         max(0, reference − value)        Metric::at_least
//!         the value itself                 Metric::error
//! pass  = error ≤ tolerance                Found::within, with a reason
//!         error ≤ 3 × measured             Found::near: the error found when the case was last reviewed
//! shown: nothing is asked                  Found::shown, with a reason: a cost, a place where a curve is flat
//! ```
//!
//! What is [`Found`] becomes a metric by one of these three and by nothing else, so that every number is either judged
//! or says why it is not. Three times the measured error leaves room for another compiler, library or stop criterion, and
//! none for a piece of the mechanics: without curvature along arcs the ring is 25 times as far off. Methods that stand
//! beside the default for comparison are judged alike, so that a change of theirs is seen. References that are rounded
//! or part among themselves widen a tolerance, and the reason says so.
//!
//! A value that was not reached fails where it is judged. Each run also has to come to rest at every load level and to
//! reach its end, unless its method is known not to ([`Variant::unsettled`], for the strong form). The exit code is 1 if
//! any record fails ([`exit_code`]).
//!
//! # What is compared with what
//!
//! The problems have up to four answers ([`tables::side_by_side`]): the particles marched in time, the same particles and energy
//! without time, the finite-element shell of `benchmarks-ref` on the same nodes, and what is published. For the default
//! formulation the error of an explicit run splits into
//!
//! ```text
//! explicit − reference = (static − reference) + (explicit − static)
//!                         discretisation         dynamics: damping, unfinished rest, the stop criterion
//! ```
//!
//! | problems | references |
//! |---|---|
//! | ring, thin ring, end shear | the elastica \[simo1989\], \[mattiasson1981\]; shell elements \[sze2004\] |
//! | hinged panel: limit load, snap-back, laminates | \[sze2004\]; bricks; the seed paper \[lin2013\] and its reference \[klinkel1999\] |
//! | linear obstacle course, twisted beam | \[macneal1985\] and the values confirmed since, in the catalogue |
//! | plates of any thickness: deflection, frequencies, buckling | \[timoshenko1959\], \[timoshenko1961\], tables in the catalogue |
//! | hemisphere, open cylinder, pinched cylinder, large displacements | \[sze2004\] |
//! | ring with the Green–Lagrange split | its own closed form, `benchmarks_ref::rolled_strip` |
//! | patch test, rotated scene, smoothness under a point load | exact, or the run itself |
//!
//! Where a run has several spacings, the order of convergence is the slope of the straight line through the logarithms
//! of spacing and error ([`judge::measure::order_of_convergence`]); values between recorded points are cubic, of order h⁴
//! ([`judge::measure::cubic_at`]). A limit load is the top of the parabola through the largest recorded load and its
//! neighbours (`benchmarks_ref::Curve::maximum`). Cost against error of all methods is drawn as the runs that no other
//! beats in both ([`judge::measure::frontier`]).
//!
//! # The quick set, the usual set, the full set, the hard cases
//!
//! A quick variant ([`Variant::quick`]) is judged by `cargo xtask test`, the full set ([`Variant::full_if`]: what takes more than ten
//! seconds) by `cargo xtask ci`, what lies between by `cargo xtask validate`. The hard
//! cases are ways to break a shell, known from practice: disorder, extreme thickness, spin, sudden loads, steps at the
//! limit, bad clouds. What is known to fail is asserted as it fails, with its cause, under the metric
//! "known failure": a repair shows as a changed verdict. A particle run that is off by more than two percent of a truth and carries
//! no warning of coque fails ([`judge::silent`]).
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | the quick set keeps its tolerances, each with a reason, and stays as it was reviewed | `the_quick_set_keeps_its_tolerances_and_stays_as_it_was_reviewed` (tests/quick) |
//! | every metric is judged or shown, with a reason | by type: a `Found` becomes a metric only so (src/judge/metric.rs); length of reasons: `the_quick_set_keeps_its_tolerances_and_stays_as_it_was_reviewed` |
//! | a measured error may grow three times and no more | `a_measured_error_may_grow_three_times_and_no_more` (src/judge/metric.rs) |
//! | a missed tolerance gives exit code one; what was not reached fails | `a_missed_tolerance_gives_exit_code_one`, `a_level_that_was_never_reached_fails` (src/judge/run.rs), `what_was_not_reached_fails_but_only_if_it_is_judged` (src/judge/record.rs) |
//! | an answer that is far off and says nothing fails | `an_answer_far_off_must_carry_a_warning` (src/judge/asked.rs) |
//! | a known miss may neither grow nor vanish | `a_known_miss_may_neither_grow_nor_vanish` (src/judge/asked.rs) |
//! | what is asked is measured | `what_is_asked_is_measured_and_what_is_known_is_asked` (src/cases/mod.rs) |
//! | the list says in a line what each case is compared with | `the_list_says_in_a_line_what_each_case_proves` (src/cases/mod.rs) |
//! | cases and their runs can be distinguished | `cases_and_their_runs_can_be_distinguished_apart` (src/cases/mod.rs) |
//! | cubic interpolation, orders, frontiers are what they say | `cubics_are_met_between_uneven_points_up_to_the_ends`, `the_order_of_a_power_is_its_exponent`, `the_frontier_holds_what_nothing_beats` (src/judge/measure.rs) |

pub mod cases;
pub mod claimed;
pub mod judge;
pub mod report;
pub mod review;
pub mod tables;

mod error;
mod figures;
mod format;
mod methods;
mod metric_names;
mod support;

pub use error::JudgeError;
pub use judge::{
    Case, CaseResult, Effort, Found, Metric, Outcome, Record, Run, Runs, Selection, Solver, Variant, Verdict,
    exit_code, judge,
};
