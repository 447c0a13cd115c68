//! Whether the initial stress of a shell is in balance where it stands.

use sph_shell::{Shell, StaticShell};

use crate::scene::body_in_scene::ShellInScene;
use crate::warning::{Warning, WarningKind};

/// Part of the forces of an initial stress up to which it counts as balanced: rounding leaves 1e-14, and to Newton's method
/// the rest would be little else.
const BALANCED: f64 = 1e-7;

/// Whether the supports of a shell leave a part of its initial stress without balance where it stands.
pub(super) fn unbalanced<S: std::ops::DerefMut<Target = Shell>>(system: &mut StaticShell<S>) -> bool {
    system.unbalanced_stress() > BALANCED
}

/// What is doubtful about a march that sets out under initial stress.
pub(super) fn warning_of_start(scene: &ShellInScene<'_>, shell: &mut Shell) -> Option<Warning> {
    if !(shell.is_stressed() && scene.analysis.kind().passes_time) {
        return None;
    }
    let part = StaticShell::lent(shell).unbalanced_stress();
    (part > BALANCED).then(|| {
        let message = format!(
            "at the start {:.1} % of the forces of the initial stress are balanced by nothing, at most {BALANCED:e} of them count as rest: \
             the shell springs from where it is drawn. If it is to set out at rest, find its balance with [analysis.static] and draw \
             that, or let damping take the motion away",
            100.0 * part
        );
        Warning::new(WarningKind::NotAtRest, message)
    })
}
