//! Random forms, laws and golden cases, for tests.
