/** Saves a file. @type {(blob: Blob, name: string) => void} */
export function download(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The download has begun by then, even if the browser asks first.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
