//! Frames of bodies on disk: `shell.pvd` of a lone shell, else `NAME.pvd`, and beside it the body with its thickness, its
//! quadrature points, or its tools.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

use mesh_io::{FieldError, Series, write_whole};

use super::{FieldSink, Frame, Part};
use crate::bodies::Model;
use crate::scene::Fields;

/// Sets of particles, beside the frames: body, set, numbers of its particles.
pub const SETS: &str = "sets.json";

/// A body whose frames are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Written<'a> {
    /// Its name, that of its files.
    pub name: &'a str,
    /// Whether it is a shell, which can be written with its thickness as well.
    pub shell: bool,
    /// Whether it has tools, which are written too.
    pub tools: bool,
}

/// Writes the frames of one body or of several into a folder: `NAME.pvd` and `NAME-0000.vtu` …, and of an extruded shell
/// likewise, `solid` of a lone shell, else `NAME-solid`; of quadrature points `NAME-points`; of tools `tools` beside a lone shell, else
/// `NAME-tools`.
///
/// Whatever kills a run leaves whole files, and lists that name only those.
pub struct FieldFiles {
    stresses: bool,
    /// Of each body its surface, and the further parts that are wanted of it.
    bodies: Vec<(Series, Vec<(Part, Series)>)>,
}

impl FieldFiles {
    /// The series of a shell that is alone in its scene; a lone solid is `solid`.
    pub const LONE: &'static str = "shell";

    /// The frames that a scene asks for, in `fields/` of the folder of its run, after so many that an earlier sitting wrote; none if it asks
    /// for none.
    ///
    /// # Errors
    /// As [`FieldFiles::create`] and [`FieldFiles::go_on`].
    pub fn of_run(model: &Model, folder: &Path, frames: u64) -> Result<Option<Self>, FieldError> {
        let Some(wanted) = &model.task.output.fields else { return Ok(None) };
        let described = &model.description;
        let of = |name| described.bodies.get(name).unwrap_or(described);
        let body = model.body.body();
        let written = |(number, name)| {
            let (shell, tools) = (of(name).kind == "shell", body.has_tools(number));
            Written { name, shell, tools }
        };
        let mut bodies: Vec<Written<'_>> = body.bodies().into_iter().enumerate().map(written).collect();
        if bodies.is_empty() {
            bodies.push(written((0, described.kind)));
        }
        let folder = folder.join("fields");
        let files = Self::go_on_all(&folder, &bodies, wanted, frames)?;
        Self::write_sets(&folder, &model.sets)?;
        Ok(Some(files))
    }

    /// Makes the folder and takes out the frames that an earlier run left there of the body.
    ///
    /// # Errors
    /// [`FieldError`] for a folder that cannot be made or cleared.
    pub fn create(folder: &Path, name: &str, wanted: &Fields) -> Result<Self, FieldError> {
        Self::create_all(folder, &[Written { name, shell: true, tools: false }], wanted)
    }

    /// The same for several bodies, in the order of [`crate::Body::bodies`].
    ///
    /// # Errors
    /// As [`FieldFiles::create`].
    pub fn create_all(folder: &Path, bodies: &[Written<'_>], wanted: &Fields) -> Result<Self, FieldError> {
        fs::create_dir_all(folder)
            .map_err(|error| FieldError { path: folder.display().to_string(), reason: error.to_string() })?;
        bodies.iter().try_for_each(|body| Self::clear(folder, body.name))?;
        let body = |body: &Written<'_>| {
            let (surface, others) = series(folder, body.name);
            (surface, further(wanted, body, others))
        };
        Ok(Self { stresses: wanted.stresses, bodies: bodies.iter().map(body).collect() })
    }

    /// Writes the sets of all bodies beside the frames, those of all particles apart.
    ///
    /// # Errors
    /// [`FieldError`] for what the system refuses.
    pub fn write_sets(
        folder: &Path,
        sets: &BTreeMap<String, BTreeMap<String, Vec<u32>>>,
    ) -> Result<(), FieldError> {
        let path = folder.join(SETS);
        let chosen: BTreeMap<&str, BTreeMap<&str, &[u32]>> = sets
            .iter()
            .map(|(body, sets)| {
                let some = sets.iter().filter(|(name, _)| *name != "all");
                (body.as_str(), some.map(|(name, particles)| (name.as_str(), &particles[..])).collect())
            })
            .collect();
        let text = serde_json::to_vec(&chosen).map_err(io::Error::from);
        let written = text.and_then(|text| write_whole(&path, |to| to.write_all(&text)));
        written.map_err(|error| FieldError { path: path.display().to_string(), reason: error.to_string() })
    }

