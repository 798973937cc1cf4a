//! Loops without a seam: which moments of a fire are alike, and how the end goes over into the beginning.

use super::Rate;
use crate::picture::Picture;

/// Longest time over which the end of a loop becomes its beginning \[s\].
const FADE_SECONDS: f64 = 0.3;
/// Time in which the beginning is looked for \[s\].
const SEARCH_SECONDS: f64 = 4.0;

/// A loop of so many pictures, before its beginning is known. Numbers count pictures from the start of the search.
#[derive(Clone, Copy, Debug)]
pub struct Loop {
    /// Number of pictures.
    pub count: u32,
    /// Number of pictures over which the end becomes the beginning.
    pub fade: u32,
    /// Number of pictures from which it may begin, and the number behind the last of them.
    starts: [u32; 2],
}

impl Loop {
    /// A loop of that many pictures.
    pub fn new(count: u32, rate: Rate) -> Loop {
        let pictures = |seconds: f64| (seconds / rate.time(1)).round() as u32;
        let fade = pictures(FADE_SECONDS).min(count / 4).max(1);
        Loop {
            count,
            fade,
            starts: [fade, fade + pictures(SEARCH_SECONDS).max(1)],
        }
    }

    /// Number of pictures in which the beginning is looked for.
    pub fn searched(&self) -> u32 {
        self.starts[1] + self.count
    }

    /// The number of the picture at which the loop begins: those that are mixed have the least distance.
    pub fn start(&self, pictures: &[Picture]) -> u32 {
        let distance = |start: &u32| -> u64 {
            let mixed = (start - self.fade..*start).map(|number| number as usize);
            let pairs = mixed.filter_map(|number| {
                Some((
                    pictures.get(number)?,
                    pictures.get(number + self.count as usize)?,
                ))
            });
            pairs.map(|(a, b)| a.distance(b)).sum()
        };
        let [first, end] = self.starts;
        (first..end).min_by_key(distance).unwrap_or(first)
    }

    /// The share of the picture a loop's length before that of this number in the loop.
    pub fn share_of_earlier(&self, number: u32) -> f32 {
        let begun = (number + 1 + self.fade).saturating_sub(self.count);
        begun as f32 / (self.fade + 1) as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RATE: Rate = Rate {
        pictures: 10,
        seconds: 1,
    };

    #[test]
    fn a_loop_begins_where_its_end_is_like_what_was_before_it() {
        let film = Loop::new(20, RATE);
        assert_eq!((film.fade, film.searched()), (3, 63));
        // The pictures have a period of 20 from number 30 on.
        let value = |number: u32| match number {
            ..30 => 255 - number as u8,
            _ => (number % 20 * 5) as u8,
        };
        let picture = |number| Picture::premultiplied(1, 1, vec![value(number), 0, 0, 255]);
        let pictures: Vec<_> = (0..film.searched()).map(picture).collect();
        assert_eq!(film.start(&pictures), 33);
        let shares: Vec<_> = (16..20)
            .map(|number| film.share_of_earlier(number))
            .collect();
        assert_eq!(shares, [0.0, 0.25, 0.5, 0.75]);
    }
}
