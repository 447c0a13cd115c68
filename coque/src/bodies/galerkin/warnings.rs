//! What is known to make a number of a Galerkin solid wrong.

use sph_core::{Block, Vec3};
use sr_galerkin::Galerkin as GalerkinBody;

use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::sets::OF_SOLIDS;
use crate::scene::{Analysis, Galerkin, GalerkinBasis, GalerkinEssential, Measured, Probe, Support};
use crate::warning::{Warning, WarningKind};

/// What is doubtful before anything is solved.
pub(super) fn warnings_of(
    scene: &BodyInScene<'_>,
    options: &Galerkin,
    lengths: [f64; 3],
    block: &Block,
) -> Vec<Warning> {
    if matches!(scene.analysis, Analysis::Heat(_)) {
        return Vec::new();
    }
    let all = [
        leaks(options),
        locks(options, lengths, block),
        cannot_turn(scene, lengths),
        few_cells(scene, lengths, block),
    ];
    all.into_iter().flatten().collect()
}

/// Part of a uniform stress that a node of cut cells may keep: whole cells leave .04, and nodes at which stresses are 10 % off and more all leave more
/// (docs/galerkin.md, "In a surface").
const UNEVEN: f64 = 0.1;
/// Part of the mass that may go to nodes without one of their own: 1.4 % lowers the first frequencies of a bar by 2 %.
const MOVED: f64 = 0.005;

/// Cells that a surface cuts so that stresses at its nodes, or frequencies, are some percent off.
pub(super) fn cut_cells(scene: &BodyInScene<'_>, body: &GalerkinBody) -> Option<Warning> {
    let message = if matches!(scene.analysis, Analysis::Modal(_)) {
        let moved = body.moved_mass();
        (moved > MOVED).then(|| {
            format!(
                "{:.1} % of the mass is moved to nodes for which the cut cells leave none: frequencies come out some percent low; use a narrower spacing, \
                 or one that divides the body",
                100.0 * moved
            )
        })
    } else {
        let uneven = body.uneven();
        (uneven > UNEVEN && reads_stresses(scene)).then(|| {
            format!(
                "cut cells leave {uneven:.2} of a uniform stress on a node at the surface (more than {UNEVEN}): the stress there may be off by as much, up to \
                 twice, displacements are not; use a narrower spacing, one that divides the body, or read stresses a spacing inside"
            )
        })
    };
    message.map(|message| Warning::new(WarningKind::UnevenCells, message))
}

/// Whether stresses at nodes leave the run.
fn reads_stresses(scene: &BodyInScene<'_>) -> bool {
    let column = |probe: &OnSet<'_, Probe>| matches!(probe.of, Measured::VonMises | Measured::Stress);
    scene.output.fields.is_some_and(|fields| fields.stresses || fields.principal)
        || scene.curve.iter().any(column)
}

/// Length over thickness from which a face at its end is to turn.
const SLENDER: f64 = 4.0;

/// A face at the end of a thin part that is held along its thickness and free along its normal turns by straining across. What that
/// takes grows with the square of the turn, as what the middle surface stretches by does: the part of the one in the other stays, 3.4 % of the
/// deflection of a plate between a half and two thicknesses (h/a = .01).
fn cannot_turn(scene: &BodyInScene<'_>, lengths: [f64; 3]) -> Option<Warning> {
    if !matches!(scene.analysis, Analysis::Static(_) | Analysis::ArcLength(_) | Analysis::Relaxation(_)) {
        return None;
    }
    let thin = (0..3).min_by(|&a, &b| lengths[a].total_cmp(&lengths[b]))?;
    let holds = |support: &Support, axis: usize| {
        let held = support.held.iter().flat_map(|held| held.displacement.iter().copied());
        let moved = support.moved.iter().map(|moved| moved.direction);
        let plane = support.symmetry.iter().map(|plane| plane.normal);
        let along = |v: [f64; 3]| Vec3::from(v).normalize()[axis].abs() > 0.5;
        support.clamped.is_some() || held.chain(moved).chain(plane).any(along)
    };
    let mut faces = OF_SOLIDS[1..].iter().enumerate();
    let (number, face) = faces.find(|(number, face)| {
        let on = || scene.supports.iter().filter(|support| support.on == **face);
        let normal = number / 2;
        let slender = normal != thin && lengths[normal] >= SLENDER * lengths[thin];
        slender && on().any(|s| holds(s, thin)) && !on().any(|s| holds(s, normal))
    })?;
    let [thin, normal] = [thin, number / 2].map(|axis| ["x", "y", "z"][axis]);
    let message = format!(
        "the face `{face}` is held along {thin}, its thickness, and free along {normal}: it cannot turn there without straining across, and \
         large deflections may come out some percent too small; hold the line of its middle alone"
    );
    Some(Warning::new(WarningKind::HeldFace, message))
}

