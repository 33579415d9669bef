//! Chunks solved by several threads, and their rows put in order again.
use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::vec;

use super::{Row, Sweep};

/// Chunks per thread that may be solved before they are asked for.
const AHEAD: usize = 16;

/// Rows of a sweep in the order of the grid, computed by several threads that run ahead of who asks for rows.
///
/// The threads stop, after the chunk they are at, when this is dropped. Where no threads can be started, the one that asks
/// does the work.
#[derive(Debug)]
pub struct ParallelRows {
    sweep: Arc<Sweep>,
    first: usize,
    /// Chunks still to be handed out.
    chunks: Range<usize>,
    /// Chunks still to be given to the threads.
    waiting: Range<usize>,
    orders: Sender<usize>,
    solved: Receiver<Solved>,
    /// Chunks that came before their time.
    early: BTreeMap<usize, Vec<Row>>,
    rows: vec::IntoIter<Row>,
}

/// A chunk and its rows; none if something broke.
type Solved = (usize, Option<Vec<Row>>);

impl ParallelRows {
    pub(super) fn new(sweep: Arc<Sweep>, first: usize, threads: NonZeroUsize) -> Self {
        let (orders, todo) = channel();
        let (done, solved) = channel();
        let todo = Arc::new(Mutex::new(todo));
        let chunks = sweep.chunks_from(first);
        let threads = threads.get().min(chunks.len());
        for _ in 0..threads {
            let (sweep, todo, done) = (Arc::clone(&sweep), Arc::clone(&todo), done.clone());
            // who asks does what is not done by threads
            let _ = thread::Builder::new().name("sweep".into()).spawn(move || work(&sweep, &todo, &done));
        }
        let mut waiting = chunks.clone();
        for chunk in waiting.by_ref().take(AHEAD * threads) {
            let _ = orders.send(chunk);
        }
        Self { sweep, first, chunks, waiting, orders, solved, early: BTreeMap::new(), rows: Vec::new().into_iter() }
    }

    fn wait_for(&mut self, chunk: usize) -> Vec<Row> {
        loop {
            if let Some(rows) = self.early.remove(&chunk) {
                return rows;
            }
            match self.solved.recv() {
                Ok((solved, Some(rows))) => {
                    self.early.insert(solved, rows);
                }
                // if it breaks again, then where it is seen
                Ok((broken, None)) => {
                    self.early.insert(broken, self.sweep.solve_chunk(broken));
                }
                Err(_) => return self.sweep.solve_chunk(chunk),
            }
        }
    }
}

impl Iterator for ParallelRows {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        loop {
            if let Some(row) = self.rows.find(|row| row.index >= self.first) {
                return Some(row);
            }
            let chunk = self.chunks.next()?;
            if let Some(next) = self.waiting.next() {
                let _ = self.orders.send(next);
            }
            self.rows = self.wait_for(chunk).into_iter();
        }
    }
}

/// What a thread does until there is nothing left to do, or nobody to do it for.
fn work(sweep: &Sweep, todo: &Mutex<Receiver<usize>>, done: &Sender<Solved>) {
    let next = || todo.lock().unwrap_or_else(PoisonError::into_inner).recv();
    while let Ok(chunk) = next() {
        let rows = catch_unwind(AssertUnwindSafe(|| sweep.solve_chunk(chunk)));
        if done.send((chunk, rows.ok())).is_err() {
            return;
        }
    }
}
