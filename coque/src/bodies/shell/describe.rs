//! What a shell models and what it leaves out, for summaries.

use std::collections::BTreeMap;

use mesh_io::surface::side;
use sph_shell::Shell;

use super::bars::described_stiffener;
use super::imported::Provenance;
use crate::bodies::{Description, LoadResultants, Resultant, TangentCost};
use crate::scene::body_in_scene::ShellInScene;
use crate::scene::{
    Analysis, Axis, Formulation, Layered, LoadKind, Material, Ply, Reach, Section, ToolScene,
};

/// Steps in whose time a tangent of cells is assembled and factorised: so many, and so many times the root of the number
/// of degrees of freedom n (a step takes a time that grows as n, a factor on a surface as n^1.5). Measured on lattices of
/// 528 to 32 238 degrees of freedom: 80 to 130 steps.
const STEPS: [f64; 2] = [60.0, 0.5];

/// What the shell of a scene is.
pub(crate) fn describe(
    scene: &ShellInScene<'_>,
    shell: &Shell,
    surface: Option<&Provenance>,
    parts: Vec<String>,
) -> Description {
    let (mut modelled, left_out) = lists(scene, surface, parts);
    modelled.extend(touched(&scene.shell.tools, shell));
    modelled.extend(shell.own_contact_stiffness().map(|stiffness| {
        let friction = match shell.own_friction_coefficient() {
            0.0 => "without friction".into(),
            friction => format!("with friction {friction}"),
        };
        format!("contact with itself, {friction}, {stiffness:.3e} an area and depth")
    }));
    let dof = shell.dof();
    Description {
        kind: "shell",
        method: scene.shell.formulation.describe(),
        particles: shell.len(),
        points: shell.reference().operator.points.len(),
        dof,
        spacing: shell.reference().cloud.spacing(),
        bytes_per_particle: shell.bytes_per_particle(),
        rotary_inertia_over_true: scene
            .analysis
            .moves_in_time()
            .then(|| shell.turning_inertia().map(|found| found.whole))
            .flatten(),
        bodies: BTreeMap::new(),
        modelled,
        left_out,
        resultants: scene.loads.iter().any(|load| !load.heats()).then(|| resultants(scene, shell)),
        tangent: match &scene.shell.formulation {
            Formulation::StrongForm(_) => TangentCost::Without,
            Formulation::StressPoint(f) if f.support == Reach::Cell => {
                TangentCost::Steps(STEPS[0] + STEPS[1] * (dof as f64).sqrt())
            }
            // Tangents of wide stencils are dearer.
            _ => TangentCost::Expensive,
        },
    }
}

/// What each load of the scene amounts to.
fn resultants(scene: &ShellInScene<'_>, shell: &Shell) -> LoadResultants {
    let about = shell.centroid();
    let named = scene.loads.iter().filter(|load| !load.heats()).flat_map(|load| {
        load.kinds()
            .into_iter()
            .map(move |(word, kind)| line(&describe_load(word, &kind), load.on, load.preload))
    });
    let reduced = shell.load_resultants(about).into_iter();
    let loads = reduced.map(|found| Resultant { force: found.force.into(), moment: found.moment.into() });
    LoadResultants {
        about: about.into(),
        normals: side(&shell.reference().cloud),
        loads: named.zip(loads).collect(),
    }
}

