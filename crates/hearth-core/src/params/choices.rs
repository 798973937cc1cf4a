//! The named choices that parameters of kind *choice* offer.

/// A type whose values are named: the kind *choice* of a parameter.
pub trait Choice: Copy + PartialEq + 'static {
    /// Every name, in the order in which a list shows them.
    const NAMES: &'static [&'static str];
    /// Every value, in the same order.
    const VALUES: &'static [Self];

    /// The name of this value.
    fn name(self) -> &'static str;

    /// The value of that name.
    fn from_name(name: &str) -> Option<Self> {
        Some(*Self::VALUES.get(place(Self::NAMES, name)?)?)
    }
}

// One search for all types: a match of texts in each is a kilobyte.
#[inline(never)]
fn place(names: &[&str], name: &str) -> Option<usize> {
    names.iter().position(|known| *known == name)
}

macro_rules! choices {
    ($(
        $(#[$doc:meta])*
        $type:ident { $( $(#[$variant_doc:meta])* $variant:ident = $name:literal, )+ }
    )+) => { $(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $type { $( $(#[$variant_doc])* $variant, )+ }

        impl $type {
            /// The name of this value.
            pub const fn name(self) -> &'static str {
                <$type as Choice>::NAMES[self as usize]
            }
        }

        impl Choice for $type {
            const NAMES: &'static [&'static str] = &[$($name),+];
            const VALUES: &'static [$type] = &[$($type::$variant),+];
            fn name(self) -> &'static str {
                $type::name(self)
            }
        }
    )+ };
}

choices! {
    /// Which equations move the particles.
    Model {
        /// The paper's: emitted particles live, cool and die, and alone carry the fire.
        Classic = "classic",
        /// Air fills the domain, fuel enters it, mixes and burns.
        Combustion = "combustion",
    }

    /// What happens to a particle at the left, right and lower edge of the
    /// domain. The upper edge is always open.
    Walls {
        /// It leaves and is gone.
        Open = "open",
        /// It stays inside: its velocity into the wall is taken away.
        Solid = "solid",
        /// It comes back in on the other side; the floor is solid.
        Periodic = "periodic",
    }

    /// What is drawn of fire and smoke.
    Layers {
        /// Fire and smoke.
        Both = "both",
        /// The fire alone.
        Fire = "fire",
        /// The smoke alone.
        Smoke = "smoke",
    }

    /// What a picture shows: the fire, or a quantity of its gas by colours that a bar
    /// explains.
    DisplayMode {
        /// Fire: particles melt into fields of temperature that glow as a black body.
        Fire = "fire",
        /// Every particle as a disc, coloured by its temperature.
        Particles = "particles",
        /// Temperature of the gas \[K\].
        Temperature = "temperature",
        /// Density of the gas [kg/m³].
        Density = "density",
        /// Pressure of the gas \[Pa\].
        Pressure = "pressure",
        /// Speed of the gas [m/s].
        Velocity = "velocity",
        /// How fast, and which way, the gas spins [1/s].
        Vorticity = "vorticity",
        /// Fuel in the gas; in the classic model, what is left of a particle's life.
        Fuel = "fuel",
        /// Soot in the gas; in the classic model, what makes smoke of a particle.
        Soot = "soot",
        /// Every particle as a disc, coloured by how many others it feels.
        Neighbours = "neighbours",
        /// The paper's own drawing: hard round sprites, coloured by the
        /// distance from the sprite's centre.
        Paper = "paper",
        /// A soft sprite with a texture of noise for each particle.
        Sprites = "sprites",
    }

    /// What colours the fire has by its temperature.
    Palette {
        /// Those of glowing soot: Planck's law.
        Blackbody = "blackbody",
        /// Those of gas that burns without soot: blue.
        Gas = "gas",
        /// Those of a flame with copper salts: green.
        Copper = "copper",
        /// Those of a flame with lithium salts: crimson.
        Lithium = "lithium",
        /// Those of a ghost: pale, between blue and green.
        Ghost = "ghost",
        /// From the cool colour to the hot one.
        Custom = "custom",
    }

    /// What the fire burns in front of.
    Backdrop {
        /// Nothing: the background, or the page.
        None = "none",
        /// A wall of bricks, which the fire lights.
        Bricks = "bricks",
    }
}

impl Model {
    /// The model that a fire burns by where nobody asks for another.
    pub const DEFAULT: Model = Model::Combustion;
}

impl Default for Model {
    fn default() -> Model {
        Model::DEFAULT
    }
}