    /// Takes out the frames that an earlier run left in a folder, and their lists; whatever else is there stays.
    ///
    /// # Errors
    /// [`FieldError`] for a folder that cannot be cleared.
    pub fn clear(folder: &Path, name: &str) -> Result<(), FieldError> {
        let (surface, others) = series(folder, name);
        surface.clear()?;
        others.iter().try_for_each(|(_, own)| own.clear())
    }

    /// Goes on after so many frames that an earlier sitting wrote; those after them are taken out, to be written again.
    ///
    /// # Errors
    /// [`FieldError`] for a list that does not hold them, and a folder that cannot be cleared.
    pub fn go_on(folder: &Path, name: &str, wanted: &Fields, frames: u64) -> Result<Self, FieldError> {
        Self::go_on_all(folder, &[Written { name, shell: true, tools: false }], wanted, frames)
    }

    /// The same for several bodies.
    ///
    /// # Errors
    /// As [`FieldFiles::go_on`].
    pub fn go_on_all(
        folder: &Path,
        bodies: &[Written<'_>],
        wanted: &Fields,
        frames: u64,
    ) -> Result<Self, FieldError> {
        if frames == 0 {
            return Self::create_all(folder, bodies, wanted);
        }
        let body = |body: &Written<'_>| {
            let (surface, others) = series(folder, body.name);
            let further = further(wanted, body, others).into_iter();
            let further = further.map(|(part, series)| Ok((part, series.up_to(frames as usize)?)));
            Ok((surface.up_to(frames as usize)?, further.collect::<Result<_, FieldError>>()?))
        };
        let bodies = bodies.iter().map(body).collect::<Result<_, FieldError>>()?;
        Ok(Self { stresses: wanted.stresses, bodies })
    }
}

/// The surface of a body, and its other parts: with its thickness, its quadrature points, its tools.
fn series(folder: &Path, name: &str) -> (Series, [(Part, Series); 3]) {
    let lone = name == FieldFiles::LONE;
    let of = |part, alone: &str, word: &str| {
        let own = if lone { alone.to_string() } else { format!("{name}-{word}") };
        (part, Series::new(folder, &own))
    };
    let others = [
        of(Part::Extruded, "solid", "solid"),
        of(Part::Points, "shell-points", "points"),
        of(Part::Tools, "tools", "tools"),
    ];
    (Series::new(folder, name), others)
}

/// The further parts that are wanted.
fn further(wanted: &Fields, body: &Written<'_>, others: [(Part, Series); 3]) -> Vec<(Part, Series)> {
    let is_wanted = |part| match part {
        Part::Extruded => wanted.extruded && body.shell,
        Part::Points => wanted.points && !body.shell,
        Part::Tools => body.tools,
        Part::Surface => false,
    };
    others.into_iter().filter(|(part, _)| is_wanted(*part)).collect()
}

impl FieldSink for FieldFiles {
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError> {
        let (along, case, enveloped) = (frame.along, frame.case, frame.envelope.is_some());
        let several = !frame.body.bodies().is_empty();
        for (number, (surface, further)) in self.bodies.iter_mut().enumerate() {
            let fields = match several {
                true => frame.evaluate_one(number, self.stresses),
                false => frame.evaluate(self.stresses),
            };
            let mut surface = || surface.add_named(along, case, |to| fields.write(Part::Surface, to));
            let mut further = || {
                // An envelope is of the surface alone.
                let wanted = if enveloped { &mut [] } else { &mut further[..] };
                wanted
                    .iter_mut()
                    .try_for_each(|(part, own)| own.add_named(along, case, |to| fields.write(*part, to)))
            };
            // While a frame is written no step is made: where the run has threads, two of them write. A run on one thread
            // has no pool, and must not wake that of the whole process.
            let pooled = rayon::current_thread_index().is_some();
            let (surface, further) =
                if pooled { rayon::join(surface, further) } else { (surface(), further()) };
            surface.and(further)?;
        }
        Ok(())
    }
}
