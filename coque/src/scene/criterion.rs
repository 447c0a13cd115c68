//! What is asked of plies: which stress, by which criterion how near to failure; through which height.

use schemars::JsonSchema;
use serde::Deserialize;

/// Where through the thickness of a shell, or of one of its plies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ShellFace {
    /// The face to which the directors point.
    Top,
    /// The other.
    Bottom,
    /// The middle between both.
    Middle,
}

/// A stress in the axes of a fibre.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PlyComponent {
    /// Along the fibre.
    Along,
    /// Across it.
    Across,
    /// The shear stress between the two.
    Shear,
}

/// A criterion of failure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Criterion {
    /// Tsai and Wu's of plies with a fibre: one surface through all strengths. Plies of elastic materials are judged by von Mises beside it.
    TsaiWu,
    /// Hashin's of 1980 of the same: fibre and matrix apart, of which the one that fails first counts.
    Hashin,
    /// Von Mises' of elastic materials with a strength.
    VonMises,
}

impl Criterion {
    /// Its word in a scene.
    pub fn word(self) -> &'static str {
        match self {
            Self::TsaiWu => "tsai-wu",
            Self::Hashin => "hashin",
            Self::VonMises => "von-mises",
        }
    }

    /// As plies with a fibre are judged; others are judged by von Mises whatever it is.
    pub(crate) fn of_fibres(self) -> shell_kinematics::Criterion {
        match self {
            Self::TsaiWu | Self::VonMises => shell_kinematics::Criterion::TsaiWu,
            Self::Hashin => shell_kinematics::Criterion::Hashin,
        }
    }
}
