//! A peridynamic body as a system of `explicit-dynamics`: forces and breaking, kick, drift, stable step and bounds; in mass-scaled
//! coordinates its tangent applied to a vector; as a structure that a fluid wets.

use explicit_dynamics::{
    BoundaryLayout, BoundaryLoad, BoundaryState, Bounds, Dynamics, Instant, LinearisedDynamics, MarchError,
    MassScaled, OutOfBounds, StableStep, Step, Wetted, Work, lanczos_step,
};
use parallel::CHUNK;
use sph_core::Vec3;

use crate::Solid;
use crate::bonds::mechanics::Evaluation;
use crate::error::SolidError;
use crate::solid::vector;
use crate::wetted::Surface;

impl Dynamics for Solid {
    /// Bonds break once a step, after the forces of this step were found with them.
    fn evaluate(&mut self, at: Instant) -> f64 {
        let wanted = Evaluation { energy: true, watch: true, share: &self.share };
        self.internal_energy = self.mechanics.evaluate(&mut self.rows, &mut self.internal, wanted);
        self.evaluate_external(at);
        self.internal_energy
    }

    fn kick(&mut self, step: &Step) -> Work {
        // A kick of no span shows a state: what breaks in it is counted by the kick that follows.
        let breaks = step.kick > 0.0 && self.noted();
        self.kick_in(step, breaks)
    }

    fn drift(&mut self, step: &Step) {
        self.drift_rows(step.drift());
    }

    fn advance(&mut self, step: &Step) -> Work {
        let wanted = Evaluation { energy: false, watch: true, share: &self.share };
        self.mechanics.evaluate(&mut self.rows, &mut self.internal, wanted);
        self.evaluate_external(step.from);
        if self.noted() {
            let work = self.kick_in(step, step.kick > 0.0);
            self.drift(step);
            return work;
        }
        let plastic = self.keep_flow(step);
        let mut work = self.pass::<true>(step);
        work.dissipated += plastic;
        work
    }

    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        let StableStep { dt, holds } = lanczos_step(self, safety)?;
        // Contact may come at any time; its eigenvalues add to those found, λ = (2 safety/Δt)², at most.
        let contact = self.mechanics.contact_spectrum();
        if contact == 0.0 {
            return Ok(StableStep { dt, holds });
        }
        let found = (2.0 * safety / dt).powi(2);
        Ok(StableStep { dt: 2.0 * safety / (found + contact).sqrt(), holds })
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        if bounds == Bounds::Configuration {
            return Ok(());
        }
        let own = self.share.own(self.len());
        let (square, particle) =
            self.share.greatest(own.map(|node| (vector(&self.rates[node]).norm_squared(), node)));
        let (speed, bound) = (square.sqrt(), self.sound_speed);
        if speed <= bound { Ok(()) } else { Err(OutOfBounds::Speed { particle, speed, bound }) }
    }

    fn stop(&mut self) {
        self.rates.fill([0.0; 4]);
    }

    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        Some(self)
    }
}

impl Solid {
    /// Whether bonds were beyond their limit in the last evaluation, of anyone who marches it.
    fn noted(&self) -> bool {
        self.mechanics.breaks() && self.share.any(self.mechanics.noted(&self.share))
    }

    /// A kick in which the bonds noted break, or none is noted.
    fn kick_in(&mut self, step: &Step, breaks: bool) -> Work {
        let plastic = self.keep_flow(step);
        let mut work = self.pass::<false>(step);
        work.dissipated += plastic;
        if breaks {
            work.dissipated += self.break_noted(0.5 * step.drift());
        }
        work
    }

    /// Keeps what flowed in the last evaluation, once a step: a kick of no span shows a state. Returns the plastic work \[F L\].
    fn keep_flow(&mut self, step: &Step) -> f64 {
        if step.kick > 0.0 { self.mechanics.keep_flow(&self.rows, &self.share) } else { 0.0 }
    }

    /// Breaks the bonds noted in the last evaluation; returns the energy they hold after so much time \[F L\].
    ///
    /// A kick has their pull up to the middle of the step, so that their energy is that of there: with it the balance of
    /// central differences closes to second order in the step.
    fn break_noted(&mut self, after: f64) -> f64 {
        let Self { rows, rates, breaking, mechanics, share, .. } = self;
        breaking.resize(rows.len(), [0.0; 4]);
        for row in share.own(rows.len()) {
            breaking[row] = std::array::from_fn(|k| rows[row][k] + after * rates[row][k]);
        }
        share.exchange_places(breaking);
        mechanics.break_bonds(breaking, share)
    }

