//! Why a surface was refused: file, line, entity, repair.

use sph_core::Vec3;

/// A surface that was refused before anything was built on it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{file}{}: {what}; {repair}", line.map(|line| format!(", line {line}")).unwrap_or_default())]
pub struct MeshError {
    /// Name of the file.
    pub file: String,
    /// Line of the file, from 1; none where the fault lies in no one line.
    pub line: Option<usize>,
    /// Entity, value and what is wrong with it.
    pub what: String,
    /// What to do about it.
    pub repair: String,
}

impl MeshError {
    /// A fault in a line, zero for none; the file is named by [`parse`](super::parse).
    pub(super) fn at(line: usize, what: impl Into<String>, repair: impl Into<String>) -> Self {
        Self {
            file: String::new(),
            line: Some(line).filter(|line| *line > 0),
            what: what.into(),
            repair: repair.into(),
        }
    }

    /// A fault of the surface as a whole.
    pub(super) fn whole(what: impl Into<String>, repair: impl Into<String>) -> Self {
        Self { file: String::new(), line: None, what: what.into(), repair: repair.into() }
    }

    /// The same, with the name of the file.
    pub(super) fn named(self, file: &str) -> Self {
        Self { file: file.into(), ..self }
    }
}

/// A place as text, to six digits.
pub(super) fn place(x: &Vec3) -> String {
    format!("[{}, {}, {}]", number(x.x), number(x.y), number(x.z))
}

/// A number to six digits, without an exponent where it reads better so.
pub(super) fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    if !(1e-4..1e7).contains(&x.abs()) {
        return format!("{x:.5e}");
    }
    let digits = (5 - libm::log10(x.abs()).floor() as i32).max(0) as usize;
    let text = format!("{x:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}
