//! Energies of a point that yields, by volume: what is stored, and what is dissipated.

use super::point::{Backs, Committed, Point};
use super::return_map::PointLaw;
use crate::pack::Number;

impl PointLaw {
    /// Whether it dissipates anything beside `K(0) α`: against overstresses, or where back stresses recover.
    pub fn loses_more(&self) -> bool {
        self.loses_more
    }

    /// Work per volume \[F/L²\]: stored elastically, stored by hardening, dissipated by `K(0) α`.
    #[inline(always)]
    pub fn work<P: Number>(&self, stress: &[P; 3], now: &Committed<P>) -> [P; 3] {
        let elastic = (stress[0] * stress[0] + stress[1] * stress[1] + stress[2] * stress[2]) * 0.5;
        let mut hardened = self.hardening().stored(now.alpha);
        if self.kinematic > 0.0 {
            for i in 0..3 {
                hardened += now.plastic[i] * now.plastic[i] * (0.5 * self.kinematic / self.yielding[i]);
            }
        }
        if !self.backs.is_empty() {
            hardened += self.stored_in(&now.backs, now.alpha.all(0.0));
        }
        [elastic, hardened, now.alpha * self.hardening().initial()]
    }

    /// What a point is committed as behind a step.
    #[inline(always)]
    pub fn after<P: Number>(&self, point: &Point<P>, before: &Committed<P>) -> Committed<P> {
        let mut backs: Backs<P> = before.backs;
        for (number, b) in backs.iter_mut().enumerate().take(self.backs.len()) {
            *b = self.moved(number, b, point, before.alpha);
        }
        Committed { plastic: point.plastic, alpha: point.alpha, backs }
    }

    /// What a step dissipates by volume beside `K(0) α`: against its overstress `s ∫K dα`, and what back stresses recover \[F/L²\].
    #[inline(always)]
    pub fn lost<P: Number>(&self, overstress: P, before: &Committed<P>, after: &Committed<P>) -> P {
        let all = |alpha: P| self.hardening().stored(alpha) + alpha * self.hardening().initial();
        let against = (all(after.alpha) - all(before.alpha)) * overstress;
        if self.backs.is_empty() {
            return against;
        }
        against + self.recovered(&after.backs, after.alpha - before.alpha)
    }
}
