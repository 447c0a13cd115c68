//! Directors of a shell, by which it holds the face of a solid across its edge.

use std::collections::{BTreeMap, BTreeSet};

use contact::{Dual, Hold};
use sph_core::{Cell, Vec3};
use sph_shell::Shell;

use super::near::Raised;

/// Part of half the thickness beyond that by which a particle may lie: faces from files are round so far.
const BEYOND: f64 = 0.01;

/// Number of a place that is rounding, of directors over half of the thickness \[–\].
const ROUNDING: f64 = 1e-14;
/// Least weight of a corner: a place two cells beyond the rim has −2 of the row behind, one a cell beyond two rims −2 of each.
const WITHIN: f64 = -2.0 - 1e-9;

/// Places by the numbers of their body, particles and then directors, and how they hold.
type HeldAt = (Vec<u32>, Hold);

/// Directors of a shell at rest.
#[derive(Clone, Debug)]
pub(super) struct Directors {
    /// Unit vectors, by particle.
    pub at: Vec<Vec3>,
    /// Half of the thickness at each particle \[L\]; none of a shell with sections off its particles.
    half: Option<Vec<f64>>,
    /// Whether nothing but the particle turns its director.
    free: Vec<bool>,
    /// Stiffness of glue at rest by area of the section \[F/L³\].
    pub stiffness: f64,
}

/// What keeps a particle from being held by directors.
pub(super) enum Unheld {
    /// Sections lie off the particles of the shell.
    Offset,
    /// It lies so far off the surface, where half of the thickness is this \[L\].
    Beyond { height: f64, half: f64 },
    /// It lies more than two cells beyond the rim of the shell.
    PastRim,
    /// Ties or a rigid set turn a director of the shell there.
    Turned,
}

/// What is reported of that.
pub(super) struct Said {
    /// Key of the glue that says otherwise.
    pub key: &'static str,
    pub value: String,
    pub bound: String,
    pub repair: &'static str,
}

impl Unheld {
    /// In words, of a particle at a place, its set and the shell.
    pub fn said(&self, [on, to]: [&str; 2], x: &Vec3) -> Said {
        let place = format!("({:.4}, {:.4}, {:.4})", x.x, x.y, x.z);
        match self {
            Self::Offset => Said {
                key: "follow",
                value: "\"director\"".into(),
                bound: format!(
                    "of a shell whose sections lie about its particles: those of `{to}` lie off them"
                ),
                repair: "leave `offset` of its sections out and place the shell there",
            },
            Self::Beyond { height, half } => Said {
                key: "on",
                value: format!("\"{on}\" with a particle at {place}"),
                bound: format!(
                    "which must lie within half the thickness of `{to}`, {half:.4e}, to follow its directors; it is {:.4e} off its middle",
                    height.abs()
                ),
                repair: "name that part of the face alone, by a box in [sets]",
            },
            Self::PastRim => Said {
                key: "on",
                value: format!("\"{on}\" with a place at {place}"),
                bound: format!(
                    "which must lie within two cells of `{to}`: its last cells are carried on beyond its rim"
                ),
                repair: "name that part of the face alone, by a box in [sets]",
            },
            Self::Turned => Said {
                key: "to",
                value: format!("\"{to}\" with a director that ties or a rigid set turn, near {place}"),
                bound: "but directors that are followed turn by themselves".into(),
                repair: "leave the edge that is joined out of [[ties]] and [[rigid]]",
            },
        }
    }
}

impl Directors {
    /// Those of a shell as it stands, with glue so many times as stiff as a cell of its section: `E/h` by area, h its spacing.
    pub fn of(shell: &Shell, over_cell: f64) -> Self {
        let half = shell.half_thicknesses();
        let thickness = 2.0 * shell.least_half_thickness().unwrap_or(f64::INFINITY);
        let spacing = shell.reference().cloud.spacing();
        Self {
            at: (0..shell.len()).map(|a| shell.director(a)).collect(),
            half,
            free: (0..shell.len()).map(|a| shell.turns_by_itself(a)).collect(),
            stiffness: over_cell * shell.least_membrane_stiffness() / (thickness * spacing),
        }
    }

