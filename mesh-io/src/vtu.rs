//! The VTU format, an unstructured grid in XML: written by [`write`], read by [`read`] for surfaces and frames alike.

pub(crate) mod read;
pub(crate) mod write;
pub(crate) mod xml;
