// The files of the page, and progress, as the core asks for them. Runs in a worker, where files are read when they are
// wanted, so that no bytes stay in memory.

/** @type {Map<string, File>} */
const files = new Map();

/** @type {(phase: string, done: number, steps: number) => void} */
let listener = () => {};

/**
 * Takes the files of the page.
 * @param {{ name: string, file: File }[]} given
 */
export function setFiles(given) {
  files.clear();
  for (const { name, file } of given) files.set(name, file);
}

/**
 * Sets the listener of progress.
 * @param {(phase: string, done: number, steps: number) => void} take
 */
export function onProgress(take) {
  listener = take;
}

/**
 * Returns the bytes of a file; nothing if there is none of this name.
 * @param {string} name
 */
export function readFile(name) {
  const file = files.get(name);
  if (!file) return undefined;
  // Only workers have this reader.
  const reader = new (/** @type {any} */ (globalThis).FileReaderSync)();
  return new Uint8Array(reader.readAsArrayBuffer(file));
}

/** Returns the names of all files, a line each. */
export function fileNames() {
  return [...files.keys()].join("\n");
}

/**
 * Passes progress on.
 * @param {string} phase
 * @param {number} done
 * @param {number} steps
 */
export function progress(phase, done, steps) {
  listener(phase, done, steps);
}
