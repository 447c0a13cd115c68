//! What a shell encloses, as it is read from the shell.

use crate::Shell;
use crate::conditions::body::Body;

impl Shell {
    /// What loads see of it in the present state.
    pub(crate) fn loaded(&self) -> Body<'_> {
        self.dependents.loaded(&self.reference, &self.motion.state)
    }

    /// Pressure \[F/L²\] and volume \[L³\] last evaluated of what is enclosed by cells of a particle, pressures summed; zero where nothing is.
    pub fn enclosed_at(&self, particle: usize) -> [f64; 2] {
        let enclosed = self.loading.enclosed(1.0).map(|(enclosed, _)| enclosed);
        let own = enclosed.filter(|enclosed| enclosed.touches(particle as u32));
        own.fold([0.0; 2], |[pressure, volume], enclosed| {
            let [more, own] = enclosed.last();
            [pressure + more, volume + own]
        })
    }

    /// Least pressure and greatest magnitude of all that is enclosed in the states that were kept \[F/L²\]: a part of the state of a run; empty where
    /// nothing is.
    pub fn enclosed_extremes(&self) -> Vec<f64> {
        self.loading.enclosed(1.0).flat_map(|(enclosed, _)| enclosed.extremes()).collect()
    }

    /// Takes that up; false, and nothing done, if it is that of another shell.
    pub fn take_up_extremes(&mut self, extremes: &[f64]) -> bool {
        let fits = extremes.len() == 2 * self.loading.enclosed(1.0).count();
        if fits {
            let kept = self.loading.enclosed(1.0).zip(extremes.as_chunks::<2>().0);
            kept.for_each(|((enclosed, _), extremes)| enclosed.take_up(*extremes));
        }
        fits
    }

    /// How far the pressure of an enclosed liquid fell below that of the surroundings in states that were kept, and its greatest magnitude
    /// \[F/L²\].
    pub fn pulling_liquid(&self) -> Option<[f64; 2]> {
        self.loading.enclosed(1.0).find_map(|(enclosed, _)| enclosed.pull())
    }
}
