//! `recede stress`: solves random legal scenes and tells what became of them.
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::path::PathBuf;

use comfy_table::{LineStyle, Table, TableStyle};
use rayon::prelude::*;
use recede::stress::{Comparison, Ranges, Trial, compare, scene, scene_of_any_kind};
use recede::{Options, Scene};

use super::Failure;
use super::progress::bar;

/// Solve random legal scenes and tell what became of them
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Layers: 1 to 6, homogeneous and graded (beta * thickness -8 to 8), bonded and up to 3 receding, thicknesses and moduli up
to 1 : 1000 and 1 : 10000, Poisson's ratio -0.5 to 0.5; contacts under the punch from 1e-4 to 10 times the thickness. Some
of the punches, layers, interfaces and bases are then exchanged for others of all kinds.

Examples:
  recede stress --count 2000 --seed 1
  recede stress --seed 1 --first 17 --count 1 --save hard     the scene with number 17 alone
  recede stress --count 2000 --paper-kinds                    circles, parabolas, bonds, half-planes only
  recede stress --count 1000 --verify                         error estimates against a stricter run

Exit status: 0 unless an answer was wrong or the solver panicked.")]
pub struct Stress {
    /// How many scenes to solve
    #[arg(long, default_value_t = 100)]
    count: u64,
    /// Which sequence of scenes
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Number of the first scene in the sequence
    #[arg(long, default_value_t = 0)]
    first: u64,
    /// Circles and parabolas, homogeneous and exponential layers, bonded and receding, on half-planes and rigid bases only
    #[arg(long)]
    paper_kinds: bool,
    /// Relative error to aim at, from 1e-13 to 1e-2
    #[arg(long, default_value = "1e-10")]
    tolerance: f64,
    /// Compare every answer with the strictest one that can be had
    #[arg(long)]
    verify: bool,
    /// Write every scene that is not solved, and those of the table of the slowest, into this folder
    #[arg(long, value_name = "DIR")]
    save: Option<PathBuf>,
    /// Scenes solved at the same time; as many as there are processors if not given
    #[arg(long)]
    threads: Option<NonZeroUsize>,
}

/// So many of the slowest scenes are listed.
const SLOWEST: usize = 10;
/// So many numbers of scenes are listed for a cause.
const LISTED: usize = 12;
/// A number of an answer that is wrong by more than this many times its estimate is listed.
const EXCESS: f64 = 10.0;
/// An estimate further above the true error than this is counted.
const CAUTION: f64 = 1000.0;
/// Scenes with a number that is known no better are counted.
const ROUGH: f64 = 0.01;
/// A stricter answer is not surer if its own estimate is larger than this part of the other.
const UNSEEN: f64 = 0.1;
const RULE: LineStyle = LineStyle::none().fill('─').junction('─');
const RULES: TableStyle = TableStyle::new().top_border(RULE).header_separator(RULE).bottom_border(RULE);

/// What is known of a scene afterwards.
struct Ended {
    number: u64,
    scene: Scene,
    /// Half-length under the punch over thickness.
    relative_half_length: Option<f64>,
    trial: Trial,
    /// `None` if not asked for, or if there is nothing to compare, or nothing to compare with.
    comparisons: Option<Vec<Comparison>>,
}

