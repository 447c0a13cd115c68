//! What a system offers to others that act on it, and what acts between systems.

use std::any::Any;

use crate::equilibrium::Equilibrium;

/// A system of particles on which others act.
pub trait Joinable: Equilibrium {
    /// Positions \[L\] of some particles in the present state. A system whose particles have directors may number those as places of unit length
    /// behind its particles: here and in what follows.
    fn places(&self, particles: &[u32], out: &mut [[f64; 3]]);

    /// Puts what is prescribed of it where a level has that.
    fn put(&mut self, level: f64);

    /// Takes away all forces that others exert.
    fn release(&mut self);

    /// Exerts forces on some particles \[F\] beside those that others exert, whatever the level, until they are taken away.
    fn exert(&mut self, particles: &[u32], forces: &[[f64; 3]]);

    /// Each unknown that moves a particle, always the same ones, with the velocity of the particle for a unit of it.
    fn motion_of(&self, particle: u32) -> Vec<(usize, [f64; 3])>;
}

/// What several systems do to each other: an energy of the places of some of their particles.
///
/// Those are numbered through in the order of [`Interaction::particles`], system after system. Whoever made it may read it again by its type.
pub trait Interaction: Any + Send {
    /// Particles on which it acts, a list for each system; it never changes.
    fn particles(&self) -> Vec<Vec<u32>>;

    /// Puts what is prescribed of it where a level has that.
    fn put(&mut self, _level: f64) {}

    /// Whether it goes with the level and is stiff, as a tool that moves is ([`Equilibrium::has_moving_tools`]).
    fn moves(&self) -> bool {
        false
    }

    /// Pairs of places that share a block of its tangent, each once, and places with themselves; the same ones until
    /// [`Interaction::pairs_changed`] says otherwise.
    fn pairs(&self) -> Vec<[usize; 2]>;

    /// Finds the pairs of present places; whether they are others than before.
    fn pairs_changed(&mut self, _places: &[[f64; 3]]) -> bool {
        false
    }

    /// The share of the way from places to others by which they may move at once, one at most ([`Equilibrium::reach`]).
    fn reach(&self, _here: &[[f64; 3]], _there: &[[f64; 3]]) -> f64 {
        1.0
    }

    /// Whether it has a history, on which its tangent depends ([`Equilibrium::tangent_is_of_the_step`]).
    fn remembers(&self) -> bool {
        false
    }

    /// Its committed history, as it stands in a saved state.
    fn history(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Takes up what [`Interaction::history`] gave.
    fn recall(&mut self, _history: &[f64]) {}

    /// Makes the history of places, those last evaluated, the one that counts: they are an accepted state.
    fn commit(&mut self, _places: &[[f64; 3]]) {}

    /// Energy lost at a place until the last commit \[F L\].
    fn lost_at(&self, _place: usize) -> f64 {
        0.0
    }

    /// What belongs to a state beside the unknowns of the systems.
    fn kept(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Takes up what [`Interaction::kept`] gave; false if it is that of another.
    fn take_up(&mut self, kept: &[f64]) -> bool {
        kept.is_empty()
    }

    /// Fills in the forces at present places; returns its energy \[F L\].
    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64;

    /// Fills in by how much its forces change with the level at places, those last evaluated; false where nothing of it is prescribed \[F\].
    fn rates(&self, _places: &[[f64; 3]], _rates: &mut [[f64; 3]]) -> bool {
        false
    }

    /// Whether forces that come about where supports of the systems lead its places count in what a unit of level adds: of what is joined
    /// as if it were one.
    fn is_led(&self) -> bool {
        false
    }

    /// Second derivatives of its energy at places, those last evaluated, a block for each of [`Interaction::pairs`] \[F/L\].
    fn stiffness(&self, places: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]);

    /// The same at places here, with the forces that act at places there, a small motion away, and without its change of shape: what is as stiff as
    /// a constraint would else soften by the square of that change.
    fn stressed(&self, _here: &[[f64; 3]], there: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        self.stiffness(there, blocks);
    }
}
