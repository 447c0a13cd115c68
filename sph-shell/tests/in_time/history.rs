//! Sections with memory: a point that hardens on its first membrane strain, by its closed form at rest and in time.

use crate::common::{self, THICKNESS, YOUNG, at, derivatives_agree, flat, parts, supported};
use explicit_dynamics::{Amplitude, Clock, Dynamics, Instant, Step, Transient};
use implicit_statics::{Equilibrium, Newton, NewtonOptions};
use shell_kinematics::{
    HistoryPack, Isotropic, IsotropicSection, Memory, Pack, Resultants, Section, SectionScales, Strains,
};
use sph_core::Vec3;
use sph_shell::{
    AppliedLoad, Clamped, Force, Formulation, InitialStress, Load, Parts, PointResult, Reach, Shell,
    ShellError, StaticShell,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

/// Membrane stiffness [F/L], the force at which a point yields [F/L], and its hardening [F/L].
const STIFFNESS: f64 = YOUNG * THICKNESS;
const LIMIT: f64 = 2e-3 * STIFFNESS;
const HARDENING: f64 = 0.25 * STIFFNESS;

/// Isotropic hardening of `N11` on `e11`, elastic otherwise and without Poisson's ratio. A history is the plastic strain p and its length a:
/// `N = E (e − p)`, `|N| ≤ N_y + H a`, `W = ½E (e − p)² + N_y a + ½H a²`.
struct Hardening(IsotropicSection);

/// One point after a strain: force, history, tangent, work.
struct Point {
    force: f64,
    history: [f64; 2],
    tangent: f64,
    work: f64,
}

impl Point {
    fn at(strain: f64, [p, a]: [f64; 2]) -> Self {
        let trial = STIFFNESS * (strain - p);
        let beyond = trial.abs() - (LIMIT + HARDENING * a);
        let slip = beyond.max(0.0) / (STIFFNESS + HARDENING);
        let (p, a) = (p + slip * trial.signum(), a + slip);
        let force = STIFFNESS * (strain - p);
        let plastic = STIFFNESS * HARDENING / (STIFFNESS + HARDENING);
        Self {
            force,
            history: [p, a],
            tangent: if beyond > 0.0 { plastic } else { STIFFNESS },
            work: 0.5 * force * (strain - p) + LIMIT * a + 0.5 * HARDENING * a * a,
        }
    }
}

fn each(strains: &Strains, committed: &[Pack], of: impl Fn(Point) -> f64) -> Pack {
    let (strain, [p, a]) = (strains.membrane[0].lanes(), [committed[0].lanes(), committed[1].lanes()]);
    Pack::from_fn(|lane| of(Point::at(strain[lane], [p[lane], a[lane]])))
}

impl Memory for Hardening {
    fn history_len(&self) -> usize {
        2
    }

    fn history_from(&self, strains: &Strains, _: f64, committed: &[Pack], trial: &mut [Pack]) -> Resultants {
        for (i, number) in trial.iter_mut().enumerate() {
            *number = each(strains, committed, |point| point.history[i]);
        }
        self.resultants_from(strains, committed)
    }

    fn resultants_from(&self, strains: &Strains, committed: &[Pack]) -> Resultants {
        let mut out = self.0.resultants(strains);
        out.membrane[0] = each(strains, committed, |point| point.force);
        out
    }

    fn held_resultants(&self, strains: &Strains, committed: &[Pack]) -> Resultants {
        let mut out = self.0.resultants(strains);
        out.membrane[0] = (strains.membrane[0] - committed[0]) * STIFFNESS;
        out
    }

    fn tangent_from(&self, strains: &Strains, committed: &[Pack]) -> [[Pack; 8]; 8] {
        let mut out = self.0.tangent(strains);
        out[0][0] = each(strains, committed, |point| point.tangent);
        out
    }

    fn energy_from(&self, strains: &Strains, committed: &[Pack]) -> Pack {
        let elastic = strains.membrane[0] * strains.membrane[0] * (0.5 * STIFFNESS);
        self.0.energy(strains) - elastic + each(strains, committed, |point| point.work)
    }
}

impl Section for Hardening {
    fn resultants(&self, strains: &Strains) -> Resultants {
        self.resultants_from(strains, &[Pack::ZERO; 2])
    }

    fn tangent(&self, strains: &Strains) -> [[Pack; 8]; 8] {
        self.tangent_from(strains, &[Pack::ZERO; 2])
    }

    fn energy(&self, strains: &Strains) -> Pack {
        self.energy_from(strains, &[Pack::ZERO; 2])
    }

    fn scales(&self) -> SectionScales {
        self.0.scales()
    }

    fn memory(&self) -> Option<&dyn Memory> {
        Some(self)
    }
}

fn elastic() -> IsotropicSection {
    IsotropicSection::new(Isotropic::new(YOUNG, 0.0).unwrap(), THICKNESS).unwrap()
}

/// A strip 1 × ½ along x, clamped at one end where it is held, under a force at the other that reaches the yield force at level one.
fn strip(counts: [usize; 2], held: bool, threads: usize) -> Parts {
    let cloud = flat(counts, [1.0, 0.5]);
    let (root, tip) = (at(&cloud, |x| x.x < 1e-9), at(&cloud, |x| x.x > 1.0 - 1e-9));
    let load: Box<dyn Load> =
        Box::new(Force { shares: common::line(&cloud, &tip), total: Vec3::x() * (0.5 * LIMIT) });
    Parts {
        section: Box::new(Hardening(elastic())),
        material_axis: Some(Vec3::x()),
        supports: held.then(|| supported(root, Clamped)).into_iter().collect(),
        loads: vec![AppliedLoad { load, amplitude: Amplitude::Constant }],
        threads,
        ..parts(cloud, CELL, THICKNESS)
    }
}

fn built(parts: Parts) -> Shell {
    Shell::builder(parts).build().unwrap()
}

fn bits(numbers: impl IntoIterator<Item = f64>) -> Vec<u64> {
    numbers.into_iter().map(f64::to_bits).collect()
}

fn results(shell: &Shell) -> Vec<PointResult> {
    let mut out = vec![PointResult::default(); shell.reference().operator.points.len()];
    shell.point_results(&mut out);
    out
}

/// The strain under a force by the hardening line `|N| = N_y + H a`, and the history there.
fn closed_form(force: f64, [mut p, mut a]: [f64; 2]) -> (f64, [f64; 2]) {
    let more = ((force.abs() - LIMIT) / HARDENING - a).max(0.0);
    (p, a) = (p + more * force.signum(), a + more);
    (force / STIFFNESS + p, [p, a])
}

/// Pulled past its limit, let go, pressed past it and pulled again, a strip has the strains of its hardening line.
#[test]
fn a_strip_loads_and_unloads_along_its_hardening_line() {
    let mut system = StaticShell::new(built(strip([5, 3], true, 1)));
    let options = NewtonOptions { tolerance: 1e-11, ..NewtonOptions::default() };
    let mut newton = Newton::new(&system, &options).unwrap();
    let (mut history, mut worst) = ([0.0; 2], 0.0_f64);
    for level in [0.6, 1.0, 1.3, 0.9, 0.0, -1.2, -1.45, 0.0, 1.4, 1.6] {
        newton.at_level(&mut system, level).unwrap();
        let shell = system.shell();
        // The force is constant in space: with N along the stretched axis P = N λ.
        let stretch = (1.0 + 2.0 * results(shell)[0].membrane[0]).sqrt();
        let (strain, next) = closed_form(level * LIMIT / stretch, history);
        history = next;
        for found in results(shell) {
            worst = worst.max((found.membrane[0] - strain).abs() * STIFFNESS / LIMIT);
            worst = worst.max((found.force[0] * stretch / LIMIT - level).abs());
        }
    }
    println!("{worst:.1e}, of a plastic strain of {:.2} yield strains", history[1] * STIFFNESS / LIMIT);
    assert!(history[1] * STIFFNESS > 2.0 * LIMIT);
    // Newton's method stops at 1e-11 of the forces and leaves 6e-13 of the yield strain.
    assert!(worst < 2e-12, "{worst:.1e}");
}

/// Forces and tangent are derivatives of the work at the history that was committed, on and inside the limit.
#[test]
fn forces_and_tangent_are_derivatives_at_a_committed_history() {
    for (first, then) in [(1.0, 1.04), (1.02, 1.01), (1.02, 0.97)] {
        let mut shell = built(strip([5, 3], false, 1));
        let mut stretched = |by: f64| {
            let rest = shell.rest_positions().to_vec();
            for (a, x) in rest.iter().enumerate() {
                // Bent a little, so that no strain is that of its neighbours.
                let place = Vec3::new(by * x.x, x.y, 0.02 * x.x * x.y);
                shell.set_state(a, place, Vec3::new(-0.02 * x.y, 0.01, 1.0));
            }
            shell.commit();
        };
        stretched(first);
        let rest = shell.rest_positions().to_vec();
        for (a, x) in rest.iter().enumerate() {
            shell.set_state(
                a,
                Vec3::new(then * x.x, x.y, 0.02 * x.x * x.y),
                Vec3::new(-0.02 * x.y, 0.01, 1.0),
            );
        }
        derivatives_agree(&mut StaticShell::new(shell), 0.0, &format!("{first} then {then}"));
    }
}

/// A level that fails leaves the history as it was; so does one that is taken back.
#[test]
fn a_level_that_is_cut_back_restores_the_history() {
    let mut system = StaticShell::new(built(strip([5, 3], true, 1)));
    let mut newton = Newton::new(&system, &NewtonOptions::default()).unwrap();
    newton.at_level(&mut system, 1.3).unwrap();
    let (saved, known) = (system.save(), bits(system.shell().history()));
    let few = NewtonOptions { iterations: 1, tolerance: 1e-13, ..NewtonOptions::default() };
    assert!(Newton::new(&system, &few).unwrap().at_level(&mut system, 3.0).is_err());
    assert!(bits(system.save()) == bits(saved.clone()) && bits(system.shell().history()) == known);
    let mut once = system.save();
    newton.at_level(&mut system, 1.6).unwrap();
    once.copy_from_slice(&system.save());
    newton.at_level(&mut system, 2.5).unwrap();
    assert!(bits(system.shell().history()) != known);
    system.restore(&saved);
    assert!(bits(system.save()) == bits(saved) && bits(system.shell().history()) == known);
    let mut fresh = Newton::new(&system, &NewtonOptions::default()).unwrap();
    fresh.at_level(&mut system, 1.6).unwrap();
    let apart = system.save().iter().zip(&once).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    println!("apart {apart:.1e}");
    assert!(apart < 1e-10, "{apart:.1e}");
    // Accepted again, nothing changes.
    let known = bits(system.shell().history());
    system.commit();
    assert!(bits(system.shell().history()) == known);
}

/// A strip that sets out fast enough to yield, and the clock that runs it.
fn thrown(threads: usize) -> (Shell, Clock) {
    let mut shell = built(Parts { loads: Vec::new(), ..strip([61, 31], true, threads) });
    for a in 0..shell.len() {
        let x = shell.rest_position(a);
        shell.set_rate(a, Vec3::new(2.0 * x.x, 0.0, 0.2 * x.x * x.x), Vec3::zeros());
    }
    let clock = Clock::start(&mut shell, 1.0, 0.7, 0.01).unwrap();
    (shell, clock)
}

fn steps(shell: &mut Shell, clock: &mut Clock, count: usize) {
    for _ in 0..count {
        clock.step(shell, f64::INFINITY, |_| 1.0).unwrap();
    }
}

fn all(shell: &Shell) -> Vec<u64> {
    bits(shell.motion().into_iter().flatten().flatten().copied().chain(shell.history()))
}

#[test]
fn a_march_goes_on_from_motion_and_history_to_the_same_bits_on_any_threads() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    let whole = |threads: usize| {
        let (mut shell, mut clock) = thrown(threads);
        steps(&mut shell, &mut clock, 120);
        all(&shell)
    };
    let once = whole(1);
    assert!(pool.install(|| whole(2)) == once, "threads change bits");
    let resumed = |with_history: bool| {
        let (mut shell, mut clock) = thrown(1);
        steps(&mut shell, &mut clock, 60);
        assert!(shell.history().iter().any(|number| *number != 0.0));
        let (mut other, _) = thrown(1);
        assert!(other.take_up(shell.motion()));
        assert!(!with_history || other.take_up_history(&shell.history()));
        steps(&mut other, &mut clock, 60);
        all(&other)
    };
    assert!(resumed(true) == once);
    assert!(resumed(false) != once, "the history changes nothing");
    assert!(!thrown(1).0.take_up_history(&[1.0]));
}

