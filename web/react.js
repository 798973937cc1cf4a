// The element itself; what React adds is types, in react.d.ts.
export * from './hearth-fire.js';
