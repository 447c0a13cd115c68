//! Steady vibration under several load cases, and combinations of them with factors and phases: one factor a frequency, or one set of modes, for all.
//!
//! A case is the scene with the loads of that case alone ([`Checked::under`](crate::scene::Checked)), whose body stands in the state that vibrates. A combination
//! is a load `p = Σ f_c exp(iφ_c) p_c`, `p(t) = Re[p exp(iωt)]`: its two parts, `Σ f_c cos φ_c p_c` and `Σ f_c sin φ_c p_c`, are answered like a case each,
//! `u = u' + i u''`, so that a combination in phase is a run under the loads times their factors, with the shape that its modes leave out.

use std::f64::consts::TAU;

use implicit_statics::{
    Complex, CycleEnergies, DirectResponse, EnergyForms, EquilibriumError, HarmonicMotion,
};

use super::harmonic::interrupted;
use super::harmonic::warnings::{Warnings, truncated, unstable};
use super::shaken_modes::{ShakenModes, Wanted, built};
use super::swinging::{Driver, Reader};
use crate::bodies::StaticBody;
use crate::results::curve::Column;
use crate::run::Run;
use crate::run::outcome::Ended;
use crate::run::vibration_summary::{CasePeak, SwingingCase, SwingingMode, VibrationSummary};
use crate::scene::{Checked, Harmonic, LoadSet};

/// Finds the steady answer to every case and combination at each frequency; rows of the curve go case by case.
pub(super) fn harmonic_cases(
    (scene, threads): (&Checked, usize),
    wanted: &Harmonic,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
) -> Ended {
    if run.tell(0.0, 0, 0.0, 0.0).is_break() {
        return interrupted(0.0);
    }
    let sets = scene.load_sets();
    let parts: Vec<Vec<LoadSet>> = sets.iter().map(LoadSet::by_phase).collect();
    let mut way = match Way::find((scene, threads), wanted, &parts, system, run) {
        Ok(way) => way,
        Err(ended) => return *ended,
    };
    let frequencies = wanted.frequencies.list();
    let mut rows: Vec<Vec<Vec<f64>>> = vec![Vec::new(); sets.len()];
    let (mut below, mut ended) = (Vec::new(), Ended::Done);
    for (number, &frequency) in frequencies.iter().enumerate() {
        let omega = TAU * frequency;
        let found = match way.at(omega, &parts, system, run) {
            Ok(found) => found,
            Err(cause) => {
                ended = run.unbalanced(number as u64, frequency, cause);
                break;
            }
        };
        for (case, ((energies, values), rows)) in (1..).zip(found.into_iter().zip(&mut rows)) {
            let CycleEnergies { internal, kinetic, external, dissipated } = energies;
            let mut row = vec![f64::from(case), frequency, omega, internal, kinetic, external, dissipated];
            row.extend(values.iter().flat_map(|value| [value.amplitude(), value.phase()]));
            rows.push(row);
        }
        below.extend(way.below());
        let done = (number + 1) as f64 / frequencies.len() as f64;
        if run.tell(done, number as u64 + 1, frequency, 0.0).is_break() {
            ended = interrupted(frequency);
            break;
        }
    }
    let first = run.curve.columns.len() - 2 * run.probes.len();
    let columns: Vec<Column> = run.curve.columns.iter().skip(first).step_by(2).cloned().collect();
    let cases = sets.iter().zip(&rows).map(|(set, rows)| SwingingCase {
        set: set.clone(),
        peaks: (0..).zip(&columns).filter_map(|(k, column)| peak(column, first + 2 * k, rows)).collect(),
    });
    run.vibration =
        Some(VibrationSummary { modes: way.modes(), cases: cases.collect(), ..Default::default() });
    rows.into_iter().flatten().for_each(|row| run.push(row));
    run.record.steps = run.curve.rows.len() as u64;
    let natural = way.natural();
    let circular: Vec<f64> = frequencies.iter().map(|frequency| TAU * frequency).collect();
    Warnings { frequencies: &circular, damping: wanted.damped(), natural, below: &below }.say(run);
    truncated(circular.last().copied(), natural, run);
    ended
}

/// Where a column of amplitudes is greatest; none without rows.
fn peak(column: &Column, at: usize, rows: &[Vec<f64>]) -> Option<CasePeak> {
    let greatest = rows.iter().max_by(|a, b| a[at].total_cmp(&b[at]))?;
    Some(CasePeak { column: column.clone(), amplitude: greatest[at], frequency: greatest[1] })
}

/// How answers are found.
enum Way {
    Direct(Box<Direct>),
    Modes(Box<InModes>),
}

/// By a factor at each frequency: loads of all parts of all cases, and what they add to columns.
struct Direct {
    response: DirectResponse,
    reader: Reader,
    sources: Vec<(Vec<f64>, Driver)>,
}

/// In modes; the forms are there where a combination has two phases.
struct InModes {
    shaken: ShakenModes,
    swings: Vec<SwingingMode>,
    forms: Option<EnergyForms>,
}

/// An answer to a load in one phase; its motion is there where it is wanted.
struct Answer {
    energies: CycleEnergies,
    values: Vec<Complex>,
    motion: Option<HarmonicMotion>,
}

