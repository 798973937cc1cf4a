//! How much work a fire makes itself: how many particles, how fine a picture.
//!
//! Left to itself it starts with a guess for the device, tries the guess for
//! half a second, and then keeps an eye on what frames take against the time
//! that the display gives them. It gives way at once when that is too much,
//! and takes more only when there was room for a while, each time it had to give
//! way again after a longer while, and never more than a few times: a
//! fire that changes all the time is worse than a coarse one.

use std::fmt::Write as _;

use crate::budget::STEPS_BUDGET_MS;

/// How much work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// For phones and machines without a graphics card.
    Low,
    /// For most.
    Medium,
    /// For fast ones.
    High,
}

impl Level {
    /// All of them, the least first.
    pub const ALL: [Level; 3] = [Level::Low, Level::Medium, Level::High];

    /// The level of that name.
    pub fn of(name: &str) -> Option<Level> {
        Level::ALL.into_iter().find(|level| level.name() == name)
    }

    /// Its name in attributes and messages.
    pub fn name(self) -> &'static str {
        ["low", "medium", "high"][self as usize]
    }

    /// Particles of the combustion model, where nobody asks for a number.
    pub fn particles(self) -> u32 {
        [1200, 3000, 6700][self as usize]
    }

    /// Most pixels of a picture, where nobody asks for a number: a 720p, 1080p or 1440p
    /// screen's.
    pub fn pixels(self) -> f64 {
        [921_600.0, 2_073_600.0, 3_686_400.0][self as usize]
    }
}

/// What a frame took, and all that came since the one before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// When it came \[ms\].
    pub now: f64,
    /// Least time since the one before that somebody asked for; 0 where nobody did \[ms\].
    pub apart: f64,
    /// Time of its steps \[ms\].
    pub steps_ms: f64,
    /// Seconds of fire that they made.
    pub made: f64,
    /// Time of drawing it, the processor's or the graphics card's \[ms\].
    pub draw_ms: f64,
    /// Seconds of fire for each second of the clock, as is wanted.
    pub time_scale: f64,
    /// Whether the fire lately fell behind the clock.
    pub slowed: bool,
    /// The number of particles at each level, where it follows from that.
    pub particles: Option<[u32; 3]>,
    /// Fires that share it.
    pub fires: usize,
}

/// Time between two decisions, and before the first one \[ms\].
const WINDOW: f64 = 1000.0;
const TRIAL: f64 = 500.0;
/// Longest time between two frames that is held against a fire \[ms\].
const LONGEST: f64 = 250.0;
/// Shortest time between two frames \[ms\]: what comes sooner is the same one again.
const SHORTEST: f64 = 1.0;
/// Time between two frames of a display that any can be asked to keep up with \[ms\],
/// and of the fastest that a fire gives anything away for.
const USUAL: f64 = 1000.0 / 60.0;
const FASTEST: f64 = 4.0;
/// Share of a frame above which a fire takes too much of it.
const TOO_MUCH: f64 = 0.9;
/// The same for drawing, where nothing can be done about the steps.
const DRAWING: f64 = 0.5;
/// Share of the budget for steps above which they are why it falls behind.
const ALL_OF_IT: f64 = 0.9;
/// Share of a frame that another level may be expected to take.
const ROOM: f64 = 0.6;
/// How much longer than the display's frames a fire's may last on average.
const LATE: f64 = 1.3;
/// Windows in a row with too much, or with late frames, before it gives way.
const TOO_MUCH_FOR: u32 = 2;
const LATE_FOR: u32 = 3;
/// Windows with room before it takes more; that many times as many each time it
/// had to give way.
const CALM_FOR: u32 = 3;
const MORE_PATIENCE: u32 = 4;
/// How often it may take more.
const MOST_RISES: u32 = 4;

/// Frames over which the time of steps is taken in a trial: browsers' clocks are
/// too coarse for one.
const GROUP: f64 = 8.0;
/// Gaps between frames that a window remembers.
const GAPS: usize = 32;

