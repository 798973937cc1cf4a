//! The records of embers, with the rates at which their paths turn.

use hearth_core::Instance;

use crate::instance::{temperature, velocity};

/// Fields of an ember's record: its size, which names it, and its age, which its rate of turn replaces.
const SIZE: usize = 5;
const AGE: usize = 6;
/// Minimum square of the speed of an ember that turns [m²/s²].
const MIN_SQUARED_SPEED: f32 = 1e-4;

/// The paths of embers, from one upload to the next.
#[derive(Default)]
pub struct Paths {
    /// The embers of the last upload with their ages.
    before: Vec<Instance>,
    /// The records of the last upload.
    records: Vec<Instance>,
}

impl Paths {
    /// The records of embers, and after them of water, which has negative temperatures.
    pub fn records(&mut self, embers: &[Instance]) -> &[Instance] {
        self.records = turning(embers, &self.before, &self.records);
        self.before.clear();
        self.before.extend_from_slice(embers);
        &self.records
    }
}

/// The records of embers: each with its rate of turn [rad/s] since the last upload. Embers stay in the order
/// of their births, so that one search finds them all.
fn turning(embers: &[Instance], before: &[Instance], records: &[Instance]) -> Vec<Instance> {
    let mut known = before.iter().zip(records);
    embers
        .iter()
        .map(|ember| {
            let mut record = *ember;
            if is_spark(ember) {
                let found = known.find(|(old, _)| old[SIZE] == ember[SIZE]);
                record[AGE] = found.map_or(0.0, |(old, drawn)| rate_of_turn(ember, old, drawn));
            }
            record
        })
        .collect()
}

/// Rate at which the path of an ember turns counterclockwise; that of its record in an upload of the same moment.
fn rate_of_turn(ember: &Instance, old: &Instance, record: &Instance) -> f32 {
    let elapsed = ember[AGE] - old[AGE];
    if elapsed <= 0.0 {
        return record[AGE];
    }
    let ([x, y], [from_x, from_y]) = (velocity(ember), velocity(old));
    (from_x * y - from_y * x) / ((x * x + y * y).max(MIN_SQUARED_SPEED) * elapsed)
}

fn is_spark(ember: &Instance) -> bool {
    temperature(ember) > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A spark with that velocity, size and age.
    fn spark(velocity: [f32; 2], size: f32, age: f32) -> Instance {
        [0.0, 0.0, velocity[0], velocity[1], 1500.0, size, age, 1.0]
    }

    #[test]
    fn a_spark_on_a_circle_has_the_rate_of_its_turn() {
        let (rate, elapsed) = (8.0_f32, 0.01);
        let angle = rate * elapsed;
        let water = [0.0, 0.0, 1.0, 0.0, -1.0, 0.006, 0.5, 1.0];
        let before = [spark([1.0, 0.0], 0.1, 1.0), spark([2.0, 0.0], 0.2, 0.5)];
        let first = turning(&before, &[], &[]);
        assert!(first.iter().all(|record| record[AGE] == 0.0));
        // The first has died, another is born.
        let turned = [angle.cos(), angle.sin()].map(|part| 2.0 * part);
        let now = [
            spark(turned, 0.2, 0.5 + elapsed),
            spark([1.0, 1.0], 0.3, 0.0),
            water,
        ];
        let records = turning(&now, &before, &first);
        assert!((records[0][AGE] - rate).abs() < 0.02, "{}", records[0][AGE]);
        assert_eq!((records[1][AGE], records[2]), (0.0, water));
        // The same moment once more.
        assert_eq!(turning(&now, &now, &records), records);
    }
}
