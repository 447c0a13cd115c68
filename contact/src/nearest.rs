//! The place of a triangle or a segment nearest to a point, and on which of its parts that lies.

use sph_core::Vec3;

/// On which part of a feature a place lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// Off all of its ends or sides.
    Inside,
    /// On the side from a corner to the next.
    Side(usize),
    /// On a corner.
    Corner(usize),
}

/// The part of a segment on which its place nearest to a point lies, and the square of the distance.
#[inline]
pub(crate) fn on_segment(p: &Vec3, [a, b]: [Vec3; 2]) -> (Part, f64) {
    let (along, r) = (b - a, p - a);
    let part = along.dot(&r);
    let square = along.norm_squared();
    if part <= 0.0 {
        (Part::Corner(0), r.norm_squared())
    } else if part >= square {
        (Part::Corner(1), (p - b).norm_squared())
    } else {
        (Part::Inside, (r - along * (part / square)).norm_squared())
    }
}

/// The same of a triangle: regions of Voronoi \[ericson2005\].
#[inline(always)]
pub(crate) fn on_triangle(p: &Vec3, [a, b, c]: [Vec3; 3]) -> (Part, f64) {
    let (e, f) = (b - a, c - a);
    let to_a = p - a;
    let [d1, d2] = [e.dot(&to_a), f.dot(&to_a)];
    if d1 <= 0.0 && d2 <= 0.0 {
        return (Part::Corner(0), to_a.norm_squared());
    }
    let to_b = p - b;
    let [d3, d4] = [e.dot(&to_b), f.dot(&to_b)];
    if d3 >= 0.0 && d4 <= d3 {
        return (Part::Corner(1), to_b.norm_squared());
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return (Part::Side(0), (to_a - e * (d1 / (d1 - d3))).norm_squared());
    }
    let to_c = p - c;
    let [d5, d6] = [e.dot(&to_c), f.dot(&to_c)];
    if d6 >= 0.0 && d5 <= d6 {
        return (Part::Corner(2), to_c.norm_squared());
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return (Part::Side(2), (to_a - f * (d2 / (d2 - d6))).norm_squared());
    }
    let va = d3 * d6 - d5 * d4;
    let [s, t] = [d4 - d3, d5 - d6];
    if va <= 0.0 && s >= 0.0 && t >= 0.0 {
        return (Part::Side(1), (to_b - (c - b) * (s / (s + t))).norm_squared());
    }
    let over = 1.0 / (va + vb + vc);
    (Part::Inside, (to_a - e * (vb * over) - f * (vc * over)).norm_squared())
}

/// Where along two segments the places nearest to each other lie \[–\], and the square of the distance \[ericson2005\].
#[inline]
pub(crate) fn of_segments([a, b]: [Vec3; 2], [c, d]: [Vec3; 2]) -> ([f64; 2], f64) {
    let (e, f, r) = (b - a, d - c, a - c);
    let [ee, ff, fr, er, ef] = [e.dot(&e), f.dot(&f), f.dot(&r), e.dot(&r), e.dot(&f)];
    let across = ee * ff - ef * ef;
    let mut s = if across > 1e-14 * ee * ff { ((ef * fr - er * ff) / across).clamp(0.0, 1.0) } else { 0.0 };
    let mut t = (ef * s + fr) / ff;
    if t < 0.0 {
        (s, t) = ((-er / ee).clamp(0.0, 1.0), 0.0);
    } else if t > 1.0 {
        (s, t) = (((ef - er) / ee).clamp(0.0, 1.0), 1.0);
    }
    ([s, t], (a + e * s - c - f * t).norm_squared())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(seed: usize) -> f64 {
        let x = libm::sin(12.9898 * seed as f64 + 4.1) * 43758.5453;
        2.0 * (x - libm::floor(x)) - 1.0
    }

    fn place(seed: usize) -> Vec3 {
        Vec3::new(number(3 * seed), number(3 * seed + 1), number(3 * seed + 2))
    }

    /// Against the best of a fine raster of barycentric numbers, which is no nearer and about its own width farther.
    #[test]
    fn no_place_of_a_triangle_or_of_a_pair_of_segments_is_nearer_than_the_one_found() {
        const N: usize = 60;
        let mut parts = [0; 3];
        for seed in 0..200 {
            let [p, a, b, c] = std::array::from_fn(|i| place(4 * seed + i));
            let (part, square) = on_triangle(&p, [a, b, c]);
            parts[match part {
                Part::Inside => 0,
                Part::Side(_) => 1,
                Part::Corner(_) => 2,
            }] += 1;
            let (mut least, mut crossing) = (f64::INFINITY, f64::INFINITY);
            for i in 0..=N {
                for j in 0..=N {
                    let [u, v] = [i as f64 / N as f64, j as f64 / N as f64];
                    if i + j <= N {
                        least = least.min((p - a * (1.0 - u - v) - b * u - c * v).norm_squared());
                    }
                    crossing = crossing.min((p + (a - p) * u - b - (c - b) * v).norm_squared());
                }
            }
            assert!(square <= least + 1e-12 && square.sqrt() > least.sqrt() - 0.06, "{square} {least}");
            let (_, square) = of_segments([p, a], [b, c]);
            assert!(
                square <= crossing + 1e-12 && square.sqrt() > crossing.sqrt() - 0.06,
                "{square} {crossing}"
            );
        }
        assert!(parts.iter().all(|&count| count > 10), "{parts:?}");
    }
}
