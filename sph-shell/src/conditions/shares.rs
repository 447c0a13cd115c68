//! How much of each load falls on degrees of freedom that can move.

use sph_core::Vec3;

use crate::Shell;
use crate::conditions::loads::AppliedLoad;

/// Where a load acts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadShare {
    /// The part that acts on degrees of freedom that no support holds, of `Σ|f|` or of `Σ|τ|`, whichever is more \[–\]; none for a load of size
    /// zero.
    pub free: Option<f64>,
    /// The one particle on which all of it acts, if there is but one.
    pub alone: Option<u32>,
}

impl Shell {
    /// Where each load acts, in the order in which they were given.
    ///
    /// Found in the present state with the amplitude left out. A couple along a director turns nothing and does not count.
    pub fn load_shares(&self) -> Vec<LoadShare> {
        let mut rows = vec![[0.0; 6]; if self.loads.is_empty() { 0 } else { self.len() }];
        let body = self.as_loaded();
        let share = |AppliedLoad { load, .. }: &AppliedLoad| {
            rows.fill([0.0; 6]);
            load.add(1.0, &body, &mut rows);
            self.ties.condense(&self.state, &mut rows, |_, _| ());
            let (mut sums, mut touched, mut last) = ([[0.0; 2]; 2], 0_usize, 0);
            for (a, (row, state)) in rows.iter().zip(&self.state).enumerate() {
                if *row != [0.0; 6] {
                    (touched, last) = (touched + 1, a as u32);
                }
                let ([fx, fy, fz, tx, ty, tz], d) = (*row, Vec3::new(state[3], state[4], state[5]));
                let (force, couple) = ([fx, fy, fz], Vec3::new(tx, ty, tz));
                let across: [f64; 3] = (couple - d * d.dot(&couple)).into();
                let free = self.constraint(a).map_or((force, across), |held| {
                    (held.free_translation(force), held.free_rotation(across))
                });
                for (sum, (whole, free)) in sums.iter_mut().zip([(force, free.0), (couple.into(), free.1)]) {
                    sum[0] += Vec3::from(whole).norm();
                    sum[1] += Vec3::from(free).norm();
                }
            }
            for group in &self.junctions.groups {
                let own = group.body.as_ref().and_then(|body| load.on_body(body.number, body.mass));
                let Some([force, couple]) = own else { continue };
                touched += group.particles.len();
                let free = self.constraint(group.first()).map_or((force, couple), |held| {
                    (held.free_translation(force.into()).into(), held.free_spin(couple))
                });
                for (sum, (whole, free)) in sums.iter_mut().zip([(force, free.0), (couple, free.1)]) {
                    sum[0] += whole.norm();
                    sum[1] += free.norm();
                }
            }
            let parts = sums.into_iter().filter(|sum| sum[0] > 0.0).map(|[whole, free]| free / whole);
            LoadShare { free: parts.reduce(f64::max), alone: (touched == 1).then_some(last) }
        };
        self.loads.iter().map(share).collect()
    }
}
