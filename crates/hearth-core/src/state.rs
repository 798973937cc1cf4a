//! The exact state of a fire as bytes, so that another process continues with the same bits.
//!
//! [`burning`](crate::simulation::burning) is the small, lossy form for downloads. Here every number keeps all its bits.
//! `state!` names the fields of a type; those after `;` are memory that the next step fills, and begin empty. The bytes
//! are those of one build: whoever stores them adds a version and a checksum.

use std::collections::VecDeque;
use std::sync::Arc;

use glam::{Vec2, Vec4};

use crate::lanes::Lanes;
use crate::params::{Choice, Fuel};

/// The bytes that are not read yet.
pub struct Bytes<'a>(pub &'a [u8]);

impl Bytes<'_> {
    /// The next `N` bytes.
    pub fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*first)
    }
}

/// What can be written and read again bit by bit.
pub trait State: Sized {
    /// Appends the bytes.
    fn save(&self, out: &mut Vec<u8>);

    /// Reads what was written; `None` if the bytes end or are no such value.
    fn load(bytes: &mut Bytes<'_>) -> Option<Self>;
}

/// Implements [`State`] for types of these fields.
#[macro_export]
macro_rules! state {
    ($type:ident($number:ident)) => {
        impl $crate::state::State for $type {
            fn save(&self, out: &mut Vec<u8>) {
                let $type($number) = self;
                $crate::state::State::save($number, out);
            }

            fn load(bytes: &mut $crate::state::Bytes<'_>) -> Option<$type> {
                $crate::state::State::load(bytes).map($type)
            }
        }
    };
    ($($type:ident: $($field:ident)* $(; $($empty:ident)*)?),+) => { $(
        impl $crate::state::State for $type {
            fn save(&self, out: &mut Vec<u8>) {
                let $type { $($field,)* $($($empty: _,)*)? } = self;
                $($crate::state::State::save($field, out);)*
                let _ = out;
            }

            fn load(bytes: &mut $crate::state::Bytes<'_>) -> Option<$type> {
                let _ = &bytes;
                Some($type {
                    $($field: $crate::state::State::load(bytes)?,)*
                    $($($empty: Default::default(),)*)?
                })
            }
        }
    )+ };
}

macro_rules! numbers {
    ($($type:ty)+) => { $(
        impl State for $type {
            fn save(&self, out: &mut Vec<u8>) {
                out.extend(self.to_le_bytes());
            }

            fn load(bytes: &mut Bytes<'_>) -> Option<$type> {
                bytes.take().map(<$type>::from_le_bytes)
            }
        }
    )+ };
}

numbers!(u8 u16 u32 u64 f32 f64);

/// Types that are written as others.
macro_rules! written_as {
    ($($type:ty as $other:ty: $save:expr, $load:expr;)+) => { $(
        impl State for $type {
            fn save(&self, out: &mut Vec<u8>) {
                let save: fn(&$type) -> $other = $save;
                save(self).save(out);
            }

            fn load(bytes: &mut Bytes<'_>) -> Option<$type> {
                let load: fn($other) -> Option<$type> = $load;
                load(State::load(bytes)?)
            }
        }
    )+ };
}

written_as! {
    usize as u64: |number| *number as u64, |number| number.try_into().ok();
    bool as u8: |flag| u8::from(*flag), |byte| (byte < 2).then_some(byte == 1);
    Vec2 as [f32; 2]: Vec2::to_array, |numbers| Some(numbers.into());
    Vec4 as [f32; 4]: Vec4::to_array, |numbers| Some(numbers.into());
    Lanes as [f32; 4]: |lanes| lanes.to_array(), |numbers| Some(Lanes::new(numbers));
    Fuel as u8: |fuel| *fuel as u8, |place| Fuel::VALUES.get(usize::from(place)).copied();
}

impl<T: State, const N: usize> State for [T; N] {
    fn save(&self, out: &mut Vec<u8>) {
        self.iter().for_each(|item| item.save(out));
    }

    fn load(bytes: &mut Bytes<'_>) -> Option<[T; N]> {
        let items: Option<Vec<T>> = (0..N).map(|_| T::load(bytes)).collect();
        items?.try_into().ok()
    }
}

impl<A: State, B: State> State for (A, B) {
    fn save(&self, out: &mut Vec<u8>) {
        self.0.save(out);
        self.1.save(out);
    }

    fn load(bytes: &mut Bytes<'_>) -> Option<(A, B)> {
        Some((A::load(bytes)?, B::load(bytes)?))
    }
}

impl<T: State> State for Vec<T> {
    fn save(&self, out: &mut Vec<u8>) {
        self.len().save(out);
        self.iter().for_each(|item| item.save(out));
    }

    fn load(bytes: &mut Bytes<'_>) -> Option<Vec<T>> {
        // An item takes at least a byte, so a wrong number ends with the bytes.
        (0..usize::load(bytes)?).map(|_| T::load(bytes)).collect()
    }
}

impl<T: State> State for VecDeque<T> {
    fn save(&self, out: &mut Vec<u8>) {
        self.len().save(out);
        self.iter().for_each(|item| item.save(out));
    }

    fn load(bytes: &mut Bytes<'_>) -> Option<VecDeque<T>> {
        Vec::load(bytes).map(VecDeque::from)
    }
}

impl<T: State> State for Option<T> {
    fn save(&self, out: &mut Vec<u8>) {
        self.is_some().save(out);
        self.iter().for_each(|item| item.save(out));
    }

    fn load(bytes: &mut Bytes<'_>) -> Option<Option<T>> {
        match bool::load(bytes)? {
            true => T::load(bytes).map(Some),
            false => Some(None),
        }
    }
}

/// Pointers are written as what they point to.
macro_rules! pointers {
    ($($pointer:ident)+) => { $(
        impl<T: State> State for $pointer<T> {
            fn save(&self, out: &mut Vec<u8>) {
                (**self).save(out);
            }

            fn load(bytes: &mut Bytes<'_>) -> Option<$pointer<T>> {
                T::load(bytes).map($pointer::new)
            }
        }
    )+ };
}

pointers!(Box Arc);
