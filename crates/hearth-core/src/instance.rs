//! Particles as the renderer receives them.
//!
//! An [`Instance`] is eight numbers, two texels of a texture: position, velocity,
//! temperature, and the three numbers of one of the types below. Each type converts to an
//! instance and back.

use glam::Vec2;

use crate::params::DisplayMode;

/// The numbers of a particle in the order of the texture.
pub type Instance = [f32; 8];

macro_rules! views {
    ($( $(#[doc = $doc:literal])+ $name:ident {
        $( $(#[doc = $field_doc:literal])+ $a:ident )+
    } )+) => { $(
        $(#[doc = $doc])+
        #[repr(C)]
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name {
            /// Position \[m\].
            pub position: Vec2,
            /// Velocity [m/s].
            pub velocity: Vec2,
            /// Temperature \[K\].
            pub temperature: f32,
            $( $(#[doc = $field_doc])+ pub $a: f32, )+
        }

        impl From<$name> for Instance {
            #[inline]
            fn from(view: $name) -> Instance {
                let ([x, y], [vx, vy]) = (view.position.to_array(), view.velocity.to_array());
                [x, y, vx, vy, view.temperature, $( view.$a ),+]
            }
        }

        impl From<Instance> for $name {
            #[inline]
            fn from([x, y, vx, vy, temperature, $( $a ),+]: Instance) -> $name {
                $name {
                    position: Vec2::new(x, y),
                    velocity: Vec2::new(vx, vy),
                    temperature,
                    $( $a ),+
                }
            }
        }
    )+ };
}

views! {
    /// A particle of the classic model in the display of its fire.
    ClassicParticle {
        /// Density [kg/m³].
        density
        /// Time since birth \[s\].
        age
        /// Remaining share of its life, from 1 to 0.
        life
    }
    /// A particle of the combustion model in the display of its fire.
    GasParticle {
        /// Volume \[m²\].
        volume
        /// Soot, in the amount that a full share of fuel leaves.
        soot
        /// Fuel burnt in a second [1/s].
        burn_rate
    }
    /// An ember.
    EmberParticle {
        /// Diameter \[m\].
        size
        /// Time since birth \[s\].
        age
        /// Remaining share of its life, from 1 to 0.
        life
    }
    /// A particle of either model in every other [`DisplayMode`].
    Measured {
        /// Volume \[m²\].
        volume
        /// Where the display shows sprites, the particle's id modulo 4096; otherwise by how many
        /// radii its kernel is wider, from 0 to 2 where open air ends.
        number
        /// The quantity of the mode; of sprites the remaining life or the soot.
        value
    }
}

/// [`Measured::number`] of a particle with that id.
pub(crate) fn numbered(id: u64, mode: DisplayMode) -> f32 {
    match mode {
        DisplayMode::Sprites => (id % 4096) as f32,
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_view_keeps_its_eight_numbers_in_order() {
        let numbers = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];
        assert_eq!(Instance::from(ClassicParticle::from(numbers)), numbers);
        assert_eq!(Instance::from(GasParticle::from(numbers)), numbers);
        assert_eq!(Instance::from(EmberParticle::from(numbers)), numbers);
        assert_eq!(Instance::from(Measured::from(numbers)), numbers);
        let gas = GasParticle::from(numbers);
        assert_eq!(
            (gas.position, gas.velocity),
            (Vec2::new(1.0, 2.0), Vec2::new(3.0, 4.0))
        );
        assert_eq!(
            [gas.temperature, gas.volume, gas.soot, gas.burn_rate],
            [5.0, 6.0, 7.0, 8.0]
        );
    }

    #[test]
    fn a_view_is_as_large_as_an_instance() {
        assert_eq!(size_of::<Measured>(), size_of::<Instance>());
        assert_eq!(size_of::<GasParticle>(), size_of::<Instance>());
    }
}
