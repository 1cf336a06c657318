//! Number types of binary files.

/// A number type of binary files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

/// The number type and byte order of the heights.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Sample {
    pub(super) kind: Kind,
    pub(super) big_endian: bool,
}

impl Sample {
    /// Bytes per number.
    pub(super) fn size(self) -> usize {
        match self.kind {
            Kind::I8 | Kind::U8 => 1,
            Kind::I16 | Kind::U16 => 2,
            Kind::I32 | Kind::U32 | Kind::F32 => 4,
            Kind::I64 | Kind::U64 | Kind::F64 => 8,
        }
    }

    /// Appends the numbers in `bytes`, without an incomplete last one.
    pub(super) fn decode(self, bytes: &[u8], into: &mut Vec<f64>) {
        macro_rules! numbers {
            ($of:ty) => {
                into.extend(bytes.as_chunks().0.iter().map(|number| {
                    (if self.big_endian {
                        <$of>::from_be_bytes(*number)
                    } else {
                        <$of>::from_le_bytes(*number)
                    }) as f64
                }))
            };
        }
        match self.kind {
            Kind::I8 => numbers!(i8),
            Kind::U8 => numbers!(u8),
            Kind::I16 => numbers!(i16),
            Kind::U16 => numbers!(u16),
            Kind::I32 => numbers!(i32),
            Kind::U32 => numbers!(u32),
            Kind::I64 => numbers!(i64),
            Kind::U64 => numbers!(u64),
            Kind::F32 => numbers!(f32),
            Kind::F64 => numbers!(f64),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_byte_orders_are_decoded() {
        let mut numbers = Vec::new();
        Sample { kind: Kind::I16, big_endian: true }.decode(&[1, 2, 255, 254, 7], &mut numbers);
        Sample { kind: Kind::I16, big_endian: false }.decode(&[1, 2], &mut numbers);
        Sample { kind: Kind::F32, big_endian: true }.decode(&1.5f32.to_be_bytes(), &mut numbers);
        Sample { kind: Kind::U8, big_endian: true }.decode(&[200], &mut numbers);
        assert_eq!(numbers, [258.0, -2.0, 513.0, 1.5, 200.0]);
    }
}
