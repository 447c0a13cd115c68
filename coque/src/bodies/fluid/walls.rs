//! The rows of particles of walls, as a fluid takes them: a piece for each side of a basin, else one.

use std::collections::HashMap;
use std::path::Path;

use mesh_io::surface::read;
use sph_core::{
    SpaceError, Vec3, basin_rows, block_rows, leaks, polyline_first_row, polyline_rows, surface_first_row,
    surface_rows,
};

use crate::bodies::refusal::body_error;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::bounded::numbers;
use crate::scene::error::SceneError;
use crate::scene::sets::OF_WALLS;
use crate::scene::{Basin, Obstacle, PeriodicSides, WallGeometry, WallSurface, WallsScene};

/// Part of a spacing behind a face up to which a particle belongs to the first row.
const FIRST: f64 = 0.75;

/// Distance in spacings within which a wall that comes in through a side stands where one is.
const NEAR: f64 = 0.6;

/// A part of the walls of a body, of which the force is distinguished.
#[derive(Clone, Debug, Default)]
pub(in crate::bodies) struct Piece {
    /// The side of a basin.
    pub side: Option<&'static str>,
    /// Its particles at rest \[L\].
    pub points: Vec<Vec3>,
    /// Whether each stands next to the fluid; all of them where rows are not distinguished.
    pub first: Vec<bool>,
}

/// A particle behind two sides of a basin or three.
#[derive(Clone, Debug)]
pub(in crate::bodies) struct Corner {
    /// The piece that has it, and its number there.
    pub piece: usize,
    pub particle: usize,
    /// The pieces of the sides that it is behind, each with the axis of its normal.
    pub sides: Vec<(usize, usize)>,
}

impl Corner {
    /// The part of the force on it, by component, that one of its sides is reported: the whole of that along its own normal, none of that
    /// along the normal of another, and an equal part of what lies along the edge. Of a basin that turns, whose normals are those of the
    /// axes at rest only, equal parts.
    pub fn part(&self, piece: usize, turns: bool) -> Vec3 {
        let equal = 1.0 / self.sides.len() as f64;
        Vec3::from([0, 1, 2].map(|axis| {
            let normal = self.sides.iter().find(|side| side.1 == axis && !turns);
            normal.map_or(equal, |side| f64::from(u8::from(side.0 == piece)))
        }))
    }
}

/// Walls of one body.
#[derive(Clone, Debug, Default)]
pub(in crate::bodies) struct Rows {
    /// Its pieces.
    pub pieces: Vec<Piece>,
    /// Particles of which sides share the force.
    pub corners: Vec<Corner>,
    /// Places where the first row has a gap through which a fluid may leak.
    pub leaks: usize,
}