/// A step at once and one in two parts commit the same.
#[test]
fn one_sweep_and_two_passes_commit_the_same() {
    let ((mut one, _), (mut two, _)) = (thrown(1), thrown(1));
    let at = |time: f64| Instant { time, level: 1.0 };
    for number in 0..40 {
        let dt = 1e-4;
        let time = f64::from(number) * dt;
        let step = Step { from: at(time), to: at(time + dt), kick: dt, damping: 0.1 };
        one.advance(&step);
        two.evaluate(step.from);
        two.kick(&step);
        two.drift(&step);
    }
    assert!(one.history().iter().any(|number| *number != 0.0));
    assert!(all(&one) == all(&two));
}

/// What the strip stores and what it has dissipated make up for the motion that it loses: the balance closes as the step
/// falls.
#[test]
fn what_is_dissipated_is_in_the_balance() {
    let errors = [0.8, 0.4, 0.2].map(|safety| {
        let mut shell = built(Parts { loads: Vec::new(), ..strip([11, 5], true, 1) });
        for a in 0..shell.len() {
            let x = shell.rest_position(a);
            shell.set_rate(a, Vec3::new(2.0 * x.x, 0.0, 0.0), Vec3::zeros());
        }
        let run = Transient { duration: 0.5, record_every: 0.005, damping: 0.0, safety };
        let records = common::records(run, &mut shell).unwrap();
        let start = records[0].energy.kinetic;
        let last = records.last().unwrap().energy;
        // Most of the motion is gone for good.
        println!("kinetic {:.3}, internal {:.3} of the start", last.kinetic / start, last.internal / start);
        records.iter().fold(0.0, |worst: f64, record| worst.max(record.balance_error.abs())) / start
    });
    println!("{errors:?}");
    // .0030 .00051 .00018
    assert!(errors[1] < errors[0] / 2.0 && errors[2] < errors[1] / 2.0, "{errors:?}");
}

