//! Greatest answers to response spectra: each mode's own, combined column by column.

use std::f64::consts::TAU;

use implicit_statics::{ModesTogether, ResponseSpectrum};

use super::shaken_modes::{ShakenModes, Source, Wanted, show};
use super::swinging::{Kind, moved_with};
use crate::WarningKind;
use crate::bodies::StaticBody;
use crate::run::Run;
use crate::run::outcome::Ended;
use crate::run::vibration_summary::VibrationSummary;
use crate::scene::{Checked, SpectrumAnalysis};

/// Part of the acceleration of the ground by which a spectrum may differ from it where modes go with it.
const WITH_THE_GROUND: f64 = 0.01;

/// Finds the answers to each base and to all of them. The analysis is that of the body, whose bases have its axes.
pub(super) fn response_spectrum(
    scene: &Checked,
    wanted: &SpectrumAnalysis,
    threads: usize,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
) -> Ended {
    if run.tell(0.0, 0, 0.0, 0.0).is_break() {
        return Ended::Interrupted { time: 0.0, level: 0.0 };
    }
    let damping = wanted.damping.damped();
    let bases = wanted.base.iter().map(|base| base.acceleration).collect();
    let (modes, sets, loads) = (wanted.modes.get(), Vec::new(), false);
    let sought = Wanted { modes, damping, bases, sets, loads, scene, threads };
    let found = match ShakenModes::find(&sought, system, run) {
        Ok(found) => found,
        Err(ended) => return *ended,
    };
    let swings = found.swings(damping);
    let together = ModesTogether::new(wanted.combination, &swings);
    let (modes, bases) = (found.modes(damping), found.bases(run));
    let mut summary = VibrationSummary { modes, bases, ..VibrationSummary::default() };
    let mut answers: Vec<Answer> = Vec::new();
    for (number, (source, base)) in found.sources.iter().zip(&wanted.base).enumerate() {
        let spectrum = base.spectrum();
        let levels = levels(&spectrum, &swings, number, run);
        let ground = if wanted.missing_mass { spectrum.of_ground() } else { 0.0 };
        let rigid = rigid_from(&spectrum, &levels);
        let greatest = Greatest { found: &found, source, swings: &swings, levels: &levels, rigid, ground };
        let (peaks, rest) = greatest.columns(run);
        let one = &mut summary.bases[number];
        let (size, columns) = (source.shakes.as_ref().map_or(1.0, |shaking| shaking.size), rest.len());
        for (n, mode) in one.modes.iter_mut().enumerate() {
            mode.acceleration = Some(size * levels[n]);
            mode.columns = (0..columns).map(|c| peaks[c][n]).collect();
        }
        one.ground = Some(size * spectrum.of_ground());
        one.missing_mass = if wanted.missing_mass { rest.clone() } else { Vec::new() };
        let values = (0..columns).map(|c| greatest.of_column(&together, c, &peaks[c], rest[c])).collect();
        let [motion, forces] = [greatest.motion(&together), greatest.forces(&together)];
        answers.push(Answer { values, motion, forces });
    }
    run.vibration = Some(summary);
    let all = |of: fn(&Answer) -> &Vec<f64>| -> Vec<f64> {
        let first = answers.first().map_or(0, |answer| of(answer).len());
        let part = |i: usize| answers.iter().map(|answer| of(answer)[i]).collect::<Vec<f64>>();
        (0..first).map(|i| wanted.directions.of(&part(i))).collect()
    };
    let whole = (answers.len() > 1).then(|| Answer {
        values: all(|answer| &answer.values),
        motion: all(|answer| &answer.motion),
        forces: all(|answer| &answer.forces),
    });
    let numbered = answers.iter().enumerate().map(|(number, answer)| ((number + 1) as f64, answer));
    for (number, answer) in numbered.chain(whole.as_ref().map(|whole| (0.0, whole))) {
        run.push([vec![number], answer.values.clone()].concat());
        show(&answer.motion, &answer.forces, number, system, run);
        if run.frames.as_ref().is_some_and(|frames| frames.failure.is_some()) {
            break;
        }
    }
    Ended::Done
}

/// Greatest answers, each number its own.
struct Answer {
    values: Vec<f64>,
    /// Of the unknowns.
    motion: Vec<f64>,
    /// Of the forces that fields show.
    forces: Vec<f64>,
}

/// Numbers of the spectrum for all modes; warns of those that lie beyond it.
fn levels(spectrum: &ResponseSpectrum, swings: &[[f64; 2]], number: usize, run: &mut Run<'_>) -> Vec<f64> {
    let (mut softer, mut other) = (Vec::new(), Vec::new());
    let mut one = |&[omega, zeta]: &[f64; 2]| {
        if omega <= 0.0 {
            return 0.0;
        }
        let found = spectrum.at(omega, zeta);
        softer.extend(found.softer.then_some(omega / TAU));
        other.extend(found.other_damping.then_some(zeta));
        found.value
    };
    let levels = swings.iter().map(&mut one).collect();
    if let Some(lowest) = softer.iter().copied().reduce(f64::min) {
        let message = format!(
            "{} modes, the lowest of {lowest:.5e}, are softer than the spectrum of base {} goes: the number at its end stands for them; let it go on",
            softer.len(),
            number + 1
        );
        run.record.warn(WarningKind::BeyondSpectrum, message);
    }
    if let Some(first) = other.first() {
        let message = format!(
            "{} modes have a damping, such as {first:.4}, beyond those for which base {} has a spectrum: that of the nearest stands for them; give \
             `damped` a spectrum for it",
            other.len(),
            number + 1
        );
        run.record.warn(WarningKind::BeyondSpectrum, message);
    }
    levels
}

