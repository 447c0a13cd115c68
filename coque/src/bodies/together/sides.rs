//! The surface of a body as others touch it: of a shell its cells, of a solid of bonds its nodes, of a Galerkin solid what lies just inside its faces.

use std::collections::BTreeMap;

use contact::Mesh;
use peridynamics::Solid;
use rigid_body::RigidBody;
use sph_core::Vec3;
use sph_shell::Shell;

use super::contact::Side;
use super::rows::Rows;
use super::skin::Between;
use crate::bodies::body::Body;
use crate::bodies::galerkin::solid::GalerkinSolid;
use crate::bodies::refusal::model_error;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{BodyScene, Scene, SolidMaterial, SolidScene};

/// Depth of the surface of a Galerkin solid below its faces, over the least edge of its cells there: so thin that what it leaves out of the
/// strained body, whose place the stiffness of contact takes, does not show, and a depth that Newton's method can find.
const BELOW: f64 = 0.1;

/// The contact that names a body first, by number.
fn named(scene: &Scene, name: &str) -> Option<usize> {
    let names = |number: &usize| {
        let other = scene.contact[*number].other(name).and_then(|other| scene.bodies.get(other));
        // Walls are tools of a shell.
        other.is_some_and(|other| !matches!(other, BodyScene::Walls(_)))
    };
    (0..scene.contact.len()).find(names)
}

/// Nothing of a body that no contact names and that has no tools.
fn touches(scene: &BodyInScene<'_>) -> Option<()> {
    let tools = !scene.body.tools().is_empty();
    (tools || named(scene.scene, scene.name).is_some()).then_some(())
}

/// The surface of a shell; none of one that no contact names.
///
/// # Errors
/// [`SceneError`] for a shell without cells, with sections off its particles or with thicknesses that differ.
pub(in crate::bodies) fn of_shell(
    scene: &BodyInScene<'_>,
    shell: &Shell,
) -> Result<Option<Side>, SceneError> {
    let Some(number) = named(scene.scene, scene.name) else { return Ok(None) };
    let path = format!("contact[{number}].between");
    let refused = |error: sph_shell::ShellError| model_error(scene.source, &path, &error.to_string());
    let (mesh, thickness, stiffness) = shell.surface_touched().map_err(refused)?;
    let cloud = &shell.reference().cloud;
    let (spacing, rest) = (cloud.spacing(), cloud.positions.clone());
    Ok(Some(Side {
        name: scene.name.into(),
        body: 0,
        mesh,
        thickness,
        stiffness,
        spacing,
        rest,
        inside: None,
        rows: None,
    }))
}

/// All nodes of a solid of bonds as balls of half the least spacing: the outermost lie so far inside the faces, and a fragment keeps its own. The
/// area of each is its volume over its diameter. Between the face and the outermost nodes lies half a spacing of material without a bond of its own,
/// whose place the stiffness of contact takes: `κ = E/(h/2)`. A softer one spreads the pressure of a contact a few spacings wide.
pub(in crate::bodies) fn of_bonds(scene: &BodyInScene<'_>, body: &SolidScene, solid: &Solid) -> Option<Side> {
    touches(scene)?;
    let block = solid.block();
    let spacing = block.spacing.iter().copied().fold(f64::INFINITY, f64::min);
    let points: Vec<(u32, f64)> = (0..).zip(block.volumes.iter().map(|volume| volume / spacing)).collect();
    Some(Side {
        name: scene.name.into(),
        body: 0,
        mesh: Mesh::points(&points, 0.5 * spacing),
        thickness: spacing,
        stiffness: 2.0 * young(body) / spacing,
        spacing,
        rest: block.positions.clone(),
        inside: None,
        rows: Some(Rows::of_lattice(&block.positions, block.spacing, body.formulation.horizon())),
    })
}

/// The faces of a Galerkin solid, moved inward by a tenth of the least edge that leads in from them: places between a node of a face and the next
/// ones behind it. What is left out is as stiff as the contact of its thickness, `κ = E/r`. A node on an edge of the body stands for its part of
/// one side, the greatest: a body presses on one at a time.
pub(super) fn of_galerkin(scene: &BodyInScene<'_>, body: &SolidScene, solid: &GalerkinSolid) -> Option<Side> {
    touches(scene)?;
    let (nodes, cells) = (solid.galerkin().rest(), solid.configuration().cells);
    let behind = behind(solid.hexahedra(), nodes);
    let length = |a: u32, b: u32| (nodes[a as usize] - nodes[b as usize]).norm();
    let edges = behind.iter().flat_map(|(&a, next)| next.keys().map(move |&b| length(a, b)));
    let spacing = edges.fold(f64::INFINITY, f64::min);
    let depth = BELOW * spacing;
    let mut inside: Vec<Between> = vec![Vec::new(); nodes.len()];
    let (mut rest, mut areas) = (nodes.to_vec(), vec![0.0; nodes.len()]);
    for (&a, next) in &behind {
        let own: Between = next.keys().map(|&b| (b, depth / length(a, b))).collect();
        let left = 1.0 - own.iter().map(|(_, weight)| weight).sum::<f64>();
        let all = std::iter::once((a, left)).chain(own);
        inside[a as usize] = all.collect();
        rest[a as usize] = inside[a as usize].iter().map(|&(b, weight)| nodes[b as usize] * weight).sum();
        areas[a as usize] = next.values().copied().fold(0.0, f64::max);
    }
    Some(Side {
        name: scene.name.into(),
        body: 0,
        mesh: Mesh::new(cells, nodes, |_| depth).with_areas(|a| areas[a as usize]),
        thickness: 2.0 * depth,
        stiffness: young(body) / depth,
        spacing,
        rest,
        inside: Some(inside),
        rows: body.galerkin().map(|options| Rows::of_faces(cells, options.narrowest())),
    })
}

