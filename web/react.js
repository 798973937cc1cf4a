// The element; react.d.ts adds its types for React.
export * from './hearth-fire.js';
