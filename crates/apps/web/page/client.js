// Calls to the core in a worker, as promises. A call is cancelled by ending its worker; the next one starts another.

/** The error of a call whose worker was ended. */
export class Cancelled extends Error {}

/** The refusal of a request by the core, in its words. */
export class Refused extends Error {
  /** @param {{ message: string, file: string | null, option: string | null }} refusal */
  constructor(refusal) {
    super(refusal.message);
    this.file = refusal.file;
    this.option = refusal.option;
  }
}

/** @typedef {{ phase: string, done: number, steps: number }} Step */

/** The core that workers run: that of the first visit, or the one that reads every format. */
let core = "truearea";
/** The compiled core, which all workers share. @type {Promise<WebAssembly.Module> | null} */
let compiled = null;

/** Loads and compiles the core, once. */
function compiledCore() {
  compiled ??= compile(new URL(`./${core}_bg.wasm`, import.meta.url));
  return compiled;
}

/** Lets workers that start from now on read every format. Returns true if they did not before. */
export function useAllFormats() {
  const isNew = core !== "truearea_all";
  if (isNew) compiled = null;
  core = "truearea_all";
  return isNew;
}

/** @param {URL} url */
async function compile(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`The core could not be loaded (${response.status}).`);
  // A server that sends another type than application/wasm keeps the browser from compiling while it loads.
  const streams = response.headers.get("content-type") === "application/wasm";
  return streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

export class Client {
  /** Started by the first call. @type {Worker | null} */ #worker = null;
  /** @type {Map<number, { resolve: (value: any) => void, reject: (error: Error) => void }>} */ #calls = new Map();
  /** @type {{ name: string, file: File }[]} */ #files = [];
  #last = 0;
  /** Memory that the core has taken. */
  bytes = 0;

  /** @param {(step: Step) => void} onProgress */
  constructor(onProgress = () => {}) {
    this.onProgress = onProgress;
  }

  /** Starts the worker, unless it runs. */
  start() {
    if (this.#worker) return this.#worker;
    const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    this.#worker = worker;
    worker.onmessage = ({ data }) => {
      if (data.progress) {
        this.onProgress(data.progress);
        return;
      }
      const call = this.#calls.get(data.id);
      this.#calls.delete(data.id);
      if (!call) return;
      if (data.error === undefined) {
        this.bytes = data.bytes;
        call.resolve(data.reply);
      } else {
        // The core does not go on after a panic, as when memory runs out.
        call.reject(new Error(`The computation ended early (${data.error}). Leave out large files and try again.`));
        this.end();
      }
    };
    worker.onerror = (event) => this.#fail(event.message || "The worker could not start.");
    const glue = `./${core}.js`;
    compiledCore().then((compiled) => worker.postMessage({ compiled, glue }), (error) => this.#fail(error.message));
    if (this.#files.length > 0) worker.postMessage({ files: this.#files });
    return worker;
  }

  /** Ends all calls with an error. */
  #fail(/** @type {string} */ words) {
    for (const call of this.#calls.values()) call.reject(new Error(words));
    this.#calls.clear();
  }

  /**
   * Gives the worker the files of the page.
   * @param {{ name: string, file: File }[]} files
   */
  setFiles(files) {
    this.#files = files;
    this.#worker?.postMessage({ files });
  }

  /** Returns true while a call runs. */
  get isBusy() {
    return this.#calls.size > 0;
  }

  /** Ends all calls with the worker, which gives its memory back; the next call starts another. */
  end() {
    this.#worker?.terminate();
    this.#worker = null;
    this.bytes = 0;
    for (const call of this.#calls.values()) call.reject(new Cancelled());
    this.#calls.clear();
  }

  /**
   * Calls a function of the core that takes a request, or its text, and returns its answer or a refusal.
   * @param {string} call
   * @param {unknown} request
   * @param {...unknown} args
   * @returns {Promise<any>}
   */
  async ask(call, request, ...args) {
    this.#last += 1;
    const id = this.#last;
    const text = typeof request === "string" ? request : JSON.stringify(request);
    const reply = await new Promise((resolve, reject) => {
      this.#calls.set(id, { resolve, reject });
      this.start().postMessage({ id, call, args: [text, ...args] });
    });
    if ("refused" in reply) throw new Refused(reply.refused);
    return reply.ok;
  }
}