impl Stress {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(self.threads.map_or(0, NonZeroUsize::get)).build()?;
        let numbers = self.first..self.first.saturating_add(self.count);
        let bar = bar(self.count, 0);
        let one = |number: u64| {
            let ended = self.one(number);
            bar.inc(1);
            ended
        };
        let ended: Vec<Ended> = pool.install(|| numbers.into_par_iter().map(one).collect::<Result<_, _>>())?;
        bar.finish_and_clear();
        let mut slowest: Vec<&Ended> = ended.iter().collect();
        slowest.sort_by(|a, b| b.trial.seconds.total_cmp(&a.trial.seconds).then(a.number.cmp(&b.number)));
        slowest.truncate(SLOWEST);
        causes(&ended, out)?;
        spread(&ended, out)?;
        list(&slowest, out)?;
        if self.verify {
            estimates(&ended, out)?;
        }
        if let Some(folder) = &self.save {
            std::fs::create_dir_all(folder)?;
            let unsolved = ended.iter().filter(|ended| ended.trial.outcome.solution().is_none());
            for ended in unsolved.chain(slowest) {
                let file = folder.join(format!("stress_{}_{}.ron", self.seed, ended.number));
                let first = format!("// {} {}", ended.trial.outcome.status(), ended.trial.outcome.reason());
                std::fs::write(file, format!("{}\n{}", first.trim_end(), ended.scene.to_ron()))?;
            }
        }
        let wrong = ended.iter().filter(|ended| ended.trial.outcome.is_wrong()).count();
        if wrong == 0 { Ok(()) } else { Err(Failure::Wrong(wrong)) }
    }

    fn one(&self, number: u64) -> Result<Ended, recede::Error> {
        let ranges = Ranges::default();
        let scene = match self.paper_kinds {
            true => scene(&ranges, self.seed, number).scene()?,
            false => scene_of_any_kind(&ranges, self.seed, number)?,
        };
        let thickness: f64 = scene.stack()?.total_thickness();
        let trial = Trial::run(&scene, &Options { tolerance: self.tolerance, ..Options::default() });
        let solution = trial.outcome.solution();
        let relative_half_length =
            solution.and_then(|solution| Some(solution.contacts().first()?.half_length / thickness));
        let comparisons = solution.filter(|_| self.verify).and_then(|solution| compare(&scene, solution).ok());
        Ok(Ended { number, scene, relative_half_length, trial, comparisons })
    }
}

/// How many scenes ended how, and why.
fn causes(ended: &[Ended], out: &mut dyn Write) -> io::Result<()> {
    let mut causes: BTreeMap<(&str, String, String), Vec<u64>> = BTreeMap::new();
    for Ended { number, trial, .. } in ended {
        let outcome = &trial.outcome;
        let interface = outcome.interface().map_or(String::new(), |interface| interface.to_string());
        causes.entry((outcome.status(), outcome.reason(), interface)).or_default().push(*number);
    }
    let mut table = table(["status", "reason", "contact", "scenes", "share", "numbers"]);
    for ((status, reason, interface), numbers) in causes {
        let share = format!("{:.2} %", 100.0 * numbers.len() as f64 / ended.len() as f64);
        let listed: Vec<String> = match status {
            "solved" => Vec::new(),
            _ => numbers.iter().take(LISTED).map(u64::to_string).collect(),
        };
        let more = if listed.len() == LISTED && numbers.len() > LISTED { ", ..." } else { "" };
        let listed = listed.join(", ") + more;
        table.add_row([status.to_owned(), reason, interface, numbers.len().to_string(), share, listed]);
    }
    writeln!(out, "{table}")
}

/// From where to where the figures of the solved scenes go.
fn spread(ended: &[Ended], out: &mut dyn Write) -> io::Result<()> {
    let mut table = table(["solved scenes", "least", "half", "90 %", "99 %", "most"]);
    let solutions = || ended.iter().filter_map(|ended| Some((ended, ended.trial.outcome.solution()?)));
    let worst = |ended: &Ended| {
        let contacts = ended.trial.outcome.solution().map_or(&[][..], |solution| solution.contacts());
        contacts.iter().fold(0.0, |worst: f64, contact| {
            worst
                .max(contact.half_length_error / contact.half_length)
                .max(contact.peak_pressure_error / contact.peak_pressure)
        })
    };
    row(&mut table, "seconds", solutions().map(|(ended, _)| ended.trial.seconds).collect());
    row(&mut table, "modes", solutions().map(|(_, solution)| solution.modes() as f64).collect());
    row(&mut table, "wavenumbers", solutions().map(|(_, solution)| solution.wavenumbers() as f64).collect());
    row(&mut table, "Newton steps", solutions().map(|(_, solution)| solution.newton_steps() as f64).collect());
    row(&mut table, "a/H", solutions().filter_map(|(ended, _)| ended.relative_half_length).collect());
    row(&mut table, "estimated error", solutions().map(|(ended, _)| worst(ended)).collect());
    writeln!(out, "{table}")?;
    let warned = solutions().filter(|(_, solution)| !solution.warnings().is_empty()).count();
    let rough = solutions().filter(|(ended, _)| worst(ended) > ROUGH).count();
    writeln!(
        out,
        "{warned} of the solved scenes with a warning, {rough} with a number known to {:.0} % or worse",
        100.0 * ROUGH
    )
}

