//! noise: random velocities on every particle of a free plate for 10⁵ steps; nothing may feed on them.

use std::time::Instant;

use explicit_dynamics::Clock;
use nalgebra::{Matrix3, Matrix3xX, Vector3};
use sph_core::Vec3;
use sph_shell::Shell;

use crate::Outcome;
use crate::cases::shell::plate::of_thickness;
use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::{CELL, STRONG_12};
use crate::support::studies::{ENERGY, SHOWN, figure, free, jittered, march, outcome, stir, study};
use crate::{JudgeError, Metric};

const BLOCKS: u64 = 200;
const EACH: u64 = 500;
/// Velocities, in parts of the speed of sound: deflections stay far below the thickness.
const SPEED: f64 = 1e-4;
const GROWTH: &str = "growth of the non-affine part";
const DRIFT: &str = "drift of the energy";
const SHARE: &str = "hourglass share, end over start";

pub fn case() -> Case {
    Case {
        name: "noise",
        title: "Random velocities on a free plate, 10⁵ steps without damping",
        about: "Every particle and every director gets a random velocity. What is left of the displacement when the best affine \
                motion is taken out may swing, but not grow: its largest value in the second half of the run, in parts of \
                that in the first half; a zero mode would give 2. The hourglass share is the part of the velocities that \
                alternates round the cells.",
        citation: "reference: the energy given at the start",
        variants: variants(),
        each,
        headline: Some(Headline::new(GROWTH, 0.01)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let plate = |method: &str| free(of_thickness(method, 11, 0.01));
    let mut variants: Vec<Variant> =
        ENERGY.into_iter().chain([STRONG_12]).map(|method| study(plate(method), run)).collect();
    variants.push(study(jittered(plate(CELL), "plate"), run));
    variants
}

fn run(mut shell: Shell) -> Result<Outcome, String> {
    let started = Instant::now();
    let speed = SPEED * shell.reference().sound_speed;
    stir(&mut shell, speed, 1);
    let mut clock = Clock::start(&mut shell, 1.0, 0.8, 0.0).map_err(|e| e.to_string())?;
    let (mut energies, mut wander, mut shares) = (Vec::new(), Vec::new(), Vec::new());
    let ended = march(&mut clock, &mut shell, [BLOCKS, EACH], |shell, record| {
        energies.push(record.energy.kinetic + record.energy.internal);
        wander.push(non_affine(shell));
        shares.push(hourglass_share(shell));
    });
    let half = wander.len() / 2;
    let most = |part: &[f64]| part.iter().copied().fold(0.0, f64::max);
    let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len().max(1) as f64;
    let drift = mean(&energies[half..]) / mean(&energies[..half]) - 1.0;
    let figures = [
        (GROWTH, "-", most(&wander[half..]) / most(&wander[..half])),
        (DRIFT, "%", 100.0 * drift),
        (SHARE, "-", mean(&shares[half..]) / shares[0]),
        ("non-affine part", "-", most(&wander)),
    ];
    Ok(outcome(&shell, clock.steps, started, &figures, ended.err().map(|e| e.to_string())))
}

/// Root mean square of the displacement less its best affine fit, in spacings.
fn non_affine(shell: &Shell) -> f64 {
    let places = &shell.reference().cloud.positions;
    let mut normal = Matrix3::zeros();
    let mut right = Matrix3::zeros();
    let of = |x: &Vec3| Vector3::new(1.0, x.x, x.y);
    for (a, x) in places.iter().enumerate() {
        normal += of(x) * of(x).transpose();
        right += of(x) * shell.position(a).transpose();
    }
    let fit = normal.try_inverse().unwrap_or_else(Matrix3::zeros) * right;
    let left = Matrix3xX::from_columns(
        &places
            .iter()
            .enumerate()
            .map(|(a, x)| shell.position(a) - fit.transpose() * of(x))
            .collect::<Vec<_>>(),
    );
    left.norm() / (places.len() as f64).sqrt() / shell.reference().cloud.spacing()
}

/// Square of the alternating part of the velocities of each cell over the square of the velocities.
fn hourglass_share(shell: &Shell) -> f64 {
    let mut alternating = 0.0;
    for cell in &shell.reference().cloud.cells {
        let [p, q, r, s] = cell.corners.map(|a| shell.velocity(a as usize));
        alternating += ((p - q + r - s) * 0.25).norm_squared();
    }
    alternating / (0..shell.len()).map(|a| shell.velocity(a).norm_squared()).sum::<f64>()
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    Ok(vec![
        figure(run, GROWTH, "-")?
            .within(1.5, "a swing gives about 1 and a motion without stiffness 2: half way"),
        figure(run, DRIFT, "%")?.within(
            5.0,
            "means over 50 000 steps each; the energy shared by 700 modes fluctuates by a few percent",
        ),
        figure(run, SHARE, "-")?
            .within(1.5, "all of it is there at the start, stiff modes pass half of theirs to the strains"),
        figure(run, "non-affine part", "spacings")?.shown(SHOWN),
    ])
}
