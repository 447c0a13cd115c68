//! panel: a hinged cylindrical panel pushed in at its crown until it snaps through; with every formulation.
//!
//! ```text
//!          ↓ w          quarter model: symmetry at the crown line and at mid-length,
//!       .-'''-.         straight edge hinged, curved edge free; P = 4 × reaction
//!      △       △
//! ```

use benchmarks_ref::fe_shell::cases::{PanelSection, panel as panel_elements};
use benchmarks_ref::{Curve, Extremum, reference};

use super::dial::{
    self, CELL, ELEMENTS, NODAL_1, NODAL_2, NODAL_3, STATIC, STRONG_12, STRONG_085, WIDE_14, WIDE_25, WIDE_30,
};
use super::panel_figures::figures;
use crate::answers::DYNAMICS;
use crate::case::{Booked, Case, Headline, Published, Run, Runs, Variant};
use crate::measure::{cubic_at, largest};
use crate::{JudgeError, Metric};

/// The scene of the hinged panel.
pub const SCENE: &str = include_str!("../../../scenes/panel.toml");
/// The transient run of the paper.
pub const FAST: &str = "stress-point cell, 3 ms";
/// Limit load \[kN\] to which two different formulations converged in study 1 §2.2 (stress points and nodal order 3, 41²).
pub const LIMIT: f64 = 2.222;
/// Displacements \[mm\] at which all formulations are compared.
const SHORT: [f64; 12] = [2.0, 6.0, 10.0, 10.5, 11.0, 11.5, 14.0, 18.0, 22.0, 26.0, 29.0, 30.0];
/// Displacement at level one \[mm\].
const FULL: f64 = 30.0;
const PERCENT: &str = "% of limit load";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "panel",
        title: "Hinged cylindrical panel, t = 12.7 mm, snapping through",
        about: "Load against displacement of the crown, through the limit point and the dip behind it, judged by the \
                table of Sze et al., by bricks (CalculiX), and by the limit load to which two formulations converge. \
                The limit is flat, so loads are compared and not the place of the maximum.",
        citation: "Lin et al. 2013, section 5.1; Sze, Liu and Lo 2004, section 3.8",
        variants: variants(),
        each,
        together,
        // 2.222 kN is known to half its last digit.
        headline: Some(Headline { metric: "limit load", floor: 100.0 * 0.0005 / LIMIT, published }),
        figures,
    }
}

fn variants() -> Vec<Variant> {
    let on = |method: &str, n| dial::variant(method, SCENE, "cylinder", [n, n]);
    let short = |method: &str, n| {
        let levels: Vec<String> = SHORT.iter().map(|w| format!("{:?}", w / FULL)).collect();
        on(method, n).set("analysis.explicit.quasi-static.levels", format!("[{}]", levels.join(", ")))
    };
    let mut variants = vec![on(CELL, 11).quick(), on(CELL, 21).quick(), short(CELL, 41)];
    let path: Vec<f64> = (1..=60).map(|half| 0.5 * f64::from(half) / FULL).collect();
    for n in [11, 21] {
        variants.push(dial::static_variant(SCENE, "cylinder", [n, n], &path).quick());
    }
    variants.push(dial::static_variant(SCENE, "cylinder", [41, 41], &path));
    for n in [11, 21] {
        let elements = move || panel_elements(n - 1, 12.7, PanelSection::Isotropic, FULL, 60);
        variants.push(Variant::elements(ELEMENTS, [n, n], elements).quick());
    }
    // Issue 3: the whole path in a hundred points on a mesh of 16×16, for its cost.
    let hundred: Vec<f64> = (1..=100).map(|i| 0.01 * f64::from(i)).collect();
    variants.push(dial::static_variant(SCENE, "cylinder", [17, 17], &hundred));
    variants.push(Variant::elements(ELEMENTS, [17, 17], || {
        panel_elements(16, 12.7, PanelSection::Isotropic, FULL, 100)
    }));
    variants.push(short(NODAL_3, 11).quick());
    for method in [WIDE_14, WIDE_25, WIDE_30, NODAL_1, NODAL_2, NODAL_3] {
        variants.push(short(method, 21));
    }
    for method in [STRONG_12, STRONG_085] {
        // It does not come to rest where the path falls; six periods are what the others need at most.
        variants.push(
            short(method, 21)
                .set("analysis.explicit.quasi-static.tolerance", 1e-6)
                .set("analysis.explicit.quasi-static.hold", 6.0)
                .restless(),
        );
    }
    variants.push(
        Variant::new(FAST, SCENE, "cylinder", [21, 21])
            .set("analysis.explicit", "{ transient = { duration = 0.003, record_every = 1e-5 } }")
            .set("supports[3].amplitude", "{ ramp = 0.003 }")
            .quick()
            .restless(),
    );
    variants
}

