//! Bodies ready for their analysis: one that is marched, one whose equilibria are sought, one that conducts heat.

use sph_shell::{ConductionError, Temperatures};

use super::body::{Body, DynamicBody, StaticBody};

/// A body that conducts heat and does not move.
pub trait ConductingBody: Body {
    /// Brings it to temperatures in balance.
    ///
    /// # Errors
    /// [`ConductionError`] where no balance is found.
    fn settle(&mut self) -> Result<&Temperatures, ConductionError>;
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
