//! Hints for words that scenes do not know: the word to write in their place.

/// Tables of words, with what to say about them.
const HINTS: &str = include_str!("hints.txt");

/// What a table says of a word, in each row that has it.
pub(super) fn rows(table: &str, found: &str) -> impl Iterator<Item = &'static str> {
    let table = HINTS.split("== ").find(|part| part.starts_with(table)).unwrap_or_default();
    // of one letter, case tells: E is not e, R is not r
    let same = move |word: &str| word == found || found.chars().count() > 1 && word.eq_ignore_ascii_case(found);
    let rows = table.lines().filter_map(|row| row.split_once(" => "));
    rows.filter(move |(words, _)| words.split(' ').any(same)).map(|(_, meaning)| meaning)
}

/// What to do about a name that is none of those allowed: another name for the same, that it is not supported, or the
/// nearest of the allowed names.
pub(super) fn instead_of(found: &str, allowed: &[&str]) -> Option<String> {
    let (mut names, mut how) = (Vec::new(), "");
    for row in rows("other names", found) {
        let (own, difference) = row.split_at(row.find([',', ':']).unwrap_or(row.len()));
        let own: Vec<&str> = own.split(' ').filter(|name| allowed.contains(name)).collect();
        how = if own.is_empty() { how } else { difference };
        names.extend(own);
    }
    if names.is_empty() {
        let not_supported = rows("not supported", found).next().map(str::to_owned);
        return not_supported.or_else(|| did_you_mean(found, allowed));
    }
    let between = if names == ["radius", "half_width"] {
        how = ", half the sum and half the difference of the outer and the inner radius";
        "` and `"
    } else {
        "` or `"
    };
    Some(format!("write `{}`{how}", names.join(between)))
}

/// The nearest of the allowed names, if it is near.
pub(super) fn did_you_mean(found: &str, allowed: &[&str]) -> Option<String> {
    let likeness = |name: &str| strsim::jaro_winkler(&found.to_lowercase(), &name.to_lowercase());
    let (likeness, name) = allowed.iter().map(|name| (likeness(name), name)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    (likeness > 0.75).then(|| format!("did you mean `{name}`?"))
}
