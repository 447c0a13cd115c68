//! Why a rigid body could not be built.

/// A rigid body that was refused before anything ran.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RigidError {
    /// A surface with a rim, with faces that disagree, or with more than two faces at an edge.
    #[error(
        "the surface is not closed: between [{:.4}, {:.4}, {:.4}] and [{:.4}, {:.4}, {:.4}] lies no second face that looks to the same side; close the surface, or give faces one side",
        .0[0][0], .0[0][1], .0[0][2], .0[1][0], .0[1][1], .0[1][2]
    )]
    Open([[f64; 3]; 2]),
    /// Faces that look inwards, or a surface without a volume.
    #[error(
        "the surface encloses a volume of {0:.4e}; turn its faces outwards (`flip`), or give it a volume"
    )]
    Volume(f64),
    /// A mass or an inertia that no body has.
    #[error(
        "the mass is {mass:.4e} and the principal moments of inertia are {moments:?}; all must be positive, and no moment greater than the sum of the two others"
    )]
    Inertia {
        /// The mass \[M\].
        mass: f64,
        /// The moments \[M L²\].
        moments: [f64; 3],
    },
    /// A support that another contradicts.
    #[error("supports {0}; remove one of them")]
    Opposed(&'static str),
    /// A condition on a particle that the body does not have.
    #[error("{what} names particle {particle} of {count}; name one of them")]
    NoSuchParticle {
        /// The condition.
        what: &'static str,
        /// The particle.
        particle: u32,
        /// Number of particles.
        count: usize,
    },
}