/// Sums over the frames between two decisions.
#[derive(Clone, Copy, Debug, Default)]
struct Window {
    start: Option<f64>,
    frames: f64,
    gaps: f64,
    steps_ms: f64,
    made: f64,
    draw_ms: f64,
    /// Least time for a second of fire in a group of frames \[ms\].
    best: Option<f64>,
    /// Time of steps, and fire made, before this group.
    before: [f64; 2],
    /// Its last gaps, in a ring.
    last: [f64; GAPS],
}

impl Window {
    fn count(&mut self, frame: &Frame, gap: f64) {
        self.last[self.frames as usize % GAPS] = gap;
        self.frames += 1.0;
        self.gaps += gap;
        self.steps_ms += frame.steps_ms;
        self.made += frame.made;
        self.draw_ms += frame.draw_ms;
        if self.frames % GROUP == 0.0 {
            let [steps_ms, made] = [self.steps_ms - self.before[0], self.made - self.before[1]];
            self.before = [self.steps_ms, self.made];
            let best = self.best.unwrap_or(f64::INFINITY);
            if made > 0.0 && steps_ms > 0.0 && steps_ms / made < best {
                self.best = Some(steps_ms / made);
            }
        }
    }

    /// Lower quartile of its last gaps: frames that come late do not change it, and
    /// neither do a few that come early.
    fn quartile(&self) -> f64 {
        let gaps = &self.last[..GAPS.min(self.frames as usize)];
        let quarter = gaps.len() / 4;
        let is_it = |gap: &f64| {
            let shorter = gaps.iter().filter(|other| *other < gap).count();
            let as_short = gaps.iter().filter(|other| *other <= gap).count();
            shorter <= quarter && quarter < as_short
        };
        gaps.iter().copied().find(is_it).unwrap_or(USUAL)
    }
}

/// The level of a fire, and why it is that.
#[derive(Clone, Debug)]
pub struct Quality {
    wish: Option<Level>,
    level: Level,
    reason: String,
    last: Option<f64>,
    /// Time between two frames of the display, as far as is known \[ms\].
    display: f64,
    window: Window,
    tried: bool,
    /// Windows in a row.
    too_much: u32,
    late: u32,
    calm: u32,
    patience: u32,
    rises: u32,
}

impl Quality {
    /// The level that is wished for or, without a wish, at first this `guess`.
    pub fn new(wish: Option<Level>, guess: Level) -> Quality {
        let mut quality = Quality {
            wish: None,
            level: guess,
            reason: "a guess for this device".into(),
            last: None,
            display: USUAL,
            window: Window::default(),
            tried: false,
            too_much: 0,
            late: 0,
            calm: 0,
            patience: CALM_FOR,
            rises: 0,
        };
        if wish.is_some() {
            quality.ask(wish);
        }
        quality
    }

    /// What somebody wishes for; nothing: that it finds its level itself.
    pub fn ask(&mut self, wish: Option<Level>) {
        self.wish = wish;
        self.reason = match wish {
            Some(level) => {
                self.level = level;
                "as asked for"
            }
            None => "as it was when it was left to itself",
        }
        .into();
        self.window = Window::default();
        (self.too_much, self.late, self.calm) = (0, 0, 0);
        (self.patience, self.rises) = (CALM_FOR, 0);
    }

    /// What is wished for.
    pub fn wish(&self) -> Option<Level> {
        self.wish
    }

    /// The level at present.
    pub fn level(&self) -> Level {
        self.level
    }

    /// Why it is that, in words.
    pub fn reason(&self) -> &str {
        &self.reason
    }

    /// The next frame is not one after the last: there was a pause.
    pub fn skip(&mut self) {
        self.last = None;
        self.window = Window::default();
        (self.too_much, self.late, self.calm) = (0, 0, 0);
    }

