//! large: deep in large rotations: hemisphere, cylinders, a jump of the panel in time, a strip rolled twice, a whip.

use benchmarks_ref::elastica::end_moment;
use benchmarks_ref::{Curve, reference};

use super::common::{ERROR, Miss, asked, or_refused, tuned};
use crate::case::{Case, Headline, Run, Variant};
use crate::cases::dial::{CELL, NODAL_1, NODAL_3, STATIC, WIDE_14};
use crate::cases::{hemisphere, hemisphere_large, open_cylinder, panel, pinched_cylinder_large, ring, strip};
use crate::measure::largest;
use crate::{JudgeError, Metric};

/// A strip hit at its free end by a pulse that turns the tip by more than half a turn; nothing is damped.
const WHIP: &str = include_str!("../../../../scenes/cantilever-end-shear.toml");
/// Limit load of the thin panel \[N\], in parts of which its loads are off.
const LIMIT: f64 = 586.0;
/// Displacements of the crown \[mm\]: up to the turning point at 17.0 mm, and after the jump.
const BEFORE: [f64; 5] = [4.0, 8.0, 12.0, 14.0, 16.0];
const AFTER: [f64; 4] = [17.5, 18.2, 19.0, 19.8];

/// The scenes, their references, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "large",
        title: "Large rotations, a jump, a whip",
        about: "Hemisphere, open and pinched cylinder against the tables of Sze et al.; the panel of 6.35 mm driven in time \
                past the turning point of its displacement, where it has to jump to the branch beyond; a strip rolled twice; \
                a cantilever whipped through large rotations by a pulse at its end, its energy balance counted.",
        citation: "Sze, Liu and Lo 2004; end moment on an inextensible elastica; balance of energy",
        variants: variants().into_iter().map(or_refused).collect(),
        each,
        together: |_| Ok(Vec::new()),
        headline: Some(Headline { metric: ERROR, floor: 0.01, published: || Ok(Vec::new()) }),
        figures: |_| Ok(Vec::new()),
    }
}

fn named(mut variant: Variant, grid: &str) -> Variant {
    variant.grid = grid.into();
    tuned(variant)
}

fn levels(values: impl IntoIterator<Item = f64>) -> String {
    let words: Vec<String> = values.into_iter().map(|value| format!("{value:?}")).collect();
    format!("[{}]", words.join(", "))
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    let hemisphere = |method, n: usize| {
        let variant = Variant::new(method, hemisphere::SCENE, "sphere", [n, n])
            .set("loads[0].force.total", "[200, 0, 0]")
            .set("loads[1].force.total", "[0, -200, 0]")
            .set("analysis.static.levels", 20);
        named(variant, &format!("hemisphere {n}×{n}"))
    };
    variants.extend([hemisphere(STATIC, 21), hemisphere(STATIC, 31)]);
    for [u, v] in [[25, 17], [37, 25]] {
        let cylinder = Variant::new(STATIC, open_cylinder::SCENE, "cylinder", [u, v]);
        variants.push(named(cylinder, &format!("open cylinder {u}×{v}")));
    }
    for n in [21, 31] {
        let cylinder = Variant::new(STATIC, pinched_cylinder_large::SCENE, "cylinder", [n, n]);
        variants.push(named(cylinder, &format!("pinched cylinder {n}×{n}")));
    }
    let path = levels(BEFORE.into_iter().chain(AFTER).map(|w| w / 30.0));
    for (method, n) in [(CELL, 11), (CELL, 21), (WIDE_14, 11), (NODAL_1, 11), (NODAL_3, 11)] {
        let jump = Variant::new(method, panel::SCENE, "cylinder", [n, n])
            .set("section.homogeneous.thickness", 6.35)
            .set("analysis.explicit.quasi-static.levels", &path);
        let jump = named(jump, &format!("panel jumps {n}×{n}"));
        variants.push(match (method, n) {
            (CELL, 11) => jump.quick(),
            // It is still moving when the hold of a level ends.
            (NODAL_1, _) => jump.restless(),
            _ => jump,
        });
    }
    for (method, [u, v]) in
        [(STATIC, [50, 5]), (CELL, [50, 5]), (STATIC, [99, 5]), (WIDE_14, [50, 5]), (NODAL_3, [50, 5])]
    {
        let twice = Variant::new(method, ring::SCENE, "plate", [u, v])
            .set("loads[0].couple.moment", 4.0 * std::f64::consts::PI * 10.0);
        let key = if method == CELL { "explicit.quasi-static" } else { "static" };
        let twice = twice.set(&format!("analysis.{key}.levels"), 16);
        if [STATIC, CELL].contains(&method) && u == 50 {
            let kept = twice.clone().set("supports[1].on", "all");
            variants.push(named(kept, &format!("rolled twice {u}×{v} in its plane")));
        }
        // Lost in time, it has no rest to ask for.
        variants.push(named(twice.restless(), &format!("rolled twice {u}×{v}")));
    }
    for (method, [u, v]) in [(CELL, [41, 5]), (CELL, [81, 9]), (WIDE_14, [41, 5]), (NODAL_3, [41, 5])] {
        let whip = Variant::new(method, WHIP, "plate", [u, v])
            .set("analysis.explicit", "{ transient = { duration = 6.0, record_every = 0.01 } }")
            .set("loads[0].force.total", "[0, 0, 24]")
            .set("loads[0].amplitude", "{ table = [[0.0, 0.0], [0.25, 1.0], [0.5, 0.0]] }")
            .set(
                "curve",
                "[{ name = \"turn\", of = \"rotation\", on = \"u1\", direction = [0.0, -1.0, 0.0] }]",
            )
            .set("output.plot", "{ x = \"time\", y = \"turn\" }")
            .restless();
        let whip = named(whip, &format!("whip {u}×{v}"));
        variants.push(if method == CELL && u == 41 { whip.quick() } else { whip });
    }
    variants
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let grid = run.variant.grid.as_str();
    let (bound, cause) = (bound(grid), cause(run));
    let quarters =
        || (1..=4).map(|quarter| twice(run, 0.25 * f64::from(quarter))).collect::<Result<Vec<_>, _>>();
    let error = match grid {
        _ if !run.done() => None,
        _ if grid.starts_with("whip") => energy(run)?,
        _ if grid.starts_with("hemisphere") => largest(hemisphere_large::errors(run)?),
        _ if grid.starts_with("open") => largest(open_cylinder::errors(run)?),
        _ if grid.starts_with("pinched") => largest(pinched_cylinder_large::errors(run)?),
        _ if grid.starts_with("panel") => jump(run)?,
        _ => largest(quarters()?),
    };
    let mut metrics = asked(run, error, bound, &MISSES, cause);
    if grid.starts_with("whip") && run.done() {
        let turn = run.column("turn")?.into_iter().map(f64::abs).reduce(f64::max);
        let reason = "a whip that turns less than half round is no large rotation and proves nothing";
        metrics.push(Metric::at_least("largest turn", turn, "rad", std::f64::consts::PI).within(0.0, reason));
    }
    Ok(metrics)
}

