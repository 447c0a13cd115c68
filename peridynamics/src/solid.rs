//! A body of nodes: what moves, what holds it, and what it resists with.

use explicit_dynamics::{Instant, Push, Work};
use sph_core::{Block, Vec3};

use crate::bonds::mechanics::{Evaluation, Mechanics};
use crate::bonds::network::Row;
use crate::bonds::solid_bonds::SolidBonds;
use crate::conditions::AppliedLoad;
use crate::constraint::Constraints;
use crate::error::SolidError;
use crate::following::FollowingPressure;
use crate::fracture::Breakage;
use crate::heat::Heat;
use crate::material::Across;
use crate::mirror::{Borne, Mirror, Passed};
use crate::parts::{Idealisation, Parts};
use crate::share::Share;
use crate::sheets::Plate;
use crate::wetted::Surface;

/// Part by which bonds that break together may differ in how far they are taken: those that symmetry makes alike differ by
/// what is left of a balance.
const ALIKE: f64 = 1e-6;

/// A peridynamic body: nodes that move, and of a plate of two sheets their directors.
///
/// What moves is a list of rows: the positions of the nodes, behind them the directors. All rows have masses, forces and
/// constraints alike.
pub struct Solid {
    pub(crate) block: Block,
    /// Rows at rest \[L\].
    pub(crate) rest: Vec<Vec3>,
    /// Rows at present.
    pub(crate) rows: Vec<Row>,
    /// Their rates \[L/T\].
    pub(crate) rates: Vec<Row>,
    pub(crate) masses: Vec<f64>,
    /// `∂U/∂row` of the last evaluation \[F\].
    pub(crate) internal: Vec<Row>,
    /// Loads of the last evaluation \[F\]; empty without any.
    pub(crate) external: Vec<Vec3>,
    /// Pressures that follow its surface, in marches.
    pub(crate) following: Vec<FollowingPressure>,
    /// Forces that a function exerts.
    pub(crate) push: Option<Box<Push>>,
    /// Forces that other bodies exert on nodes; empty of a solid alone.
    pub(crate) exerted: Vec<(u32, Vec3)>,
    /// What of its loads planes of symmetry bear at once.
    passed: Vec<Passed>,
    /// What a fluid wets.
    pub(crate) wetted: Option<Box<Surface>>,
    pub(crate) constraints: Constraints,
    pub(crate) loads: Vec<AppliedLoad>,
    pub(crate) mechanics: Box<dyn Mechanics>,
    /// Who bears what planes of symmetry do; none without.
    borne: Option<Box<Borne>>,
    pub(crate) internal_energy: f64,
    /// Rows in the middle of a step in which bonds break; empty until one does.
    pub(crate) breaking: Vec<Row>,
    /// What each chunk of rows counted in the last kick.
    pub(crate) works: Vec<Work>,
    /// Speed of pressure waves, a bound of all motion \[L/T\].
    pub(crate) sound_speed: f64,
    /// Shear modulus in its space, to which weights of bonds belong \[F/L²\].
    pub(crate) shear_modulus: f64,
    /// What the strain across its plane, which is held, makes of stresses; none of other spaces.
    pub(crate) across: Option<Across>,
    /// By how much it is warmed; none of a body that stays cold.
    pub(crate) heat: Option<Box<Heat>>,
    /// Who marches it, on how many threads.
    pub(crate) share: Share,
}

impl Solid {
    /// Builds a body at rest.
    ///
    /// # Errors
    /// [`SolidError`] for the first invalid part.
    pub fn new(parts: Parts) -> Result<Self, SolidError> {
        Self::mirrored(parts, &[])
    }

