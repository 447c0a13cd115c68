//! ring: a strip rolled into a circle by an end couple, judged by the closed form; with every formulation.
//!
//! ```text
//!   ▓────────────────╴ M        the tip stays on circles of curvature M/EI;
//!   u0 clamped       u1         at M = 2πEI/L it meets the clamp
//! ```

use benchmarks_ref::elastica::end_moment;
use benchmarks_ref::fe_shell::cases::{Strip, end_moment as end_moment_elements};
use benchmarks_ref::reference;

use crate::figures::{Axis, Chart, Figure, GREY, Line, Series};
use crate::judge::Measured;
use crate::judge::measure::{largest, order_of_convergence};
use crate::judge::{Case, Headline, Published, Recorded, Run, Runs, Variant};
use crate::methods::{
    CELL, ELEMENTS, METHODS, NODAL_1, NODAL_2, NODAL_3, RELAXED, STATIC, STRONG_12, STRONG_085,
    STRONG_DIFFERENCE, WIDE_14, WIDE_25, WIDE_30,
};
use crate::support::{peers, relaxed, scenes, strip};
use crate::{JudgeError, Metric};

/// Length of the strip \[cm\].
const LENGTH: f64 = 10.0;
const QUARTERS: [(f64, &str); 4] =
    [(0.25, "tip at ¼"), (0.5, "tip at ½"), (0.75, "tip at ¾"), (1.0, "tip at 1")];
/// Name of the metric by which the answers are compared.
const LARGEST: &str = "tip, largest";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "ring",
        title: "Strip rolled into a ring, t/L = 1/10",
        about: "The tip against the closed form: distance √(Δu² + Δw²) in percent of the length at four moments. \
                With ν = 0 and a curvature that is corrected for the stretch, the exact circle is an exact solution \
                of the shell: what is left is the error of the particles.",
        citation: "Lin et al. 2013, section 5.2; exact: end moment on an inextensible elastica",
        variants: variants(),
        each,
        together,
        headline: Some(Headline {
            metric: LARGEST,
            // The closed form neglects nothing that the shell has: errors are compared down to round-off of the rest.
            floor: 1e-3,
            published,
        }),
        peers: || peers::tips("ring", "50×5", exact),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    const USUAL: [usize; 2] = [50, 5];
    let on =
        |method: &str, counts| Variant::new(method, scenes::RING, "plate", counts).usual_if(counts == USUAL);
    let mut variants = vec![on(CELL, [25, 3]).quick(), on(CELL, [50, 5]).quick(), on(CELL, [99, 9])];
    let eighths: Vec<f64> = (1..=8).map(|i| f64::from(i) / 8.0).collect();
    for counts in [[25, 3], [50, 5], [99, 9]] {
        variants.push(on(STATIC, counts).static_levels(&eighths).quick());
    }
    variants.push(on(RELAXED, [50, 5]).relaxed(&eighths, 1e-6).quick());
    for [u, v] in [[25, 3], [50, 5], [99, 9]] {
        let elements = move || end_moment_elements(&Strip::RING, [u - 1, v - 1], 20);
        variants.push(Variant::elements(ELEMENTS, [u, v], elements).usual_if([u, v] == USUAL).quick());
    }
    for method in [WIDE_14, WIDE_25, WIDE_30, NODAL_1, NODAL_2, NODAL_3] {
        variants.extend([on(method, [25, 3]).quick(), on(method, [50, 5]).full_if(true)]);
    }
    let marched = |method, levels: &str| {
        let path = |key| format!("analysis.explicit.quasi-static.{key}");
        on(method, [50, 5]).set(&path("tolerance"), 1e-8).set(&path("levels"), levels)
    };
    variants.push(marched(STRONG_DIFFERENCE, "[0.25, 0.5, 0.75, 1.0]"));
    for method in [STRONG_12, STRONG_085] {
        // With the curvature of the paper it is lost at two thirds of the moment.
        variants.push(marched(method, "[0.25, 0.5]").full_if(method == STRONG_085).unsettled());
    }
    variants
}

