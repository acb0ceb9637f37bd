// The page: its state, its controls, and what the core answers.

import { fillBody, makeBodies, showSource } from "./bodies.js";
import { Cancelled, Client, Refused, useAllFormats } from "./client.js";
import { document_of, offer, png_of } from "./download.js";
import { listenToFiles, showFiles } from "./file-list.js";
import { chosen, dropped } from "./files.js";
import { parsedLink, stateLink } from "./link.js";
import { drawLines, isLineDrawn, listenToModels, showModels } from "./models.js";
import { by, input, pressureText, request, select, state } from "./page.js";
import { followPressure, listenToPress, pressedBytes, showMaps } from "./press.js";
import { Reader } from "./reading.js";

document.documentElement.dataset.started = "true";

/** How long nothing may change before boundary elements begin [ms]. */
const PAUSE_MS = 400;

/** Bytes of a file from which on two cores that hold its heights would take too much memory. */
const LARGE_BYTES = 2 ** 26;

/** Answers in closed forms. */
const desk = new Client(showProgress);
/** Computes elements, intervals and reports beside the desk. */
const helper = new Client(showProgress);
/** Looks at files, and is ended after that: a core keeps the memory that a large file took. */
const viewer = new Client();
const areaReader = new Reader(by("figure-main"), isLineDrawn);
const spectrumReader = new Reader(by("spectrum"));

/** @type {any} */
let choices = { materials: [], examples: [] };
/** @type {any} */
let opened = null;
/** @type {any} */
let screen_ = null;
let scene = "";
let asked = 0;
let isAsking = false;
let isStale = false;
let pause = 0;
let round = 0;

/** Returns the core that computes what takes long: the helper, or with a large file the desk, which holds it already. */
const bench = () => (state.files.some((file) => file.bytes >= LARGE_BYTES) ? desk : helper);

// ---- State -----------------------------------------------------------------------------------------------------------

const hasSurface = () => state.example !== null || state.files.some((file) => !file.is_counterface && file.kind !== "other" && !file.sight?.refusal);

/** A file lacks what only a person knows. */
const lacking = () => state.files.find((file) => file.sight?.refusal?.option);

/** Says what goes on, to people and to scripts. */
function say(/** @type {"idle" | "working" | "done" | "error"} */ what, /** @type {string} */ words) {
  const status = by("status");
  status.dataset.state = what;
  status.dataset.bytes = String(desk.bytes + helper.bytes + pressedBytes());
  if (status.textContent !== words) status.textContent = words;
}

function showError(/** @type {string} */ words) {
  by("error").textContent = words;
  by("error").hidden = words === "";
}

// ---- Answers ----------------------------------------------------------------------------------------------------------

/** Answers the state in closed forms, and with boundary elements once it rests. */
function changed() {
  asked += 1;
  stopBench();
  if (!hasSurface()) {
    showNothing();
    return;
  }
  if (isAsking) {
    isStale = true;
    return;
  }
  askDesk();
}

async function askDesk() {
  isAsking = true;
  isStale = false;
  const own = asked;
  say("working", "Closed forms …");
  try {
    const reply = await desk.ask("answer", request());
    scene = reply.scene;
    showError("");
    showFault("pressure", "");
    showFault("shortest", "");
    if (reply.opened) showOpened(reply.opened);
    if (reply.screen) showScreen(reply.screen);
    else throw new Error("The scene has no load with an area.");
    if (own === asked) judgeSoon();
  } catch (error) {
    if (own === asked) refuse(/** @type {Error} */ (error));
  } finally {
    isAsking = false;
    if (isStale) askDesk();
  }
}

function refuse(/** @type {Error} */ error) {
  if (error instanceof Cancelled) return;
  const quantity = opened && error instanceof Refused && !error.file;
  const field = quantity && edited ? edited : null;
  if (field) showFault(field, error.message);
  showError(field ? "" : describe(error));
  say("error", field ? `${by(field === "pressure" ? "pressure" : "shortest").getAttribute("data-testid")}: not understood` : "No answer: see the message.");
}

const describe = (/** @type {Error} */ error) =>
  error instanceof Refused && error.file && !error.message.startsWith(error.file) ? `${error.file}: ${error.message}` : error.message;

/** The field that was edited last. @type {"pressure" | "shortest" | null} */
let edited = null;

