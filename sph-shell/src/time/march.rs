//! The shell as a system of `explicit-dynamics`: forces, kick, drift, the whole step at once, its stable step and bounds.

use explicit_dynamics::{
    Bounds, Dynamics, Instant, MarchError, MassScaled, OutOfBounds, OutOfRange, StableStep, Step, Work,
    lanczos_step,
};
use parallel::ByChunk;

use crate::Shell;
use crate::conditions::constraints::Constraints;
use crate::dependents::Dependents;
use crate::dispatch::{Work as Sweeping, widest};
use crate::loading::Loading;
use crate::motion::Moving;
use crate::packs::Row;
use crate::points::bounds::BoundViolation;
use crate::points::sweep::Sweep;
use crate::registers::Registers;
use crate::time::evaluation::Evaluation;
use crate::time::particle::{Rows, Slots, Update, drifted};
use crate::time::share::Share;

/// A chunk of particles on its way to a thread, to be kicked and, with `DRIFT`, moved.
struct Chunk<'a, 'b, const DRIFT: bool> {
    update: &'b Update<'a>,
    slots: Option<Slots<'a>>,
    first: usize,
    rows: Rows<'b>,
    work: &'b mut Work,
}

/// Places for new rows, rates and work of a chunk of particles.
type ChunkRows<'a> = ((&'a mut [Row], &'a mut [Row]), ByChunk<'a, Work>);

impl<const DRIFT: bool> Sweeping for Chunk<'_, '_, DRIFT> {
    type Output = ();

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) {
        let Self { update, slots, first, rows, work } = self;
        let range = first..first + rows.rates.len();
        *work = Work::default();
        update.run::<DRIFT, R>(registers, range, first, rows, slots, std::slice::from_mut(work));
    }
}

/// What the update of particles reads of the groups of a shell.
fn update_of<'a>(
    [masses, inertias]: [&'a [f64]; 2],
    constraints: &'a Constraints,
    loading: &'a Loading,
    direct: &'a [Row],
    step: &'a Step,
) -> Update<'a> {
    Update {
        direct,
        external: loading.in_march(),
        masses,
        inertias,
        constraint_of: &constraints.of_particle,
        constraints: &constraints.all,
        step,
        decay: step.decay(),
    }
}

impl Shell {
    /// Kicks all particles, and moves them with `DRIFT`, from the slots that the sweep over all points filled.
    fn update<const DRIFT: bool>(&mut self, step: &Step) -> Work {
        let Self { reference, points, constraints, dependents, loading, motion, evaluation, share, .. } =
            self;
        let internal = |a| evaluation.internal_force(points, a);
        let external = |a| loading.external_force(a);
        let of_groups = dependents.junctions.kick(motion, constraints, internal, external, step, DRIFT);
        let Dependents { junctions, ties } = dependents;
        let update = update_of(ties.moving_masses(reference), constraints, loading, points.direct(), step);
        let Evaluation { slots, chunk_work, threads, .. } = evaluation;
        let slots = points.lists().map(|lists| Slots { rows: slots, lists, first: 0 });
        let Moving { state, next, rates } = &mut *motion;
        let chunk = |first: usize, ((next, rates), ByChunk(work)): ChunkRows<'_>| {
            let ([work, ..], rows) = (work, Rows { state, next, rates }) else { return };
            widest(Chunk::<DRIFT> { update: &update, slots, first, rows, work });
        };
        parallel::chunks(*threads, ((&mut next[..], &mut rates[..]), ByChunk(chunk_work)), chunk);
        if DRIFT {
            std::mem::swap(state, next);
        }
        junctions.drift(motion, constraints, if DRIFT { step.drift() } else { 0.0 });
        ties.put(&mut motion.state);
        evaluation.total_work(share, step, of_groups, loading.rubbed())
    }

    /// A step by the plan; external forces are already evaluated.
    fn fused_step(&mut self, step: &Step) -> Work {
        let Self { reference, material, points, constraints, dependents, loading, motion, evaluation, share } =
            self;
        let Evaluation { plan: Some(plan), chunk_work, .. } = evaluation else { return Work::default() };
        let Moving { state, next, rates } = motion;
        let sweep = Sweep { points, law: material.law(), state, energy: false };
        let moving = dependents.ties.moving_masses(reference);
        let update = update_of(moving, constraints, loading, &[], step);
        let (own, chunks) = (share.own(), share.chunks());
        let rows = Rows { state, next: &mut next[own.clone()], rates: &mut rates[own] };
        plan.advance(&sweep, &update, rows, &mut chunk_work[chunks]);
        std::mem::swap(state, next);
        evaluation.total_work(share, step, Work::default(), loading.rubbed())
    }
}

