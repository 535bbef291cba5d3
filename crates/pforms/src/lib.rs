//! Pascalian forms: one exact kernel, and the command line.
