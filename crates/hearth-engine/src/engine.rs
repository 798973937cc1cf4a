//! The engine's interface to JavaScript: calls and frames in, events and pictures out.
//!
//! `web/engine/loop.js` requests frames and listens to the canvas's context. Each method
//! returns whether to request another frame, so no loop runs while no fire has work.

use hearth_bindings::{light, memory, panic, parts, values};
use hearth_core::{SprayError, Vec2};
use hearth_settings::untrusted::{Untrusted, ValidationError};
use hearth_settings::{Change, Settings};
use js_sys::Set;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::WebGl2RenderingContext;

use crate::change;
use crate::commands::Command;
use crate::events::{ErrorKind, Events, Post};
use crate::fire::Fire;
use crate::fire::tick::FrameTime;
use crate::pacing::machine_limit::MachineLimit;
use crate::pacing::thread_budget::{SHARE_OF_PAGE, SHARE_OF_WORKER, ThreadBudget, deadline};
use crate::pointer::PointerForce;
use crate::shared_canvas::{Canvas, SharedCanvas, Show};
use crate::wall_clock::WallClock;

const CONTEXT_LOST: &str = "the graphics context was lost; the fire continues when it is restored";

/// Memory of the past moments of all fires \[bytes\], that of some ten fires of medium quality.
const HISTORY_BYTES: usize = 24 << 20;

/// Draws any number of fires.
#[wasm_bindgen]
pub struct Engine {
    /// A page has few fires, so a linear search is faster than a map. Moving a pointer is faster than moving a fire.
    fires: Vec<Box<Fire>>,
    canvas: SharedCanvas,
    clock: WallClock,
    budget: ThreadBudget,
    /// Whether the thread is the page's own.
    on_page: bool,
    events: Events,
}

/// How a call is answered.
enum Answer {
    /// Now, with `done`.
    Done,
    /// By the command, now or later.
    Deferred,
    /// Not yet: a part is missing, and nothing has changed.
    Missing(&'static str),
}

#[wasm_bindgen]
impl Engine {
    /// Creates an engine without fires that draws on `canvas` in its WebGL2 `context`, if the
    /// browser gives one. It posts events through `post(event)` and pictures through
    /// `show(fire)`, which returns whether the picture is already shown. `on_page`: its thread is
    /// the page's own, so it leaves most of it to the page.
    ///
    /// # Errors
    /// The browser has no WebGL2, or the driver rejects a shader.
    #[wasm_bindgen(constructor)]
    pub fn new(
        post: Post,
        canvas: Canvas,
        context: Option<WebGl2RenderingContext>,
        show: Show,
        on_page: bool,
    ) -> Result<Engine, js_sys::Error> {
        panic::record();
        let canvas = SharedCanvas::new(canvas, context, show)
            .map_err(|message| js_sys::Error::new(&message))?;
        Ok(Engine {
            fires: Vec::new(),
            canvas,
            clock: WallClock,
            budget: ThreadBudget::new(if on_page {
                SHARE_OF_PAGE
            } else {
                SHARE_OF_WORKER
            }),
            on_page,
            events: Events::new(post),
        })
    }

    /// The place and the text of the last panic; empty before the first.
    pub fn panic() -> String {
        panic::last()
    }

    /// Executes a call, `[fire, request, command, …arguments]`, and answers with an event.
    /// Returns whether to request a frame.
    ///
    /// # Errors
    /// The name of a [part](parts) that the call needs and that is not among the `loaded` ones. The
    /// caller repeats the call when the part is loaded.
    pub fn call(&mut self, call: &JsValue, loaded: &Set) -> Result<bool, JsValue> {
        let start = self.clock.now();
        let call = values::copied(call);
        let [fire, request, name, arguments @ ..] = call.list() else {
            return Ok(self.needs_frame());
        };
        let (fire, request) = (fire.number() as u32, request.number() as u32);
        let answer = Command::parse(name, arguments)
            .map_err(|error| vec![error])
            .and_then(|command| self.run(fire, request, command, loaded));
        match answer {
            Ok(Answer::Done) => self.events.done(fire, request),
            Ok(Answer::Deferred) => {}
            Ok(Answer::Missing(part)) => return Err(part.into()),
            Err(errors) => self.events.refused(fire, request, &errors),
        }
        self.budget.spend(self.clock.now() - start);
        Ok(self.needs_frame())
    }

