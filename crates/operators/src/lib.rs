//! The operators of pforms: forms in, forms or numbers out.
