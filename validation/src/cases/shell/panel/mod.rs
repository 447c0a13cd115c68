//! panel: a hinged cylindrical panel pushed in at its crown until it snaps through; with every formulation.
//!
//! ```text
//!          ↓ w          quarter model: symmetry at the crown line and at mid-length,
//!       .-'''-.         straight edge hinged, curved edge free; P = 4 × reaction
//!      △       △
//! ```

use benchmarks_ref::fe_shell::cases::{PanelSection, panel as panel_elements};
use benchmarks_ref::{Curve, Extremum, reference};

use crate::methods::{
    CELL, ELEMENTS, NODAL_1, NODAL_2, NODAL_3, RELAXED, STATIC, STRONG_12, STRONG_085, STRONG_DIFFERENCE,
    WIDE_14, WIDE_25, WIDE_30,
};
use crate::support::{peers, relaxed, scenes};
mod figures;

use crate::judge::Measured;
use crate::judge::measure::{cubic_at, largest};
use crate::judge::{Case, Headline, Published, Recorded, Run, Runs, Variant};
use crate::metric_names::DYNAMICS;
use crate::{JudgeError, Metric};

/// The transient run of the paper.
const FAST: &str = "stress-point cell, 3 ms";
/// Limit load \[kN\] that particles find (on 21², 41²: 2.2220, 2.2218) and the finite-element shell (2.2220 on 21²), which shares no
/// mechanics with them. No published value: those lie .07 to .64 % from it.
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
                table of Sze et al., by bricks (CalculiX), and by a limit load of 2.222 kN. That is no published value: it is \
                what this project's own particles find, and within 5e-5 its finite-element shell, which shares no mechanics \
                with them; other codes and tables lie .07 to .64 % from it. The limit is flat, so loads are compared and not the place of the maximum.",
        citation: "Lin et al. 2013, section 5.1; Sze, Liu and Lo 2004, section 3.8",
        variants: variants(),
        each,
        together,
        // 2.222 kN is known to half its last digit.
        headline: Some(Headline { metric: "limit load", floor: 100.0 * 0.0005 / LIMIT, published }),
        peers: || peers::limit_loads(1e3 * LIMIT),
        figures: figures::figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let on = |method: &str, n| Variant::new(method, scenes::PANEL, "cylinder", [n, n]).usual_if(n == 21);
    let short = |method: &str, n| {
        let levels = SHORT.map(|w| w / FULL);
        on(method, n).set("analysis.explicit.quasi-static.levels", format!("{levels:?}"))
    };
    let mut variants = vec![on(CELL, 11).quick(), on(CELL, 21).quick(), short(CELL, 41).full_if(true)];
    let path: Vec<f64> = (1..=60).map(|half| 0.5 * f64::from(half) / FULL).collect();
    for n in [11, 21] {
        variants.push(on(STATIC, n).static_levels(&path).quick());
    }
    variants.push(on(STATIC, 41).static_levels(&path));
    variants.push(on(RELAXED, 21).relaxed(&SHORT.map(|w| w / FULL), 1e-5).quick());
    for n in [11, 21] {
        let elements = move || panel_elements(n - 1, 12.7, PanelSection::Isotropic, FULL, 60);
        variants.push(Variant::elements(ELEMENTS, [n, n], elements).usual_if(n == 21).quick());
    }
    // The whole path in a hundred points on a mesh of 16×16, for its cost.
    let hundred: Vec<f64> = (1..=100).map(|i| 0.01 * f64::from(i)).collect();
    variants.push(on(STATIC, 17).static_levels(&hundred));
    variants.push(Variant::elements(ELEMENTS, [17, 17], || {
        panel_elements(16, 12.7, PanelSection::Isotropic, FULL, 100)
    }));
    variants.push(short(NODAL_3, 11).quick());
    for method in [WIDE_14, WIDE_25, WIDE_30, NODAL_1, NODAL_2, NODAL_3] {
        variants.push(short(method, 21).full_if(true));
    }
    let at = |method, levels: &[f64]| {
        let levels: Vec<f64> = levels.iter().map(|w| w / FULL).collect();
        let path = |key| format!("analysis.explicit.quasi-static.{key}");
        on(method, 21).set(&path("levels"), format!("{levels:?}")).set(&path("tolerance"), 1e-6)
    };
    variants.push(at(STRONG_DIFFERENCE, &[6.0, 10.5, 11.0, 11.5, 18.0, 26.0, 30.0]));
    for method in [STRONG_12, STRONG_085] {
        // It hardly comes to rest, which tells no period: that of the shell.
        let printed = at(method, &[2.0, 6.0, 10.0, 10.5, 11.0])
            .set("analysis.explicit.quasi-static.period", 0.031)
            .set("analysis.explicit.quasi-static.hold", 6.0);
        variants.push(printed.full_if(method == STRONG_085).unsettled());
    }
    variants.push(
        Variant::new(FAST, scenes::PANEL, "cylinder", [21, 21])
            .set("analysis.explicit", "{ transient = { duration = 0.003, record_every = 1e-5 } }")
            .set("supports[3].amplitude", "{ ramp = 0.003 }")
            .quick()
            .unsettled(),
    );
    variants
}