function showFault(/** @type {"pressure" | "shortest"} */ field, /** @type {string} */ words) {
  by(`${field}-error`).textContent = words;
  by(`${field}-error`).hidden = words === "";
  input(field).setAttribute("aria-invalid", String(words !== ""));
}

function judgeSoon() {
  clearTimeout(pause);
  pause = setTimeout(judge, PAUSE_MS);
}

/** Ends what the helper computes. The desk goes on, since it would have to read a large file again, and nobody sees its verdicts. */
function stopBench() {
  clearTimeout(pause);
  round += 1;
  if (helper.isBusy) helper.end();
  showWorking(false);
}

async function judge() {
  round += 1;
  const own = round;
  say("working", "Closed forms are done. Boundary elements …");
  showWorking(true);
  try {
    const first = await bench().ask("judge", request(), false);
    if (own !== round) return;
    showScreen(first.screen);
    if (first.may_widen) {
      say("working", "Verdicts are done. Uncertainty of scans and bodies …");
      const second = await bench().ask("judge", request(), true);
      if (own !== round) return;
      showScreen(second.screen);
    }
    say("done", `Done: ${plain(by("answer").querySelector(".number"))}.`);
  } catch (error) {
    if (error instanceof Cancelled || own !== round) return;
    showError(describe(/** @type {Error} */ (error)));
    say("error", "Boundary elements gave no verdict; closed forms stay.");
  } finally {
    if (own === round) showWorking(false);
  }
}

const plain = (/** @type {Element | null} */ element) => element?.textContent?.trim() ?? "";

function showWorking(/** @type {boolean} */ isWorking) {
  by("progress").hidden = !isWorking;
  by("cancel").hidden = !isWorking;
  if (isWorking) by("progress").removeAttribute("value");
}

/** @param {{ phase: string, done: number, steps: number }} step */
function showProgress({ done, steps }) {
  if (steps > 0) by("progress").setAttribute("value", String((100 * done) / steps));
}

// ---- The answer on the page -------------------------------------------------------------------------------------------

function showNothing() {
  const one = lacking();
  by("screen").hidden = true;
  by("welcome").hidden = false;
  opened = null;
  screen_ = null;
  if (one) say("idle", `${one.name} needs its ${one.sight.refusal.option}: fill it in beside the file.`);
  else if (state.files.length > 0 && state.files.every((file) => file.is_counterface)) say("idle", "Drop a scan of the first face as well.");
  else if (state.files.length > 0) say("error", "None of these files can be used: see the messages beside them.");
  else say("idle", "Drop a scan or take an example.");
}

function showOpened(/** @type {any} */ found) {
  opened = found;
  fillBody("material", state.material ?? found.material);
  fillBody("counterface", state.counterface ?? found.counterface);
  const slider = input("shortest-slider");
  slider.max = String(found.wavelengths_m.length - 1);
  slider.disabled = found.wavelengths_m.length < 2;
  placeShortest();
  by("title").textContent = found.title;
  by("spectrum").innerHTML = found.spectrum.figure;
  spectrumReader.set(found.spectrum.reading);
  by("spectrum").dataset.wavelengths = JSON.stringify(found.wavelengths_m);
  by("spectrum").dataset.value = JSON.stringify(found.c1d_m3);
  by("scans").textContent = found.scans;
  by("scans").hidden = found.scans === "";
  const warnings = found.notes.filter((/** @type {any} */ note) => note.is_warning).length;
  by("note-count").textContent = `${found.notes.length}${warnings ? `, ${warnings} to heed` : ""}`;
  by("notes").replaceChildren(...found.notes.map((/** @type {any} */ note) => {
    const item = document.createElement("li");
    item.textContent = (note.is_warning ? "Warning: " : "") + note.text;
    return item;
  }));
  by("notes-more").hidden = found.notes.length === 0;
  if (warnings) /** @type {HTMLDetailsElement} */ (by("notes-more")).open = true;
  showMaps(desk, found.maps);
}

