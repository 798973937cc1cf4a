// Generated from the parameter table of hearth-core and the table of the element
// by `cargo xtask codegen`; edit crates/hearth-core/src/params.rs or
// crates/xtask/src/codegen/element.json instead.

/**
 * `<hearth-fire>` in JSX, for React 19 and newer: `import 'hearth-fire/react'`
 * instead of `'hearth-fire'`, and attributes and events have their types.
 */

import type { DetailedHTMLProps, HTMLAttributes } from 'react';
import type {
  HearthChangeDetail,
  HearthErrorDetail,
  HearthFire,
  HearthQuality,
  HearthQualityDetail,
  HearthStats,
  PresetName,
} from './hearth-fire.js';

export * from './hearth-fire.js';

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'hearth-fire': DetailedHTMLProps<HearthFireProps, HearthFire>;
    }
  }
}

/** Everything that `<hearth-fire>` takes in JSX. */
export type HearthFireProps = HearthFireAttributes &
  HearthFireListeners &
  Omit<HTMLAttributes<HearthFire>, keyof HearthFireAttributes | keyof HearthFireListeners>;

/** The attributes of `<hearth-fire>`; one that is taken away is back at its default. */
export interface HearthFireAttributes {
{{attributes}}}

/** The events of `<hearth-fire>`. */
export interface HearthFireListeners {
{{listeners}}}
