//! Which particles, method and analysis reach an accuracy: runs of the scene on ever finer lattices tell how its own answers
//! converge.
//!
//! No table of other problems is asked: the scene runs on lattices from coarse to fine, as far as the time given allows, and
//! the differences of its own answers give order and error (`convergence.rs`). Where the accuracy lies beyond what was run,
//! the order tells the lattice, the growth of the run times the time. What converges is the answer of the model: what a
//! shell leaves out of a solid does not show.
//!
//! The error of every number of a run is found the same way, from two lattices beside its own (`errors.rs`): coarser ones where every set that
//! the scene names stays on particles (`kept.rs`, `companions.rs`), rows paired by level, time, path or shape (`pairing.rs`), each number with
//! its bar (`bars.rs`). Without time the levels of other lattices begin at those of the run (`nested.rs`, `between.rs`).

mod answers;
mod bars;
mod between;
mod companions;
mod convergence;
mod errors;
mod found;
mod graded;
mod kept;
mod ladder;
mod meshes;
mod methods;
mod nested;
mod pairing;
mod probes;
mod refined;
mod rewritten;
mod said;

use std::ops::ControlFlow;
use std::time::Duration;

pub use bars::{OF_FLUIDS, OF_OTHERS, OnLattice, bar, order_of};
pub use companions::Companions;
pub use convergence::Convergence;
pub use graded::Graded;
pub use ladder::{ClimbError, Ladder, Rung};
pub use refined::Refined;

use crate::bodies::memory::memory;
use crate::scene::Checked;

/// Particles beyond which nothing is predicted, as no scene may have more.
const MOST_PARTICLES: f64 = 1e7;

/// Why load cases have no errors of their numbers.
const OF_CASES: &str = "errors are found of one answer, and each load case is one; run the scene with the loads of one case, without `case`";

/// What is asked of a forecast.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// Greatest error allowed, as a share of the greatest value of each column \[–\].
    pub accuracy: f64,
    /// Time for the runs of each method.
    pub within: Duration,
    /// Most lattices that each method is run on.
    pub lattices: usize,
    /// Threads of a run.
    pub threads: usize,
}

/// What one method and analysis will take for the accuracy asked.
#[derive(Clone, Debug)]
pub struct Forecast {
    /// Method and analysis in words.
    pub method: String,
    /// The runs that were made.
    pub ladder: Ladder,
    /// What reaches the accuracy; none where it cannot be estimated.
    pub needed: Option<Needed>,
}

/// A lattice that reaches the accuracy, and its cost.
#[derive(Clone, Debug, PartialEq)]
pub struct Needed {
    /// The lattice in words.
    pub lattice: String,
    /// Spacing over that of the scene as it was given \[–\].
    pub spacing: f64,
    /// Particles or nodes.
    pub particles: f64,
    /// Estimated error, as a share of the answer \[–\].
    pub error: f64,
    /// Wall time \[s\].
    pub seconds: f64,
    /// Memory \[bytes\].
    pub memory: f64,
    /// Whether it was run; else it is predicted.
    pub ran: bool,
}

impl Checked {
    /// What its own method and others with the same answer will take for an accuracy; `tell` hears of every run and
    /// may end the forecast, which then rests on what was run.
    ///
    /// # Errors
    /// [`ClimbError`] if the scene itself is refused, measures nothing or has load cases; other methods that fail are left out.
    pub fn forecast(
        &self,
        asked: &Asked,
        tell: &mut dyn FnMut(&str, &Rung) -> ControlFlow<()>,
    ) -> Result<Vec<Forecast>, ClimbError> {
        if !self.cases().is_empty() {
            return Err(ClimbError::Silent(OF_CASES.into()));
        }
        let mut forecasts = Vec::new();
        let mut flow = ControlFlow::Continue(());
        for (method, scene) in methods::methods(self) {
            if flow.is_break() {
                break;
            }
            let mut tell = |rung: &Rung| {
                flow = tell(&method, rung);
                flow
            };
            match Ladder::climb(&scene, asked, &mut tell) {
                Ok(ladder) => {
                    let needed = needed(&scene, &ladder, asked.accuracy);
                    forecasts.push(Forecast { method, ladder, needed });
                }
                Err(error) if forecasts.is_empty() => return Err(error),
                Err(_) => {}
            }
        }
        Ok(forecasts)
    }
}

impl Checked {
    /// The scene on a lattice of all its bodies, a fluid among them, whose spacing is about so many of its own, whole numbers of particles along every
    /// length.
    ///
    /// # Errors
    /// In words: a scene that has no such lattice.
    pub fn alike(&self, spacing: f64, threads: usize) -> Result<Refined, String> {
        companions::alike(self, spacing, threads)
    }

    /// Why no lattice of its can be forecast, in words; none where one can.
    pub fn unforeseen(&self) -> Option<&'static str> {
        if self.as_shell().is_some_and(|shell| shell.geometry.mesh().is_some()) {
            return Some("a surface from a file has no lattice to forecast");
        }
        (self.fluid().is_some() || self.bodies.len() > 1)
            .then_some("a fluid or several bodies have no lattice to forecast")
    }
}

/// The coarsest lattice from which on all reach the accuracy; else the one on which the order of convergence has it.
fn needed(scene: &Checked, ladder: &Ladder, accuracy: f64) -> Option<Needed> {
    let reaches = |rung: &&Rung| rung.error.is_some_and(|error| error <= accuracy);
    if let Some(rung) = ladder.rungs.iter().rev().take_while(reaches).last() {
        return Some(Needed {
            lattice: rung.lattice.clone(),
            spacing: rung.spacing,
            particles: rung.particles as f64,
            error: rung.error?,
            seconds: rung.seconds,
            memory: rung.memory,
            ran: true,
        });
    }
    let (found, _) = ladder.finest.as_ref()?;
    let last = ladder.rungs.last()?;
    let refined = scene.refined(1.0 / (last.spacing * found.spacing_for(accuracy))).ok()?;
    let finer = last.spacing / refined.spacing;
    let body = scene.bodies.values().next()?;
    let particles = last.particles as f64 * libm::pow(finer, refined::dimensions(scene));
    (particles <= MOST_PARTICLES).then(|| Needed {
        lattice: refined.lattice,
        spacing: refined.spacing,
        particles,
        error: found.error * libm::pow(finer, -found.order),
        seconds: ladder.seconds_at(finer),
        memory: memory(&scene.analysis, body, particles),
        ran: false,
    })
}
