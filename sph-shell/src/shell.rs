//! The shell: reference, state, forces; how it is put together and what can be read from it.

use shell_kinematics::{LANES, Section, StrainMeasure};
use sph_core::{Cloud, Vec3};

use crate::cell_control::CellPack;
use crate::fused::Fused;
use crate::loads::{AppliedLoad, Body};
use crate::membrane_arcs::{ArcPack, ChordLoss};
use crate::packs::Packs;
use crate::pair_control::PairControl;
use crate::point::{PointLaw, Row, interpolate};
use crate::shear::ShearPack;
use crate::strong_form::StrongForm;
use crate::supports::{Constraint, constraints};
use crate::sweep::Sweep;
use crate::{Formulation, Reach, Reference, ShellError, Support};

/// A support and the particles it acts on.
pub struct Supported {
    /// Particles.
    pub particles: Vec<u32>,
    /// What is asked of them.
    pub support: Box<dyn Support>,
}

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

/// A shell of SPH particles, ready to be marched.
pub struct Shell {
    pub(crate) reference: Reference,
    pub(crate) section: Box<dyn Section>,
    pub(crate) strain: &'static dyn StrainMeasure,
    pub(crate) formulation: Formulation,
    pub(crate) packs: Packs,
    /// Control of cells; empty for wider stencils.
    pub(crate) cells: Vec<CellPack>,
    /// Shear on uneven stencils; empty on lattices of developable surfaces.
    pub(crate) shear: Vec<ShearPack>,
    /// What chords of uneven curved cells lose; empty where that is nothing.
    pub(crate) arcs: Vec<ArcPack>,
    pub(crate) chord_loss: ChordLoss,
    pub(crate) pairs: Option<PairControl>,
    pub(crate) strong_form: Option<StrongForm>,
    /// Number of each particle's entry in `constraints`, one up; zero for a free particle.
    pub(crate) constraint_of: Vec<u32>,
    pub(crate) constraints: Vec<Constraint>,
    pub(crate) loads: Vec<AppliedLoad>,
    /// Positions and directors.
    pub(crate) state: Vec<Row>,
    /// Their rates.
    pub(crate) rates: Vec<Row>,
    /// Internal forces of the sampling points, one row a (point, particle) pair.
    pub(crate) slots: Vec<Row>,
    /// Internal forces that are found particle by particle (pair control, strong form); else empty.
    pub(crate) direct: Vec<Row>,
    /// External forces; empty without loads.
    pub(crate) external: Vec<Row>,
    /// Energy of each pack, filled on request.
    pub(crate) pack_energies: Vec<f64>,
    /// Work of each chunk of particles in the last kick.
    pub(crate) chunk_work: Vec<explicit_dynamics::Work>,
    pub(crate) internal_energy: f64,
    /// The plan of a step in one sweep; cells only.
    pub(crate) fused: Option<Fused>,
    pub(crate) threads: usize,
}

/// Particles a chunk of the update sweep; fixed, so that sums do not depend on threads.
pub(crate) const PARTICLE_CHUNK: usize = 512;

