//! The engine as JavaScript has it: messages in, messages out, and a frame loop
//! that runs only while a fire has something to do.

use std::cell::RefCell;
use std::rc::{Rc, Weak};

use js_sys::{Function, Reflect};
use wasm_bindgen::JsValue;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::budget::{STEPS_BUDGET_MS, share};
use crate::fire::Fire;
use crate::host::Host;
use crate::message::{Message, Order, Refused, RefusedMessage};
use crate::outbox::{Outbox, Trouble};
use crate::picture::{ContextEvent, Picture};
use crate::raw::Raw;
use crate::wanted::Wanted;

/// Draws any number of fires.
#[wasm_bindgen]
pub struct Engine {
    shared: Rc<RefCell<Fires>>,
    post: Function,
}

#[wasm_bindgen]
impl Engine {
    /// An engine without a fire. It answers through `post(message)`.
    ///
    /// # Errors
    /// The place it runs in has no `requestAnimationFrame` or no `performance`.
    #[wasm_bindgen(constructor)]
    pub fn new(post: Function) -> Result<Engine, js_sys::Error> {
        let host = Host::new().map_err(|words| js_sys::Error::new(&words))?;
        let shared = Rc::new_cyclic(|shared: &Weak<RefCell<Fires>>| {
            let (frames, answer) = (shared.clone(), post.clone());
            let frame = Closure::new(move |now: f64| {
                act(&frames, &answer, |fires, out| fires.frame(now, out));
            });
            RefCell::new(Fires {
                fires: Vec::new(),
                host,
                frame,
                requested: None,
            })
        });
        Ok(Engine { shared, post })
    }

    /// Takes a message. Whatever it is, the answer is a message too.
    pub fn receive(&self, message: &JsValue) {
        let shared = Rc::downgrade(&self.shared);
        let parsed = Message::parse(&Raw::of(message));
        let canvas = Reflect::get(message, &"canvas".into()).unwrap_or(JsValue::UNDEFINED);
        let post = self.post.clone();
        act(
            &shared.clone(),
            &self.post,
            move |fires, out| match parsed {
                Ok(message) => fires.obey(message, canvas, out, move |fire, event| {
                    act(&shared, &post, |fires, out| fires.context(fire, event, out));
                }),
                Err(refused) => out.refused(refused),
            },
        );
    }
}

/// Does something with the fires, asks for the next frame if one is needed, and
/// then, with nothing borrowed any more, posts what there is to say.
fn act(shared: &Weak<RefCell<Fires>>, post: &Function, what: impl FnOnce(&mut Fires, &mut Outbox)) {
    let Some(shared) = shared.upgrade() else {
        return;
    };
    let mut out = Outbox::default();
    if let Ok(mut fires) = shared.try_borrow_mut() {
        what(&mut fires, &mut out);
        fires.schedule();
    }
    out.post(post);
}

/// All fires of an engine, and its frame loop.
struct Fires {
    /// Few, so that looking for one is quick, and a map’s code not worth its size.
    fires: Vec<Fire>,
    host: Host,
    frame: Closure<dyn FnMut(f64)>,
    requested: Option<u32>,
}

impl Fires {
    fn schedule(&mut self) {
        if self.requested.is_none() && self.fires.iter().any(Fire::wants_frame) {
            self.requested = Some(self.host.request_frame(self.frame.as_ref()));
        }
    }

    fn frame(&mut self, now: f64, out: &mut Outbox) {
        self.requested = None;
        let end = self.host.now() + STEPS_BUDGET_MS;
        let fires = self.fires.iter().filter(|f| f.wants_frame()).count();
        let mut left = fires;
        for fire in self.fires.iter_mut().filter(|f| f.wants_frame()) {
            let deadline = share(self.host.now(), end, left);
            left -= 1;
            fire.frame(now, deadline, fires, &self.host, out);
        }
    }

    fn context(&mut self, fire: u32, event: ContextEvent, out: &mut Outbox) {
        if let Some(fire) = self.fires.iter_mut().find(|known| known.id() == fire) {
            fire.context(event, out);
        }
    }

    fn obey(
        &mut self,
        message: Message,
        canvas: JsValue,
        out: &mut Outbox,
        tell: impl Fn(u32, ContextEvent) + Clone + 'static,
    ) {
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
            match Picture::new(canvas, move |event| tell(id, event)) {
                Ok(picture) => {
                    out.ready(id, &wanted);
                    self.fires.push(Fire::new(id, picture, wanted, &start));
                }
                Err(words) => out.error(id, Trouble::Unsupported, &words),
            }
            return out.done(id, request);
        };
        if let Some(wanted) = fire.wanted().after(&order) {
            let anew = matches!(order, Order::Preset(_));
            match wanted {
                Ok(wanted) => fire.want(wanted, &source, anew, out),
                Err(errors) => return out.refused(refuse(errors)),
            }
        }
        match order {
            Order::Add(_) => return out.refused(refuse(vec![Refused::fire(id)])),
            Order::Set(_) | Order::Restore(_) | Order::Preset(_) => {}
            Order::Resize(width, height) => fire.resize(width, height),
            Order::Visible(visible) => fire.set_visible(visible),
            Order::Quality(wish) => fire.ask_quality(wish, out),
            Order::Play => fire.set_playing(true, out),
            Order::Pause => fire.set_playing(false, out),
            Order::Reset => fire.reset(),
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

impl Drop for Fires {
    /// A frame that comes after the end would call what is no longer there.
    fn drop(&mut self) {
        if let Some(handle) = self.requested {
            self.host.cancel_frame(handle);
        }
    }
}
