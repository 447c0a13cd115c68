//! Supports: clamp, hinge, symmetry plane, diaphragm, directions held, prescribed motion and rotation; what they leave free.

use explicit_dynamics::Amplitude;
use sph_core::{HeldDirections, Vec3};

use crate::conditions::case::LoadCase;
use crate::conditions::prescribed::{Motion, Rotation};
use crate::error::ShellError;

/// What a support asks of a particle.
#[derive(Clone, Debug, Default)]
pub struct Holds {
    /// Directions along which the particle may not move.
    pub translations: Vec<Vec3>,
    /// What is asked of the director.
    pub director: DirectorHold,
    /// Unit axis of a section that does not turn in its plane: the director stays in the plane of the axis and of itself at rest.
    pub section: Option<Vec3>,
    /// A motion along one of the held directions.
    pub motion: Option<Motion>,
    /// A rotation of the director, which must then be held fixed by nothing else.
    pub rotation: Option<Rotation>,
}

impl Holds {
    /// The same with the axis of a turn from another origin.
    pub(crate) fn about(mut self, origin: &Vec3) -> Self {
        if let Some(turn) = self.motion.as_mut().and_then(|motion| motion.turn.as_mut()) {
            turn.point -= origin;
        }
        self
    }
}

/// What is asked of a director.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum DirectorHold {
    /// Nothing.
    #[default]
    Free,
    /// `d·ν = 0` for the unit normal ν of a plane.
    InPlane(Vec3),
    /// No rotation at all.
    Fixed,
}

/// A condition on particles of an edge, a row or a point.
pub trait Support: Send + Sync {
    /// What it asks of each particle.
    fn holds(&self) -> Holds;
}

/// A support and the particles it acts on.
pub struct Supported {
    /// Particles.
    pub particles: Vec<u32>,
    /// What is asked of them.
    pub support: Box<dyn Support>,
}

/// All five degrees of freedom held: `x` and `d` stay where they are.
#[derive(Clone, Copy, Debug)]
pub struct Clamped;

/// The position is held, the director free (a soft hinge).
#[derive(Clone, Copy, Debug)]
pub struct Hinged;

/// `u·ν = 0` and `d·ν = 0`, directly on the particles of the plane, without ghosts.
#[derive(Clone, Copy, Debug)]
pub struct SymmetryPlane {
    /// Normal ν of the plane (any length).
    pub normal: Vec3,
}

/// Displacements across an axis are held, those along it are free, and so is the director: or it leans along the axis alone, where the whole section
/// is held and not its middle only.
#[derive(Clone, Copy, Debug)]
pub struct Diaphragm {
    /// The axis (any length).
    pub axis: Vec3,
    /// Whether the whole section is held.
    pub section: bool,
}

/// Displacements along some directions and one turn of the director are held; the rest is free.
///
/// The clamp, the hinge, the symmetry plane and the diaphragm are special cases (a clamped director keeps both turns).
#[derive(Clone, Debug)]
pub struct Held {
    /// Directions of no displacement (any length, linearly independent).
    pub displacement: Vec<Vec3>,
    /// Normal (any length) of the plane in which the director stays.
    pub director: Option<Vec3>,
}

/// Displacement along a direction is prescribed; the rest is free.
#[derive(Clone, Debug)]
pub struct Moved {
    /// Direction (any length).
    pub direction: Vec3,
    /// Displacement at load level one \[L\].
    pub by: f64,
    /// Its course in time.
    pub amplitude: Amplitude,
}

/// The director turns about an axis by a prescribed angle; the position is free.
#[derive(Clone, Debug)]
pub struct Rotated {
    /// Axis (any length).
    pub axis: Vec3,
    /// Angle at load level one \[rad\].
    pub by: f64,
    /// Its course in time.
    pub amplitude: Amplitude,
}

impl Support for Clamped {
    fn holds(&self) -> Holds {
        Holds { translations: axes(), director: DirectorHold::Fixed, ..Holds::default() }
    }
}

impl Support for Hinged {
    fn holds(&self) -> Holds {
        Holds { translations: axes(), ..Holds::default() }
    }
}

impl Support for SymmetryPlane {
    fn holds(&self) -> Holds {
        let normal = self.normal.normalize();
        Holds { translations: vec![normal], director: DirectorHold::InPlane(normal), ..Holds::default() }
    }
}

impl Support for Diaphragm {
    fn holds(&self) -> Holds {
        let axis = self.axis.normalize();
        let frame = sph_core::Frame::from_normal(axis);
        let section = self.section.then_some(axis);
        Holds { translations: vec![frame.t1, frame.t2], section, ..Holds::default() }
    }
}

impl Support for Held {
    fn holds(&self) -> Holds {
        let director = self.director.map_or(DirectorHold::Free, |n| DirectorHold::InPlane(n.normalize()));
        Holds {
            translations: self.displacement.iter().map(Vec3::normalize).collect(),
            director,
            ..Holds::default()
        }
    }
}

impl Support for Moved {
    fn holds(&self) -> Holds {
        let direction = self.direction.normalize();
        let motion = Motion::by(direction * self.by, self.amplitude.clone());
        Holds { translations: vec![direction], motion: Some(motion), ..Holds::default() }
    }
}

impl Support for Rotated {
    fn holds(&self) -> Holds {
        let (axis, angle) = (self.axis.normalize(), self.by);
        let rotation = Rotation { axis, angle, amplitude: self.amplitude.clone(), case: LoadCase::Loading };
        Holds { director: DirectorHold::Fixed, rotation: Some(rotation), ..Holds::default() }
    }
}

