//! The series of steps that sound follows from: length, power and events of each step.

/// Most records that wait for a reader: those of some three seconds. Older ones are dropped.
const MAX_RECORDS: usize = 2048;

/// A step: its length, its power and its events. Masses are those of the step, per metre of depth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepRecord {
    /// Length of the step \[s\].
    pub length: f32,
    /// Power of the combustion [kW/m]; 0 in the classic model.
    pub power: f32,
    /// Water that solids with fuel gave off as steam [kg/m].
    pub dried: f32,
    /// Char that formed in solids with fuel [kg/m].
    pub charred: f32,
    /// Mean load of the solids that burn [kg/m²]; 0 without any.
    pub load: f32,
    /// Parts that broke off solids with fuel.
    pub broken: f32,
    /// Embers thrown.
    pub sparks: f32,
    /// Mean place of these embers or, without any, of the solids that burn, from the middle \[m\].
    pub place: f32,
    /// Water of sprays that evaporated or boiled [kg/m].
    pub steam: f32,
    /// Speed of the fastest narrow source that burns [m/s].
    pub jet: f32,
    /// Particles that the classic model made.
    pub births: f32,
    /// Particles that the classic model removed.
    pub deaths: f32,
}

impl StepRecord {
    /// Count of its numbers.
    pub const NUMBERS: usize = 12;

    /// Its numbers, in the order of the fields.
    pub fn numbers(&self) -> [f32; StepRecord::NUMBERS] {
        [
            self.length,
            self.power,
            self.dried,
            self.charred,
            self.load,
            self.broken,
            self.sparks,
            self.place,
            self.steam,
            self.jet,
            self.births,
            self.deaths,
        ]
    }
}

/// What has happened in a fire since it began, except for `load` and `place`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Totals {
    pub dried: f64,
    pub charred: f64,
    /// Mean load of the solids that burn now [kg/m²].
    pub load: f32,
    pub broken: f64,
    pub sparks: f64,
    /// Sum of the places of the embers \[m\].
    pub moment: f64,
    /// Mean place of the solids that burn now \[m\].
    pub place: f32,
    pub steam: f64,
    pub births: f64,
    pub deaths: f64,
}

/// The records that wait for a reader.
#[derive(Clone, Debug, Default)]
pub(crate) struct Recorder {
    records: Vec<StepRecord>,
    before: Totals,
}

impl Recorder {
    /// No records, of a fire with these totals.
    pub fn new(before: Totals) -> Recorder {
        Recorder {
            records: Vec::with_capacity(MAX_RECORDS),
            before,
        }
    }

    /// Adds a step of a length \[s\] with a power [kW/m] and a jet [m/s], after which there are these totals.
    pub fn add(&mut self, length: f64, power: f32, jet: f32, now: Totals) {
        let before = std::mem::replace(&mut self.before, now);
        // A fire that starts again has smaller totals, and gave nothing.
        let since = |now: f64, before: f64| (now - before).max(0.0) as f32;
        let sparks = since(now.sparks, before.sparks);
        if self.records.len() == MAX_RECORDS {
            self.records.drain(..MAX_RECORDS / 2);
        }
        self.records.push(StepRecord {
            length: length as f32,
            power,
            dried: since(now.dried, before.dried),
            charred: since(now.charred, before.charred),
            load: now.load,
            broken: since(now.broken, before.broken),
            sparks,
            place: if sparks > 0.0 {
                (now.moment - before.moment) as f32 / sparks
            } else {
                now.place
            },
            steam: since(now.steam, before.steam),
            jet,
            births: since(now.births, before.births),
            deaths: since(now.deaths, before.deaths),
        });
    }

    /// The records.
    pub fn records(&self) -> &[StepRecord] {
        &self.records
    }

    /// Forgets the records.
    pub fn clear(&mut self) {
        self.records.clear();
    }
}
