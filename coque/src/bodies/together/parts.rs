//! What is asked of a body beside others, and of all of them whatever they are solved by.

use crate::bodies::body::{Body, DynamicBody, StaticBody};

/// A body that is marched beside others.
pub(in crate::bodies) trait MarchedPart: DynamicBody + explicit_dynamics::Joinable {}

impl<B: DynamicBody + explicit_dynamics::Joinable> MarchedPart for B {}

/// A body whose equilibria are sought beside others.
pub(in crate::bodies) trait BalancedPart: StaticBody + implicit_statics::Joinable {}

impl<B: StaticBody + implicit_statics::Joinable> BalancedPart for B {}

/// Bodies marched together.
pub(super) type Marched = explicit_dynamics::Several<dyn MarchedPart>;
/// Bodies balanced together.
pub(super) type Balanced = implicit_statics::Several<dyn BalancedPart>;

/// Bodies one behind the other.
pub(super) trait Parts: Send {
    /// Each of them.
    fn each(&self) -> Vec<&dyn Body>;

    /// The same, to put them into other states.
    fn each_mut(&mut self) -> Vec<&mut dyn Body>;
}

impl Parts for Marched {
    fn each(&self) -> Vec<&dyn Body> {
        self.systems().iter().map(|part| part.as_ref() as &dyn Body).collect()
    }

    fn each_mut(&mut self) -> Vec<&mut dyn Body> {
        self.systems_mut().iter_mut().map(|part| part.as_mut() as &mut dyn Body).collect()
    }
}

impl Parts for Balanced {
    fn each(&self) -> Vec<&dyn Body> {
        self.systems().iter().map(|part| part.as_ref() as &dyn Body).collect()
    }

    fn each_mut(&mut self) -> Vec<&mut dyn Body> {
        self.systems_mut().iter_mut().map(|part| part.as_mut() as &mut dyn Body).collect()
    }
}
