//! Our plan without a compiled scene: rules of the law alone, for any scene. Not there yet.

use super::Method;

pub(super) fn method() -> Option<Method> {
    None
}
