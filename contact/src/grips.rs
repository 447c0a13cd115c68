//! What grips a surface: the anchor of each vertex on a face of the other surface, and how far the vertex stood from it.

use sph_core::Vec3;

/// Numbers of a grip in a state that is kept.
const NUMBERS: usize = 7;

/// A vertex that grips a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grip {
    /// The pass and the vertex of it.
    pub of: (u32, u32),
    /// The face whose material its anchor is.
    pub face: u32,
    /// Where the anchor lies in it, along its sides from the first corner; outside too \[–\].
    pub anchor: [f64; 2],
    /// How far the foot of the vertex stood from the anchor, along the same sides \[–\].
    pub stretch: [f64; 2],
    /// Energy lost on the way to it \[F L\].
    pub lost: f64,
    /// Whether the vertex touches.
    pub holds: bool,
}

/// All grips, by pass and vertex: those that were committed and those of the forces last evaluated.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Grips {
    pub kept: Vec<Grip>,
    pub trial: Vec<Grip>,
}

impl Grips {
    /// Makes those of the forces last evaluated the ones that count; hands each with the energy that it has lost \[F L\] to `lose`.
    pub fn commit(&mut self, mut lose: impl FnMut(&Grip, f64)) {
        self.kept.clear();
        self.kept.extend(self.trial.iter().filter(|grip| grip.holds));
        for grip in &mut self.trial {
            let lost = std::mem::take(&mut grip.lost);
            if lost != 0.0 {
                lose(grip, lost);
            }
        }
    }

    /// Energy lost on the way to the forces last evaluated, not committed yet \[F L\].
    pub fn lost(&self) -> f64 {
        self.trial.iter().map(|grip| grip.lost).sum()
    }

    /// The committed ones as numbers.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        let of = |grip: &Grip| {
            let ([u, v], [a, b]) = (grip.anchor, grip.stretch);
            let [pass, vertex, face] = [grip.of.0, grip.of.1, grip.face].map(f64::from);
            [pass, vertex, face, u, v, a, b]
        };
        self.kept.iter().flat_map(of)
    }

    /// Takes up what [`Grips::numbers`] gave; false, and nothing changed, where a grip is not one of those that `fit`.
    pub fn take_up(&mut self, numbers: &[f64], fits: impl Fn(&Grip) -> bool) -> bool {
        let (rows, left) = numbers.as_chunks::<NUMBERS>();
        let of = |&[pass, vertex, face, u, v, a, b]: &[f64; NUMBERS]| Grip {
            of: (pass as u32, vertex as u32),
            face: face as u32,
            anchor: [u, v],
            stretch: [a, b],
            lost: 0.0,
            holds: true,
        };
        let grips: Vec<Grip> = rows.iter().map(of).collect();
        let whole = left.is_empty() && grips.iter().all(fits) && grips.is_sorted_by_key(|grip| grip.of);
        if whole {
            self.trial.clone_from(&grips);
            self.kept = grips;
        }
        whole
    }

    /// Bytes that they hold.
    pub fn bytes(&self) -> usize {
        size_of::<Grip>() * (self.kept.capacity() + self.trial.capacity())
    }
}

/// A place in a face, along its sides from the first corner.
pub(crate) fn in_space([a, b, c]: [Vec3; 3], [u, v]: [f64; 2]) -> Vec3 {
    a + (b - a) * u + (c - a) * v
}

/// The part of a way in the plane of a face, along its sides \[–\].
pub(crate) fn along_sides([a, b, c]: [Vec3; 3], way: &Vec3) -> [f64; 2] {
    let (e, f) = (b - a, c - a);
    let [ee, ef, ff, we, wf] = [e.dot(&e), e.dot(&f), f.dot(&f), way.dot(&e), way.dot(&f)];
    let over = 1.0 / (ee * ff - ef * ef);
    [(ff * we - ef * wf) * over, (ee * wf - ef * we) * over]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_in_the_plane_of_a_face_is_found_along_its_sides() {
        let corners = [[0.1, 0.2, 0.3], [1.1, 0.0, 0.4], [0.4, 0.9, -0.2]].map(Vec3::from);
        let numbers = [1.7, -0.6];
        let way = in_space(corners, numbers) - corners[0];
        let normal = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
        for off in [0.0, 0.5] {
            let found = along_sides(corners, &(way + normal * off));
            assert!(found.iter().zip(numbers).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
        }
    }

    #[test]
    fn grips_are_kept_as_numbers_and_those_of_others_are_not_taken_up() {
        let grip =
            Grip { of: (1, 4), face: 9, anchor: [1.5, -0.25], stretch: [0.1, 0.2], lost: 0.0, holds: true };
        let grips = Grips { kept: vec![grip], trial: vec![grip] };
        let numbers: Vec<f64> = grips.numbers().collect();
        let mut other = Grips::default();
        assert!(other.take_up(&numbers, |grip| grip.face < 10));
        assert_eq!(other, grips);
        assert!(!other.take_up(&numbers, |grip| grip.face < 9));
        assert!(!other.take_up(&numbers[1..], |_| true));
        assert_eq!(other, grips);
    }
}