impl Way {
    fn find(
        (scene, threads): (&Checked, usize),
        wanted: &Harmonic,
        parts: &[Vec<LoadSet>],
        system: &mut dyn StaticBody,
        run: &mut Run<'_>,
    ) -> Result<Self, Box<Ended>> {
        let sets: Vec<LoadSet> = parts.iter().flatten().cloned().collect();
        let damping = wanted.damped();
        if let Some(modes) = wanted.modes {
            let (modes, bases, loads) = (modes.get(), Vec::new(), false);
            let wanted = Wanted { modes, damping, bases, sets, loads, scene, threads };
            let shaken = ShakenModes::find(&wanted, system, run)?;
            let phased = parts.iter().any(|parts| parts.len() > 1);
            let forms = phased.then(|| EnergyForms::of(system, 0.0));
            let swings = shaken.modes(damping);
            return Ok(Self::Modes(Box::new(InModes { shaken, swings, forms })));
        }
        let reader = Reader::new(system, run, false);
        let response = DirectResponse::new(system, 0.0, damping)
            .and_then(|response| Ok((response.stability(system)?.negative, response)));
        let (negative, response) = response.map_err(|cause| Box::new(run.unbalanced(0, 0.0, cause)))?;
        unstable(negative, run);
        let state = system.save();
        let mut sources = Vec::new();
        for set in &sets {
            let mut body = built(&scene.under(set), threads, &set.name)?;
            body.restore(&state);
            let mut load = vec![0.0; body.unknowns()];
            body.load_rate(0.0, &mut load);
            sources.push((load, reader.driver(body.as_mut(), run)));
        }
        Ok(Self::Direct(Box::new(Direct { response, reader, sources })))
    }

    /// Energies and columns of every case at a circular frequency.
    fn at(
        &mut self,
        omega: f64,
        parts: &[Vec<LoadSet>],
        system: &mut dyn StaticBody,
        run: &mut Run<'_>,
    ) -> Result<Vec<(CycleEnergies, Vec<Complex>)>, EquilibriumError> {
        if let Self::Direct(direct) = self {
            direct.response.factorise(omega)?;
        }
        let mut source = 0;
        let mut all = Vec::new();
        for parts in parts {
            let own = source..source + parts.len();
            source = own.end;
            let answers = own
                .clone()
                .map(|number| self.answer(number, omega, parts.len() > 1, system, run))
                .collect::<Result<Vec<_>, _>>()?;
            all.push(self.joined(own.start, answers, omega));
        }
        Ok(all)
    }

    /// The answer to a source.
    fn answer(
        &mut self,
        source: usize,
        omega: f64,
        moves: bool,
        system: &mut dyn StaticBody,
        run: &mut Run<'_>,
    ) -> Result<Answer, EquilibriumError> {
        match self {
            Self::Direct(direct) => {
                let Direct { response, reader, sources } = &mut **direct;
                let (load, driver) = &sources[source];
                let motion = response.under(load, omega)?;
                let along = [&motion.real, &motion.imaginary].map(|part| reader.slopes(part, system, run));
                let units = [Complex::new(1.0, 0.0), Complex::new(0.0, 1.0)];
                let kappa = response.kappa(omega);
                let parts = along.iter().zip(units).map(|(slopes, unit)| (slopes, unit, kappa));
                let values = reader.values(driver, parts, omega, run);
                let energies = response.energies_under([load, &[]], &motion, omega);
                Ok(Answer { energies, values, motion: moves.then_some(motion) })
            }
            Self::Modes(modes) => {
                let ShakenModes { reader, slopes, sources, .. } = &modes.shaken;
                let own = &sources[source];
                let coordinates = own.reduced.at(omega)?;
                let factors = coordinates.iter().copied().zip(own.reduced.kappas(omega));
                let parts = own.slopes(slopes).zip(factors).map(|(slopes, (z, kappa))| (slopes, z, kappa));
                let values = reader.values(&own.driver, parts, omega, run);
                let energies = own.reduced.energies(&coordinates, omega);
                let motion = moves.then(|| own.reduced.motion(&coordinates));
                Ok(Answer { energies, values, motion })
            }
        }
    }

    /// The answer to a load whose parts are those from a source on.
    fn joined(&self, first: usize, answers: Vec<Answer>, omega: f64) -> (CycleEnergies, Vec<Complex>) {
        let mut answers = answers.into_iter();
        let (Some(real), imaginary) = (answers.next(), answers.next()) else { return Default::default() };
        let Some(imaginary) = imaginary else { return (real.energies, real.values) };
        let quarter = Complex::new(0.0, 1.0);
        let values = real.values.iter().zip(&imaginary.values).map(|(a, b)| *a + quarter * *b).collect();
        let (Some(a), Some(b)) = (real.motion, imaginary.motion) else { return (real.energies, values) };
        let motion = HarmonicMotion {
            real: a.real.iter().zip(&b.imaginary).map(|(a, b)| a - b).collect(),
            imaginary: a.imaginary.iter().zip(&b.real).map(|(a, b)| a + b).collect(),
        };
        let energies = match self {
            Self::Direct(direct) => {
                let [p, q] = [first, first + 1].map(|source| &direct.sources[source].0[..]);
                direct.response.energies_under([p, q], &motion, omega)
            }
            Self::Modes(modes) => {
                let [p, q] = [first, first + 1].map(|source| &modes.shaken.sources[source].load[..]);
                modes.forms.as_ref().map_or(real.energies, |forms| forms.of_cycle([p, q], &motion, omega))
            }
        };
        (energies, values)
    }

    /// Natural frequencies below the one last answered for, where they were counted.
    fn below(&self) -> Option<usize> {
        if let Self::Direct(direct) = self { direct.response.below() } else { None }
    }

    /// Circular frequencies of the modes, where they were found \[1/T\].
    fn natural(&self) -> Option<&[f64]> {
        if let Self::Modes(modes) = self { Some(&modes.shaken.natural) } else { None }
    }

    fn modes(&self) -> Vec<SwingingMode> {
        if let Self::Modes(modes) = self { modes.swings.clone() } else { Vec::new() }
    }
}
