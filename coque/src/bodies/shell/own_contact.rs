//! The contact of a shell with itself: its stiffness, and shells that stand in themselves at the start.

use contact::Law;
use explicit_dynamics::Instant;
use sph_core::Cloud;
use sph_shell::{OwnContact, Shell};

use super::build::Builder;
use super::sections::Sections;
use super::tools::{ROUNDED, TOUCHING, stiffness};
use crate::scene::Analysis;
use crate::scene::ContactScene;
use crate::scene::error::SceneError;

/// Stiffness over that against a rigid tool: both sides give.
const OF_BOTH: f64 = 0.5;

impl Builder<'_> {
    /// How the shell touches itself, if its scene says so.
    pub(super) fn own_contact(&self, sections: &Sections, cloud: &Cloud) -> Option<OwnContact> {
        let own = self.scene.scene.contact.iter().find(|own| own.is_of_itself(self.scene.name))?;
        let marches = matches!(self.scene.analysis, Analysis::Explicit(_));
        let rounding = own.rounding.map_or(if marches { ROUNDED } else { 0.0 }, |rounding| rounding.get());
        let factor = own.stiffness.map_or(1.0, |factor| factor.get());
        let stiffness = OF_BOTH * stiffness(sections, cloud) * factor;
        let friction = own.friction.map_or(0.0, |friction| friction.get());
        Some(OwnContact { law: Law::new(rounding)?, stiffness, edges: marches, friction })
    }

    /// Refuses a shell that stands in itself before anything moves.
    pub(super) fn refuse_in_itself(&self, shell: &mut Shell) -> Result<(), SceneError> {
        shell.touch(Instant { time: 0.0, level: 0.0 });
        let Some(found) = shell.deepest_in_itself().filter(|found| found.depth > TOUCHING) else {
            return Ok(());
        };
        let thickness = shell.thickness();
        let places = found.places.map(|place| {
            let x = self.turn_back(&place);
            format!("[{:.4}, {:.4}, {:.4}]", x.x, x.y, x.z)
        });
        let [here, there] = &places;
        let value =
            format!("the shell with {here} and {there}, {:.4e} apart", (1.0 - found.depth) * thickness);
        let bound = format!("a thickness ({thickness:.4e}) apart or more where parts face each other");
        let repair = "move them apart, or leave the contact out";
        let own = |own: &ContactScene| own.is_of_itself(self.scene.name);
        let number = self.scene.scene.contact.iter().position(own).unwrap_or_default();
        let path = format!("contact[{number}]");
        Err(SceneError::Choice(self.scene.scope().fault(&path, &value, &bound, repair)))
    }
}
