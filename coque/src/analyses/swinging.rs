//! What the columns of a curve read of a vibration: each goes with the motion in proportion.

use implicit_statics::Complex;
use sph_core::Vec3;

use super::modes::scaled;
use crate::bodies::{Probe, StaticBody};
use crate::run::Run;
use crate::scene::{Measured, Take};

/// Largest displacement, in reaches of the body (thicknesses), of the states between which columns are differentiated: as of linear answers.
const REACH: f64 = 1e-2;

/// Numbers along a unit of a motion.
pub(super) struct Slopes {
    /// Of all columns.
    pub columns: Vec<f64>,
    /// Of the forces that fields show; none where nobody takes any.
    pub forces: Vec<f64>,
}

/// What drives a vibration, at its level one.
#[derive(Default)]
pub(super) struct Driver {
    /// Numbers that the load itself adds while nothing moves, of all columns.
    pub load: Vec<f64>,
    /// The same of the forces that fields show.
    pub forces: Vec<f64>,
    /// Acceleration of a base; zero without one.
    pub base: Vec3,
    /// Whether displacements and velocities are with respect to space, where the base moves too.
    pub motion_in_space: bool,
    /// Whether accelerations are.
    pub acceleration_in_space: bool,
}

/// Reads columns along motions from the state that vibrates.
pub(super) struct Reader {
    rest: Vec<f64>,
    start: Vec<Vec3>,
    kinds: Vec<Kind>,
    /// Whether forces of fields are read too.
    fields: bool,
}

/// How a column goes with a motion.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// As the motion does.
    Motion,
    /// As its rate does.
    Rate,
    /// As the rate of that does.
    Acceleration,
    /// As a force that strains exert does, damping by stiffness with it, and loads on what is held.
    Force,
}

impl Reader {
    /// Of the present state; of the forces of fields too where that is wanted.
    pub fn new(system: &mut dyn StaticBody, run: &mut Run<'_>, fields: bool) -> Self {
        let kind = |probe: &Probe| match probe.of {
            Measured::Velocity => Kind::Rate,
            Measured::Acceleration => Kind::Acceleration,
            Measured::Displacement | Measured::Rotation | Measured::Director => Kind::Motion,
            _ => Kind::Force,
        };
        let kinds = run.probes.iter().map(kind).collect();
        // Velocities and accelerations are read as the displacement whose rates they are.
        let rates = [Measured::Velocity, Measured::Acceleration];
        for probe in run.probes.iter_mut().filter(|probe| rates.contains(&probe.of)) {
            probe.of = Measured::Displacement;
        }
        let (rest, start) = (system.save(), system.configuration().present);
        Self { rest, start, kinds, fields }
    }

    /// What the loads of a system in the state that vibrates add to its columns; nothing moves with a base yet.
    pub fn driver(&self, system: &mut dyn StaticBody, run: &mut Run<'_>) -> Driver {
        let [off, on] = [0.0, 1.0].map(|level| {
            system.refresh(level);
            self.read(system, run)
        });
        let less = |on: &[f64], off: &[f64]| on.iter().zip(off).map(|(on, off)| on - off).collect();
        Driver { load: less(&on[0], &off[0]), forces: less(&on[1], &off[1]), ..Driver::default() }
    }

    /// The numbers of all columns now, and of the forces of fields.
    fn read(&self, system: &dyn StaticBody, run: &mut Run<'_>) -> [Vec<f64>; 2] {
        let columns = run.probes.iter_mut().flat_map(|probe| probe.parts(system)).collect();
        [columns, if self.fields { system.forces() } else { Vec::new() }]
    }

