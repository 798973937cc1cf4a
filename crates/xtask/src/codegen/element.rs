//! What `<hearth-fire>` has beyond its parameters, stated once for every tool:
//! the manifest of the element and its types for React are written from here, and
//! tests hold it against the element's class and its types.
//!
//! Types are those of TypeScript, by the names of `web/hearth-fire.d.ts`.

/// An attribute of the element's own, and the property of the same meaning.
pub(super) struct Attribute {
    /// Its name.
    pub name: &'static str,
    /// The type of the property.
    pub kind: &'static str,
    /// What counts where it is not there; empty: nothing.
    pub default: &'static str,
    /// Whether a change of the property changes the attribute.
    pub reflects: bool,
    /// What it is for.
    pub doc: &'static str,
}

/// A property that no attribute has.
pub(super) struct Field {
    /// Its name.
    pub name: &'static str,
    /// Its type.
    pub kind: &'static str,
    /// Whether it is one of the class.
    pub of_class: bool,
    /// What it is for.
    pub doc: &'static str,
}

/// A method.
pub(super) struct Method {
    /// Its name.
    pub name: &'static str,
    /// Name and type of each parameter; a name that ends in `?` may be left out.
    pub parameters: &'static [(&'static str, &'static str)],
    /// What it returns.
    pub returns: &'static str,
    /// What it does.
    pub doc: &'static str,
}

/// Something that has a name and a meaning.
pub(super) struct Named {
    /// The name.
    pub name: &'static str,
    /// Of an event: the type of its `detail`; else empty.
    pub kind: &'static str,
    /// What it is.
    pub doc: &'static str,
}

/// The attributes that are no parameters.
pub(super) const ATTRIBUTES: &[Attribute] = &[
    Attribute {
        name: "preset",
        kind: "PresetName",
        default: "default",
        reflects: true,
        doc: "The named set of values that the fire starts from. Changed later, it replaces every value.",
    },
    Attribute {
        name: "src",
        kind: "string",
        default: "",
        reflects: true,
        doc: "The address of a JSON file with settings, as `exportConfig()` gives them.",
    },
    Attribute {
        name: "objects",
        kind: "HearthObject[]",
        default: "",
        reflects: false,
        doc: "The sources of the fire, as JSON; without it one source, which the parameters describe.",
    },
    Attribute {
        name: "quality",
        kind: "'auto' | HearthQuality",
        default: "auto",
        reflects: true,
        doc: "How much work the fire may make itself; `auto`: as much as fits.",
    },
    Attribute {
        name: "paused",
        kind: "boolean",
        default: "false",
        reflects: true,
        doc: "The fire stands still while this is there.",
    },
    Attribute {
        name: "autoplay",
        kind: "boolean",
        default: "true",
        reflects: true,
        doc: "`false`: the fire stands still until `play()`.",
    },
    Attribute {
        name: "loading",
        kind: "'auto' | 'lazy' | 'eager'",
        default: "auto",
        reflects: true,
        doc: "When the fire is loaded: `lazy`, when it comes near the window; `eager`, at once.",
    },
    Attribute {
        name: "poster",
        kind: "string",
        default: "",
        reflects: true,
        doc: "The address of a picture that is shown until the fire burns, and where it cannot.",
    },
    Attribute {
        name: "alt",
        kind: "string",
        default: "",
        reflects: true,
        doc: "What a screen reader says of the fire; without it the fire is decoration.",
    },
    Attribute {
        name: "max-pixels",
        kind: "number | string",
        default: "",
        reflects: true,
        doc: "Most pixels that the picture may have.",
    },
    Attribute {
        name: "fps-limit",
        kind: "number | string",
        default: "",
        reflects: true,
        doc: "Most pictures a second.",
    },
    Attribute {
        name: "warm",
        kind: "number | boolean | string",
        default: "",
        reflects: true,
        doc: "Seconds of fire, 0 to 30, that a new fire burns before it is shown: 3 where the attribute has no value. The poster or the picture before stays meanwhile.",
    },
    Attribute {
        name: "interactive",
        kind: "boolean",
        default: "false",
        reflects: true,
        doc: "The fire takes pointers: they stir it, a click throws sparks, a drag moves its source. Without this clicks go through it.",
    },
    Attribute {
        name: "fit",
        kind: "'height' | 'contain' | 'cover' | 'width'",
        default: "height",
        reflects: true,
        doc: "How the fire's domain fits the picture: as high as it, all of it seen, nothing else seen, or as wide as it.",
    },
    Attribute {
        name: "align",
        kind: "string",
        default: "",
        reflects: true,
        doc: "Where the domain stands in the picture, as CSS's `object-position`: `left`, `center` or `right`, `top`, `center` or `bottom`; without it `center bottom`.",
    },
    Attribute {
        name: "touch-action",
        kind: "string",
        default: "",
        reflects: true,
        doc: "What fingers do on an interactive fire, as CSS's `touch-action`; without it `pan-y`.",
    },
    Attribute {
        name: "controls",
        kind: "boolean | string",
        default: "false",
        reflects: true,
        doc: "Shows the panel of sliders inside the element, or those of a list of parameters; its code is loaded only then.",
    },
    Attribute {
        name: "reduced-motion",
        kind: "'auto' | 'ignore'",
        default: "auto",
        reflects: true,
        doc: "`auto`: a still fire with a play button where the visitor wants less motion.",
    },
];

