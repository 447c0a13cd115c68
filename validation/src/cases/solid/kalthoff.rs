//! kalthoff-winkler: a steel plate struck between two notches; it cracks at about 68° to them.

use std::ops::ControlFlow::Continue;

use peridynamics::{Correction, Formulation, Law, Space};
use sph_core::Vec3;

use super::measure::direction;
use crate::figures::{Axis, Chart, Figure, GREY, Line, Mark, SKY, Series, VERMILION};
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::methods::PAIRWISE;
use crate::support::marched::method;
use crate::support::misses::between;
use crate::support::solids::{formulation, said};
use crate::support::studies::figure;
use crate::support::watched::watched;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/kalthoff.toml");
/// Energy of a unit area of crack \[J/m²\].
const ENERGY: f64 = 22.2e3;
const DURATION: f64 = 9e-5;
/// Depth behind the struck edge, height, thickness.
const SIZE: [f64; 3] = [0.1, 0.2, 0.009];
const NOTCH: f64 = 0.05;
const HEIGHTS: [f64; 2] = [0.075, 0.125];
/// Half the speed of the projectile: it and the plate are of the same steel.
const HALF: f64 = 16.5;
/// The whole speed, put on the edge as many do.
const WHOLE: f64 = 32.0;

const ANGLE: &str = "angle by the farthest node";
const OTHER: &str = "the same of the other notch";
const FIT: &str = "angle by a line within 40 mm";
const LENGTH: &str = "length";

#[derive(Clone, Copy)]
struct Plate {
    space: Space,
    law: Law,
    horizon: f64,
    /// Spacing \[mm\].
    spacing: f64,
    correction: Correction,
    by_work: bool,
    speed: f64,
}