    /// Counts a picture of a fire as shown. Returns whether to request a frame. JavaScript calls
    /// this for each picture, so unlike [`call`](Engine::call) it creates no object.
    pub fn shown(&mut self, fire: u32) -> bool {
        if let Some(fire) = self.fires.iter_mut().find(|known| known.id() == fire) {
            fire.presentation.renderer.shown();
        }
        self.needs_frame()
    }

    /// Processes a frame of the display at `now` \[ms\]. Returns whether to request another.
    pub fn frame(&mut self, now: f64) -> bool {
        let start = self.clock.now();
        let budget = self.budget.refill(start);
        if budget <= 0.0 {
            return self.needs_frame();
        }
        let fires = self.fires.iter().filter(|f| f.needs_frame()).count();
        let mut end = start + budget;
        let mut drawing = 0.0;
        let mut left = fires;
        // The first fire gets most of a frame that is too short for all, so they take turns.
        if fires > 1 {
            let first = self.fires.remove(0);
            self.fires.push(first);
        }
        for fire in self.fires.iter_mut().filter(|f| f.needs_frame()) {
            let deadline = deadline(self.clock.now(), end, left);
            left -= 1;
            if fire.is_due(now) {
                // The time of drawing does not shorten the steps of other fires.
                let time = FrameTime {
                    now,
                    deadline,
                    fires,
                    share: self.budget.share(),
                };
                let drew = fire.frame(time, &self.canvas, &self.clock, &self.events);
                end += drew;
                drawing += drew;
            }
        }
        self.budget.spend(self.clock.now() - start - drawing);
        self.needs_frame()
    }

    /// Handles the loss or the restoration of the context. Returns whether to request a frame.
    pub fn context(&mut self, restored: bool) -> bool {
        let result = if restored {
            self.canvas
                .restore()
                .map_err(|message| (ErrorKind::Unsupported, message))
        } else {
            self.canvas.lose();
            Err((ErrorKind::ContextLost, CONTEXT_LOST.to_owned()))
        };
        let drawable = self.canvas.gpu().is_some();
        for fire in &mut self.fires {
            fire.present(&|presentation| presentation.set_drawable(drawable));
            match &result {
                Ok(()) if drawable => self.events.restored(fire.id()),
                // Lost again meanwhile: the next event reports it.
                Ok(()) => {}
                Err((kind, message)) => self.events.error(fire.id(), *kind, message),
            }
        }
        self.needs_frame()
    }
}

/// Sprays water into a fire.
fn spray(fire: &mut Fire, [x, y, u, v, grams]: [f64; 5]) -> Result<(), Vec<ValidationError>> {
    let pair = |x: f64, y: f64| Vec2::new(x as f32, y as f32);
    let mass = 1e-3 * grams as f32;
    let done = fire.act(|simulation| simulation.spray(pair(x, y), pair(u, v), mass));
    done.map_err(|_| {
        let model = Untrusted::Text("classic".into());
        vec![ValidationError::new("model", &model, SprayError::ALLOWED)]
    })
}

impl Engine {
    /// Shares the memory of past moments among the fires.
    fn share_history(&mut self) {
        let bytes = HISTORY_BYTES / self.fires.len().max(1);
        for fire in &mut self.fires {
            fire.presentation.history.set_limit(bytes);
        }
    }

    fn needs_frame(&self) -> bool {
        self.fires.iter().any(|fire| fire.needs_frame())
    }

