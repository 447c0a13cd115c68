//! A body: its space of displacements, its state, and the internal forces of a state.

use implicit_statics::OutOfBounds;
use solid_kinematics::{Formulation, Material, PointError, PointState, Tangent, Tensor, Trial};
use sph_core::{CellList, MovingLeastSquares, Vec3};

use crate::blocks::Blocks;
use crate::discretisation::Discretisation;
use crate::error::GalerkinError;
use crate::essential::Unknowns;
use crate::heat::Heat;
use crate::images::Images;
use crate::loads::Loads;
use crate::parts::{Parts, Volumes};
use crate::reduction::Reduction;
use crate::stiffness::Scratch;
use crate::volumes::{Shared, Sharing};

/// Nodes nearer than this share of the least radius of the support coincide.
const COINCIDENT: f64 = 1e-9;
/// Least mass of a node over that of its share of the cells, where a surface cuts them.
const LEAST: f64 = 0.1;
/// Deviation of material axes from orthonormal that is rounding.
const SKEW: f64 = 1e-9;
/// |w| of a step beyond which it is refused: half a step turns by 27°.
const WIDEST_TURN: f64 = 1.0;

/// The point of a cell that cannot follow, and why.
pub(crate) type Trouble = Option<(u32, PointError)>;

/// An element-free Galerkin body in equilibrium, or on its way there.
///
/// Unknowns are nodal parameters d; displacements are `u(X) = Σ_I φ_I(X) d_I`, also at nodes. What an update needs of history is
/// that of the last state that was accepted.
pub struct Galerkin {
    pub(crate) space: Discretisation,
    pub(crate) squares: MovingLeastSquares,
    pub(crate) material: Material,
    pub(crate) axes: Tensor,
    /// Radii of the support \[L\].
    pub(crate) radii: [f64; 3],
    pub(crate) tangent: Tangent,
    pub(crate) unknowns: Unknowns,
    /// Number of conditions.
    conditions: usize,
    pub(crate) loads: Loads,
    pub(crate) masses: Vec<f64>,
    moved_mass: f64,
    pub(crate) blocks: Blocks,
    pub(crate) reduction: Reduction,
    pub(crate) scratch: Vec<Scratch>,
    pub(crate) threads: usize,
    /// Nodal parameters \[L\].
    pub(crate) parameters: Vec<f64>,
    /// Those of the last state accepted, and its points.
    pub(crate) accepted: Vec<f64>,
    pub(crate) history: Vec<PointState>,
    /// Points at the present state.
    pub(crate) trials: Vec<Trial>,
    /// How far the points of a cell share one change of volume, and what that does to each.
    pub(crate) sharing: Option<Sharing>,
    pub(crate) shared: Vec<Shared>,
    /// Forces on parameters, of cells and of all.
    pub(crate) cell_forces: Vec<f64>,
    pub(crate) internal: Vec<f64>,
    pub(crate) external: Vec<f64>,
    /// What other bodies exert; empty of a body alone.
    pub(crate) exerted: Vec<f64>,
    pub(crate) troubles: Vec<Trouble>,
    /// Whether points and internal forces are those of the parameters.
    pub(crate) evaluated: bool,
    /// Level at which held parameters stand.
    pub(crate) level: f64,
    /// By how much points expand; none of a body that is not warmed.
    pub(crate) heat: Option<Heat>,
    /// Tangents since the last state accepted, and whether the consistent one is insisted on.
    pub(crate) tangents: usize,
    pub(crate) insists: bool,
}

