//! What stands in a page beside its numbers, and where each run of numbers lies in the text of all of them.

use serde::Serialize;

use crate::body::Body;
use crate::pack;
use crate::show::{Column, Instant, Show};
use crate::track::{Range, Track};

/// A run of numbers: its first character in the text, and how many.
pub(crate) type Blob = [usize; 2];

/// The text of all numbers, under way.
#[derive(Default)]
pub(crate) struct Text(pub String);

impl Text {
    /// Adds a run of numbers.
    pub fn add(&mut self, run: &str) -> Blob {
        let at = self.0.len();
        self.0.push_str(run);
        [at, run.len()]
    }
}

/// All but the numbers.
#[derive(Serialize)]
pub(crate) struct Head<'a> {
    title: &'a str,
    facts: &'a [String],
    warnings: &'a [String],
    scene: &'a str,
    columns: &'a [Column],
    rows: &'a [Vec<f64>],
    plot: &'a Option<[String; 2]>,
    frames: &'a [Instant],
    sizeless: bool,
    wanted: &'a [String],
    reload: Option<f64>,
    /// What the page was too large for, in words.
    left_out: &'a [String],
    /// The middle of all bodies over all frames \[L\], at rest where motions have no size: places are about it.
    origin: [f64; 3],
    /// From the middle to a corner of the box round the same \[L\].
    half: [f64; 3],
    /// The axis along which a plane scene is seen.
    plane: Option<usize>,
    bodies: Vec<BodyHead<'a>>,
}

#[derive(Serialize)]
struct BodyHead<'a> {
    name: &'a str,
    count: usize,
    face_count: usize,
    shell: bool,
    glass: bool,
    /// Whether the displacement is a field to look at.
    displaced: bool,
    rest: Blob,
    faces: Blob,
    border: Blob,
    sizes: Option<Blob>,
    sets: Vec<(&'a str, Blob)>,
    motion: TrackHead<'a>,
    fields: Vec<TrackHead<'a>>,
}

#[derive(Serialize)]
struct TrackHead<'a> {
    name: &'a str,
    unit: Option<&'a str>,
    components: &'a [String],
    width: usize,
    ranges: &'a [Range],
    lengths: Option<Range>,
    frames: Vec<Blob>,
}

/// A track with its frames as text.
pub(crate) struct Packed {
    pub ranges: Vec<Range>,
    pub frames: Vec<String>,
}

impl Packed {
    /// Characters.
    pub fn size(&self) -> usize {
        self.frames.iter().map(String::len).sum()
    }
}

impl<'a> Head<'a> {
    /// All but the numbers, which go into `text`; `packed` are the tracks of each body, the motion first.
    pub fn new(show: &'a Show, packed: &'a [Vec<Packed>], left_out: &'a [String], text: &mut Text) -> Self {
        let boxes: Vec<_> = show.bodies.iter().map(|body| extent(body, true)).collect();
        let [low, high] = match show.sizeless {
            false => boxes.iter().copied().fold(NOWHERE, joined),
            true => show.bodies.iter().map(|body| extent(body, false)).fold(NOWHERE, joined),
        };
        let empty = low[0] > high[0];
        let each = |of: &dyn Fn(usize) -> f64| if empty { [0.0; 3] } else { [0, 1, 2].map(of) };
        let origin = each(&|k| 0.5 * (low[k] + high[k]));
        let half = each(&|k| 0.5 * (high[k] - low[k]));
        let bodies =
            show.bodies.iter().zip(packed).map(|(body, packed)| body_head(body, packed, origin, text));
        Self {
            bodies: bodies.collect(),
            title: &show.title,
            facts: &show.facts,
            warnings: &show.warnings,
            scene: &show.scene,
            columns: &show.columns,
            rows: &show.rows,
            plot: &show.plot,
            frames: &show.frames,
            sizeless: show.sizeless,
            wanted: &show.wanted,
            reload: show.reload,
            left_out,
            origin,
            half,
            plane: plane(show, &boxes),
        }
    }
}

