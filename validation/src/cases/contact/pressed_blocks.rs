//! pressed-blocks: drums and a ball pressed on blocks, Hertz's contacts.
//!
//! ```text
//!     ╭──╮
//!     ╰──╯  ↓
//!   ▓▓▓▓▓▓▓▓▓▓
//!   ▓▓▓▓▓▓▓▓▓▓
//! ```

use benchmarks_ref::pressed::{Block, Pressed};

use crate::cases::galerkin::INCREMENTS;
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, GREEN, Line, ORANGE, SKY, Series, VERMILION};
use crate::judge::{Case, Headline, Measured, Run, Runs, Variant};
use crate::methods::PAIRWISE;
use crate::{JudgeError, Metric};

const WITHOUT_ELEMENTS: &str = include_str!("../../../../scenes/drum-on-block.toml");
const OF_BONDS: &str = include_str!("../../../../scenes/drum-on-bonds.toml");
const PRESSURE: &str = "greatest error of the greatest pressure";
const FORCE: &str = "greatest error of the force at an approach";
const WIDTH: &str = "greatest error of the half width";
/// Half widths over the spacing from which errors count, without bonds and with.
const FROM: [f64; 2] = [1.5, 2.0];
const BALL: &str = "[{ name = \"ball\", sphere = { centre = [0.0, 0.0, 11.0], radius = 10.0 }, moved = [0.0, 0.0, -0.006] }]";

/// Errors of the greatest pressure \[%\].
const OF_PRESSURE: Measured = Measured(&[
    (INCREMENTS, &[("10 cells", 3.7), ("20 cells", 2.2), ("a ball, 10 cells", 4.6)]),
    (PAIRWISE, &[("20 cells, horizon 3", 6.0), ("25 cells, horizon 3", 7.7), ("25 cells, horizon 2", 2.5)]),
]);
/// Errors of the force at an approach \[%\].
const OF_FORCE: Measured = Measured(&[
    (INCREMENTS, &[("10 cells", 1.3), ("20 cells", 1.2), ("a ball, 10 cells", 1.6)]),
    (PAIRWISE, &[("20 cells, horizon 3", 0.9), ("25 cells, horizon 3", 1.9), ("25 cells, horizon 2", 1.1)]),
]);
/// Errors of the half width \[%\].
const OF_WIDTH: Measured = Measured(&[
    (INCREMENTS, &[("10 cells", 13.3), ("20 cells", 6.4)]),
    (PAIRWISE, &[("20 cells, horizon 3", 7.5), ("25 cells, horizon 3", 8.5), ("25 cells, horizon 2", 1.9)]),
]);

/// A tool on a block of the scene.
#[derive(Debug)]
struct Setup {
    method: &'static str,
    grid: &'static str,
    /// Spacings in height.
    cells: u32,
    /// Horizon of bonds in spacings.
    reach: Option<u32>,
    round: Round,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Round {
    Drum,
    Ball,
}

const SETUPS: [Setup; 6] = [
    Setup { method: INCREMENTS, grid: "10 cells", cells: 10, reach: None, round: Round::Drum },
    Setup { method: INCREMENTS, grid: "20 cells", cells: 20, reach: None, round: Round::Drum },
    Setup { method: INCREMENTS, grid: "a ball, 10 cells", cells: 10, reach: None, round: Round::Ball },
    Setup { method: PAIRWISE, grid: "20 cells, horizon 3", cells: 20, reach: Some(3), round: Round::Drum },
    Setup { method: PAIRWISE, grid: "25 cells, horizon 3", cells: 25, reach: Some(3), round: Round::Drum },
    Setup { method: PAIRWISE, grid: "25 cells, horizon 2", cells: 25, reach: Some(2), round: Round::Drum },
];

/// The scenes, their closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "pressed-blocks",
        title: "Drums and a ball pressed on blocks",
        about: "A rigid drum comes down on a block in plane strain, of a Galerkin solid at rest and of bonds in a quasi-static march, and a ball on a \
                Galerkin block: greatest pressure, force and half width at the same approach, from half widths of one and a half spacings on, of \
                bonds two. The half width is that of the moment of the forces about the middle.",
        citation: "Hertz 1882, corrected for block and images by waves of a layer on a smooth base",
        variants: SETUPS.iter().map(Setup::variant).collect(),
        each,
        headline: Some(Headline::new(PRESSURE, 0.1)),
        figures,
        ..Case::default()
    }
}

