//! From a scene of several bodies to one that marches them together.

use std::collections::BTreeMap;

use explicit_dynamics::{BoundaryState, Dynamics, Interaction, TwoClocks};
use fluid_sph::{Fluid, FluidError, Formulation, Parts, Wall, lattice_moduli};
use sph_core::{Cell, Vec3};

use super::body::{Coupled, Structure};
use super::layout::{Layout, Share};
use super::probes::{Measuring, probes};
use super::soft::soft;
use super::structures::{WettedBody, wet};
use super::watched::watched;
use crate::bodies::beside::{identity, judge_each, lines};
use crate::bodies::fluid::escaped::basins;
use crate::bodies::fluid::figures::Speeds;
use crate::bodies::fluid::walls::{BuiltWalls, Corner, rows};
use crate::bodies::fluid::{describe, parts, places};
use crate::bodies::memory::check_memory;
use crate::bodies::refusal::{body_error, model_error};
use crate::bodies::together::{
    self, AllLinks, BetweenBodies, JointedBodies, OnTool, SetsOfBodies, Side, TouchingBodies, contacts,
    on_tools,
};
use crate::bodies::{BuiltBody, Description, Memory, Model, Ready};
use crate::scene::body_in_scene::{BodyInScene, gravity_on};
use crate::scene::error::SceneError;
use crate::scene::{Analysis, BodyScene, Coupling, CouplingOrder, FluidScene, WallsScene};
use crate::warning::{Warning, WarningKind};

