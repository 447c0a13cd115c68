//! Bodies ready for their analysis: one that is marched, one whose equilibria are sought, one that conducts heat.

use heat_conduction::{ConductionError, HeatBalance, HeatCourse};

use super::body::{Body, DynamicBody, StaticBody};

/// A body that conducts heat and does not move.
pub trait ConductingBody: Body {
    /// Brings it to temperatures in balance; the heat that enters by each way, and the solves made.
    ///
    /// # Errors
    /// [`ConductionError`] where no balance is found.
    fn settle(&mut self) -> Result<(HeatBalance, usize), ConductionError>;

    /// Puts it at the start of a course of temperatures: all of it at one \[Θ\], or in balance under what is given then.
    ///
    /// # Errors
    /// [`ConductionError`] where no balance is found, or something stores no heat.
    fn start(&mut self, temperature: Option<f64>) -> Result<&HeatCourse, ConductionError>;

    /// Goes on to a time \[T\] by steps of which each is off by a tolerance at most \[Θ\]; started first where it is not.
    ///
    /// # Errors
    /// [`ConductionError`] where no step is short enough.
    fn advance(&mut self, until: f64, tolerance: f64) -> Result<&HeatCourse, ConductionError>;
}

/// A body ready for its analysis.
pub enum Ready {
    /// For analyses in time.
    Dynamic(Box<dyn DynamicBody>),
    /// For analyses without time.
    Static(Box<dyn StaticBody>),
    /// For temperatures.
    Heat(Box<dyn ConductingBody>),
}

impl Ready {
    /// The body, however it is solved.
    pub fn body(&self) -> &dyn Body {
        match self {
            Self::Dynamic(body) => body.as_ref(),
            Self::Static(body) => body.as_ref(),
            Self::Heat(body) => body.as_ref(),
        }
    }

    /// The same, to be changed.
    pub fn body_mut(&mut self) -> &mut dyn Body {
        match self {
            Self::Dynamic(body) => body.as_mut(),
            Self::Static(body) => body.as_mut(),
            Self::Heat(body) => body.as_mut(),
        }
    }
}
