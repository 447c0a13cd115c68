//! The linear answer: one factorisation at the unloaded shell, and what is read along it: gauges, stresses, reactions.

use std::array::from_fn;

use implicit_statics::{Equilibrium, linear_response};
use sph_core::Vec3;
use sph_shell::{PointResult, Shell, StaticShell};

use crate::analyses::modes::{keep_shape, scaled};
use crate::analyses::path::energies;
use crate::bodies::probe::Gauge;
use crate::bodies::shell::build::PrescribedPoint;
use crate::fields::LinearForces;
use crate::run::{Ended, Failure, Findings, Progress, ProgressReport};

/// Largest displacement, in thicknesses, of the states between which gauges, stresses and reactions are differentiated.
///
/// A gauge reads `v(ε)` along the motion; the linear value adds to `v(0)` the slope there, by central differences over
/// ε and 2ε: `(4 s(ε) − s(2ε)) / 3` with `s(ε) = (v(ε) − v(−ε)) / 2ε`. Rounding of positions is 2e-16 of the extent
/// over this many thicknesses, and more in forces, where stretching is stiff: the reaction of the Scordelis-Lo roof is
/// off by 1e-7, 1e-8, 6e-10 at 1e-4, 1e-3, 1e-2 thicknesses. One difference alone cuts off the stretch that bending
/// brings about, (displacement over thickness)²: 2e-6 there at 1e-2. The two cut off its square.
const REACH: f64 = 1e-2;

/// Finds the linear answer at level one and reads the curve's one row.
pub(crate) fn linear(
    system: &mut StaticShell,
    driven: Option<PrescribedPoint>,
    mut gauges: Vec<Gauge>,
    found: &mut Findings<'_>,
    progress: &mut dyn Progress,
) {
    let mut goes_on =
        |steps| progress.update(&ProgressReport { steps, ..ProgressReport::default() }).is_continue();
    if !goes_on(0) {
        found.ended = Ended::Interrupted { time: 0.0, level: 0.0 };
        return;
    }
    let response = match linear_response(system, 0.0) {
        Ok(response) => response,
        Err(cause) => {
            found.ended = Ended::Diverged(Failure::Balance { points: 0, level: 0.0, cause, unit: None });
            return;
        }
    };
    // The load that is applied, or the force that brings the prescribed motion about.
    let force = driven.map_or(1.0, |driven| driven.by / driven.moved(system, &response));
    let motion = scaled(&response, force);
    let rest = system.save();
    let largest = largest(system, &motion);
    let step = if largest > 0.0 { REACH * system.shell().thickness() / largest } else { 1.0 };
    let columns: usize = gauges.iter().map(Gauge::part_count).sum();
    let fields = found.frames.is_some();
    let mut read = |system: &mut StaticShell, level: f64| {
        system.restore(&rest);
        system.update(&scaled(&motion, level));
        // The force that brings a prescribed motion about is the reaction that is sought, not a load.
        system.evaluate(if driven.is_some() { 0.0 } else { level });
        let mut values: Vec<f64> = gauges.iter_mut().flat_map(|gauge| gauge.parts(system.shell())).collect();
        if fields {
            read_forces(system.shell(), &mut values);
        }
        values
    };
    // Rotations are counted on from the first reading, at rest.
    let mut readings: [Vec<f64>; 5] = Default::default();
    for (reading, k) in readings.iter_mut().zip([0.0, 1.0, 2.0, -1.0, -2.0]) {
        if !goes_on(1) {
            found.ended = Ended::Interrupted { time: 0.0, level: 0.0 };
            return;
        }
        *reading = read(system, k * step);
    }
    let [here, ahead, beyond, behind, before] = readings;
    system.restore(&rest);
    let mut load = vec![0.0; motion.len()];
    system.load_rate(0.0, &mut load);
    let internal = 0.5 * force * load.iter().zip(&motion).map(|(f, u)| f * u).sum::<f64>();
    // One solve; at rest no direction is unstable.
    let mut row = vec![1.0, internal, 1.0, 0.0];
    let linear = |i: usize| {
        let (near, far) = (ahead[i] - behind[i], beyond[i] - before[i]);
        here[i] + (8.0 * near - far) / (12.0 * step)
    };
    let mut parts = (0..columns).map(linear);
    row.extend(gauges.iter().map(|gauge| {
        let own: Vec<f64> = parts.by_ref().take(gauge.part_count()).collect();
        gauge.of_parts(&own)
    }));
    found.curve.rows.push(row);
    found.energies = energies(internal);
    found.newton_iterations = 1;
    keep_shape(system, &motion, 1.0, found);
    let Some(frames) = &mut found.frames else { return };
    let values: Vec<f64> = (columns..here.len()).map(linear).collect();
    let forces = forces(system.shell(), &values);
    system.update(&motion);
    frames.offer_linear(system.shell(), &forces);
    system.restore(&rest);
}

/// Numbers of a sampling point in a reading.
const NUMBERS: usize = 16;

/// Appends the reactions of all particles and the strains and resultants of all points.
fn read_forces(shell: &Shell, values: &mut Vec<f64>) {
    values.extend((0..shell.len()).flat_map(|a| <[f64; 3]>::from(shell.reaction(a))));
    for point in points(shell) {
        let PointResult { membrane, curvature, shear, force, moment, shear_force, t1: _ } = point;
        for three in [membrane, curvature, force, moment] {
            values.extend(three);
        }
        values.extend(shear);
        values.extend(shear_force);
    }
}

/// What [`read_forces`] wrote, put back in its place; the shell is at rest.
fn forces(shell: &Shell, values: &[f64]) -> LinearForces {
    let (reactions, numbers) = values.split_at(3 * shell.len());
    let point = |(rest, n): (PointResult, &[f64])| PointResult {
        membrane: from_fn(|i| n[i]),
        curvature: from_fn(|i| n[3 + i]),
        force: from_fn(|i| n[6 + i]),
        moment: from_fn(|i| n[9 + i]),
        shear: from_fn(|i| n[12 + i]),
        shear_force: from_fn(|i| n[14 + i]),
        t1: rest.t1,
    };
    LinearForces {
        points: points(shell).into_iter().zip(numbers.chunks_exact(NUMBERS)).map(point).collect(),
        reactions: reactions.chunks_exact(3).map(Vec3::from_column_slice).collect(),
    }
}

/// Strains and resultants of the present state.
fn points(shell: &Shell) -> Vec<PointResult> {
    let mut points = vec![PointResult::default(); shell.reference().operator.points.len()];
    shell.point_results(&mut points);
    points
}

/// Largest displacement of a particle within a motion of the unknowns \[L\]; the state stays.
fn largest(system: &mut StaticShell, motion: &[f64]) -> f64 {
    let rest = system.save();
    system.update(motion);
    let shell = system.shell();
    let largest = (0..shell.len()).map(|a| shell.displacement(a).norm()).fold(0.0, f64::max);
    system.restore(&rest);
    largest
}
