// Generated from the class in web/hearth-fire.js by `cargo xtask codegen`; edit its JSDoc instead.

/** The attributes that are no parameters. */
export const OWN_ATTRIBUTES = ["preset", "objects", "quality", "paused", "autoplay", "src", "loading", "poster", "alt", "max-pixels", "fps-limit", "warm", "interactive", "decorative", "fit", "align", "zoom", "pan", "sound", "roar", "crackle", "hiss", "touch-action", "controls", "reduced-motion"];
