//! struck-strip: a strip whose end is pushed in at once, judged by d'Alembert's wave, with the viscosity of the published equations and without.

use crate::judge::{Case, Run, Variant};
use crate::{JudgeError, Metric};

/// Length, Young's modulus and density are one: so is the speed of the wave with ν = 0. Duration .9, before the wave meets the far end.
const SCENE: &str = r#"
title = "A strip whose end is pushed in at once"
units = { length = "m", force = "N", time = "s" }

[geometry.plate]
lengths = [1.0, 0.04]
particles = [101, 5]

[material.elastic]
young = 1.0
poisson = 0.0
density = 1.0

[section.homogeneous]
thickness = 0.02

[formulation.strong-form]
divergence = "difference"

[sets.middle]
nearest = [0.5, 0.02, 0.0]

[[supports]]
on = "u0"
moved = { direction = [1.0, 0.0, 0.0], by = 9e-4 }
amplitude = { ramp = 0.9 }

[analysis.explicit.transient]
duration = 0.9
record_every = 0.01

[[curve]]
name = "u"
of = "displacement"
on = "middle"
direction = [1.0, 0.0, 0.0]

[output]
plot = { x = "time", y = "u" }
"#;
/// Speed of the end \[m/s\].
const SPEED: f64 = 1e-3;
/// When the wave is in the middle \[s\].
const ARRIVAL: f64 = 0.5;
const WITHOUT: &str = "no viscosity";
const OVER: &str = "greatest speed behind the front, off";
const RINGING: &str = "speed .3 s behind the front and later, root mean square off";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    let on = |grid: &str, viscosity: f64| {
        Variant::scene(crate::methods::STRONG_DIFFERENCE, SCENE, grid)
            .set("formulation.strong-form.viscosity", viscosity)
            .quick()
    };
    Case {
        name: "struck-strip",
        title: "A strip struck in its plane, with artificial viscosity and without",
        about: "One end moves at a constant speed from the start. Behind the front every particle has that speed, before it none \
                (d'Alembert). Without viscosity it rings behind the front; Π of the published equations is for that. Particles stand \
                .01 apart, speeds are means over .01 s, the time the wave takes between two of them.",
        citation: "Lin et al. 2013, eq. 4; closed form: u = v (t − x/c) behind the front",
        variants: vec![on(WITHOUT, 0.0), on("μ = 1", 1.0)],
        each,
        ..Case::default()
    }
}

/// Speeds of the middle between records over that of the end, by the time half-way.
fn speeds(run: &Run) -> Result<Vec<(f64, f64)>, JudgeError> {
    let (time, u) = (run.column("time")?, run.column("u")?);
    let pairs = time.windows(2).zip(u.windows(2));
    Ok(pairs.map(|(t, u)| (0.5 * (t[0] + t[1]), (u[1] - u[0]) / (t[1] - t[0]) / SPEED)).collect())
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let speeds = speeds(run)?;
    let over = speeds.iter().fold(0.0, |most: f64, (_, speed)| most.max(*speed)) - 1.0;
    // Where half of the speed is reached, between two records.
    let arrival = speeds.windows(2).find(|pair| pair[1].1 >= 0.5).map(|pair| {
        let [(t0, v0), (t1, v1)] = [pair[0], pair[1]];
        t0 + (0.5 - v0) / (v1 - v0) * (t1 - t0)
    });
    let late: Vec<f64> =
        speeds.iter().filter(|(t, _)| *t > ARRIVAL + 0.3).map(|(_, speed)| speed - 1.0).collect();
    let rings = (late.iter().map(|off| off * off).sum::<f64>() / late.len() as f64).sqrt();
    let (over, rings) = (Some(100.0 * over.abs()), Some(100.0 * rings));
    let late = Metric::compared("front in the middle", arrival, "s", ARRIVAL);
    if run.variant.grid == WITHOUT {
        let reason = "dispersion of the lattice behind a jump, which has no last wave length: what coque gave when the case was written";
        return Ok(vec![
            Metric::compared(OVER, over, "%", 25.5).within(2.6, reason),
            Metric::compared(RINGING, rings, "%", 8.12).within(0.8, reason),
            late.near(2.4, "half of the speed is passed on the flank of a front that short waves have left"),
        ]);
    }
    Ok(vec![
        Metric::error(OVER, over, "%").near(0.014, "what viscosity leaves of the ringing"),
        Metric::error(RINGING, rings, "%").near(0.019, "what viscosity leaves of the ringing"),
        late.near(0.041, "a front some spacings wide has its half where the jump is"),
    ])
}
