//! A build script, which adds the features that procedural macros are built with.

fn main() {}
