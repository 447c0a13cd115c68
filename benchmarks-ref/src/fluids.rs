//! Fluids alone: fronts and wall pressures of dam breaks, and a box in one.
//!
//! | data | grade | band |
//! |---|---|---|
//! | [`fronts`], [`front_band`] \[martin1952\] \[koshizuka1996\] | C, digitised | within the three sets, to 10 % above without wall friction |
//! | [`wall_pressure`] \[lobovsky2014\] | C, digitised | arrival ±10 % at 30 particles a depth, ±5 % from 60; plateau ±25 %; the peak is not asked |
//! | [`obstacle_key`], [`obstacle_height`], [`obstacle_impact`] \[kleefsman2005\] | B, one realisation | fronts ±30 ms after one common shift, heights 20 mm rms, impulses ±20 %, peaks within 0.6 to 1.5 |

use crate::catalogue::reference;
use crate::curve::Curve;
use crate::error::ReferenceError;

/// Time of a falling column without dimension, `T = t √(H/a) √(g/a)` \[martin1952\].
///
/// `width` a and `height` H of the column in \[L\], `gravity` g in \[L/T²\], `time` in \[T\]. With it fronts x/a of
/// columns of any size and one proportion H/a are one curve.
pub fn dam_break_time(time: f64, [width, height]: [f64; 2], gravity: f64) -> f64 {
    time * (height * gravity).sqrt() / width
}

/// Three sets of fronts Z = x/a against T of a column twice as high as wide: two experiments, the second read twice.
///
/// # Errors
/// [`ReferenceError`] if the data are damaged.
pub fn fronts() -> Result<[Curve; 3], ReferenceError> {
    let third = reference("dambreak_koshizuka_oka_exp_b")?.curve("t", "x_front")?;
    // Scaled to a column of 1 by 2; at 4 stands the wall.
    let (times, places): (Vec<f64>, Vec<f64>) = third
        .x()
        .iter()
        .zip(third.y())
        .filter(|(_, x)| **x <= 3.9)
        .map(|(&t, &x)| (dam_break_time(t, [1.0, 2.0], 9.81), x))
        .unzip();
    Ok([
        reference("dambreak_martin_moyce_a225")?.curve("T", "Z")?,
        reference("dambreak_koshizuka_oka_exp_a")?.curve("T", "Z")?,
        Curve::new(times, places)?,
    ])
}

/// Least and greatest front Z at a time T from 0.832 to 3.09.
///
/// # Errors
/// [`ReferenceError::OutOfRange`] outside the times that all three sets span.
pub fn front_band(time: f64) -> Result<[f64; 2], ReferenceError> {
    let mut band = [f64::INFINITY, f64::NEG_INFINITY];
    for front in fronts()? {
        let place = front.at(time)?;
        band = [band[0].min(place), band[1].max(place)];
    }
    Ok(band)
}

/// Probes on the wall that a dam break hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WallProbe {
    /// 3 mm above the floor.
    P1,
    /// The third.
    P3,
    /// The fourth, the uppermost.
    P4,
}

/// Pressures p/(ρgH) on a wall against T = t √(g/H), in the order of the reading: near the peak time does not grow.
///
/// # Errors
/// [`ReferenceError`] if the data are damaged.
pub fn wall_pressure(probe: WallProbe) -> Result<Vec<[f64; 2]>, ReferenceError> {
    let table = reference(match probe {
        WallProbe::P1 => "dambreak_lobovsky_p1",
        WallProbe::P3 => "dambreak_lobovsky_p3",
        WallProbe::P4 => "dambreak_lobovsky_p4",
    })?;
    let (times, pressures) = (table.column("T")?, table.column("p/(rho g H)")?);
    Ok(times.into_iter().zip(pressures).map(|(time, pressure)| [time, pressure]).collect())
}

/// Mean pressure of a probe over the plateau, 3.5 ≤ T ≤ 5, by the trapezoidal rule over the points read there.
///
/// # Errors
/// As [`wall_pressure`].
pub fn wall_plateau(probe: WallProbe) -> Result<f64, ReferenceError> {
    let mut points = wall_pressure(probe)?;
    points.retain(|[time, _]| (3.5..=5.0).contains(time));
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let area: f64 = points.windows(2).map(|p| 0.5 * (p[0][1] + p[1][1]) * (p[1][0] - p[0][0])).sum();
    match points.as_slice() {
        [first, .., last] => Ok(area / (last[0] - first[0])),
        _ => Err(ReferenceError::EmptyRange { first: 3.5, last: 5.0 }),
    }
}

/// Time T at which the pressure at a probe first passes 0.1 ρgH; the first reading before it was below.
///
/// # Errors
/// As [`wall_pressure`].
pub fn wall_arrival(probe: WallProbe) -> Result<f64, ReferenceError> {
    let points = wall_pressure(probe)?;
    let hit = points.iter().find(|[_, pressure]| *pressure > 0.1);
    hit.map(|[time, _]| *time).ok_or(ReferenceError::EmptyRange { first: 0.0, last: 7.0 })
}

