//! Numbers in a few characters.

/// Four significant digits, without trailing zeros; powers of ten outside 1e-4 … 1e6.
pub fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let size = value.abs().log10().floor() as i32;
    if !(-4..6).contains(&size) {
        let text = format!("{value:.3e}");
        let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{power}", digits.trim_end_matches('0').trim_end_matches('.'));
    }
    let decimals = (3 - size).max(0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

#[test]
fn numbers_are_short() {
    for (value, text) in [
        (0.0, "0"),
        (2.22194, "2.222"),
        (0.27594, "0.2759"),
        (0.4, "0.4"),
        (-12.0, "-12"),
        (123_456.7, "123457"),
        (1.5e-11, "1.5e-11"),
        (3.2e7, "3.2e7"),
        (1e-9, "1e-9"),
    ] {
        assert_eq!(short(value), text);
    }
}
