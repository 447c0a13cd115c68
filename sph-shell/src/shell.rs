//! The shell: its motion, its forces, and what can be read from it.

use explicit_dynamics::{Exert, Instant, Push};
use shell_kinematics::StrainMeasure;
use sph_core::Vec3;

use crate::Shell;
use crate::conditions::body::Block;
use crate::conditions::supports::Constraint;
use crate::control::arcs::ChordLoss;
use crate::control::pairs::PairControl;
use crate::formulation::Formulation;
use crate::junction::springs::BodySprings;
use crate::packs::Row;
use crate::points::bounds::BoundViolation;
use crate::points::scheme::{Points, Scheme};
use crate::points::strong_form::Sampling;
use crate::points::sweep::Sweep;
use crate::reference::Reference;
use crate::regions::PointSection;
use crate::time::evaluation::Evaluation;

impl Shell {
    /// The reference configuration.
    pub fn reference(&self) -> &Reference {
        &self.reference
    }

    /// The formulation in use.
    pub fn formulation(&self) -> &Formulation {
        &self.points.formulation
    }

    /// The strain measure in use.
    pub fn strain_measure(&self) -> &'static dyn StrainMeasure {
        self.material.strain
    }

    /// Whether stresses run linearly through the thickness everywhere, so that those at the faces follow from the resultants.
    pub fn homogeneous(&self) -> bool {
        self.material.homogeneous()
    }

    /// Thickness, of several sections the mean over the area \[L\].
    pub fn thickness(&self) -> f64 {
        self.material.thickness(&self.reference)
    }

    /// Whether some cells have sections of their own.
    pub fn has_regions(&self) -> bool {
        self.material.regions.any()
    }

    /// What is read of the section at a sampling point.
    pub fn section_at(&self, point: usize) -> PointSection {
        self.material.at(point)
    }

    /// What chords of uneven curved cells do to the membrane; nothing on lattices of developable surfaces.
    pub fn chord_loss(&self) -> ChordLoss {
        self.points.chord_loss
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.motion.state.len()
    }

    /// Whether there is no particle.
    pub fn is_empty(&self) -> bool {
        self.motion.state.is_empty()
    }

    /// Degrees of freedom that no support holds: three translations and two rotations a particle, three and three a group of tied
    /// ones, less what is held.
    pub fn dof(&self) -> usize {
        let alone = (0..self.len()).filter(|&a| self.dependents.junctions.first(a) == a);
        let held: usize =
            alone.filter_map(|a| self.constraint(a)).map(Constraint::held_degrees_of_freedom).sum();
        let (particles, groups) = self.tied();
        5 * (self.len() - particles) + 6 * groups - held
    }

    /// Particles that junctions and rigid bodies tie, and the groups they form; both zero without.
    pub fn tied(&self) -> (usize, usize) {
        let groups = &self.dependents.junctions.groups;
        (groups.iter().map(|group| group.particles.len()).sum(), groups.len())
    }

    /// Number of rigid bodies, and of the particles in them.
    pub fn rigid_bodies(&self) -> [usize; 2] {
        let bodies = || self.dependents.junctions.groups.iter().filter(|group| group.body.is_some());
        [bodies().count(), bodies().map(|group| group.particles.len()).sum()]
    }

    /// Masses and rotary inertias of marching that move with each particle \[M, M L²\]: with what hangs on it by ties, whose own stand
    /// still.
    pub fn moving_masses(&self) -> [&[f64]; 2] {
        self.dependents.ties.moving_masses(&self.reference)
    }

    /// Whether a support holds any degree of freedom of a particle.
    pub fn is_held(&self, particle: usize) -> bool {
        self.constraint(particle).is_some_and(Constraint::holds)
    }

    /// Whether supports leave neither the position nor the director of a particle free.
    pub fn is_clamped(&self, particle: usize) -> bool {
        self.constraint(particle).is_some_and(Constraint::clamps)
    }

    pub(crate) fn constraint(&self, particle: usize) -> Option<&Constraint> {
        self.constraints.of(particle)
    }

    /// Present position of a particle \[L\].
    pub fn position(&self, particle: usize) -> Vec3 {
        self.reference.from_zero(self.motion.place(particle))
    }

    /// Position of a particle at rest \[L\].
    pub fn rest_position(&self, particle: usize) -> Vec3 {
        self.rest_positions()[particle]
    }

    /// Positions of all particles at rest \[L\].
    pub fn rest_positions(&self) -> &[Vec3] {
        if self.reference.given.is_empty() { &self.reference.cloud.positions } else { &self.reference.given }
    }

    /// Displacement of a particle \[L\].
    pub fn displacement(&self, particle: usize) -> Vec3 {
        self.motion.place(particle) - self.reference.cloud.positions[particle]
    }

    /// Present director of a particle (unit vector).
    pub fn director(&self, particle: usize) -> Vec3 {
        self.motion.director(particle)
    }

    /// Velocity of a particle, half a step behind its position \[L/T\].
    pub fn velocity(&self, particle: usize) -> Vec3 {
        let row = self.rate(particle);
        Vec3::new(row[0], row[1], row[2])
    }

    /// Rate of a particle's director, in step with [`Shell::velocity`] \[1/T\].
    pub fn director_rate(&self, particle: usize) -> Vec3 {
        let row = self.rate(particle);
        Vec3::new(row[3], row[4], row[5])
    }

    fn rate(&self, particle: usize) -> Row {
        self.dependents.ties.rate(&self.motion.state, &self.motion.rates, particle)
    }

    /// Sets the velocity of a particle and the rate of its director; held parts are taken out. Tied particles share the velocity
    /// last set, and turn as their directors' rates say; a rigid body takes the motion of its particles, which must be rigid.
    pub fn set_rate(&mut self, particle: usize, velocity: Vec3, director_rate: Vec3) {
        let d = self.director(particle);
        let tangent = director_rate - d * d.dot(&director_rate);
        self.forget_contact();
        let (mut v, mut w) = (velocity.into(), tangent.into());
        let group = self.dependents.junctions.of(particle);
        let rigid = group.is_some_and(|group| group.body.is_some());
        if let Some(constraint) = self.constraint(particle).filter(|_| !rigid) {
            (v, w) = (constraint.held.free_part(v), constraint.free_rotation(w));
        }
        self.motion.rates[particle] = [v[0], v[1], v[2], w[0], w[1], w[2]];
        for &a in group.iter().filter(|_| !rigid).flat_map(|group| &group.particles) {
            self.motion.rates[a as usize][..3].copy_from_slice(&v);
        }
    }

    /// Puts a particle at a position with a director (made a unit vector); for tests and initial shapes.
    pub fn set_state(&mut self, particle: usize, position: Vec3, director: Vec3) {
        let (d, position) = (director.normalize(), position - self.reference.origin);
        self.loading.tools.forget();
        self.forget_contact();
        self.share.moved();
        self.motion.state[particle] = [position.x, position.y, position.z, d.x, d.y, d.z];
    }

    /// All that changes while the shell moves, a row a particle: `[x, d]` \[L, –\] and its rates \[L/T, 1/T\].
    pub fn motion(&self) -> [&[[f64; 6]]; 2] {
        [&self.motion.state, &self.motion.rates]
    }

    /// Takes up a motion that [`Shell::motion`] gave, to the same bits; false, and nothing changed, if it is that of
    /// another number of particles.
    pub fn take_up(&mut self, [state, rates]: [&[[f64; 6]]; 2]) -> bool {
        let fits = state.len() == self.len() && rates.len() == self.len();
        if fits {
            self.loading.tools.forget();
            self.share.moved();
            self.motion.state.copy_from_slice(state);
            self.motion.rates.copy_from_slice(rates);
            self.forget_contact();
        }
        fits
    }

    /// Commits what the present strains make of the history of sections with memory, and the anchors of the forces of tools last evaluated: of
    /// an accepted state at rest, whose history is to last. Without memory and friction nothing is done; marches and [`crate::StaticShell`] commit by themselves.
    pub fn commit(&mut self) {
        self.commit_in(f64::INFINITY);
    }

    /// The same in a step that takes a time \[T\].
    pub(crate) fn commit_in(&mut self, duration: f64) {
        let Self { points, material, motion, loading, evaluation, share, .. } = self;
        if let Some(own) = &mut loading.own_contact {
            own.moved();
            own.commit();
        }
        if !points.sections.histories().is_empty() {
            share.arrive(&mut motion.state);
        }
        let (rows, touched) = ((&motion.state[..], duration), share.touched());
        points.commit(material.strain, rows, touched, evaluation.threads);
        loading.tools.commit();
        loading.enclosed(1.0).for_each(|(enclosed, _)| enclosed.note());
    }

    /// Whether its section has a memory, or what it touches friction.
    pub(crate) fn remembers(&self) -> bool {
        !self.points.sections.histories().is_empty() || self.has_friction()
    }

    /// The committed history of all points, and of what grips tools, which belongs to [`Shell::motion`] as a part of the state; empty without
    /// memory and friction.
    pub fn history(&self) -> Vec<f64> {
        let points = self.points.sections.histories().iter().flat_map(|pack| pack.numbers());
        points.chain(self.own_friction_history()).chain(self.loading.tools.history()).collect()
    }

    /// Takes up a history that [`Shell::history`] gave, to the same bits; false if it is that of another shell.
    pub fn take_up_history(&mut self, history: &[f64]) -> bool {
        let points = self.points.sections.histories().iter().map(|pack| pack.count()).sum();
        let Some((points, rest)) = history.split_at_checked(points) else { return false };
        let Some((own, tools)) = self.split_own_friction(rest) else { return false };
        self.loading.tools.take_up(tools)
            && self.take_up_own_friction(own)
            && self.points.sections.take_up(points)
    }

    /// Internal energy found by the last evaluation that was asked for it \[F L\]; of sections with memory what they have dissipated is in it.
    pub fn stored_energy(&self) -> f64 {
        self.evaluation.internal_energy
    }

    /// `[∂U/∂x, ∂U/∂d]` of a particle for the last forces evaluated \[F, F L\].
    pub fn internal_force(&self, particle: usize) -> [f64; 6] {
        self.evaluation.internal_force(&self.points, particle)
    }

    /// Load on a particle for the last forces evaluated \[F, F L\].
    pub fn external_force(&self, particle: usize) -> [f64; 6] {
        self.loading.external_force(particle)
    }

    /// A row `[f, n]` as the force on the unknowns of a particle: its own, or force and torque of the group it stands for, which
    /// leaves the others of the group nothing.
    pub(crate) fn gathered(&self, a: usize, row: impl Fn(usize) -> Row) -> Row {
        self.dependents.junctions.gathered(&self.motion.state, a, row)
    }

    /// What the supports and springs of a particle bear: `∂U/∂x` less the load on it \[F\], for the last forces evaluated. The first
    /// particle of a group bears what supports of the group do.
    pub fn reaction(&self, particle: usize) -> Vec3 {
        let f = self.gathered(particle, |a| self.internal_force(a));
        let e = self.gathered(particle, |a| self.external_force(a));
        let s = self.gathered(particle, |a| self.loading.spring_force(a));
        let b = self.dependents.junctions.body_load(particle);
        let of_body = self.body_springs().row(particle);
        Vec3::from_fn(|k, _| f[k] - e[k] + s[k] - b[k] + of_body[k])
    }

    /// The moment that the supports and springs of a particle's director bear, `d × ∂U/∂d` less that of the couple on it, and what holds the
    /// direction of a stiffener there in the surface \[F L\], for the last forces evaluated.
    pub fn reaction_moment(&self, particle: usize) -> Vec3 {
        let [f, e] = [self.internal_force(particle), self.external_force(particle)];
        let s = self.loading.spring_force(particle);
        if let Some(group) = self.dependents.junctions.of(particle) {
            if group.first() != particle {
                return Vec3::zeros();
            }
            let about_first = |row: &Row| group.about_first(&self.motion.state, row);
            return about_first(&self.gathered(particle, |a| self.internal_force(a)))
                - about_first(&self.gathered(particle, |a| self.external_force(a)))
                + about_first(&self.gathered(particle, |a| self.loading.spring_force(a)))
                - about_first(&self.dependents.junctions.body_load(particle))
                + about_first(&self.body_springs().row(particle))
                + group.sum_of(|a| self.stiffeners.held_at(&self.motion.state, a));
        }
        let of_bars = self.stiffeners.held_at(&self.motion.state, particle);
        of_bars + self.director(particle).cross(&Vec3::from_fn(|k, _| f[3 + k] - e[3 + k] + s[3 + k]))
    }

    /// Evaluates the internal forces of the present state, and the internal energy if asked for.
    ///
    /// The strong form has no energy of its own; it reports the elastic energy of its strains.
    pub fn evaluate_internal(&mut self, energy: bool) {
        let Self { reference, material, points, dependents, stiffeners, motion, evaluation, share, .. } =
            self;
        let Evaluation { plan, slots, pack_energies, internal_energy, threads, .. } = evaluation;
        if let Some(plan) = plan {
            share.exchange(&mut motion.state);
            dependents.ties.put(&mut motion.state);
            let mut forces = std::mem::take(points.direct_mut());
            let sweep = Sweep { points, law: material.law(), state: &motion.state, energy };
            plan.forces(&sweep, &mut forces[share.own()]);
            *internal_energy =
                if energy { share.energy(points.packs.points.len(), |pack| plan.energy(pack)) } else { 0.0 };
            *internal_energy += stiffeners.add(&motion.state, share, &mut forces, energy);
            share.exchange_bound(&mut forces);
            dependents.ties.condense_internal(&motion.state, &mut forces);
            *points.direct_mut() = forces;
            return;
        }
        if let Points { packs, shear, scheme: Scheme::StrongForm { equations, forces }, .. } = points {
            let sampling = Sampling { packs, shear, law: material.law() };
            let rows = [&motion.state[..], &motion.rates];
            *internal_energy = equations.evaluate(reference, sampling, rows, energy, forces, *threads);
            return;
        }
        let count = points.packs.slot_count();
        let sweep = Sweep { points, law: material.law(), state: &motion.state, energy };
        sweep.run(0, &mut slots[..count], pack_energies, *threads > 1);
        let mut total = if energy { pack_energies.iter().sum() } else { 0.0 };
        if let Scheme::Wide { control, forces, .. } = &mut points.scheme {
            control.evaluate(&motion.state, forces, *threads);
            if energy {
                total += PairControl::energy(&motion.state, forces);
            }
        }
        *internal_energy = total;
    }

    pub(crate) fn evaluate_external(&mut self, at: Instant) {
        let Self { reference, dependents, motion, loading, share, .. } = self;
        if loading.push.is_some() {
            // The function sees all particles.
            share.bring(&mut motion.state);
            share.bring(&mut motion.rates);
        }
        loading.evaluate(at, reference, dependents, motion, |rows| share.exchange_bound(rows));
    }

    /// Lets a function exert forces on all particles from now on, in marches.
    pub fn push(&mut self, exert: Exert) {
        let particles = self.len();
        self.loading.push(Push::new(particles, exert), particles);
    }

    /// Evaluates what a unit of level adds to the loads of the case that is under way.
    pub(crate) fn evaluate_load_rate(&mut self, level: f64) {
        let Self { reference, dependents, motion, loading, .. } = self;
        loading.evaluate_rate(level, reference, dependents, motion);
    }

    /// The first place where the shell is outside the range of its model, or in the middle of a tool.
    pub(crate) fn bound_violation(&self) -> Option<BoundViolation> {
        let depth = self.loading.tools.greatest_depth();
        if depth >= 1.0 {
            let (place, what) = ("the shell".into(), "depth in a tool over half of the thickness");
            return Some(BoundViolation { place, what, value: depth, bound: "below one" });
        }
        if let Some(value) = self.loading.own_contact.as_ref().and_then(|own| own.pressed()) {
            let (place, what) = ("the shell, pressed through itself".into(), "step over the stable one");
            return Some(BoundViolation { place, what, value, bound: "a hundredth at least" });
        }
        self.first_violation()
    }

    /// The derivatives of all loads at a level, of the springs and of contact, block by block.
    pub(crate) fn load_stiffness(&self, level: f64, put: &mut dyn FnMut(u32, u32, &Block)) {
        self.loading.stiffness(level, &self.loaded(), put);
    }

    /// The springs of rigid bodies in the present state.
    pub(crate) fn body_springs(&self) -> BodySprings<'_> {
        self.loading.of_bodies(&self.reference, &self.dependents.junctions, &self.motion.state)
    }

    /// Bytes held per particle by everything that the step touches.
    pub fn bytes_per_particle(&self) -> f64 {
        let motion = self.motion.state.len() + self.motion.next.len() + self.motion.rates.len();
        let numbers = self.reference.masses.len() + self.reference.inertias.len();
        let bytes = self.points.bytes()
            + self.evaluation.bytes()
            + self.loading.bytes()
            + size_of::<Row>() * motion
            + size_of::<f64>() * numbers
            + size_of::<u32>() * self.constraints.of_particle.len();
        bytes as f64 / self.len() as f64
    }
}
