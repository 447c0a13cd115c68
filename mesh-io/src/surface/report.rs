//! What a file holds, as text for people.

use std::fmt::Write;

use sph_core::Cloud;

use super::error::{number, place};
use super::raw::counted;
use super::{Format, MeshError, Quality, Surface, quality, side};

/// Sets that are listed one by one.
const LISTED: usize = 24;

/// Everything that was found in a file, with what `of_cloud` finds in its cloud among the warnings.
///
/// # Errors
/// [`MeshError`] for a surface that no cloud can be made of.
pub fn report(surface: &Surface, of_cloud: impl Fn(&Cloud) -> Vec<String>) -> Result<String, MeshError> {
    let (cloud, made) = surface.cloud(surface.node_normals())?;
    let figures = quality(surface);
    let mut out = format!("{}: {}\n", surface.file, surface.format.map_or("arrays", Format::name));
    let mut line = |key: &str, text: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "  {key:<10} {text}");
    };
    let triangles = surface.faces.iter().filter(|face| face.count == 3).count();
    let kinds: Vec<String> = [(triangles, "triangle"), (surface.faces.len() - triangles, "quadrangle")]
        .into_iter()
        .filter(|(n, _)| *n > 0)
        .map(|(n, what)| counted(n, what))
        .collect();
    line("nodes", surface.positions.len().to_string());
    line("faces", if surface.faces.is_empty() { "none: points only".into() } else { kinds.join(", ") });
    if !surface.faces.is_empty() {
        line("cells", made.to_string());
    }
    let corner = |pick: fn(f64, f64) -> f64| {
        surface.positions.iter().copied().reduce(|a, b| a.zip_map(&b, pick)).unwrap_or_default()
    };
    line("extents", format!("{} to {}", place(&corner(f64::min)), place(&corner(f64::max))));
    line("area", number(figures.area));
    let [least, mean, greatest] = figures.spacing;
    if mean > 0.0 {
        line("spacing", format!("mean {}, from {} to {}", number(mean), number(least), number(greatest)));
    } else {
        line("spacing", format!("mean {}", number(cloud.spacing())));
    }
    if !surface.faces.is_empty() {
        let turned = match surface.turned {
            0 => "all faces turned the same way".into(),
            turned => format!("{} turned round to agree with the others", counted(turned, "face")),
        };
        if !surface.joined.is_empty() {
            line("junctions", surface.tied());
        }
        line("pieces", format!("{}; {turned}", surface.pieces));
    }
    let normals = if surface.normals.is_some() { "from the file" } else { "means over the faces, by area" };
    line("normals", normals.into());
    line("side", side(&cloud));
    if let (Some(least), Some(greatest)) = (
        surface.thicknesses.iter().copied().reduce(f64::min),
        surface.thicknesses.iter().copied().reduce(f64::max),
    ) {
        line("thickness", format!("from {} to {}", number(least), number(greatest)));
    }
    if surface.loops.is_empty() && !surface.faces.is_empty() {
        line("boundary", "none: the surface is closed".into());
    }
    for (i, found) in surface.loops.iter().enumerate().take(LISTED) {
        line(
            &format!("boundary{i}"),
            format!("{}, length {}", counted(found.nodes.len(), "node"), number(found.length)),
        );
    }
    for (name, nodes) in surface.sets.iter().take(LISTED) {
        let faces = surface.face_sets.get(name);
        let faces = faces.map(|faces| format!(", {}", counted(faces.len(), "face")));
        line("set", format!("{name}: {}{}", counted(nodes.len(), "node"), faces.unwrap_or_default()));
    }
    for section in surface.sections.iter().take(LISTED) {
        let material = surface.materials.get(&section.material.to_lowercase());
        let elastic = material.and_then(|material| material.elastic);
        let elastic =
            elastic.map(|[young, poisson]| format!(" (E {}, ν {})", number(young), number(poisson)));
        line(
            "section",
            format!(
                "{}: {}, thickness {}, material {}{}",
                section.group,
                counted(section.faces.len(), "face"),
                number(section.thickness),
                section.material,
                elastic.unwrap_or_default()
            ),
        );
    }
    let more = surface.loops.len().saturating_sub(LISTED) + surface.sets.len().saturating_sub(LISTED);
    if more > 0 {
        line("", format!("and {more} more"));
    }
    if !surface.faces.is_empty() {
        let [sharpest, widest] = figures.angles.map(f64::to_degrees);
        line(
            "quality",
            format!(
                "corners from {sharpest:.1}° to {widest:.1}°, greatest aspect {}",
                number(figures.aspect)
            ),
        );
    }
    for note in &surface.notes {
        line("note", note.clone());
    }
    for warning in warnings(surface, &figures).into_iter().chain(of_cloud(&cloud)) {
        line("warning", warning);
    }
    Ok(out)
}

/// What makes answers worse or a run slower, with the bound it passes.
fn warnings(surface: &Surface, figures: &Quality) -> Vec<String> {
    let mut warnings = Vec::new();
    if figures.slivers > 0 {
        let what = "sharper than 15°: the stable step is that of the sharpest";
        warnings.push(format!("{} with a corner {what}", counted(figures.slivers, "face")));
    }
    if figures.hollow > 0 {
        let what = "with a corner beyond 180°, cut into two triangles each";
        warnings.push(format!("{} {what}", counted(figures.hollow, "quadrangle")));
    }
    if figures.aspect > 5.0 {
        warnings
            .push(format!("edges of one face differ {} times in length; 5 is much", number(figures.aspect)));
    }
    let [least, mean, _] = figures.spacing;
    if least > 0.0 && mean > 5.0 * least {
        let times = number(mean / least);
        warnings.push(format!(
            "the shortest edge is {times} times shorter than the mean: it sets the stable step"
        ));
    }
    if figures.warp > 0.2 {
        let degrees = figures.warp.to_degrees();
        warnings.push(format!("a quadrangle is warped by {degrees:.0}°: refine where the surface curves"));
    }
    if surface.pieces > 1 {
        warnings
            .push(format!("{} pieces that nothing joins: each needs supports of its own", surface.pieces));
    }
    warnings
}
