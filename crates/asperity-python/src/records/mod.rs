//! `Body`, `Interface`, `Surface` and `Asperity`: structs of the library as frozen classes.

mod bodies;
mod surface;

use pyo3::PyClass;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::pyclass::boolean_struct::True;
use pyo3::types::{PyDict, PyTuple};

use crate::convert::numbers::{no_number, number};
pub(crate) use bodies::{Body, Interface, materials};
pub(crate) use surface::{Asperity, Surface};

/// An argument.
type Arg<'py> = Bound<'py, PyAny>;

/// A field of a record: a number or an optional number.
trait Field: Sized {
    fn read(record: &str, name: &str, given: Option<&Arg<'_>>) -> PyResult<Self>;
}

impl Field for f64 {
    fn read(record: &str, name: &str, given: Option<&Arg<'_>>) -> PyResult<Self> {
        number(record, name, given.ok_or_else(|| no_number(record, name, "None"))?)
    }
}

impl Field for Option<f64> {
    fn read(record: &str, name: &str, given: Option<&Arg<'_>>) -> PyResult<Self> {
        given.map(|given| number(record, name, given)).transpose()
    }
}

/// A frozen class around a struct of the library: its doc, its signature in Python, a struct to
/// fill and its check, the type of its origin, its fields with their docs, and its other methods.
macro_rules! record {
    (
        $(#[$about:meta])*
        $name:ident $signature:tt from $empty:expr, $check:expr, by $origin:ty;
        $($(#[$meaning:meta])* $field:ident: $type:ty,)+
        { $($methods:tt)* }
    ) => {
        $(#[$about])*
        #[pyclass(frozen, module = "asperity")]
        #[derive(Clone)]
        pub(crate) struct $name(pub(crate) asperity::$name, pub(crate) $origin);

        #[pymethods]
        impl $name {
            #[new]
            #[pyo3(signature = $signature)]
            #[expect(clippy::allow_attributes, reason = "some records have few fields")]
            #[allow(clippy::too_many_arguments, reason = "the fields, by their names in Python")]
            fn new($($field: Option<&Arg<'_>>),+) -> PyResult<Self> {
                let mut found = $empty;
                $(found.$field = Field::read(stringify!($name), stringify!($field), $field)?;)+
                Self::checked(found)
            }

            $($(#[$meaning])*
            #[getter]
            fn $field(&self) -> $type {
                self.0.$field
            })+

            $($methods)*

            /// A copy with other numbers, by their names.
            #[pyo3(signature = (**numbers))]
            fn replace<'py>(
                slf: &Bound<'py, Self>,
                numbers: Option<&Bound<'py, PyDict>>,
            ) -> PyResult<Bound<'py, PyAny>> {
                let fields = slf.get().fields(slf.py())?;
                numbers.map_or(Ok(()), |numbers| fields.update(numbers.as_mapping()))?;
                slf.get_type().call((), Some(&fields))
            }

            fn __eq__(&self, other: &Self) -> bool {
                self.0 == other.0
            }

            fn __hash__(&self, py: Python<'_>) -> PyResult<isize> {
                PyTuple::new(py, self.fields(py)?.values())?.hash()
            }

            fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
                shown(stringify!($name), &self.fields(py)?)
            }

            fn __reduce__<'py>(
                slf: &Bound<'py, Self>,
            ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
                if let Some(call) = slf.get().1.call(slf)? {
                    return Ok(call);
                }
                let values = PyTuple::new(slf.py(), slf.get().fields(slf.py())?.values())?;
                Ok((slf.get_type().into_any(), values))
            }
        }

        impl Record for $name {
            type Struct = asperity::$name;

            fn checked(found: asperity::$name) -> PyResult<Self> {
                let check: fn(&asperity::$name) -> Result<(), ContactError> = $check;
                check(&found).map_err(refused)?;
                Ok(Self(found, Default::default()))
            }

            fn fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
                let fields = PyDict::new(py);
                $(fields.set_item(stringify!($field), self.0.$field)?;)+
                Ok(fields)
            }
        }
    };
}

use record;

/// The numbers from which a record follows, if it was not given by its fields.
trait Origin<T: PyClass> {
    /// The call that makes the record from them, for pickling.
    fn call<'py>(
        &self,
        _record: &Bound<'py, T>,
    ) -> PyResult<Option<(Bound<'py, PyAny>, Bound<'py, PyTuple>)>> {
        Ok(None)
    }
}

impl<T: PyClass> Origin<T> for () {}

/// A class around a struct of the library.
pub(crate) trait Record: Sized {
    type Struct: 'static;
    /// The record of a struct; an error if a number is out of range.
    fn checked(found: Self::Struct) -> PyResult<Self>;

    /// Every field by its name, in the order of the signature.
    fn fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>>;
}

/// The text of the call that makes a record, without the fields that are None.
pub(crate) fn shown(name: &str, fields: &Bound<'_, PyDict>) -> PyResult<String> {
    let given = fields.iter().filter(|(_, value)| !value.is_none());
    let each = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        Ok(format!("{name}={}", value.repr()?))
    };
    Ok(format!("{name}({})", given.map(each).collect::<PyResult<Vec<_>>>()?.join(", ")))
}

/// An argument as an instance of the class; a `TypeError` for another type.
pub(crate) fn instance<'a, 'py, T: PyClass<Frozen = True> + Sync>(
    name: &str,
    given: &'a Bound<'py, PyAny>,
) -> PyResult<&'a Bound<'py, T>> {
    given.cast().map_err(|_| {
        let advice = match T::NAME {
            "Interface" if given.is_instance_of::<Body>() => {
                ": Interface.between(first, second) makes one from two bodies"
            }
            _ => "",
        };
        let (wanted, found) = (article(T::NAME), with_article(given));
        PyTypeError::new_err(format!("{name} must be {wanted} {}, not {found}{advice}", T::NAME))
    })
}

/// The name of an object's type with its article.
pub(crate) fn with_article(given: &Bound<'_, PyAny>) -> String {
    let name = given.get_type().name().map_or_else(|_| String::new(), |name| name.to_string());
    format!("{} {name}", article(&name))
}

fn article(noun: &str) -> &'static str {
    let vowel = noun.to_ascii_lowercase().starts_with(['a', 'e', 'i', 'o', 'u']);
    if vowel { "an" } else { "a" }
}
