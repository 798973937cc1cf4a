/** Engines of others, whose own types a user of the package has: `tests/consumers` compiles with them. */

declare module 'three' {
  class Any {
    constructor(...given: any[]);
    [member: string]: any;
  }
  export class BufferAttribute extends Any {}
  export class BufferGeometry extends Any {}
  export class Color extends Any {}
  export class DepthTexture extends Any {}
  export class InstancedBufferAttribute extends Any {}
  export class InstancedBufferGeometry extends Any {}
  export class Mesh extends Any {}
  export class Object3D<Events = Object3DEventMap> extends Any {
    dispatchEvent(event: Events[keyof Events] & { type: keyof Events }): void;
  }
  export interface Object3DEventMap {}
  export class PointLight extends Any {}
  export class ShaderMaterial extends Any {}
  export class Sphere extends Any {}
  export class Texture extends Any {}
  export class Vector2 extends Any {}
  export class Vector3 extends Any {}
  export class Vector4 extends Any {}
  export const CustomBlending: number;
  export const DoubleSide: number;
  export const LinearFilter: number;
  export const NoToneMapping: number;
  export const OneFactor: number;
  export const OneMinusSrcAlphaFactor: number;
  export const SrcColorFactor: number;
  export const ZeroFactor: number;
}

declare module 'three/webgpu' {
  export class NodeMaterial {}
}

declare module 'three/tsl' {
  export const attribute: any;
  export const cameraFar: any;
  export const cameraNear: any;
  export const cameraProjectionMatrix: any;
  export const cameraViewMatrix: any;
  export const clamp: any;
  export const cross: any;
  export const dot: any;
  export const exp: any;
  export const float: any;
  export const floor: any;
  export const fract: any;
  export const log: any;
  export const max: any;
  export const min: any;
  export const mix: any;
  export const mod: any;
  export const orthographicDepthToViewZ: any;
  export const perspectiveDepthToViewZ: any;
  export const positionGeometry: any;
  export const pow: any;
  export const select: any;
  export const sin: any;
  export const smoothstep: any;
  export const sqrt: any;
  export const step: any;
  export const texture: any;
  export const uniform: any;
  export const varying: any;
  export const vec2: any;
  export const vec3: any;
  export const vec4: any;
  export const viewportDepthTexture: any;
}

declare module '@react-three/fiber' {
  export function invalidate(): void;
  export interface ThreeElements {
    object3D: { [property: string]: unknown };
  }
}

declare module 'pixi.js' {
  class Any {
    constructor(...given: any[]);
    [member: string]: any;
  }
  export class ImageSource extends Any {}
  export class Sprite extends Any {}
  export class Texture extends Any {}
}

declare module 'phaser' {
  class Any {
    constructor(...given: any[]);
    [member: string]: any;
  }
  export class Scene extends Any {}
  export namespace GameObjects {
    class Image extends Any {}
  }
}