/// Lines of what is modelled, and of what is not.
fn lists(
    scene: &ShellInScene<'_>,
    surface: Option<&Provenance>,
    parts: Vec<String>,
) -> (Vec<String>, Vec<String>) {
    let mut modelled = vec![
        format!("one director a particle, finite rotations, {}", scene.shell.formulation.describe()),
        match scene.shell.curvature() {
            "logarithmic" => "strains: logarithmic membrane, curvature per present length, shear".into(),
            curvature => format!("strains: Green-Lagrange membrane, {curvature} curvature, shear"),
        },
    ];
    modelled.extend(surface.map(|surface| surface.line.clone()));
    let is_heat = matches!(scene.analysis, Analysis::Heat(_));
    if !scene.scene.heat.is_empty() {
        let how = if scene.analysis.kind().passes_time && is_heat { "in time" } else { "in balance" };
        modelled
            .push(format!("heat conducted along the surface, one temperature through the thickness, {how}"));
    }
    let mut left_out: Vec<String> = match scene.shell.material {
        _ if scene.shell.yields() => vec!["fracture".into()],
        Material::Rubber(_) => ["plasticity", "fracture"].map(String::from).into(),
        _ => ["plasticity", "fracture", "change of thickness"].map(String::from).into(),
    };
    if scene.scene.contact.is_empty() {
        let contact = if scene.shell.tools.is_empty() { "contact" } else { "contact with itself" };
        left_out.insert(1, contact.into());
    }
    match &scene.shell.section {
        Section::Homogeneous(section) if scene.shell.material.yields() => {
            modelled.push(format!(
                "elasticity that yields by von Mises, {} slices through the thickness",
                section.slices()
            ));
            modelled.push("thickness that follows plastic flow".into());
        }
        Section::Homogeneous(_) if matches!(scene.shell.material, Material::Rubber(_)) => {
            modelled.push(
                "incompressible rubber, three Gauss points through the thickness, which follows the stretch"
                    .into(),
            );
        }
        Section::Homogeneous(section) => modelled.push(match section.gauss_points {
            None => "isotropic elasticity, integrated through the thickness in closed form".into(),
            Some(points) => format!("isotropic elasticity, {points} Gauss points through the thickness"),
        }),
        Section::File(_) => modelled.push("isotropic elasticity, sections of the file in closed form".into()),
        Section::Stiffness(section) => {
            let [x, y, z] = section.axis;
            let coupled = section.coupling.map_or("", |_| ", the membrane coupled with bending");
            modelled.push(format!("elasticity of given stiffness from [{x}, {y}, {z}]{coupled}"));
        }
        Section::Layered(section) => {
            modelled.push(describe_plies(section, &scene.shell.material));
            if scene.shell.yields_itself() {
                modelled.push("thickness that follows plastic flow".into());
            }
            let missing = ["delamination", "change of transverse shear strain from ply to ply"];
            left_out.extend(missing.map(String::from));
        }
    }
    if (0..scene.shell.parts.len()).any(|part| scene.shell.in_part(part).rated().is_some())
        || scene.shell.rated().is_some()
    {
        modelled.push("a yield stress that grows with the rate of plastic strain".into());
    }
    modelled.extend(parts);
    modelled
        .extend(scene.shell.masses.iter().map(|lumped| format!("mass of {} on {}", lumped.mass, lumped.on)));
    modelled.extend(scene.shell.ties.iter().map(|tie| format!("{} tied to {}", tie.edge, tie.to)));
    modelled.extend(scene.shell.stiffeners.iter().map(|bar| described_stiffener(bar, scene.shell)));
    if scene.shell.stiffeners.iter().any(|bar| bar.in_surface.is_none()) {
        left_out.push("bending of stiffeners in the surface".into());
    }
    if !scene.shell.stiffeners.is_empty() {
        left_out.push("inertia of the heights of stiffeners beside rotary inertia".into());
    }
    modelled.extend(scene.shell.rigid.iter().map(|body| match body.mass.get() > 0.0 {
        true => format!("{} rigid, with a mass of {}", body.on, body.mass),
        false => format!("{} rigid", body.on),
    }));
    let course = match () {
        () if scene.stress_drives() => "counted by the level",
        () if scene.analysis.kind().passes_time => "let go at the start",
        () => "balanced before the analysis",
    };
    let stresses = &scene.shell.initial_stress;
    modelled.extend(stresses.iter().map(|stress| format!("initial stress of {}, {course}", stress.on)));
    for support in &scene.supports {
        modelled.extend(support.kinds().iter().map(|(word, _)| line(word, support.on, support.preload)));
    }
    for load in &scene.loads {
        let kinds = load.kinds();
        modelled
            .extend(kinds.iter().map(|(word, kind)| line(&describe_load(word, kind), load.on, load.preload)));
    }
    modelled.extend(scene.shell.imperfection.map(|_| "deflection of the unstrained body".into()));
    modelled.extend(scene.shell.velocity.as_ref().map(|velocity| match &velocity.on {
        Some(on) => format!("velocity of {on} at the start"),
        None => "velocity at the start".into(),
    }));
    if scene.loads.is_empty() {
        left_out.push("loads".into());
    }
    if scene.output.fields.is_some_and(|fields| fields.stresses) {
        if scene.analysis.kind().gives_modes {
            left_out.push("stresses of modes, which have a shape but no size".into());
        } else if scene.analysis.is_shaken_by_bases() {
            left_out.push("stresses in the fields, made of several resultants: columns have them".into());
        } else if matches!(scene.analysis, Analysis::Harmonic(_)) {
            left_out.push("stresses in the frames of peaks: columns have them".into());
        } else if !scene.shell.section.homogeneous() && !scene.output.fields.is_some_and(|own| own.plies) {
            let of = match scene.shell.section {
                Section::Layered(_) => "stresses of the plies",
                _ => "stresses",
            };
            left_out.push(format!("{of}: the fields hold resultants"));
        }
    }
    (modelled, left_out)
}

