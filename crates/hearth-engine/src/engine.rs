//! The engine as JavaScript has it: messages and frames in, messages and pictures
//! out.
//!
//! Its surroundings (`web/engine/loop.js`) ask for the browser's frames and hear
//! of its context; each call here says whether another frame is wanted, so no loop
//! runs while no fire has anything to do.

use js_sys::Function;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::WebGl2RenderingContext;

use crate::budget::{STEPS_BUDGET_MS, share};
use crate::fire::Fire;
use crate::host::Host;
use crate::message::{Message, Order, Refused, RefusedMessage};
use crate::outbox::{Outbox, Trouble};
use crate::raw::Raw;
use crate::scene;
use crate::shared_canvas::{Canvas, SharedCanvas, Show};
use crate::wanted::Wanted;

/// Draws any number of fires.
#[wasm_bindgen]
pub struct Engine {
    /// Few, so that looking for one is quick, and a map’s code not worth its size.
    fires: Vec<Fire>,
    canvas: SharedCanvas,
    host: Host,
    post: Function,
}

#[wasm_bindgen]
impl Engine {
    /// An engine without a fire, which draws on `canvas` in its WebGL2 `context`, where
    /// the browser gives one. It answers through
    /// `post(message)` and shows what it drew through `show(fire)`, which says whether
    /// the picture is shown already.
    ///
    /// # Errors
    /// There is no WebGL2, or the driver refuses.
    #[wasm_bindgen(constructor)]
    pub fn new(
        post: Function,
        canvas: Canvas,
        context: Option<WebGl2RenderingContext>,
        show: Show,
    ) -> Result<Engine, js_sys::Error> {
        let canvas =
            SharedCanvas::new(canvas, context, show).map_err(|words| js_sys::Error::new(&words))?;
        Ok(Engine {
            fires: Vec::new(),
            canvas,
            host: Host,
            post,
        })
    }

    /// Takes a message. Whatever it is, the answer is a message too. Returns
    /// whether a frame is wanted.
    pub fn receive(&mut self, message: &JsValue) -> bool {
        let mut out = Outbox::default();
        match Message::parse(&Raw::of(message)) {
            Ok(message) => self.obey(message, &mut out),
            Err(refused) => out.refused(refused),
        }
        self.end(out)
    }

    /// A picture of that fire that was on its way is shown. Returns whether a frame is
    /// wanted. It comes for each picture, and so is no message to be taken apart.
    pub fn shown(&mut self, fire: u32) -> bool {
        if let Some(fire) = self.fires.iter_mut().find(|known| known.id() == fire) {
            fire.shown();
        }
        self.fires.iter().any(Fire::wants_frame)
    }

    /// A frame of the display, at `now` \[ms\]. Returns whether another one is
    /// wanted.
    pub fn frame(&mut self, now: f64) -> bool {
        let mut out = Outbox::default();
        let fires = self.fires.iter().filter(|f| f.wants_frame()).count();
        let mut end = self.host.now() + STEPS_BUDGET_MS;
        let mut left = fires;
        // Who is first gets most of a frame that is too short for all.
        if fires > 1 {
            self.fires.rotate_left(1);
        }
        for fire in self.fires.iter_mut().filter(|f| f.wants_frame()) {
            let deadline = share(self.host.now(), end, left);
            left -= 1;
            if fire.is_due(now) {
                // Drawing takes nothing from the steps of others.
                end += fire.frame(now, deadline, fires, &self.canvas, &self.host, &mut out);
            }
        }
        self.end(out)
    }

    /// The canvas's context is lost, or back. Returns whether a frame is wanted.
    pub fn context(&mut self, back: bool) -> bool {
        let mut out = Outbox::default();
        let trouble = if back {
            self.canvas
                .restore()
                .map_err(|why| (Trouble::Unsupported, why))
        } else {
            self.canvas.lose();
            let words = "the graphics context was lost; the fire goes on when it is back";
            Err((Trouble::ContextLost, words.to_owned()))
        };
        let drawable = self.canvas.gpu().is_some();
        for fire in &mut self.fires {
            fire.set_drawable(drawable);
            match &trouble {
                Ok(()) if drawable => out.restored(fire.id()),
                // Lost again in the same moment, of which the next event tells.
                Ok(()) => {}
                Err((trouble, words)) => out.error(fire.id(), *trouble, words),
            }
        }
        self.end(out)
    }
}

impl Engine {
    /// Posts what there is to say; whether a frame is wanted.
    fn end(&self, out: Outbox) -> bool {
        out.post(&self.post);
        self.fires.iter().any(Fire::wants_frame)
    }

    fn obey(&mut self, message: Message, out: &mut Outbox) {
        let Message {
            fire: id,
            request,
            source,
            order,
        } = message;
        let refuse = |errors| RefusedMessage {
            fire: Some(id),
            request,
            source: source.clone(),
            errors,
        };
        let Some(fire) = self.fires.iter_mut().find(|fire| fire.id() == id) else {
            let Order::Add(start) = order else {
                return out.refused(refuse(vec![Refused::fire(id)]));
            };
            let (wanted, errors) = Wanted::at_first(&start);
            if !errors.is_empty() {
                out.refused(refuse(errors));
            }
            out.ready(id, &wanted);
            let mut fire = Fire::new(id, wanted, start);
            fire.set_drawable(self.canvas.gpu().is_some());
            self.fires.push(fire);
            return out.done(id, request);
        };
        if let Some(wanted) = fire.wanted().after(&order) {
            let anew = matches!(order, Order::Preset(_) | Order::Import(_));
            match wanted {
                Ok(wanted) => fire.want(wanted, &source, anew, out),
                Err(errors) => return out.refused(refuse(errors)),
            }
        }
        match order {
            Order::Add(_) => return out.refused(refuse(vec![Refused::fire(id)])),
            Order::Set(_) | Order::Restore(_) | Order::Preset(_) | Order::Import(_) => {}
            Order::ChangeObject(..) | Order::RemoveObject(_) => {}
            Order::AddObject(_) => {
                let id = fire
                    .wanted()
                    .scene
                    .objects()
                    .last()
                    .map_or(0, |last| last.0);
                return out.answer(fire.id(), request, &id.into());
            }
            Order::Check(values) => {
                if let Err(errors) = scene::set(&mut fire.wanted().scene.clone(), &values) {
                    return out.refused(refuse(errors));
                }
            }
            Order::Export => return out.config(id, request, fire.wanted()),
            Order::Resize(width, height, side) => fire.resize((width, height), side),
            Order::Visible(visible) => fire.set_visible(visible),
            Order::Limit(limit) => fire.limit(limit),
            Order::Stir(stir) => fire.stir(stir),
            Order::Sparks(sparks) => fire.throw(sparks),
            Order::View(camera) => fire.look(camera),
            Order::Quality(wish) => fire.ask_quality(wish, out),
            Order::Play => fire.set_playing(true, out),
            Order::Pause => fire.set_playing(false, out),
            Order::Reset => fire.reset(out),
            Order::Warm(seconds) => return fire.warm(seconds, request),
            Order::Step(steps) => return fire.ask_steps(steps, 0.0, request),
            Order::Burn(seconds) => return fire.ask_steps(0, seconds, request),
            Order::Remove => {
                self.fires.retain(|fire| fire.id() != id);
                return out.done(id, request);
            }
        }
        out.done(id, request);
    }
}
