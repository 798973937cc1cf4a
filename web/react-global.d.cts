// React's types as the page has them. An import of `react` begins in the folder of this file, where a linked package and
// a strict package manager have none.
import GlobalReact = globalThis.React;
export = GlobalReact;