    /// Takes note of a frame. Returns whether the level is another one now.
    pub fn frame(&mut self, frame: &Frame) -> bool {
        let gap = self.last.map(|last| frame.now - last);
        if gap.is_some_and(|gap| gap < SHORTEST) {
            return false;
        }
        self.last = Some(frame.now);
        let Some(gap) = gap else {
            return false;
        };
        let start = *self.window.start.get_or_insert(frame.now);
        let counted = if gap < LONGEST { gap } else { LONGEST };
        self.window.count(frame, counted);
        let length = if self.tried { WINDOW } else { TRIAL };
        if frame.now - start < length {
            return false;
        }
        let window = std::mem::take(&mut self.window);
        self.watch_display(window.quartile());
        // Who is to draw seldom is not late.
        if self.display < frame.apart {
            self.display = frame.apart;
        }
        if self.wish.is_some() || window.made == 0.0 {
            return false;
        }
        let trial = !std::mem::replace(&mut self.tried, true);
        let load = self.load(&window, frame, trial);
        let level = if trial {
            self.first_pick(&load)
        } else {
            self.keep_watch(&load)
        };
        let changes = level.is_some();
        if let Some(level) = level {
            (self.too_much, self.late, self.calm) = (0, 0, 0);
            self.level = level;
        }
        changes
    }

    /// Learns what the display's frames are from those of a window. They may become
    /// longer: the page moves to another display, or power is saved. Beyond what is
    /// usual that is believed only slowly, and only where nothing is left to give: who is
    /// always late, whatever is done about it, has a slow display.
    fn watch_display(&mut self, gap: f64) {
        let known = if self.display > USUAL {
            self.display
        } else {
            USUAL
        };
        self.display = if gap <= known {
            if gap > FASTEST { gap } else { FASTEST }
        } else if self.level == Level::Low {
            known + 0.05 * (gap - known)
        } else {
            known
        };
    }

    /// What this window's frames took. In the first half second the browser is
    /// still compiling: its best frames tell more than the mean, and drawing tells
    /// nothing.
    fn load(&self, window: &Window, frame: &Frame, trial: bool) -> Load {
        let rate = window.steps_ms / window.made;
        let (rate, draw) = if trial {
            (window.best.unwrap_or(rate), 0.0)
        } else {
            (rate, window.draw_ms / window.frames)
        };
        let mut load = Load {
            level: self.level,
            particles: frame.particles,
            steps: rate * frame.time_scale * self.display * 1e-3,
            draw,
            room: self.display / frame.fires.max(1) as f64,
            gap: window.gaps / window.frames,
            too_much: false,
            late: false,
        };
        load.too_much = if frame.particles.is_some() {
            // Whose frames are rare falls behind, too, whatever its steps take.
            let budget = ALL_OF_IT * STEPS_BUDGET_MS / frame.fires.max(1) as f64;
            let slowed = frame.slowed && !trial && load.steps > budget;
            load.expected(self.level) > TOO_MUCH * load.room || slowed
        } else {
            draw > DRAWING * load.room
        };
        // Late although it takes little here: the graphics card, or the page. Where it
        // is the steps, and their number is somebody else's, nothing can be done.
        let rare = load.gap > LATE * self.display;
        let busy = (window.steps_ms + window.draw_ms) / window.frames;
        let helps = frame.particles.is_some() || busy + self.display < load.gap;
        load.late = rare && helps && !load.too_much;
        load
    }

    /// The level that should fit, after a trial of the guess.
    fn first_pick(&mut self, load: &Load) -> Option<Level> {
        let level = if load.too_much {
            load.lower()
        } else {
            let mut all = Level::ALL.into_iter().rev();
            all.find(|level| load.fits(*level))
                .filter(|level| *level > self.level && !load.late)
        };
        let level = level.filter(|_| load.particles.is_some())?;
        self.because("steps should take ", load.expected(level), load, level);
        Some(level)
    }

