//! Orders of elimination from the places of the unknowns: a sweep along the body, and nested dissection \[george1973\].

/// Unknowns of a part that is not divided any more.
const LEAF: usize = 30;

/// Unknowns by their places along the longest extent: what is best for slender bodies, whose factor is then a narrow band.
pub(crate) fn sweep(places: &[[f64; 3]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..places.len()).collect();
    let axis = longest(places, &order);
    order.sort_by(|&a, &b| places[a][axis].total_cmp(&places[b][axis]));
    order
}

/// Multiplications of a factor, found without its analysis: each unknown updates half a square as large as the front, which are
/// those not yet eliminated that couple with one that is. This is what the factor takes, before supernodes are merged, where the
/// eliminated part always hangs together; where it falls apart (two legs swept at once) the fronts are added, and it is too much.
pub(crate) fn front_multiplications(order: &[usize], pointers: &[usize], rows: &[usize]) -> f64 {
    let mut place = vec![0; order.len()];
    order.iter().enumerate().for_each(|(new, &old)| place[old] = new);
    let mut enters = place.clone();
    for column in 0..order.len() {
        for &row in &rows[pointers[column]..pointers[column + 1]] {
            enters[row] = enters[row].min(place[column]);
            enters[column] = enters[column].min(place[row]);
        }
    }
    let mut entering = vec![0_u32; order.len()];
    enters.iter().for_each(|&step| entering[step] += 1);
    let mut front = 0.0;
    let each = entering.iter().map(|&more| {
        front += f64::from(more) - 1.0; // the one eliminated leaves
        0.5 * front * front
    });
    each.sum()
}

/// Halves, each ordered in the same way, before what separates them; `pointers` and `rows` are compressed columns of the lower
/// triangle of the pattern.
pub(crate) fn dissection(places: &[[f64; 3]], pointers: &[usize], rows: &[usize]) -> Vec<usize> {
    let mut order = Vec::with_capacity(places.len());
    let mut side = vec![Side::Elsewhere; places.len()];
    divide((0..places.len()).collect(), &mut order, &mut side, (places, pointers, rows));
    order
}

/// Where an unknown of the part that is divided lies.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Elsewhere,
    Lower,
    Upper,
    Between,
}

fn divide(
    part: Vec<usize>,
    order: &mut Vec<usize>,
    side: &mut [Side],
    graph: (&[[f64; 3]], &[usize], &[usize]),
) {
    let (places, pointers, rows) = graph;
    let axis = longest(places, &part);
    let mut along: Vec<f64> = part.iter().map(|&unknown| places[unknown][axis]).collect();
    along.sort_by(f64::total_cmp);
    let (first, middle) = (along.first().copied(), along.get(along.len() / 2).copied());
    let Some(middle) = middle.filter(|_| part.len() > LEAF && middle != first) else {
        return order.extend(part); // small, or all at one place
    };
    for &unknown in &part {
        side[unknown] = if places[unknown][axis] < middle { Side::Lower } else { Side::Upper };
    }
    // Those of the lower half that couple with the upper one separate the halves.
    for &column in &part {
        for &row in &rows[pointers[column]..pointers[column + 1]] {
            match (side[column], side[row]) {
                (Side::Lower, Side::Upper) => side[column] = Side::Between,
                (Side::Upper, Side::Lower) => side[row] = Side::Between,
                _ => {}
            }
        }
    }
    let of = |wanted: Side| part.iter().copied().filter(|&unknown| side[unknown] == wanted).collect();
    let [lower, upper, between]: [Vec<usize>; 3] = [Side::Lower, Side::Upper, Side::Between].map(of);
    part.iter().for_each(|&unknown| side[unknown] = Side::Elsewhere);
    drop(part);
    if lower.is_empty() {
        order.extend(upper);
        return order.extend(between);
    }
    divide(lower, order, side, graph);
    divide(upper, order, side, graph);
    order.extend(between);
}

/// The axis along which a part is longest.
fn longest(places: &[[f64; 3]], part: &[usize]) -> usize {
    let extent = |axis: usize| {
        let along = || part.iter().map(|&unknown| places[unknown][axis]);
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
        let least: usize = (0..width).map(|front| front * front).sum();
        let exact = 0.5 * ((count - width) * width * width + least) as f64;
        assert_eq!(front_multiplications(&order, &pointers, &rows), exact);
    }
}
