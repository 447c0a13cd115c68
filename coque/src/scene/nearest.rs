//! The known word nearest to a misspelt one.

/// The known word that was probably meant: at most a third of its letters differ, or it begins with the word given.
pub(crate) fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if word.chars().count() > 100 {
        return None;
    }
    let word = word.to_lowercase();
    known
        .into_iter()
        .map(|candidate| {
            let lower = candidate.to_lowercase();
            let begun = word.len() >= 3 && (lower.starts_with(&word) || word.starts_with(&lower));
            let edits = if begun { 1 } else { strsim::osa_distance(&word, &lower) };
            (edits, candidate)
        })
        .filter(|(edits, candidate)| *edits <= (candidate.chars().count() / 3).max(1))
        .min_by_key(|(edits, _)| *edits)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_what_was_meant() {
        let known = ["young", "poisson", "density", "u0", "u1"];
        assert_eq!(nearest("yuong", known), Some("young"));
        assert_eq!(nearest("Poison", known), Some("poisson"));
        assert_eq!(nearest("dens", known), Some("density"));
        assert_eq!(nearest("u2", known), Some("u0"));
        assert_eq!(nearest("thickness", known), None);
    }
}
