//! Rules about formulations: which of them are off on which bodies, and how uneven cells lock or soften thin curved shells.

use sph_shell::{ChordLoss, Divergence, Formulation, Reach};

use super::look::Look;

/// Smoothing length \[spacings\] above which motion grows in the difference form: .95 settles on the ring at all levels, 1 at some.
const NARROW: f64 = 0.95;

/// The published equations: always doubtful as printed, in difference form with wide stencils.
pub(super) fn strong_form(look: &Look<'_>) -> Option<String> {
    let &Formulation::StrongForm { divergence, smoothing, .. } = look.shell.formulation() else {
        return None;
    };
    if divergence == Divergence::Sum {
        return Some(
            "formulation strong-form has no energy, and the printed sum finds forces at edges where the stress is constant: 28 to 33 % of \
             the length off on the ring at a quarter of its moment; use formulation.stress-point, or \
             strong-form.divergence = \"difference\""
                .into(),
        );
    }
    (smoothing > NARROW).then(|| {
        format!(
            "formulation strong-form with smoothing = {smoothing} may flutter and be lost: it has no energy, and above {NARROW} motion \
             at edges grows faster than it is damped; use 0.85, or formulation.stress-point"
        )
    })
}

/// Spacings to a thickness above which order 3 locks on flat plates.
const FLAT: f64 = 2.0;
/// Δ²/(Rt) above which order 3 locks on curved shells by more than two percent.
const CURVED: f64 = 0.1;

/// Strains sampled at particles.
pub(super) fn nodal(look: &Look<'_>) -> Option<String> {
    let &Formulation::Nodal { order, .. } = look.shell.formulation() else { return None };
    let to_thickness = look.spacing / look.thickness;
    let bent = look.spacing.powi(2) * look.curvature / look.thickness;
    if order < 3 {
        return Some(format!(
            "formulation nodal of order {order} may be far off, 2 to 14 % on clamped plates of 21 by 21 particles of any thickness, and \
             locks as spacing over thickness grows (here {to_thickness:.2}; by 40 % at 500): use formulation.stress-point, or \
             order 3 below {FLAT}"
        ));
    }
    let (what, value, bound) = if bent > CURVED {
        ("the square of the spacing over radius times thickness", bent, CURVED)
    } else if to_thickness > FLAT {
        ("spacing over thickness", to_thickness, FLAT)
    } else {
        return None;
    };
    Some(format!(
        "formulation nodal of order 3 locks: {what} is {value:.2}, and beyond {bound} it may be more than 2 % too stiff; use \
         formulation.stress-point, or more particles"
    ))
}

/// Spacings to a thickness above which wide stencils are off on uneven cells.
const THIN: f64 = 100.0;
/// Mean difference of the areas of neighbouring cells over their sum above which cells are uneven: a lattice graded 1:10 over
/// twenty cells has .06.
const UNEVEN: f64 = 0.1;

/// Stencils wider than a cell, on thin shells of uneven cells.
pub(super) fn wide(look: &Look<'_>) -> Option<String> {
    let Formulation::StressPoint(Reach::Kernel(_, reach)) = look.shell.formulation() else { return None };
    let (to_thickness, uneven) = (look.spacing / look.thickness, unevenness(look));
    (to_thickness > THIN && uneven > UNEVEN).then(|| {
        format!(
            "stencils of reach {reach} on a thin shell of uneven cells: spacing over thickness is {to_thickness:.0}, and neighbouring \
             cells differ by {:.0} % of their sum; beyond {THIN} and {:.0} % plates may be 2 to 4 % too stiff: use \
             formulation.stress-point.support = \"cell\", or an even lattice",
            100.0 * uneven,
            100.0 * UNEVEN
        )
    })
}

/// Mean of |A − A′|/(A + A′) over pairs of neighbouring cells \[–\].
pub(super) fn unevenness(look: &Look<'_>) -> f64 {
    let (mut sum, mut pairs) = (0.0, 0_usize);
    let areas = &look.sheet.areas;
    for (c, cells) in look.across.iter().enumerate() {
        for area in cells.iter().filter_map(|&d| areas.get(d as usize)) {
            sum += (area - areas[c]).abs() / (area + areas[c]);
            pairs += 1;
        }
    }
    sum / pairs.max(1) as f64
}

/// Stiffening of a bending without stretch over the figure λ of [`ChordLoss`], at the most.
///
/// λ is the energy that the membrane would take beside that of bending if no particle moved to make up for it; particles do, for the
/// most part. Measured on hemispheres and arcs, jitter ±.1 to ±.4 and Poisson, R/t = 100 to 10⁴: .05 to .14 λ up to λ = 3, less
/// beyond (.01 λ at 300), the deflection falling as 1/(1 + that).
const STIFFENING: f64 = 1.0 / 7.0;
/// λ from which that is two percent.
const LOCKED: f64 = 0.15;

/// Uneven cells on a thin curved shell.
pub(super) fn uneven(look: &Look<'_>) -> Option<String> {
    let ChordLoss { locking, .. } = look.shell.chord_loss();
    (locking > LOCKED).then(|| {
        let off = 100.0 * (1.0 - 1.0 / (1.0 + STIFFENING * locking));
        format!(
            "uneven cells on a thin curved shell (R/t = {:.0}, {:.1} spacings to √(Rt)): chords put {locking:.2} of the bending energy into \
             the membrane, and from {LOCKED} on that is more than 2 %; a bending without stretch may come out up to {off:.0} % too stiff: use \
             a lattice, or more particles (the figure falls with the fourth power of the spacing)",
            look.slenderness(),
            look.spacing * (look.curvature / look.thickness).sqrt()
        )
    })
}

/// Softening of [`ChordLoss`] from which stretch counts, and the stretch of the area.
///
/// What is given back to the membrane goes with the change of curvature, of which a sphere that grows by percents has much: one of
/// softening .03 blown up by 3.6 % moves 4.6 % too far, a tube of .007 by 9 % one percent (hard case `loads`).
const SOFT: f64 = 0.015;
const STRETCH: f64 = 0.02;

/// Uneven curved cells that are stretched by percents.
pub(super) fn stretched(loss: ChordLoss, stretch: f64, level: f64) -> Option<String> {
    (loss.softening > SOFT && stretch > STRETCH).then(|| {
        format!(
            "uneven curved cells (membrane softened by {:.3}, bound {SOFT}) are stretched by {:.1} % of their area at level {level}: beyond \
             {:.0} % the shell moves some percents too far; use a lattice, or more particles",
            loss.softening,
            100.0 * stretch,
            100.0 * STRETCH
        )
    })
}

/// Slices below which bending moments past the yield are off by more than 3 % in the mean of the squares.
const SLICES: usize = 5;

/// Few slices of a section that yields.
pub(super) fn few_slices(look: &Look<'_>) -> Option<String> {
    let slices = look.shell.plastic_sections().map(|section| section.fewest_slices()).min()?;
    (slices < SLICES).then(|| {
        format!(
            "{slices} slices through the thickness: bending moments past the yield may be off by 6 % and more (six slices 2.7 %, ten 1 %); give the \
             section, or the ply, `slices` = 6 or more"
        )
    })
}
