//! What a discrete system must offer to be solved without time.

use crate::bounds::OutOfBounds;
use crate::rank_one::RankOne;

/// What touches in a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Front {
    /// A number of the set of all that touches: another one of another set.
    pub set: u64,
    /// Greatest depth over the distance at which faces touch \[–\].
    pub depth: f64,
}

/// A system whose equilibria `internal(q, λ) = external(q, λ)` are sought.
///
/// Unknowns are the free degrees of freedom only: held ones are eliminated by the system, and stand where the level
/// puts them. A state may live on a manifold (directors on spheres): increments are taken in the tangent space of the
/// present state and [`Equilibrium::update`] moves along it.
pub trait Equilibrium {
    /// Number of free degrees of freedom.
    fn unknowns(&self) -> usize;

    /// Positions `(row, column)` of the tangent's entries, lower triangle with the whole diagonal, each once.
    ///
    /// The same for every state until [`Equilibrium::pattern_changed`] says otherwise; the tangent's values come in this order.
    fn pattern(&self) -> Vec<(usize, usize)>;

    /// Whether the tangent of the present state, held values at level λ, has another pattern than the one before: where parts that touch
    /// have found other partners. Asked for before the tangent; false, the default, where the pattern is known beforehand.
    fn pattern_changed(&mut self, _level: f64) -> bool {
        false
    }

    /// Places of the unknowns, in units in which they couple about equally far along all axes: the factor is then ordered by
    /// them. Worth it where every unknown couples with very many others; None, the default, orders by the pattern alone.
    fn coordinates(&self) -> Option<Vec<[f64; 3]>> {
        None
    }

    /// The six rigid motions at the present state, a row an unknown: what it does while the body moves by a unit along x, y, z and
    /// turns by a unit about the axes through the origin, whatever supports hold. An iterative solution is built on them; None, the
    /// default, where the system does not tell.
    fn rigid_motions(&self) -> Option<Vec<[f64; 6]>> {
        None
    }

    /// `out = ∂U/∂q` at the present unknowns \[F, F L\], held values at level λ.
    fn internal(&mut self, level: f64, out: &mut [f64]);

    /// `out = external(q, λ)`, the loads at level λ, held values there too.
    fn external(&mut self, level: f64, out: &mut [f64]);

    /// `out = ∂(external − internal)/∂λ` at fixed unknowns: the loads, and the pull of held values that move.
    fn load_rate(&mut self, level: f64, out: &mut [f64]);

    /// Values of the symmetric tangent `∂(internal − external)/∂q` in the order of the pattern, held values at level λ;
    /// the part of a follower load that is not symmetric is symmetrised: critical points are then those of the symmetric
    /// part.
    fn tangent(&mut self, level: f64, values: &mut [f64]);

    /// What the tangent at the present state has beside its pattern, held values at level λ: where one number, as the pressure of what is
    /// enclosed, depends on all that encloses it. Asked for after the tangent; none, the default, of most systems.
    fn beside_pattern(&mut self, _level: f64) -> Vec<RankOne> {
        Vec::new()
    }

    /// Whether Newton's method goes on with the factor of an iterate before as long as the residual falls fast: worth it where
    /// tangent and factor cost many times what forces do.
    fn keeps_factor(&self) -> bool {
        false
    }

    /// Whether the tangent at the present state depends on where the step to it began, which [`Equilibrium::commit`] forgets: a
    /// factor of the end of a step is then none of the start of the next.
    fn tangent_is_of_the_step(&self) -> bool {
        false
    }

    /// Whether held values depend on the level. Load steps are then predicted by [`Equilibrium::load_rate`], so that
    /// the rest of the system goes along instead of being torn.
    fn has_moving_supports(&self) -> bool {
        false
    }

    /// Takes note of a converged state that is kept: a history is committed here. Called again for the same state, it
    /// must change nothing.
    fn commit(&mut self) {}

    /// How far the present state takes what may break: the greatest of measures that are one at a limit and grow about in
    /// proportion to the load; zero, the default, where nothing breaks.
    fn utilisation(&mut self) -> f64 {
        0.0
    }

    /// Breaks what the present state takes furthest, and whatever is taken as far but for rounding, for good: neither
    /// [`Equilibrium::restore`] makes it whole. Returns the energy that it takes to bring them to their limits, at most what they hold \[F L\].
    fn break_critical(&mut self) -> f64 {
        0.0
    }

    /// `out[i] = Σⱼ |K_ij|` over the unknowns, a bound of the spectrum for `relax`. The default assembles the
    /// tangent; a model may do without. Where parts turn far, unknowns that turn into each other take the largest sum of
    /// theirs: equal masses commute with rotations, and the bound holds on the way.
    fn row_sums(&mut self, level: f64, out: &mut [f64]) {
        self.pattern_changed(level);
        let pattern = self.pattern();
        let mut values = vec![0.0; pattern.len()];
        self.tangent(level, &mut values);
        row_sums(&pattern, &values, out);
        let ones = vec![1.0; out.len()];
        self.beside_pattern(level).iter().for_each(|term| term.add_magnitudes(&ones, out));
    }

