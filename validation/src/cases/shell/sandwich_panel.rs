//! sandwich-panel: a panel of given stiffness, of whose deflection two thirds are shear of its core, against Navier's series.

use benchmarks_ref::sheared_plate::ShearedPlate;

use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/sandwich-panel.toml");
const NAME: &str = "deflection";
/// As in the scene; mass by area and ρt³/12.
const PANEL: ShearedPlate = ShearedPlate {
    lengths: [0.6, 0.4],
    bending: [13318.56, 13318.56, 3995.569, 4661.497],
    shear: [865280.0, 540800.0],
    inertia: [246.2963 * 0.0216, 246.2963 * 0.0216 * 0.0216 * 0.0216 / 12.0],
};

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    let plate = |counts| Variant::new(STATIC, SCENE, "plate", counts).quick();
    let lattices = [([25, 17], 24.0), ([49, 33], 48.0)];
    let pressed = lattices.map(|(counts, cells)| {
        plate(counts).on("under pressure").judged(move |run: &Run, _: &Runs| bent(run, cells))
    });
    let swinging = lattices.map(|(counts, cells)| {
        plate(counts)
            .on("vibrating")
            .set("analysis", "{ modal = { modes = 3 } }")
            .set("curve", "[]")
            .judged(move |run: &Run, _: &Runs| frequencies(run, cells))
    });
    Case {
        name: "sandwich-panel",
        title: "Sandwich panel of given stiffness",
        about: "Faces of aluminium on a honeycomb that is stiffer along its ribbons, on four edges: deflection and moment at the centre under pressure, and \
                three frequencies.",
        citation: "Navier's series of an orthotropic plate that bends and shears, in closed form",
        variants: pressed.into_iter().chain(swinging).collect(),
        headline: Some(Headline::new(NAME, 0.1)),
        ..Case::default()
    }
}

fn bent(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let [w, _, m] = PANEL.centre(20e3);
    let percent = |name, exact: f64| run.last(name).map(|of| of.map(|found| 100.0 * (found / exact - 1.0)));
    // .044 and .15 % with 48 cells.
    let reason = "three times what one curvature and one gradient a cell leave of waves of the panel's length, of second order";
    Ok(vec![
        Metric::error(NAME, percent("w", w)?, "%").within(finer(3.0 * 0.044, cells), reason),
        Metric::error("moment across", percent("m_across", -m)?, "%")
            .within(finer(3.0 * 0.15, cells), reason),
    ])
}

fn frequencies(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let mut exact: Vec<f64> = (1..5).flat_map(|m| (1..5).map(move |n| PANEL.frequency(m, n))).collect();
    exact.sort_by(f64::total_cmp);
    let found = run.column("circular_frequency")?;
    let error = |(number, exact): (usize, &f64)| {
        ((number + 1) as f64, found.get(number).map(|found| 100.0 * (found / exact - 1.0)))
    };
    let errors: Vec<_> = exact.iter().take(3).enumerate().map(error).collect();
    // .20 % with 48 cells.
    let reason = "three times the error of the third, of two half waves across, of second order";
    Ok(vec![
        Metric::greatest("worst of three frequencies", errors, "%").within(finer(3.0 * 0.20, cells), reason),
    ])
}

/// An error with 48 cells along the panel, on a lattice of so many.
fn finer(error: f64, cells: f64) -> f64 {
    error * (48.0 / cells).powi(2)
}
