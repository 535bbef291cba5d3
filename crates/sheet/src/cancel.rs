//! Stopping a recomputation: from outside, or after a time.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Seconds since some fixed moment. A page hands in its own, since a clock is nothing the engine
/// can count on having.
pub type Clock = fn() -> f64;

/// A token that stops recomputations; clones of it stop the same ones.
///
/// ```
/// use pforms_sheet::{Cancel, Sheet};
/// let mut sheet: Sheet = Sheet::new();
/// sheet.set("A1".parse()?, "=1/3");
/// let stopped = Cancel::new();
/// stopped.cancel();
/// assert_eq!(sheet.recalculate(&stopped).remaining, 1);
/// assert_eq!(sheet.recalculate(&Cancel::new()).remaining, 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Cancel {
    flag: Arc<AtomicBool>,
    budget: Option<f64>,
}

impl Cancel {
    /// A token nobody has used yet, without a budget.
    pub fn new() -> Self {
        Self::default()
    }

    /// The same token with a budget: a recomputation stops after so many seconds, but never
    /// before it has computed one cell. It needs a clock, see [`crate::Sheet::set_clock`].
    #[must_use]
    pub fn with_budget(self, seconds: f64) -> Self {
        Self { budget: Some(seconds), ..self }
    }

    /// Stops what runs with this token, between two cells or in one that takes long.
    pub fn cancel(&self) {
        self.flag.store(true, Ordering::Relaxed);
    }

    /// Was it stopped?
    pub fn is_cancelled(&self) -> bool {
        self.flag.load(Ordering::Relaxed)
    }

    pub(crate) fn budget(&self) -> Option<f64> {
        self.budget
    }
}

/// The clock of the machine, where there is one.
#[allow(clippy::unnecessary_wraps, reason = "a page has none")]
pub(crate) fn system_clock() -> Option<Clock> {
    #[cfg(not(all(target_arch = "wasm32", target_os = "unknown")))]
    {
        use std::sync::LazyLock;
        use std::time::Instant;

        static START: LazyLock<Instant> = LazyLock::new(Instant::now);
        Some(|| START.elapsed().as_secs_f64())
    }
    #[cfg(all(target_arch = "wasm32", target_os = "unknown"))]
    None
}
