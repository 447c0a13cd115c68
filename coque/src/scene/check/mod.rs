//! The checks of a scene that need no particles, first to last.

mod analysis;
mod conditions;
mod curve;
mod fluid;
mod gauges;
mod imperfection;
mod preload;
mod sets;
mod shell;
mod solid;
mod together;
mod vectors;

use crate::scene::error::SceneError;
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::scope::Scope;
use crate::scene::velocity::Velocity;

type Checked = Result<(), SceneError>;

impl Scene {
    /// Refuses the first thing that is out of bounds.
    pub(crate) fn check(&self) -> Checked {
        self.check_units()?;
        self.check_bodies()?;
        self.check_coupling()?;
        match self.is_together() {
            true => self.check_together(),
            false => self.check_alone(),
        }
    }

    /// Refuses the first thing that is out of bounds in the scene of one body.
    fn check_alone(&self) -> Checked {
        self.check_body()?;
        self.check_sets()?;
        for (i, support) in self.supports.iter().enumerate() {
            self.check_support(&format!("supports[{i}]"), support)?;
        }
        for (i, load) in self.loads.iter().enumerate() {
            self.check_load(&format!("loads[{i}]"), load)?;
        }
        if let Some(solid) = self.as_solid() {
            self.check_solid(solid)?;
        }
        self.check_preload()?;
        self.check_analysis()?;
        self.check_curve()
    }

    fn check_units(&self) -> Checked {
        if self.units.consistent() {
            return Ok(());
        }
        let bound = "consistent: all three with a unit, or all three \"-\"";
        let repair = "units = { length = \"m\", force = \"N\", time = \"s\" }, or \"-\" for all three";
        Err(self.scope().value("units", "a mixture of units and \"-\"", bound, repair))
    }

    fn check_bodies(&self) -> Checked {
        let s = &self.scope();
        let mut names = self.bodies.keys();
        let Some(name) = names.next() else {
            let repair =
                "add [geometry], [material] and [section] for a lone shell, or [bodies.NAME.shell] with them";
            return Err(SceneError::Choice(s.fault("bodies", "no body", "one body", repair)));
        };
        let plain = |name: &str| name.chars().all(|c| c.is_alphanumeric() || "_-".contains(c));
        if let Some(name) = [name].into_iter().chain(names).find(|name| name.is_empty() || !plain(name)) {
            let repair = "it names sets and files: use letters, digits, _ and -";
            return Err(s.value(&format!("bodies.{name}"), format!("\"{name}\""), "a plain word", repair));
        }
        self.check_kinds()
    }

    /// Refuses what is out of bounds in the keys of the one body.
    fn check_body(&self) -> Checked {
        let s = &self.body_scope();
        let body = self.body();
        match body {
            BodyScene::Shell(shell) => {
                shell.check(s)?;
                self.check_parts(shell, s)?;
                self.check_wetting(shell, s)?;
            }
            BodyScene::Solid(solid) => solid.check(s)?,
            BodyScene::Fluid(fluid) => {
                fluid.check(s)?;
                self.check_velocity_of_fluid(fluid, s)?;
            }
            BodyScene::Walls(walls) => walls.check(self, s)?,
        }
        self.check_imperfection(s)?;
        body.velocity().map_or(Ok(()), |velocity| self.check_velocity(velocity, s))
    }

    fn check_velocity(&self, Velocity { on, linear, spin }: &Velocity, s: &Scope<'_>) -> Checked {
        let kind = self.analysis.kind();
        if !kind.passes_time {
            let bound = format!("none in {}", kind.name);
            let repair = "remove it, or use [analysis.explicit.transient]";
            return Err(SceneError::Choice(s.fault("velocity", "a velocity at the start", &bound, repair)));
        }
        if linear.is_none() && spin.is_none() {
            let repair = "velocity = { linear = [1, 0, 0] }, or spin = { axis = [0, 0, 1], rate = 1.0 }";
            return Err(SceneError::Choice(s.fault(
                "velocity",
                "neither",
                "`linear`, `spin` or both",
                repair,
            )));
        }
        if let Some(on) = on {
            if self.as_shell().is_none() {
                let bound = format!("none on a {}, all of which sets out", self.body().word());
                let repair = "remove `on`: only parts of a shell set out alone";
                return Err(SceneError::Choice(s.fault("velocity.on", &format!("\"{on}\""), &bound, repair)));
            }
            self.check_set_name(&s.path("velocity.on"), on)?;
        }
        s.sized_all("velocity.linear", &linear.unwrap_or_default())?;
        let Some(spin) = spin else { return Ok(()) };
        s.direction("velocity.spin.axis", spin.axis)?;
        s.sized_all("velocity.spin.point", &spin.point)?;
        s.sized("velocity.spin.rate", spin.rate)
    }
}
