//! What answers to response spectra, to noise and to load cases that vibrate consist of: modes, what each base excites of them, how strong each column is
//! under noise, where it is greatest in each case.

use serde::Serialize;

use crate::results::curve::Column;
use crate::scene::LoadSet;

/// Modes, bases, noise.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct VibrationSummary {
    /// The modes, lowest first.
    pub modes: Vec<SwingingMode>,
    /// What each base that shakes excites, in the order of the scene.
    pub bases: Vec<BaseSummary>,
    /// Each column under noise; empty where there is none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub noise: Vec<NoiseSummary>,
    /// Load cases and combinations in steady vibration, in the order of their numbers in the curve; empty where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub cases: Vec<SwingingCase>,
}

impl VibrationSummary {
    /// What of it a program tells in lines: how much of the mass the modes have, which of them has most, how strong noise is.
    pub fn lines(&self) -> Vec<String> {
        let of_base = |(number, base): (usize, &BaseSummary)| {
            let all = base.modes.iter().zip(&self.modes).enumerate();
            let most = all.max_by(|a, b| a.1.0.effective_mass.total_cmp(&b.1.0.effective_mass));
            let most = most.map_or_else(String::new, |(mode, (own, swings))| {
                let (mode, share) = (mode + 1, 100.0 * own.effective_mass / base.mass);
                format!("; most has mode {mode} of the frequency {:.4e}, {share:.2} %, with the participation factor {:.4e}", swings.frequency, own.participation)
            });
            format!(
                "base {}: {} modes have {:.2} % of the mass{most}",
                number + 1,
                base.modes.len(),
                100.0 * base.share
            )
        };
        let of_noise = |own: &NoiseSummary| {
            let crosses =
                own.crossings.map_or_else(String::new, |by| format!(", crosses zero {by:.4e} times by time"));
            format!(
                "{}: root mean square {:.4e} {}{crosses}",
                own.column.name, own.root_mean_square, own.column.unit
            )
        };
        let bases = self.bases.iter().enumerate().filter(|(_, base)| base.mass > 0.0).map(of_base);
        let of_case = |own: &SwingingCase| {
            let peak = |own: &CasePeak| {
                let CasePeak { column, amplitude, frequency } = own;
                format!("{} {amplitude:.4e} {} at {frequency:.4e}", column.name, column.unit)
            };
            let peaks: Vec<String> = own.peaks.iter().map(peak).collect();
            format!("{}: greatest {}", own.set.name, peaks.join(", "))
        };
        bases.chain(self.noise.iter().map(of_noise)).chain(self.cases.iter().map(of_case)).collect()
    }
}

/// A load case or a combination that vibrates.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SwingingCase {
    /// Which it is.
    #[serde(flatten)]
    pub set: LoadSet,
    /// Each measured column where its amplitude is greatest.
    pub peaks: Vec<CasePeak>,
}

/// The greatest amplitude of a column over the frequencies asked for.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CasePeak {
    /// The column.
    #[serde(flatten)]
    pub column: Column,
    /// Its amplitude.
    pub amplitude: f64,
    /// Where it is met \[1/T\].
    pub frequency: f64,
}

/// A mode.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SwingingMode {
    /// Its frequency, in cycles by time \[1/T\].
    pub frequency: f64,
    /// Part of the critical damping \[–\].
    pub damping: f64,
}

/// What a base excites.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BaseSummary {
    /// Unit vector along which it is accelerated.
    pub direction: [f64; 3],
    /// Mass that moves against it: all but what is held \[F T²/L\].
    pub mass: f64,
    /// Effective masses of all modes together, over that \[–\].
    pub share: f64,
    /// Greatest acceleration of the ground \[L/T²\]; none of noise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ground: Option<f64>,
    /// What it excites of each mode.
    pub modes: Vec<ExcitedMode>,
    /// What the mass that modes leave out makes of each column; empty where it is left out, and of noise.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub missing_mass: Vec<f64>,
}

/// What a base excites of a mode.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExcitedMode {
    /// Participation factor of the shape of mass one, Γ = φᵀMr \[√(F T²/L)\].
    pub participation: f64,
    /// Effective mass, Γ² but for how a shell lumps its masses; those of all modes are the mass that moves \[F T²/L\].
    pub effective_mass: f64,
    /// What the spectrum says of it, an acceleration \[L/T²\]; none of noise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<f64>,
    /// Its greatest share in each column, with its sign; empty of noise.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub columns: Vec<f64>,
}

/// A column under noise, over all frequencies.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NoiseSummary {
    /// The column, in the unit of what it measures.
    #[serde(flatten)]
    pub column: Column,
    /// Root mean square: under Gaussian noise what it exceeds 32 % of the time.
    pub root_mean_square: f64,
    /// How often it crosses zero upwards, by time \[1/T\]; none of what stands still.
    pub crossings: Option<f64>,
}