/// What is asked of a run \[%\], and why.
fn bound(grid: &str) -> (f64, &'static str) {
    match grid {
        "hemisphere 21×21" => (1.0, "asked: within 1 % of the largest displacement at 21²"),
        "hemisphere 31×31" => (0.4, "asked: within .4 % of the largest displacement at 31²"),
        "open cylinder 37×25" => (0.7, "asked: within .7 % of the largest displacement at 37×25"),
        _ if grid.starts_with("whip") => (1.0, "asked: energy is kept; central differences swing about it"),
        _ if grid.starts_with("rolled") => (0.4, "asked: the ring within .4 % of L, here wound twice"),
        _ if grid.starts_with("panel") => (
            2.0,
            "asked: on the right branch after the jump; table and bricks differ by .8 % of the limit load themselves",
        ),
        _ => (2.0, "asked: within 2 % of the largest displacement at 21² to 31²"),
    }
}

/// Why a run misses what is asked.
fn cause(run: &Run) -> &'static str {
    match run.variant.method.as_str() {
        WIDE_14 => {
            "directors that turn by ψ over a cell make chords; cells correct the curvature for it, wide rows do not, and ψ²/6 \
             is 1.1 % at two turns over 49 cells"
        }
        NODAL_1 => {
            "rows that are exact on linear fields alone are too soft in bending, a quarter on this lattice"
        }
        _ if run.variant.grid.starts_with("rolled") => {
            "the wound strip is unstable sideways from .81 of the moment on: negative pivots of the tangent in every \
             formulation and on finer lattices, none where the strip is kept in its plane"
        }
        _ => {
            "the dimple under the force is a few spacings wide; finite elements on the same nodes are 5.5 % off at 21²"
        }
    }
}

/// Distance of the tip from the circles \[% of L\].
fn twice(run: &Run, level: f64) -> Result<Option<f64>, JudgeError> {
    let tip = end_moment(2.0 * std::f64::consts::TAU * level);
    strip::tip_error(run, level, 10.0, (tip.u, tip.w))
}

/// Largest difference of the load from the branch beyond the jump \[% of the limit load\].
fn jump(run: &Run) -> Result<Option<f64>, JudgeError> {
    let table = reference("sze_hinged_roof_t6p35_isotropic")?;
    let (w, p) = (table.column("minus_W_C")?, table.column("P/Pmax")?);
    // Behind the second turning point the displacement grows again.
    let first = w.windows(2).position(|pair| pair[1] < pair[0]).unwrap_or(0);
    let second = first + w[first..].windows(2).position(|pair| pair[1] > pair[0]).unwrap_or(0);
    let branch = Curve::new(w[second..].to_vec(), p[second..].iter().map(|p| 3000.0 * p).collect())?;
    let mut errors = Vec::new();
    for w in AFTER {
        let load = run.at("P", w / 30.0)?;
        errors.push(
            load.map(|load| branch.at(w).map(|known| 100.0 * (load - known).abs() / LIMIT)).transpose()?,
        );
    }
    Ok(largest(errors))
}

/// Energy that is missing or too much, in percent of the work done.
fn energy(run: &Run) -> Result<Option<f64>, JudgeError> {
    let (kinetic, internal, external) =
        (run.column("kinetic")?, run.column("internal")?, run.column("external")?);
    let missing = (0..external.len()).map(|i| Some((kinetic[i] + internal[i] - external[i]).abs()));
    Ok(largest(missing).zip(external.last()).map(|(missing, work)| 100.0 * missing / work))
}

/// Runs that miss what is asked.
#[rustfmt::skip]
const MISSES: [Miss; 5] = [
    (STATIC, "pinched cylinder 21×21", 11.05),
    (STATIC, "pinched cylinder 31×31", 4.314),
    (NODAL_1, "panel jumps 11×11", 28.72),
    (CELL, "rolled twice 50×5", f64::NAN),
    (WIDE_14, "rolled twice 50×5", 0.9203),
];
