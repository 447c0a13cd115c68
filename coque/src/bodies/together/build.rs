//! From a scene of several bodies without a fluid to one that is marched or balanced.

use std::collections::BTreeMap;
use std::ops::Range;

use peridynamics::StaticSolid;
use rigid_body::RestingBody;
use sph_shell::StaticShell;

use super::body::Together;
use super::contact::{Side, TouchingBodies};
use super::faces::Faces;
use super::glue::{Bodies, GluedBodies};
use super::jointed::JointedBodies;
use super::joints::{BetweenBodies, SetsOfBodies};
use super::layout::Layout;
use super::links::AllLinks;
use super::on_tool::OnTool;
use super::parts::{Balanced, BalancedPart, Marched, MarchedPart};
use super::sides::{of_bonds, of_galerkin, of_rigid, of_shell};
use super::tooled::on_tools;
use super::touched::contacts;
use super::wet::{WetSurface, wetting};
use crate::bodies::beside::{identity, judge_each, lines};
use crate::bodies::body::Body;
use crate::bodies::galerkin::build::galerkin_made;
use crate::bodies::refusal::{not_a, refuse_modes};
use crate::bodies::rigid_body::build::rigid_made;
use crate::bodies::shell::build::shell_made;
use crate::bodies::solid::build::solid_made;
use crate::bodies::{BuiltBody, Description, Memory, Model, Probe, Ready};
use crate::scene::body_in_scene::{BodyInScene, ShellInScene};
use crate::scene::error::SceneError;
use crate::scene::owner::Owner;
use crate::scene::{Analysis, BodyScene, FluidScene, Scene};
use crate::warning::{Warning, WarningKind};

/// A body as it was built, in time or at rest.
enum Part {
    Marched(Box<dyn MarchedPart>),
    Balanced(Box<dyn BalancedPart>),
}

impl Part {
    fn body(&self) -> &dyn Body {
        match self {
            Self::Marched(body) => body.as_ref(),
            Self::Balanced(body) => body.as_ref(),
        }
    }
}

