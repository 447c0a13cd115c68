//! All of a fluid that changes: from that a run goes on to the same bits.

use std::borrow::Cow;

use sph_core::Vec3;

use crate::error::FluidError;
use crate::fluid::Fluid;

fn flat(list: &[Vec3]) -> Cow<'static, [f64]> {
    Cow::Owned(list.iter().flat_map(|v| [v.x, v.y, v.z]).collect())
}

fn put(list: &mut [Vec3], numbers: &[f64]) {
    list.iter_mut().zip(numbers.chunks_exact(3)).for_each(|(v, n)| *v = Vec3::new(n[0], n[1], n[2]));
}

impl Fluid {
    /// The arrays that change, by name.
    pub fn state(&self) -> Vec<(&'static str, Cow<'_, [f64]>)> {
        let (present, boundary, ledger) = (self.shown(), &self.boundary, &self.ledger);
        let ledger = vec![
            ledger.viscous,
            ledger.diffusion,
            ledger.external,
            ledger.dissipated,
            ledger.density_error,
            self.fastest,
            boundary.ledger.time,
        ];
        let forces = boundary.forces.as_flattened();
        let mut arrays = vec![
            ("positions", flat(&present.positions)),
            ("velocities", flat(&present.velocities)),
            ("densities", Cow::Borrowed(&present.densities)),
            ("boundary_positions", flat(&boundary.points)),
            ("boundary_velocities", flat(&boundary.velocities)),
            ("boundary_densities", Cow::Borrowed(&boundary.densities)),
            ("boundary_forces", Cow::Borrowed(forces)),
            ("boundary_owed", Cow::Borrowed(&boundary.ledger.owed)),
            ("thin_boundaries", Cow::Owned(boundary.thin.iter().flat_map(|thin| thin.state()).collect())),
            ("ledger", Cow::Owned(ledger)),
        ];
        if let Some(periodic) = &self.periodic {
            arrays.push(("gone", Cow::Borrowed(periodic.gone.as_flattened())));
        }
        if let Some(openings) = &self.openings {
            arrays.push(("openings", Cow::Owned(openings.state())));
        }
        arrays
    }

    /// Puts the arrays of [`Fluid::state`] back.
    ///
    /// # Errors
    /// [`FluidError::State`] for an array that is missing or of another length; nothing is changed then.
    pub fn set_state(&mut self, arrays: &[(&str, &[f64])]) -> Result<(), FluidError> {
        let mut found: Vec<&[f64]> = Vec::new();
        for (name, own) in self.state() {
            let array = arrays.iter().find(|(given, numbers)| *given == name && numbers.len() == own.len());
            found.push(array.ok_or(FluidError::State(name))?.1);
        }
        let [
            positions,
            velocities,
            densities,
            points,
            point_velocities,
            point_densities,
            forces,
            owed,
            thin,
            ledger,
            ref rest @ ..,
        ] = found[..]
        else {
            return Err(FluidError::State("ledger"));
        };
        let Self { present, boundary, ledger: own, share, periodic, openings, .. } = self;
        let present = share.shared_mut().map_or(present, |shared| &mut shared.whole);
        if let (Some(periodic), [gone, ..]) = (periodic, rest) {
            periodic.gone.as_flattened_mut().copy_from_slice(gone);
        }
        if let (Some(openings), [.., numbers]) = (openings, rest) {
            openings.set_state(numbers);
        }
        put(&mut present.positions, positions);
        put(&mut present.velocities, velocities);
        present.densities.copy_from_slice(densities);
        put(&mut boundary.points, points);
        put(&mut boundary.velocities, point_velocities);
        boundary.densities.copy_from_slice(point_densities);
        boundary.forces.as_flattened_mut().copy_from_slice(forces);
        boundary.ledger.owed.copy_from_slice(owed);
        let mut rest = thin;
        for part in &mut boundary.thin {
            let (own, after) = rest.split_at(part.state_len());
            part.set_state(own);
            rest = after;
        }
        if let [viscous, diffusion, external, dissipated, density_error, fastest, time] = *ledger {
            boundary.ledger.time = time;
            (own.viscous, own.diffusion, own.external) = (viscous, diffusion, external);
            (own.dissipated, own.density_error, self.fastest) = (dissipated, density_error, fastest);
        }
        boundary.advance = 0.0;
        boundary.forget_put_off();
        self.fresh = false;
        self.deal_out(false);
        Ok(())
    }
}