    /// What holds particles of a set that have faces between them: at each the mean about it of what the shell gives places on these faces, so that
    /// either may be finer than the other ([`Dual`]). By particle; none where a place has no foot.
    ///
    /// # Errors
    /// A place that the directors cannot hold, with what keeps it.
    pub fn means(
        &self,
        (cells, set): (&[Cell], &[u32]),
        (rest, spacing): (&[Vec3], f64),
        raised: impl Fn(&Vec3) -> Option<Raised>,
    ) -> Result<BTreeMap<u32, HeldAt>, (Vec3, Unheld)> {
        let set: BTreeSet<u32> = set.iter().copied().collect();
        let mut sums: BTreeMap<u32, (BTreeMap<u32, f64>, f64)> = BTreeMap::new();
        let corners = |cell: &Cell| cell.corners[..usize::from(cell.count)].to_vec();
        for cell in cells.iter().map(corners).filter(|cell| cell.iter().all(|a| set.contains(a))) {
            let at: Vec<Vec3> = cell.iter().map(|&a| rest[a as usize]).collect();
            let Some(dual) = Dual::on(&at, spacing) else { continue };
            for (place, counts) in dual.places.iter().zip(&dual.counts) {
                let Some(raised) = raised(place) else { return Ok(BTreeMap::new()) };
                let own = self.numbers(&raised).map_err(|why| (*place, why))?;
                for (a, count) in cell.iter().zip(counts) {
                    let (sum, _) = sums.entry(*a).or_default();
                    own.iter().for_each(|(b, number)| *sum.entry(*b).or_default() += count * number);
                }
            }
            cell.iter().zip(&dual.areas).for_each(|(a, area)| sums.entry(*a).or_default().1 += area);
        }
        let mean = |(a, (sum, area)): (u32, (BTreeMap<u32, f64>, f64))| {
            (a, self.held(sum.into_iter().map(|(b, number)| (b, number / area))))
        };
        Ok(sums.into_iter().map(mean).collect())
    }

    /// The places of the shell that hold a particle which stands so over its surface, `Σ w_i (x_i + ζ d_i)`, and how: particles, then directors
    /// behind them.
    ///
    /// # Errors
    /// What keeps it from being held.
    pub fn places(&self, raised: &Raised) -> Result<HeldAt, Unheld> {
        Ok(self.held(self.numbers(raised)?.into_iter()))
    }

    /// Places with numbers that are more than rounding.
    fn held(&self, all: impl Iterator<Item = (u32, f64)>) -> HeldAt {
        let size = |b: u32| match (&self.half, (b as usize).checked_sub(self.at.len())) {
            (Some(half), Some(a)) => half[a],
            _ => 1.0,
        };
        let (places, numbers) = all.filter(|&(b, number)| number.abs() > ROUNDING * size(b)).unzip();
        (places, Hold::Places(numbers))
    }

    fn numbers(&self, raised: &Raised) -> Result<Vec<(u32, f64)>, Unheld> {
        let half = self.half.as_ref().ok_or(Unheld::Offset)?;
        let half = raised.weights.iter().map(|&(a, weight)| weight * half[a as usize]).sum::<f64>();
        if raised.height.abs() > (1.0 + BEYOND) * half {
            return Err(Unheld::Beyond { height: raised.height, half });
        }
        if raised.weights.iter().any(|&(_, weight)| weight < WITHIN) {
            return Err(Unheld::PastRim);
        }
        if raised.weights.iter().any(|&(a, _)| !self.free[a as usize]) {
            return Err(Unheld::Turned);
        }
        let director = |&(a, weight): &(u32, f64)| (self.at.len() as u32 + a, weight * raised.height);
        Ok(raised.weights.iter().copied().chain(raised.weights.iter().map(director)).collect())
    }
}