impl Galerkin {
    /// Builds a body at rest.
    ///
    /// # Errors
    /// [`GalerkinError`].
    pub fn new(parts: Parts) -> Result<Self, GalerkinError> {
        check(&parts)?;
        let images = Images::new(&parts.nodes, &parts.mirrors, &parts.support);
        let all = [parts.nodes.as_slice(), &images.places].concat();
        let squares = MovingLeastSquares::new(&all, parts.basis, parts.support, parts.weight)?;
        let space = Discretisation::new(&parts, images, &squares)?;
        let unknowns = Unknowns::new(&space, &parts.conditions, parts.essential)?;
        let loads = Loads::new(&parts.loads, (&parts.cells, parts.rule), &squares, &space)?;
        let count = space.nodes.len();
        let of_cells = space.cells.iter().map(|cell| &cell.nodes);
        let together = of_cells.chain(loads.pressed.iter().map(|point| &point.nodes));
        let together: Vec<Vec<u32>> = together.map(|numbers| space.images.reals(numbers)).collect();
        let blocks = Blocks::new(count, &together.iter().map(Vec::as_slice).collect::<Vec<_>>());
        let reduction = Reduction::new(&blocks, &unknowns);
        let rest = PointState::rest(parts.axes);
        let trial = Trial {
            state: rest,
            kirchhoff: Tensor::zeros(),
            piola: Tensor::zeros(),
            inverse: Tensor::identity(),
            turn: 0.0,
        };
        let stride = space.force_stride();
        let shares = parts.cut.as_ref().map(|cut| cut.shares.as_slice());
        let (masses, moved_mass) = masses(&space, parts.density, shares);
        Ok(Self {
            masses,
            moved_mass,
            parameters: vec![0.0; 3 * count],
            accepted: vec![0.0; 3 * count],
            history: vec![rest; space.places.len()],
            trials: vec![trial; space.places.len()],
            shared: vec![Shared::ALONE; space.places.len()],
            sharing: match parts.volumes {
                Volumes::Points => None,
                Volumes::Shared => Sharing::of(&parts.material.moduli),
                Volumes::Mean => Some(Sharing::WHOLE),
            },
            cell_forces: vec![0.0; stride * space.cells.len()],
            internal: vec![0.0; 3 * count],
            external: vec![0.0; 3 * count],
            exerted: Vec::new(),
            troubles: vec![None; space.cells.len()],
            scratch: Vec::new(),
            evaluated: false,
            level: 0.0,
            heat: None,
            tangents: 0,
            insists: false,
            material: parts.material,
            axes: parts.axes,
            radii: parts.support.radii,
            conditions: parts.conditions.len(),
            tangent: parts.tangent,
            threads: parts.threads.max(1),
            space,
            squares,
            unknowns,
            loads,
            blocks,
            reduction,
        })
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.space.nodes.len()
    }

    /// Number of points of the quadrature.
    pub fn points(&self) -> usize {
        self.space.places.len()
    }

    /// The greatest force that a uniform stress leaves on a node of cells that a surface cuts, over that stress on the square of a spacing \[–\]: by Gauss's
    /// theorem zero, but for the quadrature; zero of whole cells.
    pub fn uneven(&self) -> f64 {
        self.space.uneven
    }

    /// Part of the mass that cut cells give to nodes for which integrals of shape functions leave none, or too little \[–\].
    pub fn moved_mass(&self) -> f64 {
        self.moved_mass
    }

    /// Equations of conditions that said nothing new and were left out.
    pub fn dependent_conditions(&self) -> usize {
        self.unknowns.dropped
    }

    /// Forces with which the conditions hold their nodes along their directions, one a condition, at the present state and a
    /// level \[F\]. Where conditions say the same, the first of them has the force.
    pub fn reactions(&mut self, level: f64) -> Vec<f64> {
        self.evaluate_internal(level);
        self.evaluate_external(level);
        let forces: Vec<f64> = self.internal.iter().zip(&self.external).map(|(a, b)| a - b).collect();
        let mut out = vec![0.0; self.conditions];
        self.unknowns.reactions(&forces, &mut out);
        out
    }

    /// Loads at a level with what other bodies exert.
    pub(crate) fn evaluate_external(&mut self, level: f64) {
        self.loads.forces(level, (&self.space.images, &self.parameters), &mut self.external);
        self.external.iter_mut().zip(&self.exerted).for_each(|(sum, force)| *sum += force);
    }

    /// Whether stress has a history.
    pub(crate) fn remembers(&self) -> bool {
        matches!(self.material.formulation, Formulation::StrainRotation { .. })
    }

    /// Puts held parameters where the unknowns and a level have them.
    pub(crate) fn put(&mut self, level: f64) {
        let goes = self.unknowns.moves || self.heat.is_some();
        let stands = self.evaluated && (!goes || self.level == level);
        if !stands {
            self.unknowns.put(level, &mut self.parameters);
            self.stretch(level);
            (self.level, self.evaluated) = (level, false);
        }
    }

    /// Evaluates points and internal forces at a level, unless that was done.
    pub(crate) fn evaluate_internal(&mut self, level: f64) {
        self.put(level);
        if !self.evaluated {
            self.sweep();
            self.evaluated = true;
        }
    }