impl Shell {
    /// Builds stencils, masses, reference strains and constraints.
    ///
    /// # Errors
    /// [`ShellError`]: unsound clouds, stencils too small for their order, empty or unknown sets,
    /// supports that contradict each other.
    pub fn new(parts: Parts) -> Result<Self, ShellError> {
        let scales = parts.section.scales();
        let reference = Reference::new(
            parts.cloud,
            &parts.formulation,
            &scales,
            parts.density,
            parts.material_axis.as_ref(),
        )?;
        for load in &parts.loads {
            load.load.check(&reference)?;
        }
        let (constraint_of, constraints) = constraints(&reference.cloud, &parts.supports)?;
        let count = reference.cloud.len();
        let packs = Packs::new(&reference.operator);
        let state: Vec<Row> = reference
            .cloud
            .positions
            .iter()
            .zip(&reference.cloud.frames)
            .map(|(x, f)| [x.x, x.y, x.z, f.n.x, f.n.y, f.n.z])
            .collect();
        let cells = match parts.formulation {
            Formulation::StressPoint(Reach::Cell) => packs
                .points
                .iter()
                .zip(&packs.order)
                .map(|(pack, points)| {
                    CellPack::new(
                        &reference.operator,
                        points,
                        pack.weight,
                        &reference.cloud.positions,
                        &scales,
                    )
                })
                .collect(),
            _ => Vec::new(),
        };
        let operator = &reference.operator;
        let second = operator.second_moments(&reference.cloud.positions);
        // Wide rows and rows at particles are uneven at every edge by design; relaxed there, they lose what holds them.
        let third = match parts.formulation {
            Formulation::StressPoint(Reach::Cell) => {
                operator.uneven_third_moments(&reference.cloud.positions)
            }
            _ => Vec::new(),
        };
        let shear = ShearPack::all(operator, &packs.order, &second, &third, scales.thickness);
        let pairs = match parts.formulation {
            Formulation::StressPoint(Reach::Kernel(..)) | Formulation::Nodal { .. } => {
                Some(PairControl::new(&reference, &scales)?)
            }
            _ => None,
        };
        let strong_form = match parts.formulation {
            Formulation::StrongForm { viscosity, .. } => {
                Some(StrongForm::new(&reference, viscosity, scales.thickness * parts.density))
            }
            _ => None,
        };
        let threads = parts.threads.max(1);
        let fused = if cells.is_empty() { None } else { Fused::plan(&packs, count, threads) };
        let slot_rows = if strong_form.is_some() { 0 } else { packs.slot_count() };
        let direct_rows = if pairs.is_some() || strong_form.is_some() { count } else { 0 };
        let mut shell = Self {
            slots: vec![[0.0; 6]; slot_rows],
            direct: vec![[0.0; 6]; direct_rows],
            external: vec![[0.0; 6]; if parts.loads.is_empty() { 0 } else { count }],
            pack_energies: vec![0.0; packs.points.len()],
            chunk_work: vec![Default::default(); count.div_ceil(PARTICLE_CHUNK)],
            rates: vec![[0.0; 6]; count],
            state,
            packs,
            cells,
            shear,
            arcs: Vec::new(),
            chord_loss: ChordLoss::default(),
            pairs,
            strong_form,
            constraint_of,
            constraints,
            loads: parts.loads,
            internal_energy: 0.0,
            fused,
            threads,
            reference,
            section: parts.section,
            strain: parts.strain,
            formulation: parts.formulation,
        };
        shell.take_reference();
        (shell.arcs, shell.chord_loss) =
            ArcPack::all(&shell.reference.operator, &shell.packs, &second, &third, scales.thickness);
        Ok(shell)
    }