/// Load in kN over the displacement of the crown in mm.
fn path(run: &Run) -> Result<(Vec<f64>, Vec<f64>), JudgeError> {
    Ok((run.column("w_crown")?, run.column("P")?.iter().map(|p| 1e-3 * p).collect()))
}

/// The table of Sze et al.: displacements in mm, loads in kN.
fn sze() -> Result<(Vec<f64>, Vec<f64>), JudgeError> {
    let table = reference("sze_hinged_roof_t12p7_isotropic")?;
    Ok((table.column("minus_W_C")?, table.column("P/Pmax")?.iter().map(|p| 3.0 * p).collect()))
}

/// Displacement at the limit point of the table \[mm\].
fn parabola_of_sze() -> Result<f64, JudgeError> {
    Ok(reference("seed_panel_limit_points")?.number(0, "limit_W")?)
}

/// The first maximum, by the parabola through the highest point and its neighbours; none if the run did not pass it.
fn limit_point(run: &Run) -> Result<Option<Extremum>, JudgeError> {
    let (w, p) = path(run)?;
    Ok(Curve::new(w, p).and_then(|curve| curve.maximum(5.0..15.0)).ok())
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (w, p) = path(run)?;
    if run.is(FAST) {
        let peak = p.iter().copied().fold(0.0, f64::max);
        let at_limit = w.iter().position(|w| *w >= 10.5).map(|row| p[row]);
        let reason = "inertia, not stiffness (2.2 kN at rest): what coque gave when the note of this case was written; 1 % for \
                      the step at which the crown passes 10.5 mm";
        let known =
            |name, value, load: f64| Metric::compared(name, value, "kN", load).within(0.01 * load, reason);
        return Ok(vec![known("peak load", Some(peak), 29.38), known("load at 10.5 mm", at_limit, 20.84)]);
    }
    let limit = limit_point(run)?;
    let found = Metric::compared("limit load", limit.map(|limit| limit.y), "kN", LIMIT);
    let place = Metric::compared("limit at", limit.map(|limit| limit.x), "mm", parabola_of_sze()?);
    if known_failure(run) {
        // Three times more than twice too stiff would hold nothing.
        let reason = "known failure of the published pair sums: they find forces at edges where the stress is constant, and are more than twice too \
                      stiff; held to a tenth";
        let (early, known) = (from_sze(&w, &p, 0.0..=11.0)?, MEASURED.of(run)?);
        return Ok(vec![
            found.shown("known failure, judged by the distance below: to 11 mm it finds no limit"),
            Metric::compared("Sze to 11 mm", early, PERCENT, known).within(0.1 * known, reason),
        ]);
    }
    let (to_26, to_30) = (from_sze(&w, &p, 0.0..=26.0)?, from_sze(&w, &p, 26.0..=FULL)?);
    let mut metrics = vec![
        found.near(MEASURED.of(run)?, why(&run.variant.method)),
        place.shown("flat within 1 % from 9.9 to 11.8 mm; the reference is the parabola through the rows of Sze et al."),
    ];
    let table = "the table itself is up to 1.5 % off independent codes";
    let singular = "the point load of a shear-flexible shell is log-singular: −.4 % for each halving of the spacing there";
    for (name, error, measured, reason) in
        [("Sze to 26 mm", to_26, &TO_26, table), ("Sze 26 to 30 mm", to_30, &TO_30, singular)]
    {
        let measured = measured.of(run)?;
        metrics.push(Metric::error(name, error, PERCENT).near(measured, reason));
    }
    Ok(metrics)
}

fn known_failure(run: &Run) -> bool {
    [STRONG_12, STRONG_085].contains(&run.variant.method.as_str())
}

/// What the error of a formulation in the limit load is made of.
fn why(method: &str) -> &'static str {
    match method {
        CELL | STATIC | RELAXED | ELEMENTS => {
            "the reference is what particles and, by other mechanics, elements converge to, known to .02 %"
        }
        STRONG_DIFFERENCE => {
            "differences over two spacings; the parabola through three levels half a millimetre apart"
        }
        _ => "beside the default, judged so that a change is seen",
    }
}

