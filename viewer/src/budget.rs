//! What goes when a page would be too large: frames down to forty, fields, then further frames.

use rayon::prelude::*;

use crate::head::Packed;
use crate::pack;
use crate::show::Show;
use crate::track::Track;

/// Frames that no field is worth.
const WORTH: usize = 40;
/// Share of the room that frames may be expected to need: those that stay differ more from each other.
const CAUTION: f64 = 0.9;

/// A show that fits, its tracks as text, and what was left out, in words.
pub(crate) struct Fitted {
    pub show: Show,
    pub packed: Vec<Vec<Packed>>,
    pub left_out: Vec<String>,
}

/// Leaves out until no more than so many characters are left; two frames of the motion stay, however large.
pub(crate) fn fitted(mut show: Show, most: usize) -> Fitted {
    let all = show.frames.len();
    let mut packed = pack_all(&show);
    let mut dropped: Vec<String> = Vec::new();
    loop {
        let size = packed.iter().flatten().map(Packed::size).sum::<usize>();
        let frames = show.frames.len();
        if size <= most || frames <= 2 && fields(&show).is_empty() {
            break;
        }
        let wanted = (frames as f64 * CAUTION * most as f64 / size as f64) as usize;
        if frames > WORTH {
            thin(&mut show, wanted.max(WORTH).min(frames - 1));
            packed = pack_all(&show);
        } else if let Some(name) = least_worth(&show, &packed) {
            drop_field(&mut show, &mut packed, &name);
            dropped.push(name);
        } else {
            thin(&mut show, wanted.clamp(2, frames.max(3) - 1));
            packed = pack_all(&show);
        }
    }
    let mut left_out = Vec::new();
    if show.frames.len() < all {
        left_out.push(format!("{} of {all} frames", show.frames.len()));
    }
    if !dropped.is_empty() {
        left_out.push(format!("without {}", dropped.join(", ")));
    }
    Fitted { show, packed, left_out }
}

fn pack_all(show: &Show) -> Vec<Vec<Packed>> {
    let of = |track: &Track| {
        let ranges = track.ranges();
        let frames = (0..track.frames.len()).into_par_iter();
        let frames = frames.map(|number| pack::frame(track, &ranges, number)).collect();
        Packed { ranges, frames }
    };
    show.bodies.iter().map(|body| body.tracks().map(of).collect()).collect()
}

/// Names of all fields, those that are kept longest in front, else the smaller ones.
fn fields(show: &Show) -> Vec<&str> {
    let mut names: Vec<&str> =
        show.bodies.iter().flat_map(|body| &body.fields).map(|track| track.name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// The field that goes next: of those that nobody wants the largest, then the last that is wanted; the first stays as
/// long as more than a few frames do.
fn least_worth(show: &Show, packed: &[Vec<Packed>]) -> Option<String> {
    let names = fields(show);
    let size = |name: &str| -> usize {
        let of = |(body, packed): (&crate::Body, &Vec<Packed>)| -> usize {
            let own = body.tracks().zip(packed).skip(1).filter(|(track, _)| track.name == name);
            own.map(|(_, packed)| packed.size()).sum()
        };
        show.bodies.iter().zip(packed).map(of).sum()
    };
    let place = |name: &str| show.wanted.iter().position(|wanted| wanted == name).unwrap_or(usize::MAX);
    let last = names.iter().max_by_key(|name| (place(name), size(name)))?;
    (names.len() > 1 || show.frames.len() <= 2).then(|| (*last).into())
}

fn drop_field(show: &mut Show, packed: &mut [Vec<Packed>], name: &str) {
    for (body, packed) in show.bodies.iter_mut().zip(packed) {
        if let Some(at) = body.fields.iter().position(|track| track.name == name) {
            body.fields.remove(at);
            packed.remove(at + 1);
        }
    }
}

/// Keeps so many frames, evenly, the first and the last among them.
fn thin(show: &mut Show, keep: usize) {
    let last = show.frames.len() - 1;
    let kept: Vec<usize> = (0..keep).map(|i| i * last / (keep - 1)).collect();
    let mut frames = std::mem::take(&mut show.frames);
    show.frames = kept.iter().map(|&at| std::mem::take(&mut frames[at])).collect();
    for track in show.bodies.iter_mut().flat_map(|body| body.tracks_mut()) {
        let mut frames = std::mem::take(&mut track.frames);
        track.frames = kept.iter().map(|&at| std::mem::take(&mut frames[at])).collect();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Body, Instant};
    use mesh_io::{Array, Sheet};

    /// A hundred points in so many frames, with three fields of noise.
    fn noise(frames: usize) -> Show {
        let mut seed = 1_u32;
        let mut next = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed)
        };
        let array = |width: usize, next: &mut dyn FnMut() -> f64| Array {
            components: Vec::new(),
            unit: None,
            width,
            numbers: (0..100 * width).map(|_| next()).collect(),
        };
        let mut sheet = || Sheet {
            points: vec![[0.0; 3]; 100],
            cells: (0..100).map(|i| vec![i]).collect(),
            point_data: ["displacement", "pressure", "velocity", "age"]
                .map(|name| {
                    (name.to_string(), array(if name.starts_with(['d', 'v']) { 3 } else { 1 }, &mut next))
                })
                .into(),
            ..Sheet::default()
        };
        let mut body = Body::new("water", &sheet());
        for _ in 0..frames {
            body.add(&sheet()).unwrap();
        }
        let frames = (0..frames).map(|i| Instant { along: i as f64, ..Instant::default() }).collect();
        Show { frames, bodies: vec![body], wanted: vec!["pressure".into()], ..Show::default() }
    }

    #[test]
    fn frames_go_first_then_fields_then_frames() {
        // Noise takes 2 bytes a number, 4/3 characters a byte: 2133 characters a frame and eight numbers a point.
        let size = |show: &Fitted| show.packed.iter().flatten().map(Packed::size).sum::<usize>();
        let whole = fitted(noise(100), 1_000_000);
        assert_eq!((whole.show.frames.len(), whole.left_out.len()), (100, 0));
        let thinned = fitted(noise(100), 150_000);
        assert!(size(&thinned) <= 150_000 && thinned.show.frames.len() >= WORTH);
        assert_eq!(thinned.show.bodies[0].fields.len(), 3);
        let alongs: Vec<f64> = thinned.show.frames.iter().map(|frame| frame.along).collect();
        assert_eq!((alongs[0], alongs.last()), (0.0, Some(&99.0)));
        let poorer = fitted(noise(100), 50_000);
        assert_eq!(poorer.show.frames.len(), WORTH);
        let names: Vec<&str> = poorer.show.bodies[0].fields.iter().map(|track| track.name.as_str()).collect();
        assert_eq!(names, ["pressure"], "{:?}", poorer.left_out);
        assert_eq!(poorer.left_out, ["40 of 100 frames", "without velocity, age"]);
        let poorest = fitted(noise(100), 1);
        assert_eq!((poorest.show.frames.len(), poorest.show.bodies[0].fields.len()), (2, 0));
    }
}