/// The first of the modes, by ascending frequency, that are so stiff that they go with the ground: the spectrum has its number there, to a hundredth, and at all
/// stiffer ones. Of a spectrum that is one number everywhere none does: it is that of some plateau.
fn rigid_from(spectrum: &ResponseSpectrum, levels: &[f64]) -> usize {
    let ground = spectrum.of_ground();
    let near = |level: &f64| (level - ground).abs() <= WITH_THE_GROUND * ground;
    if spectrum.is_flat() {
        return levels.len();
    }
    levels.len() - levels.iter().rev().take_while(|level| near(level)).count()
}

/// What a base makes of modes.
struct Greatest<'a> {
    found: &'a ShakenModes,
    source: &'a Source,
    /// Circular frequency and damping of each mode.
    swings: &'a [[f64; 2]],
    /// Numbers of the spectrum.
    levels: &'a [f64],
    /// First of the modes that go with the ground: all of these are met at once, with what modes leave out, and add up with their signs.
    rigid: usize,
    /// That of the ground, zero where what modes leave out is not added.
    ground: f64,
}

impl Greatest<'_> {
    /// Greatest share of each mode in each column, and what the mass that they leave out adds.
    fn columns(&self, run: &Run<'_>) -> (Vec<Vec<f64>>, Vec<f64>) {
        let Self { found, source, .. } = self;
        let at_rest: Vec<f64> = source.reduced.at_rest().collect();
        let loads: Vec<f64> = source.reduced.loads().collect();
        let along: Vec<Vec<f64>> =
            source.slopes(&found.slopes).map(|own| found.reader.columns(&own.columns, run)).collect();
        let load = found.reader.columns(&source.driver.load, run);
        let modes = self.swings.len();
        let mut peaks = Vec::new();
        let mut rest = Vec::new();
        for (c, (&kind, probe)) in found.reader.kinds().iter().zip(&run.probes).enumerate() {
            let left = along.get(modes).map_or(0.0, |own| own[c] * at_rest[modes]);
            let by = |omega: f64| match kind {
                Kind::Rate => omega,
                // Of a pseudo-acceleration: that with respect to space goes against the way.
                Kind::Acceleration => -omega * omega,
                Kind::Motion | Kind::Force => 1.0,
            };
            let peak = |n: usize| by(self.swings[n][0]) * along[n][c] * at_rest[n] * self.levels[n];
            peaks.push((0..modes).map(peak).collect());
            let own = match kind {
                Kind::Motion => left,
                // What follows the ground has no way of its own to go.
                Kind::Rate => 0.0,
                Kind::Acceleration => {
                    let moved: f64 = (0..modes).map(|n| along[n][c] * loads[n]).sum();
                    moved_with(&source.driver.base, probe) + moved
                }
                Kind::Force => left + load[c],
            };
            rest.push(self.ground * own);
        }
        (peaks, rest)
    }

    /// The whole of a column; rates of what goes with the ground are combined as those of the others.
    fn of_column(&self, together: &ModesTogether, column: usize, peaks: &[f64], rest: f64) -> f64 {
        match self.found.reader.kinds()[column] {
            Kind::Rate => together.of(peaks, rest),
            Kind::Motion | Kind::Acceleration | Kind::Force => self.whole(together, peaks, rest),
        }
    }

    /// Modes that swing by their rule; those that go with the ground are one with what modes leave out.
    fn whole(&self, together: &ModesTogether, peaks: &[f64], rest: f64) -> f64 {
        let mut swinging = peaks.to_vec();
        let rigid: f64 = swinging[self.rigid..].iter().sum();
        swinging[self.rigid..].fill(0.0);
        together.of(&swinging, rest + rigid)
    }

    /// The greatest of each unknown.
    fn motion(&self, together: &ModesTogether) -> Vec<f64> {
        let shapes: Vec<&[f64]> = self.source.reduced.shapes().collect();
        let none = vec![0.0; shapes.first().map_or(0, |shape| shape.len())];
        self.numbers(together, &shapes, &none)
    }

    /// The greatest of each force that fields show.
    fn forces(&self, together: &ModesTogether) -> Vec<f64> {
        let slopes: Vec<&[f64]> = self.source.slopes(&self.found.slopes).map(|own| &own.forces[..]).collect();
        self.numbers(together, &slopes, &self.source.driver.forces)
    }

    fn numbers(&self, together: &ModesTogether, along: &[&[f64]], load: &[f64]) -> Vec<f64> {
        let at_rest: Vec<f64> = self.source.reduced.at_rest().collect();
        let modes = self.swings.len();
        let one = |i: usize| {
            let peaks: Vec<f64> = (0..modes).map(|n| along[n][i] * at_rest[n] * self.levels[n]).collect();
            let left = along.get(modes).map_or(0.0, |own| own[i] * at_rest[modes]);
            self.whole(together, &peaks, self.ground * (left + load[i]))
        };
        (0..load.len()).map(one).collect()
    }
}
