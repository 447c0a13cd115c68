//! What a shell touches, tools or itself, and what of that a checkpoint keeps.

use contact::{Deepest, Mesh, NodalContact, SurfaceContact, SurfaceTouch};
use sph_core::Vec3;

use crate::Shell;
use crate::conditions::touched::{contact_spacing, contact_stiffness, touched_mesh};
use crate::error::ShellError;

impl Shell {
    /// Its surface as other bodies touch it, its thickness \[L\], and its stiffness of contact against a rigid tool \[F/L³\].
    ///
    /// # Errors
    /// [`ShellError`] for a shell without cells, with sections off its particles, or with thicknesses that differ.
    pub fn surface_touched(&self) -> Result<(Mesh, f64, f64), ShellError> {
        let half = self.material.half_thickness(&self.reference)?;
        let (mesh, thickness) = touched_mesh(&self.reference.cloud, &half)?;
        let scales = self.material.scales();
        let all = std::iter::once(scales.uniform).chain(scales.own);
        Ok((mesh, thickness, contact_stiffness(all, &self.reference.cloud)))
    }

    /// Half of its thickness where that is least \[L\]; none of a shell without cells, and of one with sections off its particles.
    pub fn least_half_thickness(&self) -> Option<f64> {
        self.half_thicknesses()?.into_iter().filter(|half| *half > 0.0).reduce(f64::min)
    }

    /// Half of the thickness at each particle \[L\]; none of a shell without cells, and of one with sections off its particles.
    pub fn half_thicknesses(&self) -> Option<Vec<f64>> {
        self.material.half_thickness(&self.reference).ok()
    }

    /// Least membrane stiffness of all its sections, of a homogeneous one Young's modulus times the thickness \[F/L\].
    pub fn least_membrane_stiffness(&self) -> f64 {
        let scales = self.material.scales();
        std::iter::once(scales.uniform)
            .chain(scales.own)
            .map(|own| own.membrane)
            .fold(f64::INFINITY, f64::min)
    }

    /// Whether its stiffness of contact is what the thickness gives, not what steps in time bear.
    pub fn thickness_bounds_contact(&self) -> bool {
        let scales = self.material.scales();
        let mut all = std::iter::once(scales.uniform).chain(scales.own);
        all.all(|own| contact::thickness_bounds(own.thickness, contact_spacing(&self.reference.cloud)))
    }

    /// Whether it may touch tools or itself.
    pub fn may_touch(&self) -> bool {
        self.loading.touches()
    }

    /// Force of all tools, and of the shell itself where it touches itself, on a particle \[F\], for the forces last evaluated.
    pub fn contact_force(&self, particle: usize) -> Vec3 {
        let own = self.loading.own_contact.as_ref().map(|own| own.force(particle));
        self.loading.tools.force(particle) + own.unwrap_or_default()
    }

    /// What the shell does to itself, for the forces last evaluated; none where it may not touch itself.
    pub fn own_touch(&self) -> Option<&SurfaceTouch> {
        self.loading.own_contact.as_ref().map(|own| own.touch())
    }

    /// The two parts of it that are deepest in each other, for the forces last evaluated, their places from zero.
    pub fn deepest_in_itself(&self) -> Option<Deepest> {
        let found = self.loading.own_contact.as_ref()?.deepest(&self.motion.state)?;
        Some(Deepest { places: found.places.map(|place| self.reference.from_zero(place)), ..found })
    }

    /// What each particle feels of tools and of the shell itself, for the forces last evaluated.
    pub fn nodal_contact(&self) -> Vec<NodalContact> {
        let mut nodal = vec![NodalContact::default(); self.len()];
        self.loading.tools.nodal_contact(&self.motion.state, &mut nodal);
        if let Some(own) = &self.loading.own_contact {
            own.nodal_contact(&mut nodal);
        }
        nodal
    }

    /// Gaps between its faces and those of the nearest tool, or of the shell itself, at some particles \[L\], tools as for the forces last
    /// evaluated; of the shell itself up to half of its thickness, infinite where it touches nothing.
    pub fn contact_gaps(&self, particles: &[u32]) -> Vec<f64> {
        let state = &self.motion.state;
        let mut gaps: Vec<f64> = particles.iter().map(|&a| self.tool_gap(a as usize)).collect();
        if let Some(own) = &self.loading.own_contact {
            let own = own.gaps(particles, state);
            gaps.iter_mut().zip(own).for_each(|(gap, own)| *gap = gap.min(own));
        }
        gaps
    }

    /// The place of it that is deepest in a tool, by its number, from zero \[L\], for the forces last evaluated.
    pub fn deepest_in_tool(&self, tool: usize) -> Option<Vec3> {
        let place = self.loading.tools.deepest(tool, &self.motion.state)?;
        Some(self.reference.from_zero(place))
    }

    /// The contact with itself where that has friction.
    pub(crate) fn own_friction(&self) -> Option<&SurfaceContact> {
        let own = self.loading.own_contact.as_ref().map(|own| own.friction());
        own.filter(|contact| contact.remembers())
    }

    /// Coefficient of the friction of the shell on itself \[–\].
    pub fn own_friction_coefficient(&self) -> f64 {
        self.own_friction().map_or(0.0, SurfaceContact::friction)
    }

    /// Gives what is near in the shell an anchor for a long step to come.
    pub(crate) fn hover(&mut self) {
        let Self { loading, motion, .. } = self;
        if let Some(own) = &mut loading.own_contact {
            own.hover(&motion.state);
        }
    }

    /// What friction of the shell on itself keeps, behind how many numbers it is; nothing without.
    pub(crate) fn own_friction_history(&self) -> Vec<f64> {
        let own = self.own_friction().map(SurfaceContact::history);
        own.map_or_else(Vec::new, |own| std::iter::once(own.len() as f64).chain(own).collect())
    }

    /// Takes that off the front of a history.
    pub(crate) fn split_own_friction<'a>(&self, history: &'a [f64]) -> Option<(&'a [f64], &'a [f64])> {
        if self.own_friction().is_none() {
            return Some((&[], history));
        }
        let (count, rest) = history.split_first()?;
        rest.split_at_checked(*count as usize)
    }

    /// Takes up what friction of the shell on itself kept; false, and nothing changed, if it is that of another shell.
    pub(crate) fn take_up_own_friction(&mut self, own: &[f64]) -> bool {
        let contact = self.loading.own_contact.as_mut();
        contact.is_none_or(|contact| contact.take_up_history(own))
    }

    /// Stiffness of the contact with itself, of a unit of area \[F/L³\].
    pub fn own_contact_stiffness(&self) -> Option<f64> {
        self.loading.own_contact.as_ref().map(|own| own.stiffness())
    }

    /// Forgets what touches in the shell: it is put into another state.
    pub(crate) fn forget_contact(&mut self) {
        if let Some(own) = &mut self.loading.own_contact {
            own.put();
        }
    }

    /// What its contact with itself keeps beside [`Shell::motion`], a part of the state; empty without, and before anything was near.
    pub fn contact_state(&self) -> Vec<f64> {
        self.loading.own_contact.as_ref().map_or_else(Vec::new, |own| own.kept())
    }

    /// Takes up what [`Shell::contact_state`] gave, after the motion, to the same bits; false, and nothing changed, if it is that of another shell.
    pub fn take_up_contact(&mut self, kept: &[f64]) -> bool {
        match &mut self.loading.own_contact {
            Some(own) => own.take_up(kept),
            None => kept.is_empty(),
        }
    }
}