impl Setup {
    fn of(run: &Run) -> Option<&'static Self> {
        SETUPS.iter().find(|setup| run.is(setup.method) && run.variant.grid == setup.grid)
    }

    fn spacing(&self) -> f64 {
        1.0 / f64::from(self.cells)
    }

    /// Length of the block along the drum: a cell, or as many spacings as the planes of symmetry of bonds are to lie apart.
    fn along(&self) -> f64 {
        match (self.round, self.reach) {
            (Round::Ball, _) => 1.0,
            (Round::Drum, None) => self.spacing(),
            (Round::Drum, Some(_)) => 3.0 * self.spacing(),
        }
    }

    fn variant(&self) -> Variant {
        let scene = if self.reach.is_some() { OF_BONDS } else { WITHOUT_ELEMENTS };
        let variant = Variant::scene(self.method, scene, self.grid)
            .set("bodies.block.solid.geometry.block.lengths", format!("[1.0, {:?}, 1.0]", self.along()))
            .set("bodies.block.solid.geometry.block.spacing", format!("{:?}", self.spacing()));
        match (self.round, self.reach) {
            (Round::Ball, _) => {
                variant.set("bodies.block.solid.tools", BALL).set("analysis.static.levels", "3")
            }
            (_, Some(reach)) => {
                variant.set("bodies.block.solid.formulation.bond-based.horizon", format!("{reach}.015"))
            }
            _ => variant,
        }
    }

    fn block(&self) -> Block {
        let poisson = if self.reach.is_some() { 0.25 } else { 0.3 };
        Block { young: 2.1e11, poisson, length: 1.0, height: 1.0, radius: 10.0 }
    }

    /// What the closed form has when the tool has come a part of its way.
    fn exact(&self, level: f64) -> Pressed {
        match (self.round, self.reach) {
            (Round::Ball, _) => self.block().at(0.006 * level, Block::under_ball),
            (_, None) => self.block().at(0.0033 * level, Block::under_drum),
            (_, Some(_)) => self.block().at(0.005 * level, Block::under_drum),
        }
    }

    fn from(&self) -> f64 {
        FROM[usize::from(self.reach.is_some())]
    }

    /// The part of the contact that the scene has, times the length along a drum.
    fn part(&self) -> f64 {
        match self.round {
            Round::Ball => 0.25,
            Round::Drum => 0.5 * self.along(),
        }
    }
}

