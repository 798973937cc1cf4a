//! Times of the passes of a picture.
//!
//! Timer queries measure them on the graphics card if the browser offers them: a query for each
//! pass of a picture, and none for the pictures until the results have arrived. A busy graphics
//! card answers many pictures later. Otherwise only the time of submitting a pass is known.

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

/// Timer queries, one after another. A context allows one at a time.
struct Timer {
    /// A query for each pass, and one that ends after the last.
    queries: Vec<WebGlQuery>,
    /// The passes of the measured picture.
    passes: Vec<&'static str>,
    state: State,
}

#[derive(PartialEq)]
enum State {
    /// The first picture is not measured, because it advects noise through the whole history.
    First,
    Idle,
    Measuring,
    Awaiting,
}

impl PassTimes {
    /// No times yet.
    pub fn new(context: &Context) -> PassTimes {
        let offered = matches!(context.get_extension(TIMER_EXTENSION), Ok(Some(_)));
        PassTimes {
            times: Vec::new(),
            timer: offered.then_some(Timer {
                queries: Vec::new(),
                passes: Vec::new(),
                state: State::First,
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

    /// Frees the queries.
    pub fn free(&self, context: &Context) {
        for query in self.timer.iter().flat_map(|timer| &timer.queries) {
            context.delete_query(Some(query));
        }
    }

    /// Begins a picture.
    pub fn begin(&mut self, context: &Context, clock: &WallClock) {
        self.submitted = 0;
        self.last = clock.now();
        if let Some(timer) = &mut self.timer {
            timer.read(context, &mut self.times);
            timer.begin(context);
        }
    }

    /// Ends a submitted pass.
    pub fn end(&mut self, context: &Context, clock: &WallClock, name: &'static str) {
        let at = self.submitted;
        self.submitted += 1;
        // Another model or look has other passes between those that stay.
        match self
            .times
            .iter()
            .skip(at)
            .position(|(known, _)| *known == name)
        {
            Some(gone) => drop(self.times.drain(at..at + gone)),
            None => self.times.insert(at, (name, 0.0)),
        }
        match &mut self.timer {
            Some(timer) => timer.follow(context, name),
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
            timer.finish(context);
        }
    }
}

impl Timer {
    /// Begins to measure a picture if no results are awaited.
    fn begin(&mut self, context: &Context) {
        if self.state == State::Idle {
            self.state = State::Measuring;
            self.passes.clear();
            self.query(context);
        }
    }

    /// Begins the query of the next pass.
    fn query(&mut self, context: &Context) {
        let at = self.passes.len();
        if self.queries.len() <= at {
            self.queries.extend(context.create_query());
        }
        // A lost context creates none.
        if let Some(query) = self.queries.get(at) {
            context.begin_query(TIME_ELAPSED, query);
        }
    }

    /// Ends the query of a pass and begins the next.
    fn follow(&mut self, context: &Context, pass: &'static str) {
        if self.state == State::Measuring {
            context.end_query(TIME_ELAPSED);
            self.passes.push(pass);
            self.query(context);
        }
    }

    /// Ends the query after the last pass.
    fn finish(&mut self, context: &Context) {
        self.state = match self.state {
            State::Measuring => {
                context.end_query(TIME_ELAPSED);
                State::Awaiting
            }
            State::First => State::Idle,
            State::Idle | State::Awaiting => return,
        };
    }

    /// Reads the results if the last has arrived.
    fn read(&mut self, context: &Context, times: &mut [(&'static str, f64)]) {
        let get = |query, what| context.get_query_parameter(query, what);
        let measured = || self.queries.iter().zip(&self.passes);
        let Some((last, _)) = measured().next_back() else {
            return;
        };
        if self.state != State::Awaiting || !get(last, Context::QUERY_RESULT_AVAILABLE).is_truthy()
        {
            return;
        }
        self.state = State::Idle;
        // A disjoint operation makes the results meaningless.
        if Calls::of(context).parameter(GPU_DISJOINT).is_truthy() {
            return;
        }
        for (query, pass) in measured() {
            let known = times.iter_mut().find(|(name, _)| name == pass);
            if let (Some(time), Some((_, average))) =
                (get(query, Context::QUERY_RESULT).as_f64(), known)
            {
                smooth(average, time * 1e-6);
            }
        }
    }
}