/// Builds a fluid with its walls and the structures in it.
pub(in crate::bodies) fn coupled_model(
    bodies: &[BodyInScene<'_>],
    of_fluid: &BodyInScene<'_>,
    wanted: &FluidScene,
    threads: usize,
) -> Result<Model, SceneError> {
    let (scene, name) = (of_fluid.scene, of_fluid.name);
    let memory = check_memory(of_fluid, wanted.room(wanted.particles_asked() as usize) as f64)?;
    let walls = coupled_walls(bodies, wanted)?;
    let mut wets = Vec::new();
    for body in bodies {
        wets.extend(wet(body, wanted, threads)?.map(|wet| (body.name, wet)));
    }
    let mut fluid = coupled_fluid(of_fluid, wanted, &walls, &wets, threads)?;
    let left_out = places::places(wanted).len() - fluid.held();
    let safety = if let Analysis::Explicit(explicit) = &scene.analysis { explicit.safety.get() } else { 1.0 };
    let step = fluid.stable_step(safety).map_or(0.0, |step| step.dt);
    let liquid = wanted.liquid();
    let mass =
        |wet: &WettedBody<'_>| liquid.density.get() * liquid.sound_speed.get() * step / wet.area_density;
    let added_mass: Vec<f64> = wets.iter().map(|(_, wet)| mass(wet)).collect();
    let mut built = CoupledParts::new(name, &fluid, &walls, &wets);
    let names: Vec<String> = wets.iter().map(|(name, _)| (*name).to_string()).collect();
    let sides: Vec<Side> = wets.iter_mut().filter_map(|(_, wet)| wet.side.take()).collect();
    let contacts = contacts(scene, &names, &sides)?;
    let placed = wets.iter().zip(&built.layout.structures);
    let placed: Vec<_> = placed.map(|((_, wet), range)| (wet.scene, &built.rest[range.clone()])).collect();
    let on_tools = on_tools(&placed, &sides)?;
    built.layout.contacts = 0..contacts.len() + on_tools.len();
    let (joints, links) = joints_between(of_fluid, &wets)?;
    let first = built.layout.contacts.end + usize::from(joints.is_some());
    built.layout.links = first..first + links.len();
    let (watch, unseen) = watched(wanted, &fluid, &walls, &wets, &built.layout)?;
    let probes = {
        let own = wets.iter_mut().map(|(_, wet)| std::mem::take(&mut wet.made.probes)).collect();
        let layout = &mut built.layout;
        let measuring = Measuring { of_fluid, fluid: &fluid, walls: &walls, layout };
        probes(measuring, own)?
    };
    let mut description = describe::of_fluid(of_fluid, wanted, &fluid);
    if left_out > 0 {
        let line =
            format!("{left_out} particles of the geometry left out, inside of rigid bodies or on them");
        description.modelled.push(line);
    }
    let mut warnings = leaks(&walls);
    let coupling = scene.coupling.unwrap_or_default();
    warnings.extend(fluid_first(coupling));
    warnings.extend(stiff(wanted.dimensions(), &parts::formulation(wanted)));
    warnings.extend(pulling(&parts::formulation(wanted), !wets.is_empty()));
    warnings.extend(unseen);
    warnings.extend(soft(&fluid, &walls));
    let (mut made, mut sets) = (Vec::new(), BTreeMap::new());
    for (name, mut wet) in wets {
        if scene.output.fields.is_some() {
            sets.insert(name.to_string(), std::mem::take(&mut wet.made.sets));
        }
        let own = wet.made.warnings.iter();
        warnings.extend(own.map(|own| Warning::new(own.kind, format!("{name}: {}", own.message))));
        made.push((name, wet.made));
    }
    let (bodies, total) = described(name, &description, &walls, &made, wanted.dimensions() == 2);
    if !made.is_empty() {
        description = total;
    }
    description.bodies = bodies;
    description.modelled.extend(contacts.iter().map(TouchingBodies::line));
    description.modelled.extend(on_tools.iter().map(OnTool::line));
    description.modelled.extend(joints.as_ref().map(BetweenBodies::line));
    description.modelled.extend(links.lines());
    description.modelled.extend(JointedBodies::line(scene));
    let memory = together(memory, &made);
    let identity = identity(&made);
    let mut structures: Vec<Box<dyn Structure>> = Vec::new();
    let mut judges = Vec::new();
    for ((_, made), range) in made.into_iter().zip(&built.layout.structures) {
        let cells = made.body.configuration().cells.to_vec();
        judges.extend(made.judge.map(|judge| (judge, range.clone(), cells)));
        structures.push(made.body);
    }
    let contacts = contacts.into_iter().map(|own| Box::new(own) as Box<dyn Interaction>);
    let on_tools = on_tools.into_iter().map(|own| Box::new(own) as Box<dyn Interaction>);
    let joints = joints.map(|own| Box::new(own) as Box<dyn Interaction>);
    let all = contacts.chain(on_tools).chain(joints).chain(links.marched());
    let bracing = JointedBodies::find(scene, &structures).map(|own| Box::new(own) as _);
    let mut clocks = TwoClocks::new(fluid, structures).with_interactions(all.collect()).with_bracing(bracing);
    clocks.order = coupling.order;
    clocks.impedance = coupling.impedance;
    let CoupledParts { layout, rest, cells } = built;
    let basins = basins(scene, wanted.geometry.spacing());
    let speeds = Speeds::of(clocks.fluid());
    let body = Coupled { clocks, layout, rest, cells, added_mass, basins, speeds, watch, ranks: None };
    let made = BuiltBody {
        body: Ready::Dynamic(Box::new(body)),
        description,
        memory,
        identity,
        probes,
        driven: None,
        warnings,
        judge: Some(judge_each(judges)),
        sets: BTreeMap::new(),
    };
    Ok(Model { sets, ..made.model(scene, threads) })
}

/// Springs between structures, and links.
fn joints_between(
    of_fluid: &BodyInScene<'_>,
    wets: &[(&str, WettedBody<'_>)],
) -> Result<(Option<BetweenBodies>, AllLinks), SceneError> {
    let (mut layout, mut sets) = (together::Layout::default(), SetsOfBodies::new());
    for (name, wet) in wets {
        layout.add(name, &*wet.made.body, 0);
        sets.insert((*name).to_string(), wet.made.sets.clone());
    }
    let scene = of_fluid.scene;
    Ok((BetweenBodies::find(scene, &layout, &sets)?, AllLinks::find(scene, &layout, &sets)?))
}

/// The rows of all walls.
pub(super) fn coupled_walls<'a>(
    bodies: &'a [BodyInScene<'a>],
    fluid: &FluidScene,
) -> Result<Vec<BuiltWalls<'a>>, SceneError> {
    let deep = parts::rows_deep(fluid);
    let mut all = Vec::new();
    for view in bodies {
        let BodyScene::Walls(scene) = view.body else { continue };
        let mut rows = rows(view, scene, fluid.geometry.spacing(), deep)?;
        if let Some(periodic) = &fluid.periodic {
            rows.cut(periodic, fluid.geometry.spacing()).map_err(|lost| beyond_sides(view, scene, &lost))?;
        }
        all.push(BuiltWalls { view, scene, rows });
    }
    Ok(all)
}

/// A wall beyond periodic sides that is no part of what goes on through them.
fn beyond_sides(view: &BodyInScene<'_>, walls: &WallsScene, lost: &Vec3) -> SceneError {
    let what = format!(
        "it stands at [{:.4}, {:.4}, {:.4}], beyond a periodic side of the fluid, and where that comes in by the opposite side it has no wall; give all of it \
         between the sides, what goes through one in two pieces",
        lost.x, lost.y, lost.z
    );
    body_error(view, &format!("geometry.{}", walls.geometry.word()), &what)
}

