//! Named sets of particles: edges, corners and middle rows of the lattice, nearest particles, boxes, and what is made of sets.

use std::collections::{BTreeMap, BTreeSet};

use sph_core::{Cloud, EndWeights, Lattice, Side, Vec3};

use crate::scene::Region;
use crate::scene::body_in_scene::{BodyInScene, ShellInScene};
use crate::scene::error::SceneError;
use crate::scene::sets::BUILT_IN;

/// The particle sets of a cloud, by name.
#[derive(Clone, Debug)]
pub(crate) struct Sets {
    members: BTreeMap<String, Vec<u32>>,
}

impl Sets {
    /// Finds every set that the scene uses or declares; `cloud` is not rotated yet, `brought` are those of its file.
    pub(crate) fn find(
        scene: &ShellInScene<'_>,
        cloud: &Cloud,
        brought: Option<BTreeMap<String, Vec<u32>>>,
    ) -> Result<Self, SceneError> {
        let members = match brought {
            Some(members) => members,
            None => {
                let found = |name: &str| Some((name.to_string(), built_in(name, cloud)?));
                BUILT_IN.into_iter().filter_map(found).collect()
            }
        };
        let mut sets = Self { members };
        let own = |path: &str, name: &str| sets.at(scene, path, name).map(<[u32]>::to_vec);
        let pick = |region: &Region| inside(region, &cloud.positions, cloud.spacing());
        let declared = Declared { scene, positions: &cloud.positions, own: &own, pick: &pick }.all()?;
        sets.members.extend(declared);
        Ok(sets)
    }

    /// All sets by name.
    pub(crate) fn into_members(self) -> BTreeMap<String, Vec<u32>> {
        self.members
    }

    /// Particles of the set that the scene names at `path`.
    pub(crate) fn at(&self, scene: &ShellInScene<'_>, path: &str, name: &str) -> Result<&[u32], SceneError> {
        self.members.get(name).map(Vec::as_slice).ok_or_else(|| {
            if scene.shell.geometry.mesh().is_some() {
                return no_such_set(scene, path, name, &Vec::from_iter(self.members.keys()));
            }
            let (direction, i) = if name == "centre-row" { ("v", 1) } else { ("u", 0) };
            let (bound, repair) = match scene.shell.geometry.particles() {
                Some(counts) => (
                    format!("but there is no middle one among {} particles along {direction}", counts[i]),
                    format!("use an odd number of particles along {direction}"),
                ),
                None => (
                    "but scattered particles stand in no rows".into(),
                    "declare a set with a box, model half of the shell with a symmetry plane on the cut edge, or \
                     place a lattice with `particles`"
                        .into(),
                ),
            };
            SceneError::Set(scene.source.fault(path, &format!("\"{name}\""), &bound, &repair))
        })
    }
}

/// Members of a set, or why it has none.
pub(super) type Members = Result<Vec<u32>, SceneError>;

/// The sets that the scene of a body declares, to be found.
pub(super) struct Declared<'a> {
    pub scene: &'a BodyInScene<'a>,
    /// Places in the frame of the regions \[L\].
    pub positions: &'a [Vec3],
    /// Members of a set that the body has of itself, named at a path.
    pub own: &'a dyn Fn(&str, &str) -> Members,
    /// Members in a region of space.
    pub pick: &'a dyn Fn(&Region) -> Vec<u32>,
}

impl Declared<'_> {
    /// All of them by name.
    ///
    /// # Errors
    /// [`SceneError::Set`] for a set without members; what `own` refuses.
    pub fn all(&self) -> Result<BTreeMap<String, Vec<u32>>, SceneError> {
        let one = |(name, region): (&&str, &&Region)| Ok(((*name).to_string(), self.one(name, region)?));
        self.scene.sets.iter().map(one).collect()
    }

    /// The members of one.
    ///
    /// # Errors
    /// As of all.
    pub fn one(&self, name: &str, region: &Region) -> Members {
        let found = match region.made() {
            None => (self.pick)(region),
            // The checks leave no set that is made of itself.
            Some((made, sets)) => {
                let each = sets.iter().enumerate().map(|(i, set)| {
                    let set = self.scene.own_set(set);
                    match self.scene.sets.get(set) {
                        Some(region) => self.one(set, region),
                        None => (self.own)(&format!("sets.{name}.{}[{i}]", made.word()), set),
                    }
                });
                made.members(&each.collect::<Result<Vec<_>, _>>()?)
            }
        };
        if found.is_empty() { Err(empty(self.scene, name, region, self.positions)) } else { Ok(found) }
    }
}

/// The particles of a set, one for each place: the first of those that a junction ties stands for all of them.
pub(crate) fn places<'a>(cloud: &'a Cloud, particles: &'a [u32]) -> impl Iterator<Item = u32> + 'a {
    let mut first: BTreeMap<u32, u32> = BTreeMap::new();
    for group in &cloud.joined {
        first.extend(group.iter().map(|&a| (a, group[0])));
    }
    let mut reported = BTreeSet::new();
    particles.iter().filter_map(move |a| match first.get(a) {
        None => Some(*a),
        Some(&first) => reported.insert(first).then_some(first),
    })
}

fn built_in(name: &str, cloud: &Cloud) -> Option<Vec<u32>> {
    let sides = cloud.sides.as_ref()?;
    let corner = |u, v| sides.corner(u, v).map(|a| vec![a]);
    match name {
        "all" => Some((0..cloud.len() as u32).collect()),
        "u0v0" => corner(Side::U0, Side::V0),
        "u1v0" => corner(Side::U1, Side::V0),
        "u0v1" => corner(Side::U0, Side::V1),
        "u1v1" => corner(Side::U1, Side::V1),
        "centre-row" => middle(cloud, 1).map(|(lattice, j)| lattice.row(j)),
        "centre-column" => middle(cloud, 0).map(|(lattice, i)| lattice.column(i)),
        _ => side(name).map(|side| sides.edge(side).to_vec()),
    }
}

