//! The results of many scenes, as tables.
use std::collections::BTreeMap;
use std::io::{self, Write};

use comfy_table::Table;
use recede::report::ruled;
use recede::selftest::Comparison;

use super::workers::{AnswerNumbers, Ended};

/// Number of scenes that are listed for a cause.
const LISTED: usize = 12;
/// Errors of more than this many times their estimate are listed.
const EXCESS: f64 = 10.0;
/// An estimate further above the true error than this is counted.
const CAUTION: f64 = 1000.0;
/// Scenes with a relative error estimate above this are counted as low-accuracy answers.
const LOW_ACCURACY: f64 = 0.01;
/// A stricter answer is not more accurate if its own estimate is larger than this part of the other.
const UNSEEN: f64 = 0.1;

/// The number of scenes for each status and reason.
pub(super) fn causes(ended: &[Ended], out: &mut dyn Write) -> io::Result<()> {
    let mut causes: BTreeMap<(&str, &str), Vec<u64>> = BTreeMap::new();
    for Ended { number, status, reason, .. } in ended {
        causes.entry((status, reason)).or_default().push(*number);
    }
    let mut table = table(["status", "reason", "scenes", "share", "numbers"]);
    for ((status, reason), numbers) in causes {
        let share = format!("{:.2} %", 100.0 * numbers.len() as f64 / ended.len() as f64);
        let listed: Vec<String> = match status {
            "solved" => Vec::new(),
            _ => numbers.iter().take(LISTED).map(u64::to_string).collect(),
        };
        let more = if listed.len() == LISTED && numbers.len() > LISTED { ", ..." } else { "" };
        let listed = listed.join(", ") + more;
        let [status, reason] = [status, reason].map(str::to_owned);
        table.add_row([status, reason, numbers.len().to_string(), share, listed]);
    }
    writeln!(out, "{table}")
}

/// Quantiles of the figures of the solved scenes.
pub(super) fn spread(ended: &[Ended], out: &mut dyn Write) -> io::Result<()> {
    let mut table = table(["solved scenes", "least", "half", "90 %", "99 %", "most"]);
    let answers = || ended.iter().filter_map(|ended| Some((ended, ended.answer.as_ref()?)));
    let mut add = |name: &str, values: Vec<f64>| row(&mut table, name, values, [0.0, 0.5, 0.9, 0.99, 1.0]);
    add("seconds", answers().map(|(ended, _)| ended.seconds).collect());
    add("modes", answers().map(|(_, answer)| answer.modes as f64).collect());
    add("wavenumbers", answers().map(|(_, answer)| answer.wavenumbers as f64).collect());
    add("Newton steps", answers().map(|(_, answer)| answer.newton_steps as f64).collect());
    add("a/H", answers().filter_map(|(_, answer)| answer.relative_half_length).collect());
    add("estimated error", answers().map(|(_, answer)| answer.worst).filter(|worst| worst.is_finite()).collect());
    writeln!(out, "{table}")?;
    let warned = answers().filter(|(_, answer)| answer.warned).count();
    let low_accuracy = answers().filter(|(_, answer)| answer.worst.is_nan() || answer.worst > LOW_ACCURACY).count();
    writeln!(
        out,
        "{warned} of the solved scenes with a warning, {low_accuracy} with an estimated error above {:.0} %",
        100.0 * LOW_ACCURACY
    )
}

/// The slowest scenes.
pub(super) fn list(slowest: &[&Ended], out: &mut dyn Write) -> io::Result<()> {
    let mut table = table(["slowest", "seconds", "modes", "Newton steps", "status"]);
    for ended in slowest {
        let count = |count: fn(&AnswerNumbers) -> usize| {
            ended.answer.as_ref().map_or(String::new(), |answer| count(answer).to_string())
        };
        table.add_row([
            ended.number.to_string(),
            format!("{:.3}", ended.seconds),
            count(|answer| answer.modes),
            count(|answer| answer.newton_steps),
            ended.status.clone(),
        ]);
    }
    writeln!(out, "{table}")
}

/// Error estimates against true errors.
pub(super) fn estimates(ended: &[Ended], out: &mut dyn Write) -> io::Result<()> {
    let all = || ended.iter().flat_map(|ended| ended.comparisons.iter().flatten().map(|one| (ended.number, one)));
    let mut table = table(["errors", "least", "half", "95 %", "99 %", "most"]);
    for quantity in ["half-length", "pressure"] {
        let of = |value: fn(&Comparison) -> f64| {
            all().filter(|(_, one)| one.quantity == quantity).map(|(_, one)| value(one)).collect()
        };
        let mut add = |name: &str, values: Vec<f64>| row(&mut table, name, values, [0.0, 0.5, 0.95, 0.99, 1.0]);
        add(&format!("{quantity}: true"), of(|one| one.error));
        add(&format!("{quantity}: estimated"), of(|one| one.estimate));
        add(&format!("{quantity}: true / estimated"), of(Comparison::excess));
        add(&format!("{quantity}: estimated / true"), of(Comparison::caution));
    }
    writeln!(out, "{table}")?;
    let total = all().count().max(1);
    let cautious = all().filter(|(_, one)| one.caution() > CAUTION).count();
    let compared = ended.iter().filter(|ended| ended.comparisons.is_some()).count();
    writeln!(out, "{compared} scenes compared, {total} numbers")?;
    writeln!(out, "{cautious} estimates ({:.2} %) too large by > {CAUTION}", 100.0 * cautious as f64 / total as f64)?;
    // an answer that does not meet the tolerance may be as accurate as the stricter one
    let unseen = all().filter(|(_, one)| one.caution() > CAUTION && one.blur > UNSEEN * one.estimate).count();
    writeln!(out, "{unseen} of these where the stricter answer has no smaller estimate")?;
    let mut bold: Vec<_> = all().filter(|(_, one)| one.excess() > EXCESS).collect();
    bold.sort_by(|(_, a), (_, b)| b.excess().total_cmp(&a.excess()));
    writeln!(out, "{} errors more than {EXCESS} times their estimate", bold.len())?;
    for (number, Comparison { contact, quantity, error, estimate, blur }) in bold.iter().take(2 * LISTED) {
        writeln!(
            out,
            "  scene {number}, {quantity} at {contact}: error {error:.1e}, estimate {estimate:.1e}, \
             estimate of the stricter run {blur:.1e}"
        )?;
    }
    Ok(())
}

fn table<const N: usize>(header: [&str; N]) -> Table {
    ruled(header.map(|name| (name, "")))
}

/// A row of quantiles.
fn row(table: &mut Table, name: &str, mut values: Vec<f64>, shares: [f64; 5]) {
    values.sort_by(f64::total_cmp);
    let at = |share: f64| {
        let index = (share * values.len().saturating_sub(1) as f64).ceil() as usize;
        values.get(index).map_or(String::new(), |value| {
            if value.fract() == 0.0 && value.abs() < 1e9 { format!("{value}") } else { format!("{value:.2e}") }
        })
    };
    table.add_row([name.to_owned()].into_iter().chain(shares.map(at)));
}