/// Load in kN over the displacement of the crown in mm.
pub fn path(run: &Run) -> Result<(Vec<f64>, Vec<f64>), JudgeError> {
    Ok((run.column("w_crown")?, run.column("P")?.iter().map(|p| 1e-3 * p).collect()))
}

/// The table of Sze et al.: displacements in mm, loads in kN.
pub fn sze() -> Result<(Vec<f64>, Vec<f64>), JudgeError> {
    let table = reference("sze_hinged_roof_t12p7_isotropic")?;
    Ok((table.column("minus_W_C")?, table.column("P/Pmax")?.iter().map(|p| 3.0 * p).collect()))
}

/// Displacement at the limit point of the table \[mm\].
fn parabola_of_sze() -> Result<f64, JudgeError> {
    Ok(reference("seed_panel_limit_points")?.number(0, "limit_W")?)
}

/// The first maximum, by the parabola through the highest point and its neighbours; none if the run did not pass it.
pub fn limit_point(run: &Run) -> Result<Option<Extremum>, JudgeError> {
    let (w, p) = path(run)?;
    Ok(Curve::new(w, p).and_then(|curve| curve.maximum(5.0..15.0)).ok())
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (w, p) = path(run)?;
    if run.variant.method == FAST {
        let peak = p.iter().copied().fold(0.0, f64::max);
        let at_limit = w.iter().position(|w| *w >= 10.5).map(|row| p[row]);
        return Ok(vec![
            Metric::error("peak load", Some(peak), "kN")
                .because("inertia, not stiffness: see the note of this case"),
            Metric::error("load at 10.5 mm", at_limit, "kN").because("2.2 kN at rest"),
        ]);
    }
    let limit = limit_point(run)?;
    let mut metrics = vec![
        judged_limit(run, Metric::compared("limit load", limit.map(|limit| limit.y), "kN", LIMIT)),
        Metric::compared("limit at", limit.map(|limit| limit.x), "mm", parabola_of_sze()?)
            .because("flat within 1 % from 9.9 to 11.8 mm; the reference is the parabola through the rows of Sze et al."),
    ];
    let fine = matches!(
        (run.variant.method.as_str(), run.variant.grid.as_str()),
        (CELL | STATIC | ELEMENTS, "21×21" | "41×41")
    );
    let (to_26, to_30) = (from_sze(&w, &p, 0.0..=26.0)?, from_sze(&w, &p, 26.0..=FULL)?);
    metrics.push(Metric::error("Sze to 26 mm", to_26, PERCENT).within_if(
        fine,
        1.5,
        "issue 2; the table is within 1.5 % of independent codes",
    ));
    metrics.push(Metric::error("Sze 26 to 30 mm", to_30, PERCENT).within_if(
        fine,
        2.5,
        "issue 2: the point load of a shear-flexible shell is log-singular, −0.4 % for each halving of the spacing there",
    ));
    Ok(metrics)
}

fn judged_limit(run: &Run, metric: Metric) -> Metric {
    let percent = |percent: f64| 0.01 * percent * LIMIT;
    match (run.variant.method.as_str(), run.variant.grid.as_str()) {
        (CELL | STATIC, "21×21") => metric.within(percent(0.5), "issue 2: within 0.5 % of 2.222 kN at 21²"),
        (ELEMENTS, "21×21") => {
            metric.within(percent(1.0), "issue 3: finite elements within 1 % of the limit load")
        }
        (WIDE_14, "21×21") => metric
            .within(percent(0.5), "the kernel reaches the four particles of the cell, so its mark holds"),
        (NODAL_3, "21×21") => metric.within(percent(0.5), "issue 2; study 1 §2.2: 2.2212"),
        (NODAL_1 | NODAL_2, "21×21") => {
            metric.within(percent(3.0), "issue 2; study 1 §2.2: −2.5 % for order 1, +0.2 % for order 2")
        }
        (STRONG_12 | STRONG_085, _) => metric
            .because("known failure: study 1 §0 found the published pair sums wrong by 1.8 to 2.3 times"),
        (WIDE_25 | WIDE_30, _) => metric.because("no mark for wide kernels on the panel in the studies"),
        _ => metric.because("judged at 21²"),
    }
}