/// The slowest scenes.
fn list(slowest: &[&Ended], out: &mut dyn Write) -> io::Result<()> {
    let mut table = table(["slowest", "seconds", "modes", "Newton steps", "status"]);
    for ended in slowest {
        let solution = ended.trial.outcome.solution();
        let count =
            |count: fn(&recede::Solution) -> usize| solution.map_or(String::new(), |found| count(found).to_string());
        table.add_row([
            ended.number.to_string(),
            format!("{:.3}", ended.trial.seconds),
            count(recede::Solution::modes),
            count(recede::Solution::newton_steps),
            ended.trial.outcome.status().to_owned(),
        ]);
    }
    writeln!(out, "{table}")
}

/// How honest the error estimates are.
fn estimates(ended: &[Ended], out: &mut dyn Write) -> io::Result<()> {
    let all = || ended.iter().flat_map(|ended| ended.comparisons.iter().flatten().map(|one| (ended.number, one)));
    let mut table = table(["errors", "least", "half", "95 %", "99 %", "most"]);
    for quantity in ["half-length", "pressure"] {
        let of = |value: fn(&Comparison) -> f64| {
            all().filter(|(_, one)| one.quantity == quantity).map(|(_, one)| value(one)).collect()
        };
        let mut row = |name: &str, values: Vec<f64>| row_at(&mut table, name, values, [0.0, 0.5, 0.95, 0.99, 1.0]);
        row(&format!("{quantity}: true"), of(|one| one.error));
        row(&format!("{quantity}: estimated"), of(|one| one.estimate));
        row(&format!("{quantity}: true / estimated"), of(Comparison::excess));
        row(&format!("{quantity}: estimated / true"), of(Comparison::caution));
    }
    writeln!(out, "{table}")?;
    let total = all().count().max(1);
    let cautious = all().filter(|(_, one)| one.caution() > CAUTION).count();
    let compared = ended.iter().filter(|ended| ended.comparisons.is_some()).count();
    writeln!(out, "{compared} scenes compared, {total} numbers")?;
    writeln!(out, "{cautious} estimates ({:.2} %) too large by > {CAUTION}", 100.0 * cautious as f64 / total as f64)?;
    // an answer that does not meet the tolerance is no less sure than the stricter one
    let unseen = all().filter(|(_, one)| one.caution() > CAUTION && one.blur > UNSEEN * one.estimate).count();
    writeln!(out, "{unseen} of these next to a stricter answer that is not surer of itself")?;
    let mut bold: Vec<_> = all().filter(|(_, one)| one.excess().is_nan() || one.excess() > EXCESS).collect();
    bold.sort_by(|(_, a), (_, b)| b.excess().total_cmp(&a.excess()));
    writeln!(out, "{} errors more than {EXCESS} times their estimate", bold.len())?;
    for (number, one) in bold.iter().take(2 * LISTED) {
        let Comparison { interface, quantity, error, estimate, blur } = one;
        writeln!(
            out,
            "  scene {number}, {quantity} at {interface}: error {error:.1e}, estimate {estimate:.1e}, \
             estimate of the stricter run {blur:.1e}"
        )?;
    }
    Ok(())
}

fn table<const N: usize>(header: [&str; N]) -> Table {
    let mut table = Table::new();
    table.load_style(RULES);
    table.set_header(header);
    table
}

fn row(table: &mut Table, name: &str, values: Vec<f64>) {
    row_at(table, name, values, [0.0, 0.5, 0.9, 0.99, 1.0]);
}

/// A row of quantiles.
fn row_at(table: &mut Table, name: &str, mut values: Vec<f64>, shares: [f64; 5]) {
    values.sort_by(f64::total_cmp);
    let at = |share: f64| {
        let index = (share * values.len().saturating_sub(1) as f64).ceil() as usize;
        values.get(index).map_or(String::new(), |value| {
            if value.fract() == 0.0 && value.abs() < 1e9 { format!("{value}") } else { format!("{value:.2e}") }
        })
    };
    table.add_row([name.to_owned()].into_iter().chain(shares.map(at)));
}
