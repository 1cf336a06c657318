//! Values, separations and shares of rows, and a contact that is prepared for many.

pub(crate) mod advice;
pub(crate) mod answer;
pub(crate) mod contact;
pub(crate) mod long;
pub(crate) mod rows;
pub(crate) mod values;
