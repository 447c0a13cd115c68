//! Constraints between the structures of a fluid that hold where a step arrives.

use std::any::Any;

use crate::error::OutOfBounds;
use crate::step::{Step, Work};

/// Exact constraints between structures, such as joints of rigid bodies: what they exert hangs on where the step arrives, not on places alone as an
/// [`Interaction`](crate::Interaction) does.
pub trait Bracing<S: ?Sized>: Any + Send {
    /// Before a kick, the forces of the structures evaluated: adds what the constraints exert. In a kick of no span it gives and takes velocities at once.
    fn brace(&mut self, bodies: &mut [Box<S>], step: &Step);

    /// Behind the kick: takes what the constraints did out of the work of loads.
    fn settle(&self, bodies: &mut [Box<S>], step: &Step, work: &mut Work);

    /// Refuses a state that they do not hold.
    ///
    /// # Errors
    /// [`OutOfBounds`].
    fn within_bounds(&self) -> Result<(), OutOfBounds>;
}
