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

/**
 * Reads a reply of the core here, where that stops nobody: long lists of numbers become arrays that move without a copy,
 * and a map to press stays text, as the core reads it again.
 * @param {string} reply
 */
function read(reply) {
  const found = JSON.parse(reply);
  const moved = [];
  const { ok } = found;
  for (const map of [ok?.map, ok?.heights]) {
    if (!map?.heights) continue;
    map.heights = Uint16Array.from(map.heights);
    moved.push(map.heights.buffer);
  }
  if (ok?.states) {
    ok.states = Uint8Array.from(ok.states);
    moved.push(ok.states.buffer);
  }
  if (ok?.question) {
    ok.name = ok.question.name;
    ok.question = JSON.stringify(ok.question);
  }
  return { found, moved };
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
    const { found, moved } = read(core[call](...args));
    postMessage({ id, reply: found, bytes: memory.buffer.byteLength }, { transfer: moved });
  } catch (error) {
    postMessage({ id, error: String(error) });
  }
};
