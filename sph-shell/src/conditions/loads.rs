//! Loads: the trait with its stiffness, dead forces on particles, and gravity.

use std::ops::Range;

use explicit_dynamics::{Amplitude, Instant};
use sph_core::Vec3;

use crate::conditions::body::{Block, Body};
use crate::conditions::case::LoadCase;
use crate::conditions::cavity::Enclosed;
use crate::error::ShellError;
use crate::reference::Reference;

/// A load: adds forces on positions \[F\] and couples on directors \[F L\].
///
/// `couple` entries are conjugate to the change of the director: their work is `τ·δd`.
pub trait Load: Send + Sync {
    /// Adds `scale` times the load to the rows `[f, τ]` of the particles it touches.
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]);

    /// Hands every block `∂[f, τ]_a/∂[x, d]_b` of what [`Load::add`] adds to `put(a, b, block)` \[F/L, F, F L\].
    ///
    /// A dead load has none. A load that follows the shell hands over the same pairs (a, b) in any state; a pair that
    /// comes twice is summed. There is no default: without these derivatives critical loads are wrong.
    fn stiffness(&self, scale: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block));

    /// Force \[F\] and couple \[F L\] at the reference point of a rigid body, by its number and its own mass, beside what the load adds to
    /// particles.
    fn on_body(&self, _number: usize, _mass: f64) -> Option<[Vec3; 2]> {
        None
    }

    /// Refuses sets and numbers that make no sense on this shell.
    ///
    /// # Errors
    /// [`ShellError`] naming the fault.
    fn check(&self, reference: &Reference) -> Result<(), ShellError>;

    /// What the load adds to the particles of a range, for one of several who march the shell. A load says it of every range or of none, and
    /// then everyone adds all of it.
    fn on_share(&self, _own: &Range<usize>, _reference: &Reference) -> Option<LoadOnShare> {
        None
    }

    /// What it is of, where its size depends on a volume that the shell encloses.
    fn enclosed(&self) -> Option<&Enclosed> {
        None
    }

    /// The load case to which it belongs.
    fn case(&self) -> LoadCase {
        LoadCase::Loading
    }
}

/// Adds a load times a factor, as [`Load::add`] does.
pub type AddLoad = Box<dyn Fn(f64, &Body<'_>, &mut [[f64; 6]]) + Send + Sync>;

/// A load on a range of particles.
pub struct LoadOnShare {
    /// Adds to the rows of these particles what [`Load::add`] does, to the bit. Of others it may write those that it reads; nobody looks at them.
    pub add: AddLoad,
    /// Particles whose positions and directors it reads, beside those of the range.
    pub reads: Vec<u32>,
}

/// A load and its course in time.
pub struct AppliedLoad {
    /// The load.
    pub load: Box<dyn Load>,
    /// Its factor, multiplied by the load level.
    pub amplitude: Amplitude,
}

impl AppliedLoad {
    /// Its factor at an instant of the case that is under way.
    pub(crate) fn scale(&self, at: Instant, under_way: LoadCase) -> f64 {
        self.load.case().factor(under_way, at.level) * self.amplitude.value(at.time)
    }
}

/// A dead force shared by particles in given parts (a point force has one part).
#[derive(Clone, Debug)]
pub struct Force {
    /// Particles and their shares; the shares are normalised to one.
    pub shares: Vec<(u32, f64)>,
    /// The whole force \[F\].
    pub total: Vec3,
}

/// Weight: acceleration times mass on every particle that moves by itself. What hangs by a tie weighs where its mass is lumped, at its corners: all of
/// a shell falls alike.
#[derive(Clone, Copy, Debug)]
pub struct Gravity {
    /// Acceleration \[L/T²\].
    pub acceleration: Vec3,
}

impl Force {
    fn whole(&self) -> f64 {
        self.shares.iter().map(|s| s.1).sum()
    }

    /// Adds the force on some of its particles, of the sum of all shares.
    fn add_of(&self, shares: &[(u32, f64)], whole: f64, scale: f64, forces: &mut [[f64; 6]]) {
        for &(particle, share) in shares {
            let factor = scale * share / whole;
            for i in 0..3 {
                forces[particle as usize][i] += factor * self.total[i];
            }
        }
    }
}

impl Load for Force {
    fn add(&self, scale: f64, _: &Body<'_>, forces: &mut [[f64; 6]]) {
        self.add_of(&self.shares, self.whole(), scale, forces);
    }

    fn on_share(&self, own: &Range<usize>, _: &Reference) -> Option<LoadOnShare> {
        let (force, whole) = (self.clone(), self.whole());
        let shares = self.shares.iter().filter(|(a, _)| own.contains(&(*a as usize)));
        let shares: Vec<(u32, f64)> = shares.copied().collect();
        let add: AddLoad = Box::new(move |scale, _, forces| force.add_of(&shares, whole, scale, forces));
        Some(LoadOnShare { add, reads: Vec::new() })
    }

    fn stiffness(&self, _: f64, _: &Body<'_>, _: &mut dyn FnMut(u32, u32, &Block)) {}

    fn check(&self, reference: &Reference) -> Result<(), ShellError> {
        check_set("a force", self.shares.iter().map(|s| s.0), reference)
    }
}

impl Gravity {
    fn add_to(&self, forces: &mut [[f64; 6]], masses: &[f64], scale: f64) {
        for (row, mass) in forces.iter_mut().zip(masses) {
            for i in 0..3 {
                row[i] += scale * mass * self.acceleration[i];
            }
        }
    }
}

impl Load for Gravity {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        self.add_to(forces, body.masses, scale);
    }

    fn on_share(&self, own: &Range<usize>, _: &Reference) -> Option<LoadOnShare> {
        let (gravity, own) = (*self, own.clone());
        let add: AddLoad = Box::new(move |scale, body, forces| {
            gravity.add_to(&mut forces[own.clone()], &body.masses[own.clone()], scale);
        });
        Some(LoadOnShare { add, reads: Vec::new() })
    }

    fn stiffness(&self, _: f64, _: &Body<'_>, _: &mut dyn FnMut(u32, u32, &Block)) {}

    fn on_body(&self, _: usize, mass: f64) -> Option<[Vec3; 2]> {
        (mass > 0.0).then(|| [self.acceleration * mass, Vec3::zeros()])
    }

    fn check(&self, _: &Reference) -> Result<(), ShellError> {
        Ok(())
    }
}

/// Refuses empty sets and numbers beyond the cloud.
pub(crate) fn check_set(
    what: &'static str,
    particles: impl IntoIterator<Item = u32>,
    reference: &Reference,
) -> Result<(), ShellError> {
    let count = reference.cloud.len();
    let mut any = false;
    for particle in particles {
        any = true;
        if particle as usize >= count {
            return Err(ShellError::NoSuchParticle { what, particle, count });
        }
    }
    if any { Ok(()) } else { Err(ShellError::EmptySet(what)) }
}