/// Angles from the lowest ply to the highest, and the thickness of each where they differ; materials where there are several, or one yields.
fn describe_plies(section: &Layered, shell: &Material) -> String {
    let list = |of: &dyn Fn(&Ply) -> String| section.plies.iter().map(of).collect::<Vec<_>>();
    let angles = list(&|ply| ply.angle.to_string()).join("/");
    let mut thicknesses = list(&|ply| ply.thickness.to_string());
    thicknesses.dedup();
    let of = |ply: &Ply| match ply.material(shell) {
        Material::Plastic(_) => format!("plastic in {} slices", ply.slices()),
        other => other.word().into(),
    };
    let materials = match shell {
        Material::Orthotropic(_) if !section.mixed() => "orthotropic elasticity".into(),
        _ => list(&of).join("/"),
    };
    let shear = match section.mixed() {
        false => "as 5/6 of the sum over the plies",
        true => "by the energy of the shear stress of bending",
    };
    let [x, y, z] = section.axis;
    format!(
        "{materials}, plies at {angles} degrees from [{x}, {y}, {z}], thickness {}: classical lamination, transverse shear {shear}",
        thicknesses.join("/")
    )
}

/// A condition, on which set, and whether it belongs to the preload.
fn line(what: &str, on: &str, preload: bool) -> String {
    format!("{what} on {on}{}", if preload { ", applied before the analysis" } else { "" })
}

fn describe_load(word: &str, kind: &LoadKind) -> String {
    match kind {
        LoadKind::Couple(couple) if couple.axis == Axis::Edge => "couple about the moving edge".into(),
        LoadKind::Pressure(pressure) if pressure.follower => "follower pressure".into(),
        LoadKind::Gas(_) => "enclosed gas".into(),
        LoadKind::Volume(_) => "enclosed liquid".into(),
        LoadKind::Temperature(_) => "change of temperature".into(),
        _ => word.into(),
    }
}

/// What is modelled of the tools of a shell, a line each.
fn touched(tools: &[ToolScene], shell: &Shell) -> Vec<String> {
    let line = |(tool, stiffness): (&ToolScene, f64)| {
        let shape = tool.given().first().copied().unwrap_or_default();
        let moves = if tool.is_driven() { ", which moves" } else { "" };
        let friction = match tool.friction.filter(|_| tool.is_rough()) {
            Some(friction) => format!("with friction {}", friction.get()),
            None => "without friction".into(),
        };
        format!(
            "contact with the {shape} `{}`{moves}, {friction}, {stiffness:.3e} an area and depth",
            tool.name
        )
    };
    tools.iter().zip(shell.tool_stiffness()).map(line).collect()
}
