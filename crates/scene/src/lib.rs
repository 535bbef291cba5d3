//! Values, styles and a camera to plain buffers.
