//! What a history says about a point that yielded: thickness, plastic strain, what its flow leaves, and the work that it holds.

use super::section::{OF_SECTION, PlasticSection};
use super::thickness;
use crate::pack::{Number, Pack};

/// A history of a [`PlasticSection`], read.
#[derive(Clone, Copy, Debug)]
pub struct Tallies<'a> {
    section: &'a PlasticSection,
    history: &'a [Pack],
}

impl PlasticSection {
    /// What a committed history says.
    pub fn tallies<'a>(&'a self, committed: &'a [Pack]) -> Tallies<'a> {
        Tallies { section: self, history: committed }
    }
}

impl Tallies<'_> {
    /// Present thickness over thickness at rest λ₃ \[–\].
    pub fn thickness(&self) -> Pack {
        self.history[self.section.of_section] + Pack::splat(1.0)
    }

    /// Share χ that the flow of the step committed last left of a stress beside the yield surface: 0.02 to 1 \[–\].
    pub fn kept_share(&self) -> Pack {
        Pack::splat(1.0) - self.history[self.section.of_section + thickness::NUMBERS]
    }

    /// Greatest equivalent plastic strain α of the points \[–\].
    pub fn plastic_strain(&self) -> Pack {
        self.folded(|most, _, alpha| most.max(alpha))
    }

    /// Share of the thickness that has ever flowed \[–\].
    pub fn yielded_share(&self) -> Pack {
        let flowed = |alpha: Pack| alpha.each(|alpha| if alpha > 0.0 { 1.0 } else { 0.0 });
        self.folded(|sum, weight, alpha| sum + flowed(alpha) * (weight / self.section.scales.thickness))
    }

    /// Work per reference area that was dissipated, `Σ w K(0) α`, what went against overstresses and what back stresses recovered \[F/L\].
    pub fn dissipated(&self) -> Pack {
        let slow = self.worked()[1];
        if self.section.loses_more { slow + self.history[self.section.of_section + OF_SECTION] } else { slow }
    }

    /// Work per reference area that hardening stores by convention, `Σ w (½β:εp + ∫(K − K(0)) dα)`, of back stresses that recover what they
    /// store \[F/L\].
    pub fn hardened(&self) -> Pack {
        self.worked()[0]
    }

    /// A sum over the points of weight and equivalent plastic strain.
    fn folded(&self, add: impl Fn(Pack, f64, Pack) -> Pack) -> Pack {
        let yielding = self.section.layers.iter().filter(|layer| layer.law.is_some());
        let points = yielding.flat_map(|layer| layer.points());
        points.fold(Pack::ZERO, |sum, (slice, place)| add(sum, slice.weight, self.history[place + 3]))
    }

    fn worked(&self) -> [Pack; 2] {
        let mut out = [Pack::ZERO; 2];
        for layer in &self.section.layers {
            let Some(law) = &layer.law else { continue };
            for (slice, place) in layer.points() {
                let now = layer.committed(law, |i| self.history[i], place);
                let [_, hardened, dissipated] = law.work(&[Pack::ZERO; 3], &now);
                out[0] += hardened * slice.weight;
                out[1] += dissipated * slice.weight;
            }
        }
        out
    }
}
