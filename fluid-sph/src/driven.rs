//! What a current does to a fluid.

use sph_core::Vec3;

use crate::books::by_cells;
use crate::current::Current;
use crate::fluid::Fluid;
use crate::pair::Row;
use crate::sorted::Sorted;

impl Fluid {
    /// Carries the water along in a zone, of a fluid that is marched by kicks and drifts.
    pub fn carry(&mut self, current: Current) {
        self.current = Some(current);
    }

    /// Draws velocities in the zone to that of the current over a kick, `v ← U + (v − U) (1 − ½βκ)/(1 + ½βκ)`; the power that this gives a unit of mass,
    /// of all \[L²/T³\].
    pub(crate) fn drive(&mut self, kick: f64) -> f64 {
        let Some(current) = self.current else { return 0.0 };
        if kick == 0.0 {
            return 0.0;
        }
        let Self { threads, accelerations, grid, sorted, share, .. } = self;
        let Sorted { starts, rows, left, .. } = sorted;
        let adds = |cell: usize| share.adds(grid, cell);
        let velocity = current.along * current.velocity;
        let numbers = |_: usize, row: &mut Row| {
            let rate = current.rate(row.at());
            if rate == 0.0 {
                return [0.0];
            }
            let (old, left) =
                (Vec3::from(row.velocity()), (1.0 - 0.5 * rate * kick) / (1.0 + 0.5 * rate * kick));
            let new = velocity + (old - velocity) * left;
            row.set_velocity(new.into());
            [(new - old).dot(&(new + old)) * (0.5 / kick)]
        };
        let [sum] =
            share.add(by_cells(*threads, starts, left, &mut rows[..accelerations.len()], &adds, &numbers));
        sum
    }
}
