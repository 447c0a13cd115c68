//! Stresses of the plies of a shell at points where its strains are sampled, and how near to failure they are.

use shell_kinematics::{LayeredSection, Margin, Through};
use sph_shell::Shell;

use super::point_numbers::POINT_NUMBERS;
use crate::scene::{Criterion, PlyComponent, ShellFace};

/// The reserve factor that stands for all beyond: of what bears next to nothing it says nothing \[–\].
pub(crate) const MOST_RESERVE: f64 = 1e3;

/// The plies at some points of a shell.
#[derive(Clone, Debug)]
pub(crate) struct Plies {
    laminates: Vec<Option<LayeredSection>>,
    heated: bool,
    /// Of each point the number of its section, and the height of its middle over the particles \[L\].
    points: Vec<(usize, f64)>,
}

/// What a column takes of plies.
#[derive(Clone, Copy, Debug)]
pub(crate) enum OfPlies {
    /// A stress of a ply at a height through it.
    Stress(usize, PlyComponent, ShellFace),
    /// The reserve factor of a ply, or the least of all.
    Reserve(Option<usize>, Criterion),
    /// The failure index of a ply, or the greatest of all.
    Index(Option<usize>, Criterion),
}

impl Plies {
    /// Those at sampling points of a shell.
    pub fn of(shell: &Shell, points: impl Iterator<Item = usize>) -> Self {
        let at = |point: usize| (shell.laminate_at(point), shell.section_at(point).height);
        Self { laminates: shell.laminates(), heated: shell.is_heated(), points: points.map(at).collect() }
    }

    /// The most plies of any section.
    pub fn most(&self) -> usize {
        self.laminates.iter().flatten().map(|own| own.plies().len()).max().unwrap_or(0)
    }

    /// The plies at a point.
    pub fn at(&self, point: usize) -> Option<&LayeredSection> {
        self.laminates.get(self.points[point].0)?.as_ref()
    }

    /// Whether any of its plies has a strength.
    pub fn any_strength(&self) -> bool {
        let mut all = self.laminates.iter().flatten().flat_map(|own| own.plies());
        all.any(|ply| ply.material.strength().is_some())
    }

    /// Whether the plies at a point, or one of them, have a strength.
    pub fn judged(&self, point: usize, ply: Option<usize>) -> bool {
        let strong = |(number, own): (usize, &shell_kinematics::Ply)| {
            ply.is_none_or(|ply| ply == number) && own.material.strength().is_some()
        };
        self.at(point).is_some_and(|own| own.plies().iter().enumerate().any(strong))
    }

    /// What goes through the thickness at a point, from its strains and resultants.
    pub fn through(
        &self,
        point: usize,
        numbers: &[f64; POINT_NUMBERS],
    ) -> Option<(&LayeredSection, Through)> {
        let (own, height) = (self.at(point)?, self.points[point].1);
        let strains = std::array::from_fn(|i| numbers[i]);
        let resultants = self.heated.then(|| std::array::from_fn(|i| numbers[8 + i]));
        Some((own, own.through(strains, height, resultants)))
    }

    /// What a column takes of a point; zero where there is no such ply, and the greatest reserve where nothing is judged.
    pub fn value(&self, point: usize, of: OfPlies, numbers: &[f64; POINT_NUMBERS]) -> f64 {
        let Some((own, through)) = self.through(point, numbers) else {
            return if matches!(of, OfPlies::Reserve(..)) { MOST_RESERVE } else { 0.0 };
        };
        let margin = |ply: Option<usize>, criterion: Criterion| margin(own, &through, ply, criterion);
        match of {
            OfPlies::Stress(ply, ..) if ply >= own.plies().len() => 0.0,
            OfPlies::Stress(ply, component, face) => {
                let share = match face {
                    ShellFace::Bottom => 0.0,
                    ShellFace::Middle => 0.5,
                    ShellFace::Top => 1.0,
                };
                let [along, across, shear] = own.ply_stress(ply, &through, share);
                match component {
                    PlyComponent::Along => along,
                    PlyComponent::Across => across,
                    PlyComponent::Shear => shear,
                }
            }
            OfPlies::Reserve(ply, criterion) => margin(ply, criterion).reserve.min(MOST_RESERVE),
            OfPlies::Index(ply, criterion) => margin(ply, criterion).index,
        }
    }
}

/// The margin of a ply, or the worst of all: the greatest index and the least reserve, which need not be of one ply.
pub(crate) fn margin(
    own: &LayeredSection,
    through: &Through,
    ply: Option<usize>,
    criterion: Criterion,
) -> Margin {
    let count = own.plies().len();
    let wanted = ply.map_or(0..count, |ply| ply..(ply + 1).min(count));
    let each = wanted.filter_map(|ply| own.ply_margin(ply, criterion.of_fibres(), through));
    each.fold(Margin::NONE, Margin::worse)
}
