// The files of the page, and progress, as the core asks for them. Runs in a worker, where files are read when they are
// wanted, part by part, so that their bytes lie in memory once.

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
 * Returns the number of bytes of a file; nothing if there is none of this name.
 * @param {string} name
 */
export function fileSize(name) {
  return files.get(name)?.size;
}

/**
 * Reads the bytes of a file from an offset on into a part of the core's memory.
 * @param {string} name
 * @param {number} offset
 * @param {Uint8Array} into
 */
export function readPart(name, offset, into) {
  const file = /** @type {File} */ (files.get(name));
  // Only workers have this reader.
  const reader = new (/** @type {any} */ (globalThis).FileReaderSync)();
  into.set(new Uint8Array(reader.readAsArrayBuffer(file.slice(offset, offset + into.length))));
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
