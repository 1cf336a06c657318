//! What members of the workspace ask of the same libraries, asked at once by those that are built
//! alone, `xtask` and the Python package: without it, cargo compiles half of the workspace again
//! for each, with a feature fewer of `either` or `syn`. There is nothing else in here.