/// Behind each level the closed form at its approach and what was found, where the contact is wide enough.
fn levels(run: &Run, setup: &Setup) -> Result<Vec<(f64, [Pressed; 2])>, JudgeError> {
    let [level, force, moment, pressure] = ["level", "P", "M", "p"].map(|name| run.column(name));
    let (level, force, moment, pressure) = (level?, force?, moment?, pressure?);
    let found = (0..level.len()).filter(|&i| level[i] > 0.0).map(|i| {
        let exact = setup.exact(level[i]);
        // Half of an ellipse of pressures has its centre at 4a/3π.
        let half = 0.75 * std::f64::consts::PI * (moment[i] / force[i]).abs();
        let found =
            Pressed { half, force: force[i] / setup.part(), pressure: pressure[i], approach: exact.approach };
        (level[i], [exact, found])
    });
    Ok(found.filter(|(_, [exact, _])| exact.half >= setup.from() * setup.spacing()).collect())
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let Some(setup) = Setup::of(run) else { return Ok(Vec::new()) };
    let known = levels(run, setup)?;
    let worst = |name: &str, of: fn(&Pressed) -> f64| {
        let errors = known.iter().filter(|_| run.done());
        let errors = errors.map(|(level, [exact, found])| (*level, 100.0 * (of(found) / of(exact) - 1.0)));
        Metric::greatest(name, errors.map(|(level, error)| (level, Some(error))), "%")
    };
    let reason = "a contact of few spacings; bonds feel no surface nearer than their horizon";
    let mut metrics = vec![
        worst(PRESSURE, |of| of.pressure).near(OF_PRESSURE.of(run)?, reason),
        worst(FORCE, |of| of.force).near(OF_FORCE.of(run)?, reason),
    ];
    if setup.round == Round::Drum {
        metrics.push(worst(WIDTH, |of| of.half).near(OF_WIDTH.of(run)?, reason));
    }
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let looks = [GREEN, BLUE, VERMILION, ORANGE, SKY];
    let scaled = |block: &Block, of: &Pressed| {
        let modulus = block.plane_modulus();
        (1e4 * of.force / (modulus * block.radius), 100.0 * of.pressure / modulus)
    };
    let mut series = Vec::new();
    for run in runs.iter() {
        let Some(setup) = Setup::of(run).filter(|setup| setup.round == Round::Drum) else { continue };
        let block = setup.block();
        if series.is_empty() {
            let forms = (1..=50).map(|i| scaled(&block, &block.under_drum(0.0045 * f64::from(i))));
            series.push(Series::line("Hertz, on a block", forms.collect(), BLACK, Line::Dashed));
        }
        let points = levels(run, setup)?.iter().map(|(_, [_, found])| scaled(&block, found)).collect();
        let look = looks[series.len() % looks.len()];
        series.push(Series::line(&run.variant.grid, points, look, Line::Solid));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Greatest pressure under a drum".into(),
        caption: "The force P of a unit of length and the greatest pressure p, E* = E/(1 − ν²).".into(),
        x: Axis::linear("10⁴ P/(E* R)"),
        y: Axis::linear("100 p/E*"),
        series,
    })])
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use coque::{Scene, Silent};

    use super::*;

    /// Errors \[%\] of pressure, force and half width under a drum at many levels, with the rows of nodes that touch, from the rim to the middle, by their
    /// area.
    fn errors(setup: &Setup, support: &str) -> Vec<(u32, [f64; 3])> {
        let (along, spacing) = (setup.along(), setup.spacing());
        let (scene, levels, way) = match setup.reach {
            None => (WITHOUT_ELEMENTS, "analysis.static.levels", 0.0066),
            Some(_) => (OF_BONDS, "analysis.explicit.quasi-static.levels", 0.008),
        };
        let method = match setup.reach {
            None => ("bodies.block.solid.formulation.galerkin.support.ellipsoid", support.into()),
            Some(reach) => ("bodies.block.solid.formulation.bond-based.horizon", format!("{reach}.015")),
        };
        let block = format!("{{ lengths = [1.0, {along:?}, 1.0], spacing = {spacing:?} }}");
        let set = [
            (levels, "14".into()),
            ("bodies.block.solid.tools.0.moved", format!("[0.0, 0.0, -{way:?}]")),
            ("bodies.block.solid.geometry.block", block),
            ("curve[+]", "{ name = \"touching\", of = \"touching-area\", on = \"block.all\" }".into()),
            method,
        ];
        let pairs: Vec<(String, String)> = set.into_iter().map(|(key, value)| (key.into(), value)).collect();
        let outcome =
            Scene::with_overrides(scene, "drum", &pairs).unwrap().build(1).unwrap().run(&mut Silent);
        let column = |name: &str| outcome.curve.column(name).unwrap();
        let [level, force, moment, pressure, area] = ["level", "P", "M", "p", "touching"].map(column);
        let block = setup.block();
        // Of a row on the plane of symmetry half is there.
        let half_row = if setup.reach.is_none() { 0.5 } else { 0.0 };
        let state = |i: usize| {
            let exact = block.at(way * level[i], Block::under_drum);
            let rows = (area[i] / along / spacing + half_row).round() as u32;
            let half = 0.75 * std::f64::consts::PI * (moment[i] / force[i]).abs();
            let off = |found: f64, exact: f64| 100.0 * (found / exact - 1.0);
            let force = off(force[i] / setup.part(), exact.force);
            (rows, [off(pressure[i], exact.pressure), force, off(half, exact.half)])
        };
        (1..level.len()).map(state).collect()
    }

    /// The table of docs/contact.md with `ROWS=all`, its coarsest blocks without; from the rows that a contact wants on pressures are right to 3 %.
    #[test]
    fn rows_of_a_contact_and_what_they_are_off() {
        let galerkin = |cells| Setup { method: INCREMENTS, grid: "", cells, reach: None, round: Round::Drum };
        let bonds = |reach| move |cells| Setup { reach: Some(reach), ..galerkin(cells) };
        let setups: [(&str, &str, u32, Vec<Setup>); 5] = [
            ("support 1.2", "1.2", 5, [8, 14, 20].map(galerkin).into()),
            ("support 1.5", "1.5", 4, [8, 10, 14, 20].map(galerkin).into()),
            ("support 2.0", "2.0", 3, [8, 14].map(galerkin).into()),
            ("horizon 2", "", 3, [16, 20, 25, 32].map(bonds(2)).into()),
            ("horizon 3", "", 5, [16, 20, 25, 32].map(bonds(3)).into()),
        ];
        let all = std::env::var_os("ROWS").is_some();
        for (name, support, wanted, setups) in setups {
            let some = if all { setups.len() } else { 1 };
            let mut greatest: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
            for (rows, errors) in setups.iter().take(some).flat_map(|setup| errors(setup, support)) {
                let known = greatest.entry(rows).or_default();
                (0..3).for_each(|k| known[k] = known[k].max(errors[k].abs()));
            }
            assert!(greatest.len() > 1, "{name}: {greatest:?}");
            for (rows, [pressure, force, half]) in greatest {
                println!(
                    "{name}: {rows} rows: pressure {pressure:.1}, force {force:.1}, half width {half:.1} %"
                );
                assert!(rows < wanted || pressure < 3.0, "{name}: {rows} rows, {pressure}");
            }
        }
    }
}
