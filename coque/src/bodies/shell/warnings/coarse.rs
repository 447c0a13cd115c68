//! Rules about particles that are too few: turns, folds, bending lengths, ends, corners, poles.

use std::f64::consts::PI;

use super::look::Look;
use super::plural;
use super::sheet::Sheet;

/// Turn of a fold \[rad\]: 30°. One of 30° costs a frame of two bars .1 %, one of 90° 3.6 %, one of 150° 65 % (hard case `crease`).
const FOLD: f64 = PI / 6.0;
/// Round-off of an angle \[rad\].
const ROUND_OFF: f64 = 1e-6;
/// Error \[%\] of an even bend over the sixth power of its turn from cell to cell: a strip rolled into a circle by an end couple turns by
/// .011, .12 and .65 % too far at .52, .79 and 1.05 rad.
const EVEN: f64 = 0.5;
/// Turn from cell to cell \[rad\] beyond which curvature is too coarse.
const TURN: f64 = 0.5;

/// Folds: edges across which the surface turns by more than 30° and beside which it does not.
pub(super) fn fold(look: &Look<'_>) -> Option<String> {
    fold_of(&look.sheet)
}

/// The same of cells alone.
pub(crate) fn fold_of(sheet: &Sheet<'_>) -> Option<String> {
    let (mut count, mut most) = (0_usize, 0.0_f64);
    for (cell, turns) in sheet.cells.iter().zip(&sheet.turns) {
        for (i, &turn) in turns.iter().enumerate() {
            if turn > FOLD + ROUND_OFF && beside(cell.count.into(), turns, i) < 0.5 * turn {
                count += 1;
                most = most.max(turn);
            }
        }
    }
    (count > 0).then(|| {
        // An edge is seen from both sides.
        let edges = plural(count.div_ceil(2), "edge");
        let degrees = most.to_degrees();
        format!(
            "a fold of {degrees:.0}° (over 30° on {edges}): one director serves both sides, and the two rows of cells beside the \
             fold bend too easily, by 4 % of the answer at 90° with ten cells a side, by more beyond; round the fold off by \
             cells that turn less, or give each side particles of its own"
        )
    })
}

/// The turn across the edge of a cell that lies opposite another.
fn beside(corners: usize, turns: &[f64; 4], i: usize) -> f64 {
    match corners {
        4 => turns[(i + 2) % 4],
        _ => turns[(i + 1) % 3].min(turns[(i + 2) % 3]),
    }
}

/// Curvature that is too coarse at rest: neighbours turn by more than half a radian, and it is no fold.
pub(super) fn turn(look: &Look<'_>) -> Option<String> {
    let sheet = &look.sheet;
    let (mut count, mut most) = (0_usize, 0.0_f64);
    for (cell, turns) in sheet.cells.iter().zip(&sheet.turns) {
        for (i, &turn) in turns.iter().enumerate() {
            if turn > TURN && beside(cell.count.into(), turns, i) >= 0.5 * turn {
                count += 1;
                most = most.max(turn);
            }
        }
    }
    (count > 0).then(|| coarse_turn(most, count.div_ceil(2), "at rest"))
}

/// The same of a shape that the shell took; folds at rest were reported before.
pub(super) fn turned(sheet: &Sheet<'_>, level: f64) -> Option<String> {
    let (most, _, count) = sheet.greatest(TURN)?;
    (count > 0).then(|| coarse_turn(most, count, &format!("at level {level}")))
}

fn coarse_turn(most: f64, edges: usize, when: &str) -> String {
    format!(
        "neighbouring cells turn by up to {most:.2} rad {when} (over {TURN} across {}): an even bend may be off by {:.1} %, and what \
         changes along it by more; use {:.0} times as many particles along the bend",
        plural(edges, "edge"),
        EVEN * most.powi(6),
        (most / (0.5 * TURN)).ceil()
    )
}

/// Cells to a bending length √(Rt) from which the layers at edges are resolved to a few percent.
///
/// A layer w ~ exp(−x/ℓ), ℓ = .78 √(Rt), is found to second order, the error falls as 1/c² in the cells c to √(Rt). Measured against
/// fine lattices, R/t = 50 to 1000: 2 to 3 %/c² of the energy on a roof under its weight, 6 %/c² on a cylinder pinched by point
/// forces. Shells that bend without stretch have no such layer: a pinched hemisphere is right at c = .8, which is why the bound of
/// all shells is not higher.
const LAYER: f64 = 0.75;
/// The same under a force on one particle away from a free edge: 6 %/c² is 2.5 %.
const DIMPLE: f64 = 1.55;
/// Part of the surface that has to be so coarse, and that sharp corners have to take.
const MUCH: f64 = 0.1;

