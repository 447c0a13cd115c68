//! Steady vibration under noise: the density of each column by frequency, its root mean square, how often it crosses zero.

use std::f64::consts::TAU;

use implicit_statics::{Complex, EquilibriumError, PowerDensity, noise_frequencies};

use super::harmonic::warnings::{Warnings, truncated};
use super::shaken_modes::{ShakenModes, Source, Wanted, show};
use crate::bodies::StaticBody;
use crate::run::Run;
use crate::run::outcome::Ended;
use crate::run::vibration_summary::{NoiseSummary, VibrationSummary};
use crate::scene::units::Units;
use crate::scene::{Checked, RandomVibration};

/// Finds the densities at the frequencies that are asked for, and the integrals over all of them. The analysis is that of the body, whose bases have its
/// axes.
pub(super) fn random_vibration(
    scene: &Checked,
    wanted: &RandomVibration,
    threads: usize,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
) -> Ended {
    let interrupted = |level: f64| Ended::Interrupted { time: 0.0, level };
    if run.tell(0.0, 0, 0.0, 0.0).is_break() {
        return interrupted(0.0);
    }
    let damping = wanted.damping.damped();
    let bases = wanted.base.iter().map(|base| base.acceleration).collect();
    let loads = wanted.loads.is_some();
    let (modes, sets) = (wanted.modes.get(), Vec::new());
    let sought = Wanted { modes, damping, bases, sets, loads, scene, threads };
    let found = match ShakenModes::find(&sought, system, run) {
        Ok(found) => found,
        Err(ended) => return *ended,
    };
    let densities: Vec<PowerDensity> = wanted.densities().collect();
    let noise = Noise { found: &found, densities: &densities };
    let frequencies = wanted.frequencies.list();
    for (number, &frequency) in frequencies.iter().enumerate() {
        let powers = match noise.at(frequency, run) {
            Ok(powers) => powers,
            Err(cause) => return run.unbalanced(number as u64, frequency, cause),
        };
        run.push([vec![frequency, TAU * frequency], powers].concat());
        let done = (number + 1) as f64 / frequencies.len() as f64;
        if run.tell(done, number as u64 + 1, frequency, 0.0).is_break() {
            return interrupted(frequency);
        }
    }
    run.record.steps = run.curve.rows.len() as u64;
    let nodes = noise_frequencies(&densities.iter().collect::<Vec<_>>(), &noise.peaks());
    let squares = match noise.squares(&nodes, run) {
        Ok(squares) => squares,
        Err(cause) => return run.unbalanced(frequencies.len() as u64, 0.0, cause),
    };
    let units = Units { by_depth: scene.is_by_depth(), ..scene.units };
    let columns = run.probes.iter().flat_map(|probe| probe.columns(&units));
    let summed = columns.zip(squares).map(|(column, [square, of_rate])| NoiseSummary {
        column,
        root_mean_square: square.sqrt(),
        crossings: (square > 0.0).then(|| (of_rate / square).sqrt() / TAU),
    });
    let of_noise = summed.collect();
    let (modes, bases) = (found.modes(damping), found.bases(run));
    let summary = VibrationSummary { modes, bases, noise: of_noise, cases: Vec::new() };
    run.vibration = Some(summary);
    let circular: Vec<f64> = frequencies.iter().map(|frequency| TAU * frequency).collect();
    Warnings { frequencies: &circular, damping, natural: Some(&found.natural), below: &[] }.say(run);
    let ends = densities.iter().filter_map(|own| own.points.last());
    truncated(ends.map(|end| TAU * end[0]).reduce(f64::max), Some(&found.natural), run);
    let [motion, forces] = match noise.numbers(&nodes, run.frames.is_some()) {
        Ok(numbers) => numbers,
        Err(cause) => return run.unbalanced(frequencies.len() as u64, 0.0, cause),
    };
    show(&motion, &forces, 1.0, system, run);
    Ended::Done
}

/// Noise in modes.
struct Noise<'a> {
    found: &'a ShakenModes,
    densities: &'a [PowerDensity],
}

