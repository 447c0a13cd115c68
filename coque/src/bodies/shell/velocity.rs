//! The velocity with which a shell sets out.

use sph_core::Vec3;
use sph_shell::Shell;

use crate::bodies::shell::build::Builder;

impl Builder<'_> {
    /// Gives particles and directors the velocity of the scene, `v + ω × (x − p)` and `ω × d`; held parts stay at rest.
    pub(super) fn set_out(&self, shell: &mut Shell) {
        let Some(velocity) = &self.scene.shell().velocity else { return };
        let linear = self.turned(velocity.linear.unwrap_or_default());
        let (spin, point) = velocity.spin.map_or_else(Default::default, |spin| {
            (self.turned(spin.axis).normalize() * spin.rate, self.turned(spin.point))
        });
        for a in 0..shell.len() {
            let about: Vec3 = shell.position(a) - point;
            shell.set_rate(a, linear + spin.cross(&about), spin.cross(&shell.director(a)));
        }
    }
}
