//! Cells that recalculate, headless.
