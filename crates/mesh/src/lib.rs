//! Forms to points, lines and triangles.