/// Largest distance from the table of Sze et al. in percent of the limit load; none if the path ends before the range.
///
/// A fine path is taken at the displacements of the table; where a path has few points, the table is taken at those.
fn from_sze(w: &[f64], p: &[f64], range: std::ops::RangeInclusive<f64>) -> Result<Option<f64>, JudgeError> {
    let (table_w, table_p) = sze()?;
    // A prescribed displacement adds up from steps: its last digits are not those of the level.
    let slack = 1e-6 * FULL;
    let last = w.last().copied().unwrap_or(0.0) + slack;
    if last < *range.end() {
        return Ok(None);
    }
    let percent = |difference: f64| 100.0 * difference.abs() / LIMIT;
    let fine = w.len() > 2 * SHORT.len();
    let (at, known, w, p) =
        if fine { (&table_w[..], &table_p[..], w, p) } else { (w, p, &table_w[..], &table_p[..]) };
    let inside = |x: &f64| range.start() - slack < *x && *x < range.end() + slack;
    // The table ends at 29.4 mm.
    let covered = |x: &f64| table_w.last().is_some_and(|end| x <= end);
    let differences = at
        .iter()
        .zip(known)
        .filter(|(x, _)| inside(x) && covered(x))
        .map(|(x, known)| cubic_at(w, p, *x).map(|ours| percent(ours - known)));
    Ok(largest(differences))
}

fn together(runs: &Runs) -> Result<Vec<Booked>, JudgeError> {
    let mut metrics = still(runs)?;
    if let (Some(middle), Some(fine)) = (runs.get(CELL, "21×21"), runs.find(CELL, "41×41")) {
        let ((w, p), (sharp_w, sharp_p)) = (path(middle)?, path(&runs.0[fine])?);
        let worst = largest(
            apart((&w, &p), (&sharp_w, &sharp_p)).filter(|(w, _)| *w <= 26.0 + 1e-9).map(|x| Some(x.1)),
        );
        metrics.push((
            fine,
            Metric::error("21² to 26 mm", worst, PERCENT)
                .within(0.5, "issue 2: 41² and 21² within 0.5 % of each other"),
        ));
    }
    Ok(metrics)
}

/// How far the loads of the static run are from those read after the holds of the explicit one.
fn still(runs: &Runs) -> Result<Vec<Booked>, JudgeError> {
    let (Some(moving), Some(at)) = (runs.get(CELL, "21×21"), runs.find(STATIC, "21×21")) else {
        return Ok(Vec::new());
    };
    let ((w, p), (static_w, static_p)) = (path(moving)?, path(&runs.0[at])?);
    let worst = largest(apart((&w, &p), (&static_w, &static_p)).map(|x| Some(x.1)));
    let reason = "issue 3: static equals the explicit ramp–hold loads to 0.2 %";
    Ok(vec![(at, Metric::error(DYNAMICS, worst, PERCENT).within(0.2, reason))])
}

/// Displacements that two paths share, with the difference of their loads there in percent of the limit load.
fn apart<'a>(
    (w, p): (&'a [f64], &'a [f64]),
    (other_w, other_p): (&'a [f64], &'a [f64]),
) -> impl Iterator<Item = (f64, f64)> + 'a {
    w.iter().zip(p).filter_map(move |(w, p)| {
        let row = other_w.iter().position(|other| (other - w).abs() < 1e-6 * FULL)?;
        Some((*w, 100.0 * (p - other_p[row]).abs() / LIMIT))
    })
}

/// Limit loads of the table of Sze et al. and of bricks, as errors of the load to which two formulations converge.
fn published() -> Result<Vec<Published>, JudgeError> {
    let limits = reference("seed_panel_limit_points")?;
    let known =
        [(0, "Sze et al. 2004, S4R"), (2, "CalculiX, 16×16 bricks"), (4, "OpenSees, ASDShellQ4 16×16")];
    known
        .into_iter()
        .map(|(row, source)| {
            let load = 1e-3 * limits.number(row, "limit_P")?;
            Ok(Published { source, error: Some(100.0 * (load / LIMIT - 1.0).abs()) })
        })
        .collect()
}
