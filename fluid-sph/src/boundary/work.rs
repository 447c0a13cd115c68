//! Work of boundaries on the fluid: of their motion, and of the pressure that they have of themselves.
//!
//! A pair of fluid a and boundary w exchanges `T + U` at the rate of the force on a times v_w, as between bodies, and besides
//!
//! ```text
//! −m (P_w/ρ_w²) m F (v_a − v_w)·r_aw:   summed over a, −m (P_w/ρ_w²) D_w,   D_w = Σ_a m F v_wa·r_wa
//! ```
//!
//! for the pressure of the boundary acts on fluid that comes nearer, and D_w is the rate of density that the boundary would
//! have. Where it has one, that is energy of compression stored in the wall; a pressure carried over from the fluid is no
//! function of any density, and what it takes and gives is work from outside. Rates belong to the middle of a step, forces
//! and pressures to its ends: each end gets half.

use sph_core::Vec3;

use crate::boundary::points::Boundary;
use crate::cells::NOWHERE;
use crate::pair::Row;

impl Boundary {
    /// Power of the motion of all points on the fluid \[F L/T\]: minus that of the fluid on them.
    pub fn power(&self) -> f64 {
        let power = |(force, velocity): (&[f64; 3], &Vec3)| -Vec3::from(*force).dot(velocity);
        self.forces.iter().zip(&self.velocities).map(power).sum()
    }

    /// Power of the pressure of all points on the fluid, over the mass of a particle, from rows and rates as they are.
    pub fn pressing(&self) -> f64 {
        let power = |(row, rate): (&Row, &[f64; 2])| -row.p_over_rho2() * rate[0];
        self.sorted.rows.iter().zip(&self.rates).map(power).sum()
    }

    /// Work of the half step after the last forces, from the rates in the middle of a step; `mass` of a particle.
    pub fn work_before(&mut self, mass: f64, dt: f64) -> f64 {
        let mut work = 0.0;
        let Self { sorted, rates, ledger, .. } = self;
        for ((owed, share), &slot) in ledger.owed.iter_mut().zip(&ledger.shares).zip(&sorted.slots) {
            let rate = if slot == NOWHERE { 0.0 } else { rates[slot as usize][0] };
            *owed = 0.5 * dt * rate;
            work -= share * *owed;
        }
        ledger.time = 0.5 * dt;
        mass * work + 0.5 * dt * self.power()
    }

    /// Work of the half step before the present forces; asked twice, the second time there is none.
    pub fn work_after(&mut self, mass: f64) -> f64 {
        let mut work = 0.0;
        let Self { sorted, ledger, .. } = self;
        for ((share, owed), &slot) in ledger.shares.iter_mut().zip(&mut ledger.owed).zip(&sorted.slots) {
            *share = if slot == NOWHERE { 0.0 } else { sorted.rows[slot as usize].p_over_rho2() };
            work -= *share * std::mem::take(owed);
        }
        let time = std::mem::take(&mut ledger.time);
        mass * work + time * self.power()
    }
}