impl Rows {
    /// Leaves out what stands beyond periodic sides, where the wall that comes in by the opposite ones stands already; a particle on both sides is one.
    ///
    /// # Errors
    /// A place beyond the sides whose image in the box has no wall.
    pub fn cut(&mut self, periodic: &PeriodicSides, spacing: f64) -> Result<(), Vec3> {
        let sides = periodic.sides();
        let rounding = 1e-6 * spacing;
        let beyond = |x: &Vec3| {
            let out = |(axis, sides): (usize, &Option<[f64; 2]>)| {
                sides.is_some_and(|[low, high]| x[axis] < low - rounding || x[axis] >= high - rounding)
            };
            sides.iter().enumerate().any(out)
        };
        let all = || self.pieces.iter().flat_map(|piece| &piece.points);
        let inside: HashMap<[i64; 3], Vec<Vec3>> =
            all().filter(|x| !beyond(x)).fold(HashMap::new(), |mut map, x| {
                map.entry(place(x, spacing)).or_default().push(*x);
                map
            });
        let image = |x: &Vec3| {
            let along = |axis: usize| match sides[axis] {
                Some([low, high]) => {
                    x[axis] - libm::floor((x[axis] - low + rounding) / (high - low)) * (high - low)
                }
                None => x[axis],
            };
            Vec3::new(along(0), along(1), along(2))
        };
        let away = |way: Vec3| {
            let along = |axis: usize| match sides[axis] {
                Some([low, high]) => way[axis] - (high - low) * libm::round(way[axis] / (high - low)),
                None => way[axis],
            };
            Vec3::new(along(0), along(1), along(2)).norm()
        };
        // Near a side the other row stands a period away.
        let stands = |x: &Vec3| {
            let near = |at: Vec3| {
                let [i, j, k] = place(&at, spacing);
                let cells = (-1..=1).flat_map(move |a| {
                    (-1..=1).flat_map(move |b| (-1..=1).map(move |c| [i + a, j + b, k + c]))
                });
                cells.filter_map(|cell| inside.get(&cell)).flatten().any(|y| away(x - y) < NEAR * spacing)
            };
            let shifts = |axis: usize| match sides[axis] {
                Some([low, high]) => vec![0.0, high - low, low - high],
                None => vec![0.0],
            };
            let [x_shifts, y_shifts, z_shifts] = [0, 1, 2].map(shifts);
            x_shifts
                .iter()
                .any(|&a| y_shifts.iter().any(|&b| z_shifts.iter().any(|&c| near(x + Vec3::new(a, b, c)))))
        };
        if let Some(lost) = all().find(|x| beyond(x) && !stands(&image(x))) {
            return Err(*lost);
        }
        let mut numbers = Vec::new();
        for Piece { points, first, .. } in &mut self.pieces {
            let kept: Vec<bool> = points.iter().map(|x| !beyond(x)).collect();
            let mut next = 0;
            let number = |kept: &bool| {
                kept.then(|| {
                    next += 1;
                    next - 1
                })
            };
            numbers.push(kept.iter().map(number).collect::<Vec<_>>());
            let mut each = kept.iter();
            points.retain(|_| each.next() == Some(&true));
            let mut each = kept.iter();
            first.retain(|_| each.next() == Some(&true));
        }
        self.corners.retain_mut(|corner| {
            let number = numbers[corner.piece][corner.particle];
            corner.particle = number.unwrap_or_default();
            number.is_some()
        });
        Ok(())
    }
}

/// The cell of a grid of a spacing in which a place lies.
fn place(x: &Vec3, spacing: f64) -> [i64; 3] {
    [0, 1, 2].map(|axis| libm::floor(x[axis] / spacing) as i64)
}

/// Walls of one body with their rows.
pub(in crate::bodies) struct BuiltWalls<'a> {
    /// The body in its scene.
    pub view: &'a BodyInScene<'a>,
    /// What its scene says.
    pub scene: &'a WallsScene,
    /// Its rows.
    pub rows: Rows,
}

/// Rows of wall particles, `rows` deep; `scene` is that of the walls alone.
pub(in crate::bodies) fn rows(
    scene: &BodyInScene<'_>,
    walls: &WallsScene,
    spacing: f64,
    rows: usize,
) -> Result<Rows, SceneError> {
    let refused = |error: SpaceError| {
        body_error(scene, &format!("geometry.{}", walls.geometry.word()), &error.to_string())
    };
    match &walls.geometry {
        WallGeometry::Basin(basin) => of_basin(basin, spacing, rows).map_err(refused),
        WallGeometry::Block(block) => of_obstacle(block, spacing, rows).map_err(refused),
        WallGeometry::Polyline(line) => {
            let points = polyline_rows(&line.points, line.side, spacing, rows).map_err(refused)?;
            let wanted = polyline_first_row(&line.points, line.side, spacing).map_err(refused)?;
            Ok(whole(points, &wanted, 2, spacing))
        }
        WallGeometry::Surface(surface) => {
            let (vertices, triangles) = triangles(scene, surface)?;
            let inside = Vec3::from(surface.inside);
            let points = surface_rows(&vertices, &triangles, &inside, spacing, rows).map_err(refused)?;
            let wanted = surface_first_row(&vertices, &triangles, &inside, spacing).map_err(refused)?;
            Ok(whole(points, &wanted, 3, spacing))
        }
    }
}

/// A vector of the coordinates of a list; zero where it has none.
fn vector(list: &[f64]) -> Vec3 {
    Vec3::from([0, 1, 2].map(|axis| list.get(axis).copied().unwrap_or(0.0)))
}

