//! Places along the middle line of a strip, for plane problems.
//!
//! A strip lies across the plane z = 0. Its particles stand in rows along z, the stations, which cells join to lines.
//! What acts on the line per depth acts on the strip times its width, and is shared over a station by the widths that
//! its particles stand for.

use sph_core::{Cloud, Vec3};

use crate::error::ShellError;
use crate::wetted::places::Places;
use crate::wetted::wetting::Wetting;

/// Part of the spacing within which particles count as one above another.
const ABOVE: f64 = 1e-6;

/// The middle line of a strip.
struct Strip {
    /// By station: its particles with the part of the width that each stands for.
    stations: Vec<Vec<(u32, f64)>>,
    /// By station: its place in the plane \[L\].
    places: Vec<Vec3>,
    /// By station: those that cells join it to, ascending.
    next: Vec<Vec<usize>>,
    width: f64,
}

/// Columns of points, then places of free edges; lengths that columns stand for \[L\]; the width of the strip \[L\].
pub(super) struct WettedFaces {
    pub middle: Places,
    pub areas: Vec<f64>,
    pub width: f64,
}

/// Lays places along the middle line of a strip.
///
/// # Errors
/// [`ShellError`] for a shell that is no strip across the plane, and for free edges that are none of its ends.
pub(super) fn along_strip(cloud: &Cloud, wetting: &Wetting) -> Result<WettedFaces, ShellError> {
    let strip = Strip::new(cloud)?;
    let (mut middle, mut areas) = (Places::default(), Vec::new());
    for line in strip.lines() {
        let lengths: Vec<f64> =
            line.windows(2).map(|ends| (strip.places[ends[1]] - strip.places[ends[0]]).norm()).collect();
        let whole: f64 = lengths.iter().sum();
        let count = wetting.count(whole);
        for number in 0..count {
            let (segment, part) = locate(&lengths, whole * (number as f64 + 0.5) / count as f64);
            let share = |station: usize, part: f64| {
                strip.stations[station].iter().map(move |&(particle, width)| (particle, part * width))
            };
            middle.push(share(line[segment], 1.0 - part).chain(share(line[segment + 1], part)));
            areas.push(whole / count as f64);
        }
    }
    let free = |station: &&Vec<(u32, f64)>| {
        station.iter().any(|(particle, _)| wetting.free_edges.contains(particle))
    };
    let before = middle.len();
    for (station, _) in strip.stations.iter().zip(&strip.next).filter(|(s, next)| free(s) && next.len() == 1)
    {
        middle.push(station.iter().copied());
    }
    if middle.len() == before && !wetting.free_edges.is_empty() {
        return Err(ShellError::NotAnEdge("a free edge in a fluid"));
    }
    Ok(WettedFaces { middle, areas, width: strip.width })
}

/// The segment of a line in which a distance along it ends, and the part of that segment \[–\].
pub(super) fn locate(lengths: &[f64], distance: f64) -> (usize, f64) {
    let mut left = distance;
    for (segment, length) in lengths.iter().enumerate() {
        if left <= *length || segment + 1 == lengths.len() {
            return (segment, (left / length).clamp(0.0, 1.0));
        }
        left -= length;
    }
    (0, 0.0)
}

impl Strip {
    fn new(cloud: &Cloud) -> Result<Self, ShellError> {
        let x = &cloud.positions;
        let apart = |a: u32, b: u32| {
            let d = x[b as usize] - x[a as usize];
            libm::hypot(d.x, d.y)
        };
        let near = ABOVE * cloud.spacing();
        let mut lowest: Vec<usize> = (0..x.len()).collect();
        let edges = || cloud.cells.iter().flat_map(|cell| cell.edges().collect::<Vec<_>>());
        for (a, b) in edges().filter(|&(a, b)| apart(a, b) < near) {
            let (a, b) = (root(&lowest, a as usize), root(&lowest, b as usize));
            lowest[a.max(b)] = a.min(b);
        }
        let mut number = vec![usize::MAX; x.len()];
        let mut members: Vec<Vec<u32>> = Vec::new();
        for a in 0..x.len() {
            let first = root(&lowest, a);
            if number[first] == usize::MAX {
                number[first] = members.len();
                members.push(Vec::new());
            }
            number[a] = number[first];
            members[number[a]].push(a as u32);
        }
        let mut next = vec![Vec::new(); members.len()];
        for (a, b) in edges().map(|(a, b)| (number[a as usize], number[b as usize])).filter(|(a, b)| a != b) {
            next[a].push(b);
            next[b].push(a);
        }
        for next in &mut next {
            next.sort_unstable();
            next.dedup();
        }
        let mut width: Option<f64> = None;
        for station in &mut members {
            station.sort_by(|&a, &b| x[a as usize].z.total_cmp(&x[b as usize].z));
            let z = |a: Option<&u32>| a.map_or(0.0, |&a| x[a as usize].z);
            let (own, particle) = (z(station.last()) - z(station.first()), station[0]);
            let first = *width.get_or_insert(own);
            if station.len() < 2 || (own - first).abs() > ABOVE * first {
                return Err(ShellError::NotAStrip { particle, width: own, first });
            }
        }
        let width = width.unwrap_or(0.0);
        let shared = |station: &Vec<u32>| -> Vec<(u32, f64)> {
            let z = |i: usize| x[station[i] as usize].z;
            let last = station.len() - 1;
            let part = |i: usize| 0.5 * (z((i + 1).min(last)) - z(i.saturating_sub(1))) / width;
            station.iter().enumerate().map(|(i, &a)| (a, part(i))).collect()
        };
        let places = members.iter().map(|station| x[station[0] as usize]).map(|x| Vec3::new(x.x, x.y, 0.0));
        Ok(Self { places: places.collect(), stations: members.iter().map(shared).collect(), next, width })
    }

    /// Lines from end to end, or from fork to fork; those that close last, their first station twice.
    fn lines(&self) -> Vec<Vec<usize>> {
        let mut seen = vec![false; self.next.len()];
        let mut lines = Vec::new();
        for start in (0..self.next.len()).filter(|&station| self.next[station].len() != 2) {
            for &next in &self.next[start] {
                let line = self.follow(start, next);
                // A line is met from both of its ends; of two between the same forks the second station tells.
                let (ends, back) = ([line[0], line[line.len() - 1]], [line[1], line[line.len() - 2]]);
                if (ends[0], back[0]) <= (ends[1], back[1]) {
                    lines.push(line.clone());
                }
                line.iter().for_each(|&station| seen[station] = true);
            }
        }
        for start in 0..self.next.len() {
            if !seen[start] && self.next[start].len() == 2 {
                let line = self.follow(start, self.next[start][0]);
                line.iter().for_each(|&station| seen[station] = true);
                lines.push(line);
            }
        }
        lines
    }

    fn follow(&self, start: usize, next: usize) -> Vec<usize> {
        let mut line = vec![start, next];
        let (mut from, mut at) = (start, next);
        while at != start && self.next[at].len() == 2 {
            let on = self.next[at][usize::from(self.next[at][0] == from)];
            (from, at) = (at, on);
            line.push(at);
        }
        line
    }
}

/// The lowest particle that one is joined to.
fn root(lowest: &[usize], mut a: usize) -> usize {
    while lowest[a] != a {
        a = lowest[a];
    }
    a
}
