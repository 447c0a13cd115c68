//! What the columns of a curve read of a steady vibration: each goes with the motion in proportion.

use implicit_statics::Complex;
use sph_core::Vec3;

use super::super::modes::scaled;
use crate::bodies::{Probe, StaticBody};
use crate::run::Run;
use crate::scene::{BaseResponse, Measured, ShakenBase, Take};

/// Largest displacement, in reaches of the body (thicknesses), of the states between which columns are differentiated: as of linear answers.
const REACH: f64 = 1e-2;

/// Numbers of all columns along a unit of a motion.
pub(super) struct Slopes(Vec<f64>);

/// Reads columns along motions from the state that vibrates.
pub(super) struct Reader {
    rest: Vec<f64>,
    start: Vec<Vec3>,
    /// Numbers that the load itself adds, at its level one, while nothing moves.
    load: Vec<f64>,
    kinds: Vec<Kind>,
    base: Option<ShakenBase>,
}

/// How a column goes with a motion.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// As the motion does.
    Motion,
    /// As its rate does.
    Rate,
    /// As a force that strains exert does, damping by stiffness with it, and loads on what is held.
    Force,
}

impl Reader {
    /// Of the present state, with the loads of the analysis off.
    pub fn new(base: Option<ShakenBase>, system: &mut dyn StaticBody, run: &mut Run<'_>) -> Self {
        let kind = |probe: &Probe| match probe.of {
            Measured::Velocity => Kind::Rate,
            Measured::Displacement | Measured::Rotation | Measured::Director => Kind::Motion,
            _ => Kind::Force,
        };
        let kinds = run.probes.iter().map(kind).collect();
        // A velocity is read as the displacement whose rate it is.
        for probe in run.probes.iter_mut().filter(|probe| probe.of == Measured::Velocity) {
            probe.of = Measured::Displacement;
        }
        let (rest, start) = (system.save(), system.configuration().present);
        let mut reader = Self { rest, start, load: Vec::new(), kinds, base };
        let [off, on] = [0.0, 1.0].map(|level| {
            system.refresh(level);
            reader.read(system, run)
        });
        reader.load = on.iter().zip(&off).map(|(on, off)| on - off).collect();
        reader
    }

    /// The numbers of all columns now.
    fn read(&self, system: &dyn StaticBody, run: &mut Run<'_>) -> Vec<f64> {
        run.probes.iter_mut().flat_map(|probe| probe.parts(system)).collect()
    }

    /// The slopes along a motion, by central differences over ε and 2ε without the loads.
    pub fn slopes(&mut self, motion: &[f64], system: &mut dyn StaticBody, run: &mut Run<'_>) -> Slopes {
        let size = motion.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
        if size == 0.0 {
            return Slopes(vec![0.0; self.load.len()]);
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
        let one = |i: usize| size * (8.0 * (ahead[i] - behind[i]) - (beyond[i] - before[i])) / (12.0 * step);
        Slopes((0..ahead.len()).map(one).collect())
    }

    /// The value of each column where motions, each with a factor and with what its strains' forces are times, come together.
    pub fn values<'s>(
        &self,
        motions: impl Iterator<Item = (&'s Slopes, Complex, Complex)>,
        omega: f64,
        run: &Run<'_>,
    ) -> Vec<Complex> {
        let mut ways = vec![Complex::default(); self.load.len()];
        let mut forces: Vec<Complex> = self.load.iter().map(|&load| Complex::new(load, 0.0)).collect();
        for (Slopes(slopes), factor, kappa) in motions {
            let of_force = factor * kappa;
            for ((way, force), &slope) in ways.iter_mut().zip(&mut forces).zip(slopes) {
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
                let value = Complex::new(taken(|z| z.re), taken(|z| z.im)) + self.of_base(probe, omega);
                if kind == Kind::Rate { value * Complex::new(0.0, omega) } else { value }
            })
            .collect()
    }

    /// What the base moves by itself, `−a/ω²`, where that is asked for.
    fn of_base(&self, probe: &Probe, omega: f64) -> Complex {
        let Some(ShakenBase { acceleration, response: BaseResponse::Absolute }) = self.base else {
            return Complex::default();
        };
        if probe.of != Measured::Displacement {
            return Complex::default();
        }
        let times = if probe.take == Take::Sum { probe.particles.len() as f64 } else { 1.0 };
        let along = Vec3::from(acceleration).dot(&probe.direction);
        Complex::new(-probe.factor * times * along / (omega * omega), 0.0)
    }
}
