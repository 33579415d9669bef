//! Chunks solved by several threads, and their rows put in order again.
use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use super::{Row, Sweep};

/// Chunks per thread that may be solved ahead of the caller.
const AHEAD: usize = 16;
/// Rows of a chunk, at most: more would keep one thread busy when the others have finished.
const LONGEST: usize = 32;
/// So many chunks there are at least, if there are as many rows.
const FEWEST: usize = 64;

/// Rows of a sweep in the order of the grid, computed by several threads that run ahead of who asks for rows.
///
/// Threads take chunks of neighbouring rows, and hand over each row when it is solved. They stop, after the row they
/// are at, when this is dropped. Where no threads can be started, the one that asks does the work.
#[derive(Debug)]
pub struct ParallelRows {
    sweep: Arc<Sweep>,
    /// Rows not requested yet.
    rows: Range<usize>,
    /// Rows of a chunk; depends on the grid alone.
    chunk: usize,
    /// Chunks still to be given to the threads.
    waiting: Range<usize>,
    orders: Sender<Range<usize>>,
    solved: Receiver<SolvedRow>,
    /// Rows that came before their time.
    early: BTreeMap<usize, Row>,
}

/// The number of a row and the row; none if something broke.
type SolvedRow = (usize, Option<Row>);

impl ParallelRows {
    pub(super) fn new(sweep: Arc<Sweep>, rows: Range<usize>, threads: NonZeroUsize) -> Self {
        let (orders, todo) = channel();
        let (done, solved) = channel();
        let todo = Arc::new(Mutex::new(todo));
        let chunk = (sweep.len() / FEWEST).clamp(1, LONGEST);
        let rows = rows.start.min(sweep.len())..rows.end.min(sweep.len());
        let waiting = rows.start / chunk..rows.end.div_ceil(chunk);
        let threads = threads.get().min(waiting.len());
        for _ in 0..threads {
            let (sweep, todo, done) = (Arc::clone(&sweep), Arc::clone(&todo), done.clone());
            // who asks does what is not done by threads
            let _ = thread::Builder::new().name("sweep".into()).spawn(move || work(&sweep, &todo, &done));
        }
        let mut ahead = Self { sweep, rows, chunk, waiting, orders, solved, early: BTreeMap::new() };
        (0..AHEAD * threads).for_each(|_| ahead.order());
        ahead
    }

    /// Gives one chunk more to the threads.
    fn order(&mut self) {
        if let Some(next) = self.waiting.next() {
            let rows = next * self.chunk..(next + 1) * self.chunk;
            let _ = self.orders.send(rows.start.max(self.rows.start)..rows.end.min(self.rows.end));
        }
    }

    fn wait_for(&mut self, index: usize) -> Row {
        loop {
            if let Some(row) = self.early.remove(&index) {
                return row;
            }
            match self.solved.recv() {
                Ok((solved, Some(row))) => self.early.insert(solved, row),
                // if it breaks again, then where it is seen
                Ok((broken, None)) => self.early.insert(broken, self.sweep.row(broken)),
                Err(_) => return self.sweep.row(index),
            };
        }
    }
}

impl Iterator for ParallelRows {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        let index = self.rows.next()?;
        if index % self.chunk == 0 {
            self.order();
        }
        Some(self.wait_for(index))
    }
}

/// Solves chunks until none is left, or the receiver is gone.
fn work(sweep: &Sweep, todo: &Mutex<Receiver<Range<usize>>>, done: &Sender<SolvedRow>) {
    let next = || todo.lock().unwrap_or_else(PoisonError::into_inner).recv();
    while let Ok(rows) = next() {
        for index in rows {
            let row = catch_unwind(AssertUnwindSafe(|| sweep.row(index)));
            if done.send((index, row.ok())).is_err() {
                return;
            }
        }
    }
}
