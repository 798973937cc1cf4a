//! The embers of a film that begins again: those that are born in it, each for as long as it lives.

use crate::{Instance, Simulation};

/// Times that differ by less are those of one picture \[s\].
const SAME_TIME: f64 = 1e-6;

/// The embers of pictures, each with the time of its birth.
#[derive(Clone, Debug, Default)]
pub struct Sparks {
    /// Time and embers of each picture \[s\].
    pictures: Vec<(f64, Vec<(f64, Instance)>)>,
}

impl Sparks {
    /// Records the embers of a picture of a fire, as the renderer gets them.
    pub fn record(&mut self, fire: &Simulation, embers: &[Instance]) {
        let (time, alive) = (fire.time(), fire.embers());
        let births = alive.iter().map(|ember| time - f64::from(ember.age));
        let embers = births.zip(embers.iter().copied()).collect();
        self.pictures.push((time, embers));
    }

    /// The embers that a loop of so many pictures, of which the recorded one of number `start` is the first, shows in its
    /// picture of that time: those that are born in the loop and live then, or would live after its end.
    pub fn shown(&self, time: f64, start: usize, count: usize) -> Vec<Instance> {
        let earlier = |(at, _): &(f64, _)| *at < time - SAME_TIME;
        let number = self.pictures.partition_point(earlier);
        let number = (number + count).saturating_sub(start) % count.max(1);
        let time_of = |number| {
            self.pictures
                .get(number)
                .map_or(f64::MAX, |(time, _)| *time)
        };
        let in_loop = time_of(start)..time_of(start + count);
        let pictures = self.pictures.iter().skip(start + number);
        let embers = pictures
            .step_by(count.max(1))
            .flat_map(|(_, embers)| embers);
        let shown = embers.filter(|(born, _)| in_loop.contains(born));
        shown.map(|(_, ember)| *ember).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ember_goes_on_over_the_end_and_one_of_before_is_not_shown() {
        let instance = |x: f32| [x; size_of::<Instance>() / 4];
        // One is born before the loop, one in it; both live on.
        let picture = |number: u8| {
            let embers = vec![(0.5, instance(-1.0)), (3.5, instance(number.into()))];
            (f64::from(number), embers)
        };
        let sparks = Sparks {
            pictures: (0..10).map(picture).collect(),
        };
        let shown = |time| sparks.shown(time, 2, 3);
        assert_eq!(shown(4.0), [instance(4.0), instance(7.0)]);
        assert_eq!(shown(2.0 + 1e-9), [2.0, 5.0, 8.0].map(instance));
        // What is seen before the beginning is mixed into the end.
        assert_eq!(shown(1.0), shown(4.0));
    }
}
