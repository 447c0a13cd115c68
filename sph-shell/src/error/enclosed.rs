//! What cells cannot enclose.

/// Why nothing is enclosed, with the number of the load.
#[derive(Clone, Debug, thiserror::Error)]
pub enum EnclosedError {
    /// Cells that are no surface with two sides.
    #[error(
        "the cells at particle {particle} have no inside: an edge there belongs to three of them, or to two that face opposite ways; name a set of cells that is one surface, without fins and walls between chambers"
    )]
    NoSurface {
        /// Number of the load.
        load: usize,
        /// A particle of the edge.
        particle: u32,
    },
    /// A rim that is not closed by anything.
    #[error(
        "the rim at particle {particle} is open: where it may move nothing closes what is enclosed; hold the rim, let it slide in a plane of symmetry, or close it by cells"
    )]
    OpenRim {
        /// Number of the load.
        load: usize,
        /// A particle of the rim.
        particle: u32,
    },
    /// Nothing is enclosed.
    #[error(
        "the surface encloses {volume:.4e} at rest, {beside:.4e} with what stands beside; it must be more than nothing: give a surface that bounds a volume, or a volume beside it"
    )]
    NoVolume {
        /// Number of the load.
        load: usize,
        /// Volume that the surface encloses \[L³\].
        volume: f64,
        /// Volume beside it \[L³\].
        beside: f64,
    },
}

impl EnclosedError {
    /// Number of the load.
    pub fn load(&self) -> usize {
        match *self {
            Self::NoSurface { load, .. } | Self::OpenRim { load, .. } | Self::NoVolume { load, .. } => load,
        }
    }
}