/// The plate, the angle seen, and how far answers may differ.
pub fn case() -> Case {
    Case {
        name: "kalthoff-winkler",
        title: "Plate struck between two notches: cracks at 62 to 71° to them",
        about: "The edge between the notches moves at 16.5 m/s, half the speed of a projectile of the same steel. The angle is \
                that of the chord from the tip of a notch to the farthest damaged node; the line that fits the nodes near the \
                notch is flatter and is shown. At the whole 32 m/s the plate shatters near the edge and the chord says little.",
        citation: "Kalthoff 2000; Kalthoff and Winkler 1988: about 70°",
        variants: variants(),
        headline: Some(Headline::new(ANGLE, 0.5)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    use Correction::{Even, None as Bare};
    use Law::{BondBased, StateBased};
    use Space::{PlaneStrain, PlaneStress, Solid};
    [
        (PlaneStress, BondBased, 3.015, 1.0, Bare, false, HALF),
        (PlaneStress, BondBased, 4.015, 1.0, Bare, false, HALF),
        (PlaneStress, StateBased, 3.015, 1.0, Bare, false, HALF),
        (PlaneStress, StateBased, 4.015, 1.0, Bare, false, HALF),
        (PlaneStress, StateBased, 4.015, 1.0, Bare, true, HALF),
        (PlaneStress, BondBased, 3.015, 1.0, Even, false, HALF),
        (PlaneStress, StateBased, 3.015, 1.0, Even, false, HALF),
        (PlaneStress, BondBased, 4.015, 1.0, Bare, false, WHOLE),
        (PlaneStress, StateBased, 4.015, 1.0, Bare, false, WHOLE),
        (PlaneStrain, BondBased, 4.015, 1.0, Bare, false, WHOLE),
        (Solid, BondBased, 3.015, 1.5, Bare, false, HALF),
    ]
    .into_iter()
    .map(|(space, law, horizon, spacing, correction, by_work, speed)| {
        let plate = Plate { space, law, horizon, spacing, correction, by_work, speed };
        plate
            .variant()
            .quick_if((law, horizon, correction) == (BondBased, 3.015, Bare) && space == PlaneStress)
            .judged(move |run, _| judged(&plate, run))
    })
    .collect()
}

impl Plate {
    fn grid(&self) -> String {
        let space = match self.space {
            Space::Solid => "in space",
            Space::PlaneStress => "plane stress",
            Space::PlaneStrain => "plane strain",
        };
        let corrected = if self.correction == Correction::Even { ", corrected" } else { "" };
        let criterion = if self.by_work { ", by work" } else { "" };
        let Self { horizon, spacing, speed, .. } = self;
        format!("{space}, {spacing} mm, δ/Δx {horizon}, {speed} m/s{corrected}{criterion}")
    }

    fn variant(&self) -> Variant {
        let dx = 1e-3 * self.spacing;
        let [depth, high, thick] = SIZE;
        let solid = self.space == Space::Solid;
        let block = if solid {
            format!("{{ lengths = [{depth}, {high}, {thick}], spacing = {dx} }}")
        } else {
            format!("{{ lengths = [{depth}, {high}], thickness = {thick}, spacing = {dx} }}")
        };
        let cracks = HEIGHTS.map(|y| {
            if solid {
                let corners =
                    format!("[[0.0, {y}, -1.0], [{NOTCH}, {y}, -1.0], [{NOTCH}, {y}, 1.0], [0.0, {y}, 1.0]]");
                format!("{{ corners = {corners} }}")
            } else {
                format!("{{ from = [0.0, {y}], to = [{NOTCH}, {y}] }}")
            }
        });
        let poisson = if self.law == Law::BondBased { self.space.pairwise_poisson() } else { 0.3 };
        let by = if self.by_work { "work" } else { "stretch" };
        let bonds = formulation(self.space, self.law, self.correction);
        let bonds = said(&Formulation { horizon: self.horizon, ..bonds });
        let struck = format!("{{ min = [0.0, {}, 0.0], max = [{dx}, {}, {thick}] }}", HEIGHTS[0], HEIGHTS[1]);
        let scene = Variant::scene(method(self.law), SCENE, self.grid())
            .set("bodies.plate.solid.geometry.block", block)
            .set("bodies.plate.solid.cracks", format!("[{}]", cracks.join(", ")))
            .set("bodies.plate.solid.material.elastic.poisson", poisson)
            .set("bodies.plate.solid.formulation", bonds)
            .set("bodies.plate.solid.fracture", format!("{{ energy = {ENERGY}, by = \"{by}\" }}"))
            .set("sets.struck.box", struck)
            .set("supports[0].moved.by", self.speed * DURATION)
            .set("analysis.explicit.transient.record_every", 5e-6)
            .set("curve[0].take", "\"mean\"")
            .set("curve[+]", "{ name = \"pieces\", of = \"pieces\", on = \"all\" }");
        let margin = self.horizon * dx;
        watched(scene, &[(ANGLE, "°"), (OTHER, "°"), (FIT, "°"), (LENGTH, "mm")], move |march| {
            let [below, above] = [0, 1].map(|side| {
                let y = HEIGHTS[side];
                let outward = |x: &Vec3| if side == 0 { y - x.y } else { x.y - y };
                let zone = |x: &Vec3| outward(x) > 0.0 && x.x > NOTCH - margin && x.x < SIZE[0] - margin;
                direction(march.body(), Vec3::new(NOTCH, y, 0.0), 0.04, zone)
            });
            Ok(Continue(vec![below[1], above[1], below[2], 1e3 * below[0]]))
        })
    }
}

fn judged(plate: &Plate, run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (one, other) = (run.last(ANGLE)?, run.last(OTHER)?);
    let apart = one.zip(other).map(|(one, other)| one - other);
    let asked = plate.speed == HALF;
    let mut metrics = if asked {
        let symmetric = "the plate and the blow are symmetric";
        let seen = "by the chord, as seen in the experiment";
        let mut metrics = between(ANGLE, one, "°", [62.0, 71.0], seen, None);
        metrics.push(Metric::error("between the notches", apart, "°").within(0.5, symmetric));
        metrics
    } else {
        let reason = "the whole speed on the edge shatters the plate: the farthest node is no tip of a crack";
        vec![
            Metric::compared(ANGLE, one, "°", 67.0).shown(reason),
            Metric::error("between the notches", apart, "°").shown(reason),
        ]
    };
    metrics.extend([
        figure(run, FIT, "°")?.shown("near the notch the cracks run flatter"),
        figure(run, LENGTH, "mm")?.shown("from the tip of a notch to the farthest damaged node"),
        Metric::error("mean damage", run.last("damage")?.map(|part| 100.0 * part), "%")
            .shown("what part of all bonds broke, by volume"),
        Metric::error("energy of broken bonds", run.last("broken")?, "J")
            .shown("energy that the broken bonds held"),
        Metric::error("fragments", run.last("pieces")?, "-").shown("pieces that no whole bond joins"),
        Metric::error("balance", Some(run.outcome.balance), "%")
            .near(0.9, "bonds that break are recorded in the middle of a step"),
    ]);
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut points = [Vec::new(), Vec::new()];
    for (number, run) in runs.iter().enumerate() {
        if run.variant.grid.contains("16.5") {
            points[usize::from(!run.is(PAIRWISE))]
                .extend(run.last(ANGLE)?.map(|angle| (number as f64, angle)));
        }
    }
    let [pairwise, state] = points;
    let last = runs.iter().len() as f64;
    Ok(vec![Figure::Chart(Chart {
        title: "Angle of the cracks at 16.5 m/s".into(),
        caption: "By the chord, in the order of the table; between the lines is what is asked.".into(),
        x: Axis::linear("number of the run"),
        y: Axis::linear("angle [°]").between(55.0, 75.0),
        series: vec![
            Series::marks("bonds alone", pairwise, SKY, Mark::Disc),
            Series::marks("bonds with a dilatation", state, VERMILION, Mark::Square),
            Series::line("62°", vec![(0.0, 62.0), (last, 62.0)], GREY, Line::Dashed),
            Series::line("71°", vec![(0.0, 71.0), (last, 71.0)], GREY, Line::Dashed),
        ],
    })])
}
