//! plate-in-water-modes: frequencies of a hinged plate that is the floor of a tank, against a series of potential flow.

use benchmarks_ref::reference;

use super::measure::SHELL;
use crate::judge::{Case, Headline, Run, Variant};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/plate-in-water-modes.toml");
const FIRST: &str = "first frequency";
/// Modes that are judged.
const MODES: usize = 4;

/// The plate, its series, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "plate-in-water-modes",
        title: "A plate under water swinging",
        about: "Half a metre of still water on an aluminium plate of 1 m by 10 mm, hinged at both ends, a slice: its first four frequencies, which water \
                lowers to a quarter and to a half, by the Laplacian of the water on the lattice of the scene; and the first by a march of the same scene, let go \
                under weights of a fiftieth, so that the plate stays linear.",
        citation: "potential flow by Fourier series, Ritz with sines, this project's reference file",
        variants: [variant(20, 2.0), variant(40, 0.71), march()].into(),
        headline: Some(Headline::new(FIRST, 0.1)),
        ..Case::default()
    }
}

/// So many spacings of the water along the plate, and twice as many cells; how far off the worst frequency was when this was reviewed \[%\].
fn variant(spacings: usize, measured: f64) -> Variant {
    Variant::scene(SHELL, SCENE, format!("L/Δx {spacings}"))
        .set("bodies.water.fluid.geometry.block.spacing", 1.0 / spacings as f64)
        .set("bodies.plate.shell.geometry.plate.particles", format!("[{}, 2]", 2 * spacings + 1))
        .quick_if(false)
        .judged(move |run, _| judged(run, measured))
}

/// The same scene in time, which swings about where weights would let it rest.
fn march() -> Variant {
    let (spacings, transient) = (20, "{ explicit.transient = { duration = 0.5, record_every = 0.002 } }");
    let middle = "{ of = \"plate\", box = { min = [0.49, -1.0, -1.0], max = [0.51, 1.0, 1.0] } }";
    let column = "[{ name = \"w\", of = \"displacement\", on = \"middle\", direction = [0.0, -1.0, 0.0] }]";
    Variant::scene(SHELL, SCENE, format!("L/Δx {spacings}, in time"))
        .set("analysis", transient)
        .set("bodies.water.fluid.geometry.block.spacing", 1.0 / f64::from(spacings))
        .set("bodies.water.fluid.material.liquid.sound_speed", 100.0)
        .set("bodies.plate.shell.geometry.plate.particles", "[21, 2]")
        .set("loads[0].gravity.acceleration", "[0.0, -0.2, 0.0]")
        .set("sets.middle", middle)
        .set("curve", column)
        .unsettled()
        .quick_if(false)
        .judged(|run, _| {
            let found = frequency(&run.column("time")?, &run.column("w")?);
            let wet = reference("plate_in_water")?.number(0, "wet")?;
            let reason = "asked: 3 %; sound of 100 m/s lowers it by (ωH/c)²/6 at most, .6 %, twenty spacings of water raise it";
            Ok(vec![Metric::compared(FIRST, found, "Hz", wet).within(0.03 * wet, reason)])
        })
}

/// From the first to the last time at which a swing passes its mean upwards; none of one that does so once.
fn frequency(times: &[f64], ways: &[f64]) -> Option<f64> {
    let mean = ways.iter().sum::<f64>() / ways.len() as f64;
    let pairs = times.windows(2).zip(ways.windows(2)).filter(|(_, w)| w[0] < mean && w[1] >= mean);
    let ups: Vec<f64> = pairs.map(|(t, w)| t[0] + (mean - w[0]) / (w[1] - w[0]) * (t[1] - t[0])).collect();
    let (first, last) = (ups.first()?, ups.last()?);
    (ups.len() > 1).then(|| (ups.len() - 1) as f64 / (last - first))
}

fn judged(run: &Run, measured: f64) -> Result<Vec<Metric>, JudgeError> {
    let table = reference("plate_in_water")?;
    let found = run.column("frequency")?;
    let mut errors = Vec::new();
    for mode in 0..MODES {
        let wet = table.number(mode, "wet")?;
        errors.push((mode as f64 + 1.0, found.get(mode).map(|found| 100.0 * (found / wet - 1.0))));
    }
    Ok(vec![
        Metric::compared(FIRST, found.first().copied(), "Hz", table.number(0, "wet")?)
            .within(0.0583, "asked: 1 %"),
        Metric::greatest("worst of four frequencies", errors, "%").near(
            measured,
            "of the second order in the spacing over the wave, (ks)²/6 of the added mass: the fourth has half of the plate for a wave",
        ),
    ])
}
