//! Times of the passes of a picture.
//!
//! A timer query measures them on the graphics card if the browser offers one: one pass per
//! picture, in turn, with a result that may arrive some pictures later. Otherwise only the
//! time of submitting a pass is known.

use web_sys::{WebGl2RenderingContext as Context, WebGlQuery};

use crate::pacing::averages::smooth;
use crate::wall_clock::WallClock;
use crate::webgl::Calls;

const TIMER_EXTENSION: &str = "EXT_disjoint_timer_query_webgl2";
const TIME_ELAPSED: u32 = 0x88bf;
const GPU_DISJOINT: u32 = 0x8fbb;

/// Times of the passes of one fire.
pub struct PassTimes {
    /// Names of the passes and their times \[ms\], in drawing order.
    pub times: Vec<(&'static str, f64)>,
    timer: Option<Timer>,
    /// Number of submitted passes of this picture.
    submitted: usize,
    /// Time of the last submission \[ms\].
    last: f64,
}

/// A timer query. A context allows one at a time.
struct Timer {
    query: WebGlQuery,
    /// Index of the measured pass.
    pass: usize,
    state: State,
}

#[derive(PartialEq)]
enum State {
    Idle,
    Begun,
    Ended,
}

impl PassTimes {
    /// No times yet.
    pub fn new(context: &Context) -> PassTimes {
        let offered = matches!(context.get_extension(TIMER_EXTENSION), Ok(Some(_)));
        let query = offered.then(|| context.create_query()).flatten();
        PassTimes {
            times: Vec::new(),
            timer: query.map(|query| Timer {
                query,
                pass: 0,
                state: State::Idle,
            }),
            submitted: 0,
            last: 0.0,
        }
    }

    /// What the times measure: `gpu` or `submit`, as in `stats`.
    pub fn timer(&self) -> &'static str {
        match self.timer {
            Some(_) => "gpu",
            None => "submit",
        }
    }

    /// Time of all passes on the graphics card \[ms\]; 0 without a timer.
    pub fn gpu_ms(&self) -> f64 {
        match self.timer {
            Some(_) => self.times.iter().map(|(_, time)| time).sum(),
            None => 0.0,
        }
    }

    /// Frees the query.
    pub fn free(&self, context: &Context) {
        if let Some(timer) = &self.timer {
            context.delete_query(Some(&timer.query));
        }
    }

    /// Begins a picture.
    pub fn begin(&mut self, context: &Context, clock: &WallClock) {
        self.submitted = 0;
        self.last = clock.now();
        if let Some(timer) = &mut self.timer {
            timer.read(context, &mut self.times);
            timer.begin(context, 0);
        }
    }

    /// Ends a submitted pass.
    pub fn end(&mut self, context: &Context, clock: &WallClock, name: &'static str) {
        let at = self.submitted;
        self.submitted += 1;
        if self.times.get(at).is_none_or(|(known, _)| *known != name) {
            // Another model or look has other passes from here on.
            self.times.truncate(at);
            self.times.push((name, 0.0));
        }
        match &mut self.timer {
            Some(timer) => {
                timer.end(context);
                timer.begin(context, at + 1);
            }
            None => {
                let now = clock.now();
                smooth(&mut self.times[at].1, now - self.last);
                self.last = now;
            }
        }
    }

    /// Ends a submitted picture.
    pub fn finish(&mut self, context: &Context) {
        self.times.truncate(self.submitted);
        if let Some(timer) = &mut self.timer {
            // This picture may have fewer passes than the last one.
            timer.end(context);
            if timer.pass >= self.submitted {
                timer.pass = 0;
            }
        }
    }
}

impl Timer {
    fn begin(&mut self, context: &Context, pass: usize) {
        if self.state == State::Idle && pass == self.pass {
            context.begin_query(TIME_ELAPSED, &self.query);
            self.state = State::Begun;
        }
    }

    fn end(&mut self, context: &Context) {
        if self.state == State::Begun {
            context.end_query(TIME_ELAPSED);
            self.state = State::Ended;
        }
    }

    /// Reads the result if it has arrived.
    fn read(&mut self, context: &Context, times: &mut [(&'static str, f64)]) {
        let query = |what| context.get_query_parameter(&self.query, what);
        if self.state != State::Ended || !query(Context::QUERY_RESULT_AVAILABLE).is_truthy() {
            return;
        }
        self.state = State::Idle;
        // A disjoint operation makes the result meaningless.
        let disjoint = Calls::of(context).parameter(GPU_DISJOINT);
        if let (Some(time), Some((_, average))) = (
            query(Context::QUERY_RESULT).as_f64(),
            times.get_mut(self.pass),
        ) && disjoint.is_falsy()
        {
            smooth(average, time * 1e-6);
        }
        self.pass = (self.pass + 1) % times.len().max(1);
    }
}