/// A key figure of the box in a dam break by its name, such as `first peak P1` \[Pa\] or `front passes x=0.992`
/// \[s\].
///
/// # Errors
/// [`ReferenceError::UnknownReference`] lists the names there are.
pub fn obstacle_key(quantity: &str) -> Result<f64, ReferenceError> {
    let table = reference("dambreak_obstacle_kleefsman_key")?;
    let names: Vec<&str> = table.rows.iter().filter_map(|row| row[0].as_str()).collect();
    match names.iter().position(|name| *name == quantity) {
        Some(row) => table.number(row, "value"),
        None => Err(ReferenceError::UnknownReference { name: quantity.to_owned(), known: names.join(", ") }),
    }
}

/// Water height \[m\] against time \[s\] at a gauge x = 0.496, 0.992, 1.488 or 2.638 m, means of 20 ms.
///
/// # Errors
/// [`ReferenceError::UnknownColumn`] for another gauge, with those there are.
pub fn obstacle_height(gauge: f64) -> Result<Curve, ReferenceError> {
    reference("dambreak_obstacle_kleefsman_heights")?.curve("t", &format!("h at x={gauge}"))
}

/// Pressure \[Pa\] against time \[s\] at probe P1 to P8 on the box during the first impact, 1 kHz.
///
/// # Errors
/// [`ReferenceError::UnknownColumn`] for another probe, with those there are.
pub fn obstacle_impact(probe: usize) -> Result<Curve, ReferenceError> {
    reference("dambreak_obstacle_kleefsman_pressure_impact")?.curve("t", &format!("P{probe}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn fronts_of_three_sets_are_one_band() {
        for (time, least, greatest) in
            [(1.0, 1.33, 1.40), (1.5, 1.77, 1.85), (2.0, 2.30, 2.39), (2.5, 2.79, 3.03), (3.0, 3.47, 3.75)]
        {
            let band = front_band(time).unwrap();
            // Two digits were noted.
            assert_relative_eq!(band[0], least, epsilon = 6e-3);
            assert_relative_eq!(band[1], greatest, epsilon = 6e-3);
        }
        assert!(matches!(front_band(3.2), Err(ReferenceError::OutOfRange { .. })));
    }

    #[test]
    fn the_time_of_a_column_twice_as_high_as_wide_is_that_of_the_tables() {
        let time = dam_break_time(0.3, [0.146, 0.292], 9.81);
        assert_relative_eq!(time, 0.3 * (2.0 * 9.81 / 0.146_f64).sqrt(), max_relative = 1e-14);
    }

    #[test]
    fn the_wall_is_hit_at_2_43_and_the_plateau_falls_with_height() {
        assert_relative_eq!(wall_arrival(WallProbe::P1).unwrap(), 2.427);
        let plateaus =
            [WallProbe::P1, WallProbe::P3, WallProbe::P4].map(|probe| wall_plateau(probe).unwrap());
        for (plateau, noted) in plateaus.iter().zip([0.608, 0.584, 0.537]) {
            // The mean noted was one over points, not over time.
            assert_relative_eq!(*plateau, noted, max_relative = 0.02);
        }
    }

    /// The impulses of the key figures are the areas under the record, each with its own zero.
    #[test]
    fn impulses_are_the_areas_under_the_record() {
        for probe in 1..=4 {
            let record = obstacle_impact(probe).unwrap();
            let zero = record.y()[0];
            let points: Vec<(f64, f64)> = record
                .x()
                .iter()
                .zip(record.y())
                .map(|(&t, &p)| (t, p - zero))
                .filter(|p| p.0 <= 0.7)
                .collect();
            let area: f64 = points.windows(2).map(|p| 0.5 * (p[0].1 + p[1].1) * (p[1].0 - p[0].0)).sum();
            let noted = obstacle_key(&format!("impulse P{probe} 0.38-0.70 s")).unwrap();
            // The zero was a mean over earlier times, a few ten pascals from the first point over 0.32 s.
            assert_relative_eq!(area, noted, max_relative = 0.03);
            let peak = points.iter().map(|p| p.1).fold(0.0, f64::max);
            assert_relative_eq!(
                peak,
                obstacle_key(&format!("first peak P{probe}")).unwrap(),
                max_relative = 0.03
            );
        }
    }

    #[test]
    fn gauges_start_at_the_depth_of_the_column() {
        let column = obstacle_height(2.638).unwrap();
        assert_relative_eq!(column.y()[0], 0.55, epsilon = 0.01);
        assert!(obstacle_height(0.992).unwrap().y()[0] < 0.01);
        let error = obstacle_height(1.0).unwrap_err().to_string();
        assert!(error.contains("h at x=0.992"), "{error}");
        assert!(obstacle_key("peak").unwrap_err().to_string().contains("first peak P1"));
    }
}
