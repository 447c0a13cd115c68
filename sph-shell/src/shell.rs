//! The shell: how it is put together, its forces, and what can be read from it.

use explicit_dynamics::{Instant, Work};
use shell_kinematics::{Section, StrainMeasure};
use sph_core::{Cloud, Vec3};

use crate::Shell;
use crate::conditions::case::LoadCase;
use crate::conditions::loads::AppliedLoad;
use crate::conditions::springs::Springs;
use crate::conditions::supports::{Constraint, Supported, constraints};
use crate::control::arcs::ChordLoss;
use crate::control::pairs::PairControl;
use crate::error::ShellError;
use crate::formulation::{Formulation, Reach};
use crate::gather::Places;
use crate::junction::group::Junctions;
use crate::packs::{PARTICLE_CHUNK, Row};
use crate::points::point::PointLaw;
use crate::points::scheme::{Points, Scheme, Sections};
use crate::points::strong_form::Sampling;
use crate::points::sweep::Sweep;
use crate::reference::Reference;
use crate::regions::{PointSection, Region, Regions};
use crate::ties::list::Ties;
use crate::time::fused::Fused;

/// What a shell is made of.
pub struct Parts {
    /// Particles, frames, areas, cells.
    pub cloud: Cloud,
    /// Material and thickness.
    pub section: Box<dyn Section>,
    /// Strain measure.
    pub strain: &'static dyn StrainMeasure,
    /// Direction whose projection on the surface is the section's first axis; without, the axes of the sampling points are
    /// arbitrary, and the section must not care.
    pub material_axis: Option<Vec3>,
    /// Mass density \[M/L³\].
    pub density: f64,
    /// Where strains are sampled.
    pub formulation: Formulation,
    /// Supports.
    pub supports: Vec<Supported>,
    /// Loads.
    pub loads: Vec<AppliedLoad>,
    /// Threads to use; more than one needs a rayon pool around the run.
    pub threads: usize,
}

impl Shell {
    /// Builds stencils, masses, reference strains and constraints.
    ///
    /// # Errors
    /// [`ShellError`]: invalid clouds, stencils too small for their order, empty or unknown sets,
    /// supports that contradict each other.
    pub fn new(parts: Parts) -> Result<Self, ShellError> {
        Self::with_regions(parts, Vec::new())
    }

    /// The same with sections of their own on some cells; the section of the parts is that of all others.
    ///
    /// # Errors
    /// As [`Shell::new`], for cells in two regions, and for regions where strains are not sampled in cells.
    pub fn with_regions(parts: Parts, regions: Vec<Region>) -> Result<Self, ShellError> {
        Self::about(parts, regions, Vec3::zeros())
    }

    /// The same, with all places kept from an origin: displacements of a shell far from zero keep the digits that its places would take. Places
    /// that are given and read ([`Shell::position`], [`crate::RigidSet`], axes of turns) are from zero all the same; only
    /// those of [`Reference::cloud`] and of [`Shell::motion`] are from the origin. Not together with a fluid.
    ///
    /// # Errors
    /// As [`Shell::with_regions`].
    pub fn about(mut parts: Parts, regions: Vec<Region>, origin: Vec3) -> Result<Self, ShellError> {
        let mut given = Vec::new();
        if origin != Vec3::zeros() {
            given.clone_from(&parts.cloud.positions);
            parts.cloud.positions.iter_mut().for_each(|x| *x -= origin);
        }
        let cells = matches!(parts.formulation, Formulation::StressPoint(Reach::Cell));
        if !cells && !parts.cloud.joined.is_empty() {
            return Err(ShellError::JunctionOfWideStencils);
        }
        let base = &*parts.section;
        let own_axes = !regions.is_empty();
        let mut reference = Reference::new(
            parts.cloud,
            &parts.formulation,
            &base.scales(),
            parts.density,
            parts.material_axis.as_ref().filter(|_| !own_axes),
        )?;
        (reference.origin, reference.given) = (origin, given);
        let regions = Regions::new(regions, &reference, &parts.formulation)?;
        if own_axes {
            regions.align(parts.material_axis, &mut reference)?;
            regions.weigh(base, parts.density, &mut reference);
        }
        for load in &parts.loads {
            load.load.check(&reference)?;
        }
        let (constraint_of, constraints) = constraints(&reference, &parts.supports)?;
        let junctions = Junctions::new(&reference, [&reference.masses, &reference.inertias], |_| true)?;
        let scales = regions.scales(base);
        let (mut points, chord_loss) = Points::new(&reference, &parts.formulation, &scales, parts.density)?;
        if regions.any() {
            points.sections = Sections::Own(regions.packs(base, &points.packs.order));
            points.strains = regions.strains(parts.strain, &points.packs.order);
        }
        let (count, threads) = (reference.cloud.len(), parts.threads.max(1));
        let fused = match points.scheme {
            Scheme::Cells { .. } => {
                let places = Places::new(&points.packs, &reference.operator);
                Some(Fused::plan(&points.packs, &places, count, threads))
            }
            Scheme::Wide { .. } | Scheme::StrongForm { .. } => None,
        };
        Ok(Self {
            slots: points.slots(),
            external: vec![[0.0; 6]; if parts.loads.is_empty() { 0 } else { count }],
            pack_energies: vec![0.0; if fused.is_some() { 0 } else { points.packs.points.len() }],
            chunk_work: vec![Work::default(); count.div_ceil(PARTICLE_CHUNK)],
            state: reference.rest(),
            next: vec![[0.0; 6]; count],
            rates: vec![[0.0; 6]; count],
            points,
            chord_loss,
            constraint_of,
            constraints,
            junctions,
            ties: Ties::default(),
            loads: parts.loads,
            case: LoadCase::Loading,
            stresses: Vec::new(),
            stress_case: LoadCase::Preload,
            springs: Springs::default(),
            spring_forces: Vec::new(),
            wetted: None,
            internal_energy: 0.0,
            fused,
            threads,
            reference,
            regions,
            section: parts.section,
            strain: parts.strain,
            formulation: parts.formulation,
        })
    }

