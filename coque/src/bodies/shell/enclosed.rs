//! What is doubtful about liquids that a shell encloses.

use sph_shell::Shell;

use crate::{Warning, WarningKind};

/// A liquid that pulled.
pub(super) fn pulling(shell: &Shell) -> Option<Warning> {
    let [pull, greatest] = shell.pulling_liquid()?;
    let message = format!(
        "the pressure of a liquid fell to {pull:.3e} below that of the surroundings ({greatest:.3e} at most): where it is below zero altogether a \
         liquid boils or lets go, and does not pull as it does here; give it a preload, a slower course, or damping"
    );
    Some(Warning::new(WarningKind::PullingLiquid, message))
}
