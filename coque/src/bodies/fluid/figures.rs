//! What a run with a fluid found beside its curve, and what is doubtful about it.

use explicit_dynamics::Counts;
use fluid_sph::{Energies, Fluid};
use peers::{Greatest, Peers};
use sph_core::Vec3;

use super::late;
use crate::bodies::{Diagnostics, FluidFigures};
use crate::ranks::Ranks;
use crate::warning::{Warning, WarningKind};

/// Change of density beyond which pressures are off by more than the method's own error: half as much again as sound dam breaks
/// reach.
const DENSE: f64 = 0.05;
/// Speed of sound over the greatest speed, below which densities change by more than two percent.
const SLOW: f64 = 7.0;

/// Share of the particles that may be faster: spray.
const SPRAY: f64 = 0.01;

/// Speeds of a fluid so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::bodies) struct Speeds {
    /// The greatest of any particle \[L/T\].
    pub greatest: f64,
    /// Greatest share of the particles that were too fast for the speed of sound at a time \[–\].
    pub fast: f64,
    /// Greatest share of the particles that ran faster than a wave on the water at rest at a time \[–\].
    pub ran: f64,
    /// Speed of that wave, √(gH) \[L/T\].
    pub wave: f64,
}

impl Speeds {
    /// Those of a fluid that has not moved yet.
    pub fn of(fluid: &Fluid) -> Self {
        Self { wave: late::wave(fluid), ..Self::default() }
    }

    /// Looks at the particles; those of all who march it, where several do.
    pub fn watch(&mut self, fluid: &Fluid, ranks: Option<&mut Ranks>) {
        let bound = (fluid.liquid().sound_speed / SLOW).powi(2);
        let wave = self.wave * self.wave;
        let (mut greatest, mut counts) = (0.0_f64, [0, 0]);
        for square in fluid.own_velocities().map(Vec3::norm_squared) {
            greatest = greatest.max(square);
            counts[0] += i64::from(square > bound);
            counts[1] += i64::from(square > wave);
        }
        if let Some(ranks) = ranks {
            ranks.add(&mut [], &mut counts);
        }
        let [fast, ran] = counts;
        self.greatest = self.greatest.max(greatest.sqrt());
        let all = fluid.held() as f64;
        self.fast = self.fast.max(fast as f64 / all);
        self.ran = self.ran.max(ran as f64 / all);
    }

    /// Takes in what the others saw.
    pub fn bring(&mut self, ranks: &mut Ranks) {
        let mut found = [Greatest::of(self.greatest, 0)];
        ranks.greatest(&mut found);
        self.greatest = found[0].value();
    }
}

/// The figures at present, and their warnings.
pub(in crate::bodies) fn found(
    fluid: &Fluid,
    counts: &Counts,
    added_mass: &[f64],
    speeds: Speeds,
    lost: usize,
) -> Diagnostics {
    let Energies { kinetic, compression, potential, viscous, diffusion } = fluid.energies();
    let Counts { substeps, most, shortened } = *counts;
    let figures = FluidFigures {
        mass: fluid.mass() * fluid.held() as f64,
        came_in: fluid.passed().into_iter().map(|[came, _]| came).collect(),
        went_out: fluid.passed().into_iter().map(|[_, went]| went).collect(),
        lost,
        greatest_speed: speeds.greatest,
        greatest_density_error: fluid.greatest_density_error(),
        kinetic,
        compression,
        potential,
        viscous,
        diffusion,
        substeps,
        most_substeps: most,
        shortened,
        added_mass: added_mass.to_vec(),
    };
    let late = (speeds.ran > SPRAY).then(|| late::warning(fluid)).flatten();
    let warnings = [dense(&figures), slow(fluid, speeds), late, gone(lost)].into_iter().flatten().collect();
    Diagnostics { fluid: Some(figures), warnings }
}

fn gone(lost: usize) -> Option<Warning> {
    let message = || {
        format!(
            "{lost} particles of the fluid are beyond closed sides of basins: they splashed over an open side, or leaked; make \
             the sides higher, or use a narrower spacing"
        )
    };
    (lost > 0).then(|| Warning::new(WarningKind::LostFluid, message()))
}

fn dense(figures: &FluidFigures) -> Option<Warning> {
    let error = figures.greatest_density_error;
    let message = || {
        format!(
            "the density of the fluid changed by {:.1} %: beyond {:.0} % pressures are off; raise `sound_speed`, or use a \
             narrower spacing",
            100.0 * error,
            100.0 * DENSE
        )
    };
    (error > DENSE).then(|| Warning::new(WarningKind::Compressed, message()))
}

fn slow(fluid: &Fluid, speeds: Speeds) -> Option<Warning> {
    let sound = fluid.liquid().sound_speed;
    let message = || {
        format!(
            "{:.1} % of the fluid were faster than {:.4}, a {SLOW}th of its speed of sound, at a time: their densities change by \
             more than two percent; use a greater `sound_speed`",
            100.0 * speeds.fast,
            sound / SLOW
        )
    };
    (speeds.fast > SPRAY).then(|| Warning::new(WarningKind::SlowSound, message()))
}
