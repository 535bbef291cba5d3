//! Large work in parts, one for each processor.
//!
//! Threads live only as long as the work: starting one costs some 30 µs, far below what a part
//! takes, and a process that forks has none left over that would be missing in its child.

use std::ops::Range;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, OnceLock, PoisonError};
use std::thread::{Builder, available_parallelism, scope};

use crate::{Result, stopping};

/// Arithmetic operations below which a part is not worth a thread: half a millisecond or more.
const GRAIN: usize = 1 << 21;

/// Parts for each thread: one that is held up leaves its share to the others.
const PARTS: usize = 4;

/// Items of a part are a multiple of this, so that only the last has a block that is not full.
const BLOCK: usize = 256;

static LIMIT: AtomicUsize = AtomicUsize::new(usize::MAX);

/// Number of threads that large work may take: the processors of this process, unless limited.
pub fn count() -> usize {
    static PROCESSORS: OnceLock<usize> = OnceLock::new();
    let alone = cfg!(target_family = "wasm");
    let processors = || if alone { 1 } else { available_parallelism().map_or(1, Into::into) };
    LIMIT.load(Ordering::Relaxed).min(*PROCESSORS.get_or_init(processors))
}

/// Limits the threads of the whole process; 0 counts as 1.
pub fn limit(count: usize) {
    LIMIT.store(count.max(1), Ordering::Relaxed);
}

/// Fills `out`, `width` numbers for each item, in as many parts as are worth a thread.
///
/// `cost` counts the operations of one item; `job` is given the items of a part and their numbers.
///
/// Errors: the first of the job's, in the order of the items.
pub fn fill_parts<T: Send>(
    out: &mut [T],
    width: usize,
    cost: usize,
    job: impl Fn(Range<usize>, &mut [T]) -> Result<()> + Sync,
) -> Result<()> {
    let items = out.len() / width.max(1);
    let worthwhile = items.saturating_mul(cost) / GRAIN;
    let threads = count().min(worthwhile);
    if threads < 2 {
        return job(0..items, out);
    }
    let step = items.div_ceil(worthwhile.min(PARTS * threads));
    let step = if step > BLOCK { step.next_multiple_of(BLOCK) } else { step };
    let ranges = (0..items).step_by(step).map(|start| start..items.min(start + step));
    work_off(threads, ranges.zip(out.chunks_mut(step * width)), |(range, part)| {
        let start = range.start;
        job(range, part).map_err(|error| (start, error))
    })
    .map_err(|(_, error)| error)
}

/// Does all tasks, each thread taking the next when it has done one.
///
/// A thread stops at its first error. Tasks are begun in order, so the least of these is the first
/// of all; a thread that cannot be started is missed only in speed.
fn work_off<P: Send, E: Send>(
    threads: usize,
    tasks: impl Iterator<Item = P> + Send,
    job: impl Fn(P) -> std::result::Result<(), (usize, E)> + Sync,
) -> std::result::Result<(), (usize, E)> {
    let queue = Mutex::new(tasks);
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
    let work = || -> std::result::Result<(), (usize, E)> {
        while let Some(task) = next() {
            job(task)?;
        }
        Ok(())
    };
    let signal = stopping::signal();
    let helping = || stopping::helping(signal.clone(), work);
    let mut first = Ok(());
    scope(|scope| {
        let spawn = |_| Builder::new().spawn_scoped(scope, helping).ok();
        let others: Vec<_> = (1..threads).filter_map(spawn).collect();
        let own = work();
        let joined =
            others.into_iter().map(|other| other.join().unwrap_or_else(|p| resume_unwind(p)));
        for result in joined.chain([own]) {
            if let Err((place, error)) = result
                && first.as_ref().err().is_none_or(|(least, _)| place < *least)
            {
                first = Err((place, error));
            }
        }
    });
    first
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Error;

    const HEAVY: usize = GRAIN;

    #[test]
    fn every_item_is_done_once() {
        for items in [0, 1, 2, 7, 300, 5000] {
            let mut out = vec![0; 2 * items];
            fill_parts(&mut out, 2, HEAVY, |range, part| {
                for (i, pair) in range.zip(part.chunks_mut(2)) {
                    pair[0] += i;
                    pair[1] += 1;
                }
                Ok(())
            })
            .unwrap();
            let expected: Vec<usize> = (0..items).flat_map(|i| [i, 1]).collect();
            assert_eq!(out, expected);
        }
    }

    #[test]
    fn the_first_error_wins() {
        let fail = |item: usize| Error::shape("item", item, "another");
        for _ in 0..20 {
            let done = fill_parts(&mut [0; 64], 1, HEAVY, |mut range, _| {
                range.find(|item| item % 10 == 5).map_or(Ok(()), |item| Err(fail(item)))
            });
            assert_eq!(done, Err(fail(5)));
        }
    }
}
