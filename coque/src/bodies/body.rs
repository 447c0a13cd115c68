//! What the application asks of any model: where its particles are, what can be measured on them, what it keeps.

use std::borrow::Cow;
use std::collections::BTreeMap;

use contact::{FrontChange, NodalContact};
use explicit_dynamics::{Dynamics, Exert, Shortened};
use implicit_statics::Equilibrium;
use serde::{Deserialize, Serialize};
use sph_core::{Cell, Vec3};

use super::contact_now::{ContactFields, ContactNow};
use super::field_source::{FieldRequest, FieldSource};
use super::figures::FluidFigures;
use super::glue_now::GlueNow;
use super::one_process::NotShared;
use super::outline::Outline;
use super::point_numbers::POINT_NUMBERS;
use super::resultants::{LoadResultants, Resultant};
use super::yielding::Yielding;
use crate::Warning;
use crate::ranks::Ranks;
use crate::scene::Measured;

/// Particles that move, whatever they are made of.
///
/// Curves, pictures, checkpoints and files of fields need no more than this. How a body moves is [`Dynamics`] or
/// [`Equilibrium`].
pub trait Body: Send {
    /// Where the particles are, and where they were at rest.
    fn configuration(&self) -> Configuration<'_>;

    /// One quantity at one particle, its component along a unit vector where it has components.
    ///
    /// Forces are those of the last evaluation.
    fn read(&self, of: Measured, particle: usize, along: &Vec3) -> f64;

    /// Strains and resultants at some of the points where a shell samples them, each `e κ γ N M Q` in the frame of the point;
    /// none of another body.
    fn point_numbers(&self, _points: &[u32]) -> Vec<[f64; POINT_NUMBERS]> {
        Vec::new()
    }

    /// Stress `xx, yy, zz, xy, yz, zx` of each node of one of its bodies, a solid \[F/L²\]; none of another body.
    fn stresses(&self, _body: usize) -> Vec<[f64; 6]> {
        Vec::new()
    }

    /// Whether it counts the turns of a particle itself, so that they are read as [`Measured::Rotation`] and not followed by its director.
    fn counts_turns(&self, _particle: usize) -> bool {
        false
    }

    /// Force \[F\] on one of its bodies and moment about the origin \[F L\] that a joint exerts in the last step, by its number in the scene, or that all do.
    fn joints_exert(&self, _body: usize, _joint: Option<usize>) -> [Vec3; 2] {
        [Vec3::zeros(); 2]
    }

    /// Works out what its fields show, for whoever writes them.
    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a>;

    /// Whether one of its bodies has tools, which are shown as [`crate::Part::Tools`].
    fn has_tools(&self, _body: usize) -> bool {
        false
    }

    /// Names of the bodies that it is made of, each with fields of its own; none of a body that is one.
    fn bodies(&self) -> Vec<&str> {
        Vec::new()
    }