impl Evaluation {
    /// Adds the work of all chunks, exactly whoever has them, to what is there already; what friction took of the work of tools is dissipated.
    fn total_work(&self, share: &Share, step: &Step, first: Work, rubbed: f64) -> Work {
        let of = |work: &Work| [work.kinetic, work.external, work.change, work.resisted];
        let [kinetic, external, change, resisted] = share.sum(self.chunk_work[share.chunks()].iter().map(of));
        let sum = Work {
            kinetic: first.kinetic + kinetic,
            external: first.external + external,
            dissipated: 0.0,
            change: first.change + change,
            resisted: first.resisted + resisted,
        };
        Work {
            dissipated: 2.0 * step.kick * step.damping * sum.kinetic + rubbed,
            external: sum.external + rubbed,
            ..sum
        }
    }
}

impl Dynamics for Shell {
    fn evaluate(&mut self, at: Instant) -> f64 {
        self.evaluate_internal(true);
        self.evaluate_external(at);
        self.stored_energy()
    }

    fn kick(&mut self, step: &Step) -> Work {
        self.update::<false>(step)
    }

    fn drift(&mut self, step: &Step) {
        let Self { dependents: Dependents { junctions, ties }, constraints, motion, .. } = self;
        junctions.set_aside(motion);
        for (row, rate) in motion.state.iter_mut().zip(&mut motion.rates) {
            (*row, *rate) = drifted(row, rate, step.drift());
        }
        junctions.drift(motion, constraints, step.drift());
        ties.put(&mut motion.state);
        self.commit_in(step.drift());
    }

    fn advance(&mut self, step: &Step) -> Work {
        // Groups and ties gather forces that the fused step does not keep.
        if self.evaluation.plan.is_some() && self.dependents.is_empty() {
            self.share.exchange(&mut self.motion.state);
            self.evaluate_external(step.from);
            let work = self.fused_step(step);
            self.commit_in(step.drift());
            return work;
        }
        self.evaluate_internal(false);
        self.evaluate_external(step.from);
        let work = self.update::<true>(step);
        self.commit_in(step.drift());
        work
    }

    fn stop(&mut self) {
        self.motion.rates.fill([0.0; 6]);
    }

    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        lanczos_step(self, safety)
    }

    fn shortened(&mut self, stable: f64, safety: f64) -> f64 {
        let Self { reference, dependents, loading, motion, .. } = self;
        let Some(own) = &mut loading.own_contact else { return stable };
        let [masses, _] = dependents.ties.moving_masses(reference);
        own.shortened(stable, safety, [&motion.state, &motion.rates], masses)
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        if bounds == Bounds::Configuration {
            let found =
                |BoundViolation { place, what, value, bound }| OutOfRange { place, what, value, bound };
            return self.bound_violation().map_or(Ok(()), |violation| Err(found(violation).into()));
        }
        let (particle, speed) = self.fastest();
        let bound = self.reference.sound_speed;
        if speed <= bound { Ok(()) } else { Err(OutOfBounds::Speed { particle, speed, bound }) }
    }

    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        Some(self)
    }
}

impl Shell {
    /// The particle with the greatest speed, and that speed \[L/T\]; not a number counts as greatest.
    fn fastest(&self) -> (usize, f64) {
        let speed = |a: usize| {
            let rate = &self.motion.rates[a];
            let rotating = rate[3] * rate[3] + rate[4] * rate[4] + rate[5] * rate[5];
            let moving = rate[0] * rate[0] + rate[1] * rate[1] + rate[2] * rate[2];
            let energy = moving + rotating * self.reference.inertias[a] / self.reference.masses[a];
            (energy, a)
        };
        let (square, particle) = self.share.greatest(self.share.own().map(speed));
        (particle, square.sqrt())
    }
}

