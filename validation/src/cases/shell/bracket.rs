//! bracket: a bent sheet with a hole and a flange under pressure on one of its faces, and its frequencies.

use std::f64::consts::FRAC_PI_4;

use benchmarks_ref::reference;
use implicit_statics::{Equilibrium, linear_response, natural_modes, unwatched};
use sph_core::{Cloud, Vec3};
use sph_shell::{Clamped, Pressure, PressurePatch, Shell, StaticShell};

use crate::judge::measure::largest;
use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::metric_names::ERROR;
use crate::support::meshes::{Mesh, nearest, particles};
use crate::support::sheets::{MaterialSection, shell_of, supported};
use crate::support::studies::{finding, or_failed};
use crate::{JudgeError, Metric, Outcome};

const TABLE: &str = "calculix_bracket";

/// The problem, its reference, and how far the two may differ.
pub fn case() -> Case {
    let study = |grid: &str, n: usize| Variant::study(STATIC, grid, move || Ok(or_failed(bracket(n))));
    Case {
        name: "bracket",
        title: "Bracket with a hole and a flange",
        about: "A foot, an upright with a round hole and a flange, one sheet bent at two right angles; the foot is clamped at its far edge. \
                Pressure acts on the upright alone; then the first five frequencies. What a drawing office asks of a program.",
        citation: "eight-node elements S8R of CalculiX on 8 to 64 cells across, extrapolated: they converge at first order at folds",
        variants: vec![study("8 across", 8).quick(), study("16 across", 16).quick(), study("32 across", 32)],
        each,
        // The elements change by .01 % from one extrapolation to the next.
        headline: Some(Headline::new(ERROR, 0.02)),
        ..Case::default()
    }
}

/// Errors of the displacement and of the worst of five frequencies \[%\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[("8 across", 0.129), ("16 across", 0.040), ("32 across", 0.0047)]),
]);
#[rustfmt::skip] // a paragraph a method
const FREQUENCIES: Measured = Measured(&[
    (STATIC, &[("8 across", 1.36), ("16 across", 0.298), ("32 across", 0.0684)]),
]);

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let table = reference(TABLE)?;
    let last = table.rows.len() - 1;
    let off = |name: &str| -> Result<Option<f64>, JudgeError> {
        let exact = table.number(last, name)?;
        Ok(run.last(name)?.map(|found| 100.0 * (found / exact - 1.0).abs()))
    };
    let frequencies = ["f1", "f2", "f3", "f4", "f5"].map(off).into_iter().collect::<Result<Vec<_>, _>>()?;
    let tip = largest([off("tip x")?, off("tip z")?]);
    let wave = "of second order in the spacing over the wave: the fifth bends the upright and the flange against each other";
    let balance = "rounding of displacements of a millionth, between which forces are read";
    Ok(vec![
        Metric::error(ERROR, tip, "%").near(MEASURED.of(run)?, "of second order in the spacing"),
        Metric::error("worst of five frequencies", largest(frequencies), "%")
            .near(FREQUENCIES.of(run)?, wave),
        Metric::error("reaction less load", run.last("unbalanced")?, "-").within(1e-6, balance),
    ])
}

/// Steel \[mm, N, t\].
const BODY: MaterialSection =
    MaterialSection { young: 2.1e5, poisson: 0.3, thickness: 2.0, density: 7.85e-9 };
/// Width, length of the foot, height of the upright, depth of the flange, radius of the hole \[mm\].
const WIDE: f64 = 80.0;
const FOOT: f64 = 100.0;
const UP: f64 = 120.0;
const FLANGE: f64 = 30.0;
const HOLE: f64 = 20.0;
/// On the upright \[N/mm²\].
const PRESSURE: f64 = 1e-3;