/// The sides of a basin; particles of a corner belong to the side that they are farther behind, the force on them to all of its sides.
fn of_basin(basin: &Basin, spacing: f64, rows: usize) -> Result<Rows, SpaceError> {
    let (min, max, dimensions) = (vector(&basin.min), vector(&basin.max), basin.min.len());
    let open = [0, 1, 2, 3, 4, 5].map(|side| basin.open.iter().any(|open| open == OF_WALLS[side + 1]));
    let points = basin_rows(&min, &max, open, dimensions, spacing, rows)?;
    let behind = |side: usize, x: &Vec3| match side % 2 {
        0 => min[side / 2] - x[side / 2],
        _ => x[side / 2] - max[side / 2],
    };
    let mut pieces: Vec<Piece> = (0..2 * dimensions)
        .map(|side| Piece { side: Some(OF_WALLS[side + 1]), ..Piece::default() })
        .collect();
    let mut shared = Vec::new();
    for x in points {
        let mut own = (0, f64::NEG_INFINITY);
        for side in 0..2 * dimensions {
            let depth = behind(side, &x);
            if depth > own.1 + 1e-9 * spacing {
                own = (side, depth);
            }
        }
        let (side, depth) = own;
        let sides: Vec<usize> = (0..2 * dimensions).filter(|&side| behind(side, &x) > 0.0).collect();
        if sides.len() > 1 {
            shared.push((side, pieces[side].points.len(), sides));
        }
        pieces[side].points.push(x);
        pieces[side].first.push(depth <= FIRST * spacing);
    }
    pieces.retain(|piece| !piece.points.is_empty());
    let piece = |side: usize| pieces.iter().position(|piece| piece.side == Some(OF_WALLS[side + 1]));
    let corner = |(side, particle, sides): (usize, usize, Vec<usize>)| {
        let sides = sides.into_iter().filter_map(|side| Some((piece(side)?, side / 2))).collect();
        Some(Corner { piece: piece(side)?, particle, sides })
    };
    let corners = shared.into_iter().filter_map(corner).collect();
    Ok(Rows { pieces, corners, leaks: 0 })
}

fn of_obstacle(block: &Obstacle, spacing: f64, rows: usize) -> Result<Rows, SpaceError> {
    let (lengths, dimensions) = (vector(&numbers(&block.lengths)), block.lengths.len());
    let origin = vector(block.origin.as_deref().unwrap_or_default());
    let points = block_rows(lengths.into(), &origin, dimensions, spacing, rows)?;
    let depth = |x: &Vec3| {
        let inside = (0..dimensions).map(|i| (x[i] - origin[i]).min(origin[i] + lengths[i] - x[i]));
        inside.fold(f64::INFINITY, f64::min)
    };
    let first = points.iter().map(|x| depth(x) <= FIRST * spacing).collect();
    Ok(Rows { pieces: vec![Piece { side: None, points, first }], ..Rows::default() })
}

/// One piece, looked at for gaps.
fn whole(points: Vec<Vec3>, wanted: &[Vec3], dimensions: usize, spacing: f64) -> Rows {
    let leaks = leaks(wanted, &points, dimensions, spacing);
    let first = vec![true; points.len()];
    Rows { pieces: vec![Piece { side: None, points, first }], leaks, ..Rows::default() }
}

/// Vertices and triangles of a surface from a file.
fn triangles(
    scene: &BodyInScene<'_>,
    surface: &WallSurface,
) -> Result<(Vec<Vec3>, Vec<[u32; 3]>), SceneError> {
    let folder = Path::new(scene.source.origin()).parent().unwrap_or(Path::new(""));
    let read = read(&folder.join(&surface.file)).map_err(|error| {
        let mut said = error.clone();
        let repair = std::mem::take(&mut said.repair);
        let value = said.to_string();
        let value = value.trim_end_matches([';', ' ']);
        let fault = scene.body_scope().fault("geometry.surface.file", value, "a sound surface", &repair);
        SceneError::Mesh(fault)
    })?;
    let read = read.scaled(surface.scale.get());
    let halves = read.faces.iter().flat_map(|face| {
        let [a, b, c, d] = face.corners;
        let second = (face.count == 4).then_some([a, c, d]);
        [Some([a, b, c]), second].into_iter().flatten()
    });
    let triangles = halves.collect();
    Ok((read.positions, triangles))
}
