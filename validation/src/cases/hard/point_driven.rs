//! point-driven: the panel pushed in through one particle, with every formulation, on and off the lattice.

use crate::cases::shell::point_load_smoothness::{checkerboard, second_difference};
use crate::judge::{Case, Headline, Run, Variant};
use crate::support::scenes;
use crate::support::studies::{ENERGY, jittered};
use crate::{JudgeError, Metric};

const STANDS_OUT: &str = "crown over its neighbours";
const BOARD: &str = "checkerboard farther off";
const UNIT: &str = "% of crown";

pub fn case() -> Case {
    Case {
        name: "point-driven",
        title: "The panel pushed in through one particle: do its neighbours follow?",
        about: "Without time, crown at 10 mm, 11×11. Second difference of the displacement at the crown, and the largest part \
                that alternates from particle to particle two and more particles away, both in parts of the crown's \
                displacement. Off the lattice uneven spacing adds what a smooth field has of itself.",
        citation: "the panel of Sze, Liu and Lo 2004; reference: neighbours that follow exactly",
        variants: variants(),
        each,
        headline: Some(Headline::new(STANDS_OUT, 0.1)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for method in ENERGY {
        let panel = Variant::new(method, scenes::PANEL, "cylinder", [11, 11])
            .set("analysis.static.levels", "[0.16666666666666666, 0.3333333333333333]");
        variants.push(panel.clone());
        variants.push(jittered(panel, "cylinder"));
    }
    variants
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let percent = |value: Option<f64>| value.map(|value| 100.0 * value);
    Ok(vec![
        Metric::error(STANDS_OUT, percent(second_difference(run)), UNIT).within(
            20.0,
            "a neighbour that stayed behind would give 200 %; bending under a point load gives 6 to 13 % at this spacing",
        ),
        Metric::error(BOARD, percent(checkerboard(run, 2)), UNIT).within(
            2.0,
            "a zero-energy mode would be as large as the displacement; uneven spacing alone makes 1.1 to 1.5 %",
        ),
    ])
}
