//! ply-strength: plies and laminates that are pulled until one of them fails, against classical lamination.

use benchmarks_ref::reference;

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("ply-strength.toml");
const TSAI_WU: &str = "reserve factor of Tsai and Wu";
const HASHIN: &str = "reserve factor of Hashin";

/// Angles from the lowest ply, their thickness \[mm\], and by how much it is cooled \[K\]; a row of the reference each.
const ROWS: [(&str, &[f64], f64, f64); 7] = [
    ("ply at 15°", &[15.0], 0.5, 0.0),
    ("ply at 45°", &[45.0], 0.5, 0.0),
    ("ply at 75°", &[75.0], 0.5, 0.0),
    ("[0/45/−45/90]ₛ", &EVEN, 0.125, 0.0),
    ("[0/45/−45/90]ₛ, cooled", &EVEN, 0.125, 100.0),
    ("[0/45/90]", &UNEVEN, 0.125, 0.0),
    ("[0/45/90], cooled", &UNEVEN, 0.125, 100.0),
];
const EVEN: [f64; 8] = [0.0, 45.0, -45.0, 90.0, 90.0, -45.0, 45.0, 0.0];
const UNEVEN: [f64; 3] = [0.0, 45.0, 90.0];

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "ply-strength",
        title: "Laminates that are pulled until a ply fails",
        about: "Single plies at an angle, a balanced and an uneven laminate, warm and cooled: by what all stresses may grow until the first ply fails, by two criteria.",
        citation: "[jones1999], [tsai1971], [hashin1980]: classical lamination",
        variants: (0..ROWS.len()).map(variant).collect(),
        headline: Some(Headline::new(TSAI_WU, 0.1)),
        ..Case::default()
    }
}

fn variant(row: usize) -> Variant {
    let (name, angles, thickness, cooled) = ROWS[row];
    let ply = |angle: &f64| format!("{{ thickness = {thickness:?}, angle = {angle:?} }}");
    let plies = angles.iter().map(ply).collect::<Vec<_>>().join(", ");
    let scene = Variant::scene(STATIC, SCENE, name).set("section.layered.plies", format!("[{plies}]"));
    let scene = scene.set("loads[2].temperature.change", format!("{:?}", -cooled));
    scene.quick().judged(move |run, _| judged(run, row))
}

fn judged(run: &Run, row: usize) -> Result<Vec<Metric>, JudgeError> {
    let table = reference("ply_strength")?;
    // 7.5e-9 % at most.
    let reason = "three times what the differences of a linear answer leave of an even state, which cells have exactly";
    let error = |name: &str, column: &str, of: &str| -> Result<Metric, JudgeError> {
        let exact = table.number(row, of)?;
        let percent = run.last(column)?.map(|found| 100.0 * (found / exact - 1.0));
        Ok(Metric::error(name, percent, "%").within(3.0 * 7.5e-9, reason))
    };
    Ok(vec![error(TSAI_WU, "tsai_wu", "tsai-wu")?, error(HASHIN, "hashin", "hashin")?])
}