    /// Builds the part of a symmetric body on one side of each of these planes: bonds reach across to the images of its nodes,
    /// nodes on a plane stay on it, with the part of their volume that the block gives them.
    ///
    /// # Errors
    /// As [`Solid::new`]; [`SolidError::Mirror`] for a plane inside the body, [`SolidError::MirroredContact`].
    pub fn mirrored(parts: Parts, mirrors: &[Mirror]) -> Result<Self, SolidError> {
        let Parts { block, material, plastic, formulation, mut supports, loads, threads, .. } = parts;
        if let Some(&Mirror { axis, at }) = mirrors.iter().find(|mirror| mirror.axis >= block.dimensions) {
            return Err(SolidError::Mirror { axis, at });
        }
        if !mirrors.is_empty() && parts.contact.is_some() {
            return Err(SolidError::MirroredContact);
        }
        supports.extend(mirrors.iter().filter_map(|mirror| mirror.support(&block)));
        let breakage = Breakage { fracture: parts.fracture, cracks: parts.cracks, contact: parts.contact };
        let mut rest = block.positions.clone();
        let mut masses: Vec<f64> = block.volumes.iter().map(|volume| material.density * volume).collect();
        let (mechanics, space, across): (Box<dyn Mechanics>, _, _) = match &formulation {
            Idealisation::Bonds(bonds) => {
                let across = (block.dimensions == 2).then(Vec3::z);
                (
                    Box::new(SolidBonds::new(
                        &block,
                        (&material, plastic.as_ref()),
                        bonds,
                        &breakage,
                        mirrors,
                    )?),
                    bonds.space,
                    across,
                )
            }
            Idealisation::Sheets(_) if plastic.is_some() => {
                return Err(SolidError::Yielding(
                    "are for solids: a plate of two sheets has no plasticity; take a block of several layers, or a shell",
                ));
            }
            Idealisation::Sheets(sheets) => {
                let (plate, directors) = Plate::new(&block, &material, sheets, &breakage, mirrors)?;
                rest.extend(directors);
                masses.extend(masses.clone().iter().map(|mass| mass * sheets.thickness.powi(2) / 12.0));
                (Box::new(plate), sheets.formulation.space, None)
            }
        };
        let horizon = match &formulation {
            Idealisation::Bonds(bonds) => bonds.horizon,
            Idealisation::Sheets(sheets) => sheets.formulation.horizon,
        };
        let reach = (horizon + 0.5) * block.greatest_spacing();
        let borne = (!mirrors.is_empty()).then(|| Box::new(Borne::new(mirrors, &block, reach)));
        let moduli = material.moduli(space)?;
        let constraints = Constraints::new(&rest, block.len(), &supports, across)?;
        for (node, _) in loads.iter().flat_map(|load| &load.forces) {
            if *node as usize >= block.len() {
                return Err(SolidError::NoSuchNode { what: "a load", node: *node, count: block.len() });
            }
        }
        let count = rest.len();
        Ok(Self {
            rows: rest.iter().map(|x| [x.x, x.y, x.z, 0.0]).collect(),
            rates: vec![[0.0; 4]; count],
            masses,
            internal: vec![[0.0; 4]; count],
            external: if loads.is_empty() { Vec::new() } else { vec![Vec3::zeros(); count] },
            following: Vec::new(),
            push: None,
            exerted: Vec::new(),
            passed: Vec::new(),
            wetted: None,
            constraints,
            loads,
            mechanics,
            borne,
            internal_energy: 0.0,
            breaking: Vec::new(),
            works: Vec::new(),
            sound_speed: ((moduli.lambda + 2.0 * moduli.mu) / material.density).sqrt(),
            shear_modulus: moduli.mu,
            across: Across::of(&material, space),
            heat: None,
            share: Share::alone(count, threads.max(1)),
            rest,
            block,
        })
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.block.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.block.is_empty()
    }

    /// Its nodes at rest.
    pub fn block(&self) -> &Block {
        &self.block
    }

    /// Directed bonds, each pair twice.
    pub fn bonds(&self) -> usize {
        self.mechanics.bonds()
    }

    /// Degrees of freedom that no support holds.
    pub fn dof(&self) -> usize {
        self.constraints.dof()
    }

    /// Position of a node \[L\].
    pub fn position(&self, node: usize) -> Vec3 {
        vector(&self.rows[node])
    }

    /// Displacement of a node \[L\].
    pub fn displacement(&self, node: usize) -> Vec3 {
        vector(&self.rows[node]) - self.rest[node]
    }

    /// Velocity of a node \[L/T\].
    pub fn velocity(&self, node: usize) -> Vec3 {
        vector(&self.rates[node])
    }

    /// Director of a column of two sheets \[–\].
    pub fn director(&self, node: usize) -> Option<Vec3> {
        self.rows.get(self.len() + node).map(vector)
    }

    /// Turns and stretches the director of a column of two sheets; nothing else has one.
    pub fn set_director(&mut self, node: usize, director: Vec3) {
        let row = self.block.len() + node;
        if let Some(row) = self.rows.get_mut(row) {
            row[..3].copy_from_slice(director.as_slice());
        }
    }

    /// `∂U/∂d` of a column of two sheets in the last evaluation \[F L\].
    pub fn internal_couple(&self, node: usize) -> Option<Vec3> {
        self.internal.get(self.len() + node).map(vector)
    }

    /// Moves a node to a place \[L\]; forces are those of the last evaluation.
    pub fn put(&mut self, node: usize, position: Vec3) {
        self.rows[node][..3].copy_from_slice(position.as_slice());
    }

    /// Gives a node a velocity \[L/T\].
    pub fn set_velocity(&mut self, node: usize, velocity: Vec3) {
        self.rates[node][..3].copy_from_slice(velocity.as_slice());
    }

    /// Mass of a node \[M\].
    pub fn mass(&self, node: usize) -> f64 {
        self.masses[node]
    }

    /// `∂U/∂x` of a node in the last evaluation \[F\].
    pub fn internal_force(&self, node: usize) -> Vec3 {
        vector(&self.internal[node])
    }

    /// Load on a node in the last evaluation \[F\].
    pub fn external_force(&self, node: usize) -> Vec3 {
        self.external.get(node).copied().unwrap_or_default()
    }

