//! Steps of a fire that somebody asked for, apart from those that time brings.

/// So many steps, or as many as so much fire needs.
pub struct Order {
    request: Option<f64>,
    steps: u32,
    seconds: f64,
}

impl Order {
    fn is_open(&self) -> bool {
        self.steps > 0 || self.seconds > 0.0
    }

    /// A step of `length` seconds was made for it.
    pub fn take(&mut self, length: f64) {
        self.steps = self.steps.saturating_sub(1);
        self.seconds -= length;
    }
}

/// All that is asked of a fire: first come, first served.
#[derive(Default)]
pub struct Asked {
    orders: Vec<Order>,
    /// Requests whose steps are made and not drawn yet.
    made: Vec<Option<f64>>,
}

impl Asked {
    /// One more: `request` is to be answered when its steps are made and drawn.
    pub fn add(&mut self, steps: u32, seconds: f64, request: Option<f64>) {
        self.orders.push(Order {
            request,
            steps,
            seconds,
        });
    }

    /// Whether nothing is to be made, of which more may wait to be drawn.
    pub fn is_empty(&self) -> bool {
        self.orders.is_empty()
    }

    /// Whether something is made and waits to be drawn.
    pub fn waits(&self) -> bool {
        !self.made.is_empty()
    }

    /// What the next step is for.
    pub fn next_open(&mut self) -> Option<&mut Order> {
        self.orders.iter_mut().find(|order| order.is_open())
    }

    /// Takes away those whose steps are made: they are answered when these are drawn.
    pub fn take_made(&mut self) {
        let open = self.orders.iter().position(Order::is_open);
        let made = self.orders.drain(..open.unwrap_or(self.orders.len()));
        self.made.extend(made.map(|order| order.request));
    }

    /// The requests that are answered now.
    pub fn answers(&mut self) -> impl Iterator<Item = Option<f64>> {
        self.made.drain(..)
    }
}