/// The properties that no attribute has.
pub(super) const FIELDS: &[Field] = &[
    Field {
        name: "wasmUrl",
        kind: "string | URL | undefined",
        of_class: true,
        doc: "Where the wasm file is, if it is not beside the module. Set it before the first fire.",
    },
    Field {
        name: "engine",
        kind: "'auto' | 'worker' | 'main'",
        of_class: true,
        doc: "Where the engine runs; `auto`: in a worker where that can draw. Set it before the first fire.",
    },
    Field {
        name: "params",
        kind: "HearthParameters",
        of_class: false,
        doc: "Every value that the fire burns with, by id.",
    },
    Field {
        name: "stats",
        kind: "HearthStats | null",
        of_class: false,
        doc: "What the fire last said about itself; null before it did.",
    },
    Field {
        name: "ready",
        kind: "Promise<void>",
        of_class: false,
        doc: "Resolves when the fire burns; rejects where it cannot.",
    },
];

/// The methods.
pub(super) const METHODS: &[Method] = &[
    Method {
        name: "play",
        parameters: &[],
        returns: "Promise<void>",
        doc: "Lets it burn.",
    },
    Method {
        name: "pause",
        parameters: &[],
        returns: "Promise<void>",
        doc: "Lets it stand still.",
    },
    Method {
        name: "reset",
        parameters: &[],
        returns: "Promise<void>",
        doc: "Starts again from nothing, with the same values.",
    },
    Method {
        name: "step",
        parameters: &[("steps?", "number")],
        returns: "Promise<void>",
        doc: "Makes some steps, burning or not, then draws.",
    },
    Method {
        name: "get",
        parameters: &[("id", "ParameterId")],
        returns: "number | string | boolean",
        doc: "The value of one parameter.",
    },
    Method {
        name: "set",
        parameters: &[
            ("ids", "ParameterId | Partial<HearthParameters>"),
            ("value?", "number | string | boolean"),
        ],
        returns: "Promise<void>",
        doc: "Sets one parameter, or several: all of them or none. Rejects with a RangeError that names what is allowed.",
    },
    Method {
        name: "addObject",
        parameters: &[("object", "HearthObject")],
        returns: "Promise<number>",
        doc: "Adds an object; resolves to its id. Rejects with a RangeError that names what is allowed.",
    },
    Method {
        name: "changeObject",
        parameters: &[("id", "string"), ("properties", "Partial<HearthObject>")],
        returns: "Promise<void>",
        doc: "Sets properties of an object: all of them or none. Rejects as `addObject` does.",
    },
    Method {
        name: "removeObject",
        parameters: &[("id", "number")],
        returns: "Promise<void>",
        doc: "Removes an object. The next source becomes the first, which the parameters describe.",
    },
    Method {
        name: "to",
        parameters: &[
            ("values", "Partial<HearthParameters>"),
            ("how?", "HearthTransition"),
        ],
        returns: "Promise<boolean>",
        doc: "Moves parameters to values, all of them or none; whether they arrived. Rejects as `set` does.",
    },
    Method {
        name: "restore",
        parameters: &[("...ids", "ParameterId[]")],
        returns: "Promise<void>",
        doc: "Puts these, or all, back to their defaults.",
    },
    Method {
        name: "exportConfig",
        parameters: &[],
        returns: "Promise<HearthConfig>",
        doc: "Its settings: the preset, and what differs from it.",
    },
    Method {
        name: "importConfig",
        parameters: &[("config", "HearthConfig | string")],
        returns: "Promise<void>",
        doc: "Burns with these settings, or with those of this JSON: all of them or none.",
    },
    Method {
        name: "toBlob",
        parameters: &[("type?", "string"), ("quality?", "number")],
        returns: "Promise<Blob>",
        doc: "What is seen of it now, as a file of that type; without one, PNG.",
    },
    Method {
        name: "captureStream",
        parameters: &[("fps?", "number")],
        returns: "Promise<MediaStream>",
        doc: "The fire as a stream of video.",
    },
    Method {
        name: "stir",
        parameters: &[
            ("x", "number"),
            ("y", "number"),
            ("u", "number"),
            ("v", "number"),
        ],
        returns: "Promise<void>",
        doc: "Carries the gas around a place along, for a twentieth of a second.",
    },
    Method {
        name: "sparks",
        parameters: &[("x", "number"), ("y", "number"), ("count?", "number")],
        returns: "Promise<void>",
        doc: "Throws sparks from a place; the classic model has none.",
    },
    Method {
        name: "toMetres",
        parameters: &[("x", "number"), ("y", "number")],
        returns: "HearthPoint | null",
        doc: "The place of the fire's world that a point of the element shows.",
    },
    Method {
        name: "toPixels",
        parameters: &[("x", "number"), ("y", "number")],
        returns: "HearthPoint | null",
        doc: "Where a place of the fire's world is shown: the inverse of `toMetres`.",
    },
    Method {
        name: "destroy",
        parameters: &[],
        returns: "Promise<void>",
        doc: "Puts the fire out and frees all that it holds.",
    },
];

