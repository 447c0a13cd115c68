//! Steady vibration: amplitudes and phases at given frequencies, directly or in modes, about the unloaded or the preloaded body.

pub(super) mod warnings;

use std::f64::consts::TAU;

use implicit_statics::{
    Complex, CycleEnergies, DirectResponse, EquilibriumError, HarmonicMotion, ReducedResponse,
};

use sph_core::Vec3;

use self::warnings::{Warnings, truncated, unstable};
use super::modes::{Vibration, keep, vibration};
use super::swinging::{Driver, Reader, Slopes};
use crate::bodies::StaticBody;
use crate::run::Run;
use crate::run::outcome::Ended;
use crate::scene::{BaseResponse, Harmonic, ShakenBase};

/// Finds the steady answer at each frequency and reads a row of the curve.
pub(crate) fn harmonic(wanted: &Harmonic, system: &mut dyn StaticBody, run: &mut Run<'_>) -> Ended {
    if run.tell(0.0, 0, 0.0, 0.0).is_break() {
        return interrupted(0.0);
    }
    let mut reader = Swing::new(wanted.base, system, run);
    let way = match wanted.modes {
        Some(count) => in_modes(count.get(), wanted, &mut reader, system, run),
        None => directly(wanted, system, run).map_err(|cause| Box::new(run.unbalanced(0, 0.0, cause))),
    };
    let mut way = match way {
        Ok(way) => way,
        Err(ended) => return *ended,
    };
    let frequencies = wanted.frequencies.list();
    let mut peaks = Peaks::default();
    let mut below = Vec::new();
    for (number, &frequency) in frequencies.iter().enumerate() {
        let omega = TAU * frequency;
        let found = match way.at(omega, &mut reader, system, run) {
            Ok(found) => found,
            Err(cause) => return run.unbalanced(number as u64, frequency, cause),
        };
        let Found { energies, values, motion } = found;
        let CycleEnergies { internal, kinetic, external, dissipated } = energies;
        let mut row = vec![frequency, omega, internal, kinetic, external, dissipated];
        row.extend(values.iter().flat_map(|value| [value.amplitude(), value.phase()]));
        run.push(row);
        run.record.energies.internal = internal;
        run.record.energies.kinetic = kinetic;
        below.extend(way.below());
        if let Some((at, motion)) = peaks.take(frequency, internal + kinetic, motion)
            && keep(system, &motion.widest(way.masses()), at, run).is_break()
        {
            break;
        }
        let done = (number + 1) as f64 / frequencies.len() as f64;
        if run.tell(done, number as u64 + 1, frequency, internal).is_break() {
            return interrupted(frequency);
        }
    }
    if let Some((at, motion)) = peaks.last() {
        // Nothing follows: a frame that could not be taken is reported by the failure.
        let _ = keep(system, &motion.widest(way.masses()), at, run);
    }
    run.record.steps = run.curve.rows.len() as u64;
    let natural = way.natural();
    let circular: Vec<f64> = frequencies.iter().map(|frequency| TAU * frequency).collect();
    Warnings { frequencies: &circular, damping: wanted.damped(), natural: natural.as_deref(), below: &below }
        .say(run);
    truncated(circular.last().copied(), natural.as_deref(), run);
    Ended::Done
}

/// How a run ends that was asked to at a frequency.
pub(super) fn interrupted(level: f64) -> Ended {
    Ended::Interrupted { time: 0.0, level }
}

/// What reads columns, and what drives.
struct Swing {
    of: Reader,
    driver: Driver,
}

impl Swing {
    fn new(base: Option<ShakenBase>, system: &mut dyn StaticBody, run: &mut Run<'_>) -> Self {
        let of = Reader::new(system, run, false);
        let mut driver = of.driver(system, run);
        if let Some(ShakenBase { acceleration, response: BaseResponse::Absolute }) = base {
            driver.base = Vec3::from(acceleration);
            (driver.motion_in_space, driver.acceleration_in_space) = (true, true);
        }
        Self { of, driver }
    }
}

/// How an answer is found.
enum Way {
    Direct(Box<DirectResponse>),
    Modes(InModes),
}

/// Shapes with what is read along each.
struct InModes {
    reduced: ReducedResponse,
    slopes: Vec<Slopes>,
    natural: Vec<f64>,
}

/// An answer at a frequency.
struct Found {
    energies: CycleEnergies,
    values: Vec<Complex>,
    motion: HarmonicMotion,
}