/// Too few cells to a bending length √(Rt) on curved parts.
pub(super) fn bending(look: &Look<'_>) -> Option<String> {
    let t = look.thickness;
    let whole: f64 = look.curved.iter().map(|point| point.area).sum();
    let coarse: f64 = look.curved.iter().filter(|p| p.cells(t) < LAYER).map(|point| point.area).sum();
    if coarse > MUCH * whole {
        let least = look.curved.iter().map(|point| point.cells(t)).fold(f64::INFINITY, f64::min);
        return Some(format!(
            "{least:.2} cells to a bending length √(Rt) at the least, fewer than {LAYER} on {:.0} % of the surface (R/t = {:.0}): where an \
             edge or a load bends the shell, the answer may be off by {:.0} % and more; use {:.0} times as many particles along the \
             curvature",
            100.0 * coarse / whole,
            look.slenderness(),
            2.0 / (least * least),
            (DIMPLE / least).ceil()
        ));
    }
    let pressed = look.loads.iter().filter_map(|load| load.alone).filter(|&a| !on_a_free_edge(look, a));
    let cells = |a: u32| {
        let around = look.curved.iter().filter(|point| point.particles.contains(&a));
        around.map(|point| point.cells(t)).reduce(f64::min).map(|cells| (cells, a))
    };
    let (least, particle) = pressed.filter_map(cells).min_by(|a, b| a.0.total_cmp(&b.0))?;
    (least < DIMPLE).then(|| {
        format!(
            "{least:.2} cells to a bending length √(Rt) round particle {particle}, on which a force acts alone; with fewer than {DIMPLE} \
             its dimple may be about {:.0} % too stiff: use {:.0} times as many particles along the curvature, or spread the force",
            6.0 / (least * least),
            (2.0 * DIMPLE / least).ceil()
        )
    })
}

/// Whether a particle lies on an edge along which its neighbour is free: a shell bends there without stretch.
fn on_a_free_edge(look: &Look<'_>, particle: u32) -> bool {
    let free = |(cell, across): (&sph_core::Cell, &[u32; 4])| {
        let mut edges =
            cell.edges().zip(across).filter(|(_, other)| **other == u32::MAX).map(|(edge, _)| edge);
        edges.any(|(a, b)| {
            let other = if a == particle { b } else { a };
            (a == particle || b == particle) && !look.shell.is_held(other as usize)
        })
    };
    look.sheet.cells.iter().zip(&look.across).any(free)
}

/// Cells from end to end below which a field that bends once is off by percents.
const CELLS: f64 = 5.5;
/// The same along the shorter direction, where less varies, unless it is narrower than `NARROW` of the longer one.
const CELLS_ACROSS: f64 = 5.5;
/// Width over length below which nothing much varies across.
const NARROW: f64 = 0.6;

/// A handful of particles from end to end.
pub(super) fn few(look: &Look<'_>) -> Option<String> {
    let [width, length] = look.extents();
    let [across, along] = look.lattice.map_or_else(
        || [width, length].map(|extent| extent / look.spacing),
        |sides| sides.map(|(cells, _)| cells as f64),
    );
    let (cells, bound) = match () {
        () if along < CELLS => (along, CELLS),
        () if across < CELLS_ACROSS && width > NARROW * length => (across, CELLS_ACROSS),
        () => return None,
    };
    Some(format!(
        "{cells:.0} cells from end to end; the error falls with the square of their number, and with fewer than {:.0} a plate that \
         bends once is percents off: use more particles, and compare",
        bound.ceil()
    ))
}

/// Corner of a cell \[°\] below which it counts as sharp.
const SHARP: f64 = 30.0;

/// Sharp corners on much of the surface.
pub(super) fn corners(look: &Look<'_>) -> Option<String> {
    let positions = &look.shell.reference().cloud.positions;
    let (mut sharp, mut sharpest) = (0.0, f64::INFINITY);
    for (cell, area) in look.sheet.cells.iter().zip(&look.sheet.areas) {
        let corners = cell.particles();
        let n = corners.len();
        let place = |i: usize| positions[corners[i % n] as usize];
        let angle = |i: usize| (place(i + 1) - place(i)).angle(&(place(i + n - 1) - place(i)));
        let least = (0..n).map(angle).fold(f64::INFINITY, f64::min).to_degrees();
        sharpest = least.min(sharpest);
        sharp += if least < SHARP { *area } else { 0.0 };
    }
    let whole: f64 = look.sheet.areas.iter().sum();
    (sharp > MUCH * whole).then(|| {
        format!(
            "{:.0} % of the surface lies in cells with a corner below {SHARP}° (the sharpest {sharpest:.0}°): they are long cells in \
             disguise and may be too stiff, by 7 % on a plate at 20° and 27 % at 10°, more where curved; mesh anew with rounder cells",
            100.0 * sharp / whole
        )
    })
}

/// Triangles round one particle from which on it is a pole.
const SPOKES: usize = 9;

/// Many triangles that meet in one particle.
pub(super) fn pole(look: &Look<'_>) -> Option<String> {
    let mut spokes = vec![0_u32; look.shell.len()];
    for cell in look.sheet.cells.iter().filter(|cell| cell.count == 3) {
        cell.particles().iter().for_each(|&a| spokes[a as usize] += 1);
    }
    let (particle, &most) = spokes.iter().enumerate().max_by_key(|(_, count)| **count)?;
    (most as usize >= SPOKES).then(|| {
        format!(
            "{most} triangles meet in particle {particle} (from {SPOKES} on it is a pole): thirds of a pressure are more than flat facets \
             bear there, and the pole alone moves out and may go 10 % too far on a sphere; use blocks of quadrangles there"
        )
    })
}
