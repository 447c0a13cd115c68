//! Starts of one lattice from the equilibria of another: what the state changes by from one level to the next, carried over.
//!
//! A lattice that is begun so need not go through every level: it is balanced at few of them, and what the two lattices differ by is a cubic of
//! the level between.

use super::between::Between;
use super::pairing::between_rows;
use crate::results::curve::Curve;
use crate::run::outcome::Outcome;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, Checked, Levels, Scene};

/// Levels at which another lattice is balanced: with the start they give each stretch its cubic.
const BALANCED: usize = 4;
/// The column that tells how many negative pivots the tangent has.
const PIVOTS: &str = "negative_pivots";

/// The states of a run without time at its start and its levels, on a lattice.
pub(super) struct Nested<'a> {
    particles: [usize; 2],
    states: &'a [Vec<f64>],
    levels: Vec<f64>,
}

/// A scene on another lattice whose levels are begun from states of this one.
pub(super) struct Begun {
    /// The scene, with the levels that are to be balanced.
    pub scene: Checked,
    /// Rows of the run that are those of its levels, the start first.
    pub rows: Vec<usize>,
    /// Changes of its state from level to level.
    pub increments: Vec<Vec<f64>>,
}

impl<'a> Nested<'a> {
    /// Of a run of one shell on a lattice, all of whose levels were kept; none where the run met critical points, which another lattice is to find
    /// by itself.
    pub fn of(scene: &Checked, outcome: &'a Outcome) -> Option<Self> {
        let Analysis::Static(wanted) = &scene.analysis else { return None };
        let particles = scene.as_shell()?.geometry.particles()?;
        let (states, levels) = (&outcome.states[..], wanted.levels.list());
        let numbers = 6 * particles[0] * particles[1];
        let whole = states.len() == levels.len() + 1 && states.len() == outcome.curve.rows.len();
        let fits = whole && states.iter().all(|state| state.len() == numbers);
        let plain = outcome.summary.record.critical.is_empty() && scene.bodies.len() == 1;
        (fits && plain).then_some(Self { particles, states, levels })
    }

    /// Another lattice, balanced at few levels where they grow, at all where they do not.
    ///
    /// # Errors
    /// [`SceneError`] of the checks.
    pub fn begun(&self, other: &Checked) -> Result<Begun, SceneError> {
        let count = self.levels.len();
        let grow = self.levels.windows(2).all(|pair| pair[1] > pair[0]) && self.levels[0] > 0.0;
        let step = if grow { count.div_ceil(BALANCED) } else { 1 };
        // Counted from the last, which is one of them.
        self.begun_at(other, (1..=count).filter(|row| (count - row).is_multiple_of(step)).collect())
    }

    /// Another lattice, balanced at the last level only.
    ///
    /// # Errors
    /// [`SceneError`] of the checks.
    pub fn begun_at_last(&self, other: &Checked) -> Result<Begun, SceneError> {
        self.begun_at(other, vec![self.levels.len()])
    }

    fn begun_at(&self, other: &Checked, balanced: Vec<usize>) -> Result<Begun, SceneError> {
        let mut scene = Scene::clone(other);
        if let Analysis::Static(wanted) = &mut scene.analysis {
            wanted.levels = Levels::List(balanced.iter().map(|row| self.levels[row - 1]).collect());
        }
        let particles = other.as_shell().and_then(|shell| shell.geometry.particles());
        let between = Between::new(self.particles, particles.unwrap_or(self.particles));
        let rows: Vec<usize> = std::iter::once(0).chain(balanced).collect();
        let increment = |pair: &[usize]| {
            let [from, to] = [&self.states[pair[0]], &self.states[pair[1]]];
            between.carried(&to.iter().zip(from).map(|(to, from)| to - from).collect::<Vec<f64>>())
        };
        let increments = rows.windows(2).map(increment).collect();
        Ok(Begun { scene: scene.check()?, rows, increments })
    }
}

impl Begun {
    /// Whether the equilibria are as stable as those of the run: they are then taken to be of one branch.
    pub fn is_alike(&self, own: &Curve, found: &Curve) -> bool {
        let pivots = own.columns.iter().position(|column| column.name == PIVOTS);
        // At the start no tangent is made.
        let mut pairs = self.rows.iter().zip(&found.rows).skip(1);
        pivots.is_none_or(|at| pairs.all(|(row, found)| own.rows[*row][at] == found[at]))
    }

    /// The curve at all rows of the run: that of the run and the difference from it, a cubic between the rows that were balanced.
    pub fn at_all(&self, own: &Curve, found: &Curve) -> Curve {
        let place = |row: &usize| own.rows[*row].first().copied().unwrap_or(0.0);
        let known = &self.rows[..found.rows.len().min(self.rows.len())];
        let places: Vec<f64> = known.iter().map(place).collect();
        let off = |(row, found): (&usize, &Vec<f64>)| {
            found.iter().zip(&own.rows[*row]).map(|(found, own)| found - own).collect::<Vec<f64>>()
        };
        let differences: Vec<Vec<f64>> = known.iter().zip(&found.rows).map(off).collect();
        let mut whole = Curve { columns: found.columns.clone(), rows: Vec::new() };
        for (row, own_row) in own.rows.iter().enumerate() {
            if let Some(at) = known.iter().position(|&known| known == row) {
                whole.rows.push(found.rows[at].clone());
            } else if let Some(difference) = between_rows(&places, &differences, place(&row)) {
                whole.rows.push(own_row.iter().zip(&difference).map(|(own, off)| own + off).collect());
            }
        }
        whole
    }
}