#[cfg(test)]
mod tests {
    use explicit_dynamics::{Amplitude, LinearisedDynamics};
    use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
    use sph_core::{
        Cell, Cloud, Cylinder, EndWeights, Patch, Plate, Side, Vec3, jittered_lattice, lattice, poisson_cloud,
    };

    use super::*;
    use crate::Parts;
    use crate::conditions::loads::AppliedLoad;
    use crate::conditions::pressure::Pressure;
    use crate::conditions::supports::{Clamped, Supported};
    use crate::formulation::{Formulation, Reach};
    use crate::gather::Places;
    use crate::time::fused::Fused;

    /// Layouts that are tried.
    const LAYOUTS: usize = 80;

    /// Whole numbers that look random.
    #[derive(Clone)]
    struct RandomNumbers(u64);

    impl RandomNumbers {
        /// One from `low` to `high`, both included.
        fn roll(&mut self, low: usize, high: usize) -> usize {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            low + (self.0 >> 33) as usize % (high - low + 1)
        }
    }

    /// A cloud of 500 to 2700 particles: one to six chunks, so that parts have borders anywhere in a row.
    fn layout(number: usize, dice: &mut RandomNumbers) -> Cloud {
        let (plate, roof) =
            (Plate { lengths: [2.0, 1.5] }, Cylinder { radius: 3.0, angles: [-0.5, 0.4], length: 2.5 });
        let patch: &dyn Patch = if dice.roll(0, 1) == 0 { &plate } else { &roof };
        let odd = [2 * dice.roll(10, 25) + 1, 2 * dice.roll(12, 26) + 1];
        match number % 5 {
            0 => lattice(patch, [odd[0], odd[1]], EndWeights::Trapezoid).unwrap(),
            // one row of cells, whose particles lie side by side or the length of the strip apart
            1 => {
                let long = dice.roll(260, 1350);
                let (counts, lengths) = match dice.roll(0, 1) {
                    0 => ([long, 2], [long as f64, 1.0]),
                    _ => ([2, long], [1.0, long as f64]),
                };
                lattice(&Plate { lengths }, counts, EndWeights::Trapezoid).unwrap()
            }
            2 => jittered_lattice(patch, odd, 0.25, number as u64).unwrap(),
            3 => poisson_cloud(patch, 0.01 * dice.roll(4, 6) as f64, number as u64).unwrap(),
            _ => with_triangles(&lattice(patch, odd, EndWeights::Trapezoid).unwrap(), dice.roll(66, 90)),
        }
    }

    /// Every so many cells one is cut in two.
    fn with_triangles(cloud: &Cloud, every: usize) -> Cloud {
        let cut = |(number, cell): (usize, &Cell)| {
            let [a, b, c, d] = cell.corners;
            if number % every == 0 {
                vec![Cell::triangle([a, b, c]), Cell::triangle([a, c, d])]
            } else {
                vec![*cell]
            }
        };
        let cells = cloud.cells.iter().enumerate().flat_map(cut).collect();
        let normals = cloud.frames.iter().map(|frame| frame.n).collect();
        let cut = Cloud::from_cells(cloud.positions.clone(), Some(normals), cells).unwrap();
        Cloud { sides: cloud.sides.clone(), ..cut }
    }

    /// The shell of a cloud, clamped at an edge, under pressure; positions and rates are rough.
    fn body(cloud: Cloud, loaded: bool, dice: &mut RandomNumbers) -> Shell {
        let load = AppliedLoad {
            load: Box::new(Pressure { value: 0.01, follower: true }),
            amplitude: Amplitude::Constant,
        };
        let held = cloud.sides.as_ref().unwrap().edge(Side::U0).to_vec();
        let size = 0.05 * cloud.spacing();
        let mut shell = Shell::builder(Parts {
            cloud,
            section: Box::new(IsotropicSection::new(Isotropic::new(1200.0, 0.3).unwrap(), 0.05).unwrap()),
            strain: &StretchCorrected,
            material_axis: None,
            density: 1.0,
            formulation: Formulation::StressPoint(Reach::Cell),
            supports: vec![Supported { particles: held, support: Box::new(Clamped) }],
            loads: if loaded { vec![load] } else { Vec::new() },
            threads: 1,
        })
        .build()
        .unwrap();
        let mut rough = || {
            let mut one = || size * (dice.roll(0, 2000) as f64 / 1000.0 - 1.0);
            Vec3::new(one(), one(), one())
        };
        for a in 0..shell.len() {
            shell.set_state(a, shell.position(a) + rough(), shell.director(a) + rough());
            shell.set_rate(a, rough(), rough());
        }
        shell
    }