fn exact(level: f64) -> (f64, f64) {
    let tip = end_moment(std::f64::consts::TAU * level);
    (tip.u, tip.w)
}

fn errors(run: &Run) -> Result<Vec<Option<f64>>, JudgeError> {
    QUARTERS.iter().map(|&(level, _)| strip::tip_error(run, level, LENGTH, exact(level))).collect()
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let method = run.variant.method.as_str();
    if matches!(method, STRONG_12 | STRONG_085) {
        return known_failure(run);
    }
    let (measured, reason) = (MEASURED.of(run)?, why(method));
    let errors = errors(run)?;
    let each = QUARTERS.iter().zip(&errors).map(|(&(_, name), error)| (name, *error));
    let all = each.chain([(LARGEST, largest(errors.iter().copied()))]);
    Ok(all.map(|(name, error)| Metric::error(name, error, strip::UNIT).near(measured, reason)).collect())
}

/// The printed sum, asserted as it is: an error that vanished would have to be explained, too.
fn known_failure(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let reason = "known failure of the published pair sums: they find forces at edges where the moment is constant, so that the strip turns \
                  by .56 to .62 of what it should at any moment; held to a tenth";
    let (errors, known) = (errors(run)?, MEASURED.of(run)?);
    let at_half = Metric::compared("tip at ½, to what it was", errors[1], strip::UNIT, known);
    let shown = QUARTERS[..2].iter().zip(&errors).map(|(&(_, name), error)| {
        Metric::error(name, *error, strip::UNIT).shown("known failure, judged by what it was at ½")
    });
    // At ½, the last of the four that it is asked for.
    let largest = Metric::error(LARGEST, errors[1], strip::UNIT).within(1.1 * known, reason);
    Ok(shown.chain([at_half.within(0.1 * known, reason), largest]).collect())
}

/// What the error of a formulation is made of.
fn why(method: &str) -> &'static str {
    match method {
        CELL | STATIC | RELAXED | WIDE_14 => {
            "curvature along arcs, second order in the spacing; by chords 50×5 is off by .28 % (docs/zero-energy-control.md)"
        }
        STRONG_DIFFERENCE => {
            "differences over two spacings see a circle as its chords: 1 − sin(kΔ)/kΔ = .27 % of the turn, second order in the spacing"
        }
        ELEMENTS => "directors that are interpolated along chords; second order in the spacing",
        _ => {
            "what wide stencils and nodal sampling lose at the ends; beside the default, judged so that a change is seen"
        }
    }
}

/// Errors of the tip, the largest of the four moments \[% of L\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (CELL, &[("25×3", 0.049), ("50×5", 0.012), ("99×9", 0.0034)]),
    (STATIC, &[("25×3", 0.049), ("50×5", 0.012), ("99×9", 0.0029)]),
    (RELAXED, &[("50×5", 0.012)]),
    (ELEMENTS, &[("25×3", 0.045), ("50×5", 0.012), ("99×9", 0.0029)]),
    (WIDE_14, &[("25×3", 0.61), ("50×5", 0.24)]),
    (WIDE_25, &[("25×3", 2.3), ("50×5", 0.69)]),
    (WIDE_30, &[("25×3", 5.6), ("50×5", 1.4)]),
    (NODAL_1, &[("25×3", 8.3), ("50×5", 2.0)]),
    (NODAL_2, &[("25×3", 3.1), ("50×5", 0.59)]),
    (NODAL_3, &[("25×3", 1.4), ("50×5", 0.075)]),
    (STRONG_12, &[("50×5", 48.0)]),
    (STRONG_085, &[("50×5", 56.4)]),
    (STRONG_DIFFERENCE, &[("50×5", 0.27)]),
]);

