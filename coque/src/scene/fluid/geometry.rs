//! Where a fluid is at the start: one block or several, a disc, an annulus.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{NotNegative, Positive};

/// Where a fluid is at the start; particles stand half a spacing inside its faces.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum FluidGeometry {
    /// A box along the axes.
    Block(FluidBlock),
    /// Several boxes, such as a column and a pool.
    Blocks(FluidBlocks),
    /// A disc in the plane, of rings of particles.
    Disc(Disc),
    /// What lies between two circles of the plane, of rings of particles.
    Annulus(Annulus),
}

/// A box of fluid along the axes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FluidBlock {
    /// Edges along x, y and, in space, z, each a whole number of spacings \[L\].
    #[schemars(length(min = 2, max = 3))]
    pub lengths: Vec<Positive>,
    /// Distance between particles \[L\].
    pub spacing: Positive,
    /// The corner of least coordinates \[L\]; left out, the origin.
    #[schemars(length(min = 2, max = 3))]
    pub origin: Option<Vec<f64>>,
}

/// Several boxes of fluid with one spacing.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FluidBlocks {
    /// Distance between particles \[L\].
    pub spacing: Positive,
    /// The boxes.
    pub parts: Vec<FluidBox>,
}

/// One of several boxes of fluid.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FluidBox {
    /// Edges along x, y and, in space, z, each a whole number of spacings \[L\].
    #[schemars(length(min = 2, max = 3))]
    pub lengths: Vec<Positive>,
    /// The corner of least coordinates \[L\]; left out, the origin.
    #[schemars(length(min = 2, max = 3))]
    pub origin: Option<Vec<f64>>,
}

/// A disc of fluid in the plane.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Disc {
    /// Its centre \[L\].
    pub centre: [f64; 2],
    /// Its radius, a whole number of spacings \[L\].
    pub radius: Positive,
    /// Distance between particles \[L\].
    pub spacing: Positive,
}

/// The fluid between two circles of the plane.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Annulus {
    /// Its centre \[L\].
    pub centre: [f64; 2],
    /// Inner radius \[L\].
    pub inner: NotNegative,
    /// Outer radius, a whole number of spacings from the inner \[L\].
    pub outer: Positive,
    /// Distance between particles \[L\].
    pub spacing: Positive,
}

/// A box of fluid: its path below the fluid, its edges and, if it is given, its corner.
pub(crate) type Part<'a> = (String, &'a [Positive], Option<&'a [f64]>);

/// A box of fluid, in space; in a plane its last length is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Extent {
    /// Least coordinates \[L\].
    pub least: [f64; 3],
    /// Edges \[L\].
    pub lengths: [f64; 3],
}

impl FluidGeometry {
    /// Its key in a scene.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Block(_) => "block",
            Self::Blocks(_) => "blocks",
            Self::Disc(_) => "disc",
            Self::Annulus(_) => "annulus",
        }
    }

    /// Dimensions of the particles.
    pub fn dimensions(&self) -> usize {
        match self {
            Self::Block(block) => block.lengths.len(),
            Self::Blocks(blocks) => blocks.parts.first().map_or(0, |part| part.lengths.len()),
            Self::Disc(_) | Self::Annulus(_) => 2,
        }
    }

    /// Distance between particles \[L\].
    pub fn spacing(&self) -> f64 {
        match self {
            Self::Block(block) => block.spacing.get(),
            Self::Blocks(blocks) => blocks.spacing.get(),
            Self::Disc(disc) => disc.spacing.get(),
            Self::Annulus(annulus) => annulus.spacing.get(),
        }
    }

    /// The same, to change it.
    pub(crate) fn spacing_mut(&mut self) -> &mut Positive {
        match self {
            Self::Block(block) => &mut block.spacing,
            Self::Blocks(blocks) => &mut blocks.spacing,
            Self::Disc(disc) => &mut disc.spacing,
            Self::Annulus(annulus) => &mut annulus.spacing,
        }
    }

    /// The circles between which rings of particles stand: centre, inner and outer radius.
    pub(crate) fn rings(&self) -> Option<Annulus> {
        match *self {
            Self::Block(_) | Self::Blocks(_) => None,
            Self::Disc(Disc { centre, radius, spacing }) => {
                Some(Annulus { centre, inner: NotNegative::default(), outer: radius, spacing })
            }
            Self::Annulus(annulus) => Some(annulus),
        }
    }

    /// Its boxes, each with its path below the fluid; none of rings.
    pub(crate) fn boxes(&self) -> Vec<Part<'_>> {
        match self {
            Self::Block(block) => {
                vec![("geometry.block".into(), &block.lengths, block.origin.as_deref())]
            }
            Self::Blocks(blocks) => {
                let path = |i: usize| format!("geometry.blocks.parts[{i}]");
                let parts = blocks.parts.iter().enumerate();
                parts.map(|(i, part)| (path(i), &part.lengths[..], part.origin.as_deref())).collect()
            }
            Self::Disc(_) | Self::Annulus(_) => Vec::new(),
        }
    }

    /// Boxes that it fills, in rings the box round them.
    pub(crate) fn extents(&self) -> Vec<Extent> {
        if let Some(Annulus { centre, outer, .. }) = self.rings() {
            let least = [centre[0] - outer.get(), centre[1] - outer.get(), 0.0];
            return vec![Extent { least, lengths: [2.0 * outer.get(), 2.0 * outer.get(), 0.0] }];
        }
        let at = |list: &[f64], axis: usize| list.get(axis).copied().unwrap_or(0.0);
        let extent = |(_, lengths, origin): Part<'_>| Extent {
            least: [0, 1, 2].map(|axis| origin.map_or(0.0, |origin| at(origin, axis))),
            lengths: [0, 1, 2].map(|axis| lengths.get(axis).map_or(0.0, |length| length.get())),
        };
        self.boxes().into_iter().map(extent).collect()
    }
}
