/** The compiler of TypeScript, which is pinned in this folder, for the scripts of others. */
export { SyntaxKind } from 'typescript/unstable/ast';
export { API } from 'typescript/unstable/sync';
