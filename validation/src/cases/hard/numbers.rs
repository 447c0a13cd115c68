//! numbers: far from the origin, in units nine powers of ten away, and under loads too small for squares.

use std::time::Instant;

use explicit_dynamics::{Amplitude, Clock, LANCZOS_STEPS, largest_eigenvalue};
use nalgebra::Rotation3;
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{EndWeights, Plate, Side, Vec3, lattice};
use sph_shell::{AppliedLoad, Clamped, Force, Formulation, Parts, Shell, Supported};

use crate::Outcome;
use crate::judge::measure::largest;
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::methods::{CELL, STATIC};
use crate::support::scenes;
use crate::support::studies::{ENERGY, SHOWN, figure, march, outcome, shell};
use crate::{JudgeError, Metric};

const LENGTH: f64 = 10.0;
/// Powers of ten of length, force and time.
const UNITS: [[i32; 3]; 6] = [[9, 0, 0], [-9, 0, 0], [0, 9, 0], [0, -9, 0], [0, 0, 9], [0, 0, -9]];
const OFF: &str = "off the usual answer";

pub fn case() -> Case {
    Case {
        name: "numbers",
        title: "Far from the origin, in strange units, under denormal loads",
        about: "A cantilever of L/t = 100 under a sudden end force, a quarter of a period, 10⁶ lengths from the origin against the \
                same at the origin; the ring's strip at half the moment in units of length, force or time that differ by 10⁹; a \
                force of 1e-300 of the usual one. Differences in parts of the tip's displacement.",
        citation: "reference: the same body at the origin, in usual units",
        variants: variants(),
        headline: Some(Headline::new(OFF, 1e-12)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for method in ENERGY {
        let any = Variant::new(method, scenes::RING, "plate", [25, 3]);
        let formulation = move || shell(&any).map(|shell| *shell.formulation());
        let other = formulation.clone();
        let offset = Variant::study(method, "25×3 at 10⁶ lengths", move || offset(formulation()?));
        let denormal = Variant::study(method, "25×3 force 1e-300", move || denormal(other()?));
        variants.extend([offset.judged(far_off), denormal.judged(hardly_loaded)]);
    }
    for method in [CELL, STATIC] {
        variants.push(in_units(method, [0; 3]).quick());
        variants.extend(UNITS.map(|powers| in_units(method, powers).quick()));
    }
    variants
}

/// The strip at half the moment, numbers as they read in other units.
fn in_units(method: &str, powers: [i32; 3]) -> Variant {
    let [l, f, t] = powers.map(|power| 10.0_f64.powi(power));
    let strip = Variant::new(method, scenes::RING, "plate", [25, 3])
        .set("geometry.plate.lengths", format!("[{:e}, {:e}]", LENGTH * l, l))
        .set("material.elastic.young", format!("{:e}", 1200.0 * f / (l * l)))
        .set("material.elastic.density", format!("{:e}", f * t * t / (l * l * l * l)))
        .set("section.homogeneous.thickness", format!("{l:e}"))
        .set("loads[0].couple.moment", format!("{:e}", 20.0 * std::f64::consts::PI * f * l));
    let strip = if method == STATIC {
        strip.set("analysis.static.levels", "[0.25, 0.5]")
    } else {
        strip
            .set("analysis.explicit.quasi-static.levels", "[0.5]")
            .set("analysis.explicit.quasi-static.period", format!("{:e}", 17.9 * t))
    };
    strip.on(&units(powers)).judged(move |run, runs| scaled(run, runs, powers[0]))
}

fn units([length, force, time]: [i32; 3]) -> String {
    format!("units 1e{length}, 1e{force}, 1e{time}")
}

/// A clamped strip far away, under an end force across.
fn strip(formulation: Formulation, shift: &Vec3, force: f64) -> Result<Shell, String> {
    let near = lattice(&Plate { lengths: [LENGTH, 1.0] }, [25, 3], EndWeights::Trapezoid)
        .map_err(|e| e.to_string())?;
    let cloud = near.transformed(&Rotation3::identity(), shift);
    let edge = |side| near.sides.as_ref().map(|sides| sides.edge(side).to_vec()).unwrap_or_default();
    let material = Isotropic::new(1200.0, 0.0).map_err(|e| e.to_string())?;
    let section = IsotropicSection::new(material, 0.1).map_err(|e| e.to_string())?;
    let shares = edge(Side::U1).into_iter().map(|a| (a, near.edge_lengths[a as usize])).collect();
    Shell::builder(Parts {
        cloud,
        section: Box::new(section),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation,
        supports: vec![Supported { particles: edge(Side::U0), support: Box::new(Clamped) }],
        loads: vec![AppliedLoad {
            load: Box::new(Force { shares, total: Vec3::z() * force }),
            amplitude: Amplitude::Constant,
        }],
        threads: 1,
    })
    .build()
    .map_err(|e| e.to_string())
}

/// `PL²/EI = 1`: at rest the tip would stand three tenths of the length up.
const USUAL: f64 = 1.0 * 1200.0 * (0.1 * 0.1 * 0.1 / 12.0) / (LENGTH * LENGTH);

/// A quarter of a period of the lowest mode, undamped; the force is there at once.
const STEPS: u64 = 5000;

fn swing(shell: &mut Shell, steps: u64) -> Result<(), String> {
    let mut clock = Clock::start(shell, 1.0, 0.8, 0.0).map_err(|e| e.to_string())?;
    // The same step for both bodies: the estimates differ in their last digits.
    clock.dt = 0.8 * shell.reference().cloud.spacing() / shell.reference().sound_speed / 2.0;
    march(&mut clock, shell, [10, steps / 10], |_, _| {}).map_err(|e| e.to_string())
}

fn offset(formulation: Formulation) -> Result<Outcome, String> {
    let started = Instant::now();
    let mut near = strip(formulation, &Vec3::zeros(), USUAL)?;
    // No round numbers: those could be free of rounding.
    let mut far = strip(formulation, &(Vec3::new(0.6, -0.35, 0.72) * (1e6 * LENGTH * 1.0123456789)), USUAL)?;
    let spectrum = |shell: &mut Shell| largest_eigenvalue(shell, LANCZOS_STEPS).bound();
    let step = (spectrum(&mut far) / spectrum(&mut near) - 1.0).abs();
    swing(&mut near, STEPS)?;
    swing(&mut far, STEPS)?;
    let tip = (0..near.len()).map(|a| near.displacement(a).norm()).fold(0.0, f64::max);
    let apart = (0..near.len()).map(|a| (near.displacement(a) - far.displacement(a)).norm());
    let worst = apart.fold(0.0, f64::max) / tip;
    let figures = [(OFF, "-", worst), ("stable step, off", "-", step), ("tip", "L", tip / LENGTH)];
    Ok(outcome(&near, 2 * STEPS, started, &figures, None))
}

fn denormal(formulation: Formulation) -> Result<Outcome, String> {
    let started = Instant::now();
    let mut shell = strip(formulation, &Vec3::zeros(), 1e-300 * USUAL)?;
    swing(&mut shell, STEPS / 5)?;
    shell.evaluate_internal(true);
    let tip = (0..shell.len())
        .map(|a| shell.displacement(a).norm())
        .fold(0.0, |m: f64, u| if u.is_finite() { m.max(u) } else { f64::MAX });
    let figures = [(OFF, "-", tip / LENGTH), ("strain energy", "-", shell.stored_energy())];
    Ok(outcome(&shell, STEPS / 5, started, &figures, None))
}

fn far_off(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    Ok(vec![
        figure(run, OFF, "-")?.within(
            1e-6,
            "1e-6; positions of 10⁷ keep 1e-9, which each step rounds anew: 3e-8 to 7e-8 is left after 5000",
        ),
        figure(run, "stable step, off", "-")?.shown(
            "differences of forces at perturbations of 1e-5 spacings: 1e-9 of a position is 1e-4 of those",
        ),
        figure(run, "tip", "L")?.shown(SHOWN),
    ])
}

fn hardly_loaded(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    Ok(vec![
        figure(run, OFF, "-")?.within(
            1e-13,
            "below the rounding of positions no displacement can be kept; what is asked is that nothing else appears",
        ),
        figure(run, "strain energy", "-")?.shown(SHOWN),
    ])
}

/// Tip and rotation in a system of units against the usual one; `length` is the power of ten of the unit of length.
fn scaled(run: &Run, runs: &Runs, length: i32) -> Result<Vec<Metric>, JudgeError> {
    let Some(usual) = runs.get(&run.variant.method, &format!("25×3 {}", units([0; 3])))? else {
        return Ok(Vec::new());
    };
    let mut off = Vec::new();
    for (name, unit) in
        [("minus_U_tip", 10.0_f64.powi(length)), ("W_tip", 10.0_f64.powi(length)), ("rotation_tip", 1.0)]
    {
        let (here, there) = (run.at(name, 0.5)?, usual.at(name, 0.5)?);
        off.push(here.zip(there).map(|(here, there)| (here / unit / there - 1.0).abs()));
    }
    let reason = "results scale exactly in shape, to 1e-6";
    Ok(vec![Metric::error(OFF, largest(off), "-").within(1e-6, reason)])
}