/// Errors of the limit load \[%\], of the printed strong form the distance from the table to 11 mm, no less than a third of what the reference is known to.
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (CELL, &[("11×11", 0.045), ("21×21", 0.0075), ("41×41", 0.0098)]),
    (STATIC, &[("11×11", 0.044), ("21×21", 0.0075), ("41×41", 0.011), ("17×17", 0.0082)]),
    (RELAXED, &[("21×21", 0.0075)]),
    (ELEMENTS, &[("11×11", 0.016), ("21×21", 0.0075), ("17×17", 0.0075)]),
    (NODAL_3, &[("11×11", 0.091), ("21×21", 0.017)]),
    (WIDE_14, &[("21×21", 0.019)]),
    (WIDE_25, &[("21×21", 0.026)]),
    (WIDE_30, &[("21×21", 0.29)]),
    (NODAL_1, &[("21×21", 0.71)]),
    (NODAL_2, &[("21×21", 0.3)]),
    (STRONG_12, &[("21×21", 127.0)]),
    (STRONG_085, &[("21×21", 162.0)]),
    (STRONG_DIFFERENCE, &[("21×21", 0.06)]),
]);

/// Distances from the table of Sze et al. to 26 mm \[% of the limit load\].
#[rustfmt::skip] // a paragraph a method
const TO_26: Measured = Measured(&[
    (CELL, &[("11×11", 0.35), ("21×21", 0.47), ("41×41", 0.67)]),
    (STATIC, &[("11×11", 0.35), ("21×21", 0.47), ("41×41", 0.66), ("17×17", 0.44)]),
    (RELAXED, &[("21×21", 0.47)]),
    (ELEMENTS, &[("11×11", 0.84), ("21×21", 0.41), ("17×17", 0.48)]),
    (NODAL_3, &[("11×11", 0.67), ("21×21", 0.6)]),
    (WIDE_14, &[("21×21", 0.49)]),
    (WIDE_25, &[("21×21", 0.67)]),
    (WIDE_30, &[("21×21", 2.0)]),
    (NODAL_1, &[("21×21", 3.3)]),
    (NODAL_2, &[("21×21", 0.87)]),
    (STRONG_DIFFERENCE, &[("21×21", 1.2)]),
]);

/// The same from 26 to 30 mm.
#[rustfmt::skip] // a paragraph a method
const TO_30: Measured = Measured(&[
    (CELL, &[("11×11", 0.45), ("21×21", 0.78), ("41×41", 1.2)]),
    (STATIC, &[("11×11", 0.45), ("21×21", 0.79), ("41×41", 1.2), ("17×17", 0.7)]),
    (RELAXED, &[("21×21", 0.79)]),
    (ELEMENTS, &[("11×11", 1.7), ("21×21", 0.26), ("17×17", 0.61)]),
    (NODAL_3, &[("11×11", 0.72), ("21×21", 0.88)]),
    (WIDE_14, &[("21×21", 0.84)]),
    (WIDE_25, &[("21×21", 1.3)]),
    (WIDE_30, &[("21×21", 4.3)]),
    (NODAL_1, &[("21×21", 6.7)]),
    (NODAL_2, &[("21×21", 2.3)]),
    (STRONG_DIFFERENCE, &[("21×21", 1.2)]),
]);

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

fn together(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let mut metrics = still(runs)?;
    metrics.extend(relaxed::cost(runs, "21×21")?);
    if let (Some(particles), Some(at)) = (runs.get(STATIC, "21×21")?, runs.number(ELEMENTS, "21×21")?) {
        let (ours, theirs) = (limit_point(particles)?, limit_point(&runs.chosen[at])?);
        if let Some(ours) = ours {
            let found = Metric::compared(
                "limit load, to that of particles",
                theirs.map(|limit| limit.y),
                "kN",
                ours.y,
            );
            let reason = "the reference of this case is where the two meet, and they share no mechanics";
            metrics.push((at, found.near(0.0023, reason)));
        }
    }
    if let (Some(middle), Some(fine)) = (runs.get(CELL, "21×21")?, runs.number(CELL, "41×41")?) {
        let ((w, p), (sharp_w, sharp_p)) = (path(middle)?, path(&runs.chosen[fine])?);
        let worst = largest(
            apart((&w, &p), (&sharp_w, &sharp_p)).filter(|(w, _)| *w <= 26.0 + 1e-9).map(|x| Some(x.1)),
        );
        metrics.push((
            fine,
            Metric::error("21² to 26 mm", worst, PERCENT)
                .near(0.2, "a lattice of half the spacing; the point load is log-singular"),
        ));
    }
    Ok(metrics)
}

/// How far the loads of the static run are from those read after the holds of the explicit one.
fn still(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let (Some(moving), Some(at)) = (runs.get(CELL, "21×21")?, runs.number(STATIC, "21×21")?) else {
        return Ok(Vec::new());
    };
    let ((w, p), (static_w, static_p)) = (path(moving)?, path(&runs.chosen[at])?);
    let worst = largest(apart((&w, &p), (&static_w, &static_p)).map(|x| Some(x.1)));
    let found = Metric::error(DYNAMICS, worst, PERCENT);
    Ok(vec![(at, found.near(0.0071, "unfinished rest at the levels of the explicit run"))])
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

/// Limit loads of the table of Sze et al. and of other codes, as distances from the load to which particles and elements converge.
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
