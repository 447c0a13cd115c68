//! What is known to make a number of a Galerkin solid wrong.

use sph_core::Block;

use crate::scene::{Galerkin, GalerkinBasis, GalerkinEssential};
use crate::warning::{Doubt, Warning};

/// What is doubtful before anything is solved.
pub(super) fn doubts_of(options: &Galerkin, lengths: [f64; 3], block: &Block) -> Vec<Warning> {
    [leaks(options), locks(options, lengths, block)].into_iter().flatten().collect()
}

/// Fixed parameters are no fixed displacements.
fn leaks(options: &Galerkin) -> Option<Warning> {
    let message = "supports fix nodal parameters, which are no displacements: a clamped cantilever bends 1 to 2 % more, immovable \
                   edges of a plate leak by tens of percent; use essential = \"collocation\"";
    (options.essential == GalerkinEssential::Direct).then(|| Warning::new(Doubt::LeakySupport, message))
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
        Warning::new(Doubt::ShearLocking, message)
    })
}

/// Principal strain up to which the law of increments is meant.
const MEANT: f64 = 0.2;

/// Strains beyond those that the law was made for.
pub(super) fn large_strain(found: f64) -> Option<Warning> {
    (found > MEANT).then(|| {
        let message = format!(
            "a principal strain is {found:.2} in the last state: linear laws of increments are meant for less than {MEANT} and may be \
             off beyond; the other law, law = \"st-venant\", tells how much that matters"
        );
        Warning::new(Doubt::LargeStrain, message)
    })
}
