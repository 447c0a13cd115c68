//! The velocity with which a shell sets out.

use sph_core::Vec3;
use sph_shell::Shell;

use crate::bodies::sets::Sets;
use crate::bodies::shell::build::Builder;
use crate::scene::error::SceneError;

impl Builder<'_> {
    /// Gives particles and directors of its set the velocity of the scene, `v + ω × (x − p)` and `ω × d`; held parts stay at rest.
    pub(super) fn set_out(&self, sets: &Sets, shell: &mut Shell) -> Result<(), SceneError> {
        let Some(velocity) = &self.scene.shell.velocity else { return Ok(()) };
        let linear = self.turned(velocity.linear.unwrap_or_default());
        let (spin, point) = velocity.spin.map_or_else(Default::default, |spin| {
            (self.turned(spin.axis).normalize() * spin.rate, self.turned(spin.point))
        });
        let path = self.scene.body_scope().path("velocity.on");
        for &a in sets.at(self.scene, &path, velocity.on.as_deref().unwrap_or("all"))? {
            let a = a as usize;
            let about: Vec3 = shell.position(a) - point;
            shell.set_rate(a, linear + spin.cross(&about), spin.cross(&shell.director(a)));
        }
        Ok(())
    }
}