    fn run(
        &mut self,
        id: u32,
        request: u32,
        command: Command<'_>,
        loaded: &Set,
    ) -> Result<Answer, Vec<ValidationError>> {
        let events = &self.events;
        let found = self.fires.iter_mut().find(|fire| fire.id() == id);
        let fire = match (found, command) {
            (None, Command::Add { start }) if start.films > 0 => {
                if parts::lacks(loaded, parts::FILMS) {
                    return Ok(Answer::Missing(parts::FILMS));
                }
                let mut fires = self.fires.iter_mut();
                let Some(filmed) = fires.find(|fire| fire.id() == start.films) else {
                    let films = Untrusted::Number(start.films.into());
                    let allowed = "the number of a fire";
                    return Err(vec![ValidationError::new("films", &films, allowed)]);
                };
                let particles = MachineLimit::new(self.on_page).particles();
                memory::reserve(None, &filmed.settings().completed(), particles)
                    .map_err(|error| vec![error])?;
                let copy = filmed.film(id, &start, self.on_page);
                self.fires.push(Box::new(copy));
                return Ok(Answer::Done);
            }
            (None, Command::Add { start }) => {
                if start.children && parts::lacks(loaded, parts::CHILDREN) {
                    return Ok(Answer::Missing(parts::CHILDREN));
                }
                let (settings, errors) = change::at_first(&start);
                if let Some(part) = parts::missing(settings.scene(), loaded) {
                    return Ok(Answer::Missing(part));
                }
                if !errors.is_empty() {
                    events.refused(id, 0, &errors);
                }
                let values = settings.completed();
                if let Err(error) =
                    memory::reserve(None, &values, MachineLimit::new(self.on_page).particles())
                {
                    events.error(id, ErrorKind::Memory, &error.message);
                    return Ok(Answer::Done);
                }
                events.ready(id, &settings);
                let mut fire = Fire::new(id, settings, &start, self.on_page);
                let drawable = self.canvas.gpu().is_some();
                fire.present(&|presentation| presentation.set_drawable(drawable));
                if !drawable {
                    events.error(id, ErrorKind::ContextLost, CONTEXT_LOST);
                }
                self.fires.push(Box::new(fire));
                self.share_history();
                return Ok(Answer::Done);
            }
            (Some(fire), command) if !matches!(command, Command::Add { .. }) => (fire, command),
            _ => {
                let allowed = "the number of a fire, or a new number to add one";
                let id = Untrusted::Number(id.into());
                return Err(vec![ValidationError::new("fire", &id, allowed)]);
            }
        };
        let (fire, command) = fire;
        if matches!(command, Command::Children { .. }) && parts::lacks(loaded, parts::CHILDREN) {
            return Ok(Answer::Missing(parts::CHILDREN));
        }
        let mut errors = Vec::new();
        if let Some((settings, source)) = change::by_command(fire.settings(), &command, &mut errors)
        {
            let settings = settings?;
            if let Some(part) = parts::missing(settings.scene(), loaded) {
                return Ok(Answer::Missing(part));
            }
            let [old, new] = [fire.settings(), &settings].map(Settings::completed);
            memory::reserve(
                Some(&old),
                &new,
                MachineLimit::new(self.on_page).particles(),
            )
            .map_err(|error| vec![error])?;
            let replaced = match command {
                Command::Preset { .. } | Command::Import { .. } => true,
                Command::Restore { .. } => settings.preset().name != fire.settings().preset().name,
                _ => false,
            };
            fire.change(settings, source, replaced, events);
            if let Command::AddObject { .. } = command {
                let added = fire.settings().scene().objects().last();
                let id = added.map_or(0, |object| object.id);
                events.answer(fire.id(), request, &id.into());
                return Ok(Answer::Deferred);
            }
            return match errors.is_empty() {
                true => Ok(Answer::Done),
                false => Err(errors),
            };
        }
        match command {
            Command::CheckValues { values } => {
                fire.settings().after(&Change::Set(values))?;
            }
            Command::Export {} => {
                events.config(id, request, fire.settings());
                return Ok(Answer::Deferred);
            }
            Command::Resize {
                width,
                height,
                side,
            } => fire.resize((width.0, height.0), side),
            Command::Visible { visible } => {
                fire.present(&|presentation| presentation.set_visible(visible))
            }
            Command::LimitFps { fps_limit } => fire.presentation.limit_fps(fps_limit),
            Command::LimitPixels { max_pixels } => fire.presentation.limit_pixels(max_pixels),
            Command::Stir { x, y, u, v } => {
                let pair = |x: f64, y: f64| [x as f32, y as f32];
                fire.playback.pointer = Some(PointerForce::new(pair(x.0, y.0), pair(u.0, v.0)));
            }
            Command::Sparks { x, y, count } => {
                let from = Vec2::new(x.0 as f32, y.0 as f32);
                fire.act(|simulation| simulation.throw_embers(from, count.0));
            }
            Command::Light {
                lit,
                radius,
                place,
                y,
            } => fire
                .act(|simulation| light(simulation, lit, [radius, place, y]))
                .map_err(|error| vec![error])?,
            Command::Spray { x, y, u, v, grams } => {
                if parts::lacks(loaded, parts::BODIES) {
                    return Ok(Answer::Missing(parts::BODIES));
                }
                spray(fire, [x.0, y.0, u.0, v.0, grams.0])?;
            }
            Command::FreeSolids {} => {
                events.numbers(id, request, &fire.simulation.free_solid_numbers());
                return Ok(Answer::Deferred);
            }
            Command::Measure { x, y } => {
                let at = Vec2::new(x.0 as f32, y.0 as f32);
                events.numbers(id, request, &fire.simulation.measure(at));
                return Ok(Answer::Deferred);
            }
            Command::View { fit, x, y } => fire.set_fit(fit.0, [x.0 as f32, y.0 as f32]),
            Command::Zoom { zoom, x, y } => fire
                .presentation
                .set_zoom(zoom.0 as f32, [x.0 as f32, y.0 as f32]),
            Command::Quality { quality } => fire.request_quality(quality.0, events),
            Command::Play {} => fire.set_playing(true, events),
            Command::Pause {} => fire.set_playing(false, events),
            Command::Sound {
                rate,
                roar,
                crackle,
                hiss,
            } => {
                if parts::lacks(loaded, parts::SOUND) {
                    return Ok(Answer::Missing(parts::SOUND));
                }
                fire.set_sound(rate.map(|rate| rate.0), [roar.0, crackle.0, hiss.0]);
            }
            Command::Reset {} => fire.reset(events),
            Command::Warm { seconds } => {
                fire.playback
                    .set_warm_up(seconds.map(|seconds| seconds.0), request);
                return Ok(Answer::Deferred);
            }
            Command::Step { steps } => {
                fire.playback.requests.add(steps.0, 0.0, request);
                return Ok(Answer::Deferred);
            }
            Command::Advance { seconds } => {
                fire.playback.requests.add(0, seconds.0, request);
                return Ok(Answer::Deferred);
            }
            Command::Remove {} => {
                let filmed = fire.films();
                self.fires.retain(|fire| fire.id() != id);
                if let Some(fire) = self.fires.iter_mut().find(|fire| Some(fire.id()) == filmed) {
                    fire.go_on();
                }
                self.share_history();
            }
            // Executed above.
            Command::Add { .. }
            | Command::Set { .. }
            | Command::AddObject { .. }
            | Command::ChangeObject { .. }
            | Command::RemoveObject { .. }
            | Command::Children { .. }
            | Command::Preset { .. }
            | Command::Import { .. }
            | Command::Restore { .. } => {}
        }
        Ok(Answer::Done)
    }
}
