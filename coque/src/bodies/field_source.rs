//! What fields show of a body: which state it is in, and which part of it is written.

use std::io;

use mesh_io::FieldWriter;

use crate::scene::units::Units;
use crate::scene::{Criterion, Output};

/// Kinds of states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// On the way in time.
    Moving,
    /// An equilibrium found without time.
    Balance,
    /// A linear answer: displacements are its own, directors turned by its rotations, forces those of [`FieldRequest::forces`].
    Linear,
    /// Greatest numbers, or root mean squares, each its own and none with a sign: displacements, and forces as of a linear answer; what would be made of several
    /// of them is not shown.
    Greatest,
    /// A mode, scaled for the eye: displacements show its shape, stresses and reactions have no size.
    Mode,
}

/// What is asked of the fields of a body.
#[derive(Clone, Copy, Debug)]
pub struct FieldRequest<'a> {
    /// What kind of state it is in.
    pub state: State,
    /// Units of the scene, for the names of fields.
    pub units: Units,
    /// Whether stresses are wanted.
    pub stresses: bool,
    /// Whether it is wanted where the lattice of a shell is too coarse, as far as strains tell.
    pub indicator: bool,
    /// Whether it is wanted what particles feel of contact.
    pub contact: bool,
    /// What else of stresses is wanted.
    pub of_stresses: StressFields,
    /// The particle whose prescribed motion drives an analysis without time: it bears a reaction though no support
    /// holds it.
    pub driven: Option<u32>,
    /// The forces of a linear answer, as [`crate::StaticBody::forces`] orders them.
    pub forces: Option<&'a [f64]>,
}

/// What is wanted of stresses beside them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StressFields {
    /// Principal stresses, their directions, Tresca's stress.
    pub principal: bool,
    /// Stresses of shells at their particles.
    pub recovered: bool,
    /// Stresses of plies.
    pub plies: bool,
    /// Reserve factors by a criterion.
    pub reserve: Option<Criterion>,
}

impl StressFields {
    /// What a scene asks for.
    pub(crate) fn asked(output: &Output) -> Self {
        let of = |fields: crate::scene::Fields| Self {
            principal: fields.principal,
            recovered: fields.recovered,
            plies: fields.plies,
            reserve: fields.reserve,
        };
        output.fields.map_or_else(Self::default, of)
    }

    /// Whether any of it is.
    pub(crate) fn any(self) -> bool {
        self != Self::default()
    }
}

/// What of a body is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Its particles, and the cells between them: of a shell the mid-surface.
    Surface,
    /// A shell with its thickness.
    Extruded,
    /// The quadrature points of a Galerkin solid.
    Points,
    /// The tools of a shell.
    Tools,
}

/// The fields of a body, ready to be written; any function that writes them is.
pub trait FieldSource: Sync {
    /// Writes geometry and fields of a part.
    ///
    /// # Errors
    /// Those of the writer.
    fn write(&self, part: Part, to: &mut dyn FieldWriter) -> io::Result<()>;
}

impl<F: Fn(Part, &mut dyn FieldWriter) -> io::Result<()> + Sync> FieldSource for F {
    fn write(&self, part: Part, to: &mut dyn FieldWriter) -> io::Result<()> {
        self(part, to)
    }
}
