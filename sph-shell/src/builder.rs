//! From parts to a shell: what it may have beside them, and the one place where all of it is checked and put together in order.

use shell_kinematics::{Section, StrainMeasure};
use sph_core::{Cloud, Vec3};

use crate::Shell;
use crate::conditions::case::LoadCase;
use crate::conditions::constraints::Constraints;
use crate::conditions::loads::AppliedLoad;
use crate::conditions::own_contact::{OwnContact, SelfContact};
use crate::conditions::springs::Springs;
use crate::conditions::stages::Stages;
use crate::conditions::supports::Supported;
use crate::conditions::tools::{Tool, Tools};
use crate::dependents::Dependents;
use crate::error::{HeatError, ShellError, StiffenerError};
use crate::formulation::{Formulation, Reach};
use crate::heat::Temperature;
use crate::initial_stress::InitialStress;
use crate::junction::group::Junctions;
use crate::junction::rigid::{Bodies, RigidSet};
use crate::loading::Loading;
use crate::material::Material;
use crate::motion::Moving;
use crate::points::scheme::Points;
use crate::reference::Reference;
use crate::regions::{Region, Regions};
use crate::stiffeners::{Stiffener, Stiffeners};
use crate::ties::list::{Tie, Ties};
use crate::time::evaluation::Evaluation;
use crate::time::share::Share;
use crate::wetted::surface::Surface;
use crate::wetted::wetting::Wetting;

/// What every shell is made of.
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

/// A shell before it is built: its parts, and what else it is to have, in any order.
#[must_use]
pub struct ShellBuilder {
    parts: Parts,
    regions: Vec<Region>,
    origin: Vec3,
    ties: Vec<Tie>,
    masses: Vec<(u32, f64)>,
    stiffeners: Vec<Stiffener>,
    rigid: Vec<RigidSet>,
    springs: Springs,
    tools: Vec<Tool>,
    own_contact: Option<OwnContact>,
    stresses: Vec<InitialStress>,
    stress_case: LoadCase,
    temperatures: Vec<Temperature>,
    wetting: Option<Wetting>,
}

impl Shell {
    /// A shell of these parts, to be built with [`ShellBuilder::build`].
    pub fn builder(parts: Parts) -> ShellBuilder {
        ShellBuilder {
            parts,
            regions: Vec::new(),
            origin: Vec3::zeros(),
            ties: Vec::new(),
            masses: Vec::new(),
            stiffeners: Vec::new(),
            rigid: Vec::new(),
            springs: Springs::default(),
            tools: Vec::new(),
            own_contact: None,
            stresses: Vec::new(),
            stress_case: LoadCase::Preload,
            temperatures: Vec::new(),
            wetting: None,
        }
    }
}

impl ShellBuilder {
    /// Sections of their own on some cells; the section of the parts is that of all others.
    pub fn regions(self, regions: Vec<Region>) -> Self {
        Self { regions, ..self }
    }

    /// Keeps all places from an origin \[L\]: displacements of a shell far from zero keep the digits that its places would take.
    /// Places that are given and read ([`Shell::position`], [`RigidSet`], axes of turns) are from zero all the same; only
    /// those of [`Reference::cloud`] and of [`Shell::motion`] are from the origin. Not together with a fluid.
    pub fn origin(self, origin: Vec3) -> Self {
        Self { origin, ..self }
    }

    /// Ties edges to cells of other sheets, whose particles may stand elsewhere.
    ///
    /// What hangs has no unknowns of its own; supports on it must be those of its host. Not together with a fluid, which would not
    /// see what hangs move.
    pub fn ties(self, ties: Vec<Tie>) -> Self {
        Self { ties, ..self }
    }

    /// Masses \[M\] lumped at particles: they add to inertia in the march and in modes, and to weight on all of the shell, and do not
    /// turn with the director.
    pub fn masses(self, masses: Vec<(u32, f64)>) -> Self {
        Self { masses, ..self }
    }

