//! plate-frequencies: the first six bending frequencies of square plates, four kinds of edges, four thicknesses.

use benchmarks_ref::fe_shell::cases::{PlateEdges, plate_frequencies};
use benchmarks_ref::reference;

use super::plate::{letters, named, of_thickness, supported};
use crate::judge::Measured;
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::methods::{ELEMENTS, STATIC};
use crate::{JudgeError, Metric};

const EDGES: [PlateEdges; 4] =
    [PlateEdges::SimplySupported, PlateEdges::Clamped, PlateEdges::Cantilever, PlateEdges::Free];
const THICKNESSES: [f64; 4] = [0.001, 0.01, 0.1, 0.2];
const MODES: usize = 6;
const NAME: &str = "worst of six frequencies";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "plate-frequencies",
        title: "Frequencies of square plates",
        about: "First six bending frequencies, in parts of √(D/ρha⁴), against a Ritz series with rotary inertia; motions in \
                the plane are held, rigid ones left out. Stiffness and mass of particles are judged together.",
        citation: "Leissa 1969 for thin plates; Ritz series of this project's reference file",
        variants: variants(),
        // The Ritz series is converged to 7e-4 for cantilevers and free plates.
        headline: Some(Headline::new(NAME, 0.05)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for edges in EDGES {
        for thickness in THICKNESSES {
            let modes = MODES + rigid(edges);
            let particles =
                supported(of_thickness(STATIC, 21, thickness), edges).set("analysis.modal.modes", modes);
            let nodes =
                Variant::elements(ELEMENTS, [21, 21], move || plate_frequencies(20, thickness, edges));
            // Elements leave rigid motions out by themselves.
            variants.extend([(particles, rigid(edges)), (nodes, 0)].map(|(variant, left_out)| {
                let judged = move |run: &Run, _: &Runs| frequencies(run, edges, thickness, left_out);
                variant.on(&named(edges, thickness)).quick_if(thickness == 0.01).judged(judged)
            }));
        }
    }
    variants
}

/// Rigid motions that nothing holds, the plane's being held everywhere.
fn rigid(edges: PlateEdges) -> usize {
    if edges == PlateEdges::Free { 3 } else { 0 }
}

/// Errors of the worst of six \[%\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[
        ("21×21 SSSS h/a 0.001", 0.74), ("21×21 SSSS h/a 0.01", 0.74), ("21×21 SSSS h/a 0.1", 0.91),
        ("21×21 SSSS h/a 0.2", 1.1), ("21×21 CCCC h/a 0.001", 1.3), ("21×21 CCCC h/a 0.01", 1.3),
        ("21×21 CCCC h/a 0.1", 0.73), ("21×21 CCCC h/a 0.2", 1.1), ("21×21 CFFF h/a 0.001", 1.2),
        ("21×21 CFFF h/a 0.01", 1.1), ("21×21 CFFF h/a 0.1", 0.9), ("21×21 CFFF h/a 0.2", 0.98),
        ("21×21 FFFF h/a 0.001", 0.98), ("21×21 FFFF h/a 0.01", 0.91), ("21×21 FFFF h/a 0.1", 0.76),
        ("21×21 FFFF h/a 0.2", 1.3),
    ]),
    (ELEMENTS, &[
        ("21×21 SSSS h/a 0.001", 0.55), ("21×21 SSSS h/a 0.01", 0.55), ("21×21 SSSS h/a 0.1", 0.7),
        ("21×21 SSSS h/a 0.2", 0.89), ("21×21 CCCC h/a 0.001", 1.4), ("21×21 CCCC h/a 0.01", 1.4),
        ("21×21 CCCC h/a 0.1", 0.44), ("21×21 CCCC h/a 0.2", 0.79), ("21×21 CFFF h/a 0.001", 0.89),
        ("21×21 CFFF h/a 0.01", 0.66), ("21×21 CFFF h/a 0.1", 0.6), ("21×21 CFFF h/a 0.2", 0.78),
        ("21×21 FFFF h/a 0.001", 0.84), ("21×21 FFFF h/a 0.01", 0.79), ("21×21 FFFF h/a 0.1", 0.74),
        ("21×21 FFFF h/a 0.2", 1.0),
    ]),
]);

/// The frequencies of a plate, the first `left_out` of the run being rigid.
fn frequencies(
    run: &Run,
    edges: PlateEdges,
    thickness: f64,
    left_out: usize,
) -> Result<Vec<Metric>, JudgeError> {
    let (table, letters) = (reference("plate_vibration_square")?, letters(edges));
    let mut row = 0;
    while row < table.rows.len()
        && !(table.rows[row][0].as_str() == Some(letters) && table.number(row, "h/a")? == thickness)
    {
        row += 1;
    }
    let found = run.column("circular_frequency")?;
    let mut errors = Vec::new();
    for mode in 1..=MODES {
        let expected = table.number(row, &format!("lambda{mode}"))?;
        let error = found.get(left_out + mode - 1).map(|value| 100.0 * (value / expected - 1.0));
        errors.push((mode as f64, error));
    }
    let first = errors[0];
    let reason = "of second order in the spacing over the wave; mass and stiffness together";
    let measured = MEASURED.of(run)?;
    Ok(vec![
        Metric::greatest(NAME, errors, "%").near(measured, reason),
        Metric::greatest("first", [first], "%").near(measured, "no worse than the worst of the six"),
    ])
}