    /// The reference configuration.
    pub fn reference(&self) -> &Reference {
        &self.reference
    }

    /// The formulation in use.
    pub fn formulation(&self) -> &Formulation {
        &self.formulation
    }

    /// The strain measure in use.
    pub fn strain_measure(&self) -> &'static dyn StrainMeasure {
        self.strain
    }

    /// Whether stresses run linearly through the thickness everywhere, so that those at the faces follow from the resultants.
    pub fn homogeneous(&self) -> bool {
        self.regions.homogeneous(&*self.section)
    }

    /// Thickness, of several sections the mean over the area \[L\].
    pub fn thickness(&self) -> f64 {
        let mean = self.regions.mean_thickness(&*self.section, &self.reference);
        mean.unwrap_or_else(|| self.section.scales().thickness)
    }

    /// Whether some cells have sections of their own.
    pub fn has_regions(&self) -> bool {
        self.regions.any()
    }

    /// What is read of the section at a sampling point.
    pub fn section_at(&self, point: usize) -> PointSection {
        let initial = self.stresses.get(point).copied().unwrap_or_default();
        PointSection { initial, ..self.regions.read(&*self.section, point) }
    }

    /// What chords of uneven curved cells do to the membrane; nothing on lattices of developable surfaces.
    pub fn chord_loss(&self) -> ChordLoss {
        self.chord_loss
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.state.len()
    }

    /// Whether there is no particle.
    pub fn is_empty(&self) -> bool {
        self.state.is_empty()
    }

    /// Degrees of freedom that no support holds: three translations and two rotations a particle, three and three a group of tied
    /// ones, less what is held.
    pub fn dof(&self) -> usize {
        let alone = (0..self.len()).filter(|&a| self.junctions.first(a) == a);
        let held: usize =
            alone.filter_map(|a| self.constraint(a)).map(Constraint::held_degrees_of_freedom).sum();
        let (particles, groups) = self.tied();
        5 * (self.len() - particles) + 6 * groups - held
    }

    /// Internal energy found by the last evaluation that was asked for it \[F L\].
    pub fn stored_energy(&self) -> f64 {
        self.internal_energy
    }

    pub(crate) fn constraint(&self, particle: usize) -> Option<&Constraint> {
        let number = self.constraint_of[particle] as usize;
        number.checked_sub(1).map(|i| &self.constraints[i])
    }

    /// `[∂U/∂x, ∂U/∂d]` of a particle for the last forces evaluated \[F, F L\].
    pub fn internal_force(&self, particle: usize) -> [f64; 6] {
        let mut sum = self.points.direct()[particle];
        for slot in self.points.lists().into_iter().flat_map(|lists| lists.of(particle)) {
            let row = &self.slots[slot as usize];
            for i in 0..6 {
                sum[i] += row[i];
            }
        }
        sum
    }

    /// Load on a particle for the last forces evaluated \[F, F L\].
    pub fn external_force(&self, particle: usize) -> [f64; 6] {
        self.external.get(particle).copied().unwrap_or([0.0; 6])
    }

    /// What the supports and springs of a particle bear: `∂U/∂x` less the load on it \[F\], for the last forces evaluated. The first
    /// particle of a group bears what supports of the group do.
    pub fn reaction(&self, particle: usize) -> Vec3 {
        let f = self.gathered(particle, |a| self.internal_force(a));
        let e = self.gathered(particle, |a| self.external_force(a));
        let s = self.gathered(particle, |a| self.spring_forces(a));
        let (b, of_body) = (self.body_load(particle), self.spring_row_of_body(particle));
        Vec3::from_fn(|k, _| f[k] - e[k] + s[k] - b[k] + of_body[k])
    }

    /// The moment that the supports and springs of a particle's director bear: `d × ∂U/∂d` less that of the couple on it \[F L\], for the
    /// last forces evaluated.
    pub fn reaction_moment(&self, particle: usize) -> Vec3 {
        let [f, e, s] =
            [self.internal_force(particle), self.external_force(particle), self.spring_forces(particle)];
        if let Some(group) = self.junctions.of(particle) {
            if group.first() != particle {
                return Vec3::zeros();
            }
            return self.about_first(group, &self.gathered(particle, |a| self.internal_force(a)))
                - self.about_first(group, &self.gathered(particle, |a| self.external_force(a)))
                + self.about_first(group, &self.gathered(particle, |a| self.spring_forces(a)))
                - self.about_first(group, &self.body_load(particle))
                + self.about_first(group, &self.spring_row_of_body(particle));
        }
        self.director(particle).cross(&Vec3::from_fn(|k, _| f[3 + k] - e[3 + k] + s[3 + k]))
    }

    /// Evaluates the internal forces of the present state, and the internal energy if asked for.
    ///
    /// The strong form has no energy of its own; it reports the elastic energy of its strains.
    pub fn evaluate_internal(&mut self, energy: bool) {
        if let Some(mut fused) = self.fused.take() {
            self.put_hanging();
            let mut forces = std::mem::take(self.points.direct_mut());
            self.internal_energy = fused.forces(&self.sweep(energy), &mut forces);
            self.condense_internal(&mut forces);
            *self.points.direct_mut() = forces;
            self.fused = Some(fused);
            return;
        }
        let Points { packs, shear, scheme, .. } = &mut self.points;
        if let Scheme::StrongForm { equations, forces } = scheme {
            let law = PointLaw { strain: self.strain, section: &*self.section };
            self.internal_energy = equations.evaluate(
                &self.reference,
                Sampling { packs, shear, law },
                [&self.state, &self.rates],
                energy,
                forces,
                self.threads > 1,
            );
            return;
        }
        let mut slots = std::mem::take(&mut self.slots);
        let mut energies = std::mem::take(&mut self.pack_energies);
        let count = self.points.packs.slot_count();
        self.sweep(energy).run(0, &mut slots[..count], &mut energies, self.threads > 1);
        (self.slots, self.pack_energies) = (slots, energies);
        let mut total = if energy { self.pack_energies.iter().sum() } else { 0.0 };
        if let Scheme::Wide { control, forces, .. } = &mut self.points.scheme {
            control.evaluate(&self.state, forces, self.threads > 1);
            if energy {
                total += PairControl::energy(&self.state, forces);
            }
        }
        self.internal_energy = total;
    }

    /// The sweep over the points of the present state.
    pub(crate) fn sweep(&self, energy: bool) -> Sweep<'_> {
        let law = PointLaw { strain: self.strain, section: &*self.section };
        Sweep { points: &self.points, law, state: &self.state, energy }
    }

    pub(crate) fn evaluate_external(&mut self, at: Instant) {
        let under_way = self.case;
        self.evaluate_loads(true, |applied| applied.scale(at, under_way));
    }

    /// Evaluates what a unit of level adds to the loads of the case that is under way.
    pub(crate) fn evaluate_load_rate(&mut self) {
        let (at, under_way) = (Instant { time: 0.0, level: 1.0 }, self.case);
        self.evaluate_loads(false, |applied| {
            if applied.load.case() == under_way { applied.scale(at, under_way) } else { 0.0 }
        });
    }

    fn evaluate_loads(&mut self, springs: bool, scale: impl Fn(&AppliedLoad) -> f64) {
        if self.external.is_empty() {
            return;
        }
        self.put_hanging();
        self.evaluate_bodies(springs, &scale);
        let mut rows = std::mem::take(&mut self.external);
        rows.fill([0.0; 6]);
        let body = self.as_loaded();
        for applied in &self.loads {
            applied.load.add(scale(applied), &body, &mut rows);
        }
        self.external = rows;
        if let Some(surface) = &self.wetted {
            surface.add(&self.rates, &mut self.external);
        }
        if springs && !self.spring_forces.is_empty() {
            self.evaluate_springs();
        }
        self.condense_external();
    }

    /// Bytes held per particle by everything that the step touches.
    pub fn bytes_per_particle(&self) -> f64 {
        let motion = self.state.len() + self.next.len() + self.rates.len();
        let rows = self.slots.len() + motion + self.external.len() + self.spring_forces.len();
        let numbers = self.reference.masses.len() + self.reference.inertias.len() + self.pack_energies.len();
        let bytes = self.points.bytes()
            + self.fused.as_ref().map_or(0, Fused::bytes)
            + self.wetted.as_ref().map_or(0, |surface| surface.bytes())
            + size_of::<Row>() * rows
            + size_of::<f64>() * numbers
            + size_of::<u32>() * self.constraint_of.len();
        bytes as f64 / self.len() as f64
    }
}
