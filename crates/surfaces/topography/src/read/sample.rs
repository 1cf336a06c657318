//! Number types of binary files.

/// The number type and byte order of the heights.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Sample {
    /// `i`, `u` or `f`: signed, unsigned or floating.
    kind: u8,
    /// Bytes per number.
    pub(super) size: usize,
    big_endian: bool,
}

impl Sample {
    /// The type of a name such as `f8`, with the low byte first.
    pub(super) const fn new(name: [u8; 2]) -> Self {
        Self { kind: name[0], size: (name[1] - b'0') as usize, big_endian: false }
    }

    /// The type of a name of NumPy, such as `<f8`.
    pub(super) fn numpy(name: &str) -> Option<Self> {
        let (order, name) = name.as_bytes().split_first()?;
        let big_endian = *order == b'>';
        match name {
            [kind @ (b'i' | b'u'), size @ (b'1' | b'2' | b'4' | b'8')]
            | [kind @ b'f', size @ (b'4' | b'8')]
                if big_endian || matches!(order, b'<' | b'|') =>
            {
                Some(Self { big_endian, ..Self::new([*kind, *size]) })
            }
            _ => None,
        }
    }

    /// The numbers in `bytes`, without an incomplete last one.
    pub(super) fn decode(self, bytes: &[u8]) -> Vec<f64> {
        bytes.chunks_exact(self.size).map(|bytes| self.number(bytes)).collect()
    }

    /// The number in as many bytes as it has.
    pub(super) fn number(self, bytes: &[u8]) -> f64 {
        let push = |bits: u64, byte: &u8| bits << 8 | u64::from(*byte);
        let bits = match self.big_endian {
            true => bytes.iter().fold(0, push),
            false => bytes.iter().rev().fold(0, push),
        };
        // Shifts carry the sign of short numbers.
        let unused = 64 - 8 * self.size;
        match (self.kind, self.size) {
            (b'f', 4) => f64::from(f32::from_bits(bits as u32)),
            (b'f', _) => f64::from_bits(bits),
            (b'i', _) => ((bits << unused) as i64 >> unused) as f64,
            _ => bits as f64,
        }
    }

    /// The least and the largest number, of floating ones with the few digits that files print.
    pub(super) fn range(self) -> [f64; 2] {
        let largest = 2f64.powi(8 * self.size as i32);
        match (self.kind, self.size) {
            (b'f', 4) => [-3.4e38, 3.4e38],
            (b'f', _) => [-1.7e308, 1.7e308],
            (b'i', _) => [-0.5 * largest, 0.5 * largest - 1.0],
            _ => [-1.0, largest - 1.0],
        }
    }
}

/// Bytes not yet parsed; `None` where they end too early.
pub(super) struct Bytes<'a>(pub(super) &'a [u8]);

impl<'a> Bytes<'a> {
    pub(super) fn take(&mut self, n: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(n)?;
        self.0 = rest;
        Some(taken)
    }

    /// A number of this type, such as `f8`.
    pub(super) fn number(&mut self, name: [u8; 2]) -> Option<f64> {
        let sample = Sample::new(name);
        Some(sample.number(self.take(sample.size)?))
    }

    /// A count in four bytes.
    pub(super) fn count(&mut self) -> Option<usize> {
        self.number(*b"u4").map(|n| n as usize)
    }

    /// A text that ends with a zero.
    pub(super) fn text(&mut self) -> Option<&'a [u8]> {
        let end = self.0.iter().position(|byte| *byte == 0)?;
        self.take(end + 1)?.strip_suffix(b"\0")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_byte_orders_are_decoded() {
        let of = |name, bytes: &[u8]| Sample::numpy(name).unwrap().decode(bytes);
        assert_eq!(of(">i2", &[1, 2, 255, 254, 7]), [258.0, -2.0]);
        assert_eq!(of("<i2", &[1, 2]), [513.0]);
        assert_eq!(of(">f4", &1.5f32.to_be_bytes()), [1.5]);
        assert_eq!(of("|u1", &[200]), [200.0]);
        assert_eq!(of("<i8", &(-3i64).to_le_bytes()), [-3.0]);
        assert_eq!(of("<u8", &u64::MAX.to_le_bytes()), [u64::MAX as f64]);
        assert_eq!(Sample::new(*b"i2").range().map(|end| end as i64), [-32_768, 32_767]);
        assert_eq!(Sample::new(*b"u4").range().map(|end| end as i64), [-1, i64::from(u32::MAX)]);
    }
}
