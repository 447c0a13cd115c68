//! channel-with-inflow: steady flow over a sill from an inflow to an outflow, its discharge and its depths.

use super::open_channel::depth;
use crate::judge::{Case, Headline, Run, Variant};
use crate::support::fluids::KICKS;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/channel-with-inflow.toml");
const FLOW: &str = "discharge over velocity of the inflow times depth";
const SAME: &str = "discharge over the sill";
const LEVEL: &str = "depth before the sill over that of the outflow's head";
const CREST: &str = "depth over the sill over Bernoulli's";
/// Velocity of the inflow \[m/s\], level of the outflow and height of the sill \[m\], gravity \[m/s²\].
const VELOCITY: f64 = 0.5;
const OUTFLOW: f64 = 0.3;
const SILL: f64 = 0.06;
const GRAVITY: f64 = 9.81;
/// From when on the flow is a mean \[s\].
const FROM: f64 = 8.0;

/// The channel, Bernoulli's equation, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "channel-with-inflow",
        title: "Flow over a sill, from an inflow to an outflow",
        about: "Water comes in with a velocity and goes out by a level; over a sill its surface sinks. Means of the last seconds: what flows is the velocity of the inflow times the depth there, \
                the depth before the sill has the head of the outflow, and the depth over the sill that of both, h + q²/2gh², less the height of the sill.",
        citation: "Bernoulli's equation of subcritical flow",
        variants: vec![
            Variant::scene(KICKS, SCENE, "15 rows").unsettled().full_if(true).judged(|run, _| judged(run)),
        ],
        headline: Some(Headline::new(CREST, 0.1)),
        ..Case::default()
    }
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let time = run.column("time")?;
    let mean = |name: &str| -> Result<Option<f64>, JudgeError> {
        let column = run.column(name)?;
        let kept: Vec<f64> = time.iter().zip(&column).filter(|(t, _)| **t >= FROM).map(|(_, x)| *x).collect();
        Ok((run.done() && !kept.is_empty()).then(|| kept.iter().sum::<f64>() / kept.len() as f64))
    };
    let [flow, before, over, crest] = [mean("q")?, mean("h")?, mean("q_sill")?, mean("h_sill")?];
    let head = |h: f64, q: f64| h + q * q / (2.0 * GRAVITY * h * h);
    let inflow = before.map_or(0.0, |h| VELOCITY * h);
    let level = flow.and_then(|q| depth(head(OUTFLOW, q), q)).unwrap_or(0.0);
    let bernoulli = before.zip(flow).and_then(|(h, q)| depth(head(h, q) - SILL, q)).unwrap_or(0.0);
    let within = |name: &str, value: Option<f64>, of: f64, unit: &str, why: &str| {
        Metric::compared(name, value, unit, of).within(0.02 * of, why)
    };
    Ok(vec![
        within(FLOW, flow, inflow, "m²/s", "asked 2 %: what comes in has one velocity at all depths"),
        within(LEVEL, before, level, "m", "asked 2 %: walls let the water slip, so that its head stays"),
        within(CREST, crest, bernoulli, "m", "asked 2 %: the same head less the height of the sill"),
        within(SAME, over, flow.unwrap_or(0.0), "m²/s", "asked 2 %: no water is lost or made between"),
    ])
}