    /// The same as [`Body::fields`] for one of the bodies that it is made of.
    fn fields_of<'a>(&'a self, _body: usize, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        self.fields(shown)
    }

    /// The same as [`Body::fields`] with what its particles feel of contact.
    fn fields_with_contact<'a>(
        &'a self,
        shown: &FieldRequest<'a>,
        _nodal: ContactFields,
    ) -> Box<dyn FieldSource + 'a> {
        self.fields(shown)
    }

    /// The body of a particle among those that it is made of, and its number there.
    fn place(&self, particle: usize) -> (usize, usize) {
        (0, particle)
    }

    /// What each particle of one of its bodies feels of contact, for the forces last evaluated; nothing where nothing touches it.
    fn nodal_contact(&self, _body: usize) -> Vec<NodalContact> {
        Vec::new()
    }

    /// What each particle of one of its bodies that yields has gone through; empty for others.
    fn yielding(&self, _body: usize) -> Vec<Yielding> {
        Vec::new()
    }

    /// Gaps between its faces and those of whatever may touch it at some particles of one of its bodies \[L\], infinite where there is nothing.
    fn gaps(&self, _body: usize, particles: &[u32]) -> Vec<f64> {
        vec![f64::INFINITY; particles.len()]
    }

    /// What fields show of contact on one of its bodies.
    fn contact_fields(&self, body: usize) -> ContactFields {
        let nodal = self.nodal_contact(body);
        let all: Vec<u32> = (0..nodal.len() as u32).collect();
        ContactFields { gaps: self.gaps(body, &all), nodal }
    }

    /// The contacts of all of its bodies, with what they do now.
    fn contacts(&self) -> Vec<ContactNow> {
        Vec::new()
    }

    /// The glue between its bodies, with what it does now.
    fn glue(&self) -> Vec<GlueNow> {
        Vec::new()
    }

    /// What others may run into of it and of the bodies that it is made of, fluids and walls apart.
    fn outlines(&self) -> Vec<Outline> {
        Vec::new()
    }

    /// What it noticed so far beside what is measured on it.
    fn diagnostics(&self) -> Diagnostics {
        Diagnostics::default()
    }

    /// What its supports exert on it, reduced to its centroid at rest, for the forces last evaluated; none if it cannot tell.
    fn support_resultant(&self) -> Option<Resultant> {
        None
    }

    /// All that changes while it moves, as named arrays: what a checkpoint keeps.
    fn state(&self) -> Vec<StateArray<'_>>;

    /// Takes up a state that [`Body::state`] gave, to the same bits.
    ///
    /// # Errors
    /// [`Mismatch`], and nothing changed, for the state of another body.
    fn set_state(&mut self, state: &[StateArray<'_>]) -> Result<(), Mismatch>;
}

/// A body that is marched in time.
pub trait DynamicBody: Body + Dynamics {
    /// Looks at itself where a run records, at a time \[T\]: what it sees is in [`Body::diagnostics`].
    fn look(&mut self, _time: f64) {}

    /// Steps of what has a clock of its own that were made shorter than the stable one, because something came.
    fn slowed(&self) -> Shortened {
        Shortened::default()
    }

    /// Marches it with others from now on, each of whom has built the same: all that its march returns is then that of the whole, and what is
    /// read of it is right after [`DynamicBody::bring`].
    ///
    /// # Errors
    /// What of it one process marches alone.
    fn share(&mut self, _ranks: &Ranks) -> Result<(), NotShared> {
        Err(NotShared::Kind)
    }

    /// Brings all that can be read of it to everyone who marches it; all of them call it.
    fn bring(&mut self) {}

    /// Lets a function exert forces on its particles from now on; the function comes back from a body that cannot.
    ///
    /// # Errors
    /// The function.
    fn push(&mut self, exert: Exert) -> Result<(), Exert> {
        Err(exert)
    }

    /// The same body without time, for a look at the tangent of the state at which it rests; none without an energy.
    fn at_rest(&mut self) -> Option<Box<dyn StaticBody + '_>> {
        None
    }
}

/// A body whose equilibria are sought without time.
pub trait StaticBody: Body + Equilibrium {
    /// Seeks its equilibria with others from now on, by [`implicit_statics::Relaxation`]: each evaluates the forces on a share of its particles, and
    /// all of them are known to everyone.
    ///
    /// # Errors
    /// What of it one process relaxes alone.
    fn share(&mut self, _ranks: &Ranks) -> Result<(), NotShared> {
        Err(NotShared::Kind)
    }

    /// Evaluates forces at a level, so that they can be read; returns the internal energy \[F L\].
    fn refresh(&mut self, level: f64) -> f64;

    /// The displacement of a particle along a direction, as weights of the unknowns; asked for only where a prescribed
    /// motion of one particle drives the analysis ([`PrescribedPoint`]).
    fn functional(&self, _particle: usize, _along: Vec3) -> Vec<f64> {
        Vec::new()
    }

    /// Whether contacts open and close in it: its stiffness then jumps, and full steps of Newton's method may go to and fro between two states.
    fn opens_and_closes(&self) -> bool {
        false
    }

    /// Whether friction slips in it: what a tangent then says of the way ahead holds for a part of the step only.
    fn slips(&self) -> bool {
        false
    }

    /// A displacement across which answers are no longer linear \[L\]: the thickness of a shell.
    fn linear_reach(&self) -> f64 {
        1.0
    }

    /// Greatest stable step of the unloaded body, were it marched \[T\]; zero if none is known. The scale of its spectrum.
    fn stable_step(&mut self) -> f64 {
        0.0
    }

    /// Largest skew entry of the load stiffness over the largest entry \[–\]: zero for loads with a potential.
    fn skew_load_share(&self) -> f64 {
        0.0
    }

    /// What is doubtful about so many modes of vibration about the state that a preload left.
    fn doubtful_modes(&self, _count: usize) -> Option<Warning> {
        None
    }