    /// The first point that could not follow the last deformation tried, and why.
    pub fn trouble(&self) -> Option<(Vec3, PointError)> {
        let found = |(cell, trouble): (usize, &Trouble)| {
            trouble
                .map(|(point, error)| (self.space.places[cell * self.space.points + point as usize], error))
        };
        self.troubles.iter().enumerate().find_map(found)
    }

    /// Refuses steps that turn too far for the update.
    pub(crate) fn turns_within_bounds(&self) -> Result<(), OutOfBounds> {
        let widest =
            (0..self.trials.len()).max_by(|&a, &b| self.trials[a].turn.total_cmp(&self.trials[b].turn));
        match widest.map(|point| (point, self.trials[point].turn)) {
            Some((point, turn)) if turn > WIDEST_TURN => {
                let x = self.space.places[point];
                Err(OutOfBounds {
                    place: format!("the Gauss point at ({:.4}, {:.4}, {:.4})", x.x, x.y, x.z),
                    what: "spin of the step",
                    value: turn,
                    bound: "1 at most: take smaller steps",
                })
            }
            _ => Ok(()),
        }
    }
}

/// Masses of nodes \[M\], their images' with them: integrals of the shape functions; where one is not positive and a surface cuts the cells, these or
/// a tenth of the node's share of the cells, of whole cells those of their squares, either scaled to the whole. And the part of the whole that cut cells
/// so give to nodes for which their integrals leave less.
fn masses(space: &Discretisation, density: f64, shares: Option<&[f64]>) -> (Vec<f64>, f64) {
    let mut integrals = space.integrals[..space.nodes.len()].to_vec();
    for (image, own) in space.integrals.iter().enumerate().skip(space.nodes.len()) {
        let node = space.images.real(image as u32).0 as usize;
        (0..2).for_each(|k| integrals[node][k] += own[k]);
    }
    let sum = |k: usize| integrals.iter().map(|integral| integral[k]).sum::<f64>();
    if integrals.iter().all(|integral| integral[0] > 0.0) {
        return (integrals.iter().map(|integral| density * integral[0]).collect(), 0.0);
    }
    if let Some(shares) = shares {
        let clipped = |(integral, share): (&[f64; 2], &f64)| integral[0].max(LEAST * share);
        let all: Vec<f64> = integrals.iter().zip(shares).map(clipped).collect();
        let left = sum(0) / all.iter().sum::<f64>();
        return (all.into_iter().map(|own| density * left * own).collect(), 1.0 - left);
    }
    let scale = density * sum(0) / sum(1);
    (integrals.iter().map(|integral| scale * integral[1]).collect(), 0.0)
}

fn check(parts: &Parts) -> Result<(), GalerkinError> {
    for (number, x) in parts.nodes.iter().enumerate() {
        if let Some(&value) = x.iter().find(|x| !x.is_finite()) {
            return Err(GalerkinError::NotFinite { what: "a coordinate of node", number, value });
        }
    }
    if parts.nodes.is_empty() {
        return Err(GalerkinError::EmptySet("the body"));
    }
    if parts.cells.cells.is_empty() {
        return Err(GalerkinError::EmptySet("the quadrature"));
    }
    if !(parts.density > 0.0 && parts.density.is_finite()) {
        return Err(GalerkinError::Density(parts.density));
    }
    if parts.material.plastic.is_some() && parts.material.formulation == Formulation::StVenant {
        return Err(GalerkinError::FlowWithoutSteps);
    }
    let skew = (parts.axes.transpose() * parts.axes - Tensor::identity()).norm();
    if skew > SKEW || skew.is_nan() {
        return Err(GalerkinError::Axes(skew));
    }
    let least = parts.support.radii.iter().fold(f64::INFINITY, |least, &radius| least.min(radius));
    if least > 0.0 && least.is_finite() {
        let near = CellList::new(&parts.nodes, least);
        let mut found = Vec::new();
        for (node, x) in parts.nodes.iter().enumerate() {
            near.within(x, COINCIDENT * least, &mut found);
            if let Some(&other) = found.iter().find(|&&other| other as usize > node) {
                return Err(GalerkinError::Coincident(node as u32, other));
            }
        }
    }
    Ok(())
}
