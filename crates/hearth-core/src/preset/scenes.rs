// Generated from the files of scenes/ by `cargo xtask codegen`; edit those instead.

use super::definition::{Caption, Preset};

/// Every preset: the default one, then those of each model by their names.
pub static PRESETS: &[Preset] = &[
    Preset {
        name: "default",
        text: "",
    },
    Preset {
        name: "bonfire-in-wind",
        text: "fuel_power 500\n\
            source_width 0.7\n\
            turbulence 2\n\
            wind 1\n\
            exposure 0.3\n\
            ember_rate 150\n\
            ground sand\n\
            source_height 0.22\n\
            emission_speed 0.5\n\
            emission_noise 0.5\n\
            source_oxygen 0.5\n\
            turbulence_scale 0.3\n\
            ember_life_max 3\n\
            domain_width 2.8\n\
            domain_height 2\n\
            spacing 0.037417\n\
            max_particles 8000\n\
            \n\
            kind solid\n\
            shape line\n\
            x -0.14\n\
            y 0.17\n\
            angle 16\n\
            width 0.8\n\
            height 0.11\n\
            material wood\n\
            \n\
            x 0.16\n\
            y 0.16\n\
            angle -19\n\
            width 0.76\n\
            height 0.1\n\
            \n\
            x 0\n\
            y 0.1\n\
            angle 2\n\
            width 0.8\n\
            height 0.11\n\
            \n\
            shape box\n\
            x -0.72\n\
            y 0.07\n\
            angle 8\n\
            width 0.2\n\
            height 0.14\n\
            corner 0.06\n\
            material stone\n\
            \n\
            x 0.72\n\
            angle -9\n\
            width 0.19",
    },
    Preset {
        name: "burning-logs",
        text: "fuel_power 60\n\
            source_width 0.2\n\
            turbulence 0.5\n\
            exposure 0.6\n\
            bloom 0.2\n\
            smoke_opacity 0.4\n\
            ember_rate 60\n\
            ground earth\n\
            source_height 0.03\n\
            emission_speed 0.3\n\
            emission_noise 0.6\n\
            soot_life 0.35\n\
            source_oxygen 0.5\n\
            detail 1.4\n\
            turbulence_scale 0.25\n\
            ember_life_max 3\n\
            domain_width 1.6\n\
            domain_height 1.7\n\
            spacing 0.03\n\
            max_particles 6200\n\
            \n\
            kind solid\n\
            shape circle\n\
            x -0.16\n\
            y 0.07\n\
            width 0.14\n\
            material wood\n\
            fuel wood\n\
            load 12\n\
            moisture 4\n\
            \n\
            x 0.16\n\
            y 0.065\n\
            width 0.13\n\
            \n\
            x -0.33\n\
            y 0.05\n\
            width 0.1\n\
            \n\
            x 0.33\n\
            y 0.055\n\
            width 0.11\n\
            \n\
            x -0.21\n\
            y 0.215\n\
            \n\
            x 0.005\n\
            y 0.22\n\
            width 0.12\n\
            \n\
            x 0.21\n\
            y 0.2\n\
            width 0.1",
    },
    Preset {
        name: "burning-word",
        text: "fuel_power 600\n\
            exposure 0.4\n\
            smoke_opacity 0.2\n\
            ember_rate 120\n\
            ground stone\n\
            time_scale 0.8\n\
            source_shape solid\n\
            source_solid 2\n\
            emission_noise 0.6\n\
            burn_time 0.06\n\
            soot_life 0.8\n\
            radiative_cooling 250\n\
            source_oxygen 0.6\n\
            source_temperature 900\n\
            domain_width 1.26\n\
            domain_height 1.05\n\
            spacing 0.0182\n\
            max_particles 9000\n\
            \n\
            kind solid\n\
            shape mask\n\
            x 0\n\
            y 0.231\n\
            width 1.008\n\
            height 0.291\n\
            mask 128x37:jB3xLSO2BAF3ONMKIGDbB3yFUB3xLSO2BAF3tOKDYB3yFVBDEGM3sLSBDEGLtLGEDBRBDFGOtMLLLMwJBXBDEGM3tFZKtHaHoLWItJZNtETCFLtMBaKtHbLoFZKtHaFoLWItJZNtEWEtLaKtHbJoFZKtHaDoLWItJZNtEXHtGZKtHbHoFZKtHaBoLWItJZNtEXBtNZKtHbFoFZKtHbOPLWItJZNtEYMtCYKtHbDoFZKtHbMPLWItJZNtEYLtEYKtHcoFZKtHbFHGWItJZNtEYKtFYKtHfZKtHfVItJZNtEYLtFYKtHfZKtHfVItJZNtEYLtDYKtHfZKtHfVItJZNtEYOtBYKtHXLPJeKtHWGobItJZNtEXCtLZKtHXoJeKtHWIobItJZNtEXJtFZKtHWDoJeKtHWLobItJZNtEWGtMaKtHWGoJeKtHWOobItJZNtETCEKtOCaK3oJeKtNLLLLLLLLpbItJZNtMLLLMOvMCbK3oJeK3obItJZN3pMFdK3oJeK3obItJZN3oKfKtHWGoJeKtHWpbItJZNtERDuEeKtHWCoJeKtHWMobItJZNtESItNBdKtHXOPJeKtHWKobItJZNtETMtLdKtHXILHeKtHWHobItJZNtETDuGcKtHfZKtHWELLbItJZNtEUJtOCbKtHfZKtHfVItJZNtEUBNtMbKtHeKLGXKtHfVItJZNtEVEuIaKtHdBoHXKtHfVItJZNtEWKuEZKtHdFoGXKtHfVItJZNtEWBOtNBYKtHdIoFXKtHfVItJZNtEXFuKYKtHdLoFXKtHfVItJZNtEYLuGXKtHdpEXKtHfVItJZNtEYCOtOCWKtHcFpDVDFMtKFECfBDEGLtLGEDBRBEHJuLIGDWGuNIGDABDEGM3vDTJ2MDcO2BQ2KWMxG30CTL3DcO2BQ2KWDxG30BS\n\
            material coal\n\
            front true\n\
            thermal conducting\n\
            temperature 800\n\
            heat_capacity 400",
    },
    Preset {
        name: "campfire",
        text: "fuel_power 300\n\
            source_width 0.5\n\
            turbulence 0.8\n\
            exposure 0.5\n\
            bloom 0.2\n\
            smoke_opacity 0.4\n\
            ember_rate 110\n\
            ground earth\n\
            source_height 0.2\n\
            emission_speed 0.6\n\
            emission_noise 0.6\n\
            soot_life 0.35\n\
            source_oxygen 0.5\n\
            detail 1.4\n\
            turbulence_scale 0.25\n\
            ember_life_max 3\n\
            domain_width 1.8\n\
            domain_height 1.8\n\
            spacing 0.032863\n\
            \n\
            kind solid\n\
            shape line\n\
            x -0.1\n\
            y 0.155\n\
            angle 15\n\
            width 0.5\n\
            height 0.075\n\
            material wood\n\
            \n\
            x 0.12\n\
            y 0.145\n\
            angle -18\n\
            width 0.48\n\
            height 0.07\n\
            \n\
            x 0.02\n\
            y 0.105\n\
            angle 3\n\
            width 0.46\n\
            height 0.08\n\
            \n\
            shape box\n\
            x -0.46\n\
            y 0.085\n\
            angle 8\n\
            width 0.17\n\
            height 0.12\n\
            corner 0.05\n\
            material stone\n\
            \n\
            x 0.48\n\
            angle -12\n\
            width 0.15\n\
            corner 0.055\n\
            \n\
            x -0.62\n\
            y 0.07\n\
            angle -5\n\
            width 0.13\n\
            height 0.09\n\
            corner 0.04",
    },
    Preset {
        name: "candle",
        text: "fuel_power 24\n\
            source_width 0.08\n\
            exposure 1\n\
            smoke_opacity 0.1\n\
            ember_rate 0\n\
            time_scale 0.5\n\
            source_height 0.11\n\
            emission_speed 0.15\n\
            emission_noise 0\n\
            soot_life 0.6\n\
            radiative_cooling 700\n\
            source_oxygen 0.5\n\
            detail 0.2\n\
            domain_width 0.42\n\
            domain_height 0.5\n\
            spacing 0.0083666\n\
            kinematic_viscosity 0.01\n\
            eddy_viscosity 0.3\n\
            diffusion 0.001\n\
            \n\
            kind solid\n\
            shape box\n\
            x 0\n\
            y 0.048\n\
            width 0.07\n\
            height 0.104\n\
            corner 0.012\n\
            material wax\n\
            \n\
            kind solid\n\
            shape line\n\
            x 0\n\
            y 0.106\n\
            angle 90\n\
            width 0.016\n\
            height 0.005\n\
            material coal",
    },
    Preset {
        name: "curtains",
        text: "fuel_power 55\n\
            source_width 0.05\n\
            wind 0.4\n\
            exposure 0.5\n\
            backdrop bricks\n\
            ground stone\n\
            time_scale 0.6\n\
            source_height 0.32\n\
            emission_speed 0.3\n\
            domain_width 1.3\n\
            domain_height 1.3\n\
            floor solid\n\
            spacing 0.026\n\
            max_particles 5000\n\
            \n\
            kind solid\n\
            shape box\n\
            x -0.104\n\
            y 1.053\n\
            width 0.068\n\
            height 0.27\n\
            material wax\n\
            fuel cloth\n\
            load 0.9\n\
            motion free\n\
            density 60\n\
            hangs_from 26\n\
            \n\
            y 0.783\n\
            hangs_from 2\n\
            \n\
            y 0.513\n\
            hangs_from 3\n\
            \n\
            x -0.194\n\
            y 1.053\n\
            hangs_from 26\n\
            \n\
            y 0.783\n\
            hangs_from 5\n\
            \n\
            y 0.513\n\
            hangs_from 6\n\
            \n\
            x -0.284\n\
            y 1.053\n\
            hangs_from 26\n\
            \n\
            y 0.783\n\
            hangs_from 8\n\
            \n\
            y 0.513\n\
            hangs_from 9\n\
            \n\
            x -0.374\n\
            y 1.053\n\
            hangs_from 26\n\
            \n\
            y 0.783\n\
            hangs_from 11\n\
            \n\
            y 0.513\n\
            hangs_from 12\n\
            \n\
            x 0.104\n\
            y 1.053\n\
            hangs_from 26\n\
            \n\
            y 0.783\n\
            hangs_from 14\n\
            \n\
            y 0.513\n\
            hangs_from 15\n\
            \n\
            x 0.194\n\
            y 1.053\n\
            hangs_from 26\n\
            \n\
            y 0.783\n\
            hangs_from 17\n\
            \n\
            y 0.513\n\
            hangs_from 18\n\
            \n\
            x 0.284\n\
            y 1.053\n\
            hangs_from 26\n\
            \n\
            y 0.783\n\
            hangs_from 20\n\
            \n\
            y 0.513\n\
            hangs_from 21\n\
            \n\
            x 0.374\n\
            y 1.053\n\
            hangs_from 26\n\
            \n\
            y 0.783\n\
            hangs_from 23\n\
            \n\
            y 0.513\n\
            hangs_from 24\n\
            \n\
            kind solid\n\
            shape line\n\
            y 1.2\n\
            width 1.06\n\
            height 0.03\n\
            material iron\n\
            \n\
            shape box\n\
            x 0\n\
            y 0.23\n\
            width 0.05\n\
            height 0.13\n\
            corner 0.01\n\
            material wax\n\
            \n\
            kind solid\n\
            shape box\n\
            y 0.145\n\
            width 0.6\n\
            height 0.04\n\
            material wood",
    },
    Preset {
        name: "fireplace",
        text: "fuel_power 200\n\
            source_width 0.5\n\
            turbulence 0.6\n\
            exposure 1.2\n\
            smoke_opacity 0.35\n\
            ember_rate 60\n\
            backdrop bricks\n\
            source_height 0.21\n\
            emission_speed 0.6\n\
            emission_noise 0.6\n\
            source_oxygen 0.6\n\
            detail 1.4\n\
            domain_width 2\n\
            domain_height 1.6\n\
            spacing 0.0323\n\
            max_particles 7000\n\
            \n\
            kind solid\n\
            shape box\n\
            x -0.78\n\
            y 0.53\n\
            width 0.36\n\
            height 0.94\n\
            material brick\n\
            \n\
            x 0.78\n\
            \n\
            x -0.58\n\
            y 1.4\n\
            width 0.84\n\
            height 0.8\n\
            \n\
            x 0.58\n\
            \n\
            x -0.6\n\
            y 1.03\n\
            width 0.8\n\
            height 0.09\n\
            corner 0.02\n\
            material stone\n\
            \n\
            x 0.6\n\
            \n\
            kind solid\n\
            shape line\n\
            y 0.06\n\
            width 0.7\n\
            height 0.025\n\
            material iron\n\
            \n\
            x -0.28\n\
            y 0.03\n\
            angle 90\n\
            width 0.05\n\
            \n\
            x 0.28\n\
            \n\
            x -0.36\n\
            y 0.12\n\
            angle 100\n\
            width 0.12\n\
            \n\
            x 0.36\n\
            angle 80\n\
            \n\
            x -0.03\n\
            angle 3\n\
            width 0.48\n\
            height 0.09\n\
            material wood\n\
            \n\
            x 0.04\n\
            y 0.19\n\
            angle -8\n\
            width 0.4\n\
            height 0.07",
    },
    Preset {
        name: "fireside",
        text: "fuel_power 300\n\
            source_width 0.44\n\
            turbulence 0.8\n\
            exposure 1.75\n\
            bloom 0.2\n\
            smoke_opacity 0.4\n\
            ember_rate 110\n\
            backdrop bricks\n\
            source_height 0.03\n\
            emission_speed 0.6\n\
            emission_noise 0.6\n\
            soot_life 0.5\n\
            source_oxygen 0.5\n\
            detail 1.4\n\
            turbulence_scale 0.25\n\
            ember_life_max 3\n\
            domain_width 1.6\n\
            domain_height 1.6\n\
            spacing 0.035777\n\
            max_particles 4000\n\
            \n\
            kind solid\n\
            shape line\n\
            x -0.09\n\
            y 0.065\n\
            angle 14\n\
            width 0.44\n\
            height 0.07\n\
            material wood\n\
            \n\
            x 0.1\n\
            y 0.06\n\
            angle -16\n\
            width 0.42\n\
            height 0.065\n\
            \n\
            shape box\n\
            x -0.4\n\
            y 0.055\n\
            angle 8\n\
            width 0.15\n\
            height 0.11\n\
            corner 0.05\n\
            material stone\n\
            \n\
            x 0.42\n\
            angle -12\n\
            width 0.14",
    },
    Preset {
        name: "forge",
        text: "fuel_power 200\n\
            source_width 1\n\
            exposure 1.8\n\
            bloom 0.4\n\
            smoke_opacity 0.1\n\
            ember_rate 400\n\
            backdrop bricks\n\
            source_height 0.18\n\
            emission_speed 0.1\n\
            emission_noise 0.8\n\
            flame_rise 1700\n\
            burn_time 0.05\n\
            soot_life 0.8\n\
            source_oxygen 0.9\n\
            buoyancy 0.5\n\
            ember_size 0.0035\n\
            ember_life_max 1\n\
            domain_width 2.8\n\
            domain_height 1.15\n\
            spacing 0.032762\n\
            gas_expansion 0.5\n\
            \n\
            kind solid\n\
            shape box\n\
            x 0\n\
            y 0.025\n\
            width 1.6\n\
            height 0.13\n\
            material brick\n\
            \n\
            kind solid\n\
            shape circle\n\
            x -0.5\n\
            y 0.14\n\
            width 0.13\n\
            material coal\n\
            \n\
            x -0.36\n\
            y 0.15200000000000002\n\
            width 0.16\n\
            \n\
            x -0.22\n\
            y 0.164\n\
            width 0.14500000000000002\n\
            \n\
            x -0.08\n\
            y 0.14\n\
            width 0.13\n\
            \n\
            x 0.06\n\
            y 0.15200000000000002\n\
            width 0.16\n\
            \n\
            x 0.2\n\
            y 0.164\n\
            width 0.14500000000000002\n\
            \n\
            x 0.34\n\
            y 0.14\n\
            width 0.13\n\
            \n\
            x 0.48\n\
            y 0.15200000000000002\n\
            width 0.16\n\
            \n\
            shape line\n\
            x 0.78\n\
            y 0.27\n\
            angle 14\n\
            width 0.8\n\
            height 0.035\n\
            material iron",
    },
    Preset {
        name: "gas-burner",
        text: "fuel_power 22\n\
            source_width 0.12\n\
            palette gas\n\
            exposure 3.8\n\
            bloom 0.3\n\
            smoke_opacity 0\n\
            ember_rate 0\n\
            time_scale 0.5\n\
            source_height 0.11\n\
            emission_speed 0.6\n\
            emission_noise 0\n\
            flame_rise 1700\n\
            burn_time 0.03\n\
            soot_life 0.1\n\
            radiative_cooling 2000\n\
            source_oxygen 0.75\n\
            detail 0.3\n\
            luminance_exponent 0.2\n\
            domain_width 0.44\n\
            domain_height 0.5\n\
            spacing 0.0085635\n\
            kinematic_viscosity 0.005\n\
            diffusion 0.001\n\
            \n\
            kind solid\n\
            shape box\n\
            x 0\n\
            y 0.098\n\
            width 0.15\n\
            height 0.026\n\
            corner 0.008\n\
            material iron\n\
            \n\
            kind solid\n\
            shape box\n\
            x 0\n\
            y 0.035\n\
            width 0.04\n\
            height 0.102\n\
            material iron",
    },
    Preset {
        name: "ghost-fire",
        text: "fuel_power 220\n\
            source_width 0.3\n\
            turbulence 1.5\n\
            palette ghost\n\
            exposure -0.5\n\
            bloom 0.45\n\
            smoke_opacity 0.2\n\
            ember_rate 10\n\
            time_scale 0.4\n\
            source_height 0.2\n\
            soot_life 0.5\n\
            source_oxygen 0.45\n\
            detail 1.5\n\
            turbulence_scale 0.3\n\
            domain_width 1.1\n\
            domain_height 1.6\n\
            spacing 0.024221",
    },
    Preset {
        name: "house-of-cards",
        text: "fuel_power 40\n\
            source_width 0.08\n\
            exposure 0.6\n\
            backdrop bricks\n\
            ground stone\n\
            time_scale 0.6\n\
            source_x -0.33\n\
            source_height 0.02\n\
            emission_speed 0.3\n\
            domain_width 0.8\n\
            domain_height 1.1\n\
            floor solid\n\
            spacing 0.018\n\
            max_particles 5500\n\
            \n\
            kind solid\n\
            shape box\n\
            x -0.2\n\
            y 0.095\n\
            angle 69.5\n\
            height 0.01\n\
            material wax\n\
            fuel paper\n\
            load 5\n\
            moisture 15\n\
            motion free\n\
            \n\
            x -0.04\n\
            \n\
            x 0.12\n\
            \n\
            x -0.12\n\
            y 0.296\n\
            \n\
            x 0.04\n\
            \n\
            x -0.04\n\
            y 0.497\n\
            \n\
            x -0.12\n\
            y 0.095\n\
            angle 110.5\n\
            \n\
            x 0.04\n\
            \n\
            x 0.2\n\
            \n\
            x -0.04\n\
            y 0.296\n\
            \n\
            x 0.12\n\
            \n\
            x 0.04\n\
            y 0.497\n\
            \n\
            x -0.08\n\
            y 0.196\n\
            angle 0\n\
            width 0.155\n\
            \n\
            x 0.08\n\
            \n\
            x 0\n\
            y 0.397",
    },
    Preset {
        name: "match",
        text: "fuel_power 15\n\
            source_width 0.06\n\
            wind 0.06\n\
            exposure 0.8\n\
            smoke_opacity 0.4\n\
            ember_rate 3\n\
            time_scale 0.5\n\
            source_height 0.14\n\
            emission_speed 0.15\n\
            emission_noise 0.8\n\
            soot_life 0.8\n\
            radiative_cooling 500\n\
            source_oxygen 0.7\n\
            detail 0.5\n\
            ember_size 0.0015\n\
            domain_width 0.42\n\
            domain_height 0.5\n\
            spacing 0.0083666\n\
            kinematic_viscosity 0.005\n\
            eddy_viscosity 0.25\n\
            diffusion 0.0005\n\
            \n\
            kind solid\n\
            shape line\n\
            x 0.028\n\
            y 0.088\n\
            angle 115\n\
            width 0.13\n\
            height 0.011\n\
            material wood\n\
            \n\
            kind solid\n\
            shape circle\n\
            x -0.002\n\
            y 0.148\n\
            width 0.017\n\
            material coal",
    },
    Preset {
        name: "paper-boat",
        text: "fuel_power 100\n\
            source_width 0.2\n\
            exposure 0.5\n\
            backdrop bricks\n\
            ground stone\n\
            time_scale 0.6\n\
            source_height 0.03\n\
            emission_speed 0.3\n\
            domain_width 1.3\n\
            domain_height 1.3\n\
            floor solid\n\
            spacing 0.026\n\
            max_particles 5000\n\
            \n\
            kind solid\n\
            shape polygon\n\
            x -0.8\n\
            y 0.05\n\
            points -0.16,0.05 -0.05,0 0,0.1 0.05,0 0.16,0.05 0.08,-0.05 -0.08,-0.05\n\
            material wax\n\
            fuel paper\n\
            load 1\n\
            moisture 20\n\
            motion free\n\
            density 2.5\n\
            friction 0.12",
    },
    Preset {
        name: "ring-of-fire",
        text: "fuel_power 50\n\
            source_width 0.16\n\
            exposure 0.6\n\
            smoke_opacity 0.2\n\
            ember_rate 60\n\
            ground sand\n\
            source_x 0\n\
            source_height 0.18\n\
            source_angle -180\n\
            emission_speed 0.4\n\
            emission_noise 0.5\n\
            soot_life 0.5\n\
            source_oxygen 0.4\n\
            domain_width 1.3\n\
            domain_height 1.6\n\
            spacing 0.026\n\
            max_particles 9000\n\
            \n\
            kind source\n\
            x 0.235\n\
            y 0.256\n\
            angle -144\n\
            power 50\n\
            width 0.16\n\
            speed 0.4\n\
            noise 0.5\n\
            oxygen 0.4\n\
            \n\
            x 0.38\n\
            y 0.456\n\
            angle -108\n\
            \n\
            y 0.704\n\
            angle -72\n\
            \n\
            x 0.235\n\
            y 0.904\n\
            angle -36\n\
            \n\
            x 0\n\
            y 0.98\n\
            angle 0\n\
            \n\
            x -0.235\n\
            y 0.904\n\
            angle 36\n\
            \n\
            x -0.38\n\
            y 0.704\n\
            angle 72\n\
            \n\
            y 0.456\n\
            angle 108\n\
            \n\
            x -0.235\n\
            y 0.256\n\
            angle 144\n\
            \n\
            kind solid\n\
            shape line\n\
            y 0.11\n\
            angle 90\n\
            width 0.2\n\
            height 0.045\n\
            material iron\n\
            \n\
            kind solid\n\
            shape line\n\
            y 0.012\n\
            width 0.4\n\
            height 0.024\n\
            material iron\n\
            \n\
            kind solid\n\
            shape stroke\n\
            y 0.58\n\
            height 0.03\n\
            points 0.37,0 0.363,0.072 0.342,0.142 0.308,0.206 0.262,0.262 0.206,0.308 0.142,0.342 0.072,0.363 0,0.37 -0.072,0.363 -0.142,0.342 -0.206,0.308 -0.262,0.262 -0.308,0.206 -0.342,0.142 -0.363,0.072 -0.37,0 -0.363,-0.072 -0.342,-0.142 -0.308,-0.206 -0.262,-0.262 -0.206,-0.308 -0.142,-0.342 -0.072,-0.363 0,-0.37 0.072,-0.363 0.142,-0.342 0.206,-0.308 0.262,-0.262 0.308,-0.206 0.342,-0.142 0.363,-0.072 0.37,0\n\
            material iron\n\
            thermal conducting",
    },
    Preset {
        name: "rope",
        text: "fuel_power 35\n\
            source_width 0.1\n\
            exposure 0.4\n\
            backdrop bricks\n\
            ground stone\n\
            time_scale 0.6\n\
            source_height 0.02\n\
            emission_speed 0.3\n\
            domain_width 0.8\n\
            domain_height 1.2\n\
            floor solid\n\
            spacing 0.018\n\
            max_particles 6000\n\
            \n\
            kind solid\n\
            shape line\n\
            y 1.052\n\
            angle 90\n\
            width 0.056\n\
            height 0.032\n\
            material wax\n\
            fuel cloth\n\
            load 7\n\
            moisture 15\n\
            motion free\n\
            density 60\n\
            hangs_from 18\n\
            \n\
            y 0.996\n\
            hangs_from 2\n\
            \n\
            y 0.94\n\
            hangs_from 3\n\
            \n\
            y 0.884\n\
            hangs_from 4\n\
            \n\
            y 0.828\n\
            hangs_from 5\n\
            \n\
            y 0.772\n\
            hangs_from 6\n\
            \n\
            y 0.716\n\
            hangs_from 7\n\
            \n\
            y 0.66\n\
            hangs_from 8\n\
            \n\
            y 0.604\n\
            hangs_from 9\n\
            \n\
            y 0.548\n\
            hangs_from 10\n\
            \n\
            y 0.492\n\
            hangs_from 11\n\
            \n\
            y 0.436\n\
            hangs_from 12\n\
            \n\
            y 0.38\n\
            hangs_from 13\n\
            \n\
            y 0.324\n\
            hangs_from 14\n\
            \n\
            y 0.268\n\
            hangs_from 15\n\
            \n\
            kind solid\n\
            shape circle\n\
            y 0.24\n\
            width 0.056\n\
            material wax\n\
            fuel cloth\n\
            load 7\n\
            moisture 15\n\
            motion free\n\
            density 60\n\
            hangs_from 16\n\
            \n\
            kind solid\n\
            shape circle\n\
            y 1.08\n\
            width 0.05\n\
            material iron",
    },
    Preset {
        name: "sheltered-candle",
        text: "fuel_power 24\n\
            source_width 0.08\n\
            wind 0.4\n\
            exposure 1\n\
            smoke_opacity 0.1\n\
            ember_rate 0\n\
            ground stone\n\
            time_scale 0.5\n\
            source_height 0.11\n\
            emission_speed 0.15\n\
            emission_noise 0\n\
            soot_life 0.6\n\
            radiative_cooling 700\n\
            source_oxygen 0.5\n\
            detail 0.2\n\
            domain_width 0.5\n\
            domain_height 0.5\n\
            spacing 0.0095\n\
            max_particles 7000\n\
            kinematic_viscosity 0.01\n\
            eddy_viscosity 0.3\n\
            diffusion 0.001\n\
            \n\
            kind solid\n\
            shape box\n\
            x 0\n\
            y 0.048\n\
            width 0.07\n\
            height 0.104\n\
            corner 0.012\n\
            material wax\n\
            \n\
            kind solid\n\
            shape line\n\
            x 0\n\
            y 0.106\n\
            angle 90\n\
            width 0.016\n\
            height 0.005\n\
            material coal\n\
            \n\
            shape box\n\
            x -0.13\n\
            y 0.24\n\
            width 0.22\n\
            height 0.026\n\
            corner 0.004\n\
            material wood\n\
            motion sway\n\
            sway 0.12\n\
            heading -90\n\
            period 6",
    },
    Preset {
        name: "smoke-stack",
        text: "fuel_power 150\n\
            source_width 0.25\n\
            turbulence 1\n\
            smoke_opacity 2\n\
            ember_rate 5\n\
            ground earth\n\
            source_height 0.2\n\
            flame_rise 900\n\
            air_demand 1\n\
            soot_life 2\n\
            radiative_cooling 1800\n\
            source_oxygen 0.1\n\
            background #b9c4cc\n\
            smoke_life 10\n\
            domain_width 1.6\n\
            domain_height 2.2\n\
            spacing 0.034254\n\
            \n\
            kind solid\n\
            shape box\n\
            x 0\n\
            y 0.05\n\
            width 0.34\n\
            height 0.32\n\
            material brick",
    },
    Preset {
        name: "torch",
        text: "fuel_power 190\n\
            source_width 0.14\n\
            turbulence 1.5\n\
            exposure 0.3\n\
            ember_rate 70\n\
            backdrop bricks\n\
            source_height 0.33\n\
            emission_speed 1.2\n\
            emission_noise 0.3\n\
            soot_life 0.35\n\
            source_oxygen 0.6\n\
            detail 1.2\n\
            turbulence_scale 0.12\n\
            domain_width 1\n\
            domain_height 1.3\n\
            spacing 0.020817\n\
            \n\
            kind solid\n\
            shape line\n\
            x 0\n\
            y 0.12\n\
            angle 90\n\
            width 0.34\n\
            height 0.045\n\
            material wood\n\
            \n\
            kind solid\n\
            shape box\n\
            x 0\n\
            y 0.31\n\
            width 0.12\n\
            height 0.05\n\
            corner 0.015\n\
            material iron",
    },
    Preset {
        name: "wall-of-fire",
        text: "fuel_power 150\n\
            source_width 0.4\n\
            turbulence 1\n\
            exposure 0.3\n\
            ember_rate 60\n\
            ground stone\n\
            time_scale 0.5\n\
            source_height 0.1\n\
            emission_speed 0.6\n\
            emission_noise 0.6\n\
            source_oxygen 0.5\n\
            source_temperature 900\n\
            domain_width 2.8\n\
            domain_height 1.4\n\
            spacing 0.036148\n\
            \n\
            kind source\n\
            x -1\n\
            power 150\n\
            speed 0.6\n\
            noise 0.6\n\
            width 0.4\n\
            y 0.1\n\
            temperature 900\n\
            oxygen 0.5\n\
            \n\
            x -0.5\n\
            \n\
            x 0.5\n\
            \n\
            x 1\n\
            \n\
            kind solid\n\
            shape box\n\
            x 0\n\
            y 0.045\n\
            width 2.7\n\
            height 0.1\n\
            material brick",
    },
    Preset {
        name: "wooden-word",
        text: "fuel_power 40\n\
            source_width 0.08\n\
            wind 0.25\n\
            exposure 0.4\n\
            smoke_opacity 0.3\n\
            ember_rate 60\n\
            ground stone\n\
            source_x -0.5\n\
            source_height 0.02\n\
            emission_speed 0.3\n\
            radiative_cooling 500\n\
            domain_width 1.26\n\
            domain_height 1.05\n\
            spacing 0.0182\n\
            max_particles 9000\n\
            \n\
            kind solid\n\
            shape mask\n\
            x 0\n\
            y 0.231\n\
            width 1.008\n\
            height 0.291\n\
            mask 128x37:jB3xLSO2BAF3ONMKIGDbB3yFUB3xLSO2BAF3tOKDYB3yFVBDEGM3sLSBDEGLtLGEDBRBDFGOtMLLLMwJBXBDEGM3tFZKtHaHoLWItJZNtETCFLtMBaKtHbLoFZKtHaFoLWItJZNtEWEtLaKtHbJoFZKtHaDoLWItJZNtEXHtGZKtHbHoFZKtHaBoLWItJZNtEXBtNZKtHbFoFZKtHbOPLWItJZNtEYMtCYKtHbDoFZKtHbMPLWItJZNtEYLtEYKtHcoFZKtHbFHGWItJZNtEYKtFYKtHfZKtHfVItJZNtEYLtFYKtHfZKtHfVItJZNtEYLtDYKtHfZKtHfVItJZNtEYOtBYKtHXLPJeKtHWGobItJZNtEXCtLZKtHXoJeKtHWIobItJZNtEXJtFZKtHWDoJeKtHWLobItJZNtEWGtMaKtHWGoJeKtHWOobItJZNtETCEKtOCaK3oJeKtNLLLLLLLLpbItJZNtMLLLMOvMCbK3oJeK3obItJZN3pMFdK3oJeK3obItJZN3oKfKtHWGoJeKtHWpbItJZNtERDuEeKtHWCoJeKtHWMobItJZNtESItNBdKtHXOPJeKtHWKobItJZNtETMtLdKtHXILHeKtHWHobItJZNtETDuGcKtHfZKtHWELLbItJZNtEUJtOCbKtHfZKtHfVItJZNtEUBNtMbKtHeKLGXKtHfVItJZNtEVEuIaKtHdBoHXKtHfVItJZNtEWKuEZKtHdFoGXKtHfVItJZNtEWBOtNBYKtHdIoFXKtHfVItJZNtEXFuKYKtHdLoFXKtHfVItJZNtEYLuGXKtHdpEXKtHfVItJZNtEYCOtOCWKtHcFpDVDFMtKFECfBDEGLtLGEDBRBEHJuLIGDWGuNIGDABDEGM3vDTJ2MDcO2BQ2KWMxG30CTL3DcO2BQ2KWDxG30BS\n\
            material wood\n\
            front false\n\
            fuel wood\n\
            load 1.6\n\
            moisture 25",
    },
    Preset {
        name: "classic",
        text: "model classic",
    },
    Preset {
        name: "paper-buoyancy",
        text: "model classic\n\
            emission_rate 2500\n\
            source_width 0.24\n\
            lifetime_max 0.8\n\
            source_height 0.2\n\
            emission_speed 0.5\n\
            emission_spread 0.3\n\
            emission_noise 0\n\
            taper 0.6\n\
            lifetime_min 0.4\n\
            display_mode paper\n\
            particle_size 0.03\n\
            buoyancy 1\n\
            thermal_buoyancy 0.02\n\
            domain_height 1.5\n\
            smoothing_radius 0.022\n\
            particle_mass 0.00015\n\
            gas_constant 0.6",
    },
    Preset {
        name: "paper-fire",
        text: "model classic\n\
            emission_rate 2500\n\
            source_width 0.24\n\
            lifetime_max 1.2\n\
            source_height 0.2\n\
            emission_speed 0.5\n\
            emission_spread 0.3\n\
            emission_noise 0\n\
            taper 0.6\n\
            lifetime_min 0.4\n\
            display_mode paper\n\
            particle_size 0.03\n\
            buoyancy 0.12\n\
            thermal_buoyancy 0.02\n\
            domain_height 1.5\n\
            smoothing_radius 0.022\n\
            particle_mass 0.00015\n\
            gas_constant 0.6",
    },
    Preset {
        name: "paper-smoothing",
        text: "model classic\n\
            emission_rate 2500\n\
            source_width 0.24\n\
            lifetime_max 1.2\n\
            source_height 0.2\n\
            emission_speed 0.5\n\
            emission_spread 0.3\n\
            emission_noise 0\n\
            taper 0.6\n\
            lifetime_min 0.4\n\
            display_mode paper\n\
            particle_size 0.03\n\
            buoyancy 0.12\n\
            thermal_buoyancy 0.02\n\
            domain_height 1.5\n\
            smoothing_radius 0.07\n\
            particle_mass 0.00015\n\
            gas_constant 0.6",
    },
    Preset {
        name: "paper-stiffness",
        text: "model classic\n\
            emission_rate 2500\n\
            source_width 0.24\n\
            lifetime_max 1.2\n\
            source_height 0.2\n\
            emission_speed 0.5\n\
            emission_spread 0.3\n\
            emission_noise 0\n\
            taper 0.6\n\
            lifetime_min 0.4\n\
            display_mode paper\n\
            particle_size 0.03\n\
            buoyancy 0.12\n\
            thermal_buoyancy 0.02\n\
            domain_height 1.5\n\
            smoothing_radius 0.022\n\
            particle_mass 0.00015\n\
            gas_constant 6",
    },
    Preset {
        name: "paper-viscosity",
        text: "model classic\n\
            emission_rate 2500\n\
            source_width 0.24\n\
            lifetime_max 1.2\n\
            source_height 0.2\n\
            emission_speed 0.5\n\
            emission_spread 0.3\n\
            emission_noise 0\n\
            taper 0.6\n\
            lifetime_min 0.4\n\
            display_mode paper\n\
            particle_size 0.03\n\
            buoyancy 0.12\n\
            thermal_buoyancy 0.02\n\
            domain_height 1.5\n\
            smoothing_radius 0.022\n\
            particle_mass 0.00015\n\
            gas_constant 0.6\n\
            viscosity 0.016\n\
            printed_viscosity true",
    },
    Preset {
        name: "seed",
        text: "model classic\n\
            emission_rate 400\n\
            source_width 0.125\n\
            lifetime_max 2\n\
            emission_speed 0.75\n\
            emission_spread 0.45\n\
            emission_noise 0\n\
            taper 0\n\
            lifetime_min 1.1\n\
            maximum_temperature 1273\n\
            cooling_rate 300\n\
            display_mode paper\n\
            particle_size 0.015\n\
            buoyancy 0.02\n\
            thermal_buoyancy 0.01\n\
            domain_width 1.5\n\
            domain_height 1.5\n\
            walls solid\n\
            max_particles 800\n\
            smoothing_radius 0.0075\n\
            particle_mass 0.0001\n\
            gas_constant 2\n\
            viscosity 0.0002",
    },
];

