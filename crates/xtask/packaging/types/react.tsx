/** What a user of React writes, and what the compiler must not let through. */
import type { HearthFire } from 'hearth-fire/react';

export function Fires({ hold }: { hold: (fire: HearthFire | null) => void }) {
  return (
    <main>
      <hearth-fire
        ref={hold}
        className="fire"
        style={{ width: 320 }}
        model="combustion"
        source-width={0.3}
        viscosity="0.02"
        max-particles={5000}
        quality="high"
        paused
        controls={false}
        alt="A fire"
        onready={() => console.log('burns')}
        onstats={({ detail }) => console.log(detail.fps)}
        onparams-change={({ detail }) => console.log(detail.id, detail.value)}
        onerror={({ detail }) => console.log(detail.kind, detail.message)}
        onClick={(event) => console.log(event.currentTarget.params.viscosity)}
      >
        <img slot="poster" alt="" src="poster.jpg" />
        <hearth-source x={0.2} power="80" />
        <hearth-solid of="#headline" material="wood" ref={(solid) => console.log(solid?.objectId)} />
      </hearth-fire>
      {/* @ts-expect-error: a width is a number. */}
      <hearth-fire source-width="wide" />
      {/* @ts-expect-error: there is no such model. */}
      <hearth-fire model="quantum" />
      {/* @ts-expect-error: `ready` tells nothing. */}
      <hearth-fire onready={(event: CustomEvent<string>) => event} />
    </main>
  );
}