    /// Begins the preload: levels count what belongs to it, all else is left off. False, and nothing done, where nothing does.
    fn begin_preload(&mut self) -> bool {
        false
    }

    /// Ends the preload, which is held from here on: levels count all else.
    fn end_preload(&mut self) {}

    /// Freezes contact as it stands at a level: what touches is a spring from here on, and what is apart stays apart.
    fn freeze_contact(&mut self, _level: f64) {}

    /// The first change along a motion of what touched when contact was frozen; none where nothing changes.
    fn first_change(&mut self, _motion: &[f64]) -> Option<FrontChange> {
        None
    }

    /// What may be wrong with the states that were kept, known once they are.
    fn warnings(&self) -> Vec<Warning> {
        Vec::new()
    }

    /// Forces that fields show and that grow with the load of a linear answer, as one row of numbers.
    fn forces(&self) -> Vec<f64> {
        Vec::new()
    }
}

/// What a body found while it moved.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnostics {
    /// Figures of a fluid, if it has one.
    pub fluid: Option<FluidFigures>,
    /// What may be wrong with its numbers.
    pub warnings: Vec<Warning>,
}

/// Where the particles of a body are.
#[derive(Clone, Debug)]
pub struct Configuration<'a> {
    /// Positions at rest \[L\].
    pub rest: &'a [Vec3],
    /// Present positions \[L\].
    pub present: Vec<Vec3>,
    /// Cells between the particles; none where there are particles only.
    pub cells: &'a [Cell],
}

/// A named array of what changes while a body moves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StateArray<'a> {
    /// What it holds.
    pub name: Cow<'a, str>,
    /// Its numbers.
    pub numbers: Cow<'a, [f64]>,
}

impl<'a> StateArray<'a> {
    /// An array under a name.
    pub fn new(name: &'static str, numbers: &'a [f64]) -> Self {
        Self { name: name.into(), numbers: numbers.into() }
    }
}

/// A state that belongs to another body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the state is that of another body")]
pub struct Mismatch;

/// A deformed shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// Time \[T\].
    pub time: f64,
    /// Load level.
    pub level: f64,
    /// Positions of the particles \[L\].
    pub positions: Vec<Vec3>,
}

/// What a body is: for summaries, and for what a run costs.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Description {
    /// Kind of body, as scenes call it.
    pub kind: &'static str,
    /// Method with its options.
    pub method: String,
    /// Particles.
    pub particles: usize,
    /// Points at which strains are sampled.
    pub points: usize,
    /// Degrees of freedom that no support holds.
    pub dof: usize,
    /// Mean distance between particles \[L\].
    pub spacing: f64,
    /// Memory that a step touches, per particle \[bytes\].
    pub bytes_per_particle: f64,
    /// Rotary inertia of a march over that of the surface, for a turn of the whole body about the axis where it is farthest from one \[–\];
    /// none where no time passes, and of a body that is no shell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rotary_inertia_over_true: Option<f64>,
    /// Bodies that it is made of, by name; none of a body that is one.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub bodies: BTreeMap<String, Description>,
    /// What is modelled, one line each.
    pub modelled: Vec<String>,
    /// What is not, one line each.
    pub left_out: Vec<String>,
    /// What its loads amount to; none of a body that cannot tell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub resultants: Option<LoadResultants>,
    /// Steps in time that a look at the tangent costs.
    #[serde(skip)]
    pub tangent: TangentCost,
}

/// What the tangent of a marched body costs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum TangentCost {
    /// It has none.
    #[default]
    Without,
    /// Much; it is looked at only where that is asked for.
    Expensive,
    /// About so many steps in time.
    Steps(f64),
}

/// A prescribed motion of one particle that a force along it brings about.
#[derive(Clone, Copy, Debug)]
pub struct PrescribedPoint {
    /// The particle.
    pub particle: u32,
    /// Unit vector along the motion.
    pub direction: Vec3,
    /// Displacement at level one \[L\], positive.
    pub by: f64,
}

/// Diagonal of the box round some places \[L\].
pub(crate) fn extent(places: &[Vec3]) -> f64 {
    let corner = |pick: fn(f64, f64) -> f64| places.iter().copied().reduce(|a, b| a.zip_map(&b, pick));
    let (low, high) = (corner(f64::min).unwrap_or_default(), corner(f64::max).unwrap_or_default());
    (high - low).norm()
}