fn body_head<'a>(body: &'a Body, packed: &'a [Packed], origin: [f64; 3], text: &mut Text) -> BodyHead<'a> {
    let about = |x: &[f64; 3]| [0, 1, 2].map(|k| (x[k] - origin[k]) as f32);
    let rest: Vec<f32> = body.rest.iter().flat_map(about).collect();
    let mut tracks: Vec<TrackHead<'a>> =
        body.tracks().zip(packed).map(|(track, packed)| track_head(track, packed, text)).collect();
    let motion = tracks.remove(0);
    let flat = |rows: &'a [[u32; 4]]| rows.as_flattened().iter().copied();
    BodyHead {
        name: &body.name,
        count: body.rest.len(),
        face_count: body.faces.faces.len(),
        shell: body.shell,
        glass: body.glass,
        displaced: body.displaced,
        rest: text.add(&pack::single(rest.into_iter())),
        faces: text.add(&pack::whole(flat(&body.faces.faces))),
        border: text.add(&pack::whole(body.faces.border.as_flattened().iter().copied())),
        sizes: (!body.sizes.is_empty()).then(|| text.add(&pack::single(body.sizes.iter().copied()))),
        sets: body
            .sets
            .iter()
            .map(|(name, points)| (name.as_str(), text.add(&pack::whole(points.iter().copied()))))
            .collect(),
        motion,
        fields: tracks,
    }
}

fn track_head<'a>(track: &'a Track, packed: &'a Packed, text: &mut Text) -> TrackHead<'a> {
    TrackHead {
        name: &track.name,
        unit: track.unit.as_deref(),
        components: &track.components,
        width: track.width,
        ranges: &packed.ranges,
        lengths: track.is_vector().then(|| track.lengths()),
        frames: packed.frames.iter().map(|frame| text.add(frame)).collect(),
    }
}

/// A box that holds nothing.
const NOWHERE: [[f64; 3]; 2] = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
/// Extent below which a body is flat, in parts of the greatest one.
const FLAT: f64 = 1e-6;

fn joined([low, high]: [[f64; 3]; 2], [a, b]: [[f64; 3]; 2]) -> [[f64; 3]; 2] {
    [[0, 1, 2].map(|k| low[k].min(a[k])), [0, 1, 2].map(|k| high[k].max(b[k]))]
}

/// The box round a body at rest and, if it is moved, over all frames \[L\].
fn extent(body: &Body, moved: bool) -> [[f64; 3]; 2] {
    let mut found = NOWHERE;
    body.rest.iter().for_each(|&x| found = joined(found, [x; 2]));
    for frame in body.motion.frames.iter().filter(|_| moved) {
        for (x, u) in body.rest.iter().zip(frame.chunks_exact(3)) {
            let at = [0, 1, 2].map(|k| x[k] + f64::from(u[k]));
            if at.iter().all(|x| x.is_finite()) {
                found = joined(found, [at; 2]);
            }
        }
    }
    found
}

/// The axis along which a scene is plane: no body has an extent along it, or particles beside sheets have none.
fn plane(show: &Show, boxes: &[[[f64; 3]; 2]]) -> Option<usize> {
    let flat = |wanted: &dyn Fn(&Body) -> bool| {
        let own = show.bodies.iter().zip(boxes).filter(|(body, _)| wanted(body)).map(|(_, &own)| own);
        let [low, high] = own.fold(NOWHERE, joined);
        let size = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
        (0..3).rev().find(|&k| size > 0.0 && high[k] - low[k] <= FLAT * size)
    };
    // A row of particles, or one alone, has no plane.
    flat(&|_| true).or_else(|| flat(&|body| body.faces.faces.is_empty() && body.rest.len() > 2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mesh_io::Sheet;

    fn show(points: &[[f64; 3]], cells: &[Vec<usize>]) -> Show {
        let sheet = Sheet { points: points.into(), cells: cells.into(), ..Sheet::default() };
        let mut body = Body::new("a", &sheet);
        body.add(&sheet).unwrap();
        Show { bodies: vec![body], ..Show::default() }
    }

    fn seen(show: &Show) -> Option<usize> {
        plane(show, &show.bodies.iter().map(|body| extent(body, true)).collect::<Vec<_>>())
    }

    #[test]
    fn plane_scenes_are_known_by_their_flat_axis_in_every_frame() {
        let square = [[0.0, 2.0, 0.0], [1.0, 2.0, 0.0], [1.0, 2.0, 3.0]];
        assert_eq!(seen(&show(&square, &[vec![0], vec![1], vec![2]])), Some(1));
        let mut plate = show(&square, &[vec![0, 1, 2]]);
        assert_eq!(seen(&plate), Some(1));
        plate.bodies[0].motion.frames.push([0.0, 0.1, 0.0].repeat(3));
        assert_eq!(seen(&plate), None, "a plate that bends is no plane scene");
    }

    #[test]
    fn a_strip_of_shell_in_a_plane_fluid_is_seen_straight() {
        let mut both = show(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[vec![0], vec![1], vec![2]]);
        let strip = show(&[[0.5, 0.0, -0.1], [0.5, 1.0, -0.1], [0.5, 1.0, 0.1]], &[vec![0, 1, 2]]);
        both.bodies.extend(strip.bodies);
        assert_eq!(seen(&both), Some(2));
    }
}
