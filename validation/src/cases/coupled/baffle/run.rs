//! A dam breaks on a baffle of bonds that stands before a pool, and breaks it.

use std::error::Error;

use explicit_dynamics::Amplitude;
use fluid_sph::Parts;
use peridynamics::{
    AppliedLoad, Contact, Correction, Criterion, Elastic, Fracture, Law, Solid, Space, Support, Supported,
};
use sph_core::Vec3;

use crate::support::coupled::{GRAVITY, ROWS, coupled, fill, march, water};
use crate::support::solids::{formulation, lattice, nodes, parts};

/// Side of the box; column; baffle with its near face; pool: width and depth \[m\].
const BOX: f64 = 4.0;
const COLUMN: [f64; 2] = [1.0, 3.0];
const NEAR: f64 = 2.0;
pub const BAFFLE: [f64; 2] = [0.1, 1.0];
const POOL: f64 = 0.7;
/// A plane body of bonds has this Poisson's ratio.
const MATERIAL: Elastic = Elastic { young: 20e6, poisson: 1.0 / 3.0, density: 1878.0 };
/// Stretches at which bonds break.
const TENSION: f64 = 0.05;
const COMPRESSION: f64 = -0.09;
/// Rows of nodes that are held below the floor.
const HELD: usize = 3;
/// Time for the pool to bend the baffle before the dam breaks \[s\], and damping of the baffle meanwhile
/// \[1/s\].
const BEFORE: f64 = 1.0;
const DAMPING: f64 = 40.0;

/// What a run leaves behind.
#[derive(Clone, Debug, Default)]
pub struct Broken {
    /// Time \[s\], front of the column \[m\], way of the top downstream \[m\], most damage of a node, mean
    /// damage of the row next to the floor, energy of broken bonds \[J/m\], part of the nodes cut off,
    /// crest \[m\], energy missing \[J/m\], work of gravity \[J/m\].
    pub rows: Vec<[f64; 10]>,
    /// Where bonds broke first \[m\].
    pub first: Option<[f64; 2]>,
    pub particles: usize,
    pub steps: u64,
    pub substeps: u64,
    pub density_error: f64,
    pub seconds: f64,
}

fn baffle(dx: f64, breaks: bool) -> Result<Solid, Box<dyn Error>> {
    let below = HELD as f64 * dx;
    let origin = Vec3::new(NEAR, -below, 0.0);
    let block = lattice(2, origin, [BAFFLE[0], BAFFLE[1] + below, dx], dx).block()?;
    let foot = nodes(&block, |x| x.y < 0.0);
    let weight = |a: usize| (a as u32, -Vec3::y() * (GRAVITY * MATERIAL.density * block.volumes[a]));
    let loads =
        vec![AppliedLoad { forces: (0..block.len()).map(weight).collect(), amplitude: Amplitude::Constant }];
    let held = Support::Held { displacement: vec![Vec3::x(), Vec3::y()], director: Vec::new() };
    let criterion = Criterion::Stretch { tension: TENSION, compression: Some(COMPRESSION) };
    let walls = vec![[Vec3::zeros(), Vec3::y()], [Vec3::x() * BOX, -Vec3::x()], [Vec3::zeros(), Vec3::x()]];
    let mut solid = Solid::new(peridynamics::Parts {
        supports: vec![Supported { nodes: foot, support: held }],
        loads,
        fracture: breaks.then_some(Fracture { criterion, unbreakable: Vec::new() }),
        contact: breaks.then_some(Contact { distance: 1.0, walls }),
        ..parts(block, MATERIAL, formulation(Space::PlaneStress, Law::BondBased, Correction::Even))
    })?;
    solid.wet()?;
    Ok(solid)
}

fn tank(dx: f64, positions: Vec<Vec3>, sound: f64) -> Parts {
    let behind = ROWS as f64 * dx;
    let walls = vec![
        fill([-behind, -behind], [NEAR, 0.0], dx),
        fill([NEAR + BAFFLE[0], -behind], [BOX + behind, 0.0], dx),
        fill([-behind, 0.0], [0.0, BOX], dx),
        fill([BOX, 0.0], [BOX + behind, BOX], dx),
        fill([-behind, BOX], [BOX + behind, BOX + behind], dx),
    ];
    water(dx, positions, sound, walls)
}

/// Runs the baffle with so many layers of nodes.
///
/// # Errors
/// A motion that diverges.
pub fn broken(layers: usize, duration: f64) -> Result<Broken, Box<dyn Error>> {
    let started = std::time::Instant::now();
    let dx = BAFFLE[0] / layers as f64;
    let pool = fill([NEAR + BAFFLE[0], 0.0], [BOX, POOL], dx);
    // The pool alone bends the baffle, which is whole as yet.
    let slow = 10.0 * (GRAVITY * POOL).sqrt();
    let mut before = coupled(tank(dx, pool, slow), vec![baffle(dx, false)?])?;
    march(&mut before, [BEFORE, BEFORE], DAMPING, |_, _| {})?;
    let column = fill([0.0, 0.0], COLUMN, dx);
    let dam = column.len();
    let positions: Vec<Vec3> = column.into_iter().chain(before.fluid().positions().iter().copied()).collect();
    let mut solid = baffle(dx, true)?;
    if let Some(bent) = before.structures().next() {
        (0..solid.len()).for_each(|a| solid.put(a, bent.position(a)));
    }

    let mut system = coupled(tank(dx, positions, 20.0 * (GRAVITY * COLUMN[1]).sqrt()), vec![solid])?;
    let mut found = Broken { particles: system.fluid().len(), ..Broken::default() };
    let (rows, first) = (&mut found.rows, &mut found.first);
    found.steps = march(&mut system, [duration, 0.005], 0.0, |system, record| {
        let positions = system.fluid().positions();
        let front = positions[..dam].iter().map(|x| x.x).fold(0.0, f64::max);
        let crest = positions.iter().filter(|x| x.x > 1.5).map(|x| x.y).fold(0.0, f64::max);
        let Some(solid) = system.structures().next() else { return };
        let rest = &solid.block().positions;
        let row =
            |low: f64, high: f64| (0..solid.len()).filter(move |&a| rest[a].y > low && rest[a].y < high);
        let mean = |nodes: Vec<usize>, of: &dyn Fn(usize) -> f64| {
            nodes.iter().map(|&a| of(a)).sum::<f64>() / nodes.len() as f64
        };
        let top = mean(row(BAFFLE[1] - dx, BAFFLE[1]).collect(), &|a| solid.displacement(a).x);
        let foot = mean(row(0.0, dx).collect(), &|a| solid.damage(a));
        let damaged =
            (0..solid.len()).max_by(|&a, &b| solid.damage(a).total_cmp(&solid.damage(b))).unwrap_or(0);
        if first.is_none() && solid.damage(damaged) > 0.0 {
            *first = Some([rest[damaged].x, rest[damaged].y]);
        }
        let pieces = solid.fragments();
        // The first piece is that of the held foot.
        let off = 1.0 - pieces[0] as f64 / solid.len() as f64;
        let spent = (0..solid.len()).map(|a| solid.fracture_energy(a)).sum::<f64>() / dx;
        rows.push([
            record.at.time,
            front,
            top,
            solid.damage(damaged),
            foot,
            spent,
            off,
            crest,
            record.balance_error + spent,
            record.energy.external,
        ]);
    })?;
    found.substeps = system.counts().substeps;
    found.density_error = system.fluid().greatest_density_error();
    found.seconds = started.elapsed().as_secs_f64();
    Ok(found)
}
