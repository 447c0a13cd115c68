//! A shell that several march together: whole marches to the same bits, what is read of it, and what one marches alone.

use crate::common::{self, flat, parts, records, shell, supported};
use explicit_dynamics::{Amplitude, Bounds, Damping, Dynamics, Instant, Plan, QuasiStatic, Step, Transient};
use peers::{Peers, together};
use shell_kinematics::StretchCorrected;
use sph_core::{Side, Vec3};
use sph_shell::{
    Clamped, DrillingCouple, Formulation, Gravity, Load, Moved, Pressure, Reach, Shell, ShellError,
    SymmetryPlane,
};

const CELLS: Formulation = Formulation::StressPoint(Reach::Cell);

/// A strip of several chunks, clamped at one end and lifted at the other, under its weight and a pressure.
fn strip() -> Shell {
    let cloud = flat([161, 11], [4.0, 0.25]);
    let sides = cloud.sides.clone().unwrap();
    let end = |side: Side| sides.edge(side).to_vec();
    let lifted = Moved { direction: Vec3::z(), by: 0.05, amplitude: Amplitude::Ramp(0.2) };
    let supports = vec![supported(end(Side::U0), Clamped), supported(end(Side::U1), lifted)];
    // Couples about normals of a line along the border of two shares, and of an area across it.
    let across = (0..11).map(|j| (46 * 11 + j, 1.0)).collect();
    let loads: Vec<Box<dyn Load>> = vec![
        Box::new(Gravity { acceleration: Vec3::new(0.0, 0.3, -0.2) }),
        Box::new(Pressure { value: 0.02, follower: true }),
        Box::new(DrillingCouple::new(&cloud, across, Vec3::z(), 0.01)),
        Box::new(DrillingCouple::new(&cloud, (700..900).map(|a| (a, 1.0)).collect(), Vec3::z(), 0.01)),
    ];
    shell(cloud, CELLS, 0.05, &StretchCorrected, supports, loads)
}

/// One of those who march it together.
pub fn shared(mut shell: Shell, peers: Box<dyn Peers>) -> Shell {
    shell.share(peers).unwrap();
    shell
}

/// A short march in real time, and a quasi-static one.
pub fn plans() -> [Plan; 2] {
    let transient = Transient { duration: 0.02, record_every: 0.005, damping: 0.2, safety: 0.8 };
    let quasi_static = QuasiStatic {
        levels: vec![0.5, 1.0],
        period: None,
        ramp: 1.0,
        hold: 0.5,
        damping: Damping::Ratio(0.5),
        tolerance: 1e-3,
        accuracy: 0.5,
        safety: 0.8,
    };
    [Plan::from(transient), Plan::from(quasi_static)]
}

/// Everything that a march tells, as words; and what is read of the shell at its end.
pub fn reported(plan: &Plan, mut shell: Shell) -> (Vec<String>, Vec<u64>) {
    marched(plan, &mut shell)
}

/// The same of a shell that is read further.
pub fn marched(plan: &Plan, shell: &mut Shell) -> (Vec<String>, Vec<u64>) {
    let records = records(plan.clone(), shell).unwrap();
    shell.bring();
    let motion = shell.motion().into_iter().flatten().flatten().map(|x| x.to_bits());
    let borne = |a| [shell.reaction(a), shell.reaction_moment(a)];
    let borne = (0..shell.len()).flat_map(borne).flat_map(|f| [f.x, f.y, f.z]).map(f64::to_bits);
    let read = motion.chain(borne).chain(shell.history().into_iter().map(f64::to_bits)).collect();
    (records.iter().map(|record| format!("{record:?}")).collect(), read)
}

/// In real time and quasi-statically, with the checks of rest: one to seven processes tell the same, to the bit.
#[test]
fn marches_tell_the_same_whoever_makes_them() {
    for plan in plans() {
        let alone = reported(&plan, strip());
        assert!(alone.0.len() > 2, "{:?}", alone.0);
        for count in [1, 2, 3, 4, 7] {
            let all = together(count, |peers| reported(&plan, shared(strip(), peers))).unwrap();
            for (rank, found) in all.into_iter().enumerate() {
                assert!(found == alone, "{count} peers, rank {rank}");
            }
        }
    }
}

/// Each moves its own particles alone, and all of them are somebody's.
#[test]
fn particles_are_shared_out() {
    let mut owned = together(3, |peers| shared(strip(), peers).own_particles()).unwrap();
    owned.sort_by_key(|own| own.start);
    assert_eq!(owned, [0..512, 512..1024, 1024..161 * 11]);
    assert_eq!(strip().own_particles(), 0..161 * 11);
}

/// A shell that turns inside out is refused by all with the same words.
#[test]
fn all_refuse_a_state_beyond_the_model() {
    let words = |peers: Option<Box<dyn Peers>>| {
        let mut shell = strip();
        if let Some(peers) = peers {
            shell.share(peers).unwrap();
        }
        // In a march: particles of others are behind.
        let at = |time: f64| Instant { time, level: time };
        let step = |time: f64| Step { from: at(time), to: at(time + 1e-4), kick: 1e-4, damping: 0.0 };
        (0..3).for_each(|number| _ = shell.advance(&step(1e-4 * f64::from(number))));
        let a = 1300;
        shell.set_state(a, shell.position(a) + Vec3::new(0.5, 0.0, 0.0), shell.director(a));
        shell.within_bounds(Bounds::Configuration).unwrap_err().to_string()
    };
    let alone = words(None);
    println!("{alone}");
    for count in [2, 3] {
        assert_eq!(together(count, |peers| words(Some(peers))).unwrap(), vec![alone.clone(); count]);
    }
}

/// What one marches alone says so.
#[test]
fn what_is_not_shared_is_refused() {
    let refused = |build: &(dyn Fn() -> Shell + Sync)| {
        let all = together(2, |peers| match build().share(peers) {
            Err(ShellError::NotShared(what)) => what,
            _ => "not refused",
        });
        all.unwrap()[0]
    };
    let plate = || flat([5, 5], [1.0, 1.0]);
    let wide = || Shell::builder(parts(plate(), common::energy_formulations()[1].1, 0.1)).build().unwrap();
    let said = refused(&wide);
    println!("{said:?}");
    assert!(said.starts_with("a shell "), "{said:?}");
    let symmetry = || {
        let cloud = plate();
        let held = cloud.sides.as_ref().unwrap().edge(Side::U0).to_vec();
        let supports = vec![supported(held, SymmetryPlane { normal: Vec3::x() })];
        shell(cloud, CELLS, 0.1, &StretchCorrected, supports, Vec::new())
    };
    assert_eq!(refused(&symmetry), "not refused");
}
