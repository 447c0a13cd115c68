//! Marches of Galerkin solids that are stopped and go on: the same bits as marches that never stopped.

use crate::common::sittings::stopped_again_and_again;
use crate::common::text;

/// What a step starts from is all that the next one knows: axes and stress of the points, no factor that the end of a step left.
#[test]
fn levels_of_galerkin_solids_go_on_to_the_same_bits() {
    let cantilever = text("cantilever-solid.toml");
    let coarse = ("bodies.beam.solid.geometry.block.spacing", "[25.4, 12.7, 12.7]");
    let levels = ("analysis", "{ static = { levels = 8 } }");
    stopped_again_and_again("galerkin-static", &cantilever, &[coarse, levels], 3);
    let consistent = ("bodies.beam.solid.formulation.galerkin.tangent", "\"consistent\"");
    stopped_again_and_again("galerkin-consistent", &cantilever, &[coarse, levels, consistent], 3);
    let one_solve = ("analysis", "{ static = { levels = 8, one_solve = true } }");
    stopped_again_and_again("galerkin-one-solve", &cantilever, &[coarse, one_solve], 3);
}
