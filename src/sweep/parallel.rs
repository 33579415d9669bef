//! Chunks solved by several threads; the rows of each chunk come through a channel of its own, so that all come in order.
use std::collections::VecDeque;
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
    orders: Sender<Order>,
    /// Where the rows of the chunks come that the threads have been given.
    ahead: VecDeque<Receiver<Row>>,
}

/// Rows to be solved, and where they are handed over.
type Order = (Range<usize>, Sender<Row>);

impl ParallelRows {
    pub(super) fn new(sweep: Arc<Sweep>, rows: Range<usize>, threads: NonZeroUsize) -> Self {
        let (orders, todo) = channel();
        let todo = Arc::new(Mutex::new(todo));
        let chunk = (sweep.len() / FEWEST).clamp(1, LONGEST);
        let rows = rows.start.min(sweep.len())..rows.end.min(sweep.len());
        let waiting = rows.start / chunk..rows.end.div_ceil(chunk);
        let threads = threads.get().min(waiting.len());
        for _ in 0..threads {
            let (sweep, todo) = (Arc::clone(&sweep), Arc::clone(&todo));
            // who asks does what is not done by threads
            let _ = thread::Builder::new().name("sweep".into()).spawn(move || work(&sweep, &todo));
        }
        let mut ahead = Self { sweep, rows, chunk, waiting, orders, ahead: VecDeque::new() };
        (0..AHEAD * threads).for_each(|_| ahead.order());
        ahead
    }

    /// Gives one chunk more to the threads.
    fn order(&mut self) {
        if let Some(next) = self.waiting.next() {
            let rows = next * self.chunk..(next + 1) * self.chunk;
            let (done, solved) = channel();
            let _ = self.orders.send((rows.start.max(self.rows.start)..rows.end.min(self.rows.end), done));
            self.ahead.push_back(solved);
        }
    }
}

impl Iterator for ParallelRows {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        let index = self.rows.next()?;
        let solved = self.ahead.front().and_then(|chunk| chunk.recv().ok());
        if (index + 1) % self.chunk == 0 {
            self.ahead.pop_front();
            self.order();
        }
        // if it has broken and breaks again, then where it is seen
        Some(solved.unwrap_or_else(|| self.sweep.row(index)))
    }
}

/// Solves chunks until none is left, or the receiver is gone; what is left of a chunk in which something breaks is not solved.
fn work(sweep: &Sweep, todo: &Mutex<Receiver<Order>>) {
    let next = || todo.lock().unwrap_or_else(PoisonError::into_inner).recv();
    while let Ok((mut rows, done)) = next() {
        let solve = || rows.all(|index| done.send(sweep.row(index)).is_ok());
        if let Ok(false) = catch_unwind(AssertUnwindSafe(solve)) {
            return;
        }
    }
}
