//! How greatest answers of modes, which are met at times of their own, make one.

use serde::{Deserialize, Serialize};

/// How greatest answers of modes are combined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "scene", derive(schemars::JsonSchema))]
pub enum Combination {
    /// `√(ΣΣ ρ_ij R_i R_j)`: complete quadratic combination, by how modes go together under noise \[wilson1981\].
    #[default]
    Cqc,
    /// `√(Σ R_i²)`: as if no mode knew of another; frequencies near each other are then wrong.
    Srss,
    /// `Σ |R_i|`: as if all were met at once, an upper bound.
    Absolute,
}

/// How answers to several directions are combined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "scene", derive(schemars::JsonSchema))]
pub enum DirectionRule {
    /// `√(Σ R_d²)`.
    #[default]
    Srss,
    /// All of one direction with three tenths of the others: the greatest of these sums.
    HundredThirty,
    /// `Σ |R_d|`.
    Absolute,
}

impl DirectionRule {
    /// The whole of answers to directions, none of them negative.
    pub fn of(self, parts: &[f64]) -> f64 {
        let sum: f64 = parts.iter().sum();
        match self {
            Self::Srss => root_of_squares(parts),
            Self::HundredThirty => parts.iter().fold(0.0, |most, own| most.max(0.7 * own + 0.3 * sum)),
            Self::Absolute => sum,
        }
    }
}

/// Modes by which greatest answers are combined.
#[derive(Clone, Debug, PartialEq)]
pub struct ModesTogether {
    rule: Combination,
    /// `ρ_ij`, row by row; none of a rule that asks for none.
    correlations: Vec<f64>,
}

impl ModesTogether {
    /// Of modes with these `[ω, ζ]`: circular frequency \[1/T\] and part of the critical damping \[–\].
    pub fn new(rule: Combination, modes: &[[f64; 2]]) -> Self {
        let rows = if rule == Combination::Cqc { modes } else { &[] };
        let correlations = rows.iter().flat_map(|&i| modes.iter().map(move |&j| correlation(i, j)));
        Self { rule, correlations: correlations.collect() }
    }

    /// The whole of greatest answers of the modes, with their signs, and of what all other modes make of the stiff end of the spectrum, which is in step
    /// with the ground and so a part of its own.
    pub fn of(&self, peaks: &[f64], rest: f64) -> f64 {
        let modes = match self.rule {
            Combination::Absolute => return peaks.iter().map(|peak| peak.abs()).sum::<f64>() + rest.abs(),
            Combination::Srss => root_of_squares(peaks),
            Combination::Cqc => self.quadratic(peaks),
        };
        libm::hypot(modes, rest)
    }

    /// `√(Rᵀ ρ R)`, scaled so that no square leaves the range of numbers.
    fn quadratic(&self, peaks: &[f64]) -> f64 {
        let most = greatest(peaks);
        if most == 0.0 {
            return 0.0;
        }
        let row = |row: &[f64]| row.iter().zip(peaks).map(|(rho, peak)| rho * (peak / most)).sum::<f64>();
        let rows = self.correlations.chunks(peaks.len()).zip(peaks);
        let sum: f64 = rows.map(|(own, peak)| peak / most * row(own)).sum();
        most * sum.max(0.0).sqrt()
    }
}

/// How far two modes `[ω, ζ]` go together under white noise, from 0 to 1 \[wilson1981\]:
///
/// ```text
/// ρ = 8 √(ζᵢζⱼ) (ζᵢ + r ζⱼ) r^{3/2} / ((1 − r²)² + 4 ζᵢζⱼ r (1 + r²) + 4 (ζᵢ² + ζⱼ²) r²)        r = ωⱼ/ωᵢ
/// ```
pub fn correlation([first, zeta]: [f64; 2], [second, other]: [f64; 2]) -> f64 {
    if [first, zeta] == [second, other] {
        return 1.0;
    }
    if first <= 0.0 || second <= 0.0 {
        return 0.0;
    }
    let r = second / first;
    let apart = (1.0 - r) * (1.0 + r);
    let wide = 4.0 * zeta * other * r * (1.0 + r * r) + 4.0 * (zeta * zeta + other * other) * r * r;
    if wide == 0.0 {
        return 0.0;
    }
    8.0 * (zeta * other).sqrt() * (zeta + r * other) * r * r.sqrt() / (apart * apart + wide)
}

fn greatest(parts: &[f64]) -> f64 {
    parts.iter().fold(0.0_f64, |most, own| most.max(own.abs()))
}

fn root_of_squares(parts: &[f64]) -> f64 {
    let most = greatest(parts);
    if most == 0.0 {
        return 0.0;
    }
    most * parts.iter().map(|own| (own / most) * (own / most)).sum::<f64>().sqrt()
}