function showScreen(/** @type {any} */ found) {
  const first = screen_ === null;
  screen_ = found;
  by("welcome").hidden = true;
  by("screen").hidden = false;
  by("bodies").textContent = `${found.bodies ?? ""} at ${found.load}`;
  if (document.activeElement !== input("pressure")) input("pressure").value = found.load;
  const slider = input("pressure-slider");
  if (document.activeElement !== slider) slider.value = String(Math.log10(found.nominal_pressure_pa));
  slider.setAttribute("aria-valuetext", found.load);
  const answer = by("answer");
  fill(answer, found.best);
  answer.dataset.value = found.area_fraction === null ? "" : String(found.area_fraction);
  answer.dataset.low = String(found.low);
  answer.dataset.high = String(found.high);
  fill(by("contact"), found.contact ?? "");
  fill(by("other"), found.other_hardness);
  fill(by("cautions"), found.cautions);
  fill(by("interface"), found.interface);
  by("figure-title").textContent = found.figure_title ?? "";
  fill(by("figure-main"), found.figure ?? "");
  showModels(found.models, first);
  // Below the controls, as on a phone, nothing seems to happen.
  if (first && by("result").getBoundingClientRect().top > innerHeight / 2) by("result").scrollIntoView();
  drawLines();
  areaReader.set(found.reading);
  followPressure(desk, found.nominal_pressure_pa, found.load);
}

/** Markup that each element holds, so that only what changes is laid out again. @type {WeakMap<Element, string>} */
const filled = new WeakMap();

function fill(/** @type {HTMLElement} */ element, /** @type {string} */ markup) {
  if (filled.get(element) === markup) return;
  filled.set(element, markup);
  element.innerHTML = markup;
}

// ---- Files ------------------------------------------------------------------------------------------------------------

async function take(/** @type {import("./files.js").Named[]} */ found, isCounterface = false) {
  if (found.length === 0) return;
  // The core knows files by their names.
  const differs = (/** @type {File} */ one, /** @type {File} */ other) => one.size !== other.size || one.lastModified !== other.lastModified;
  const isTaken = (/** @type {import("./files.js").Named} */ { name, file }) => state.files.some((one) => one.name === name && one.is_counterface !== isCounterface && one.file && differs(one.file, file));
  const taken = found.find(isTaken);
  if (taken) {
    showError(`Both faces have a file ${taken.name}, and they differ: rename one of them.`);
    say("error", "No answer: see the message.");
    return;
  }
  if (state.example !== null && !isCounterface) {
    state.example = null;
    select("example").value = "";
    state.material = null;
    state.counterface = null;
  }
  if (state.example === null) {
    state.material ??= { name: select("material").value || choices.materials[0].name };
    state.counterface ??= {};
  }
  for (const { name, file } of found) {
    const known = state.files.find((one) => one.name === name && one.is_counterface === isCounterface);
    if (known) Object.assign(known, { file, bytes: file.size, sight: null });
    else state.files.push({ name, bytes: file.size, options: {}, kind: "scan", is_counterface: isCounterface, file, sight: null });
  }
  opened = null;
  await lookAtFiles();
}

function giveFiles() {
  const given = state.files.filter((file) => file.file).map(({ name, file }) => ({ name, file: /** @type {File} */ (file) }));
  for (const client of [desk, helper, viewer]) client.setFiles(given);
  if (bench() === desk) helper.end();
}

async function lookAtFiles() {
  stopBench();
  asked += 1;
  giveFiles();
  for (const file of [...state.files]) {
    if (file.sight !== null || !file.file) continue;
    say("working", `Reading ${file.name} …`);
    try {
      file.sight = await viewer.ask("look", { name: file.name, bytes: file.bytes, options: file.options, kind: file.kind, is_counterface: file.is_counterface });
      file.kind = file.sight.kind;
      if (file.sight.wants_all_formats && useAllFormats()) {
        say("working", "Loading the readers of all formats …");
        for (const client of [desk, helper, viewer]) client.end();
        // Also those that could be read: a file beside them may say more about them.
        for (const each of state.files) each.sight = null;
        await lookAtFiles();
        return;
      }
    } catch (error) {
      // Ended by files that need the other core; these are looked at again there.
      if (error instanceof Cancelled) return;
      file.sight = { words: "", map: null, line: null, refusal: { message: /** @type {Error} */ (error).message, option: null } };
      file.kind = "other";
    }
    showFiles();
  }
  if (!viewer.isBusy) viewer.end();
  if (state.files.some((file) => file.kind === "scene" && !file.is_counterface) && state.files.every((file) => Object.keys(file.options).length === 0)) {
    // A scene brings its own bodies and loads.
    state.material = null;
    state.counterface = null;
    state.pressure = null;
  }
  keepLink();
  const one = lacking();
  if (one) {
    showNothing();
    return;
  }
  changed();
}