/// The surface of a rigid body, of no thickness: it gives way nowhere, and the stiffness of contact is that of the other body alone.
pub(in crate::bodies) fn of_rigid(scene: &BodyInScene<'_>, body: &RigidBody, spacing: f64) -> Option<Side> {
    touches(scene)?;
    Some(Side {
        name: scene.name.into(),
        body: 0,
        mesh: Mesh::new(body.cells(), body.rest(), |_| 0.0),
        thickness: 0.0,
        stiffness: f64::INFINITY,
        spacing,
        rest: body.rest().to_vec(),
        inside: None,
        rows: None,
    })
}

/// Young's modulus \[F/L²\], of an orthotropic solid the least.
pub(super) fn young(body: &SolidScene) -> f64 {
    match &body.material {
        SolidMaterial::Elastic(elastic) => elastic.young.get(),
        SolidMaterial::Plastic(plastic) => plastic.young.get(),
        SolidMaterial::Orthotropic(own) => {
            own.young.iter().map(|young| young.get()).fold(f64::INFINITY, f64::min)
        }
    }
}

/// Faces of a hexahedron by its corners, and the corner behind each.
const FACES: [([usize; 4], [usize; 4]); 6] = [
    ([0, 1, 2, 3], [4, 5, 6, 7]),
    ([4, 5, 6, 7], [0, 1, 2, 3]),
    ([0, 1, 5, 4], [3, 2, 6, 7]),
    ([3, 2, 6, 7], [0, 1, 5, 4]),
    ([0, 3, 7, 4], [1, 2, 6, 5]),
    ([1, 2, 6, 5], [0, 3, 7, 4]),
];

/// Of each node on the outside, those to which edges lead in from the faces at it, with its part of the area of the faces from which they do \[L²\]:
/// thirds of four triangles about the middle of each.
fn behind(cells: &[[u32; 8]], nodes: &[Vec3]) -> BTreeMap<u32, BTreeMap<u32, f64>> {
    let face = |cell: &[u32; 8], corners: &[usize; 4]| {
        let mut nodes = corners.map(|corner| cell[corner]);
        nodes.sort_unstable();
        nodes
    };
    let mut count: BTreeMap<[u32; 4], u8> = BTreeMap::new();
    for cell in cells {
        FACES.iter().for_each(|(corners, _)| *count.entry(face(cell, corners)).or_default() += 1);
    }
    let mut all: BTreeMap<u32, BTreeMap<u32, f64>> = BTreeMap::new();
    for cell in cells {
        for (corners, next) in FACES.iter().filter(|(corners, _)| count[&face(cell, corners)] == 1) {
            let at = |i: usize| nodes[cell[corners[i % 4]] as usize];
            let middle = (at(0) + at(1) + at(2) + at(3)) / 4.0;
            let third = |i: usize| (at(i) - middle).cross(&(at(i + 1) - middle)).norm() / 6.0;
            for (i, (&a, &b)) in corners.iter().zip(next).enumerate() {
                let part = third(i) + third(i + 3);
                *all.entry(cell[a]).or_default().entry(cell[b]).or_default() += part;
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use sph_core::Vec3;

    use super::behind;

    /// Two cubes in a row along the first axis: x, then y, then z fastest.
    #[test]
    fn edges_lead_in_from_every_face_at_a_node() {
        let cell = |i: u32| {
            let at = |a: u32, b: u32, c: u32| 4 * (i + a) + 2 * b + c;
            let ring = |c| [at(0, 0, c), at(1, 0, c), at(1, 1, c), at(0, 1, c)];
            let ([a, b, c, d], [e, f, g, h]) = (ring(0), ring(1));
            [a, b, c, d, e, f, g, h]
        };
        let nodes: Vec<Vec3> = (0..12_u32)
            .map(|a| Vec3::new(f64::from(a / 4), f64::from(a / 2 % 2), f64::from(a % 2)))
            .collect();
        let behind = behind(&[cell(0), cell(1)], &nodes);
        let of = |node: u32| behind[&node].keys().copied().collect::<Vec<_>>();
        // A corner: along x, y and z. A node between both cubes: not along x.
        assert_eq!((of(0), of(4)), (vec![1, 2, 4], vec![5, 6]));
        assert_eq!(behind.len(), 12);
        // A sixth of the one face at the corner on each side, two where both cubes have one.
        assert!(behind[&0].values().all(|area| (area - 1.0 / 6.0).abs() < 1e-15));
        assert!(behind[&4].values().all(|area| (area - 1.0 / 3.0).abs() < 1e-15));
    }
}