    /// Bars along lines of particles.
    pub fn stiffeners(self, stiffeners: Vec<Stiffener>) -> Self {
        Self { stiffeners, ..self }
    }

    /// Sets that move as rigid bodies.
    pub fn rigid(self, rigid: Vec<RigidSet>) -> Self {
        Self { rigid, ..self }
    }

    /// Springs on particles, between them, and on rigid sets.
    pub fn springs(self, springs: impl Into<Springs>) -> Self {
        Self { springs: springs.into(), ..self }
    }

    /// Rigid tools that the shell may touch.
    pub fn tools(self, tools: Vec<Tool>) -> Self {
        Self { tools, ..self }
    }

    /// Lets the shell touch itself, if there is a way how.
    pub fn touching_itself(self, own_contact: impl Into<Option<OwnContact>>) -> Self {
        Self { own_contact: own_contact.into(), ..self }
    }

    /// Stresses of the unstrained shell; those of one cell add up. They belong to the preload.
    pub fn stresses(self, stresses: Vec<InitialStress>) -> Self {
        Self { stresses, ..self }
    }

    /// Lets the level of the analysis bring the initial stress up, as it does loads, instead of a preload; without time.
    pub fn stress_by_level(self) -> Self {
        Self { stress_case: LoadCase::Loading, ..self }
    }

    /// Changes of temperature; those of one cell add up.
    pub fn temperatures(self, temperatures: Vec<Temperature>) -> Self {
        Self { temperatures, ..self }
    }

    /// Lays points over the wet faces, through which a fluid acts on the shell; it acts on nothing else.
    pub fn wetted(self, wetting: Wetting) -> Self {
        Self { wetting: Some(wetting), ..self }
    }

