//! Tools of a shell: their stiffness, and shells that stand in them at the start.

use contact::Law;
use sph_core::Cloud;
use sph_shell::{LoadCase, Shell, Tool, contact_stiffness};

use super::build::Builder;
use super::sections::Sections;
use crate::bodies::refusal::in_tool;
use crate::bodies::tool_shapes::shape;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, ToolScene};

/// Depth over half of the thickness up to which a shell that stands on a tool counts as touching it, and no more.
pub(in crate::bodies) const TOUCHING: f64 = 1e-6;
/// Rounding of the law in analyses in time.
pub(in crate::bodies) const ROUNDED: f64 = 0.05;

/// Stiffness of contact of a unit of area of a shell \[F/L³\], before its factor: by its thinnest section and mean spacing.
pub(super) fn stiffness(sections: &Sections, cloud: &Cloud) -> f64 {
    let all = std::iter::once(sections.base.scales())
        .chain(sections.regions.iter().map(|region| region.section.scales()));
    contact_stiffness(all, cloud)
}

impl Builder<'_> {
    /// The tools of the scene.
    pub(super) fn tools(&self, sections: &Sections, cloud: &Cloud) -> Vec<Tool> {
        let stiffness = stiffness(sections, cloud);
        let rounding = if matches!(self.scene.analysis, Analysis::Explicit(_)) { ROUNDED } else { 0.0 };
        let tool = |tool: &ToolScene| {
            let rounding = tool.rounding.map_or(rounding, |rounding| rounding.get());
            Some(Tool {
                shape: shape(tool, |place| self.turned(place))?,
                moved: self.turned(tool.moved.unwrap_or_default()),
                turn: tool.turn.unwrap_or_default(),
                friction: tool.friction.map_or(0.0, |friction| friction.get()),
                amplitude: tool.amplitude.clone().unwrap_or_default(),
                case: if tool.preload { LoadCase::Preload } else { LoadCase::Loading },
                law: Law::new(rounding)?,
                stiffness: stiffness * tool.stiffness.map_or(1.0, |factor| factor.get()),
            })
        };
        self.scene.shell.tools.iter().filter_map(tool).collect()
    }

    /// Refuses a shell that stands in a tool before anything moves.
    pub(super) fn refuse_in_tools(&self, shell: &mut Shell) -> Result<(), SceneError> {
        let half = 0.5 * shell.thickness();
        let touches = shell.touches_before_all();
        for (i, (tool, (touch, gap))) in self.scene.shell.tools.iter().zip(touches).enumerate() {
            if touch.greatest_depth > TOUCHING {
                let value = format!("`{}`, {:.4e} deep in the shell", tool.name, -gap);
                let bound = format!(
                    "off the face of the shell, half of its thickness ({half:.4e}) from its particles, or on it"
                );
                return Err(in_tool(self.scene, i, value, &bound));
            }
        }
        Ok(())
    }
}
