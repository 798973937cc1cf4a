import { useState } from 'react';
import type { HearthErrorDetail, HearthStats } from 'hearth-fire';

/** What the fire reports. */
export interface Observed {
  ready: number;
  stats: HearthStats | null;
  changes: string[];
  errors: HearthErrorDetail[];
}

/** The state that the test sets. */
interface State {
  there: boolean;
  width?: number;
  viscosity?: number;
  paused?: boolean;
}

export function App({ observed, onState }: { observed: Observed; onState(setState: (state: State) => void): void }) {
  const [{ there, width, viscosity, paused }, setState] = useState<State>({
    there: true, width: 0.3, viscosity: 0.02, paused: false,
  });
  onState(setState);
  if (!there) return null;
  return (
    <hearth-fire
      style={{ width: 240, height: 240 }}
      // More than one model takes: the model counts first, wherever it stands.
      max-particles={500}
      source-width={width}
      viscosity={viscosity}
      model="classic"
      paused={paused}
      alt="A fire"
      onready={() => (observed.ready += 1)}
      onstats={({ detail }) => (observed.stats = detail)}
      onparams-change={({ detail }) => observed.changes.push(`${detail.id}=${detail.value}`)}
      onerror={({ detail }) => observed.errors.push(detail)}
    />
  );
}