impl Noise<'_> {
    /// Density of each column at a frequency \[1/T\].
    fn at(&self, frequency: f64, run: &Run<'_>) -> Result<Vec<f64>, EquilibriumError> {
        let mut powers = vec![0.0; run.probes.len()];
        let omega = TAU * frequency;
        for (source, density) in self.found.sources.iter().zip(self.densities) {
            let density = density.at(frequency);
            if density == 0.0 {
                continue;
            }
            let coordinates = source.reduced.at(omega)?;
            let shapes = coordinates.iter().zip(source.reduced.kappas(omega));
            let motions = source.slopes(&self.found.slopes).zip(shapes);
            let motions = motions.map(|(slopes, (&z, kappa))| (slopes, z, kappa));
            let values = self.found.reader.values(&source.driver, motions, omega, run);
            powers.iter_mut().zip(values).for_each(|(power, value)| *power += density * value.square());
        }
        Ok(powers)
    }

    /// Mean squares of each column and of its rate, over all frequencies.
    fn squares(&self, nodes: &[[f64; 2]], run: &Run<'_>) -> Result<Vec<[f64; 2]>, EquilibriumError> {
        let mut all = vec![[0.0; 2]; run.probes.len()];
        for &[frequency, weight] in nodes {
            let omega = TAU * frequency;
            for ([square, of_rate], power) in all.iter_mut().zip(self.at(frequency, run)?) {
                *square += weight * power;
                *of_rate += weight * omega * omega * power;
            }
        }
        Ok(all)
    }

    /// Natural frequencies of all shapes, each with half of the width of its peak \[1/T\].
    fn peaks(&self) -> Vec<[f64; 2]> {
        let swings = self.found.sources.iter().flat_map(|source| source.reduced.swings());
        swings.map(|[omega, zeta]| [omega / TAU, zeta * omega / TAU]).filter(|[f, _]| *f > 0.0).collect()
    }

    /// Roots of the mean squares of all unknowns, and of the forces that fields show where they are wanted: by the covariances of the shapes.
    fn numbers(&self, nodes: &[[f64; 2]], fields: bool) -> Result<[Vec<f64>; 2], EquilibriumError> {
        let mut all = [Vec::new(), Vec::new()];
        for (source, density) in self.found.sources.iter().zip(self.densities) {
            let [ways, forces] = covariances(source, density, nodes)?;
            let shapes: Vec<&[f64]> = source.reduced.shapes().collect();
            add_squares(&ways, &shapes, &mut all[0]);
            if fields {
                let slopes = source.slopes(&self.found.slopes).map(|own| &own.forces[..]);
                add_squares(
                    &forces,
                    &slopes.chain([&source.driver.forces[..]]).collect::<Vec<_>>(),
                    &mut all[1],
                );
            }
        }
        Ok(all.map(|squares| squares.into_iter().map(|square: f64| square.max(0.0).sqrt()).collect()))
    }
}

/// `∫ G Re(b_i b_j*) df` of the coordinates of the shapes, and of what the forces of their strains go by with that of the load itself as the last.
fn covariances(
    source: &Source,
    density: &PowerDensity,
    nodes: &[[f64; 2]],
) -> Result<[Vec<Vec<f64>>; 2], EquilibriumError> {
    let count = source.reduced.shapes().len();
    let mut all = [vec![vec![0.0; count]; count], vec![vec![0.0; count + 1]; count + 1]];
    for &[frequency, weight] in nodes {
        let power = weight * density.at(frequency);
        let omega = TAU * frequency;
        let ways = source.reduced.at(omega)?;
        let forces = ways.iter().zip(source.reduced.kappas(omega)).map(|(&z, kappa)| z * kappa);
        let forces: Vec<Complex> = forces.chain([Complex::new(1.0, 0.0)]).collect();
        for (sums, numbers) in all.iter_mut().zip([&ways, &forces]) {
            for (row, a) in sums.iter_mut().zip(numbers) {
                row.iter_mut().zip(numbers).for_each(|(sum, b)| *sum += power * (a.re * b.re + a.im * b.im));
            }
        }
    }
    Ok(all)
}

/// Adds `Σ C_ij x_i x_j` of each number along the shapes.
fn add_squares(covariances: &[Vec<f64>], along: &[&[f64]], squares: &mut Vec<f64>) {
    let length = along.first().map_or(0, |numbers| numbers.len());
    squares.resize(length, 0.0);
    for (i, square) in squares.iter_mut().enumerate() {
        for (row, a) in covariances.iter().zip(along) {
            *square += a[i] * row.iter().zip(along).map(|(c, b)| c * b[i]).sum::<f64>();
        }
    }
}
