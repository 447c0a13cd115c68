//! Cells that sag towards round tools.

use sph_core::{Cell, Vec3};

use super::look::Look;
use crate::scene::ToolScene;

/// Sag of a cell over half of the thickness from which it is reported.
const SAG: f64 = 0.1;

/// Between particles on a tool of radius R a cell of length h sags by h²/8R towards it: its middle is pressed, its corners stand off.
pub(super) fn coarse(look: &Look<'_>) -> Option<String> {
    let half = 0.5 * look.thickness;
    let tools = &look.scene?.shell.tools;
    let sags = tools.iter().filter_map(|tool| {
        let (radius, axis) = round(tool)?;
        let axis = axis.map(|axis| look.turn * axis);
        let square = mean_square(look, axis.as_ref());
        Some((tool, radius, square, square / (8.0 * radius)))
    });
    let (tool, radius, square, sag) = sags.max_by(|a, b| a.3.total_cmp(&b.3))?;
    let most = (8.0 * radius * SAG * half).sqrt();
    (sag > SAG * half).then(|| {
        format!(
            "cells {:.4} long sag by h²/8R = {sag:.4e} towards the tool `{}` of radius {radius}, which is {:.2} of the half thickness \
             ({SAG} is much): where they lie on it their middles are pressed and their corners stand off, and held edges bear the \
             difference; take cells of {most:.4} or less there",
            square.sqrt(),
            tool.name,
            sag / half
        )
    })
}

/// Radius of a round tool, and the direction along which it is straight.
fn round(tool: &ToolScene) -> Option<(f64, Option<Vec3>)> {
    let sphere = tool.sphere.map(|sphere| (sphere.radius.get(), None));
    let cylinder = tool.cylinder.map(|drum| (drum.radius.get(), Vec3::from(drum.axis).try_normalize(0.0)));
    let capsule = tool.capsule.map(|capsule| {
        let [a, b] = capsule.ends.map(Vec3::from);
        (capsule.radius.get(), (b - a).try_normalize(0.0))
    });
    sphere.or(cylinder).or(capsule)
}

/// Mean over the area of the square of the longest side of a cell, without what lies along an axis \[L²\].
fn mean_square(look: &Look<'_>, axis: Option<&Vec3>) -> f64 {
    let positions = &look.shell.reference().cloud.positions;
    let longest = |cell: &Cell| {
        let own = cell.particles();
        let side = |i: usize| {
            let way = positions[own[(i + 1) % own.len()] as usize] - positions[own[i] as usize];
            axis.map_or(way, |axis| way - axis * axis.dot(&way)).norm_squared()
        };
        (0..own.len()).map(side).fold(0.0, f64::max)
    };
    let cells = &look.shell.reference().cloud.cells;
    let weighted = cells.iter().zip(&look.sheet.areas).map(|(cell, area)| longest(cell) * area);
    weighted.sum::<f64>() / look.sheet.areas.iter().sum::<f64>().max(f64::MIN_POSITIVE)
}