// ---- Conditions -------------------------------------------------------------------------------------------------------

function placeShortest() {
  const slider = input("shortest-slider");
  const wavelengths = /** @type {number[]} */ (opened?.wavelengths_m ?? []);
  let at = wavelengths.length - 1;
  const typed = Number.parseFloat(state.shortest ?? "");
  if (state.shortest?.endsWith(" m") && typed > 0) at = wavelengths.findLastIndex((wavelength) => wavelength >= typed * (1 - 1e-12));
  slider.value = String(Math.max(at, 0));
  slider.setAttribute("aria-valuetext", state.shortest === null ? "all of the spectrum" : opened?.wavelengths[Math.max(at, 0)] ?? "");
}

/** Takes a pressure from a slider. */
function takePressure(/** @type {string} */ pressure) {
  state.pressure = pressure;
  input("pressure").value = pressure;
  edited = "pressure";
  changed();
}

function listen() {
  listenToFiles(() => {
    opened = null;
    lookAtFiles();
  });
  listenToModels(() => {
    areaReader.show();
    keepLink();
  });
  listenToPress(desk, takePressure);
  input("pressure-slider").addEventListener("input", () => takePressure(pressureText(10 ** Number(input("pressure-slider").value))));
  input("pressure").addEventListener("change", () => {
    state.pressure = input("pressure").value.trim() || null;
    edited = "pressure";
    keepLink();
    changed();
  });
  input("shortest-slider").addEventListener("input", () => {
    const at = Number(input("shortest-slider").value);
    const isAll = at >= opened.wavelengths_m.length - 1;
    state.shortest = isAll ? null : `${opened.wavelengths_m[at]} m`;
    input("shortest").value = isAll ? "" : opened.wavelengths[at];
    input("shortest-slider").setAttribute("aria-valuetext", isAll ? "all of the spectrum" : opened.wavelengths[at]);
    edited = "shortest";
    changed();
  });
  input("shortest").addEventListener("change", () => {
    state.shortest = input("shortest").value.trim() || null;
    edited = "shortest";
    placeShortest();
    keepLink();
    changed();
  });
  for (const id of ["pressure-slider", "shortest-slider", "press-pressure"]) input(id).addEventListener("change", keepLink);
  input("seal").addEventListener("change", () => {
    state.seal = input("seal").checked;
    keepLink();
    changed();
  });
  input("flatness").addEventListener("change", () => {
    state.flatness = input("flatness").value.trim() || null;
    keepLink();
    changed();
  });
  select("example").addEventListener("change", () => {
    state.example = select("example").value || null;
    state.material = null;
    state.counterface = null;
    state.pressure = null;
    state.shortest = null;
    input("shortest").value = "";
    state.files = [];
    opened = null;
    screen_ = null;
    showFiles();
    keepLink();
    changed();
  });
  for (const [id, isOther] of /** @type {[string, boolean][]} */ ([["files", false], ["files-other", true]])) {
    input(id).addEventListener("change", () => {
      const found = chosen(/** @type {FileList} */ (input(id).files));
      input(id).value = "";
      take(found, isOther);
    });
  }
  by("controls").addEventListener("submit", (event) => event.preventDefault());
  const [drop, other] = [by("drop"), by("drop-other")];
  const isOther = (/** @type {DragEvent} */ event) => other.contains(/** @type {Node} */ (event.target));
  for (const kind of ["dragenter", "dragover"]) {
    document.addEventListener(kind, (event) => {
      event.preventDefault();
      drop.classList.toggle("over", !isOther(/** @type {DragEvent} */ (event)));
      other.classList.toggle("over", isOther(/** @type {DragEvent} */ (event)));
    });
  }
  document.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) [drop, other].forEach((zone) => zone.classList.remove("over"));
  });
  document.addEventListener("drop", async (event) => {
    event.preventDefault();
    [drop, other].forEach((zone) => zone.classList.remove("over"));
    if (event.dataTransfer) take(await dropped(event.dataTransfer), isOther(event));
  });
  by("cancel").addEventListener("click", () => {
    stopBench();
    if (bench() === desk) desk.end();
    say("done", "Cancelled: closed forms stay, without verdicts of boundary elements.");
    input("pressure").focus();
  });
  by("download-scene").addEventListener("click", () => offer("scene.toml", scene));
  by("download-report").addEventListener("click", makeReport);
  by("copy-link").addEventListener("click", async () => {
    keepLink();
    try {
      await navigator.clipboard.writeText(location.href);
      say("done", "The link is copied. It holds everything but the files.");
    } catch {
      say("done", "Copy the address of this page: it holds everything but the files.");
    }
  });
  for (const [id, name] of [["figure", "area"], ["spectrum", "spectrum"]]) {
    const svg = () => /** @type {SVGSVGElement} */ (by(id === "figure" ? "figure-main" : "spectrum").querySelector("svg"));
    by(`${id}-svg`).addEventListener("click", () => offer(`${name}.svg`, document_of(svg()), "image/svg+xml"));
    by(`${id}-png`).addEventListener("click", async () => offer(`${name}.png`, await png_of(document_of(svg())), "image/png"));
  }
}