/// The lattice of a cloud with the place of its middle row or column; none without one.
fn middle(cloud: &Cloud, direction: usize) -> Option<(Lattice, usize)> {
    let lattice = cloud.lattice?;
    let n = lattice.counts[direction];
    (n % 2 == 1).then_some((lattice, n / 2))
}

fn side(name: &str) -> Option<Side> {
    match name {
        "u0" => Some(Side::U0),
        "u1" => Some(Side::U1),
        "v0" => Some(Side::V0),
        "v1" => Some(Side::V1),
        _ => None,
    }
}

/// Particles, or other places, in a region, `spacing` apart \[L\].
pub(crate) fn inside(region: &Region, positions: &[Vec3], spacing: f64) -> Vec<u32> {
    let numbered = || positions.iter().enumerate().map(|(a, x)| (a as u32, x));
    if let Some(point) = region.nearest {
        let distance = |x: &Vec3| (x - Vec3::from(point)).norm_squared();
        let nearest = numbered().min_by(|(_, x), (_, y)| distance(x).total_cmp(&distance(y)));
        return nearest.map(|(a, _)| a).into_iter().collect();
    }
    if let Some(near) = region.near {
        // A particle at the distance belongs to the ball, whatever rounding did to it.
        let reach = near.distance.get() + 1e-9 * spacing;
        let within = |x: &Vec3| (x - Vec3::from(near.point)).norm() <= reach;
        return numbered().filter(|(_, x)| within(x)).map(|(a, _)| a).collect();
    }
    if let Some(plane) = region.plane {
        let normal = Vec3::from(plane.normal).normalize();
        let within = plane.within.map_or(1e-3 * spacing, |within| within.get());
        let on = |x: &Vec3| (x - Vec3::from(plane.point)).dot(&normal).abs() <= within;
        return numbered().filter(|(_, x)| on(x)).map(|(a, _)| a).collect();
    }
    let Some(faces) = region.inside else { return Vec::new() };
    // A particle on a face belongs to the box, whatever rounding did to it.
    let slack = 1e-9 * spacing;
    let holds = |x: &Vec3| (0..3).all(|i| faces.min[i] - slack <= x[i] && x[i] <= faces.max[i] + slack);
    numbered().filter(|(_, x)| holds(x)).map(|(a, _)| a).collect()
}

/// Refusal of a declared set without particles.
fn empty(scene: &BodyInScene<'_>, name: &str, region: &Region, positions: &[Vec3]) -> SceneError {
    let path = format!("sets.{name}");
    if let Some((made, _)) = region.made() {
        let bound = format!("the {} of its sets holds no particle", made.word());
        let repair = "see where the sets lie: `coque view` shows them, or give each a column of the curve";
        return SceneError::Set(scene.source.fault(&path, "empty", &bound, repair));
    }
    let [least, greatest] = [f64::min, f64::max].map(|pick| corner(positions, pick));
    let repair = format!("the {} lies between {least} and {greatest}", scene.body.word());
    let bound = "its region holds no particle";
    SceneError::Set(scene.source.fault(&path, "empty", bound, &repair))
}

/// One corner of the box round particles.
fn corner(positions: &[Vec3], pick: fn(f64, f64) -> f64) -> String {
    let extreme = positions.iter().copied().reduce(|a, b| a.zip_map(&b, pick)).unwrap_or_default();
    format!("[{:.4}, {:.4}, {:.4}]", extreme.x, extreme.y, extreme.z)
}

/// Particles with tributary lengths \[L\] on the edge called `name`; none if it is no edge.
///
/// The lengths are those along this edge alone (a corner has half a spacing), weighted like the areas of the cloud.
pub(crate) fn edge(
    name: &str,
    particles: &[u32],
    cloud: &Cloud,
    weights: EndWeights,
) -> Option<Vec<(u32, f64)>> {
    side(name)?;
    let gaps: Vec<f64> = particles
        .windows(2)
        .map(|pair| (cloud.positions[pair[1] as usize] - cloud.positions[pair[0] as usize]).norm())
        .collect();
    let half = |gap: Option<&f64>| gap.map_or(0.0, |gap| 0.5 * gap);
    let trapezoid = |i: usize| half(i.checked_sub(1).and_then(|i| gaps.get(i))) + half(gaps.get(i));
    let lengths: Vec<f64> = match (weights, weights.weights(particles.len())) {
        (EndWeights::Gregory, Ok(weights)) => {
            let mean = gaps.iter().sum::<f64>() / gaps.len() as f64;
            weights.into_iter().map(|w| w * mean).collect()
        }
        _ => (0..particles.len()).map(trapezoid).collect(),
    };
    Some(particles.iter().copied().zip(lengths).collect())
}

/// Refusal of a set that neither the file nor the scene has.
fn no_such_set(scene: &ShellInScene<'_>, path: &str, name: &str, known: &[&String]) -> SceneError {
    let known: Vec<&str> = known.iter().map(|name| name.as_str()).collect();
    let mut repair = crate::scene::source::suggest(name, &known);
    if BUILT_IN.contains(&name) {
        repair = format!("a mesh has no rows and columns; known here: {}", known.join(", "));
    }
    SceneError::Set(scene.source.fault(path, &format!("\"{name}\""), "which is no set of this mesh", &repair))
}
