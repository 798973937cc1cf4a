/**
 * A fire as a component of React Three Fiber.
 *
 *     <Fire preset="campfire" warm={2} position={[0, 0, 0]} wind={[0.5, 0, 0]} />
 *
 * An option that changes starts another fire; `values`, `wind`, `intensity` and the properties of an object change this one.
 */

import { invalidate } from '@react-three/fiber';
import { createElement, useEffect, useRef, useState } from 'react';
import { FireObject } from '../three.js';

/** What a fire starts with. */
const STARTS = ['preset', 'quality', 'warm', 'paused', 'width', 'height', 'fit', 'wasmUrl', 'thread', 'shadow', 'soft'];

/** @param {import('./react.js').FireProps} props */
export function Fire({ type = FireObject, values, onError, ...props }) {
  const given = Object.entries(props);
  const options = Object.fromEntries(given.filter(([name]) => STARTS.includes(name)));
  const rest = Object.fromEntries(given.filter(([name]) => !STARTS.includes(name)));
  const key = JSON.stringify(options);
  const latest = useRef({ options, values, onError });
  latest.current = { options, values, onError };
  const [fire, setFire] = useState(/** @type {FireObject | undefined} */ (undefined));

  // biome-ignore lint/correctness/useExhaustiveDependencies: the options are equal while their texts are.
  useEffect(() => {
    const { options, values } = latest.current;
    const made = new type({ ...options, values });
    made.addEventListener('error', (/** @type {{error: Error}} */ { error }) => latest.current.onError?.(error));
    // A canvas with frames on demand draws each picture.
    made.addEventListener('picture', () => invalidate());
    setFire(made);
    return () => made.dispose();
  }, [type, key]);

  const set = JSON.stringify(values);
  const before = useRef({ fire, set });
  useEffect(() => {
    const { fire: then, set: last } = before.current;
    before.current = { fire, set };
    if (!fire || then !== fire || set === last) return;
    // A value that is left out has its default again.
    const gone = Object.keys(JSON.parse(last ?? '{}')).map((id) => [id, null]);
    fire.fire.set({ ...Object.fromEntries(gone), ...JSON.parse(set ?? '{}') }).catch(() => {});
  }, [fire, set]);

  return fire ? createElement('primitive', { ...rest, object: fire }) : null;
}