/// Fixed parameters are no fixed displacements.
fn leaks(options: &Galerkin) -> Option<Warning> {
    let message = "supports fix nodal parameters, which are no displacements: a clamped cantilever bends 1 to 2 % more, immovable \
                   edges of a plate leak by tens of percent; use essential = \"collocation\"";
    (options.essential == GalerkinEssential::Direct).then(|| Warning::new(WarningKind::LeakySupport, message))
}

/// Spacings along a thin part over its thickness beyond which bases without cubic terms lock: simply supported plates are .1, 2
/// and 18 % stiff at 2, 5 and 10.
const COARSE: f64 = 3.0;

fn locks(options: &Galerkin, lengths: [f64; 3], block: &Block) -> Option<Warning> {
    if options.basis == GalerkinBasis::Plate17 {
        return None;
    }
    let thickness = lengths.iter().copied().fold(f64::INFINITY, f64::min);
    let along = block.spacing.iter().copied().fold(0.0, f64::max);
    (along > COARSE * thickness).then(|| {
        let message = format!(
            "nodes are {:.1} thicknesses apart along a thin part: beyond {COARSE} this basis locks in bending; use basis = \
             \"plate17\", or narrower spacings along the part",
            along / thickness
        );
        Warning::new(WarningKind::ShearLocking, message)
    })
}

/// Cells along the longest part of a body that bends up to which it is reported: a block as deep as long is 13 % stiff with two cells, one twice as long
/// 5 to 6 % with four, and Cook's panel 3 % with four, at ν = .499 8 %; with eight all are within 1.2 %.
const FEW: f64 = 4.5;

/// Few cells along a body that loads or motions across it bend; a plane of symmetry doubles them.
fn few_cells(scene: &BodyInScene<'_>, lengths: [f64; 3], block: &Block) -> Option<Warning> {
    let long = (0..3).max_by(|&a, &b| lengths[a].total_cmp(&lengths[b]))?;
    let across = |v: [f64; 3]| {
        let v = Vec3::from(v);
        (0..3).any(|axis| axis != long && v[axis].abs() > 0.1 * v.norm())
    };
    let forces = scene.loads.iter().flat_map(|load| {
        let spread = load.traction.map(|traction| traction.value);
        [load.force.map(|force| force.total), spread, load.gravity.map(|gravity| gravity.acceleration)]
    });
    let motions = scene.supports.iter().map(|support| support.moved.map(|moved| moved.direction));
    if !forces.chain(motions).flatten().any(across) {
        return None;
    }
    let ends = [2 * long, 2 * long + 1].map(|face| OF_SOLIDS[1 + face]);
    let mirrored = scene.supports.iter().any(|s| s.symmetry.is_some() && ends.contains(&s.on));
    let cells = lengths[long] / block.spacing[long] * if mirrored { 2.0 } else { 1.0 };
    (cells < FEW).then(|| {
        let message = format!(
            "{cells:.0} cells along {} of a body that is loaded across: what bends may come out some percent too stiff (3 to 8 % with four cells, \
             most where it is nearly incompressible), 1 % with eight; use a narrower spacing",
            ["x", "y", "z"][long]
        );
        Warning::new(WarningKind::FewParticles, message)
    })
}

/// Principal strain up to which the law of increments is meant.
const MEANT: f64 = 0.2;

/// Strains beyond those that the law was made for.
pub(super) fn large_strain(found: f64, yields: bool) -> Option<Warning> {
    (found > MEANT).then(|| {
        let repair = if yields {
            "where the axes of stretch turn in the material, which finer levels do not mend: read nothing that is sheared so far"
        } else {
            "the other law, law = \"st-venant\", tells how much that matters"
        };
        let message = format!(
            "a principal strain is {found:.2} in the last state: linear laws of increments are meant for less than {MEANT} and may be \
             off beyond; {repair}"
        );
        Warning::new(WarningKind::LargeStrain, message)
    })
}
