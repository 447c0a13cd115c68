//! Orders of elimination from the places of the unknowns: a sweep along the body, and nested dissection \[george1973\]. Orders are of places, those of
//! their unknowns by [`Places::spread`].

use crate::places::Places;

/// Unknowns of a part that is not divided any more.
const LEAF: usize = 30;

/// Places along the longest extent: what is best for slender bodies, whose factor is then a narrow band.
pub(crate) fn sweep(places: &Places) -> Vec<usize> {
    let mut order: Vec<usize> = (0..places.count()).collect();
    let axis = longest(places, &order);
    order.sort_by(|&a, &b| places.at[a][axis].total_cmp(&places.at[b][axis]));
    order
}

/// Multiplications of a factor, found without its analysis: each unknown updates half a square as large as the front, which are
/// those not yet eliminated that couple with one that is. This is what the factor takes, before supernodes are merged, where the
/// eliminated part always hangs together; where it falls apart (two legs swept at once) the fronts are added, and it is too much.
pub(crate) fn front_multiplications(order: &[usize], places: &Places) -> f64 {
    let mut step = vec![0; order.len()];
    order.iter().enumerate().for_each(|(new, &old)| step[old] = new);
    let mut enters = step.clone();
    for column in 0..order.len() {
        for &row in places.coupled(column) {
            enters[row] = enters[row].min(step[column]);
            enters[column] = enters[column].min(step[row]);
        }
    }
    let mut entering = vec![0.0; order.len()];
    enters.iter().enumerate().for_each(|(place, &step)| entering[step] += places.weight(place) as f64);
    let (mut front, mut sum) = (0.0, 0.0);
    for (&place, more) in order.iter().zip(&entering) {
        front += more;
        for _ in places.unknowns(place) {
            front -= 1.0; // the one eliminated leaves
            sum += 0.5 * front * front;
        }
    }
    sum
}

/// Halves, each ordered in the same way, before what separates them.
pub(crate) fn dissection(places: &Places) -> Vec<usize> {
    let mut order = Vec::with_capacity(places.count());
    let mut side = vec![Side::Elsewhere; places.count()];
    divide((0..places.count()).collect(), &mut order, &mut side, places);
    order
}

/// Where a place of the part that is divided lies.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Elsewhere,
    Lower,
    Upper,
    Between,
}

fn divide(part: Vec<usize>, order: &mut Vec<usize>, side: &mut [Side], places: &Places) {
    let axis = longest(places, &part);
    let unknowns: usize = part.iter().map(|&place| places.weight(place)).sum();
    let middle = if unknowns > LEAF { middle(places, &part, axis, unknowns) } else { None };
    let Some(middle) = middle else {
        return order.extend(part); // small, or all at one place
    };
    for &place in &part {
        side[place] = if places.at[place][axis] < middle { Side::Lower } else { Side::Upper };
    }
    // Those of the lower half that couple with the upper one separate the halves.
    for &column in &part {
        for &row in places.coupled(column) {
            match (side[column], side[row]) {
                (Side::Lower, Side::Upper) => side[column] = Side::Between,
                (Side::Upper, Side::Lower) => side[row] = Side::Between,
                _ => {}
            }
        }
    }
    let of = |wanted: Side| part.iter().copied().filter(|&place| side[place] == wanted).collect();
    let [lower, upper, between]: [Vec<usize>; 3] = [Side::Lower, Side::Upper, Side::Between].map(of);
    part.iter().for_each(|&place| side[place] = Side::Elsewhere);
    drop(part);
    if lower.is_empty() {
        order.extend(upper);
        return order.extend(between);
    }
    divide(lower, order, side, places);
    divide(upper, order, side, places);
    order.extend(between);
}

/// Where along an axis half of the unknowns of a part lie before; none where that is where the first one is.
fn middle(places: &Places, part: &[usize], axis: usize, unknowns: usize) -> Option<f64> {
    let mut along: Vec<(f64, usize)> =
        part.iter().map(|&place| (places.at[place][axis], places.weight(place))).collect();
    along.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut before = 0;
    let found = along.iter().find(|(_, weight)| {
        before += weight;
        before > unknowns / 2
    });
    found.map(|&(at, _)| at).filter(|&at| at != along[0].0)
}

/// The axis along which a part is longest.
fn longest(places: &Places, part: &[usize]) -> usize {
    let extent = |axis: usize| {
        let along = || part.iter().map(|&place| places.at[place][axis]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    (1..3).fold(0, |best, axis| if extent(axis) > extent(best) { axis } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a band the front is its width until the end comes near, whatever the order of the numbers, and the sum is exact.
    #[test]
    fn the_front_of_a_band_is_its_width() {
        let (count, width) = (40, 5);
        // Numbered backwards, so that the order is not the numbering.
        let order: Vec<usize> = (0..count).rev().collect();
        let (mut pointers, mut rows) = (vec![0], Vec::new());
        for column in 0..count {
            rows.extend(column..count.min(column + width + 1));
            pointers.push(rows.len());
        }
        // Each unknown at a place of its own.
        let coordinates: Vec<[f64; 3]> = (0..count).map(|unknown| [unknown as f64, 0.0, 0.0]).collect();
        let places = Places::of(&coordinates, &pointers, &rows);
        let least: usize = (0..width).map(|front| front * front).sum();
        let exact = 0.5 * ((count - width) * width * width + least) as f64;
        assert_eq!(front_multiplications(&order, &places), exact);
    }
}
