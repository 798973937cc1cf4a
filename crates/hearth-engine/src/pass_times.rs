//! How long each pass of a picture takes.
//!
//! The graphics card's own clock measures it where the browser offers one: one pass a picture,
//! in turn, with an answer that may arrive some pictures later. Elsewhere only the time of
//! submitting a pass is known.

use web_sys::{WebGl2RenderingContext as Context, WebGlQuery};

use crate::average::smooth;
use crate::wall_clock::WallClock;
use crate::webgl::Calls;

const TIMER: &str = "EXT_disjoint_timer_query_webgl2";
const TIME_ELAPSED: u32 = 0x88bf;
const DISJOINT: u32 = 0x8fbb;

/// Times of the passes of one context's pictures.
pub struct PassTimes {
    /// Keys and times of the passes \[ms\], in their order.
    pub times: Vec<(&'static str, f64)>,
    timer: Option<Timer>,
    /// Passes of this picture that are submitted, and when the last one was.
    done: usize,
    last: f64,
}

/// A query of the graphics card; there is one at a time.
struct Timer {
    query: WebGlQuery,
    /// The pass that it measures.
    turn: usize,
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
        let offered = matches!(context.get_extension(TIMER), Ok(Some(_)));
        let query = offered.then(|| context.create_query()).flatten();
        PassTimes {
            times: Vec::new(),
            timer: query.map(|query| Timer {
                query,
                turn: 0,
                state: State::Idle,
            }),
            done: 0,
            last: 0.0,
        }
    }

    /// The clock that measures: `gpu`, or `submit`.
    pub fn timer(&self) -> &'static str {
        match self.timer {
            Some(_) => "gpu",
            None => "submit",
        }
    }

    /// Time of all passes on the graphics card \[ms\]; zero if it offers no clock.
    pub fn on_card(&self) -> f64 {
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
    pub fn begin(&mut self, context: &Context, host: &WallClock) {
        self.done = 0;
        self.last = host.now();
        if let Some(timer) = &mut self.timer {
            timer.read(context, &mut self.times);
            timer.begin(context, 0);
        }
    }

    /// Ends a pass, which is submitted.
    pub fn end(&mut self, context: &Context, host: &WallClock, name: &'static str) {
        let at = self.done;
        self.done += 1;
        if self.times.get(at).is_none_or(|(known, _)| *known != name) {
            // Another model or look: from here on the passes are others.
            self.times.truncate(at);
            self.times.push((name, 0.0));
        }
        match &mut self.timer {
            Some(timer) => {
                timer.end(context);
                timer.begin(context, at + 1);
            }
            None => {
                let now = host.now();
                smooth(&mut self.times[at].1, now - self.last);
                self.last = now;
            }
        }
    }

    /// Ends a picture, which is submitted.
    pub fn finish(&mut self, context: &Context) {
        self.times.truncate(self.done);
        if let Some(timer) = &mut self.timer {
            // This picture may have fewer passes than the last one.
            timer.end(context);
            if timer.turn >= self.done {
                timer.turn = 0;
            }
        }
    }
}

impl Timer {
    fn begin(&mut self, context: &Context, pass: usize) {
        if self.state == State::Idle && pass == self.turn {
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

    /// Reads the answer, if it has arrived.
    fn read(&mut self, context: &Context, times: &mut [(&'static str, f64)]) {
        let ask = |what| context.get_query_parameter(&self.query, what);
        if self.state != State::Ended || !ask(Context::QUERY_RESULT_AVAILABLE).is_truthy() {
            return;
        }
        self.state = State::Idle;
        // A clock that was reset meanwhile measures nothing.
        let broken = Calls::of(context).ask(DISJOINT);
        if let (Some(time), Some((_, average))) = (
            ask(Context::QUERY_RESULT).as_f64(),
            times.get_mut(self.turn),
        ) && broken.is_falsy()
        {
            smooth(average, time * 1e-6);
        }
        self.turn = (self.turn + 1) % times.len().max(1);
    }
}
