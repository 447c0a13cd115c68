//! What a particle does not see though it is near: the other side of a thin structure.

/// Which neighbours a particle does not see.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hidden<'a> {
    /// Faces that it does not see.
    pub faces: u32,
    /// By slot of the neighbours: faces that they belong to.
    pub of: &'a [u32],
}

impl Hidden<'_> {
    /// None.
    pub const NONE: Self = Self { faces: 0, of: &[] };
}

/// The other face of each structure: faces of a structure are two bits next to each other.
#[inline(always)]
pub(crate) fn opposite(faces: u32) -> u32 {
    (faces & 0x5555_5555) << 1 | (faces & 0xAAAA_AAAA) >> 1
}
