//! The embers of a film that begins again: those that are born in it, each for as long as it lives.

use crate::{Instance, Simulation};

/// Times that differ by less are those of one picture \[s\].
const SAME_TIME: f64 = 1e-6;

/// The embers of pictures.
#[derive(Clone, Debug, Default)]
pub struct Sparks {
    /// Time of each picture \[s\].
    times: Vec<f64>,
    /// Each with the number of its picture and the time of its birth \[s\].
    embers: Vec<(usize, f64, Instance)>,
}

impl Sparks {
    /// Records the embers of a picture of a fire, as the renderer gets them.
    pub fn record(&mut self, fire: &Simulation, embers: &[Instance]) {
        let (number, time) = (self.times.len(), fire.time());
        for (alive, ember) in fire.embers().iter().zip(embers) {
            self.embers
                .push((number, time - f64::from(alive.age), *ember));
        }
        self.times.push(time);
    }

    /// Writes the embers that a loop of so many pictures, of which the recorded one of number `start` is the first, shows in
    /// its picture of that time: those that are born in the loop and live then, or would live after its end.
    pub fn show(&self, time: f64, start: usize, count: usize, out: &mut Vec<Instance>) {
        out.clear();
        let time_of = |number| self.times.get(number).map_or(f64::MAX, |time| *time);
        let in_loop = time_of(start)..time_of(start + count);
        let mut shown = 0;
        while time_of(shown) < time - SAME_TIME {
            shown += 1;
        }
        // What is seen before the beginning is mixed into the end.
        shown += if shown < start { count } else { 0 };
        for (number, born, ember) in &self.embers {
            let is_shown = *number >= shown && (number - shown).is_multiple_of(count);
            if is_shown && in_loop.contains(born) {
                out.push(*ember);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ember_goes_on_over_the_end_and_one_of_before_is_not_shown() {
        let instance = |x: f32| [x; size_of::<Instance>() / 4];
        // One is born before the loop, one in it; both live on.
        let embers = (0..10_u8).flat_map(|number| {
            let of = |born, x: f32| (usize::from(number), born, instance(x));
            [of(0.5, -1.0), of(3.5, number.into())]
        });
        let sparks = Sparks {
            times: (0..10_u8).map(f64::from).collect(),
            embers: embers.collect(),
        };
        let shown = |time| {
            let mut embers = vec![instance(0.0)];
            sparks.show(time, 2, 3, &mut embers);
            embers
        };
        assert_eq!(shown(4.0), [instance(4.0), instance(7.0)]);
        assert_eq!(shown(2.0 + 1e-9), [2.0, 5.0, 8.0].map(instance));
        assert_eq!(shown(1.0), shown(4.0));
    }
}
