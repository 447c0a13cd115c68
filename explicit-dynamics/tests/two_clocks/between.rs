//! What structures in a gas do to each other: a bumper between two, and the steps that it asks for.

use explicit_dynamics::{Interaction, March, Places, TwoClocks};

use crate::marching::{CELLS, COURANT, Coupled, MASS, Notes, march, state, take_up, transient};
use crate::model::{Column, DENSITY, LENGTH, Spring};

/// `½ k d²` of the depth `d = near − (x₁ − x₀)` where that is positive; deep in it steps have to be shorter.
struct Bumper {
    stiffness: f64,
    near: f64,
    shorter: f64,
}

impl Bumper {
    fn depth(&self, at: &[[f64; 3]]) -> f64 {
        (self.near - (at[1][0] - at[0][0])).max(0.0)
    }
}

impl Interaction for Bumper {
    fn particles(&self) -> Vec<Vec<u32>> {
        vec![vec![0], vec![0]]
    }
    fn evaluate(&mut self, at: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        let depth = self.depth(at);
        forces[0] = [-self.stiffness * depth, 0.0, 0.0];
        forces[1] = [self.stiffness * depth, 0.0, 0.0];
        0.5 * self.stiffness * depth * depth
    }
    fn resist(&self, _: &[[f64; 3]], _: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        forces.fill([0.0; 3]);
    }
    fn fastest(&self, masses: &[f64]) -> f64 {
        self.stiffness * (1.0 / masses[0] + 1.0 / masses[1])
    }
    fn shortened(&mut self, stable: f64, _: f64, now: &Places<'_>) -> f64 {
        if self.depth(now.at) > 0.0 { self.shorter * stable } else { stable }
    }
}

/// Mass of pistons that the gas stops far behind where they bump.
const HEAVY: f64 = 1.0;

/// Free pistons at both ends of the gas that come towards each other and bump, whatever the gas between them says of that.
fn pistons(shorter: f64) -> Coupled {
    let fluid = Column::new(CELLS, COURANT);
    let dt = fluid.dt;
    let piston = |v: f64| {
        let mut piston = Spring::new(HEAVY, 0.0, dt / 3.0);
        piston.v = v;
        Box::new(piston)
    };
    let bumper = Bumper { stiffness: 3e4, near: -5e-5, shorter };
    TwoClocks::new(fluid, vec![piston(1e-3), piston(-1e-3)]).with_interactions(vec![Box::new(bumper)])
}

#[test]
fn a_bump_keeps_energy_and_momentum_and_makes_steps_shorter() {
    let total = |system: &Coupled| {
        let gas: f64 = system.fluid().velocities.iter().sum::<f64>() * DENSITY * LENGTH / CELLS as f64;
        let own = system.structures().enumerate();
        gas + own
            .map(|(k, piston)| HEAVY * piston.v - system.impulse_ahead(k).map_or(0.0, |[x, ..]| x))
            .sum::<f64>()
    };
    for shorter in [1.0, 0.37] {
        let mut system = pistons(shorter);
        let (notes, end) = march(&mut system, 160, 1);
        end.unwrap();
        assert!(total(&system).abs() < 1e-13 * HEAVY * 1e-3, "{}", total(&system));
        // Something bumped, and bounced off.
        let [left, right] = [0, 1].map(|k| system.structures().nth(k).map_or(0.0, |piston| piston.v));
        assert!(left < -4e-4 && (left + right).abs() < 1e-12 * left.abs(), "{left} {right}");
        let turned = notes.records[0].energy.kinetic;
        let open = notes.records.iter().map(|record| record.balance_error.abs() / turned).fold(0.0, f64::max);
        assert!(open < OPEN, "{shorter}: {open}");
        assert_eq!(system.slowed().steps > 0, shorter < 1.0);
        let most = if shorter < 1.0 { 9 } else { 3 };
        assert!(system.counts().most >= most, "{:?}", system.counts());
    }
}

/// Measured .0017, with the bump or without: the kicks of the gas and those of the pistons have other middles.
const OPEN: f64 = 0.005;

#[test]
fn what_does_nothing_changes_no_bit_of_structures_of_one_step() {
    let fluid = || Column::new(CELLS, COURANT);
    let dt = fluid().dt;
    let spring = |x: f64| Box::new(Spring::new(MASS, 4e3, dt / 3.0).at(x));
    let mut alone = TwoClocks::new(fluid(), vec![spring(1e-4), spring(-1e-4)]);
    let nothing = Bumper { stiffness: 0.0, near: -1.0, shorter: 1.0 };
    let mut joined =
        TwoClocks::new(fluid(), vec![spring(1e-4), spring(-1e-4)]).with_interactions(vec![Box::new(nothing)]);
    march(&mut alone, 300, 30).1.unwrap();
    march(&mut joined, 300, 30).1.unwrap();
    assert_eq!(state(&alone), state(&joined));
}

#[test]
fn a_bump_goes_on_to_the_same_bits() {
    let bits = |system: &Coupled| state(system).into_iter().flatten().map(f64::to_bits).collect::<Vec<_>>();
    for keep_at in [1, 30, 31, 97, 250] {
        let (mut whole, mut again) = (pistons(0.37), pistons(0.37));
        let mut notes = Notes { keep_at: Some(keep_at), ..Notes::default() };
        let march = March::start(transient(&whole, 400, 30), &mut whole).unwrap();
        notes.lead(march, &mut whole).unwrap();
        let (at, kept) = notes.kept.unwrap();
        take_up(&mut again, &kept);
        March::resume(transient(&again, 400, 30), at).finish(&mut again).unwrap();
        assert!(bits(&whole) == bits(&again), "from step {keep_at}");
    }
}