impl Way {
    fn at(
        &mut self,
        omega: f64,
        reader: &mut Swing,
        system: &mut dyn StaticBody,
        run: &mut Run<'_>,
    ) -> Result<Found, EquilibriumError> {
        match self {
            Self::Direct(direct) => {
                let motion = direct.at(omega)?;
                let along = [&motion.real, &motion.imaginary].map(|part| reader.of.slopes(part, system, run));
                let kappa = direct.kappa(omega);
                let parts = along.iter().zip([Complex::new(1.0, 0.0), Complex::new(0.0, 1.0)]);
                let values = reader.of.values(
                    &reader.driver,
                    parts.map(|(slopes, unit)| (slopes, unit, kappa)),
                    omega,
                    run,
                );
                Ok(Found { energies: direct.energies(&motion, omega), values, motion })
            }
            Self::Modes(InModes { reduced, slopes, .. }) => {
                let coordinates = reduced.at(omega)?;
                let parts = slopes.iter().zip(coordinates.iter().zip(reduced.kappas(omega)));
                let values = reader.of.values(
                    &reader.driver,
                    parts.map(|(slopes, (&z, kappa))| (slopes, z, kappa)),
                    omega,
                    run,
                );
                let (energies, motion) =
                    (reduced.energies(&coordinates, omega), reduced.motion(&coordinates));
                Ok(Found { energies, values, motion })
            }
        }
    }

    /// Natural frequencies below the one last answered for, where they were counted.
    fn below(&self) -> Option<usize> {
        if let Self::Direct(direct) = self { direct.below() } else { None }
    }

    fn masses(&self) -> &[f64] {
        match self {
            Self::Direct(direct) => direct.masses(),
            Self::Modes(modes) => modes.reduced.masses(),
        }
    }

    /// Circular frequencies of the modes, where they were found.
    fn natural(&self) -> Option<Vec<f64>> {
        if let Self::Modes(modes) = self { Some(modes.natural.clone()) } else { None }
    }
}

/// Finds the modes, what they leave out, and what is read along each.
fn in_modes(
    count: usize,
    wanted: &Harmonic,
    reader: &mut Swing,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
) -> Result<Way, Box<Ended>> {
    let Vibration { modes, shift, unstable: negative } = vibration(count, system, run)?;
    unstable(negative, run);
    let natural = modes.iter().map(|mode| mode.circular_frequency()).collect();
    let reduced = ReducedResponse::new(system, 0.0, modes, shift, wanted.damped())
        .map_err(|cause| Box::new(run.unbalanced(0, 0.0, cause)))?;
    let slopes = reduced.shapes().map(|shape| reader.of.slopes(shape, system, run)).collect();
    Ok(Way::Modes(InModes { reduced, slopes, natural }))
}

/// Makes ready for a factor at each frequency.
fn directly(
    wanted: &Harmonic,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
) -> Result<Way, EquilibriumError> {
    let direct = DirectResponse::new(system, 0.0, wanted.damped())?;
    unstable(direct.stability(system)?.negative, run);
    Ok(Way::Direct(Box::new(direct)))
}

/// Motions at which the stored and the kinetic energy have a maximum, the first and the last frequency among them.
#[derive(Default)]
struct Peaks {
    before: Option<(f64, f64, HarmonicMotion)>,
    falls: bool,
}

impl Peaks {
    /// Takes the next frequency with its energy and its motion; the one before it if that was a peak.
    fn take(&mut self, frequency: f64, energy: f64, motion: HarmonicMotion) -> Option<(f64, HarmonicMotion)> {
        let before = self.before.replace((frequency, energy, motion))?;
        let rose = !self.falls;
        self.falls = energy < before.1;
        (rose && self.falls).then_some((before.0, before.2))
    }

    /// The last one, if the energy rose up to there.
    fn last(self) -> Option<(f64, HarmonicMotion)> {
        self.before.filter(|_| !self.falls).map(|(frequency, _, motion)| (frequency, motion))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_are_maxima_and_ends() {
        let mut peaks = Peaks::default();
        let energies = [3.0, 2.0, 2.5, 7.0, 6.0, 1.0, 4.0];
        let mut found = Vec::new();
        for (i, &energy) in energies.iter().enumerate() {
            found.extend(peaks.take(i as f64, energy, HarmonicMotion::default()).map(|(at, _)| at));
        }
        found.extend(peaks.last().map(|(at, _)| at));
        assert_eq!(found, [0.0, 3.0, 6.0]);
    }
}
