//! dropped: what is thrown on a tool, a plate or a column, and what it feels.
//!
//! ```text
//!    ▓▓▓  ↓       ●  ↓        ▄▄▄  ↓
//!    ▓▓▓        ━━━━━━━       ▐▓▌
//!   ▔▔▔▔▔                     ▔▔▔
//! ```

use benchmarks_ref::impact::{struck_bar, velocity_on_a_plate};

use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, Line, Series};
use crate::judge::{Case, Headline, Measured, Run, Runs, Variant};
use crate::methods::{CELL, PAIRWISE};
use crate::{JudgeError, Metric};

const BLOCK: &str = include_str!("../../../../scenes/block-on-flat.toml");
const BALL: &str = include_str!("../../../../scenes/ball-on-plate.toml");
const MASS: &str = include_str!("../../../../scenes/mass-on-column.toml");
const RESTITUTION: &str = "restitution";
const PRESSED: &str = "force while the wave runs";
const SLOWED: &str = "greatest error of the velocity";
const MOMENTUM: &str = "momentum gained";
/// Impact velocities, mass on the column, its density times area \[m/s, kg, kg/m\].
const SPEED: [f64; 2] = [27.386, 10.0];
const STRIKING: f64 = 960.0;
const LINE: f64 = 320.0;
/// Height \[m\] and speed of waves \[m/s\] of block and column.
const HEIGHT: f64 = 1.0;
const WAVE: f64 = 5477.2256;
/// Gap at the start \[m\].
const GAP: f64 = 1e-4;
/// Velocity of the ball \[m/s\], Z/M of the plate \[1/s\].
const THROWN: f64 = 0.02;
const IMPEDANCE: f64 = 191.838;
const ON_PLATE: &str = "ball on a wide plate";
const ON_COLUMN: &str = "mass on a column of bonds";

/// Errors of the restitution \[%\].
const OF_RESTITUTION: Measured = Measured(&[(PAIRWISE, &[(ON_COLUMN, 0.11)])]);
/// Errors of the velocity \[% of that of the impact\].
const OF_SPEED: Measured = Measured(&[(CELL, &[(ON_PLATE, 2.7)]), (PAIRWISE, &[(ON_COLUMN, 3.3)])]);

/// The scenes, their closed forms, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "dropped",
        title: "Impacts of a block, a ball and a mass",
        about: "A block of bonds falls flat on a rigid flat, at .005 of the speed of its waves, and leaves as it came when its wave is back. A rigid ball is \
                slowed by a wide plate as by a dashpot, until waves come back. A rigid mass hits a column of bonds, whose waves push it off.",
        citation: "Saint-Venant's longitudinal impact; the point impedance of a plate by Cremer and Heckl",
        variants: vec![
            Variant::scene(PAIRWISE, BLOCK, "block of bonds on a flat").judged(|run, _| block(run)),
            Variant::scene(CELL, BALL, ON_PLATE).judged(|run, _| ball(run)),
            Variant::scene(PAIRWISE, MASS, ON_COLUMN).judged(|run, _| mass(run)),
        ],
        headline: Some(Headline::new(SLOWED, 0.1)),
        figures,
        ..Case::default()
    }
}

/// The velocity at the end over that of the impact, against one; the force about the middle of the contact, against ρ c v A.
fn block(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let rebound = run.last("v")?.map(|v| v / SPEED[0]);
    let (time, force) = (run.column("time")?, run.column("F")?);
    let whole = LINE * WAVE * SPEED[0];
    let touched = GAP / SPEED[0];
    // The middle half of the time in which the wave runs up and down.
    let inside = |t: f64| (t - touched) * WAVE / HEIGHT > 0.5 && (t - touched) * WAVE / HEIGHT < 1.5;
    let forces = time.iter().zip(&force).filter(|(t, _)| inside(**t)).map(|(_, force)| force / whole);
    let worst = forces.map(|force| 100.0 * (force - 1.0).abs()).reduce(f64::max).filter(|_| run.done());
    let reason = "waves of few spacings run behind the front and stay in the block";
    Ok(vec![
        Metric::compared(RESTITUTION, rebound, "-", 1.0).within(0.005, format!("measured .0018; {reason}")),
        Metric::error(PRESSED, worst, "%").near(1.3, reason),
    ])
}

