//! Closed fluids that walls compress.
//!
//! The equation of continuity sees walls with their own velocity: of fluid that comes nearer a wall it counts less than if the motion
//! went on into the wall as it does before it. Once pressures are equal again, a wall gives way as a layer of the fluid of .57 h would: measured
//! from 5 × 20 to 40 × 80 particles in a plane and 6 × 6 × 12 to 12³ in space (fluid-sph/tests/closed.rs, docs/fluids.md).

use fluid_sph::Fluid;
use sph_core::CellList;

use crate::bodies::fluid::walls::BuiltWalls;
use crate::warning::{Warning, WarningKind};

/// Thickness of the layer of fluid as which a wall gives way, in smoothing lengths.
const LAYER: f64 = 0.57;
/// Distance of the first row of a wall from the nearest particles of the fluid, in spacings, at most.
const NEXT: f64 = 1.2;
/// What may be missing of a pressure without a warning: other errors of pressures are as large.
const MISSING: f64 = 0.02;

/// The warning of a fluid without a free surface between walls that move and walls that stand.
pub(super) fn soft(fluid: &Fluid, walls: &[BuiltWalls<'_>]) -> Option<Warning> {
    let moving = walls.iter().filter(|body| body.scene.motion.is_some()).count();
    if moving == 0 || moving == walls.len() || fluid.free_surface().contains(&true) {
        return None;
    }
    let (spacing, smoothing) = (fluid.spacing(), fluid.formulation().smoothing);
    let list = CellList::new(fluid.positions(), spacing);
    let points = walls.iter().flat_map(|body| &body.rows.pieces).flat_map(|piece| &piece.points);
    let area = points.filter(|x| list.nearest(x, 1) <= NEXT * spacing).count() as f64;
    // Area over volume, times the smoothing length.
    let ratio = smoothing * area / fluid.len() as f64;
    let missing = 1.0 - 1.0 / (1.0 + LAYER * ratio);
    let message = || {
        format!(
            "the fluid is closed, and walls move while others stand: where they change its volume, pressures rise by about \
             {:.0} % less than the equation of state has it, for the density counts too little of fluid that comes nearer a wall; half \
             the spacing halves that",
            100.0 * missing
        )
    };
    (missing > MISSING).then(|| Warning::new(WarningKind::SoftWalls, message()))
}
