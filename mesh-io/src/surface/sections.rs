//! Sections and materials that a file gives to groups of its faces, as they stand there.

/// A homogeneous section of a group of faces.
#[derive(Clone, Debug, PartialEq)]
pub struct FileSection {
    /// Name of the group, as the section writes it.
    pub group: String,
    /// Its faces; none if the file has no such group.
    pub faces: Vec<u32>,
    /// Thickness `[L]`.
    pub thickness: f64,
    /// From the nodes to the middle of the thickness along the normal, in thicknesses `[–]`.
    pub offset: f64,
    /// Name of the material, as the section writes it.
    pub material: String,
    /// Line of the file.
    pub line: usize,
}

/// An isotropic elastic material; what the file does not give is none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FileMaterial {
    /// Young's modulus and Poisson's ratio, in the units of the file.
    pub elastic: Option<[f64; 2]>,
    /// Mass per volume, in the units of the file.
    pub density: Option<f64>,
}