async function makeReport() {
  stopBench();
  const own = round;
  say("working", "Making the report: other choices, boundary elements, uncertainty …");
  showWorking(true);
  try {
    const date = `${new Date().toISOString().slice(0, 16).replace("T", " ")} UTC`;
    const made = await bench().ask("report", request(), date);
    if (own !== round) return;
    offer("report.html", made.find((/** @type {any} */ file) => file.name === "report.html").text, "text/html");
    by("product-list").replaceChildren(...made.map((/** @type {any} */ file) => {
      const item = document.createElement("li");
      const button = Object.assign(document.createElement("button"), { type: "button", textContent: file.name });
      button.addEventListener("click", () => offer(file.name, file.text));
      item.append(button);
      return item;
    }));
    by("products").hidden = false;
    say("done", `The report is saved; its ${made.length} files are listed below.`);
  } catch (error) {
    if (error instanceof Cancelled) return;
    showError(describe(/** @type {Error} */ (error)));
    say("error", "There is no report: see the message.");
  } finally {
    if (own === round) showWorking(false);
  }
}

// ---- Link -------------------------------------------------------------------------------------------------------------

function keepLink() {
  history.replaceState(null, "", stateLink({ ...request(), files: state.files.map(({ name, options, is_counterface }) => ({ name, options, is_counterface })), drawn: state.drawn }));
}

function fromLink() {
  const found = parsedLink(location.hash);
  if (found === null) say("error", "The link is damaged. The page starts empty: drop files, or take an example.");
  if (!found) return;
  state.example = found.example ?? null;
  state.files = (found.files ?? []).map((/** @type {any} */ file) => ({ name: String(file.name), bytes: 0, options: file.options ?? {}, kind: "scan", is_counterface: file.is_counterface === true, file: null, sight: null }));
  state.material = found.material ?? null;
  state.counterface = found.counterface ?? null;
  state.pressure = found.pressure ?? null;
  state.shortest = found.shortest_wavelength ?? null;
  state.seal = found.seal === true;
  state.flatness = found.flatness ?? null;
  state.drawn = found.drawn ?? {};
  select("example").value = state.example ?? "";
  input("pressure").value = state.pressure ?? input("pressure").value;
  input("shortest").value = state.shortest ?? "";
  input("seal").checked = state.seal;
  input("flatness").value = state.flatness ?? "";
  if (state.material) fillBody("material", { ...state.material });
  if (state.counterface) fillBody("counterface", { ...state.counterface });
  showFiles();
  if (state.example && state.files.length === 0) changed();
  else if (state.files.length > 0) say("idle", `The link was made with ${state.files.map((file) => file.name).join(", ")}: drop these files again.`);
}

async function begin() {
  listen();
  desk.start();
  choices = await (await fetch(new URL("./choices.json", import.meta.url))).json();
  for (const { key, title } of choices.examples) select("example").add(new Option(title, key));
  makeBodies(choices.materials, () => {
    edited = null;
    keepLink();
    changed();
  });
  select("material").value = choices.materials[0].name;
  showSource("material");
  by("program").textContent = choices.program;
  document.documentElement.dataset.ready = "true";
  fromLink();
  if ("serviceWorker" in navigator && location.protocol.startsWith("http")) {
    navigator.serviceWorker.register("offline.js").catch(() => {});
  }
}

begin().catch((error) => {
  showError(`The page could not start: ${error.message}`);
  say("error", "The page could not start.");
});
