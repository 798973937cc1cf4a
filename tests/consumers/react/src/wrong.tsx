// What the compiler must not let through.
import 'hearth-fire/react';

export const wrong = (
  <>
    {/* @ts-expect-error: a width is a number. */}
    <hearth-fire source-width="wide" />
    {/* @ts-expect-error: no parameter is called so. */}
    <hearth-fire sauce={1} />
    {/* @ts-expect-error: no material is called so. */}
    <hearth-fire><hearth-solid of="#headline" material="straw" /></hearth-fire>
    {/* @ts-expect-error: `stats` tells no text. */}
    <hearth-fire onstats={(event: CustomEvent<string>) => event} />
  </>
);