/// Long cells across the strip: the step hangs on the stretch along it. From loading as from unloading it would be a fifth longer.
#[test]
fn the_stable_step_is_that_of_unloading() {
    let step = |stretch: f64| {
        let mut shell = built(strip([21, 3], false, 1));
        for a in 0..shell.len() {
            let x = shell.rest_position(a);
            shell.set_state(a, Vec3::new(stretch * x.x, x.y, x.z), Vec3::z());
        }
        shell.commit();
        shell.stable_step(1.0).unwrap().dt
    };
    let ratio = step(1.0 + 4.0 * LIMIT / STIFFNESS) / step(1.0);
    println!("{ratio}");
    assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
}

#[test]
fn memory_is_refused_where_nothing_would_keep_it() {
    let refused = |builder: sph_shell::ShellBuilder| builder.build().err().unwrap();
    let plain = || parts(flat([4, 3], [1.0, 0.5]), CELL, THICKNESS);
    let wide = Formulation::StressPoint(Reach::Kernel(&sph_core::CubicSpline, 1.4));
    let in_wide = Parts { formulation: wide, ..strip([5, 4], false, 1) };
    assert!(matches!(refused(Shell::builder(in_wide)), ShellError::OwnLaw(_)));
    let stress = InitialStress { cells: vec![0], axis: None, membrane: [1.0, 1.0, 0.0], bending: [0.0; 3] };
    let stressed = Shell::builder(strip([4, 3], false, 1)).stresses(vec![stress]);
    assert!(matches!(refused(stressed), ShellError::OwnLaw(_)));
    // An elastic shell has no history.
    assert!(built(plain()).history().is_empty());
}

/// A pack alone: the committed history is kept by evaluations, and by a commit of the same strains.
#[test]
fn evaluations_leave_a_history_alone() {
    let mut pack = HistoryPack::new(std::sync::Arc::new(Hardening(elastic())));
    let stretched =
        |e: f64| Strains { membrane: [Pack::splat(e), Pack::ZERO, Pack::ZERO], ..Strains::default() };
    let yielding = stretched(3.0 * LIMIT / STIFFNESS);
    let before = bits(pack.numbers());
    let force = pack.resultants(&yielding).membrane[0].lanes()[0];
    assert!(bits(pack.numbers()) == before && pack.resultants(&yielding).membrane[0].lanes()[0] == force);
    pack.commit(&yielding);
    let after = bits(pack.numbers());
    pack.commit(&yielding);
    assert!(after != before && bits(pack.numbers()) == after);
    assert!((pack.resultants(&yielding).membrane[0].lanes()[0] / force - 1.0).abs() < 1e-15);
}