    /// Builds stencils, masses, reference strains and constraints, and with them all that was asked for.
    ///
    /// Masses hang on ties, rigid bodies on masses, springs of bodies on those: the order is this function's.
    ///
    /// # Errors
    /// [`ShellError`]: invalid clouds, stencils too small for their order, empty or unknown sets, supports that contradict each other;
    /// cells in two regions; edges too far from their hosts, on too few of their cells, without particles of their own, with supports
    /// that the host does not have, ties in a circle; masses that are not positive and finite; stiffeners on what is no line, or beyond the centre of its curvature; rigid sets that meet each other, stand on one
    /// line along a normal, hold a particle that is supported, tied to a cell, or of a junction only in part; springs without a stiffness, along a
    /// director, or of one particle; tools without sense, on shells without cells or with sections over or below their particles; contact of a shell with itself where its
    /// thickness is not one, edges are tied or it has no stiffness; what is enclosed by cells that are no surface, with rims that are free to change its volume, or without any; stresses whose axis stands on the surface; heat of what does not say how it expands; wettings out of bounds, of a shell about an origin, in a
    /// plane problem of a shell that is no strip across the plane; and regions, ties, rigid sets, stresses, heat and sections with memory where
    /// strains are not sampled in cells, the last together with stresses or heat too.
    pub fn build(self) -> Result<Shell, ShellError> {
        let Self {
            parts,
            regions,
            origin,
            ties,
            masses,
            stiffeners,
            rigid,
            springs,
            tools,
            own_contact,
            stresses,
            stress_case,
            temperatures,
            wetting,
        } = self;
        let Parts {
            mut cloud,
            section,
            strain,
            material_axis,
            density,
            formulation,
            supports,
            loads,
            threads,
        } = parts;
        if !matches!(formulation, Formulation::StressPoint(Reach::Cell)) {
            let of_cells = [
                (cloud.joined.is_empty(), ShellError::JunctionOfWideStencils),
                (regions.is_empty(), ShellError::RegionsWithoutCells),
                (ties.is_empty(), ShellError::TieOfWideStencils),
                (rigid.is_empty(), ShellError::RigidOfWideStencils),
                (stiffeners.is_empty(), StiffenerError::WideStencils.into()),
                (stresses.is_empty(), ShellError::StressOfWideStencils),
                (temperatures.is_empty(), HeatError::WideStencils.into()),
            ];
            of_cells.into_iter().try_for_each(|(none, refusal)| if none { Ok(()) } else { Err(refusal) })?;
        }
        let mut given = Vec::new();
        if origin != Vec3::zeros() {
            given.clone_from(&cloud.positions);
            cloud.positions.iter_mut().for_each(|x| *x -= origin);
        }
        let one_axis = material_axis.filter(|_| regions.is_empty());
        let scales = section.scales();
        let mut reference = Reference::new(cloud, &formulation, &scales, density, one_axis.as_ref())?;
        (reference.origin, reference.given) = (origin, given);
        let regions = Regions::new(regions, &reference)?;
        if regions.any() {
            regions.align(material_axis, &mut reference)?;
            regions.weigh(&*section, density, &mut reference);
        }
        loads.iter().try_for_each(|applied| applied.load.check(&reference))?;
        let mut constraints = Constraints::new(&reference, &supports)?;
        let section = section.into();
        let mut material =
            Material { section, strain, regions, stresses: Vec::new(), stress_case, heat: None };
        let mut points = Points::new(&reference, &formulation, &material.scales(), density)?;
        let under = [
            (!stresses.is_empty()).then_some("does not go with an initial stress; remove one of them"),
            (!temperatures.is_empty())
                .then_some("does not go with a change of temperature; remove one of them"),
        ];
        material.divide(&mut points, under.into_iter().flatten().next())?;

        let mut ties = Ties::new(&reference, &material, &ties)?;
        ties.hold(&reference, &mut constraints)?;
        reference.lump(&masses, material.thickness(&reference))?;
        let thickness = material.thickness(&reference);
        let stiffeners = Stiffeners::new(&stiffeners, &mut reference, thickness)?;
        ties.weigh(&reference, material.thickness(&reference));
        let moving = ties.moving_masses(&reference);
        let junctions = Junctions::new(&reference, moving, |a| ties.of(a).is_none())?;
        let bodies = Bodies { reference: &reference, material: &material, ties: &ties };
        let junctions = bodies.join(junctions, &rigid, &mut constraints)?;

        for (number, applied) in loads.iter().enumerate() {
            let enclosed = applied.load.enclosed();
            enclosed.map_or(Ok(()), |enclosed| enclosed.close(number, &reference, &constraints))?;
        }
        let springs = springs.checked(&reference)?;
        junctions.check_springs(&springs.of_bodies)?;
        let tools = match tools.is_empty() {
            true => Tools::default(),
            false => {
                let scales = material.scales();
                let all = std::iter::once(scales.uniform).chain(scales.own);
                let bending = all.map(|scales| scales.bending).fold(f64::INFINITY, f64::min);
                let stages = Stages::new(&reference.cloud, bending);
                Tools::new(tools, &reference, &material.half_thickness(&reference)?, stages)?
            }
        };
        if own_contact.is_some() && !ties.is_empty() {
            return Err(ShellError::ContactOfTies);
        }
        let touching = own_contact.map(|own| {
            let half = material.half_thickness(&reference).map_err(SelfContact::refusal)?;
            SelfContact::new(&own, &reference, &half, ties.moving_masses(&reference)[0])
        });
        let own_contact = touching.transpose()?.map(Box::new);
        material.stress(&stresses, &reference, &mut points)?;
        material.warm(&temperatures, &reference, &mut points)?;
        let surface =
            wetting.map(|wetting| Surface::new(&reference, material.thickness(&reference), &wetting));
        let wetted = surface.transpose()?.map(Box::new);
        Ok(Shell {
            loading: Loading::new(loads, springs, tools, own_contact, wetted, reference.cloud.len()),
            motion: Moving::new(&reference),
            evaluation: Evaluation::new(&points, &reference, threads),
            share: Share::alone(reference.cloud.len()),
            dependents: Dependents { junctions, ties },
            stiffeners,
            reference,
            material,
            points,
            constraints,
        })
    }
}
