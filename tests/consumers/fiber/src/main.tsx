import { Canvas } from '@react-three/fiber';
import { Fire } from 'hearth-fire/three/react';
import type { FireObject } from 'hearth-fire/three';
import { StrictMode, useState } from 'react';
import { createRoot } from 'react-dom/client';

/** The state that the test sets. */
interface State {
  there: boolean;
  power?: number;
  x?: number;
  wind?: number;
}

const page = {
  fires: [] as FireObject[],
  errors: [] as string[],
  setState: (_: State): void => {},
};
Object.assign(window, { page });
const met = (fire: FireObject | null) => void (fire && !page.fires.includes(fire) && page.fires.push(fire));

function Scene() {
  const [{ there, power, x = 0, wind = 0 }, setState] = useState<State>({ there: true });
  page.setState = setState;
  return there ? (
    <Fire
      ref={met}
      width={160}
      height={160}
      quality="low"
      values={power === undefined ? { seed: 7 } : { seed: 7, fuel_power: power }}
      position={[x, 0, 0]}
      wind={[wind, 0, 0]}
      onError={(error) => page.errors.push(error.message)}
    />
  ) : null;
}

// @ts-expect-error: there is no such scene.
export const wrong = <Fire preset="campfir" />;

const root = document.getElementById('root');
if (!root) throw new Error('there is no place for the scene');
createRoot(root).render(
  <StrictMode>
    <Canvas camera={{ position: [0, 0.8, 4] }}>
      <Scene />
    </Canvas>
  </StrictMode>,
);
