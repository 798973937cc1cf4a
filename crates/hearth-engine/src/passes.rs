//! How long each pass of a picture takes.
//!
//! By the graphics card's own clock where the browser lends it: one pass a
//! picture in turn, and its answer is waited for over as many pictures as it
//! takes. Elsewhere all that can be told is how long it took to hand the pass over.

use web_sys::{WebGl2RenderingContext as Context, WebGlQuery};

use crate::average::smooth;
use crate::wall_clock::WallClock;
use crate::webgl::Calls;

const TIMER: &str = "EXT_disjoint_timer_query_webgl2";
const TIME_ELAPSED: u32 = 0x88bf;
const DISJOINT: u32 = 0x8fbb;

/// Times of the passes of one context's pictures.
pub struct Passes {
    /// Each pass with its time \[ms\], in their order.
    pub times: Vec<(&'static str, f64)>,
    timer: Option<Timer>,
    /// Passes of this picture that are handed over, and when the last one was.
    done: usize,
    last: f64,
}

/// A question to the graphics card; there is one at a time.
struct Timer {
    query: WebGlQuery,
    /// The pass that it is about.
    turn: usize,
    state: Asked,
}

#[derive(PartialEq)]
enum Asked {
    Nothing,
    Begun,
    Ended,
}

impl Passes {
    /// No pass was measured yet.
    pub fn new(context: &Context) -> Passes {
        let lent = matches!(context.get_extension(TIMER), Ok(Some(_)));
        let query = lent.then(|| context.create_query()).flatten();
        Passes {
            times: Vec::new(),
            timer: query.map(|query| Timer {
                query,
                turn: 0,
                state: Asked::Nothing,
            }),
            done: 0,
            last: 0.0,
        }
    }

    /// Whose clock it is: `gpu`, or `submit`.
    pub fn timer(&self) -> &'static str {
        match self.timer {
            Some(_) => "gpu",
            None => "submit",
        }
    }

    /// What all of them take the graphics card \[ms\]; zero where it does not say.
    pub fn on_card(&self) -> f64 {
        match self.timer {
            Some(_) => self.times.iter().map(|(_, time)| time).sum(),
            None => 0.0,
        }
    }

    /// Frees what asks the graphics card.
    pub fn free(&self, context: &Context) {
        if let Some(timer) = &self.timer {
            context.delete_query(Some(&timer.query));
        }
    }

    /// A picture begins.
    pub fn begin(&mut self, context: &Context, host: &WallClock) {
        self.done = 0;
        self.last = host.now();
        if let Some(timer) = &mut self.timer {
            timer.read(context, &mut self.times);
            timer.begin(context, 0);
        }
    }

    /// A pass was handed over.
    pub fn end(&mut self, context: &Context, host: &WallClock, name: &'static str) {
        let at = self.done;
        self.done += 1;
        if self.times.get(at).is_none_or(|(known, _)| *known != name) {
            // Another model, or another look: from here on there are others.
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

    /// The picture is handed over.
    pub fn finish(&mut self, context: &Context) {
        self.times.truncate(self.done);
        if let Some(timer) = &mut self.timer {
            // The last pass may have gone since it was its turn.
            timer.end(context);
            if timer.turn >= self.done {
                timer.turn = 0;
            }
        }
    }
}

impl Timer {
    fn begin(&mut self, context: &Context, pass: usize) {
        if self.state == Asked::Nothing && pass == self.turn {
            context.begin_query(TIME_ELAPSED, &self.query);
            self.state = Asked::Begun;
        }
    }

    fn end(&mut self, context: &Context) {
        if self.state == Asked::Begun {
            context.end_query(TIME_ELAPSED);
            self.state = Asked::Ended;
        }
    }

    /// Takes in the answer, if it is there.
    fn read(&mut self, context: &Context, times: &mut [(&'static str, f64)]) {
        let ask = |what| context.get_query_parameter(&self.query, what);
        if self.state != Asked::Ended || !ask(Context::QUERY_RESULT_AVAILABLE).is_truthy() {
            return;
        }
        self.state = Asked::Nothing;
        // A clock that was reset meanwhile tells nothing.
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
