//! thin-partition: water of two depths on both sides of a wall of shell that is one to four spacings thick.

use std::ops::ControlFlow::Continue;

use crate::cases::coupled::measure::{SHELL, mean_and_deviation};
use crate::judge::{Case, Headline, Run, Variant};
use crate::support::coupled::{GRAVITY, WATER};
use crate::support::watched::watched;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("partition.toml");
const SPACING: f64 = 0.02;
/// Depths left and right, and widths of both \[m\].
const DEPTHS: [f64; 2] = [0.6, 0.3];
const WIDTH: f64 = 0.4;
/// Thicknesses in spacings: from one to three smoothing lengths.
const THICKNESSES: [f64; 4] = [1.0, 1.3, 2.0, 3.9];

const THRUST: &str = "thrust";
const LEAKED: &str = "particles on the wrong side";

/// The partition, its thrust in closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "thin-partition",
        title: "A wall of shell thinner than the kernel, water on both sides",
        about: "The shell is held still between two depths of water. Its thickness goes from one \
                spacing, where the rows of points behind either face lie in the water on the other side, \
                to three smoothing lengths. The thrust is that of the difference of the two depths, and \
                no particle may pass.",
        citation: "½ ρ g (H₁² − H₂²)",
        variants: THICKNESSES.map(held).into(),
        headline: Some(Headline::new(THRUST, 1.0)),
        ..Case::default()
    }
}

fn held(ratio: f64) -> Variant {
    let face = 0.5 * ratio * SPACING;
    let [left, right] = [-face - WIDTH, face + WIDTH];
    let boxes = format!(
        "{{ spacing = {SPACING}, parts = [{{ lengths = [{WIDTH}, {}], origin = [{left}, 0.0] }}, \
         {{ lengths = [{WIDTH}, {}], origin = [{face}, 0.0] }}] }}",
        DEPTHS[0], DEPTHS[1]
    );
    let scene = Variant::scene(SHELL, SCENE, format!("t = {ratio} Δx"))
        .set("bodies.water.fluid.geometry.blocks", boxes)
        .set("bodies.tank.walls.geometry.basin.min", format!("[{left}, 0.0]"))
        .set("bodies.tank.walls.geometry.basin.max", format!("[{right}, 0.8]"))
        .set("bodies.wall.shell.section.homogeneous.thickness", 2.0 * face)
        .unsettled();
    let leaks = watched(scene, &[(LEAKED, "-")], |march| {
        let places = march.body().configuration();
        // Wall and shell stay where they are.
        let wrong = |a: &usize| places.rest[*a].x * places.present[*a].x < 0.0;
        Ok(Continue(vec![(0..places.rest.len()).filter(wrong).count() as f64]))
    });
    leaks.judged(|run, _| judged(run))
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let [h1, h2] = DEPTHS;
    let exact = 0.5 * WATER * GRAVITY * (h1 * h1 - h2 * h2);
    let late = mean_and_deviation(&run.column("time")?, &run.column("thrust")?, [0.505, 1.0]);
    let leaked = run.column(LEAKED)?.into_iter().reduce(f64::max);
    Ok(vec![
        Metric::compared(THRUST, late.map(|found| found.0), "N/m", exact)
            .within(0.05 * exact, "a spacing is 3 % of the greater depth"),
        Metric::error(LEAKED, leaked, "-").within(0.0, "a wall lets no particle pass"),
    ])
}
