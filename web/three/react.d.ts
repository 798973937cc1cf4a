/**
 * The types of `hearth-fire/three/react`: a fire as a component of React Three Fiber.
 */

import type { ThreeElements } from '@react-three/fiber';
import type { ReactElement, Ref } from 'react';
import type { FireObject, FireObjectOptions } from '../three.js';

type ObjectProps = Partial<Omit<ThreeElements['object3D'], 'ref' | 'args' | 'attach' | 'children'>>;

/** What a fire starts with; its `values` change it later, too. */
export interface FireProps extends Omit<FireObjectOptions, 'depthTexture'>, ObjectProps {
  /** The class of the fire: that of `hearth-fire/three` without it, or that of `hearth-fire/three/webgpu`. */
  type?: typeof FireObject;
  /** Wind in the world [m/s]. */
  wind?: [x: number, y: number, z: number];
  /** Depth of the scene without the fire, for soft edges at things. */
  depthTexture?: FireObjectOptions['depthTexture'];
  /** A value is refused, or there is no fire. */
  onError?: (error: Error) => void;
  /** The fire. */
  ref?: Ref<FireObject>;
}

/** A fire in a scene. */
export function Fire(props: FireProps): ReactElement | null;