    /// Another level, where this one was too much for a while, or there was room
    /// for more.
    fn keep_watch(&mut self, load: &Load) -> Option<Level> {
        count(&mut self.too_much, load.too_much);
        count(&mut self.late, load.late);
        let higher = Level::ALL.into_iter().find(|level| *level > self.level);
        let higher = higher.filter(|level| !load.too_much && !load.late && load.fits(*level));
        count(&mut self.calm, higher.is_some());
        if self.too_much >= TOO_MUCH_FOR {
            let level = load.lower()?;
            self.because(
                "steps and drawing took ",
                load.expected(self.level),
                load,
                level,
            );
            self.patience *= MORE_PATIENCE;
            return Some(level);
        }
        if self.late >= LATE_FOR {
            let mut lower = Level::ALL.into_iter().rev();
            let level = lower.find(|level| *level < self.level)?;
            self.because("pictures come every ", load.gap, load, level);
            self.patience *= MORE_PATIENCE;
            return Some(level);
        }
        let level = higher.filter(|_| self.calm >= self.patience && self.rises < MOST_RISES)?;
        self.because(
            "steps and drawing should take ",
            load.expected(level),
            load,
            level,
        );
        self.rises += 1;
        Some(level)
    }

    /// Says why it goes to another level, which changes the number of particles or
    /// at least the picture.
    fn because(&mut self, what: &str, ms: f64, load: &Load, level: Level) {
        let mut reason = String::new();
        for (words, ms) in [(what, ms), (" for a frame of ", load.room)] {
            // Formatting a fraction would bring 20 KB of code.
            let tenths = (ms * 10.0).round() as u32;
            let _ = write!(reason, "{words}{}.{} ms", tenths / 10, tenths % 10);
        }
        let number = |level: Level| load.particles.map(|numbers| numbers[level as usize]);
        let _ = if let (Some(new), Some(old)) = (number(level), number(self.level))
            && new != old
        {
            let (new, old) = (in_words(new), in_words(old));
            write!(reason, ": {new} particles instead of {old}")
        } else {
            let than = if level < self.level {
                "coarser"
            } else {
                "finer"
            };
            write!(reason, ": a {than} picture")
        };
        self.reason = reason;
    }
}

/// What the frames of a window took, each.
struct Load {
    level: Level,
    particles: Option<[u32; 3]>,
    /// Time of all the steps that are wanted \[ms\].
    steps: f64,
    /// Time of drawing \[ms\].
    draw: f64,
    /// Time that there is \[ms\].
    room: f64,
    /// Time from one to the next \[ms\].
    gap: f64,
    too_much: bool,
    late: bool,
}

impl Load {
    /// What a frame may be expected to take at another level \[ms\].
    fn expected(&self, level: Level) -> f64 {
        // More particles are more work a step, and shorter steps.
        let more = self.particles.map_or(1.0, |numbers| {
            f64::from(numbers[level as usize]) / f64::from(numbers[self.level as usize].max(1))
        });
        let steps = self.steps * more * more.sqrt();
        steps + self.draw * if level > self.level { 2.0 } else { 1.0 }
    }

    fn fits(&self, level: Level) -> bool {
        self.expected(level) <= ROOM * self.room
    }

    /// The highest level below that should fit, else the lowest; none below that.
    fn lower(&self) -> Option<Level> {
        let mut below = Level::ALL.into_iter().rev();
        below
            .find(|level| *level < self.level && self.fits(*level))
            .or((self.level > Level::Low).then_some(Level::Low))
    }
}

/// A number of particles as a person reads it.
fn in_words(number: u32) -> String {
    let mut words = number.to_string();
    if number >= 1000 {
        words.insert(words.len() - 3, ',');
    }
    words
}

/// How many times in a row it was so.
fn count(times: &mut u32, so: bool) {
    *times = if so { *times + 1 } else { 0 };
}
