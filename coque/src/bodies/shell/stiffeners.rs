//! The stiffeners of a scene on their particles.

use sph_shell::{InSurface, Stiffener};

use super::bars::bar_of;
use super::build::Builder;
use crate::bodies::sets::Sets;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, StiffenerScene};

impl Builder<'_> {
    /// Where inertia counts, bars give none to particles that follow others: those of rigid sets and of tied edges.
    fn refuse_hung(&self, sets: &Sets, path: &str, on: &str, particles: &[u32]) -> Result<(), SceneError> {
        let analysis = &self.scene.analysis;
        let in_time = matches!(analysis, Analysis::Explicit(own) if own.transient.is_some());
        if !(in_time || analysis.swings() || matches!(analysis, Analysis::Modal(_))) {
            return Ok(());
        }
        let scope = self.scene.body_scope();
        let shell = self.scene.shell;
        let rigid =
            shell.rigid.iter().enumerate().map(|(k, own)| (format!("rigid[{k}].on"), &own.on, "a rigid set"));
        let tied = shell
            .ties
            .iter()
            .enumerate()
            .map(|(k, own)| (format!("ties[{k}].edge"), &own.edge, "a tied edge"));
        for (key, set, what) in rigid.chain(tied) {
            let members = sets.at(self.scene, &scope.path(&key), set)?;
            if particles.iter().any(|a| members.contains(a)) {
                let bound = format!(
                    "no line with particles of {what} in {}, which would lose the inertia of the bar about it",
                    analysis.kind().name
                );
                let repair = "end the stiffener before it, or lay it on the sheet to which the edge is tied";
                return Err(SceneError::Set(self.scene.source.fault(
                    path,
                    &format!("\"{on}\""),
                    &bound,
                    repair,
                )));
            }
        }
        Ok(())
    }

    /// Particles of a line at which its direction in the surface is held.
    fn held_ends(
        &self,
        sets: &Sets,
        stiffener: &StiffenerScene,
        number: usize,
        line: &[u32],
    ) -> Result<Vec<u32>, SceneError> {
        let Some(in_surface) = &stiffener.in_surface else { return Ok(Vec::new()) };
        let mut held = Vec::new();
        for (k, on) in in_surface.held.iter().enumerate() {
            let path = self.scene.body_scope().path(&format!("stiffeners[{number}].in_surface.held[{k}]"));
            let ends = sets.at(self.scene, &path, on)?.iter().filter(|a| line.contains(a));
            let before = held.len();
            held.extend(ends.copied());
            self.refuse_moved(sets, &path, on, &held[before..])?;
            if held.len() == before {
                let bound = format!("which has no end of the line \"{}\"", stiffener.on);
                let repair = "name the edge or the set at which it ends, or leave it out";
                return Err(SceneError::Set(self.scene.source.fault(
                    &path,
                    &format!("\"{on}\""),
                    &bound,
                    repair,
                )));
            }
        }
        held.sort_unstable();
        held.dedup();
        Ok(held)
    }

    /// Refuses to hold the direction of a bar where it goes with a rigid set, a tied edge or a support that turns, or where nothing stands still.
    fn refuse_moved(&self, sets: &Sets, path: &str, on: &str, held: &[u32]) -> Result<(), SceneError> {
        let scope = self.scene.body_scope();
        let shell = self.scene.shell;
        let rigid = shell.rigid.iter().enumerate().map(|(k, own)| (format!("rigid[{k}].on"), &own.on));
        let tied = shell.ties.iter().enumerate().map(|(k, own)| (format!("ties[{k}].edge"), &own.edge));
        for (key, set) in rigid.chain(tied) {
            let members = sets.at(self.scene, &scope.path(&key), set)?;
            if held.iter().any(|a| members.contains(a)) {
                let bound =
                    format!("which goes where `{key}` goes; only an end that stands still can be held");
                let fault =
                    self.scene.source.fault(path, &format!("\"{on}\""), &bound, "leave it out of `held`");
                return Err(SceneError::Set(fault));
            }
        }
        let mut still: Vec<u32> = Vec::new();
        for support in &self.scene.supports {
            let members = sets.at(self.scene, &support.at("on"), support.on)?;
            let turns = support.turned.is_some() || support.rotated.is_some();
            if turns && held.iter().any(|a| members.contains(a)) {
                let bound = "which a support turns; only an end that stands still can be held";
                let fault =
                    self.scene.source.fault(path, &format!("\"{on}\""), bound, "leave it out of `held`");
                return Err(SceneError::Set(fault));
            }
            still.extend(members);
        }
        if held.iter().any(|a| !still.contains(a)) {
            let bound = "which has no support; what holds a direction holds its place";
            let fault = self.scene.source.fault(
                path,
                &format!("\"{on}\""),
                bound,
                "add a support there, or leave it out",
            );
            return Err(SceneError::Set(fault));
        }
        Ok(())
    }

    /// Bars along lines, in the order of the scene.
    ///
    /// # Errors
    /// [`SceneError`] for sets that are none.
    pub(super) fn stiffeners(&self, sets: &Sets) -> Result<Vec<Stiffener>, SceneError> {
        let shell = self.scene.shell;
        let mut all = Vec::new();
        for (i, stiffener) in shell.stiffeners.iter().enumerate() {
            let path = self.scene.body_scope().path(&format!("stiffeners[{i}].on"));
            let particles = sets.at(self.scene, &path, &stiffener.on)?.to_vec();
            self.refuse_hung(sets, &path, &stiffener.on, &particles)?;
            let held = self.held_ends(sets, stiffener, i, &particles)?;
            all.extend(bar_of(stiffener, shell).map(|bar| {
                let in_surface = bar.in_surface.map(|own| InSurface { held, ..own });
                Stiffener { particles, in_surface, ..bar }
            }));
        }
        Ok(all)
    }
}