/// What a person reads about each preset, in the order of [`PRESETS`].
pub static CAPTIONS: &[Caption] = &[
    Caption {
        label: "Default",
        description: "A broad fire in still air, at every parameter's default.",
    },
    Caption {
        label: "Bonfire in wind",
        description: "A large fire that a steady wind leans over, and its sparks with it.",
    },
    Caption {
        label: "Burning logs",
        description: "A small heap of logs that catch fire one after another and burn away.",
    },
    Caption {
        label: "Burning word",
        description: "A word of glowing coal that burns along its letters.",
    },
    Caption {
        label: "Campfire",
        description: "A broad, lively fire in the open that throws sparks.",
    },
    Caption {
        label: "Candle",
        description: "A small flame, steady as in a room without a draught.",
    },
    Caption {
        label: "Burning curtains",
        description: "Curtains in a draught that a candle sets on fire.",
    },
    Caption {
        label: "Fireplace",
        description: "A fire of logs on a grate of iron, in an opening of bricks below its flue.",
    },
    Caption {
        label: "Fireside",
        description: "A campfire on a stone floor before a wall of bricks, which it lights.",
    },
    Caption {
        label: "Forge",
        description: "Low, wide and white-hot before a wall of bricks, full of sparks.",
    },
    Caption {
        label: "Gas burner",
        description: "A blue cone of gas that was mixed with air before it burns.",
    },
    Caption {
        label: "Ghost fire",
        description: "Pale flames that rise slowly, as no fire does.",
    },
    Caption {
        label: "House of cards",
        description: "A house of cards that a small flame sets on fire at a corner, and that falls as it burns.",
    },
    Caption {
        label: "Match",
        description: "A small flame that flickers, leans and smokes a little.",
    },
    Caption {
        label: "Paper boat",
        description: "A paper boat that the draught of a fire draws in, sets on fire and lifts.",
    },
    Caption {
        label: "Ring of fire",
        description: "A hoop of iron that burns all around.",
    },
    Caption {
        label: "Burning rope",
        description: "A rope that burns upward from its knot, and falls.",
    },
    Caption {
        label: "Sheltered candle",
        description: "A candle in a draught, behind a plate that moves up and down.",
    },
    Caption {
        label: "Smoke stack",
        description: "Rich fuel and little air: dark red flames under rolling smoke.",
    },
    Caption {
        label: "Torch",
        description: "A tall, restless flame from a narrow head, on a wall.",
    },
    Caption {
        label: "Wall of fire",
        description: "A broad front of flames, in slow motion.",
    },
    Caption {
        label: "Wooden word",
        description: "A word of wood that a small flame sets on fire at one end, and that burns away.",
    },
    Caption {
        label: "Classic",
        description: "The student paper's model, with its mistakes put right.",
    },
    Caption {
        label: "Paper, buoyancy",
        description: "As Paper, plain, with much more buoyancy and shorter lives: the fire is narrower.",
    },
    Caption {
        label: "Paper, plain",
        description: "The classic model drawn as in the paper: the fire that four other scenes change.",
    },
    Caption {
        label: "Paper, smoothing",
        description: "As Paper, plain, with a three times larger smoothing radius: its particles cluster.",
    },
    Caption {
        label: "Paper, stiffness",
        description: "As Paper, plain, with a ten times larger gas constant: the fire is wider.",
    },
    Caption {
        label: "Paper, viscosity",
        description: "As Paper, plain, with more viscosity, in the force as the paper prints it: the fire spreads to both sides.",
    },
    Caption {
        label: "Seed",
        description: "The program that Hearth grew from: a narrow column of sparse dots.",
    },
];