/// The events. None of them bubbles.
pub(super) const EVENTS: &[Named] = &[
    Named {
        name: "ready",
        kind: "null",
        doc: "The fire burns.",
    },
    Named {
        name: "play",
        kind: "null",
        doc: "It burns again.",
    },
    Named {
        name: "pause",
        kind: "null",
        doc: "It stands still.",
    },
    Named {
        name: "params-change",
        kind: "HearthChangeDetail",
        doc: "A value changed, whoever changed it.",
    },
    Named {
        name: "objects-change",
        kind: "HearthObjectsDetail",
        doc: "An object was added, changed or removed.",
    },
    Named {
        name: "quality-change",
        kind: "HearthQualityDetail",
        doc: "The fire makes itself more or less work than before.",
    },
    Named {
        name: "stats",
        kind: "HearthStats",
        doc: "What the fire says about itself, about four times a second.",
    },
    Named {
        name: "error",
        kind: "HearthErrorDetail",
        doc: "Something is wrong: a value that was refused, a file that did not arrive, a browser that cannot.",
    },
    Named {
        name: "restored",
        kind: "null",
        doc: "The graphics context was lost and is back.",
    },
];

/// What CSS reaches with `::part()`.
pub(super) const PARTS: &[Named] = &[
    Named {
        name: "canvas",
        kind: "",
        doc: "The canvas.",
    },
    Named {
        name: "message",
        kind: "",
        doc: "The words for a browser that cannot show the fire.",
    },
    Named {
        name: "play",
        kind: "",
        doc: "The button that plays a fire that stands still for the visitor's sake, and pauses it again.",
    },
    Named {
        name: "panel",
        kind: "",
        doc: "The panel of sliders, where there is one.",
    },
    Named {
        name: "scale",
        kind: "",
        doc: "The bar that says which colour is how much, where the picture shows a quantity.",
    },
];

/// The custom properties that the fire sets on itself.
pub(super) const CSS_PROPERTIES: &[Named] = &[
    Named {
        name: "--hearth-light",
        kind: "",
        doc: "Its power now against its mean, from 0 to 1; 0.5 is the mean.",
    },
    Named {
        name: "--hearth-glow",
        kind: "",
        doc: "The colour of its light.",
    },
];

/// What CSS selects by `:state()`.
pub(super) const CSS_STATES: &[Named] = &[Named {
    name: "burning",
    kind: "",
    doc: "Its picture is shown and it plays.",
}];

/// Where a page puts what is its own.
pub(super) const SLOTS: &[Named] = &[Named {
    name: "poster",
    kind: "",
    doc: "What is shown until the fire burns, and where it cannot; the attribute's picture if this is empty.",
}];
