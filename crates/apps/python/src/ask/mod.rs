//! Values, separations and shares of rows, compiled contacts, plans and what is known best.

pub(crate) mod advice;
pub(crate) mod answer;
pub(crate) mod asked;
pub(crate) mod contact;
pub(crate) mod long;
pub(crate) mod over;
pub(crate) mod rows;
pub(crate) mod values;
