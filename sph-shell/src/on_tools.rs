//! What a shell and the tools that it may touch do to each other, to be read.

use contact::{Pose, ToolShape, Touch};
use explicit_dynamics::Instant;
use sph_core::Vec3;

use crate::Shell;
use crate::conditions::case::LoadCase;

impl Shell {
    /// Evaluates loads and tools at an instant; what each tool and the shell do to each other there.
    pub fn touch(&mut self, at: Instant) -> &[Touch] {
        self.evaluate_external(at);
        self.touches()
    }

    /// Least gaps between its faces and those of each tool at an instant \[L\], negative where they are in each other.
    pub fn tool_gaps(&self, at: Instant) -> Vec<f64> {
        self.loading.tools.least_gaps(at, self.loading.case, &self.motion.state)
    }

    /// What each tool and the shell do to each other before a preload or a load moves anything, with the least gap between their faces \[L\].
    pub fn touches_before_all(&mut self) -> Vec<(Touch, f64)> {
        let (at, case) = (Instant { time: 0.0, level: 0.0 }, self.loading.case);
        self.loading.case = LoadCase::Preload;
        let touches = self.touch(at).to_vec();
        let gaps = self.tool_gaps(at);
        self.loading.case = case;
        touches.into_iter().zip(gaps).collect()
    }

    /// Whether there are tools that it may touch.
    pub fn has_tools(&self) -> bool {
        !self.loading.tools.is_empty()
    }

    /// The shape of each tool at level zero, and how far it had moved and turned, from zero, as forces were last evaluated.
    pub fn tools_as_they_stood(&self) -> impl Iterator<Item = (ToolShape, Pose)> {
        self.loading.tools.stood()
    }

    /// Gap between its face and that of the nearest tool at a particle \[L\], with tools as for the forces last evaluated.
    pub fn tool_gap(&self, particle: usize) -> f64 {
        self.loading.tools.gap_at(particle, &self.motion.state)
    }

    /// Whether a tool has friction, or the shell where it touches itself.
    pub fn has_friction(&self) -> bool {
        self.loading.tools.remember() || self.own_friction().is_some()
    }

    /// Force of all tools on a particle \[F\], for the forces last evaluated.
    pub fn tool_force(&self, particle: usize) -> Vec3 {
        self.loading.tools.force(particle)
    }

    /// Stiffness of the contact with each tool, of a unit of area \[F/L³\].
    pub fn tool_stiffness(&self) -> impl Iterator<Item = f64> {
        self.loading.tools.stiffnesses()
    }

    /// What each tool and the shell do to each other, for the forces last evaluated, in the order in which tools were given.
    pub fn touches(&self) -> &[Touch] {
        self.loading.tools.touches()
    }

    /// Energy that friction on tools and of the shell on itself has taken at a particle \[F L\], until the last commit.
    pub fn friction_loss(&self, particle: usize) -> f64 {
        let own = self.own_friction().map_or(0.0, |own| own.lost_at((0, particle as u32)));
        self.loading.tools.lost_at(particle) + own
    }
}
