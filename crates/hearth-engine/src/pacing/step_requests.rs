//! Step requests: steps that a script requests besides those that are due by the clock.

/// A request for a number of steps, or for steps of a total length.
pub struct StepRequest {
    request: u32,
    steps: u32,
    /// Length that is left [s of fire].
    seconds: f64,
    /// The age of the fire at which nothing is left \[s\]; infinite before the first step.
    end: f64,
}

impl StepRequest {
    fn is_open(&self) -> bool {
        self.steps > 0 || self.seconds > 0.0
    }

    /// The age at which the last of its steps ends, of a fire of that `age` \[s\].
    pub fn end(&mut self, age: f64) -> f64 {
        // A fire that has started again makes what is left.
        if self.seconds > 0.0 && self.end - age > self.seconds {
            self.end = age + self.seconds;
        }
        self.end
    }

    /// Counts a step after which the fire has that `age` \[s\].
    pub fn take(&mut self, age: f64) {
        self.steps = self.steps.saturating_sub(1);
        if self.seconds > 0.0 {
            self.seconds = self.end - age;
        }
    }
}

/// The step requests of a fire, oldest first.
#[derive(Default)]
pub struct StepRequests {
    open: Vec<StepRequest>,
    /// Numbers of the requests whose steps are made and not drawn yet.
    made: Vec<u32>,
}

impl StepRequests {
    /// Adds a request, which is answered when its steps are made and drawn.
    pub fn add(&mut self, steps: u32, seconds: f64, request: u32) {
        self.open.push(StepRequest {
            request,
            steps,
            seconds,
            end: f64::INFINITY,
        });
    }

    /// Whether no requested step remains to be made. Some may still have to be drawn.
    pub fn is_empty(&self) -> bool {
        self.open.is_empty()
    }

    /// Whether steps are made and not drawn yet.
    pub fn awaits_drawing(&self) -> bool {
        !self.made.is_empty()
    }

    /// The request that the next step counts for.
    pub fn next_open(&mut self) -> Option<&mut StepRequest> {
        self.open.iter_mut().find(|request| request.is_open())
    }

    /// Closes the requests whose steps are made.
    pub fn close(&mut self) {
        while self.open.first().is_some_and(|first| !first.is_open()) {
            self.made.push(self.open.remove(0).request);
        }
    }

    /// Takes the numbers of the requests to answer now.
    pub fn answers(&mut self) -> Vec<u32> {
        std::mem::take(&mut self.made)
    }
}
