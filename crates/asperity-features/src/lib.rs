//! The union of the features that members of the workspace use of the same libraries. `xtask` and
//! the Python package, which are built alone, depend on it: without it cargo compiles half of the
//! workspace again for each, with one feature of `either` or `syn` less.