/// Builds all bodies with what is asked of them.
pub(in crate::bodies) fn together_model(
    scene: &Scene,
    bodies: &[BodyInScene<'_>],
    threads: usize,
) -> Result<Model, SceneError> {
    Ok(together_in(scene, bodies, None, threads)?.0)
}

/// The same of shells that a fluid wets, with their wet surfaces, whose unknowns are those of all together.
pub(in crate::bodies) fn together_in(
    scene: &Scene,
    bodies: &[BodyInScene<'_>],
    fluid: Option<&FluidScene>,
    threads: usize,
) -> Result<(Model, Vec<WetSurface>), SceneError> {
    let (mut made, mut sides, mut faces) = (Vec::new(), Vec::new(), BTreeMap::new());
    let mut wet = Vec::new();
    for body in bodies {
        let Surfaced { part, side, own, surface } = part(body, fluid, threads)?;
        wet.push(surface);
        made.push((body.name, part));
        sides.extend(side);
        faces.extend(own.map(|own| (body.name.to_string(), own)));
    }
    let mut layout = Layout::default();
    let mut sets = SetsOfBodies::new();
    for (name, part) in &mut made {
        layout.add(name, part.body.body(), part.description.points);
        sets.insert((*name).to_string(), std::mem::take(&mut part.sets));
    }
    let joints = BetweenBodies::find(scene, &layout, &sets)?;
    let links = AllLinks::find(scene, &layout, &sets)?;
    let contacts = contacts(scene, &layout.names, &sides)?;
    let mut glue = Bodies { scene, layout: &layout, sets: &sets, faces: &faces }.glued()?;
    let rest = |(body, range): (_, &Range<usize>)| (body, &layout.rest[range.clone()]);
    let placed: Vec<_> = bodies.iter().zip(&layout.particles).map(rest).collect();
    let on_tools = on_tools(&placed, &sides)?;
    let own = made.iter_mut().map(|(_, part)| std::mem::take(&mut part.probes)).collect();
    let probes = probes(scene, &layout, own)?;
    let warned = |(name, part): &mut (&str, BuiltBody<Part>)| -> Vec<Warning> {
        let own = std::mem::take(&mut part.warnings).into_iter();
        own.map(|own| Warning::new(own.kind, format!("{name}: {}", own.message))).collect()
    };
    let coarse = bodies.iter().filter_map(|body| galerkin_contact(scene, body));
    let warnings = made.iter_mut().flat_map(warned).chain(coarse).collect();
    let mut description = described(
        scene,
        &made,
        joints.as_ref(),
        contacts.iter().map(TouchingBodies::line).chain(on_tools.iter().map(OnTool::line)),
    );
    description.modelled.extend(glue.iter().map(GluedBodies::line));
    description.modelled.extend(links.lines());
    description.modelled.extend(JointedBodies::line(scene));
    refuse_modes(scene, description.dof)?;
    let memory = made.iter().fold(Memory::default(), |sum, (_, part)| Memory {
        needed: sum.needed + part.memory.needed,
        available: part.memory.available,
    });
    let identity = identity(&made);
    let mut judges = Vec::new();
    let mut marched: Vec<Box<dyn MarchedPart>> = Vec::new();
    let mut balanced: Vec<Box<dyn BalancedPart>> = Vec::new();
    for ((_, part), range) in made.into_iter().zip(&layout.particles) {
        let cells = part.body.body().configuration().cells.to_vec();
        judges.extend(part.judge.map(|judge| (judge, range.clone(), cells)));
        match part.body {
            Part::Marched(body) => marched.push(body),
            Part::Balanced(body) => balanced.push(body),
        }
    }
    let (mut firsts, mut end) = (Vec::with_capacity(balanced.len()), 0);
    for body in &balanced {
        firsts.push(end);
        end += body.unknowns();
    }
    if matches!(scene.analysis, Analysis::Linear(_)) {
        let mut end = 0;
        let forces = balanced.iter().map(|body| {
            let first = end;
            end += body.forces().len();
            first..end
        });
        layout.forces = forces.collect();
    }
    layout.contacts =
        usize::from(joints.is_some())..usize::from(joints.is_some()) + contacts.len() + on_tools.len();
    layout.glue = layout.contacts.end..layout.contacts.end + glue.len();
    layout.links = layout.glue.end..layout.glue.end + links.len();
    let body = match &scene.analysis {
        Analysis::Explicit(_) => {
            pace(&mut glue, &mut marched);
            let springs = joints.map(|joints| Box::new(joints) as Box<dyn explicit_dynamics::Interaction>);
            let touching = contacts.into_iter().map(|own| Box::new(own) as _);
            let on_tools = on_tools.into_iter().map(|own| Box::new(own) as _);
            let glue = glue.into_iter().map(|own| Box::new(own) as _);
            let all = springs.into_iter().chain(touching).chain(on_tools).chain(glue).chain(links.marched());
            let jointed = JointedBodies::find(scene, &marched);
            let system = Marched::new(marched, all.collect());
            Ready::Dynamic(Box::new(Together { system, layout, joints: jointed }))
        }
        _ => {
            for own in &mut glue {
                own.settle(|body, particles, out| balanced[body].places(particles, out));
            }
            let springs = joints.map(|joints| Box::new(joints) as Box<dyn implicit_statics::Interaction>);
            let touching = contacts.into_iter().map(|own| Box::new(own) as _);
            let on_tools = on_tools.into_iter().map(|own| Box::new(own) as _);
            let glue = glue.into_iter().map(|own| Box::new(own) as _);
            let all = springs.into_iter().chain(touching).chain(on_tools).chain(glue).chain(links.balanced());
            let system = Balanced::new(balanced, all.collect());
            Ready::Static(Box::new(Together { system, layout, joints: None }))
        }
    };
    let (driven, judge) = (None, Some(judge_each(judges)));
    let wet = wet.into_iter().zip(firsts);
    let wet = wet.filter_map(|(surface, first)| surface.map(|surface| surface.numbered_from(first)));
    let own_sets = BTreeMap::new();
    let sets = if scene.output.fields.is_some() { sets } else { BTreeMap::new() };
    let made =
        BuiltBody { body, description, memory, identity, probes, driven, warnings, judge, sets: own_sets };
    Ok((Model { sets, ..made.model(scene, threads) }, wet.collect()))
}

/// What is said of a Galerkin solid that touches: its surface moves by shape functions some spacings wide.
fn galerkin_contact(scene: &Scene, body: &BodyInScene<'_>) -> Option<Warning> {
    let BodyScene::Solid(solid) = body.body else { return None };
    solid.galerkin()?;
    let names = |pair: &[String; 2]| pair.iter().any(|name| name == body.name);
    scene.contact.iter().filter_map(|own| own.pair()).find(|pair| names(pair))?;
    let message = format!(
        "`{}` touches by shape functions some spacings wide: the force between pressed faces is held to 3 %, but a contact of three cells in its half \
         width came out two fifths too wide beside Hertz's; refine until what you read of the contact stands still",
        body.name
    );
    Some(Warning::new(WarningKind::CoarseContact, message))
}

/// What each body is, and what they are together.
fn described(
    scene: &Scene,
    made: &[(&str, BuiltBody<Part>)],
    joints: Option<&BetweenBodies>,
    contacts: impl Iterator<Item = String>,
) -> Description {
    let each = || made.iter().map(|(_, part)| &part.description);
    let bodies: BTreeMap<String, Description> =
        made.iter().map(|(name, part)| ((*name).to_string(), part.description.clone())).collect();
    let particles: usize = each().map(|body| body.particles).sum();
    let bytes: f64 = each().map(|body| body.bytes_per_particle * body.particles as f64).sum();
    let mut modelled = lines(bodies.iter(), |body| &body.modelled);
    modelled.extend(joints.map(BetweenBodies::line));
    modelled.extend(contacts);
    let way = if matches!(scene.analysis, Analysis::Explicit(_)) { "one clock" } else { "one balance" };
    Description {
        kind: "several",
        method: way.into(),
        particles,
        points: each().map(|body| body.points).sum(),
        dof: each().map(|body| body.dof).sum(),
        spacing: each().map(|body| body.spacing).fold(f64::INFINITY, f64::min),
        bytes_per_particle: bytes / particles as f64,
        modelled,
        left_out: lines(bodies.iter(), |body| &body.left_out),
        bodies,
        ..Description::default()
    }
}

/// Makes glue as stiff as steps in time bear: those of the bodies alone, by the fastest motion of all.
fn pace(glue: &mut [GluedBodies], marched: &mut [Box<dyn MarchedPart>]) {
    if glue.is_empty() {
        return;
    }
    // A body without a step of its own, as a rigid one, has no motion that is fast.
    let steps = marched.iter_mut().filter_map(|body| body.stable_step(1.0).ok().map(|step| step.dt));
    let least = steps.fold(f64::INFINITY, f64::min);
    for own in glue {
        own.settle(|body, particles, out| {
            explicit_dynamics::Joinable::places(&*marched[body], particles, out)
        });
        own.pace(4.0 / (least * least), |body, particles| marched[body].masses(particles));
    }
}

/// A body that was built, with its surface where a contact names it, and its faces where it is glued.
struct Surfaced {
    part: BuiltBody<Part>,
    side: Option<Side>,
    own: Option<Faces>,
    /// What of it a fluid wets.
    surface: Option<WetSurface>,
}

/// Builds one of the bodies.
fn part(scene: &BodyInScene<'_>, fluid: Option<&FluidScene>, threads: usize) -> Result<Surfaced, SceneError> {
    let marched = matches!(scene.analysis, Analysis::Explicit(_));
    let glued = scene.glued.then_some(());
    let mut surface = None;
    let (part, side, own) = match scene.body {
        BodyScene::Shell(shell) => {
            let wetting = fluid.map(|fluid| wetting(shell, fluid));
            let made = shell_made(&ShellInScene::new(scene, shell), threads, wetting)?;
            let side = of_shell(scene, &made.body)?;
            let own = glued.map(|()| Faces::of_shell(&made.body));
            surface = fluid.map(|_| WetSurface::of(&made.body));
            let part = made.map(|shell| match marched {
                true => Part::Marched(Box::new(shell)),
                false => {
                    let shell = StaticShell::new(shell);
                    surface.iter_mut().for_each(|surface| surface.find_unknowns(&shell));
                    Part::Balanced(Box::new(shell))
                }
            });
            (part, side, own)
        }
        BodyScene::Solid(solid) => match solid.galerkin() {
            Some(options) => {
                let made = galerkin_made(scene, solid, options, threads)?;
                let side = of_galerkin(scene, solid, &made.body);
                let own = glued.map(|()| Faces::of_galerkin(solid, &made.body, made.description.spacing));
                (made.map(|solid| Part::Balanced(Box::new(solid))), side, own)
            }
            None => {
                let made = solid_made(scene, solid, threads, false)?;
                let side = of_bonds(scene, solid, &made.body);
                let own = glued.map(|()| Faces::of_bonds(solid, &made.body));
                let part = made.map(|solid| match marched {
                    true => Part::Marched(Box::new(solid)),
                    false => Part::Balanced(Box::new(StaticSolid::new(solid))),
                });
                (part, side, own)
            }
        },
        BodyScene::Rigid(rigid) => {
            let made = rigid_made(scene, rigid, None)?;
            let side = of_rigid(scene, &made.body, made.description.spacing);
            let own = glued.map(|()| Faces::of_rigid(&made.body));
            let part = made.map(|body| match marched {
                true => Part::Marched(Box::new(body)),
                false => Part::Balanced(Box::new(RestingBody::new(body))),
            });
            (part, side, own)
        }
        BodyScene::Fluid(_) | BodyScene::Walls(_) => return Err(not_a(scene, "shell")),
    };
    Ok(Surfaced { part, side, own, surface })
}

/// The columns in the order of the scene; `own` are those of each body.
fn probes(scene: &Scene, layout: &Layout, own: Vec<Vec<Probe>>) -> Result<Vec<Probe>, SceneError> {
    let mut own: Vec<_> = own.into_iter().map(Vec::into_iter).collect();
    let mut all = Vec::new();
    for (i, column) in scene.curve.iter().enumerate() {
        let Owner::Of(body, _) = Owner::of(scene, &format!("curve[{i}].on"), &column.on)? else { continue };
        let Some(number) = layout.names.iter().position(|name| name == body) else { continue };
        let Some(mut probe) = own[number].next() else { continue };
        let ranges = if probe.sampled.is_some() { &layout.points } else { &layout.particles };
        let first = ranges[number].start as u32;
        probe.particles.iter_mut().for_each(|particle| *particle += first);
        all.push(probe);
    }
    Ok(all)
}