/// The fluid between its walls and around structures.
fn coupled_fluid(
    scene: &BodyInScene<'_>,
    wanted: &FluidScene,
    walls: &[BuiltWalls<'_>],
    wets: &[(&str, WettedBody<'_>)],
    threads: usize,
) -> Result<Fluid, SceneError> {
    let mut positions = places::places(wanted);
    let spacing = wanted.geometry.spacing();
    positions.retain(|place| !wets.iter().any(|(_, wet)| wet.excludes(place, spacing)));
    let velocities = places::velocities(wanted, &positions);
    let gravity = gravity_on(scene.scene, scene.name);
    let wall = |body: &BuiltWalls<'_>, points: &[Vec3]| Wall {
        points: points.to_vec(),
        motion: body.scene.motion.as_ref().map(|motion| parts::motion(motion, &gravity)),
    };
    let pieces = walls.iter().flat_map(|body| body.rows.pieces.iter().map(|piece| wall(body, &piece.points)));
    let structure = |(_, wet): &(&str, WettedBody<'_>)| {
        let mut state = BoundaryState::default();
        wet.made.body.boundary(&mut state);
        fluid_sph::Structure { layout: wet.made.body.boundary_layout().clone(), state }
    };
    let all = Parts {
        dimensions: wanted.dimensions(),
        spacing,
        positions,
        velocities,
        liquid: parts::liquid(wanted),
        formulation: parts::formulation(wanted),
        gravity,
        start: wanted.formulation.options().start,
        walls: pieces.collect(),
        structures: wets.iter().map(structure).collect(),
        domain: None,
        threads: threads.max(1),
    };
    let built = match &wanted.periodic {
        Some(periodic) => Fluid::repeated(all, periodic.periods()),
        None => Fluid::new(all),
    };
    let mut fluid = built.map_err(|error| fluid_refusal(scene, wanted, &error))?;
    if let Some(beach) = &wanted.beach {
        fluid.absorb(parts::beach(beach, &gravity));
    }
    if let Some(current) = &wanted.current {
        fluid.carry(parts::current(current));
    }
    if !wanted.openings.is_empty() {
        let openings = wanted.openings.iter().map(parts::opening).collect();
        let room = wanted.room(fluid.len());
        fluid.open(openings, room).map_err(|error| fluid_refusal(scene, wanted, &error))?;
    }
    Ok(fluid)
}

/// Puts a refusal of the fluid where the scene causes it.
fn fluid_refusal(scene: &BodyInScene<'_>, fluid: &FluidScene, error: &FluidError) -> SceneError {
    let key = match error {
        FluidError::Option { key, .. } => format!("formulation.{}.{key}", fluid.formulation.word()),
        FluidError::Opening { number, .. } => format!("openings[{number}]"),
        _ => format!("geometry.{}", fluid.geometry.word()),
    };
    let path = scene.body_scope().path(&key);
    // What is to be done stands behind the last colon of some messages.
    let message = error.to_string();
    let message = match message.contains("; ") {
        true => message,
        false => message.replacen(": ", "; ", 1),
    };
    model_error(scene.source, &path, &message)
}

/// The bodies one behind the other.
struct CoupledParts {
    layout: Layout,
    rest: Vec<Vec3>,
    cells: Vec<Cell>,
}

impl CoupledParts {
    fn new(name: &str, fluid: &Fluid, walls: &[BuiltWalls<'_>], wets: &[(&str, WettedBody<'_>)]) -> Self {
        let mut layout = Layout { names: vec![name.into()], fluid: fluid.len(), ..Layout::default() };
        let (mut rest, mut cells) = (fluid.rest().to_vec(), Vec::new());
        for (name, wet) in wets {
            let own = wet.made.body.configuration();
            let first = rest.len();
            cells.extend(own.cells.iter().map(|cell| Cell {
                corners: cell.corners.map(|corner| corner + first as u32),
                count: cell.count,
            }));
            rest.extend_from_slice(own.rest);
            layout.structures.push(first..rest.len());
            layout.names.push((*name).into());
        }
        for body in walls {
            let piece = layout.pieces.len();
            for of in &body.rows.pieces {
                let first = rest.len();
                rest.extend_from_slice(&of.points);
                layout.pieces.push(first..rest.len());
            }
            layout.walls.push(piece..layout.pieces.len());
            layout.shares.extend(shares(body, piece));
            layout.names.push(body.view.name.into());
        }
        Self { layout, rest, cells }
    }
}

/// By piece of a body of walls, the first of which has this number: what it has of corners, less what is counted with its particles.
fn shares(body: &BuiltWalls<'_>, first: usize) -> Vec<Vec<Share>> {
    let rows = &body.rows;
    let turns = body.scene.turns();
    let of = |piece: usize| {
        let corners =
            rows.corners.iter().filter(move |corner| corner.sides.iter().any(|side| side.0 == piece));
        let share = move |corner: &Corner| {
            let counted = if corner.piece == piece { 1.0 } else { 0.0 };
            let part = corner.part(piece, turns) - Vec3::repeat(counted);
            Share { piece: first + corner.piece, particle: corner.particle, part }
        };
        corners.map(share).collect()
    };
    (0..rows.pieces.len()).map(of).collect()
}

/// Warnings of walls with gaps.
fn leaks(walls: &[BuiltWalls<'_>]) -> Vec<Warning> {
    let leaky = walls.iter().filter(|body| body.rows.leaks > 0);
    let warning = |body: &BuiltWalls<'_>| {
        let message = format!(
            "{} has gaps wider than 1.2 spacings between its particles at {} places, where it is thinner than a spacing or \
             folded: fluid may leak; use a narrower spacing",
            body.view.name, body.rows.leaks
        );
        Warning::new(WarningKind::LeakyWall, message)
    };
    leaky.map(warning).collect()
}

/// The warning of the order that pumps.
fn fluid_first(coupling: Coupling) -> Option<Warning> {
    let message = "the fluid goes first through a step: structures then answer to forces of a step before, which feeds energy \
                   into them, into light ones most; judge energies, not displacements alone, or use order = \
                   \"structure-first\"";
    (coupling.order == CouplingOrder::FluidFirst).then(|| Warning::new(WarningKind::FluidFirst, message))
}

/// The warning of a width at which lattices of the fluid resist shear so much that waves are this much too fast.
fn stiff(dimensions: usize, formulation: &Formulation) -> Option<Warning> {
    const FAST: f64 = 0.03;
    let modulus = lattice_moduli(dimensions, formulation.smoothing).into_iter().fold(0.0, f64::max);
    let message = || {
        format!(
            "with smoothing = {} the lattice of the fluid has a shear modulus of {modulus:.3} of its pressure, which water has \
             not, at any spacing: frequencies of waves come out up to {:.1} % too high, and pressures may differ \
             with direction by {:.1} % after a shear of a tenth; use {}",
            formulation.smoothing,
            100.0 * modulus,
            20.0 * modulus,
            Formulation::default().smoothing
        )
    };
    (modulus > FAST).then(|| Warning::new(WarningKind::StiffLattice, message()))
}

/// The warning of a fluid that may pull on structures.
fn pulling(formulation: &Formulation, structures: bool) -> Option<Warning> {
    let message = format!(
        "confined lets boundaries pull on the fluid, structures among them; with h = {} Δx the motion of a heavy one was found \
         to grow (h = 2 Δx grew slowly): watch the energies, and take confined = false where the fluid has pressure enough",
        formulation.smoothing
    );
    (formulation.confined && structures).then(|| Warning::new(WarningKind::PullingBoundary, message))
}

/// What each body is, and what they are together.
fn described(
    name: &str,
    fluid: &Description,
    walls: &[BuiltWalls<'_>],
    made: &[(&str, BuiltBody<Box<dyn Structure>>)],
    plane: bool,
) -> (BTreeMap<String, Description>, Description) {
    let mut bodies = BTreeMap::from([(name.to_string(), fluid.clone())]);
    for body in walls {
        bodies.insert(body.view.name.into(), describe::of_walls(body.scene, &body.rows, fluid.spacing));
    }
    bodies.extend(made.iter().map(|(name, made)| ((*name).to_string(), made.description.clone())));
    let moving = || [fluid].into_iter().chain(made.iter().map(|(_, made)| &made.description));
    let particles: usize = moving().map(|body| body.particles).sum();
    let bytes: f64 = moving().map(|body| body.bytes_per_particle * body.particles as f64).sum();
    let mut modelled = lines(bodies.iter(), |body| &body.modelled);
    if plane {
        modelled.push("energies: those of a plane fluid by depth, of structures by their own width".into());
    }
    let total = Description {
        kind: "coupled",
        method: "two clocks".into(),
        particles,
        points: moving().map(|body| body.points).sum(),
        dof: moving().map(|body| body.dof).sum(),
        spacing: fluid.spacing,
        bytes_per_particle: bytes / particles as f64,
        modelled,
        left_out: lines(bodies.iter(), |body| &body.left_out),
        ..Description::default()
    };
    (bodies, total)
}

/// What all bodies need together.
fn together(fluid: Memory, made: &[(&str, BuiltBody<Box<dyn Structure>>)]) -> Memory {
    let needed = made.iter().map(|(_, made)| made.memory.needed).sum::<f64>() + fluid.needed;
    Memory { needed, available: fluid.available }
}
