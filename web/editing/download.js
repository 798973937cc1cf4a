/** Saves a file. @type {(blob: Blob, name: string) => void} */
export function download(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The download has begun by then, even if the browser asks first.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/**
 * Saves settings as a file with the name of a scene.
 * @type {(config: object | undefined, name?: string) => void}
 */
export function saveSettings(config, name = '') {
  const file = name.replace(/[^\p{L}\p{N} _-]+/gu, '').trim() || 'hearth';
  download(new Blob([JSON.stringify(config, null, 2)], { type: 'application/json' }), `${file}.json`);
}