    /// Some steps from a motion; everything they leave, as bits.
    fn marched(
        shell: &mut Shell,
        from: &[Vec<Row>; 2],
        advance: impl Fn(&mut Shell, &Step) -> Work,
    ) -> Vec<u64> {
        assert!(shell.take_up([&from[0], &from[1]]));
        let mut bits = Vec::new();
        for number in 0..2 {
            let at = |time: f64| Instant { time, level: 1.0 };
            let dt = 1e-5;
            let time = f64::from(number) * dt;
            let work = advance(shell, &Step { from: at(time), to: at(time + dt), kick: dt, damping: 0.3 });
            bits.extend([work.kinetic, work.external, work.dissipated].map(f64::to_bits));
        }
        shell.bring();
        bits.extend(shell.motion().into_iter().flatten().flatten().map(|x| x.to_bits()));
        bits
    }

    #[test]
    fn one_sweep_gives_the_same_bits_on_many_layouts_and_threads() {
        let mut dice = RandomNumbers(3);
        let mut several = 0;
        for number in 0..LAYOUTS {
            let mut shell = body(layout(number, &mut dice), number % 3 != 0, &mut dice);
            several += usize::from(shell.len() > 2 * parallel::CHUNK);
            let from = shell.motion().map(<[Row]>::to_vec);
            let expected = marched(&mut shell, &from, |shell, step| {
                shell.evaluate(step.from);
                let work = shell.kick(step);
                shell.drift(step);
                work
            });
            for threads in [1, 2, 3, 4] {
                let places = Places::new(&shell.points.packs, &shell.reference.operator);
                shell.evaluation.plan =
                    Some(Fused::plan(&shell.points.packs, &places, 0..shell.len(), threads));
                let found = marched(&mut shell, &from, Shell::advance);
                assert!(found == expected, "layout {number} of {} particles, {threads} threads", shell.len());
            }
        }
        assert!(several >= LAYOUTS / 2, "{several} of several chunks");
    }

    /// One to seven march the same layouts together: motion, work, energy, the stable step, speeds and what is out of balance.
    #[test]
    fn peers_march_to_the_same_bits_on_many_layouts() {
        let mut dice = RandomNumbers(3);
        for number in 0..LAYOUTS {
            let cloud = layout(number, &mut dice);
            let thrown = dice.clone();
            let loaded = number % 3 != 0;
            let march = |share: Option<Box<dyn peers::Peers>>| {
                let mut shell = body(cloud.clone(), loaded, &mut thrown.clone());
                if let Some(peers) = share {
                    shell.share(peers).unwrap();
                }
                let from = shell.motion().map(<[Row]>::to_vec);
                let mut bits = marched(&mut shell, &from, Shell::advance);
                bits.push(shell.evaluate(Instant { time: 1.0, level: 1.0 }).to_bits());
                let mut vectors = [vec![0.0; 6 * shell.len()], vec![0.0; 6 * shell.len()]];
                shell.out_of_balance(&mut vectors[0]);
                MassScaled::rates(&shell, &mut vectors[1]);
                let [force, rates] = &vectors;
                bits.extend(
                    [shell.dot(force, rates), shell.displaced(), shell.fastest().1].map(f64::to_bits),
                );
                if number % 8 == 0 {
                    bits.push(shell.stable_step(1.0).unwrap().dt.to_bits());
                }
                bits.push(u64::from(shell.within_bounds(Bounds::Configuration).is_ok()));
                bits
            };
            let alone = march(None);
            body(cloud.clone(), loaded, &mut dice);
            for count in [1, 2, 3, 4, 7] {
                let all = peers::together(count, |peers| march(Some(peers))).unwrap();
                assert!(all.iter().all(|found| *found == alone), "layout {number}, {count} peers");
            }
        }
    }
}
