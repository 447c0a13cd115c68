//! What may be wrong with a steady vibration: peaks that frequencies miss, modes that are too few, no damping.

use std::f64::consts::TAU;

use implicit_statics::HarmonicDamping;

use crate::WarningKind;
use crate::run::Run;

/// Part of a peak's height that may be missing at the nearest frequency: a peak is `1/√(1 + x²)`, x the distance over half of its width.
const MISSED: f64 = 0.05;
/// Part of the last mode's frequency up to which modes and the shape that stands for the others answer: see docs/vibration.md.
const COVERED: f64 = 0.7;

/// Frequencies that were asked for, and what is known of the body.
pub(in crate::analyses) struct Warnings<'a> {
    /// Circular frequencies \[1/T\], in order.
    pub frequencies: &'a [f64],
    pub damping: HarmonicDamping,
    /// Natural ones, where modes were found \[1/T\].
    pub natural: Option<&'a [f64]>,
    /// How many natural ones lie below each, where nothing damps and they were counted.
    pub below: &'a [usize],
}

/// Warns of a state that would leave its place.
pub(in crate::analyses) fn unstable(negative: usize, run: &mut Run<'_>) {
    if negative > 0 {
        let message = format!(
            "the state that vibrates is not stable ({negative} motions against which nothing holds it): what it does is no steady vibration \
             but a fall; lower the stress or the preload, or look for the critical one with [analysis.buckling]"
        );
        run.record.warn(WarningKind::Unstable, message);
    }
}

/// Warns of a highest circular frequency \[1/T\] that lies beyond what modes answer for.
pub(in crate::analyses) fn truncated(last: Option<f64>, natural: Option<&[f64]>, run: &mut Run<'_>) {
    let Some(last) = last else { return };
    let covered = natural.and_then(|natural| natural.last()).map(|&highest| COVERED * highest);
    if let Some(covered) = covered.filter(|&covered| last > covered) {
        let message = format!(
            "the highest frequency, {:.5e}, is beyond {COVERED} of that of the last mode, {:.5e}: modes above it swing there, and are but one \
             shape in the answer; ask for more `modes`, or leave them out",
            last / TAU,
            covered / COVERED / TAU
        );
        run.record.warn(WarningKind::TruncatedModes, message);
    }
}

impl Warnings<'_> {
    /// Warns of what is doubtful.
    pub fn say(&self, run: &mut Run<'_>) {
        let [Some(&first), Some(&last)] = [self.frequencies.first(), self.frequencies.last()] else { return };
        let message = match self.damping {
            HarmonicDamping::None => self.undamped([first, last]),
            damping => self.coarse(damping, [first, last]),
        };
        if let Some((kind, message)) = message {
            run.record.warn(kind, message);
        }
    }

    /// Natural frequencies that lie between those asked for, where nothing damps.
    fn undamped(&self, [first, last]: [f64; 2]) -> Option<(WarningKind, String)> {
        let counted =
            self.below.last().zip(self.below.first()).map(|(last, first)| last.saturating_sub(*first));
        let found = self.natural.map(|all| all.iter().filter(|&&own| (first..=last).contains(&own)).count());
        let number = found.or(counted).filter(|&number| number > 0)?;
        let message = format!(
            "nothing damps the body, and {number} of its natural frequencies lie between the first and the last one: at those amplitudes have no \
             bound, and near them they are a matter of how near; give `damping`"
        );
        Some((WarningKind::Undamped, message))
    }

    /// The peak that is missed furthest, or steps that may miss one.
    fn coarse(&self, damping: HarmonicDamping, [first, last]: [f64; 2]) -> Option<(WarningKind, String)> {
        let missed = |off: f64, natural: f64| {
            let x = off / (damping.ratio(natural) * natural);
            1.0 - 1.0 / (1.0 + x * x).sqrt()
        };
        let pairs = || self.frequencies.windows(2).map(|pair| [pair[0], pair[1]]);
        let (natural, off, step) = match self.natural {
            Some(all) => {
                let inside = all.iter().filter(|&&own| (first..=last).contains(&own) && own > 0.0);
                let nearest = inside.filter_map(|&own| {
                    let [low, high] = pairs().find(|&[low, high]| (low..=high).contains(&own))?;
                    Some((own, (own - low).min(high - own), high - low))
                });
                nearest.max_by(|a, b| missed(a.1, a.0).total_cmp(&missed(b.1, b.0)))?
            }
            None => {
                let middles = pairs().map(|[low, high]| (0.5 * (low + high), 0.5 * (high - low), high - low));
                middles.max_by(|a, b| missed(a.1, a.0).total_cmp(&missed(b.1, b.0)))?
            }
        };
        let part = missed(off, natural);
        // A peak of width 2ζω is met within the bound by steps of this many widths.
        let enough = 2.0 * (1.0 / (1.0 - MISSED).powi(2) - 1.0).sqrt() * damping.ratio(natural) * natural;
        (part > MISSED).then(|| {
            let what = match self.natural {
                Some(_) => format!("the natural frequency {:.5e} lies between two", natural / TAU),
                None => format!("a natural frequency near {:.5e} may lie between two", natural / TAU),
            };
            let message = format!(
                "{what} that are {:.3e} apart, where damping makes its peak {:.3e} wide: what stands in the curve may be {:.0} % below it, at most {:.0} % \
                 are let pass; take steps of {:.3e} there",
                step / TAU,
                2.0 * damping.ratio(natural) * natural / TAU,
                100.0 * part,
                100.0 * MISSED,
                enough / TAU
            );
            (WarningKind::CoarseFrequencies, message)
        })
    }
}
