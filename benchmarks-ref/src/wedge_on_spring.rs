//! A wedge on a spring that enters still water, without gravity: momentum, with the similarity flow of Dobrovol'skaya about it \[dobrovolskaya1969\].
//!
//! ```text
//! (M + m_a D²) V' + k ρ D V² + c D = 0      D' = V      D(0) = 0,  V(0) = V₀
//! ```
//!
//! M and the stiffness c are those of the wedge by width, D its depth. The second term is the force of the flow at a constant speed, the first in brackets what the same water resists
//! at once where the speed changes ([`WedgeEntry::added`](crate::wedge_entry::WedgeEntry)). Left out is that the water which has run up a wedge that slows down lies otherwise than
//! one of constant speed would have it: the wetted face is taken from the depth alone, as at all speeds that are constant. It holds until the wedge turns back.
//!
//! Before it does, what the water resists of the change of speed is more than what it pushes by the speed: it pulls. Water that has a free surface beside the face need not hold
//! on to it; where it does not, the wedge goes on with its spring alone. The energy that the water has is that of the wedge at the start without what wedge and spring hold.

use crate::wedge_entry::WedgeEntry;

/// A wedge on a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WedgeOnSpring {
    /// Mass over the density of water, by width \[L²\].
    pub mass: f64,
    /// Stiffness of the spring over the density of water, by width \[L²/T²\].
    pub stiffness: f64,
    /// Speed at which it meets the water, where the spring is at rest \[L/T\].
    pub speed: f64,
    /// Whether the water may pull.
    pub pulls: bool,
}

/// Where it turns back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// Time from the first touch \[T\].
    pub time: f64,
    /// Depth \[L\].
    pub depth: f64,
    /// Part of its energy that the spring holds then; the rest is in the water.
    pub spring: f64,
}

impl WedgeOnSpring {
    /// Times, depths and speeds until it turns back, in steps of this size by the rule of Runge and Kutta of the fourth order.
    pub fn course(&self, flow: &WedgeEntry, step: f64) -> Vec<[f64; 3]> {
        let rate = |[depth, speed]: [f64; 2]| {
            let (pushed, added) = (flow.force * depth * speed * speed, flow.added * depth * depth);
            let change = -(pushed + self.stiffness * depth) / (self.mass + added);
            let alone = -self.stiffness * depth / self.mass;
            [speed, if self.pulls { change } else { change.min(alone) }]
        };
        let ahead = |[x, v]: [f64; 2], [dx, dv]: [f64; 2], by: f64| [x + by * dx, v + by * dv];
        let (mut state, mut rows) = ([0.0, self.speed], vec![[0.0, 0.0, self.speed]]);
        while state[1] > 0.0 && rows.len() < 1_000_000 {
            let first = rate(state);
            let second = rate(ahead(state, first, 0.5 * step));
            let third = rate(ahead(state, second, 0.5 * step));
            let fourth = rate(ahead(state, third, step));
            for k in 0..2 {
                state[k] += step / 6.0 * (first[k] + 2.0 * (second[k] + third[k]) + fourth[k]);
            }
            rows.push([rows.len() as f64 * step, state[0], state[1]]);
        }
        rows
    }

    /// Where it turns back; none where it does not within a million steps.
    pub fn turn(&self, flow: &WedgeEntry, step: f64) -> Option<Turn> {
        let rows = self.course(flow, step);
        let [.., [time, before, fast], [_, _, back]] = rows[..] else { return None };
        if back > 0.0 {
            return None;
        }
        // The speed falls along a straight line within the last step.
        let part = fast / (fast - back) * step;
        let depth = before + 0.5 * part * fast;
        let spring = self.stiffness * depth * depth / (self.mass * self.speed * self.speed);
        Some(Turn { time: time + part, depth, spring })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flow(force: f64, added: f64) -> WedgeEntry {
        WedgeEntry { force, added, pressure: 0.0, contact: 0.0, tip: 0.0, missing: [0.0; 2] }
    }

    const WEDGE: WedgeOnSpring = WedgeOnSpring { mass: 0.1, stiffness: 5.0, speed: 1.0, pulls: true };

    /// Without water a quarter of a swing; all of the energy is in the spring.
    #[test]
    fn without_water_it_swings() {
        let turn = WEDGE.turn(&flow(0.0, 0.0), 1e-3).unwrap();
        let omega = (WEDGE.stiffness / WEDGE.mass).sqrt();
        assert!((turn.time * omega / (0.5 * std::f64::consts::PI) - 1.0).abs() < 1e-5, "{turn:?}");
        assert!((turn.depth * omega - 1.0).abs() < 1e-6 && (turn.spring - 1.0).abs() < 1e-6, "{turn:?}");
    }

    /// Without a spring and water nothing turns it.
    #[test]
    fn what_nothing_holds_does_not_turn() {
        assert!(WedgeOnSpring { stiffness: 0.0, ..WEDGE }.turn(&flow(0.0, 0.0), 1e-3).is_none());
    }

    /// Water that does not pull leaves the wedge to its spring: the energy of both is then the same to the end. It takes more from the wedge than water that pulls.
    #[test]
    fn water_that_does_not_pull_leaves_it_to_its_spring() {
        let (flow, pressed) = (flow(14.0, 8.0), WedgeOnSpring { pulls: false, ..WEDGE });
        let energy =
            |[_, depth, speed]: &[f64; 3]| WEDGE.mass * speed * speed + WEDGE.stiffness * depth * depth;
        let rows = pressed.course(&flow, 1e-4);
        let end = energy(&rows[rows.len() - 2]);
        let left = rows.iter().position(|row| (energy(row) / end - 1.0).abs() < 1e-6).unwrap();
        assert!(
            rows[left][2] > 0.2 && rows[..left].windows(2).all(|pair| energy(&pair[1]) < energy(&pair[0]))
        );
        let [held, alone] = [WEDGE, pressed].map(|wedge| wedge.turn(&flow, 1e-4).unwrap());
        assert!(alone.depth < held.depth && alone.time < held.time, "{alone:?} {held:?}");
    }

    /// Where the added mass is half of the force, the momentum of wedge and water is that of the start without a spring: a wedge that falls freely has it, (1 + k D²/2M)⁻¹.
    #[test]
    fn without_a_spring_its_momentum_goes_to_the_water() {
        let free = WedgeOnSpring { stiffness: 1e-9, ..WEDGE };
        let rows = free.course(&flow(14.0, 7.0), 1e-3);
        for [_, depth, speed] in rows.iter().take(500) {
            let exact = 1.0 / (1.0 + 7.0 * depth * depth / WEDGE.mass);
            assert!((speed - exact).abs() < 1e-6, "{depth} {speed} {exact}");
        }
    }
}
