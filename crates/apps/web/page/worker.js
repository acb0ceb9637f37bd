// A worker that loads the core once and answers one call after another.

import init, * as core from "./truearea.js";
import { onProgress, setFiles } from "./bridge.js";

const ready = init({ module_or_path: new URL("./truearea_bg.wasm", import.meta.url) });
onProgress((phase, done, steps) => postMessage({ progress: { phase, done, steps } }));

/** @param {MessageEvent} event */
onmessage = async (event) => {
  const { id, call, args, files } = event.data;
  if (files) {
    setFiles(files);
    return;
  }
  try {
    const { memory } = /** @type {any} */ (await ready);
    const reply = /** @type {any} */ (core)[call](...args);
    postMessage({ id, reply, bytes: memory.buffer.byteLength });
  } catch (error) {
    postMessage({ id, error: String(error) });
  }
};