/// The bracket, `n` cells across: the foot in the plane z = 0, the upright in x = 0, the flange away from the foot.
fn cloud(n: usize) -> Result<Cloud, String> {
    let foot = |u: f64, v: f64| Vec3::new(u * FOOT, v * WIDE, 0.0);
    // A quarter of the square round the hole, from its side to the hole.
    let quarter = |k: usize| {
        move |u: f64, v: f64| {
            let at = FRAC_PI_4 * (2.0 * (k as f64 + u) - 3.0);
            let (side, half) = (2.0 * u - 1.0, 0.5 * WIDE);
            let [y, z] = [[side, -1.0], [1.0, side], [-side, 1.0], [-1.0, -side]][k];
            let mix = |out: f64, round: f64| half + (1.0 - v) * half * out + v * HOLE * round;
            Vec3::new(0.0, mix(y, libm::cos(at)), mix(z, libm::sin(at)))
        }
    };
    let [below, right, above, left] = [0, 1, 2, 3].map(quarter);
    let upper = |u: f64, v: f64| Vec3::new(0.0, u * WIDE, WIDE + v * (UP - WIDE));
    let flange = |u: f64, v: f64| Vec3::new(-v * FLANGE, u * WIDE, UP);
    let ring = [n, n / 2];
    Mesh::patches(&[
        ([n * 5 / 4, n], &foot),
        (ring, &below),
        (ring, &right),
        (ring, &above),
        (ring, &left),
        (ring, &upper),
        ([n, n * 3 / 8], &flange),
    ])
    .cloud()
}

/// The bracket under pressure on its upright, along x.
fn shell(cloud: &Cloud, cells: &[u32], side: f64) -> Result<Shell, String> {
    let clamp = supported(particles(cloud, |x| x.x > FOOT - 1e-9), Clamped);
    let pressure = Pressure { value: side * PRESSURE, follower: false };
    let load = PressurePatch { pressure, cells: cells.to_vec(), factors: Vec::new() };
    shell_of(BODY, cloud.clone(), STATIC, vec![clamp], vec![Box::new(load)])
}

/// Part of the load at which the linear answer is read, and less the same: far enough for forces to stand out of rounding.
const STEP: f64 = 1e-2;

fn bracket(n: usize) -> Result<Outcome, String> {
    let cloud = cloud(n)?;
    let at = |c: &u32| cloud.cells[*c as usize].geometry(&cloud.positions);
    let upright = |c: &u32| at(c).normal.x.abs() > 0.9;
    let cells: Vec<u32> = (0..cloud.cells.len() as u32).filter(upright).collect();
    let area: f64 = cells.iter().map(|c| at(c).area).sum();
    let side = cells.first().map_or(1.0, |c| at(c).normal.x.signum());
    let words = |error: implicit_statics::EquilibriumError| error.to_string();

    let mut system = StaticShell::new(shell(&cloud, &cells, side)?);
    let warnings = coque::warnings(system.shell());
    let motion = linear_response(&mut system, 0.0).map_err(words)?;
    let clamp = particles(&cloud, |x| x.x > FOOT - 1e-9);
    let edge = nearest(&cloud, Vec3::new(-FLANGE, 0.5 * WIDE, UP)) as usize;
    let (mut tip, mut bears) = (Vec3::zeros(), Vec3::zeros());
    // On both sides of the unloaded shape, from which the second state lies twice as far as the first.
    for (step, far) in [(STEP, 1.0), (-STEP, 2.0)] {
        system.update(&motion.iter().map(|q| q * step * far).collect::<Vec<f64>>());
        system.evaluate(step);
        tip += system.shell().displacement(edge) / (2.0 * step);
        bears += clamp.iter().map(|&a| system.shell().reaction(a as usize)).sum::<Vec3>() / (2.0 * step);
    }
    let load = Vec3::new(PRESSURE * area, 0.0, 0.0);

    let mut system = StaticShell::new(shell(&cloud, &cells, side)?);
    let modes = natural_modes(&mut system, 0.0, 5, 0.0, &mut unwatched).map_err(words)?.modes;
    let hertz =
        |k: usize| modes.get(k).map_or(f64::NAN, |mode| mode.circular_frequency() / (8.0 * FRAC_PI_4));
    let figures = [
        ("tip x", tip.x),
        ("tip z", tip.z),
        ("unbalanced", (bears + load).norm() / load.norm()),
        ("f1", hertz(0)),
        ("f2", hertz(1)),
        ("f3", hertz(2)),
        ("f4", hertz(3)),
        ("f5", hertz(4)),
    ];
    Ok(Outcome { warnings, ..finding(cloud.len(), cloud.spacing(), &figures) })
}
