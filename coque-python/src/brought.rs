//! What a scene calls by name and Python brings: meshes and numbers by particle, as NumPy's arrays.

use std::collections::BTreeMap;
use std::sync::Arc;

use coque::mesh::Arrays;
use coque::{Checked, SceneError};
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

type Sets<'py> = BTreeMap<String, PyReadonlyArray1<'py, u32>>;
/// Points, faces, sets of points, sets of faces.
type Mesh<'py> = (PyReadonlyArray2<'py, f64>, PyReadonlyArray2<'py, u32>, Sets<'py>, Sets<'py>);

/// Meshes and numbers by particle, by the names under which a scene calls them.
#[derive(FromPyObject)]
pub struct Brought<'py>(BTreeMap<String, Mesh<'py>>, BTreeMap<String, PyReadonlyArray1<'py, f64>>);

/// The same as scenes hold them.
pub struct InMemory {
    surfaces: BTreeMap<String, Arc<Arrays>>,
    arrays: BTreeMap<String, Arc<Vec<f64>>>,
}

impl Brought<'_> {
    /// Copies them.
    ///
    /// # Errors
    /// Arrays that do not lie in one piece.
    pub fn copied(&self) -> PyResult<InMemory> {
        let Self(meshes, numbers) = self;
        let surface = |(name, mesh): (&String, _)| Ok((name.clone(), Arc::new(arrays(mesh)?)));
        let array = |(name, numbers): (&String, &PyReadonlyArray1<'_, f64>)| {
            Ok((name.clone(), Arc::new(numbers.as_slice()?.to_vec())))
        };
        Ok(InMemory {
            surfaces: meshes.iter().map(surface).collect::<PyResult<_>>()?,
            arrays: numbers.iter().map(array).collect::<PyResult<_>>()?,
        })
    }
}

impl InMemory {
    /// The scene with them, checked.
    ///
    /// # Errors
    /// As [`coque::Scene::check`].
    pub fn into_scene(self, scene: Checked) -> Result<Checked, SceneError> {
        let Self { surfaces, arrays } = self;
        coque::Scene { surfaces, arrays, ..scene.into_scene() }.check()
    }
}

/// A mesh of NumPy's arrays.
fn arrays((points, faces, sets, face_sets): &Mesh<'_>) -> PyResult<Arrays> {
    let lists = |sets: &Sets<'_>| {
        let list = |(name, numbers): (&String, &PyReadonlyArray1<'_, u32>)| {
            Ok((name.clone(), numbers.as_slice()?.to_vec()))
        };
        sets.iter().map(list).collect::<PyResult<_>>()
    };
    Ok(Arrays {
        points: points.as_slice()?.as_chunks().0.to_vec(),
        faces: faces.as_slice()?.as_chunks().0.to_vec(),
        sets: lists(sets)?,
        face_sets: lists(face_sets)?,
    })
}
