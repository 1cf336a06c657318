//! A build script, so that what procedural macros are built with is asked for too.

fn main() {}