    /// The tangent of the present, unstressed configuration with the stresses that a motion would bring: what
    /// [`crate::Prebuckling::Stress`] differentiates. False, and nothing done, where the system does not offer it.
    fn stressed_tangent(&mut self, _level: f64, _motion: &[f64], _values: &mut [f64]) -> bool {
        false
    }

    /// The tangent after a motion from the present state, held values going from the first level to the second, in unknowns
    /// that turn with the structure on the way: what [`crate::Prebuckling::Rotations`] differentiates. The state is put
    /// back. Any choice is a congruence `Rᵀ K R` that is singular where K is; the better the turn is followed, the less the
    /// second derivative counts. The default keeps the unknowns as they are.
    fn turned_tangent(&mut self, [_, level]: [f64; 2], motion: &[f64], values: &mut [f64]) {
        let rest = self.save();
        self.update(motion);
        self.tangent(level, values);
        self.restore(&rest);
    }

    /// Norm of what stresses that go with the level, those of heat, exert at a level, part by part before they cancel \[F\]. What is left of them may
    /// be rounding, and passes for balance then; and the energy depends on the level at fixed unknowns. Zero, the default, without heat.
    fn stress_forces(&self, _level: f64) -> f64 {
        0.0
    }

    /// Norm of the forces that bring prescribed values about \[F\], for the internal forces last evaluated: the scale of
    /// residuals where little else is loaded. Zero without prescribed values.
    fn driving_force(&self) -> f64 {
        0.0
    }

    /// The share of an increment, one at most, by which the state may move at once: less than one where parts that may touch would leap
    /// through each other. One, the default, where there are none.
    fn reach(&mut self, _increment: &[f64]) -> f64 {
        1.0
    }

    /// Whether tools that may touch it go with the level: a relaxation brings them along as it does held values, and what they would press if
    /// nothing gave way is no scale of Newton's residuals.
    fn has_moving_tools(&self) -> bool {
        false
    }

    /// `out` as of [`Equilibrium::external`] without the forces of contact, which have an energy of their own.
    fn external_without_contact(&mut self, level: f64, out: &mut [f64]) {
        self.external(level, out);
    }

    /// Energy of the contact in the external forces last evaluated \[F L\].
    fn contact_energy(&self) -> f64 {
        0.0
    }

    /// Lengths over which softened contact gives, longest first, for Newton's method to find what touches in stages \[L\]; none, the
    /// default, where nothing touches or softening tells nothing.
    fn stages_of_contact(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Softens contact so that it gives over a length at least; none: back to its own stiffness.
    fn soften_contact(&mut self, _length: Option<f64>) {}

    /// What touches in the present state, tools and held values at level λ.
    fn front(&mut self, _level: f64) -> Front {
        Front::default()
    }

    /// Moves the state by an increment in its present tangent space.
    fn update(&mut self, increment: &[f64]);

    /// Moves the state along a motion and carries the motion into the new tangent space: it goes straight on. The
    /// default suits states that are vectors or carry their axes along.
    fn transport(&mut self, motion: &mut [f64]) {
        self.update(motion);
    }

    /// `out` = the motion in the tangent space of the present state that leads to a saved one; false, and nothing done, where
    /// the system does not offer it. Paths are then predicted along their bend as well as their tangent.
    fn motion_to(&self, _saved: &[f64], _out: &mut [f64]) -> bool {
        false
    }

    /// A copy of the state with its history, to come back to.
    fn save(&self) -> Vec<f64>;

    /// Comes back to a saved state.
    fn restore(&mut self, saved: &[f64]);

    /// Internal energy of the present state \[F L\].
    fn energy(&mut self) -> f64;

    /// Diagonal mass of each unknown \[M, M L²\].
    fn masses(&self) -> Vec<f64>;

    /// The same for modes of vibration, where a system has masses that integrate better and yet give no step in time.
    fn vibrating_masses(&self) -> Vec<f64> {
        self.masses()
    }

    /// What an unknown is, for messages: the particle or node, and the direction.
    fn name_unknown(&self, unknown: usize) -> String;

    /// Refuses a state outside the range of the model, such as an element turned inside out, though it balances.
    ///
    /// # Errors
    /// The place and the number that is out of bounds.
    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        Ok(())
    }
}

/// Sums over the rows of |K|, given by its lower triangle.
pub fn row_sums(pattern: &[(usize, usize)], values: &[f64], out: &mut [f64]) {
    out.fill(0.0);
    for (&(row, column), value) in pattern.iter().zip(values) {
        out[row] += value.abs();
        if row != column {
            out[column] += value.abs();
        }
    }
}