    /// The vector without what supports of a row hold.
    pub(crate) fn free_part(&self, row: usize, v: Vec3) -> Vec3 {
        self.constraints.get(row).map_or(v, |constraint| constraint.held.free_part(v.into()).into())
    }
}

impl LinearisedDynamics for Solid {
    fn unknowns(&self) -> usize {
        3 * self.rows.len()
    }

    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        let scaled = |row: usize| self.scaled(row, Vec3::new(v[3 * row], v[3 * row + 1], v[3 * row + 2]));
        let own = self.share.own(self.rows.len());
        let mut along = vec![[0.0; 4]; self.rows.len()];
        own.clone().for_each(|row| along[row] = scaled(row).push(0.0).into());
        self.mechanics.tangent(&mut self.rows, &mut along, &mut self.internal, &self.share);
        out.fill(0.0);
        for row in own {
            let scaled = self.scaled(row, vector(&self.internal[row]));
            out[3 * row..3 * row + 3].copy_from_slice(scaled.as_slice());
        }
    }

    fn dot(&mut self, a: &[f64], b: &[f64]) -> f64 {
        self.share.dot(a, b, 3)
    }
}

impl MassScaled for Solid {
    fn out_of_balance(&self, out: &mut [f64]) {
        for (row, out) in out.chunks_exact_mut(3).enumerate() {
            let external = self.external.get(row).copied().unwrap_or_default();
            let scaled = self.scaled(row, external - vector(&self.internal[row]));
            out.copy_from_slice(scaled.as_slice());
        }
    }

    fn rates(&self, out: &mut [f64]) {
        for (row, out) in out.chunks_exact_mut(3).enumerate() {
            let scaled = vector(&self.rates[row]) * self.masses[row].sqrt();
            out.copy_from_slice(scaled.as_slice());
        }
    }

    fn displaced(&self) -> f64 {
        let square =
            |row: usize| self.masses[row] * (vector(&self.rows[row]) - self.rest[row]).norm_squared();
        let own = self.share.own(self.rows.len());
        let chunks = own.clone().step_by(CHUNK).map(|first| first..(first + CHUNK).min(own.end));
        let [sum] = self.share.sum(chunks.map(|chunk| [chunk.map(square).sum::<f64>()]));
        sum.sqrt()
    }
}

impl Solid {
    /// `M^{-½} v` of a row, without what supports hold.
    pub(super) fn scaled(&self, row: usize, v: Vec3) -> Vec3 {
        self.free_part(row, v) / self.masses[row].sqrt()
    }
}

/// The boundary of a solid that is dry.
static DRY: BoundaryLayout = BoundaryLayout { points: 0, areas: Vec::new(), thin: None };

impl Solid {
    /// Puts the solid into a fluid, which acts on its nodes from now on; they should be as far apart as the particles of the
    /// fluid. In a plane forces per depth act on its thickness.
    ///
    /// # Errors
    /// [`SolidError::WetSheets`] for a plate of two sheets, [`SolidError::NotShared`] for a solid that several march.
    pub fn wet(&mut self) -> Result<(), SolidError> {
        if self.rest.len() > self.block.len() {
            return Err(SolidError::WetSheets);
        }
        if self.share.is_shared() {
            return Err(SolidError::NotShared("a solid in a fluid"));
        }
        if self.external.is_empty() {
            self.external = vec![Vec3::zeros(); self.rest.len()];
        }
        self.wetted = Some(Box::new(Surface::new(&self.block)));
        Ok(())
    }
}

impl Wetted for Solid {
    fn boundary_layout(&self) -> &BoundaryLayout {
        self.wetted.as_ref().map_or(&DRY, |surface| &surface.layout)
    }

    fn boundary(&self, out: &mut BoundaryState) {
        match &self.wetted {
            Some(surface) => surface.places(&self.rows, out),
            None => *out = BoundaryState::default(),
        }
    }

    fn apply_load(&mut self, load: &BoundaryLoad<'_>) {
        if let Some(surface) = &mut self.wetted {
            surface.take(&self.rows, load);
        }
    }

    fn impedance_impulses(&self, span: f64, impulses: &mut [[f64; 3]]) {
        if let Some(surface) = &self.wetted {
            surface.impedance_impulses(&self.rates, span, impulses);
        }
    }

    fn boundary_velocities(&self, out: &mut Vec<[f64; 3]>) {
        out.clear();
        if self.wetted.is_some() {
            out.extend(self.rates.iter().map(|rate| [rate[0], rate[1], rate[2]]));
        }
    }
}
