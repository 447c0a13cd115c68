//! Marches of a gas between springs, and what they note.

use explicit_dynamics::{Clock, Event, March, MarchError, MarchState, Record, Transient, TwoClocks};

use crate::model::{Column, Spring};

pub const CELLS: usize = 50;
pub const COURANT: f64 = 0.3;
pub const MASS: f64 = 0.05;
pub type Coupled = TwoClocks<Column, Spring>;

/// Records, and where the march stood after some steps with all that changes.
#[derive(Default)]
pub struct Notes {
    pub records: Vec<Record>,
    pub ends: Vec<f64>,
    /// Balance of the first structure.
    pub balances: Vec<f64>,
    pub keep_at: Option<u64>,
    pub kept: Option<(MarchState, Vec<Vec<f64>>)>,
}

impl Notes {
    /// Leads a march to its end.
    pub fn lead(&mut self, mut march: March, system: &mut Coupled) -> Result<Clock, MarchError> {
        loop {
            match march.advance(system)? {
                Event::Record(record) => {
                    self.records.push(record);
                    self.ends.extend(system.structures().next().map(|spring| spring.x));
                    self.balances.extend(system.energy(0).map(|energy| energy.error(0.0)));
                }
                Event::End => return Ok(march.clock().clone()),
                _ => {}
            }
            if let Some(at) = march.state().filter(|at| self.keep_at == Some(at.clock.steps)) {
                self.kept = Some((at.clone(), state(system)));
            }
        }
    }
}

pub fn state(system: &Coupled) -> Vec<Vec<f64>> {
    let springs = system.structures().map(|spring| vec![spring.x, spring.v]);
    [system.state(), system.fluid().state()].into_iter().chain(springs).collect()
}

pub fn take_up(system: &mut Coupled, kept: &[Vec<f64>]) {
    assert!(system.set_state(&kept[0]));
    system.fluid_mut().set_state(&kept[1]);
    for (spring, numbers) in system.structures_mut().zip(&kept[2..]) {
        (spring.x, spring.v) = (numbers[0], numbers[1]);
    }
}

/// A spring at the left end, pulled out, that turns by `turn` within a step of the gas and takes `substeps` of its own.
pub fn one_spring(turn: f64, substeps: u32) -> Coupled {
    let fluid = Column::new(CELLS, COURANT);
    let dt = fluid.dt;
    let spring = Spring::new(MASS, MASS * (turn / dt).powi(2), dt / f64::from(substeps));
    TwoClocks::new(fluid, vec![Box::new(spring.at(1e-5))])
}

pub fn transient(system: &Coupled, steps: usize, every: usize) -> Transient {
    let dt = system.fluid().dt;
    Transient { duration: steps as f64 * dt, record_every: every as f64 * dt, damping: 0.0, safety: 0.9 }
}

pub fn march(system: &mut Coupled, steps: usize, every: usize) -> (Notes, Result<Clock, MarchError>) {
    let mut notes = Notes::default();
    let march = March::start(transient(system, steps, every), system);
    let end = march.and_then(|march| notes.lead(march, system));
    (notes, end)
}