fn together(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let [coarse, middle, fine] = ["25×3", "50×5", "99×9"].map(|grid| runs.number(CELL, grid));
    let mut metrics = strip::still(runs, "50×5", &QUARTERS.map(|quarter| quarter.0), LENGTH, 0.0011)?;
    metrics.extend(relaxed::cost(runs, "50×5")?);
    let (Some(coarse), Some(middle), Some(fine)) = (coarse?, middle?, fine?) else { return Ok(metrics) };
    let mut points = Vec::new();
    for at in [coarse, middle, fine] {
        let run = &runs.chosen[at];
        if let Some(error) = largest(errors(run)?) {
            points.push((run.outcome.spacing, error));
        }
    }
    let reason =
        "one-point cells are of second order; .2 for the coarsest grid, which has three rows of particles";
    let order = |name, points: &[(f64, f64)]| {
        Metric::at_least(name, order_of_convergence(points), "-", 2.0).within(0.2, reason)
    };
    let enough = points.len() == 3;
    metrics.extend([
        (fine, order("order, three grids", if enough { &points } else { &[] })),
        (middle, order("order from 25×3", if enough { &points[..2] } else { &[] })),
        (fine, order("order from 50×5", if enough { &points[1..] } else { &[] })),
    ]);
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut figures = Vec::new();
    let shown: Vec<_> =
        strip::on_grid(runs, "50×5").into_iter().filter(|(run, ..)| !run.is(WIDE_25)).collect();
    if !shown.is_empty() {
        let mut caption = vec!["Lines: the circle. All energy-based formulations lie on them."];
        let there =
            |methods: &[&str]| shown.iter().any(|(run, ..)| methods.iter().any(|method| run.is(method)));
        if there(&[STRONG_12, STRONG_085]) {
            caption.push(
                "The strong form as printed turns by .56 to .62 of what it should, whatever the moment.",
            );
        }
        if there(&[STRONG_DIFFERENCE]) {
            caption.push("Its difference form, edges prescribed, closes the ring.");
        }
        figures.push(Figure::Chart(strip::tip_chart(
            "Tip of the strip against the moment, 50×5",
            &caption.join(" "),
            &shown,
            LENGTH,
            |level| Some(exact(level)),
        )?));
    }
    if let Some(run) = runs.get(CELL, "50×5")? {
        figures.push(Figure::Shapes(strip::rolled_shapes(
            "The strip at eighths of the moment (paper, figure 4)",
            "Each wireframe is a settled level, 50×5 particles, true to scale; the darker, the more moment. At the last \
             one the tip meets the clamp.",
            run,
        )));
    }
    figures.extend(convergence(runs)?);
    Ok(figures)
}

/// Largest error of the four moments over the spacing.
fn convergence(runs: &Runs) -> Result<Option<Figure>, JudgeError> {
    let mut series = Vec::new();
    for setting in &METHODS {
        let mut points = Vec::new();
        for run in runs.iter().filter(|run| run.is(setting.method)) {
            if let Some(error) = largest(errors(run)?) {
                points.push((run.outcome.spacing, error));
            }
        }
        if points.len() > 1 {
            series.push(Series::both(setting.method, points, setting.colour, setting.mark));
        }
    }
    let Some(&(spacing, error)) = series.first().and_then(|s| s.points.first()) else { return Ok(None) };
    let second = |h: f64| (h, 0.6 * error * (h / spacing).powi(2));
    series.push(Series::line("slope 2", vec![second(spacing), second(0.25 * spacing)], GREY, Line::Dashed));
    Ok(Some(Figure::Chart(Chart {
        title: "Error against the spacing".into(),
        caption: "Largest of the four moments, both scales logarithmic. Second order is the slope of the dashed line.".into(),
        x: Axis::log("mean spacing of the particles [cm]"),
        y: Axis::log("distance of the tip from the circle [% of L]"),
        series,
    })))
}

/// An independent code on the same problem, as noted beside the reference; the paper prints a figure without numbers.
fn published() -> Result<Vec<Published>, JudgeError> {
    let table = reference("seed_ring_bending")?;
    let error = table.cross_check[0]["max_tip_deviation_from_closed_form_over_L"].as_f64();
    Ok(vec![Published { source: "OpenSees 3.7.1, ASDShellQ4 50×5", error: error.map(|e| 100.0 * e) }])
}