    /// The slopes along a motion, by central differences over ε and 2ε without the loads.
    pub fn slopes(&self, motion: &[f64], system: &mut dyn StaticBody, run: &mut Run<'_>) -> Slopes {
        let size = motion.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
        if size == 0.0 {
            let [columns, forces] = self.read(system, run).map(|numbers| vec![0.0; numbers.len()]);
            return Slopes { columns, forces };
        }
        let motion = scaled(motion, 1.0 / size);
        // Unknowns are lengths, turns too; a rigid part may carry its places further.
        let reach = REACH * system.linear_reach();
        system.restore(&self.rest);
        system.update(&scaled(&motion, reach));
        let present = system.configuration().present;
        let far = self.start.iter().zip(&present).map(|(from, to)| (to - from).norm()).fold(0.0, f64::max);
        let step = if far > reach { reach * reach / far } else { reach };
        let [ahead, beyond, behind, before] = [1.0, 2.0, -1.0, -2.0].map(|k| {
            system.restore(&self.rest);
            system.update(&scaled(&motion, k * step));
            system.refresh(0.0);
            self.read(system, run)
        });
        system.restore(&self.rest);
        let [columns, forces] = [0, 1].map(|k| {
            let [ahead, beyond, behind, before] = [&ahead[k], &beyond[k], &behind[k], &before[k]];
            let one =
                |i: usize| size * (8.0 * (ahead[i] - behind[i]) - (beyond[i] - before[i])) / (12.0 * step);
            (0..ahead.len()).map(one).collect()
        });
        Slopes { columns, forces }
    }

    /// How each column goes with a motion.
    pub fn kinds(&self) -> &[Kind] {
        &self.kinds
    }

    /// The value of each column, of numbers such as those of slopes.
    pub fn columns(&self, numbers: &[f64], run: &Run<'_>) -> Vec<f64> {
        let mut at = 0;
        let one = |probe: &Probe| {
            let own = at..at + probe.part_count();
            at = own.end;
            probe.of_parts(&numbers[own])
        };
        run.probes.iter().map(one).collect()
    }

    /// The value of each column where motions, each with a factor and with what its strains' forces are times, come together.
    pub fn values<'s>(
        &self,
        driver: &Driver,
        motions: impl Iterator<Item = (&'s Slopes, Complex, Complex)>,
        omega: f64,
        run: &Run<'_>,
    ) -> Vec<Complex> {
        let mut ways = vec![Complex::default(); driver.load.len()];
        let mut forces: Vec<Complex> = driver.load.iter().map(|&load| Complex::new(load, 0.0)).collect();
        for (slopes, factor, kappa) in motions {
            let of_force = factor * kappa;
            for ((way, force), &slope) in ways.iter_mut().zip(&mut forces).zip(&slopes.columns) {
                *way = *way + factor * slope;
                *force = *force + of_force * slope;
            }
        }
        let mut at = 0;
        let columns = run.probes.iter().zip(&self.kinds);
        columns
            .map(|(probe, &kind)| {
                let own = at..at + probe.part_count();
                at = own.end;
                let parts = if kind == Kind::Force { &forces[own] } else { &ways[own] };
                let taken =
                    |part: fn(&Complex) -> f64| probe.of_parts(&parts.iter().map(part).collect::<Vec<_>>());
                let value =
                    Complex::new(taken(|z| z.re), taken(|z| z.im)) + of_base(driver, (probe, kind), omega);
                match kind {
                    Kind::Rate => value * Complex::new(0.0, omega),
                    Kind::Acceleration => value * (-omega * omega),
                    Kind::Motion | Kind::Force => value,
                }
            })
            .collect()
    }
}

/// What the base moves by itself, `−a/ω²`, where that is asked for.
fn of_base(driver: &Driver, (probe, kind): (&Probe, Kind), omega: f64) -> Complex {
    let in_space =
        if kind == Kind::Acceleration { driver.acceleration_in_space } else { driver.motion_in_space };
    if !in_space || probe.of != Measured::Displacement {
        return Complex::default();
    }
    Complex::new(-moved_with(&driver.base, probe) / (omega * omega), 0.0)
}

/// What a column of displacement reads where all of the body moves by such a way.
pub(super) fn moved_with(way: &Vec3, probe: &Probe) -> f64 {
    let times = if probe.take == Take::Sum { probe.particles.len() as f64 } else { 1.0 };
    probe.factor * times * way.dot(&probe.direction)
}