    /// Reference measures of every point, and reference values of the cell control, from the present state.
    fn take_reference(&mut self) {
        for (index, pack) in self.packs.points.iter_mut().enumerate() {
            let entries = &self.packs.entries[pack.first as usize..][..pack.width as usize];
            let (p, raw) = interpolate::<true>(pack, entries, &self.state);
            pack.reference = p.measures();
            if let Some(cell) = self.cells.get_mut(index) {
                pack.reference.curvature = cell.rest(&p, &pack.reference.curvature, raw);
            }
        }
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

    /// Thickness \[L\].
    pub fn thickness(&self) -> f64 {
        self.section.scales().thickness
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

    /// Degrees of freedom that no support holds: three translations and two rotations a particle, less what is held.
    pub fn freedoms(&self) -> usize {
        let held: usize = self.constraints.iter().map(Constraint::held_freedoms).sum();
        5 * self.len() - held
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
        let mut sum = self.direct.get(particle).copied().unwrap_or([0.0; 6]);
        if !self.slots.is_empty() {
            for &slot in self.packs.slots_of(particle) {
                let row = &self.slots[slot as usize];
                for i in 0..6 {
                    sum[i] += row[i];
                }
            }
        }
        sum
    }

    /// Load on a particle for the last forces evaluated \[F, F L\].
    pub fn external_force(&self, particle: usize) -> [f64; 6] {
        self.external.get(particle).copied().unwrap_or([0.0; 6])
    }

    /// What the supports of a particle bear: `∂U/∂x` less the load on it \[F\], for the last forces evaluated.
    pub fn reaction(&self, particle: usize) -> Vec3 {
        let f = self.internal_force(particle);
        let e = self.external_force(particle);
        Vec3::new(f[0] - e[0], f[1] - e[1], f[2] - e[2])
    }

    /// The moment that the supports of a particle's director bear: `d × ∂U/∂d` less that of the couple on it \[F L\], for the
    /// last forces evaluated.
    pub fn reaction_moment(&self, particle: usize) -> Vec3 {
        let f = self.internal_force(particle);
        let e = self.external_force(particle);
        self.director(particle).cross(&Vec3::new(f[3] - e[3], f[4] - e[4], f[5] - e[5]))
    }

    /// Evaluates the internal forces of the present state, and the internal energy if asked for.
    ///
    /// The strong form has no energy of its own; it reports the elastic energy of its strains.
    pub fn evaluate_internal(&mut self, energy: bool) {
        if let Some(strong) = &mut self.strong_form {
            let law = PointLaw { strain: self.strain, section: &*self.section };
            let total = strong.evaluate(
                &self.reference,
                &self.packs,
                &self.shear,
                law,
                &self.state,
                &self.rates,
                &mut self.direct,
            );
            self.internal_energy = total;
            return;
        }
        let mut slots = std::mem::take(&mut self.slots);
        let mut energies = std::mem::take(&mut self.pack_energies);
        self.sweep(energy).run(0, &mut slots, &mut energies, self.threads > 1);
        (self.slots, self.pack_energies) = (slots, energies);
        let mut total = if energy { self.pack_energies.iter().sum() } else { 0.0 };
        if let Some(pairs) = &self.pairs {
            total += pairs.evaluate(&self.state, &mut self.direct, self.threads > 1);
        }
        self.internal_energy = total;
    }

    /// The sweep over the points of the present state.
    pub(crate) fn sweep(&self, energy: bool) -> Sweep<'_> {
        let law = PointLaw { strain: self.strain, section: &*self.section };
        Sweep {
            packs: &self.packs,
            cells: &self.cells,
            shear: &self.shear,
            arcs: &self.arcs,
            law,
            state: &self.state,
            energy,
        }
    }

    pub(crate) fn evaluate_external(&mut self, at: explicit_dynamics::Instant) {
        if self.external.is_empty() {
            return;
        }
        self.external.fill([0.0; 6]);
        let body = Body { reference: &self.reference, state: &self.state };
        for applied in &self.loads {
            applied.load.add(applied.scale(at), &body, &mut self.external);
        }
    }

    /// Bytes held per particle by everything that the step touches.
    pub fn bytes_per_particle(&self) -> f64 {
        use std::mem::{size_of, size_of_val};
        let packs = &self.packs;
        let bytes = size_of_val(&packs.points[..])
            + size_of_val(&packs.entries[..])
            + size_of_val(&packs.slots[..])
            + size_of_val(&packs.offsets[..])
            + size_of_val(&self.shear[..])
            + self.fused.as_ref().map_or(0, Fused::bytes)
            + size_of_val(&self.cells[..])
            + size_of_val(&self.arcs[..])
            + self.pairs.as_ref().map_or(0, PairControl::bytes)
            + size_of::<Row>()
                * (self.slots.len()
                    + self.state.len()
                    + self.rates.len()
                    + self.direct.len()
                    + self.external.len())
            + 8 * (self.reference.masses.len() + self.reference.inertias.len() + self.pack_energies.len())
            + 4 * self.constraint_of.len();
        bytes as f64 / self.len() as f64
    }
}

// A pack is four points; the chunking above relies on it only through the slot counts.
const _: () = assert!(LANES == 4);
