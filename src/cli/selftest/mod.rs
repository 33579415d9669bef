//! `recede selftest`: solves random legal scenes and checks the results.
mod tables;
mod workers;

use std::io::{self, Write};
use std::iter;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use recede::selftest::{Ranges, about_axis, scene, scene_of_any_kind, scene_with_punches, variant};
use recede::{Scene, files};

use super::Failure;
use super::progress::Progress;
use tables::{causes, estimates, list, spread};
use workers::{Ended, run};

/// Solve random scenes and check the results: a test of the program itself
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Every scene is solved, reported in all formats, and its fields are computed and checked; one in sixteen is drawn. A scene \
that takes more than the allowed memory or time is counted as killed.

Layers: none to 6, homogeneous and graded (beta * thickness -8 to 8), bonded and up to 3 receding, thicknesses and moduli up \
to 1 : 1000 and 1 : 10000, Poisson's ratio -0.5 to 0.5; contacts under the punch from 1e-4 to 10 times the thickness. Some \
of the punches, layers, interfaces and bases are then exchanged for others of all kinds. Every fourth scene has one to four \
punches that may be turned, or pressed beside their tips. Every third scene is one of the examples that ship with the program, \
with numbers, layers, interfaces, base and punch changed at random.

Examples:
  recede selftest --count 2000 --seed 1
  recede selftest --seed 1 --first 17 --count 1  the scene with number 17 alone
  recede selftest --count 2000 --paper-kinds     kinds of the source paper only
  recede selftest --count 1000 --axisymmetric    the same about an axis
  recede selftest --count 1000 --verify          against a stricter tolerance

Exit status: 0 unless an answer was wrong, the program panicked, or a scene was killed.")]
pub struct SelftestArguments {
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
    /// The same scenes about an axis: spheres, cones and discs, forces as they are
    #[arg(long)]
    axisymmetric: bool,
    /// Relative error to aim at, from 1e-13 to 1e-2
    #[arg(long, default_value = "1e-10")]
    tolerance: f64,
    /// Compare every answer with one at the strictest tolerance
    #[arg(long)]
    verify: bool,
    /// Write every scene that is not solved, and the slowest ones, into this folder
    #[arg(long, value_name = "DIR")]
    save: Option<PathBuf>,
    /// Scenes solved at the same time; the number of processors if not given
    #[arg(long)]
    threads: Option<NonZeroUsize>,
    /// Memory that one scene may take, in MB; only where the operating system can limit it
    #[arg(long, default_value_t = 1024)]
    memory: u64,
    /// Seconds that one scene may take
    #[arg(long, default_value_t = 600)]
    seconds: u64,
    /// Solve the scene whose number is read from standard input
    #[arg(long, hide = true)]
    worker: bool,
}

/// One scene in this many has several punches, or one that is turned.
const PUNCHES: u64 = 4;
/// The number of slowest scenes that are listed.
const SLOWEST: usize = 10;
/// One scene in this many is drawn, too.
const PICTURED: u64 = 16;
/// One scene in this many is a changed example scene.
const VARIED: u64 = 3;

impl SelftestArguments {
    pub fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
        if self.worker {
            return self.work(out);
        }
        let mut ended = self.ended_all()?;
        ended.sort_by_key(|ended| ended.number);
        let mut slowest: Vec<&Ended> = ended.iter().collect();
        slowest.sort_by(|a, b| b.seconds.total_cmp(&a.seconds).then(a.number.cmp(&b.number)));
        slowest.truncate(SLOWEST);
        causes(&ended, out)?;
        spread(&ended, out)?;
        list(&slowest, out)?;
        if self.verify {
            estimates(&ended, out)?;
        }
        if let Some(folder) = &self.save {
            std::fs::create_dir_all(folder)?;
            let unsolved = ended.iter().filter(|ended| ended.answer.is_none());
            for ended in unsolved.chain(slowest) {
                let file = folder.join(format!("selftest_{}_{}.ron", self.seed, ended.number));
                let first = format!("// {} {}", ended.status, ended.reason);
                let text = format!("{}\n{}", first.trim_end(), self.scene(ended.number)?.to_ron());
                files::replace(&file, |out| out.write_all(text.as_bytes()))?;
            }
        }
        let wrong = ended.iter().filter(|ended| ended.is_wrong).count();
        if wrong == 0 { Ok(()) } else { Err(Failure::Wrong(wrong)) }
    }

    /// Solves all scenes, several at a time.
    fn ended_all(&self) -> Result<Vec<Ended>, Failure> {
        let threads = self.threads.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get);
        let (next, end) = (AtomicU64::new(self.first), self.first.saturating_add(self.count));
        let bar = Progress::new("scenes", self.count, 0);
        let one_by_one = || -> Result<Vec<Ended>, Failure> {
            let numbers = iter::from_fn(|| Some(next.fetch_add(1, Ordering::Relaxed)).filter(|number| *number < end));
            numbers.map(|number| run(self, number).inspect(|_| bar.step())).collect()
        };
        let all = thread::scope(|scope| {
            let threads: Vec<_> = (0..threads).map(|_| scope.spawn(one_by_one)).collect();
            threads
                .into_iter()
                .map(|thread| thread.join().unwrap_or_else(|_| Err(io::Error::other("a thread panicked").into())))
                .collect::<Result<Vec<_>, _>>()
        })?;
        bar.finish();
        Ok(all.into_iter().flatten().collect())
    }

    /// The scene with a number.
    fn scene(&self, number: u64) -> Result<Scene, recede::Error> {
        let ranges = Ranges::default();
        let drawn = if self.paper_kinds {
            scene(&ranges, self.seed, number).scene()
        } else if number % VARIED == VARIED - 1 {
            variant(self.seed, number)
        } else if number.is_multiple_of(PUNCHES) && !self.axisymmetric {
            scene_with_punches(&ranges, self.seed, number)
        } else {
            scene_of_any_kind(&ranges, self.seed, number)
        };
        if self.axisymmetric { drawn.map(about_axis) } else { drawn }
    }
}
