//! Ask a form about itself: tangents, normals, frames, curvatures.
