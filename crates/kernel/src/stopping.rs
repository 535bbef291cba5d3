//! Long work that can be stopped from outside: who starts it says how to ask, and the work asks now
//! and then, wherever a form is made and in the loops of searches.

use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, mpsc};
use std::time::Duration;

use crate::{Error, Result};

/// Calls of [`check`] between two questions.
const STRIDE: u32 = 16;

/// How long a thread that waits for another lets it work between two questions.
const PAUSE: Duration = Duration::from_millis(20);

thread_local! {
    static LISTENER: RefCell<Option<Rc<Listener>>> = const { RefCell::new(None) };
    static CALLS: Cell<u32> = const { Cell::new(0) };
}

/// Who may stop the work of a thread.
struct Listener {
    /// Set once and for all: work that was stopped goes nowhere.
    stopped: Arc<AtomicBool>,
    /// Threads that help have none: they see what the first one was told.
    asked: Option<Box<dyn Fn() -> bool>>,
    outer: Option<Rc<Listener>>,
}

impl Listener {
    /// Was the work stopped, or is it to be?
    fn hears(&self) -> bool {
        let stopped = self.stopped.load(Ordering::Relaxed)
            || self.outer.as_ref().is_some_and(|outer| outer.hears())
            || self.asked.as_ref().is_some_and(|asked| asked());
        if stopped {
            self.stopped.store(true, Ordering::Relaxed);
        }
        stopped
    }
}

/// Puts a listener in place for as long as it lives.
struct Place(Option<Rc<Listener>>);

impl Place {
    fn of(stopped: Arc<AtomicBool>, asked: Option<Box<dyn Fn() -> bool>>) -> Self {
        LISTENER.with_borrow_mut(|place| {
            let outer = place.take();
            *place = Some(Rc::new(Listener { stopped, asked, outer: outer.clone() }));
            Self(outer)
        })
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        LISTENER.with_borrow_mut(|place| *place = self.0.take());
    }
}

/// Does a job that ends early, mostly with [`Error::Stopped`], once `asked` answers yes; tells
/// whether it was: then the answer of the job is worth nothing, whatever it looks like.
///
/// `asked` is called often, and only in this thread; inner jobs are stopped with outer ones.
///
/// ```
/// use pforms_kernel::{Form, stopping};
/// let endless = || -> pforms_kernel::Result<()> {
///     loop {
///         stopping::check()?;
///     }
/// };
/// let (answer, stopped) = stopping::stoppable(|| true, endless);
/// assert!(stopped && answer.is_err());
/// ```
pub fn stoppable<T>(asked: impl Fn() -> bool + 'static, job: impl FnOnce() -> T) -> (T, bool) {
    let stopped = Arc::new(AtomicBool::new(false));
    let place = Place::of(Arc::clone(&stopped), Some(Box::new(asked)));
    let answer = job();
    drop(place);
    (answer, stopped.load(Ordering::Relaxed))
}

/// Complains when the work of this thread is to end.
///
/// Nearly free: most calls only count. Whoever loops long without making a form calls it.
///
/// Errors: `Stopped`.
#[inline]
pub fn check() -> Result<()> {
    let calls = CALLS.get().wrapping_add(1);
    CALLS.set(calls);
    if calls.is_multiple_of(STRIDE) && is_stopped() {
        return Err(Error::Stopped);
    }
    Ok(())
}

/// Is the work of this thread to end?
pub fn is_stopped() -> bool {
    // Not borrowed while it is asked: an answer may take any other work.
    let listener = LISTENER.with_borrow(Clone::clone);
    listener.is_some_and(|listener| listener.hears())
}

/// What tells other threads that this one was stopped.
pub(crate) fn signal() -> Option<Arc<AtomicBool>> {
    LISTENER.with_borrow(|place| place.as_ref().map(|listener| Arc::clone(&listener.stopped)))
}

/// Does a job that helps another thread, and stops with it.
pub(crate) fn helping<T>(signal: Option<Arc<AtomicBool>>, job: impl FnOnce() -> T) -> T {
    let _place = signal.map(|stopped| Place::of(stopped, None));
    job()
}

/// Does a job that cannot ask, such as somebody else's code, in another thread while this one asks;
/// `stop` is to end it.
///
/// Where nobody may stop the work, or there are no threads, the job is done here.
pub fn beside<T: Send>(job: impl Fn() -> T + Sync, stop: impl Fn()) -> T {
    let signal = signal();
    if cfg!(target_family = "wasm") || signal.is_none() {
        return job();
    }
    let answer = std::thread::scope(|scope| {
        let (done, waits) = mpsc::channel::<()>();
        let job = &job;
        let work = move || {
            let answer = helping(signal, job);
            drop(done);
            answer
        };
        let other = std::thread::Builder::new().spawn_scoped(scope, work).ok()?;
        while let Err(mpsc::RecvTimeoutError::Timeout) = waits.recv_timeout(PAUSE) {
            if is_stopped() {
                stop();
            }
        }
        Some(other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
    });
    answer.unwrap_or_else(job)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::threads::fill_parts;

    fn endless() -> Result<()> {
        loop {
            check()?;
        }
    }

    #[test]
    fn nobody_stops_what_nobody_may() {
        assert!((0..1000).all(|_| check().is_ok()));
        let (answer, stopped) = stoppable(|| false, || (0..1000).all(|_| check().is_ok()));
        assert!(answer && !stopped);
    }

    #[test]
    fn it_stays_stopped_and_ends_with_its_job() {
        let questions = Rc::new(Cell::new(0));
        let asked = {
            let questions = Rc::clone(&questions);
            move || {
                questions.set(questions.get() + 1);
                questions.get() == 3
            }
        };
        let job = || (endless(), endless());
        assert_eq!(stoppable(asked, job), ((Err(Error::Stopped), Err(Error::Stopped)), true));
        assert_eq!(questions.get(), 3);
        assert!((0..1000).all(|_| check().is_ok()));
    }

    #[test]
    fn the_inner_stops_with_the_outer_but_not_the_other_way() {
        let inner = || stoppable(|| false, endless);
        assert_eq!(stoppable(|| true, inner), ((Err(Error::Stopped), true), true));
        let outer = || {
            let inner = stoppable(|| true, endless);
            (inner, (0..1000).all(|_| check().is_ok()))
        };
        assert_eq!(stoppable(|| false, outer), (((Err(Error::Stopped), true), true), false));
    }

    #[test]
    fn helpers_stop_too() {
        let job = || fill_parts(&mut [0; 64], 1, 1 << 22, |_, _| endless());
        assert_eq!(stoppable(|| true, job), (Err(Error::Stopped), true));
    }

    #[test]
    fn what_cannot_ask_is_done_beside() {
        let flag = AtomicBool::new(false);
        let deaf = || {
            while !flag.load(Ordering::Relaxed) {
                std::thread::yield_now();
            }
            7
        };
        let watched = || beside(deaf, || flag.store(true, Ordering::Relaxed));
        assert_eq!(stoppable(|| true, watched), (7, true));
        assert_eq!(beside(|| 8, || ()), 8);
    }
}
