//! What is known to make a number of a solid wrong, looked for before it is run.

use std::collections::BTreeMap;

use peridynamics::Solid;
use sph_core::{BlockLattice, NodePlaces, Vec3};

use super::bending::stiffness;
use super::conditions::inward;
use super::ends::excess;
use super::places::Places;
use super::skin::Skin;
use crate::bodies::hot::hot;
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::sets::OF_SOLIDS;
use crate::scene::{Analysis, Correction, Load, Measured, SolidScene, Support};
use crate::warning::{Warning, WarningKind};

/// A rule: what is doubtful, and whether it is so.
type Rule = (WarningKind, fn(&Look<'_>) -> Option<String>);

/// Every rule, in the order in which warnings are printed.
const RULES: [Rule; 8] = [
    (WarningKind::OddHorizon, odd_horizon),
    (WarningKind::FlatCells, flat_cells),
    (WarningKind::FewLayers, few_layers),
    (WarningKind::ThinLayer, thin_layer),
    (WarningKind::LoadedFace, loaded_face),
    (WarningKind::SoftSkin, soft_skin),
    (WarningKind::SoftSkin, cool_skin),
    (WarningKind::ThinFins, thin_fins),
];

/// What the rules look at.
struct Look<'a> {
    scene: &'a BodyInScene<'a>,
    body: &'a SolidScene,
    solid: &'a Solid,
    lattice: &'a BlockLattice,
    sets: &'a BTreeMap<String, Vec<u32>>,
    skin: Option<&'a Skin>,
}

/// What is doubtful about the solid of a scene.
pub(super) fn warnings_of(
    scene: &BodyInScene<'_>,
    body: &SolidScene,
    solid: &Solid,
    (places, sets): (&Places, &BTreeMap<String, Vec<u32>>),
) -> Vec<Warning> {
    let look = Look { scene, body, solid, lattice: &places.lattice, sets, skin: places.skin.as_ref() };
    let of_rules = RULES.iter().filter_map(|(kind, rule)| Some(Warning::new(*kind, rule(&look)?)));
    of_rules.chain(hot(solid.greatest_free_strain())).collect()
}

/// Horizons over the spacing between which cracks run freely and waves arrive in time.
const USUAL: [f64; 2] = [2.5, 6.0];

/// Short horizons lead cracks along the lattice, long ones smear; sheets are best at 1.5.
fn odd_horizon(look: &Look<'_>) -> Option<String> {
    let horizon = look.body.formulation.horizon();
    let [low, high] = USUAL;
    (!look.body.has_directors() && look.body.fracture.is_some() && !(low..=high).contains(&horizon)).then(
        || {
            let fault =
                if horizon < low { "cracks follow the lattice" } else { "cracks and waves are smeared" };
            format!("the horizon is {horizon} spacings: {fault} outside {low} to {high}; 3.015 is usual")
        },
    )
}

/// Greatest over least spacing from which a family is a flat disc.
const FLAT: f64 = 1.5;

/// Families are measured in the greatest spacing, and see little across it where another is much narrower.
fn flat_cells(look: &Look<'_>) -> Option<String> {
    let spacing = &look.solid.block().spacing[..look.body.dimensions()];
    let [least, most] = [f64::min, f64::max].map(|pick| spacing.iter().copied().reduce(pick).unwrap_or(1.0));
    (most / least > FLAT).then(|| {
        format!(
            "spacings of {least:.3e} and {most:.3e} differ by a factor of {:.2}: beyond {FLAT} families are flat and their moduli \
             off; use one spacing along all axes",
            most / least
        )
    })
}

/// Part of the stiffness in bending that may be missing, or too much.
const BENDING: f64 = 0.05;
/// Part of what comes out that may be off by clamps, or by stiffness and clamps together.
const OFF: f64 = 0.02;
/// Length over thickness from which a member bends under a load across it.
const SLENDER: f64 = 4.0;

/// Loads and motions across a slender block bend it, and so do its modes of vibration and buckling.
fn few_layers(look: &Look<'_>) -> Option<String> {
    if look.body.has_directors() {
        return None;
    }
    let lattice = look.lattice;
    let (cells, lengths) = (lattice.cells().ok()?, &lattice.lengths[..lattice.dimensions]);
    let along = (0..lengths.len()).max_by(|&a, &b| lengths[a].total_cmp(&lengths[b]))?;
    let modes = matches!(look.scene.analysis, Analysis::Modal(_) | Analysis::Buckling(_));
    let slender = |&axis: &usize| {
        let bent = modes || bends(look, axis) || axis != along && turns(look, [along, axis]);
        axis != along && lengths[along] >= SLENDER * lengths[axis] && bent
    };
    let stiffness = |axis: usize| Some((axis, stiffness(look.body, lattice, [along, axis])?));
    let off = |&(_, stiffness): &(usize, f64)| (stiffness - 1.0).abs();
    let (axis, stiffness) =
        (0..lengths.len()).filter(slender).filter_map(stiffness).max_by(|a, b| off(a).total_cmp(&off(b)))?;
    let longer = behind_clamps(look, [along, axis]);
    // Deflections go by the cube of the length, of loads all over by its fourth power, frequencies and buckling loads by its square.
    let by_area = |load: &Load| load.traction.is_some() || load.pressure.is_some();
    let spread = look.scene.loads.iter().any(|load| by_area(load) || load.gravity.is_some());
    let power = if spread { 4.0 } else { 3.0 };
    let (what, factor, by_clamps) = match &look.scene.analysis {
        Analysis::Modal(_) => {
            ("frequencies of bending", stiffness.sqrt() * (1.0 - 2.0 * longer), 2.0 * longer)
        }
        Analysis::Buckling(_) => {
            ("buckling loads in bending", stiffness * (1.0 - 2.0 * longer), 2.0 * longer)
        }
        _ => ("deflections", (1.0 + power * longer) / stiffness, power * longer),
    };
    let balanced = match look.body.correction() {
        Correction::Balanced => "",
        _ => " nodes = \"edges\" with correction = \"balanced\",",
    };
    let clamps = match longer {
        0.0 => String::new(),
        _ => format!(
            ", and clamps on nodes at centres of cells hold it about a spacing behind their faces, as if it were {:.1} % longer",
            100.0 * longer
        ),
    };
    let little = (stiffness - 1.0).abs() <= BENDING;
    (!little || by_clamps > OFF || (factor - 1.0).abs() > OFF).then(|| {
        format!(
            "{} layers of nodes across a member that bends, along {}, at a horizon of {} spacings have about {:.2} of its \
             stiffness in bending{clamps}: {what} {} about {:+.0} % off; what is missing falls with the square of horizon over \
             thickness: use a narrower spacing or a shorter horizon,{balanced} or formulation.two-sheets for a thin plate",
            cells[axis],
            ["x", "y", "z"][axis],
            look.body.formulation.horizon(),
            stiffness,
            if little { "may come out" } else { "come out" },
            100.0 * (factor - 1.0)
        )
    })
}

/// By what part a member is longer between its clamps than it should be: where layers under its end faces are held along and across it, nodes at
/// centres of cells hold it about a spacing behind the face of the clamp, half of it their place and half what their bonds give way by. Gates of 5 and
/// 10 layers in plane strain are as soft as if it were .6 to 1.3 spacings.
fn behind_clamps(look: &Look<'_>, [along, across]: [usize; 2]) -> f64 {
    let lattice = look.lattice;
    if lattice.nodes != NodePlaces::Centres {
        return 0.0;
    }
    let holds = |support: &Support, axis: usize| {
        let held = support.held.iter().flat_map(|held| &held.displacement);
        support.clamped.is_some() || held.map(|v| Vec3::from(*v).normalize()).any(|v| v[axis].abs() > 0.5)
    };
    let held = look.scene.supports.iter().filter(|support| holds(support, along) && holds(support, across));
    let layers = held.filter_map(|support| look.scene.sets.get(support.on)?.layer.as_ref());
    let ends = [2 * along, 2 * along + 1].map(|face| OF_SOLIDS[1 + face]);
    let depths: Vec<f64> =
        layers.filter(|layer| ends.contains(&layer.face.as_str())).map(|layer| layer.depth.get()).collect();
    let free = lattice.lengths[along] - depths.iter().sum::<f64>();
    look.solid.block().spacing[along] * depths.len() as f64 / free
}

/// Whether loads or prescribed motions have a part along an axis.
///
/// The lattice of an arc is the straight block before it is bent: its thickness lies in the plane of x and z, and every load in that plane
/// bends it.
fn bends(look: &Look<'_>, axis: usize) -> bool {
    let (scene, arc) = (look.scene, look.body.geometry.arc.is_some());
    let loads = scene.loads.iter().flat_map(|load| {
        // A group of a file may look anywhere.
        let anywhere = look.body.geometry.filled.as_ref().map(|_| Vec3::repeat(1.0));
        let pressed = load.pressure.as_ref().and_then(|_| inward(load.on).or(anywhere));
        let others = [load.force.map(|f| f.total), load.traction.map(|t| t.value)];
        [others[0], others[1], load.gravity.map(|g| g.acceleration), pressed.map(Into::into)]
    });
    let motions = scene.supports.iter().map(|support| support.moved.map(|moved| moved.direction));
    let bends = |v: [f64; 3]| match (arc, axis) {
        (true, 0) => false,
        (true, 2) => across(v, 0) || across(v, 2),
        _ => across(v, axis),
    };
    loads.chain(motions).flatten().any(bends)
}

/// Whether a set that turns bends a member along an axis in the plane of it and another one.
fn turns(look: &Look<'_>, [along, across]: [usize; 2]) -> bool {
    let mut turned = look.scene.supports.iter().filter_map(|support| support.turned);
    turned.any(|turned| self::across(turned.axis, 3 - along - across))
}

/// What is thinner than half a spacing has no nodes of its own: its mass and its loads are on the body that it stands on, its stiffness nowhere.
fn thin_fins(look: &Look<'_>) -> Option<String> {
    look.skin?.thin_fins()
}

/// Whether a vector has more than a tenth of its length along an axis.
fn across(v: [f64; 3], axis: usize) -> bool {
    v[axis].abs() > 0.1 * Vec3::from(v).norm()
}

/// Part of the displacement of a loaded face that may be too much, or missing.
const FACE: f64 = 0.05;

/// A face that is pulled along its normal moves farther than its strain says where bonds are missing, and a column reads it.
fn loaded_face(look: &Look<'_>) -> Option<String> {
    if look.body.geometry.filled.is_some()
        && let Some(found) = loaded_surface(look)
    {
        return Some(found);
    }
    let (scene, lattice) = (look.scene, look.lattice);
    let pulled = |face: &str, axis: usize| {
        scene.loads.iter().filter(|load| load.on == face).any(|load| {
            let spread = load.traction.filter(|traction| traction.depth.is_none());
            let pressed = load.pressure.as_ref().and_then(|_| inward(load.on)).map(Into::into);
            let values =
                [load.force.map(|force| force.total), spread.map(|traction| traction.value), pressed];
            values.into_iter().flatten().any(|value| across(value, axis))
        })
    };
    let read = |face: &str| {
        scene.curve.iter().any(|column| column.on == face && matches!(column.of, Measured::Displacement))
    };
    let faces = OF_SOLIDS[1..].iter().enumerate().take(2 * lattice.dimensions);
    let mut found = faces.filter(|(number, face)| pulled(face, number / 2) && read(face)).peekable();
    found.peek()?;
    let excess = excess(look.body, lattice)?;
    found.find_map(|(number, face)| {
        let part = excess * look.solid.block().spacing[number / 2] / lattice.lengths[number / 2];
        (part.abs() > FACE).then(|| {
            format!(
                "the loaded face `{face}` moves by {excess:+.1} spacings times the strain behind it beyond what that strain makes of the \
                 body, {:+.0} % of the whole under a uniform stress: bonds are missing there; use nodes = \"edges\" with correction = \
                 \"balanced\", or read the displacement of a section a horizon inside",
                100.0 * part
            )
        })
    })
}

/// The same of a piece of the surface that a body fills, of whatever shape: a column reads nodes that a load by area acts on.
fn loaded_surface(look: &Look<'_>) -> Option<String> {
    let nodes = |name: &str| look.sets.get(name).map_or(&[][..], Vec::as_slice);
    let curved = |load: &&OnSet<'_, Load>| {
        !OF_SOLIDS.contains(&load.on)
            && (load.pressure.is_some() || load.traction.is_some_and(|traction| traction.depth.is_none()))
    };
    let read = |load: &&OnSet<'_, Load>| {
        look.scene.curve.iter().any(|column| {
            let own = nodes(column.on);
            matches!(column.of, Measured::Displacement)
                && !own.is_empty()
                && own.iter().all(|node| nodes(load.on).binary_search(node).is_ok())
        })
    };
    let load = look.scene.loads.iter().filter(curved).find(read)?;
    Some(format!(
        "nodes of the loaded face `{}` lack bonds and move too far, in the wall of a hollow ball 8 spacings thick by 10, 18, 42 % with horizons of 1.5, 2, \
         3 spacings: read the displacement of a section a horizon inside, or of the other face",
        load.on
    ))
}

