// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params/table.rs instead.

/** Which equations move the particles. */
export type ModelName = {{models}};

/** The name of a preset. */
export type PresetName = {{presets}};

/** The value of every parameter, by its id. */
export interface HearthParameters {
{{parameters}}}

/** The value of every parameter, as the element's properties name it. */
export interface HearthProperties {
{{properties}}}

{{objects}}
/** Any id of a parameter. */
export type ParameterId = keyof HearthParameters;

/** Values to set: `undefined` states nothing, `null` restores the default. */
export type HearthValues = { [Id in ParameterId]?: HearthParameters[Id] | null | undefined } & {
  objects?: HearthObject[] | null | undefined;
};

/** Default and range of a parameter in one model; only numbers have a range. */
export interface ParameterDomain {
  default: number | string | boolean;
  min?: number;
  max?: number;
}

/**
 * What is known about a parameter. Default and range are those of the default
 * model, or of the one that uses it; `domains` has those of each.
 */
export interface Parameter extends ParameterDomain {
  id: ParameterId;
  /** The attribute of `<hearth-fire>`. */
  attribute: string;
  /** The property of `<hearth-fire>`. */
  property: keyof HearthProperties;
  label: string;
  group: string;
  /** Empty for a pure number. */
  unit: string;
  doc: string;
  kind: 'number' | 'integer' | 'choice' | 'flag' | 'colour' | 'seed';
  /** Numbers and integers: how a slider spreads the range. */
  scale?: 'linear' | 'log';
  /** Choices: every name. */
  choices?: string[];
  /** The models that use it. */
  models: ModelName[];
  domains: Partial<Record<ModelName, ParameterDomain>>;
  /**
   * The choices, by id, that must each have one of these names, or the value shows nowhere.
   * It can be set all the same.
   */
  when?: Partial<Record<ParameterId, string[]>>;
  /** The choices with whose names, all of them chosen together, it shows nowhere either. */
  unless?: Partial<Record<ParameterId, string[]>>;
}

/** A named set of values: the defaults, with these changed. */
export interface Preset {
  name: PresetName;
  label: string;
  /** What there is to see, in a sentence. */
  description: string;
  values: Partial<HearthParameters>;
}

/** Every parameter, in the order in which a panel shows them. */
export declare const PARAMETERS: Parameter[];

/** Every preset, the default one first. */
export declare const PRESETS: Preset[];

/** What the colours of a display mode measure, from `stats.scale[0]` to `stats.scale[1]`. */
export interface Quantity {
  /** Empty for a pure number. */
  unit: string;
  /** Whether it goes both ways from zero, which is then the middle of the colours. */
  signed: boolean;
  /** Whether it is a whole number. */
  whole: boolean;
}

/** Of each display mode that measures something, what. */
export declare const QUANTITIES: Partial<Record<HearthParameters['display_mode'], Quantity>>;
{{stats}}