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
        Some(*Self::VALUES.get(index_of(Self::NAMES, name)?)?)
    }
}

fn index_of(names: &[&str], name: &str) -> Option<usize> {
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
    /// The equations that move the particles.
    Model {
        /// The paper's: emitted particles live, cool and die; they alone are the fire.
        Classic = "classic",
        /// Air fills the domain, fuel enters it, mixes and burns.
        Combustion = "combustion",
    }

    /// The boundary condition at the left, right and lower edge of the domain. The upper edge is
    /// always open.
    Walls {
        /// Particles leave and are removed.
        Open = "open",
        /// Particles stay inside: the velocity into the wall becomes 0.
        Solid = "solid",
        /// Particles re-enter on the other side; the floor is solid.
        Periodic = "periodic",
    }

    /// The boundary condition of the combustion model's air.
    Edges {
        /// Air without a box: gas leaves, and fresh air enters.
        Open = "open",
        /// A closed box whose opposite edges are identified.
        Periodic = "periodic",
    }

    /// What is below the air of the combustion model.
    Floor {
        /// Air.
        None = "none",
        /// A solid floor at the lower edge of the domain.
        Solid = "solid",
    }

    /// The shape of a source.
    SourceShape {
        /// A straight line.
        Line = "line",
        /// The surface of a solid.
        Solid = "solid",
    }

    /// The shape of a solid.
    Shape {
        /// A disc.
        Circle = "circle",
        /// A rectangle, with round corners if it has a corner radius.
        Box = "box",
        /// A line with round ends.
        Line = "line",
        /// A closed outline of straight lines.
        Polygon = "polygon",
        /// A line through points, with a thickness and round ends.
        Stroke = "stroke",
        /// What is opaque in a picture.
        Mask = "mask",
    }

    /// The material of a solid, which decides its picture.
    Material {
        /// Stone.
        Stone = "stone",
        /// Wood.
        Wood = "wood",
        /// Iron.
        Iron = "iron",
        /// Bricks.
        Brick = "brick",
        /// Coal.
        Coal = "coal",
        /// Wax.
        Wax = "wax",
        /// Glass.
        Glass = "glass",
        /// Cloth: a sheet in folds, or a twisted rope.
        Cloth = "cloth",
        /// Nothing: the solid is invisible.
        None = "none",
    }

    /// The place of a solid in the depth of the fire.
    Plane {
        /// Behind the fire, which it does not touch.
        Behind = "behind",
        /// Within the fire, which flows around it.
        Within = "within",
        /// Before the fire, which it hides and does not touch.
        Before = "before",
    }

    /// The thermal boundary condition at a solid.
    Thermal {
        /// No heat passes.
        Adiabatic = "adiabatic",
        /// The surface keeps a temperature.
        Fixed = "fixed",
        /// The gas and radiation heat and cool the solid.
        Conducting = "conducting",
    }

    /// The fuel of a solid.
    Fuel {
        /// None: it does not burn.
        None = "none",
        /// Wood.
        Wood = "wood",
        /// Paper.
        Paper = "paper",
        /// Coal.
        Coal = "coal",
        /// Wax.
        Wax = "wax",
        /// Cloth of cotton.
        Cloth = "cloth",
    }

    /// The motion of a solid by itself.
    Motion {
        /// None.
        Still = "still",
        /// To and fro along a line, as a sine of the time.
        Sway = "sway",
        /// Around its place, at a constant rate.
        Spin = "spin",
        /// By gravity, other solids and the gas.
        Free = "free",
    }

    /// The visible layers.
    Layers {
        /// Fire and smoke.
        Both = "both",
        /// The fire alone.
        Fire = "fire",
        /// The smoke alone.
        Smoke = "smoke",
    }

    /// The displayed quantity: the fire, or a quantity of its gas with a colour bar.
    DisplayMode {
        /// Fire: fields of temperature that glow as a black body.
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
        /// Vorticity of the gas [1/s].
        Vorticity = "vorticity",
        /// Distance of the gas from the nearest solid or floor \[m\].
        Distance = "distance",
        /// Fuel in the gas; in the classic model, the remaining life of a particle.
        Fuel = "fuel",
        /// Soot in the gas; in the classic model, the smoke of a particle.
        Soot = "soot",
        /// Every particle as a disc, coloured by its number of neighbours.
        Neighbours = "neighbours",
        /// The paper's sprites: hard and round, coloured by the distance from the centre.
        Paper = "paper",
        /// A soft sprite with a texture of noise for each particle.
        Sprites = "sprites",
    }

    /// The colours of the fire by temperature.
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

    /// The surface behind the fire.
    Backdrop {
        /// Nothing: the background, or the page.
        None = "none",
        /// A wall of bricks, which the fire lights.
        Bricks = "bricks",
    }

    /// The ground under the fire.
    Ground {
        /// Nothing; the floor of a wall is of stone.
        None = "none",
        /// Flat stones.
        Stone = "stone",
        /// Bare earth.
        Earth = "earth",
        /// Sand.
        Sand = "sand",
        /// Snow.
        Snow = "snow",
    }
}

impl Model {
    /// The model of a new fire.
    pub const DEFAULT: Model = Model::Combustion;
}

impl Default for Model {
    fn default() -> Model {
        Model::DEFAULT
    }
}
