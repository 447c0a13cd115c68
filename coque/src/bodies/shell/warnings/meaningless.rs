//! Rules about scenes that make no sense: loads on what is held, sets far from the body, bodies that are no shells.

use sph_core::Vec3;

use super::folded::overlaps;
use super::look::Look;
use super::plural;
use crate::scene::Material;
use crate::scene::body_in_scene::{OnSet, ShellInScene};

/// Part of a load that acts on free degrees of freedom below which it does no work: round-off of the directions that supports hold.
const NO_WORK: f64 = 1e-9;
/// Part of a load on free degrees of freedom below which most of it is lost in supports.
const MOSTLY_HELD: f64 = 0.5;
/// Spacings from the point of a `nearest` to the particle it finds beyond which another place was meant: within the mesh
/// the particle is at most one cell away.
const FAR: f64 = 3.0;

/// A load without work: on degrees of freedom that are held, along the director, or of size zero.
pub(super) fn no_work(look: &Look<'_>) -> Option<String> {
    let shares: Vec<_> = look.loads.iter().map(|load| load.free).collect();
    let idle = shares.iter().filter(|share| share.is_none_or(|share| share < NO_WORK)).count();
    (idle > 0).then(|| {
        let first = shares.iter().position(|share| share.is_none_or(|share| share < NO_WORK)).unwrap_or(0);
        let why = match shares[first] {
            None => "it is zero",
            Some(_) => "every freedom it acts on is held by a support",
        };
        format!(
            "{} does no work (the first: {why}); put it on particles that can move along it",
            of_loads(look, first, idle)
        )
    })
}

/// A load of which the greater part falls on degrees of freedom that are held.
pub(super) fn held_load(look: &Look<'_>) -> Option<String> {
    let shares: Vec<_> = look.loads.iter().map(|load| load.free).collect();
    let held = |share: &Option<f64>| share.is_some_and(|s| (NO_WORK..MOSTLY_HELD).contains(&s));
    let first = shares.iter().position(held)?;
    let part = 100.0 * (1.0 - shares[first].unwrap_or(0.0));
    let count = shares.iter().filter(|share| held(share)).count();
    Some(format!(
        "{part:.0} % of {} falls on degrees of freedom that a support holds and does no work; more than {:.0} % is a mistake more \
         often than not: put the load on particles that can move along it",
        of_loads(look, first, count),
        100.0 * MOSTLY_HELD
    ))
}

/// Names a load of the scene by its key, or by its number where there is no scene.
fn of_loads(look: &Look<'_>, first: usize, count: usize) -> String {
    let kinds = |scene: &ShellInScene<'_>| -> Vec<String> {
        let named = |load: &OnSet<'_, crate::scene::Load>| {
            let (path, on) = (&load.path, load.on);
            load.kinds().iter().map(|(word, _)| format!("`{path}.{word}` on {on}")).collect::<Vec<_>>()
        };
        scene.loads.iter().filter(|load| !load.heats()).flat_map(named).collect()
    };
    let name = look.scene.and_then(|scene| kinds(scene).into_iter().nth(first));
    let name = name.unwrap_or_else(|| format!("load {}", first + 1));
    if count > 1 { format!("{name}, one of {count} such loads,") } else { name }
}

/// A `nearest` whose point is far from every particle.
pub(super) fn far_nearest(look: &Look<'_>) -> Option<String> {
    let scene = look.scene?;
    let cloud = &look.shell.reference().cloud;
    let bound = FAR * look.spacing + look.thickness;
    let far = |region: &crate::scene::Region| {
        let point = look.turn * Vec3::from(region.nearest?) - look.shell.reference().origin;
        let least = cloud.positions.iter().map(|x| (x - point).norm_squared()).reduce(f64::min)?.sqrt();
        (least > bound).then_some(least)
    };
    let all = scene.sets.iter().filter_map(|(name, region)| Some((name, far(region)?)));
    let (name, distance) = all.max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(format!(
        "`sets.{name}`: the nearest particle is {:.1} spacings away from its point (spacing {:.3e}; beyond {FAR} another \
         place was meant): move the point onto the shell",
        distance / look.spacing,
        look.spacing
    ))
}

/// Thicker than half its width, or than its radius of curvature: no shell.
///
/// Without Poisson's ratio a strip bends as a beam of any width, and its width is not asked for.
pub(super) fn too_thick(look: &Look<'_>) -> Option<String> {
    let t = look.thickness;
    let beam = look.scene.is_some_and(
        |scene| matches!(&scene.shell.material, Material::Elastic(material) if material.poisson == 0.0),
    );
    let extents = look.extents();
    // A strip between two mirrors is as wide as one likes, and one mirror doubles it.
    let mirrors = look.scene.map_or(0, |scene| mirrors(look, scene));
    let beam = beam || mirrors > 1;
    let (width, name) =
        if beam { (extents[1], "length") } else { (extents[0] * (1 + mirrors) as f64, "width") };
    if t > 0.5 * width {
        return Some(format!(
            "the thickness is {:.2} of the {name} ({t:.3e} of {width:.3e}); beyond half of it a mid-surface may no longer describe the body: \
             model it as a solid",
            t / width
        ));
    }
    let area: f64 = look.curved.iter().map(|point| point.area).sum();
    let thick: f64 =
        look.curved.iter().filter(|point| point.curvature * t > 1.0).map(|point| point.area).sum();
    (thick > 0.0).then(|| {
        let most = look.curved.iter().fold(0.0_f64, |most, point| most.max(point.curvature * t));
        format!(
            "the thickness is {most:.2} of the radius of curvature on {:.0} % of the surface; beyond 1 hardly anything is left \
             inside the bend, and beyond a tenth the strains of thin shells are off by percents: model it as a solid",
            100.0 * thick / area
        )
    })
}

/// Mirror planes across the shorter direction of a lattice: a slice of plane strain lies between two, or all of it in one.
fn mirrors(look: &Look<'_>, scene: &ShellInScene<'_>) -> usize {
    let Some(across) = look.across_the_lattice() else { return 0 };
    let planes = scene.supports.iter().filter_map(|support| Some((support.on, support.symmetry?)));
    let facing = planes.filter(|(_, plane)| {
        let normal = look.turn * Vec3::from(plane.normal).normalize();
        normal.dot(&across).abs() > 1.0 - 1e-6
    });
    facing.map(|(on, _)| if on == "all" { 2 } else { usize::from(!on.starts_with("centre")) }).sum()
}

/// Cells that lie on others.
pub(super) fn overlap(look: &Look<'_>) -> Option<String> {
    let positions = &look.shell.reference().cloud.positions;
    overlap_of(&overlaps(&look.sheet, positions, look.thickness))
}

/// What is said of cells that lie on others.
pub(crate) fn overlap_of(pairs: &[(usize, usize)]) -> Option<String> {
    let (first, second) = pairs.first()?;
    Some(format!(
        "{} of cells lie on each other (the first: {first} and {second}, middle within, closer than half a thickness or a \
         twentieth of a cell): the mesh is folded onto itself or laid twice; there is no contact in the model, each layer \
         bears alone",
        plural(pairs.len(), "pair")
    ))
}
