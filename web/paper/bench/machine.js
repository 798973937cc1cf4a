/** The browser, the processors and the GPU, as far as the browser names them. */

/** Programs by their words in the user agent; the first one that matches counts. @type {[string, RegExp][]} */
const BROWSERS = [
  ['Edge', /Edg\/([\d.]+)/],
  ['Firefox', /Firefox\/([\d.]+)/],
  ['Chrome', /(?:Headless)?Chrome\/([\d.]+)/],
  ['Safari', /Version\/([\d.]+).*Safari/],
];

function browser() {
  for (const [name, pattern] of BROWSERS) {
    const version = pattern.exec(navigator.userAgent)?.[1];
    if (version) return `${name} ${version}`;
  }
  return 'an unknown browser';
}

function gpu() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return 'no WebGL2';
  const named = gl.getExtension('WEBGL_debug_renderer_info');
  const renderer = gl.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return String(renderer) || 'an unnamed GPU';
}

export function readMachine() {
  return { browser: browser(), processors: navigator.hardwareConcurrency, gpu: gpu() };
}
