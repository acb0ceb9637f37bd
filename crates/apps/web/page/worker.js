// A worker that is given the compiled core, and answers one call after another.

import { onProgress, setFiles } from "./bridge.js";

/** @type {(core: Promise<any>) => void} */
let begin;
/** The core, once it runs. @type {Promise<any>} */
const ready = new Promise((resolve) => (begin = resolve));
onProgress((phase, done, steps) => postMessage({ progress: { phase, done, steps } }));

/**
 * Starts the compiled core by the functions that were built with it.
 * @param {WebAssembly.Module} compiled
 * @param {string} glue
 */
async function start(compiled, glue) {
  const core = await import(glue);
  const { memory } = await core.default({ module_or_path: compiled });
  return { core, memory };
}

/** @param {MessageEvent} event */
onmessage = async (event) => {
  const { id, call, args, files, compiled, glue } = event.data;
  if (compiled) {
    begin(start(compiled, glue));
    return;
  }
  if (files) {
    setFiles(files);
    return;
  }
  try {
    const { core, memory } = await ready;
    const reply = core[call](...args);
    postMessage({ id, reply, bytes: memory.buffer.byteLength });
  } catch (error) {
    postMessage({ id, error: String(error) });
  }
};