fn axes() -> Vec<Vec3> {
    vec![Vec3::x(), Vec3::y(), Vec3::z()]
}

/// All that the supports of one particle ask of it, ready for the step.
#[derive(Clone, Debug)]
pub(crate) struct Constraint {
    /// Directions in which the position is held.
    pub(crate) held: HeldDirections,
    pub(crate) director: DirectorHold,
    /// Few particles are moved, and a step reads what is held of each.
    pub(super) motion: Option<Box<Motion>>,
    pub(super) rotation: Option<Box<Rotation>>,
    /// Position and director at rest.
    pub(super) rest: (Vec3, Vec3),
    /// Whether the particle belongs to a group, which then moves it.
    pub(crate) tied: bool,
}

/// A step reads one a held particle, which may be all.
#[cfg(target_pointer_width = "64")]
const _: () = assert!(size_of::<Constraint>() <= 184);

impl Constraint {
    /// Nothing moves: of a particle that hangs on others and is put where they are.
    pub(crate) fn still(rest: (Vec3, Vec3)) -> Self {
        let (held, director) = (HeldDirections::all(), DirectorHold::Fixed);
        Self { held, director, motion: None, rotation: None, rest, tied: false }
    }

    /// Whether it leaves neither the position nor the director free.
    pub(crate) fn clamps(&self) -> bool {
        self.director == DirectorHold::Fixed && self.held.basis().len() == 3
    }

    /// Whether what is asked of another particle is asked of this one as well.
    pub(crate) fn implies(&self, other: &Self) -> bool {
        let held = |n: &Vec3| Vec3::from(self.held.free_part((*n).into())).norm() < 1e-9;
        let director = other.director == DirectorHold::Free
            || self.director == DirectorHold::Fixed
            || join_directors(self.director, other.director) == self.director;
        let moved = other.held.basis().is_empty() || self.motion == other.motion;
        other.held.basis().iter().all(held) && director && moved && self.rotation == other.rotation
    }

    /// Joins what several supports, by their numbers, ask of particle `particle` with a position and director at rest.
    pub(crate) fn join(
        particle: u32,
        rest: (Vec3, Vec3),
        asked: &[(usize, Holds)],
    ) -> Result<Self, ShellError> {
        let mut out = Self {
            held: HeldDirections::default(),
            director: DirectorHold::Free,
            motion: None,
            rotation: rotation(particle, asked)?.map(Box::new),
            rest,
            tied: false,
        };
        for (_, hold) in asked {
            for direction in &hold.translations {
                out.held.hold(direction);
            }
            out.director = join_directors(out.director, hold.director);
            if let Some(motion) = &hold.motion {
                out.motion = Some(Box::new(match out.motion.take() {
                    None => motion.clone(),
                    Some(old) => old.joined(motion).ok_or(ShellError::TwoMotions(particle))?,
                }));
            }
        }
        if let Some(motion) = &out.motion {
            // A held direction of another support must not oppose the motion.
            for (_, hold) in asked.iter().filter(|(_, hold)| hold.motion.is_none()) {
                for direction in &hold.translations {
                    for part in motion.parts(&rest.0) {
                        let along = part.dot(direction);
                        if along.abs() > 1e-9 * part.norm() {
                            return Err(ShellError::Contradiction { particle, wanted: along, held: 0.0 });
                        }
                    }
                }
            }
        }
        Ok(out)
    }

    /// Takes the held part out of a vector tangent to the director's sphere.
    #[inline]
    pub(crate) fn free_rotation(&self, v: [f64; 3]) -> [f64; 3] {
        match self.director {
            DirectorHold::Free => v,
            DirectorHold::Fixed => [0.0; 3],
            DirectorHold::InPlane(n) => {
                let along = v[0] * n.x + v[1] * n.y + v[2] * n.z;
                [v[0] - along * n.x, v[1] - along * n.y, v[2] - along * n.z]
            }
        }
    }
}

/// The prescribed rotation of a director, which no other support may contradict: it may keep the director in a plane
/// square to the axis.
fn rotation(particle: u32, asked: &[(usize, Holds)]) -> Result<Option<Rotation>, ShellError> {
    let rotating = |(number, hold): &(usize, Holds)| Some((*number, hold.rotation.clone()?));
    let Some((rotated, rotation)) = asked.iter().find_map(rotating) else { return Ok(None) };
    for (other, hold) in asked.iter().filter(|(number, _)| *number != rotated) {
        let agrees = match hold.director {
            DirectorHold::Free => true,
            DirectorHold::InPlane(normal) => normal.cross(&rotation.axis).norm() < 1e-9,
            DirectorHold::Fixed => false,
        };
        if !agrees {
            return Err(ShellError::HeldDirector { particle, rotated, other: *other });
        }
    }
    Ok(Some(rotation))
}

fn join_directors(a: DirectorHold, b: DirectorHold) -> DirectorHold {
    match (a, b) {
        (DirectorHold::Free, other) | (other, DirectorHold::Free) => other,
        (DirectorHold::InPlane(m), DirectorHold::InPlane(n)) if m.cross(&n).norm() < 1e-9 => {
            DirectorHold::InPlane(m)
        }
        // Two planes leave only their common line.
        _ => DirectorHold::Fixed,
    }
}

impl Constraint {
    /// Degrees of freedom held, of three translations and two rotations, of three and three of a group.
    pub(crate) fn held_degrees_of_freedom(&self) -> usize {
        let rotations = match self.director {
            DirectorHold::Free => 0,
            DirectorHold::InPlane(_) => 1 + usize::from(self.tied),
            DirectorHold::Fixed => 2 + usize::from(self.tied),
        };
        self.held.basis().len() + rotations
    }
}
