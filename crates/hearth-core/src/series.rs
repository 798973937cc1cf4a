//! The series that sound follows from: length, power and events of each part of a step.

use crate::extremes::fast_max;

/// Most steps that wait for a reader: those of some three seconds. The next one drops them.
const MAX_STEPS: usize = 2048;

/// The totals, by their places.
pub(crate) const DRIED: usize = 0;
pub(crate) const CHARRED: usize = 1;
pub(crate) const BROKEN: usize = 2;
pub(crate) const SPARKS: usize = 3;
pub(crate) const POPS: usize = 4;
pub(crate) const STEAM: usize = 5;
pub(crate) const BIRTHS: usize = 6;
pub(crate) const DEATHS: usize = 7;

/// Numbers of a step that are no totals, and those that add up to one.
const MOMENTARY: usize = 7;
const GROWN: usize = 8;

/// A part of a step, of which the combustion model has two and the classic model one: its length, its power and its
/// events, which the first part has. Masses are per metre of depth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepRecord {
    /// Its length \[s\].
    pub length: f32,
    /// Power of the combustion in it [kW/m]; 0 in the classic model.
    pub power: f32,
    /// Mean load of the solids that burn [kg/m²]; 0 without any.
    pub load: f32,
    /// Mean place of the embers thrown or, without any, of the solids that burn, from the middle \[m\].
    pub place: f32,
    /// Speed of the fastest narrow source that burns [m/s].
    pub jet: f32,
    /// Highest ratio of speed, or wind, to width of a wide source that burns [1/s].
    pub flutter: f32,
    /// 1 before a wall, 0 in the open.
    pub wall: f32,
    /// Water that solids with fuel gave off as steam [kg/m].
    pub dried: f32,
    /// Char that formed in solids with fuel [kg/m].
    pub charred: f32,
    /// Parts that broke off solids with fuel.
    pub broken: f32,
    /// Embers thrown.
    pub sparks: f32,
    /// Embers thrown by a pop, which are among them.
    pub pops: f32,
    /// Water of sprays that evaporated or boiled [kg/m].
    pub steam: f32,
    /// Particles that the classic model made.
    pub births: f32,
    /// Particles that the classic model removed.
    pub deaths: f32,
}

impl StepRecord {
    /// Count of its numbers.
    pub const NUMBERS: usize = MOMENTARY + GROWN;

    /// The step of these numbers, in the order of the fields.
    pub fn of(numbers: [f32; StepRecord::NUMBERS]) -> StepRecord {
        let [
            length,
            power,
            load,
            place,
            jet,
            flutter,
            wall,
            ref totals @ ..,
        ] = numbers;
        let [dried, charred, broken, sparks, pops, steam, births, deaths] = *totals;
        StepRecord {
            length,
            power,
            load,
            place,
            jet,
            flutter,
            wall,
            dried,
            charred,
            broken,
            sparks,
            pops,
            steam,
            births,
            deaths,
        }
    }
}

/// What has happened in a fire since it began, in the units of [`StepRecord`]; load and place are those of now.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Totals {
    pub load: f32,
    pub place: f32,
    /// Sum of the places of the embers \[m\].
    pub moment: f64,
    /// The numbers of a step from `dried` on, of all steps.
    pub grown: [f64; GROWN],
}

/// The steps that wait for a reader.
#[derive(Clone, Debug, Default)]
pub(crate) struct Recorder {
    /// All numbers of one step, then of the next.
    numbers: Vec<f32>,
    before: Totals,
}

crate::state! { Totals: load place moment grown, Recorder: numbers before }

impl Recorder {
    /// No steps, of a fire with these totals.
    pub fn new(before: Totals) -> Recorder {
        Recorder {
            numbers: Vec::with_capacity(MAX_STEPS * StepRecord::NUMBERS),
            before,
        }
    }

    /// Adds a step, after which there are these totals: its length, power, jet, flutter and wall.
    pub fn add(&mut self, [length, power, jet, flutter, wall]: [f32; 5], now: Totals) {
        let before = std::mem::replace(&mut self.before, now);
        let sparks = now.grown[SPARKS] - before.grown[SPARKS];
        let place = if sparks > 0.0 {
            ((now.moment - before.moment) / sparks) as f32
        } else {
            now.place
        };
        if self.numbers.len() >= MAX_STEPS * StepRecord::NUMBERS {
            self.numbers.clear();
        }
        let mut numbers = [0.0; StepRecord::NUMBERS];
        let momentary = [length, power, now.load, place, jet, flutter, wall];
        numbers[..MOMENTARY].copy_from_slice(&momentary);
        for (number, (now, before)) in numbers[MOMENTARY..]
            .iter_mut()
            .zip(now.grown.into_iter().zip(before.grown))
        {
            // A fire that starts again has smaller totals, and gave nothing.
            *number = fast_max((now - before) as f32, 0.0);
        }
        self.numbers.extend_from_slice(&numbers);
    }

    /// The steps.
    pub fn steps(&self) -> Vec<StepRecord> {
        let (steps, _) = self.numbers.as_chunks();
        steps.iter().copied().map(StepRecord::of).collect()
    }

    /// All numbers of one step, then of the next.
    pub fn numbers(&self) -> &[f32] {
        &self.numbers
    }

    /// Forgets the steps.
    pub fn clear(&mut self) {
        self.numbers.clear();
    }
}