/// The velocity until waves are back from the edges, against that of a dashpot.
fn ball(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let reason =
        "contact and the cells below the ball give, so that it is slowed later in the first milliseconds";
    let worst = slowed(run)?.into_iter().map(|[_, found, exact]| 100.0 * (found - exact).abs());
    let worst = worst.reduce(f64::max).filter(|_| run.done());
    Ok(vec![Metric::error(SLOWED, worst, "% of the impact's").near(OF_SPEED.of(run)?, reason)])
}

/// Times, velocities over that of the impact and those of the closed form, on a wide plate.
fn slowed(run: &Run) -> Result<Vec<[f64; 3]>, JudgeError> {
    let rows = run.column("time")?.into_iter().zip(run.column("velocity")?);
    let rows = rows.filter(|(time, _)| *time < 2.1e-2);
    Ok(rows.map(|(t, v)| [IMPEDANCE * t, -v / THROWN, velocity_on_a_plate(IMPEDANCE * t)]).collect())
}

/// Times c t/L since the impact, velocities over that of the impact and those of the closed form, on a column.
fn pushed(run: &Run) -> Result<Vec<[f64; 3]>, JudgeError> {
    let exact = struck_bar(LINE * HEIGHT / STRIKING);
    let rows = run.column("time")?.into_iter().zip(run.column("v")?);
    let found = rows.map(|(time, v)| {
        let own = (time - GAP / SPEED[1]) * WAVE / HEIGHT;
        let place = exact.partition_point(|[time, _]| *time <= own).clamp(1, exact.len());
        [own, -v / SPEED[1], exact[place - 1][1]]
    });
    Ok(found.filter(|[time, ..]| *time >= 0.0).collect())
}

fn mass(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let rows = pushed(run)?;
    let worst = rows.iter().map(|[_, found, exact]| 100.0 * (found - exact).abs()).reduce(f64::max);
    let last = rows.last().map(|[_, found, exact]| (-found, -exact)).filter(|_| run.done());
    let forces = run.column("F")?.into_iter().zip(run.column("F_column")?);
    let (mut gained, mut greatest) = (0.0_f64, 0.0_f64);
    for (force, other) in forces {
        (gained, greatest) = (gained.max((force + other).abs()), greatest.max(force.abs()));
    }
    let reason = "fronts of waves are some spacings long";
    let exact = last.map_or(1.0, |(_, exact)| exact);
    Ok(vec![
        Metric::compared(RESTITUTION, last.map(|(found, _)| found), "-", exact)
            .near(OF_RESTITUTION.of(run)?, reason),
        Metric::error(SLOWED, worst.filter(|_| run.done()), "% of the impact's")
            .near(OF_SPEED.of(run)?, reason),
        Metric::error(MOMENTUM, Some(gained / greatest).filter(|_| run.done()), "of the greatest force")
            .within(1e-12, "one force on both, to rounding"),
    ])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut all = Vec::new();
    for run in runs.iter() {
        let (title, x, rows) = match run.variant.grid.as_str() {
            ON_PLATE => ("A ball on a wide plate", "Z t/M", slowed(run)?),
            ON_COLUMN => ("A mass on a column", "c t/L", pushed(run)?),
            _ => continue,
        };
        let curve = |place: usize| rows.iter().map(|row| (row[0], row[place])).collect::<Vec<_>>();
        all.push(Figure::Chart(Chart {
            title: title.into(),
            caption: "Velocity over that of the impact.".into(),
            x: Axis::linear(x),
            y: Axis::linear("v/v₀"),
            series: vec![
                Series::line("closed form", curve(2), BLACK, Line::Dashed),
                Series::line(&run.variant.method, curve(1), BLUE, Line::Solid),
            ],
        }));
    }
    Ok(all)
}
