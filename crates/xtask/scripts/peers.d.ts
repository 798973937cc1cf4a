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
  export class Mesh extends Any {}
  export class Object3D<Events = Object3DEventMap> extends Any {
    dispatchEvent(event: Events[keyof Events] & { type: keyof Events }): void;
  }
  export interface Object3DEventMap {}
  export class PointLight extends Any {}
  export class Points extends Any {}
  export class ShaderMaterial extends Any {}
  export class Sphere extends Any {}
  export class Texture extends Any {}
  export class Vector2 extends Any {}
  export class Vector3 extends Any {}
  export class Vector4 extends Any {}
  export const DoubleSide: number;
  export const LinearFilter: number;
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