/// Nodes near a face lack bonds; without a correction the skin through which a body is touched is soft.
fn soft_skin(look: &Look<'_>) -> Option<String> {
    let uncorrected = !look.body.has_directors() && look.body.correction() == Correction::None;
    let named = look.scene.scene.contact.iter().any(|contact| contact.is_of(look.scene.name));
    (uncorrected && (named || !look.body.tools.is_empty())).then(|| {
        "bonds without a correction are soft at the skin, through which the body is touched: forces, half widths and greatest pressures of drums on \
         blocks come out 10 to 27 % off; leave `correction` out, or use \"energy-factor\""
            .to_string()
    })
}

/// Bonds whose weights are not balanced conduct less into the nodes at faces.
fn cool_skin(look: &Look<'_>) -> Option<String> {
    let heats = matches!(look.scene.analysis, Analysis::Heat(_));
    if heats && look.body.geometry.filled.is_some() {
        let said = "nodes of what fills a surface lie up to half a spacing inside it: between two held surfaces the wall is so much thinner, and 5 spacings of a hollow ball pass \
                    28 % more heat; use a `film`, or a Galerkin solid";
        return Some(said.into());
    }
    (heats && look.body.correction() != Correction::Balanced).then(|| {
        "bonds whose weights are not balanced conduct less into the nodes at faces: a slab of 12 spacings between two of them passes 11 % less heat; use \
         correction = \"balanced\", with nodes on the edges of a block"
            .to_string()
    })
}

