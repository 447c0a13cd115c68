//! plate: square plates under pressure, clamped and simply supported, from thick to paper-thin; nothing may lock.

use benchmarks_ref::fe_shell::cases::{PlateEdges, plate_deflection};

use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, GREEN, Mark, ORANGE, Series};
use crate::judge::Measured;
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::methods::{ELEMENTS, STATIC};
use crate::support::linear;
use crate::support::scenes;
use crate::{JudgeError, Metric};

const NAME: &str = "central deflection";

/// Thickness over side, central deflection in q a⁴/D simply supported and clamped.
///
/// From `plate_static_square`; the thinnest takes the values of 0.001, from which it differs by 1e-6 of itself.
const DEFLECTIONS: [(f64, f64, f64); 6] = [
    (0.2, 0.00490431, 0.00217216),
    (0.1, 0.00427284, 0.00150463),
    (0.05, 0.00411498, 0.00132726),
    (0.01, 0.00406446, 0.00126785),
    (0.001, 0.00406237, 0.00126534),
    (0.0001, 0.00406237, 0.00126534),
];

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "plate",
        title: "Square plates under pressure, h/a from 0.2 to 0.0001",
        about: "Central deflection against Mindlin's theory, clamped and simply supported (hard), 21×21 on the whole plate. \
                The ratio has to stay flat as the plate gets thin: shear locking would bend it to zero.",
        citation: "Timoshenko and Woinowsky-Krieger 1959; thick plates by a Ritz series (this project's reference file)",
        variants: variants(),
        headline: Some(Headline::new(NAME, 0.01)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for edges in [PlateEdges::SimplySupported, PlateEdges::Clamped] {
        for (thickness, exact) in DEFLECTIONS.map(|row| (row.0, exact(row, edges))) {
            let particles = supported(of_thickness(STATIC, 21, thickness), edges);
            let nodes = Variant::elements(ELEMENTS, [21, 21], move || plate_deflection(20, thickness, edges));
            variants.extend([particles, nodes].map(|variant| {
                variant.on(&named(edges, thickness)).quick().judged(move |run, _| deflection(run, exact))
            }));
        }
    }
    variants
}

/// The plate of bending stiffness one and unit mass per area, of some thickness.
pub fn of_thickness(method: &str, n: usize, thickness: f64) -> Variant {
    thin(Variant::new(method, scenes::PLATE, "plate", [n, n]), thickness)
}

/// Gives a plate some thickness.
pub fn thin(variant: Variant, thickness: f64) -> Variant {
    variant
        .set("section.homogeneous.thickness", format!("{thickness:?}"))
        .set("material.elastic.young", format!("{:?}", 10.92 / thickness.powi(3)))
        .set("material.elastic.density", format!("{:?}", 1.0 / thickness))
}

/// Replaces the four clamped edges.
pub fn supported(variant: Variant, edges: PlateEdges) -> Variant {
    let hard = |edge: &str, along: &str| {
        format!("{{ on = \"{edge}\", held = {{ displacement = [[0, 0, 1]], director = [{along}] }} }}")
    };
    let plane = "{ on = \"all\", held = { displacement = [[1, 0, 0], [0, 1, 0]] } }";
    let clamp = "{ on = \"u0\", clamped = {} }";
    let supports = match edges {
        PlateEdges::Clamped => return variant,
        PlateEdges::SimplySupported => {
            let (x, y) = ("[1, 0, 0]", "[0, 1, 0]");
            format!("{plane}, {}, {}, {}, {}", hard("u0", y), hard("u1", y), hard("v0", x), hard("v1", x))
        }
        PlateEdges::Cantilever => format!("{plane}, {clamp}"),
        PlateEdges::Free => plane.into(),
    };
    variant.set("supports", format!("[{supports}]"))
}

/// The kind of edges in four letters, as in tables.
pub fn letters(edges: PlateEdges) -> &'static str {
    match edges {
        PlateEdges::SimplySupported => "SSSS",
        PlateEdges::Clamped => "CCCC",
        PlateEdges::Cantilever => "CFFF",
        PlateEdges::Free => "FFFF",
    }
}

/// What sets a plate apart.
pub fn named(edges: PlateEdges, thickness: f64) -> String {
    format!("{} h/a {thickness}", letters(edges))
}

/// Errors \[%\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[
        ("21×21 SSSS h/a 0.2", 0.066), ("21×21 SSSS h/a 0.1", 0.032), ("21×21 SSSS h/a 0.05", 0.021),
        ("21×21 SSSS h/a 0.01", 0.017), ("21×21 SSSS h/a 0.001", 0.017), ("21×21 SSSS h/a 0.0001", 0.016),
        ("21×21 CCCC h/a 0.2", 0.045), ("21×21 CCCC h/a 0.1", 0.0034), ("21×21 CCCC h/a 0.05", 0.0034),
        ("21×21 CCCC h/a 0.01", 0.0034), ("21×21 CCCC h/a 0.001", 0.0034), ("21×21 CCCC h/a 0.0001", 0.0035),
    ]),
    (ELEMENTS, &[
        ("21×21 SSSS h/a 0.2", 0.034), ("21×21 SSSS h/a 0.1", 0.068), ("21×21 SSSS h/a 0.05", 0.078),
        ("21×21 SSSS h/a 0.01", 0.081), ("21×21 SSSS h/a 0.001", 0.081), ("21×21 SSSS h/a 0.0001", 0.082),
        ("21×21 CCCC h/a 0.2", 0.11), ("21×21 CCCC h/a 0.1", 0.19), ("21×21 CCCC h/a 0.05", 0.2),
        ("21×21 CCCC h/a 0.01", 0.19), ("21×21 CCCC h/a 0.001", 0.19), ("21×21 CCCC h/a 0.0001", 0.19),
    ]),
]);

/// Central deflection of a row of the table, simply supported or clamped.
fn exact((_, supported, clamped): (f64, f64, f64), edges: PlateEdges) -> f64 {
    if edges == PlateEdges::Clamped { clamped } else { supported }
}

fn deflection(run: &Run, exact: f64) -> Result<Vec<Metric>, JudgeError> {
    let reason = "flat in the thickness: shear that locks would bend the thinnest to zero";
    Ok(vec![linear::figure(run, NAME, "w_centre", exact, (&MEASURED, reason))?])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut series = Vec::new();
    let looks = [
        (STATIC, PlateEdges::SimplySupported, BLUE, Mark::Disc),
        (STATIC, PlateEdges::Clamped, GREEN, Mark::Square),
        (ELEMENTS, PlateEdges::SimplySupported, BLACK, Mark::Circle),
        (ELEMENTS, PlateEdges::Clamped, ORANGE, Mark::Diamond),
    ];
    for (method, edges, colour, mark) in looks {
        let mut points = Vec::new();
        for row in DEFLECTIONS {
            let grid = format!("21×21 {}", named(edges, row.0));
            let Some(run) = runs.get(method, &grid)? else { continue };
            let deflection = run.column("w_centre")?.last().copied();
            points.extend(deflection.map(|value| (row.0, value / exact(row, edges))));
        }
        let edges = if edges == PlateEdges::Clamped { "clamped" } else { "simply supported" };
        series.push(Series::both(&format!("{method}, {edges}"), points, colour, mark));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Deflection over Mindlin's, against the thickness".into(),
        caption:
            "Flat lines: neither particles nor elements lock, over three and a half decades of thickness."
                .into(),
        x: Axis::log("thickness over side"),
        y: Axis::linear("central deflection / exact").between(0.985, 1.015),
        series,
    })])
}
