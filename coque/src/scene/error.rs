//! Why a scene was refused: what was found, what is allowed, how to repair it, and where it stands.

use std::ops::Range;
use std::sync::Arc;

/// A place in the text of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Name of the text: a file, or whatever the caller of [`crate::Scene::parse`] gave.
    pub origin: Arc<str>,
    /// The whole text, with the lines of `--set` at its end.
    pub text: Arc<str>,
    /// Bytes of the text to underline; none where something is missing altogether.
    pub span: Option<Range<usize>>,
}

/// What every refusal carries.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Path of the key, such as `section.homogeneous.thickness`; empty for the scene as a whole.
    pub key: String,
    /// What was found there, as text.
    pub value: String,
    /// What is allowed there.
    pub bound: String,
    /// What to do about it.
    pub repair: String,
    /// Where it stands.
    pub place: Place,
}

/// What a check says.
pub(crate) type Verdict = Result<(), SceneError>;

/// Why a scene was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// The text is not TOML.
    #[error("the scene is not TOML: {}", .0.value)]
    Syntax(Box<Fault>),
    /// A value has the wrong type.
    #[error("`{}` is {}; it must be {}", .0.key, .0.value, .0.bound)]
    Type(Box<Fault>),
    /// An override that cannot be put into the scene.
    #[error("cannot set `{}`: {}", .0.key, .0.value)]
    Override(Box<Fault>),
    /// A key without default is missing.
    #[error("`{}` is missing", .0.key)]
    Missing(Box<Fault>),
    /// A key that no scene has.
    #[error("{}unknown key `{}`", at(&.0.key), .0.value)]
    UnknownKey(Box<Fault>),
    /// A word for something that other programs do and coque does not yet; the value is its name.
    #[error("{}coque does not do {} yet", at(&.0.key), .0.value)]
    NotYet(Box<Fault>),
    /// A word outside a fixed list.
    #[error("{}unknown word `{}`", at(&.0.key), .0.value)]
    UnknownWord(Box<Fault>),
    /// None or more than one of several alternatives, or something that does not go with the rest.
    #[error("`{}` gives {}; it must give {}", .0.key, .0.value, .0.bound)]
    Choice(Box<Fault>),
    /// A value outside its bounds.
    #[error("`{}` is {}; it must be {}", .0.key, .0.value, .0.bound)]
    Value(Box<Fault>),
    /// A set that does not exist, is empty, or does not suit its use.
    #[error("`{}` is {}, {}", .0.key, .0.value, .0.bound)]
    Set(Box<Fault>),
    /// The file of the surface cannot be read, or holds no sound surface.
    #[error("`{}`: {}", .0.key, .0.value)]
    Mesh(Box<Fault>),
    /// The supports leave a rigid motion free that a static answer cannot do without; the value names the body as well.
    #[error("the supports leave the {}", .0.value)]
    FreeMotion(Box<Fault>),
    /// A layer below refused the model.
    #[error("the model cannot be built: {}", .0.value)]
    Model(Box<Fault>),
}

/// `` `key`: `` in front of a message, nothing for the scene as a whole.
fn at(key: &str) -> String {
    if key.is_empty() { String::new() } else { format!("`{key}`: ") }
}

impl SceneError {
    /// Key, value, bound, repair and place.
    pub fn fault(&self) -> &Fault {
        match self {
            Self::Syntax(f)
            | Self::Type(f)
            | Self::Override(f)
            | Self::Missing(f)
            | Self::UnknownKey(f)
            | Self::NotYet(f)
            | Self::UnknownWord(f)
            | Self::Choice(f)
            | Self::Value(f)
            | Self::Set(f)
            | Self::Mesh(f)
            | Self::FreeMotion(f)
            | Self::Model(f) => f,
        }
    }

    /// Word for the kind of refusal, for programs.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Syntax(_) => "scene::syntax",
            Self::Type(_) => "scene::type",
            Self::Override(_) => "scene::override",
            Self::Missing(_) => "scene::missing",
            Self::UnknownKey(_) => "scene::unknown-key",
            Self::NotYet(_) => "scene::not-yet",
            Self::UnknownWord(_) => "scene::unknown-word",
            Self::Choice(_) => "scene::choice",
            Self::Value(_) => "scene::value",
            Self::Set(_) => "scene::set",
            Self::Mesh(_) => "scene::mesh",
            Self::FreeMotion(_) => "scene::free-motion",
            Self::Model(_) => "scene::model",
        }
    }
}