/// A motion that is prescribed on less than the depth of the horizon acts on part of each family only.
fn thin_layer(look: &Look<'_>) -> Option<String> {
    let motions = || look.scene.supports.iter().filter(|support| support.motion().is_some());
    if look.body.has_directors() || motions().next().is_none() {
        return None;
    }
    let block = look.solid.block();
    let horizon = look.body.formulation.horizon() * block.greatest_spacing();
    let extent = |places: &mut dyn Iterator<Item = f64>| {
        let (least, most) =
            places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        most - least
    };
    // Across which a layer reaches from face to face, the body has no more: that is its thickness, and no depth of the layer.
    let depth = |nodes: &[u32], axis: usize| {
        let whole = extent(&mut block.positions.iter().map(|x| x[axis]));
        let own = extent(&mut nodes.iter().map(|&node| block.positions[node as usize][axis]));
        let spacing = block.spacing[axis];
        (own < whole - 0.5 * spacing).then_some(own + spacing)
    };
    motions().find_map(|support| {
        let nodes = look.sets.get(support.on)?;
        let depth = (0..block.dimensions).filter_map(|axis| depth(nodes, axis)).fold(f64::INFINITY, f64::min);
        // A layer as deep as the horizon holds the nodes whose places lie in it.
        (depth < horizon - block.greatest_spacing() * (0.5 - 1e-6)).then(|| {
            format!(
                "the motion of `{}` is prescribed on a layer {depth:.3e} deep: below the horizon, {horizon:.3e}, bonds reach past it \
                 and the motion acts in part; use a set with layer = {{ face = \"…\", depth = {horizon:.3e} }}",
                support.on
            )
        })
    })
}
