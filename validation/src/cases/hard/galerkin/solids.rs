//! galerkin-solids: slender and thin bodies, nodes in disorder, a material that hardly gives way, free motion.

use benchmarks_ref::reference;

use crate::judge::{Case, Headline, Run, Variant};
use crate::metric_names::ERROR;
use crate::{JudgeError, Metric};

const CANTILEVER: &str = include_str!("../../../../../scenes/cantilever-solid.toml");
const PLATE: &str = include_str!("../../../../../scenes/plate-solid.toml");
const METHOD: &str = "galerkin";
const GALERKIN: &str = "bodies.beam.solid.formulation.galerkin";
/// A beam with shear under K = 1 on its upper face (`holden_cantilever`), in lengths.
const BEAM: f64 = 0.127_012;
const BLOCK: &str = "bodies.beam.solid.geometry.block";

/// The bodies, and what they have to keep.
pub fn case() -> Case {
    Case {
        name: "galerkin-solids",
        title: "Galerkin solids: slender, thin, in disorder, nearly incompressible, free",
        about: "A slender beam in large steps, at which the tangent of the rate equation fails and the other is taken; plates of a/h to \
                1000; nodes moved by a quarter of their spacing, inside and on faces; Poisson's ratio .49 and .499, at which \
                changes of volume are shared within a cell; a body without supports, which has six rigid motions and no more.",
        citation: "reference: Holden's elastica, Kirchhoff's plate, the same bodies in order",
        variants: variants(),
        headline: Some(Headline::new(ERROR, 0.01)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let beam = |grid: &str| Variant::scene(METHOD, CANTILEVER, grid);
    let mut variants = vec![
        beam("slender 41×3×3, steps of K = 1")
            .set(BLOCK, "{ lengths = [254.0, 12.7, 12.7], spacing = 6.35 }")
            .set("loads", "[{ on = \"all\", gravity = { acceleration = [0.0, 0.0, -67864.17322834646] } }]")
            .set("sets.tip", "{ nearest = [254.0, 6.35, 6.35] }")
            .static_levels(&[1.0, 2.0, 3.0, 4.0])
            .judged(|run, _| slender(run)),
    ];
    for (h, stiff) in [(0.5, 0.12), (0.1, 2.4)] {
        variants.push(thin(h).judged(move |run, _| plate(run, h, stiff)));
    }
    for (fraction, measured) in [(0.1, 0.04), (0.25, 0.05)] {
        variants.push(
            beam(&format!("nodes moved by {fraction}"))
                .set(
                    BLOCK,
                    format!(
                        "{{ lengths = [254.0, 25.4, 25.4], spacing = 12.7, disorder = {{ fraction = {fraction}, seed = 11 }} }}"
                    ),
                )
                .static_levels(&[1.0])
                .judged(move |run, _| {
                    let found = Metric::compared(ERROR, run.last("w")?, "L", 0.125_82);
                    Ok(vec![found.near(measured, "beside nodes in rows; the quadrature of cells that nodes have left")])
                }),
        );
    }
    for (poisson, basis, ratio) in
        [(0.49, "quadratic", 0.9705), (0.499, "quadratic", 0.9682), (0.49, "linear", 0.9760)]
    {
        variants.push(
            beam(&format!("ν = {poisson}, {basis}"))
                .set("bodies.beam.solid.material.elastic.poisson", poisson)
                .set(&format!("{GALERKIN}.basis"), basis)
                .static_levels(&[1.0])
                .judged(move |run, _| {
                    let found =
                        Metric::compared("deflection over that of a beam", over_beam(run)?, "-", ratio);
                    Ok(vec![found.near(
                        0.3,
                        "a figure to notice a change by: .981 at ν = .3, and a clamp that holds the contraction of a rubber",
                    )])
                }),
        );
    }
    variants.push(
        Variant::scene(METHOD, CANTILEVER, "free")
            .set("supports", "[]")
            .set("loads", "[]")
            .set("curve", "[]")
            .set("output", "{}")
            .set(BLOCK, "{ lengths = [50.8, 25.4, 25.4], spacing = 12.7 }")
            .set("analysis.modal.modes", 7)
            .judged(|run, _| free(run)),
    );
    variants
}

/// The plate of the scene, of thickness h and side 100, under P = 1.
fn thin(h: f64) -> Variant {
    let middle = 0.5 * h;
    let load = (h / 100.0).powi(4);
    Variant::scene(METHOD, PLATE, format!("plate a/h {}", 100.0 / h))
        .set(
            "bodies.plate.solid.geometry.block",
            format!("{{ lengths = [50.0, 50.0, {h}], spacing = [10.0, 10.0, {middle}] }}"),
        )
        .set("sets.centre.nearest", format!("[0.0, 0.0, {middle}]"))
        .set("sets.edge_x.box", format!("{{ min = [50.0, 0.0, {middle}], max = [50.0, 50.0, {middle}] }}"))
        .set("sets.edge_y.box", format!("{{ min = [0.0, 50.0, {middle}], max = [50.0, 50.0, {middle}] }}"))
        .set("loads.0.traction.value", format!("[0.0, 0.0, {:e}]", -load))
        .set("curve.0.factor", 1.0 / h)
        .set("analysis", "{ linear = {} }")
}

fn slender(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let known = reference("holden_cantilever")?.curve("K", "dead_w_over_L")?;
    let asked = run.last("w")?.map(|w| 100.0 * (w / known.at(4.0).unwrap_or(f64::NAN) - 1.0).abs());
    Ok(vec![Metric::error(ERROR, asked, "%").within(0.7, "the mark of the design for L/h = 20")])
}

/// w/h = 0.00406235 · 12(1 − ν²) P of Kirchhoff's plate, simply supported.
fn plate(run: &Run, h: f64, stiff: f64) -> Result<Vec<Metric>, JudgeError> {
    let thin = 0.004_062_35 * 12.0 * (1.0 - 0.316 * 0.316);
    let found = Metric::compared(ERROR, run.last("w")?, "h", thin);
    let reason =
        if h < 0.2 { "cubic terms do not lock, but the condition of thin cells tells" } else { "the mesh" };
    Ok(vec![found.near(stiff, reason)])
}

/// Deflection over that of a beam with shear at K = 1; the clamp of a solid holds its contraction as well.
fn over_beam(run: &Run) -> Result<Option<f64>, JudgeError> {
    Ok(run.last("w")?.map(|w| w / BEAM))
}

fn free(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let frequencies = run.column("circular_frequency")?;
    let elastic = frequencies.get(6).copied();
    let rigid = frequencies.iter().take(6).fold(0.0, |most: f64, f| most.max(f.abs()));
    let part = elastic.map(|elastic| rigid / elastic);
    Ok(vec![
        Metric::error("greatest rigid over the first elastic frequency", part, "-")
            .within(1e-3, "six rigid motions without stiffness; the root of what rounding leaves of it"),
    ])
}
