//! open-channel: steady flow over a sill in a channel that goes round, its discharge and its heads.

use crate::judge::{Case, Headline, Run, Variant};
use crate::support::fluids::KICKS;
use crate::support::misses::{Miss, between};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/open-channel.toml");
const FLOW: &str = "discharge over velocity of the zone times depth";
const SAME: &str = "discharge over the sill";
const CREST: &str = "depth over the sill over Bernoulli's";
/// Velocity of the zone \[m/s\], height of the sill \[m\], gravity \[m/s²\].
const VELOCITY: f64 = 0.7;
const SILL: f64 = 0.06;
const GRAVITY: f64 = 9.81;
/// From when on the flow is a mean \[s\]: the sloshing of the start has gone through the zone some times.
const FROM: f64 = 8.0;

/// What is known to be missed: the flow that the bed brakes, and the depth over the sill.
const BRAKED: Miss = Miss {
    measured: 0.96,
    margin: 0.01,
    cause: "the bed brakes: its layer carries less than the velocity of the zone times its thickness; with a quarter of the artificial viscosity 2 % more flows",
};
const SUNK: Miss = Miss {
    measured: 0.976,
    margin: 0.006,
    cause: "the bed takes .9 % of the head on the way, and sloshing of the start swings in the mean; with a quarter of the artificial viscosity it is 1.2 % deeper \
            (docs/flows.md)",
};

/// The channel, Bernoulli's equation, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "open-channel",
        title: "Flow over a sill in an open channel",
        about: "Water goes round through periodic sides and a zone that keeps its velocity; over a sill its surface sinks. Means of the last seconds: what flows before the sill and over it is the \
                velocity of the zone times the depth, and the depth over the sill that which has the head of the water before it, h + q²/2gh², less the height of the sill.",
        citation: "Bernoulli's equation of subcritical flow",
        variants: vec![
            Variant::scene(KICKS, SCENE, "15 rows").unsettled().full_if(true).judged(|run, _| judged(run)),
        ],
        headline: Some(Headline::new(CREST, 0.1)),
        ..Case::default()
    }
}

/// The greater depth at which water of a discharge \[m²/s\] has a head \[m\], by halving from the critical depth on; none where there is none.
pub(super) fn depth(head: f64, flow: f64) -> Option<f64> {
    let square = flow * flow / (2.0 * GRAVITY);
    let own = |h: f64| h + square / (h * h);
    let (mut low, mut high) = (libm::cbrt(2.0 * square), head);
    if own(low) > head {
        return None;
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if own(middle) < head { low = middle } else { high = middle }
    }
    Some(low)
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let time = run.column("time")?;
    let mean = |name: &str| -> Result<Option<f64>, JudgeError> {
        let column = run.column(name)?;
        let kept: Vec<f64> = time.iter().zip(&column).filter(|(t, _)| **t >= FROM).map(|(_, x)| *x).collect();
        Ok((run.done() && !kept.is_empty()).then(|| kept.iter().sum::<f64>() / kept.len() as f64))
    };
    let [flow, before, over, crest] = [mean("q")?, mean("h")?, mean("q_sill")?, mean("h_sill")?];
    let of_zone = before.map_or(0.0, |h| VELOCITY * h);
    let bernoulli = before.zip(flow).and_then(|(h, q)| depth(h + q * q / (2.0 * GRAVITY * h * h) - SILL, q));
    let bernoulli = bernoulli.unwrap_or(0.0);
    let over_one = |value: Option<f64>, of: f64| value.map(|value| value / of);
    let asked = [0.98, 1.02];
    let mut metrics = between(FLOW, over_one(flow, of_zone), "-", asked, "2 %", Some(BRAKED));
    metrics.extend(between(CREST, over_one(crest, bernoulli), "-", asked, "2 %", Some(SUNK)));
    metrics.push(Metric::compared(SAME, over, "m²/s", flow.unwrap_or(0.0)).within(
        0.02 * flow.unwrap_or(0.0),
        "asked 2 %: no water is lost or made; means over seconds of a flow that still swings",
    ));
    Ok(metrics)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_depth_has_its_head() {
        let (h, q) = (0.3, 0.21);
        let found = depth(h + q * q / (2.0 * GRAVITY * h * h), q).unwrap();
        assert!((found - h).abs() < 1e-12);
        assert_eq!(depth(0.1, q), None);
    }
}
