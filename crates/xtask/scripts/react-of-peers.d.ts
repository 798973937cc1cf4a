/** What `hearth-fire/three/react` takes of React, whose own types `packaging/` compiles with. */

declare module 'react' {
  export type ReactElement = object;
  export type Ref<T> = ((instance: T | null) => void) | { current: T | null } | null;
  export function createElement(type: string, props: object): ReactElement;
  export function useEffect(effect: () => (() => void) | void, needs: unknown[]): void;
  export function useRef<T>(value: T): { current: T };
  export function useState<T>(value: T): [T, (value: T) => void];
}
