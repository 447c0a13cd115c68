//! A crack in a double cantilever: its energy release rate by compliance, and where it grows.

use crate::bodies::LAWS;
use crate::cantilever::Cantilever;

#[test]
fn the_energy_release_rate_is_that_of_the_compliance() {
    for law in LAWS {
        let found = Cantilever { law, across: 12, horizon: 3.015 }.released().unwrap();
        println!("{law:?}: {found:.3?}");
        for one in found {
            assert!((one.ratio - 1.0).abs() < 0.1, "{law:?}: {one:?}");
        }
    }
}

#[test]
fn a_crack_grows_where_the_energy_asked_for_is_released() {
    for law in LAWS {
        let found = Cantilever { law, across: 12, horizon: 3.015 }.grown().unwrap();
        let mean = found.rates.iter().sum::<f64>() / found.rates.len() as f64;
        println!("{law:?}: mean {mean:.3} of {found:.3?}");
        assert!((mean - 1.0).abs() < 0.1, "{law:?}: mean {mean}");
    }
}