    /// What the supports of a node bear \[F\], for the forces last evaluated. Outermost nodes on or before a plane of symmetry bear
    /// along its normal what the bonds of all nodes behind them pull through it.
    pub fn reaction(&self, node: usize) -> Vec3 {
        let across = |behind: usize, plane| self.mechanics.across(&self.rows, behind, plane);
        let borne = self.borne.as_ref().map_or_else(Vec3::zeros, |borne| borne.at(node, across));
        let passed: Vec3 = self.passed.iter().filter_map(|passed| passed.at(node)).sum();
        self.internal_force(node) - self.external_force(node) + borne - passed
    }

    /// Lets planes of symmetry bear a part of a load at once: forces at nodes of the face before one, at level one \[F\].
    ///
    /// A force near a plane that nodes on both sides bear goes through it without a bond; reactions of the face count it.
    ///
    /// # Errors
    /// [`SolidError::NoSuchNode`] for a load or a node that there is not.
    pub fn pass_through(&mut self, load: usize, forces: Vec<(u32, Vec3)>) -> Result<(), SolidError> {
        let count = self.block.len();
        let known = load < self.loads.len();
        let wrong = forces.iter().find(|(node, _)| !known || *node as usize >= count);
        if let Some(&(node, _)) = wrong {
            return Err(SolidError::NoSuchNode { what: "a load on a plane of symmetry", node, count });
        }
        self.passed.push(Passed { load, forces: forces.into_iter().collect(), factor: 0.0 });
        Ok(())
    }

    /// Whether a support holds a node along any direction that it could move in.
    pub fn is_held(&self, node: usize) -> bool {
        let across = usize::from(self.block.dimensions == 2 && self.rest.len() == self.block.len());
        self.constraints.get(node).is_some_and(|constraint| constraint.held.basis().len() > across)
    }

    /// Stored energy of the last evaluation that asked for it \[F L\].
    pub fn internal_energy(&self) -> f64 {
        self.internal_energy
    }

    /// Memory that a step touches, per node \[bytes\].
    pub fn bytes_per_particle(&self) -> f64 {
        let rows = 3 * size_of::<Row>() + size_of::<f64>();
        let wet = self.wetted.as_ref().map_or(0, |surface| surface.bytes());
        (self.mechanics.bytes() + rows * self.rows.len() + wet) as f64 / self.len() as f64
    }

    /// Evaluates the internal forces of the present state, and the stored energy if asked for. No bond breaks.
    pub fn evaluate_internal(&mut self, energy: bool) {
        let wanted = Evaluation { energy, watch: false, share: &self.share };
        let stored = self.mechanics.evaluate(&mut self.rows, &mut self.internal, wanted);
        if energy {
            self.internal_energy = stored;
        }
    }

    /// Counts the work that the present state does on bonds, if that breaks them; evaluated once more it does none.
    pub(crate) fn count_work(&mut self) {
        let wanted = Evaluation { energy: false, watch: true, share: &self.share };
        self.mechanics.evaluate(&mut self.rows, &mut self.internal, wanted);
    }

    /// How far the bond nearest to its limit is taken in the present state, one at the limit; zero where none breaks.
    pub(crate) fn utilisation(&mut self) -> f64 {
        self.evaluate_internal(false);
        self.mechanics.utilisation(&self.rows)
    }

    /// Breaks the bonds that the present state, whose work was counted, takes furthest; returns the energy that it takes to bring
    /// them to their limits: what they hold falls with the square of how far they are taken.
    pub(crate) fn break_critical(&mut self) -> f64 {
        let most = self.utilisation();
        let counted = 1.0 / (most * most).max(1.0);
        let energy = self.mechanics.break_from(most * (1.0 - ALIKE), counted, &self.rows, &self.share);
        // Work goes on from the pulls of the bonds that are left.
        self.count_work();
        energy
    }

    /// The loads of the body at an instant.
    pub(crate) fn evaluate_loads(&mut self, at: Instant) {
        if let Some(own) = self.external.get_mut(self.share.own(self.rest.len())) {
            own.fill(Vec3::zeros());
        }
        for passed in &mut self.passed {
            passed.factor = self.loads[passed.load].factor(at);
        }
        for load in &self.loads {
            let factor = load.factor(at);
            for (node, force) in &load.forces {
                self.external[*node as usize] += force * factor;
            }
        }
    }

    /// The same with all that a fluid, a function and other bodies exert.
    pub(crate) fn evaluate_external(&mut self, at: Instant) {
        self.evaluate_loads(at);
        for pressure in &self.following {
            pressure.add(at, &self.rows, &mut self.external);
        }
        if let Some(surface) = &self.wetted {
            surface.add(&self.rates, &mut self.external);
        }
        if let Some(push) = &mut self.push {
            let (rows, rates) = (&self.rows, &self.rates);
            let forces = push.forces(at, |a| [vector(&rows[a]).into(), vector(&rates[a]).into()]);
            for (sum, force) in self.external.iter_mut().zip(forces) {
                *sum += Vec3::from(*force);
            }
        }
        for (node, force) in &self.exerted {
            self.external[*node as usize] += force;
        }
    }
}

/// The vector of a row.
#[inline]
pub(crate) fn vector(row: &Row) -> Vec3 {
    Vec3::new(row[0], row[1], row[2])
}
