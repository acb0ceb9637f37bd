// The page: its state, its controls, and what the core answers.

import { Cancelled, Client, Refused } from "./client.js";
import { document_of, offer, png_of } from "./download.js";
import { chosen, dropped } from "./files.js";
import { mapElement } from "./map.js";
import { parsedLink, stateLink } from "./link.js";

/** @typedef {Record<string, string | null>} Body */
/** @typedef {{ name: string, bytes: number, options: Record<string, string>, kind: string, file: File | null, sight: any }} PageFile */

/** The properties of a body: their keys, labels and examples. */
const PROPERTIES = [
  ["youngs_modulus", "Young's modulus", "210 GPa"],
  ["poisson_ratio", "Poisson's ratio", "0.3"],
  ["yield_strength", "Yield strength", "1.8 GPa"],
  ["indentation_hardness", "Indentation hardness", "6 GPa"],
  ["strain_gradient_length", "Strain-gradient length", "5 um"],
];

/** The options of a scan: their keys, labels and examples. */
const OPTIONS = [
  ["unit", "Unit", "um"],
  ["size", "Size along the lines", "100 um"],
  ["tip-radius", "Tip radius", "2 um, or auto"],
  ["shortest", "Shortest wavelength trusted", "1 um"],
  ["instrument", "Instrument", "stylus"],
  ["channel", "Channel", "Height"],
];

/** Options of a scan with few values. */
const CHOICES = [
  ["direction", "Direction", ["", "x", "y", "both"]],
  ["gaps", "Missing points", ["", "harmonic", "lines", "refuse"]],
];

/** How long nothing may change before boundary elements begin [ms]. */
const PAUSE_MS = 400;

const state = {
  /** @type {string | null} */ example: null,
  /** @type {PageFile[]} */ files: [],
  /** @type {Body | null} */ material: null,
  /** @type {Body | null} */ counterface: null,
  /** @type {string | null} */ pressure: null,
  /** @type {string | null} */ shortest: null,
  seal: false,
  /** @type {Record<string, boolean>} */ drawn: {},
};

/**
 * @template {HTMLElement} [T=HTMLElement]
 * @param {string} id
 * @returns {T}
 */
const by = (id) => /** @type {T} */ (document.getElementById(id));
const input = (/** @type {string} */ id) => /** @type {HTMLInputElement} */ (by(id));
const select = (/** @type {string} */ id) => /** @type {HTMLSelectElement} */ (by(id));

const desk = new Client();
const bench = new Client(showProgress);

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
/** The rows of the table of models. */
let shownOrder = "";

// ---- State and request ------------------------------------------------------------------------------------------------

/** The request of the state, as the core reads it. */
function request() {
  const files = state.example ? [] : state.files.map(({ name, bytes, options, kind }) => ({ name, bytes, options, kind }));
  return {
    example: state.example,
    files,
    material: state.material,
    counterface: state.counterface,
    pressure: state.pressure,
    shortest_wavelength: state.shortest,
    seal: state.seal,
  };
}

const hasSurface = () => state.example !== null || state.files.some((file) => file.kind !== "other" && !file.sight?.refusal);

/** A file lacks what only a person knows. */
const lacking = () => state.files.find((file) => file.sight?.refusal?.option);

/** Says what goes on, to people and to scripts. */
function say(/** @type {"idle" | "working" | "done" | "error"} */ what, /** @type {string} */ words) {
  const status = by("status");
  status.dataset.state = what;
  status.dataset.bytes = String(desk.bytes + bench.bytes);
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

function stopBench() {
  clearTimeout(pause);
  round += 1;
  if (bench.isBusy) bench.restart();
  showWorking(false);
}

async function judge() {
  round += 1;
  const own = round;
  say("working", "Closed forms are done. Boundary elements …");
  showWorking(true);
  try {
    const first = await bench.ask("judge", request(), false);
    showScreen(first.screen);
    if (first.may_widen) {
      say("working", "Verdicts are done. Uncertainty of scans and bodies …");
      showScreen((await bench.ask("judge", request(), true)).screen);
    }
    say("done", `Done: ${plain(by("answer").querySelector(".number"))} at ${screen_.load}.`);
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
  by("spectrum").innerHTML = found.spectrum;
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
  fill(by("hangs-on"), found.hangs_on);
  fill(by("cautions"), found.cautions);
  fill(by("interface"), found.interface);
  fill(by("figure-main"), found.figure ?? "");
  showModels(found.models, first);
  drawLines();
}

/** Markup that each element holds, so that only what changes is laid out again. @type {WeakMap<Element, string>} */
const filled = new WeakMap();

function fill(/** @type {HTMLElement} */ element, /** @type {string} */ markup) {
  if (filled.get(element) === markup) return;
  filled.set(element, markup);
  element.innerHTML = markup;
}

function isDrawn(/** @type {any} */ model) {
  return state.drawn[model.key] ?? model.is_drawn;
}

/** Rows that stay in place while only their numbers change, so that focus and sliders are not disturbed. */
function showModels(/** @type {any[]} */ models, /** @type {boolean} */ isFirst) {
  const table = by("models");
  const order = models.map((model) => `${model.key} ${model.reference ?? ""}`).join("\n");
  if (!isFirst && order === shownOrder && models.every((model) => !model.verdict)) {
    for (const model of models) fillArea(/** @type {HTMLElement} */ (table.querySelector(`[data-testid="area-${model.key}"]`)), model);
    return;
  }
  shownOrder = order;
  const kept = document.activeElement?.closest("#models") ? document.activeElement.getAttribute("data-testid") : null;
  const head = row("thead", ["model", "area", models.some((model) => model.verdict) ? "÷ elements" : ""]);
  /** @type {HTMLTableSectionElement | null} */
  let body = null;
  const sections = [];
  let reference = "";
  for (const model of models) {
    if (body === null || (model.reference ?? "") !== reference) {
      reference = model.reference ?? "";
      body = document.createElement("tbody");
      sections.push(body);
      if (reference) {
        const group = document.createElement("tr");
        group.className = "group";
        group.innerHTML = "<th colspan=3 scope=rowgroup></th>";
        /** @type {HTMLElement} */ (group.firstElementChild).textContent = reference;
        body.append(group);
      }
    }
    body.append(modelRow(model));
  }
  table.replaceChildren(head, ...sections);
  if (kept && !isFirst) /** @type {HTMLElement | null} */ (table.querySelector(`[data-testid="${kept}"]`))?.focus();
}

function fillArea(/** @type {HTMLElement} */ cell, /** @type {any} */ model) {
  cell.dataset.value = model.area_fraction === null ? "" : String(model.area_fraction);
  cell.textContent = model.area ?? "none";
}

function row(/** @type {string} */ section, /** @type {string[]} */ words) {
  const head = document.createElement(section);
  const line = document.createElement("tr");
  for (const word of words) {
    const cell = document.createElement(word ? "th" : "td");
    if (word) cell.setAttribute("scope", "col");
    cell.textContent = word;
    line.append(cell);
  }
  head.append(line);
  return head;
}

function modelRow(/** @type {any} */ model) {
  const line = document.createElement("tr");
  const name = document.createElement("th");
  name.setAttribute("scope", "row");
  const label = document.createElement("label");
  const box = Object.assign(document.createElement("input"), { type: "checkbox", checked: isDrawn(model) });
  box.dataset.testid = `model-${model.key}`;
  box.addEventListener("change", () => {
    state.drawn[model.key] = box.checked;
    drawLines();
    keepLink();
  });
  const key = document.createElement("span");
  key.className = "key line";
  key.style.setProperty("--light", model.colour);
  key.style.setProperty("--dark", model.dark_colour);
  label.title = model.in_words;
  label.append(box, key, model.name);
  name.append(label);
  const area = document.createElement("td");
  area.dataset.testid = `area-${model.key}`;
  fillArea(area, model);
  const verdict = document.createElement("td");
  verdict.dataset.testid = `verdict-${model.key}`;
  verdict.dataset.value = model.verdict ?? "";
  if (model.verdict) {
    verdict.className = `cell ${model.verdict}`;
    verdict.style.setProperty("--fill", model.fill.toFixed(2));
    verdict.tabIndex = 0;
    verdict.dataset.ratio = model.ratio === null ? "" : String(model.ratio);
    verdict.textContent = model.verdict_in_short;
    if (model.reason) {
      const reason = document.createElement("span");
      reason.className = "reason";
      reason.setAttribute("role", "tooltip");
      const who = document.createElement("strong");
      who.textContent = `${model.name}: `;
      reason.append(who, model.reason);
      verdict.append(reason);
    }
  }
  line.append(name, area, verdict);
  return line;
}

function drawLines() {
  for (const model of screen_?.models ?? []) {
    for (const element of by("figure-main").querySelectorAll(`.m${model.curve}`)) {
      /** @type {SVGElement} */ (element).style.display = isDrawn(model) ? "" : "none";
    }
  }
  const named = (screen_?.models ?? []).filter(isDrawn).length;
  by("figure-main").classList.toggle("crowded", named > 4);
}

// ---- Bodies -----------------------------------------------------------------------------------------------------------

function makeBodies() {
  for (const which of ["material", "counterface"]) {
    const list = select(which);
    for (const material of choices.materials) list.add(new Option(material.name, material.name));
    if (which === "counterface") list.add(new Option("own values", "own"));
    list.addEventListener("change", () => {
      for (const [key] of PROPERTIES) input(`${which}-${key}`).value = "";
      if (which === "material" ? list.value === "" : list.value === "own") {
        /** @type {HTMLDetailsElement} */ (by(`${which}-more`)).open = true;
        input(`${which}-${PROPERTIES[0][0]}`).focus();
        showSource(which);
        return;
      }
      takeBody(which);
    });
    for (const [key, words, example] of PROPERTIES) {
      const label = document.createElement("label");
      label.className = "field";
      const field = Object.assign(document.createElement("input"), { type: "text", id: `${which}-${key}`, placeholder: `as ${example}`, autocomplete: "off", spellcheck: false });
      field.dataset.testid = `${which}-${key.replaceAll("_", "-")}`;
      field.addEventListener("change", () => takeBody(which));
      label.append(words, field);
      by(`${which}-values`).append(label);
    }
  }
}

function takeBody(/** @type {string} */ which) {
  const name = select(which).value;
  /** @type {Body} */
  const body = { name: name === "" || name === "own" ? null : name };
  for (const [key] of PROPERTIES) body[key] = input(`${which}-${key}`).value.trim() || null;
  if (which === "material") state.material = body;
  else state.counterface = body;
  showSource(which);
  edited = null;
  keepLink();
  changed();
}

function fillBody(/** @type {string} */ which, /** @type {Body} */ body) {
  const list = select(which);
  const isEmpty = Object.values(body).every((value) => value === null);
  const known = choices.materials.some((/** @type {any} */ material) => material.name === body.name);
  if (known) list.value = /** @type {string} */ (body.name);
  else list.value = which === "counterface" && !isEmpty ? "own" : "";
  for (const [key] of PROPERTIES) {
    const field = input(`${which}-${key}`);
    if (document.activeElement !== field) field.value = body[key] ?? "";
  }
  showSource(which);
}

function showSource(/** @type {string} */ which) {
  const found = choices.materials.find((/** @type {any} */ material) => material.name === select(which).value);
  by(`${which}-source`).textContent = found ? `${found.values} (${found.sources})` : "";
}

// ---- Files ------------------------------------------------------------------------------------------------------------

async function take(/** @type {import("./files.js").Named[]} */ found) {
  if (found.length === 0) return;
  if (state.example !== null) {
    state.example = null;
    select("example").value = "";
    state.material = null;
    state.counterface = null;
  }
  state.material ??= { name: select("material").value || choices.materials[0].name };
  state.counterface ??= {};
  for (const { name, file } of found) {
    const known = state.files.find((one) => one.name === name);
    if (known) Object.assign(known, { file, bytes: file.size, sight: null });
    else state.files.push({ name, bytes: file.size, options: {}, kind: "scan", file, sight: null });
  }
  opened = null;
  await lookAtFiles();
}

function giveFiles() {
  const given = state.files.filter((file) => file.file).map(({ name, file }) => ({ name, file: /** @type {File} */ (file) }));
  desk.setFiles(given);
  bench.setFiles(given);
}

async function lookAtFiles() {
  stopBench();
  asked += 1;
  giveFiles();
  for (const file of [...state.files]) {
    if (file.sight !== null || !file.file) continue;
    say("working", `Reading ${file.name} …`);
    try {
      file.sight = await desk.ask("look", { name: file.name, bytes: file.bytes, options: file.options, kind: file.kind });
      file.kind = file.sight.kind;
    } catch (error) {
      file.sight = { words: "", map: null, line: null, refusal: { message: /** @type {Error} */ (error).message, option: null } };
      file.kind = "other";
    }
    showFiles();
  }
  if (state.files.some((file) => file.kind === "scene") && state.files.every((file) => Object.keys(file.options).length === 0)) {
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

/** The names of files whose options are shown. @type {Set<string>} */
const unfolded = new Set();

function showFiles() {
  const kept = document.activeElement?.id ?? "";
  by("file-list").replaceChildren(...state.files.map(fileItem));
  if (kept) document.getElementById(kept)?.focus();
}

function fileItem(/** @type {PageFile} */ file, /** @type {number} */ at) {
  const item = document.createElement("li");
  item.className = "file";
  const head = document.createElement("div");
  head.className = "file-head";
  const name = document.createElement("strong");
  name.textContent = file.name;
  const remove = Object.assign(document.createElement("button"), { type: "button", textContent: "Remove" });
  remove.setAttribute("aria-label", `Remove ${file.name}`);
  remove.addEventListener("click", () => {
    state.files.splice(state.files.indexOf(file), 1);
    showFiles();
    lookAtFiles();
    input("files").focus();
  });
  head.append(name, remove);
  item.append(head);
  const sight = file.sight;
  if (!file.file) {
    const words = document.createElement("p");
    words.className = "error";
    words.textContent = "A link holds no files: drop this one again.";
    item.append(words);
  }
  if (sight?.refusal) {
    const words = document.createElement("p");
    words.className = "error";
    words.dataset.testid = "file-error";
    words.textContent = sight.refusal.message;
    item.append(words);
    if (sight.refusal.option) item.append(option(file, at, OPTIONS.find(([key]) => key === sight.refusal.option) ?? OPTIONS[0], "needed"));
  }
  if (sight?.map) item.append(mapElement(sight.map, file.name));
  if (sight?.line) {
    const figure = document.createElement("figure");
    figure.className = "figures profile";
    figure.dataset.testid = "map";
    figure.innerHTML = sight.line;
    item.append(figure);
  }
  if (sight?.words) {
    const words = document.createElement("p");
    words.className = "words";
    words.textContent = sight.words.trim().split("\n").slice(sight.kind === "scan" ? 1 : 0).map((/** @type {string} */ line) => line.trim()).join("\n");
    item.append(words);
  }
  if (file.kind === "scan" && sight && !(sight.refusal && !sight.refusal.option)) {
    const more = document.createElement("details");
    const title = document.createElement("summary");
    title.textContent = "Unit, tip, direction …";
    more.open = unfolded.has(file.name);
    more.addEventListener("toggle", () => (more.open ? unfolded.add(file.name) : unfolded.delete(file.name)));
    const grid = document.createElement("div");
    grid.className = "grid";
    const others = OPTIONS.filter(([key]) => key !== sight.refusal?.option);
    grid.append(...others.map((entry) => option(file, at, entry, "")), ...CHOICES.map((entry) => option(file, at, entry, "")));
    more.append(title, grid);
    item.append(more);
  }
  return item;
}

function option(/** @type {PageFile} */ file, /** @type {number} */ at, /** @type {any[]} */ [key, words, example], /** @type {string} */ className) {
  const label = document.createElement("label");
  label.className = `field ${className}`;
  /** @type {HTMLInputElement | HTMLSelectElement} */
  let field;
  if (Array.isArray(example)) {
    field = document.createElement("select");
    for (const value of example) field.add(new Option(value || "as usual", value));
  } else {
    field = Object.assign(document.createElement("input"), { type: "text", placeholder: `as ${example}`, autocomplete: "off", spellcheck: false });
  }
  field.id = `file-${at}-${key}`;
  field.dataset.testid = `file-${key}`;
  field.value = file.options[key] ?? "";
  field.addEventListener("change", () => {
    if (field.value.trim()) file.options[key] = field.value.trim();
    else delete file.options[key];
    file.sight = null;
    opened = null;
    lookAtFiles();
  });
  label.append(words, field);
  return label;
}

// ---- Conditions -------------------------------------------------------------------------------------------------------

/** A pressure with three digits, as a person types it. */
function pressureText(/** @type {number} */ pressure_pa) {
  for (const [unit, one] of /** @type {[string, number][]} */ ([["GPa", 1e9], ["MPa", 1e6], ["kPa", 1e3]])) {
    if (pressure_pa >= 0.9995 * one) return `${Number((pressure_pa / one).toPrecision(3))} ${unit}`;
  }
  return `${Number(pressure_pa.toPrecision(3))} Pa`;
}

function placeShortest() {
  const slider = input("shortest-slider");
  const wavelengths = /** @type {number[]} */ (opened?.wavelengths_m ?? []);
  let at = wavelengths.length - 1;
  const typed = Number.parseFloat(state.shortest ?? "");
  if (state.shortest?.endsWith(" m") && typed > 0) at = wavelengths.findLastIndex((wavelength) => wavelength >= typed * (1 - 1e-12));
  slider.value = String(Math.max(at, 0));
  slider.setAttribute("aria-valuetext", state.shortest === null ? "all of the spectrum" : opened?.wavelengths[Math.max(at, 0)] ?? "");
}

function listen() {
  input("pressure-slider").addEventListener("input", () => {
    state.pressure = pressureText(10 ** Number(input("pressure-slider").value));
    input("pressure").value = state.pressure;
    edited = "pressure";
    changed();
  });
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
  for (const id of ["pressure-slider", "shortest-slider"]) input(id).addEventListener("change", keepLink);
  input("seal").addEventListener("change", () => {
    state.seal = input("seal").checked;
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
  input("files").addEventListener("change", () => {
    const found = chosen(/** @type {FileList} */ (input("files").files));
    input("files").value = "";
    take(found);
  });
  by("controls").addEventListener("submit", (event) => event.preventDefault());
  const drop = by("drop");
  for (const kind of ["dragenter", "dragover"]) {
    document.addEventListener(kind, (event) => {
      event.preventDefault();
      drop.classList.add("over");
    });
  }
  document.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) drop.classList.remove("over");
  });
  document.addEventListener("drop", async (event) => {
    event.preventDefault();
    drop.classList.remove("over");
    if (event.dataTransfer) take(await dropped(event.dataTransfer));
  });
  by("cancel").addEventListener("click", () => {
    stopBench();
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
    const made = await bench.ask("report", request(), date);
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
  history.replaceState(null, "", stateLink({ ...request(), files: state.files.map(({ name, options }) => ({ name, options })), drawn: state.drawn }));
}

function fromLink() {
  const found = parsedLink(location.hash);
  if (!found) return;
  state.example = found.example ?? null;
  state.files = (found.files ?? []).map((/** @type {any} */ file) => ({ name: String(file.name), bytes: 0, options: file.options ?? {}, kind: "scan", file: null, sight: null }));
  state.material = found.material ?? null;
  state.counterface = found.counterface ?? null;
  state.pressure = found.pressure ?? null;
  state.shortest = found.shortest_wavelength ?? null;
  state.seal = found.seal === true;
  state.drawn = found.drawn ?? {};
  select("example").value = state.example ?? "";
  input("pressure").value = state.pressure ?? input("pressure").value;
  input("shortest").value = state.shortest ?? "";
  input("seal").checked = state.seal;
  if (state.material) fillBody("material", { ...state.material });
  if (state.counterface) fillBody("counterface", { ...state.counterface });
  showFiles();
  if (state.example) changed();
  else if (state.files.length > 0) say("idle", `The link was made with ${state.files.map((file) => file.name).join(", ")}: drop these files again.`);
}

async function begin() {
  listen();
  choices = JSON.parse(await desk.text("choices"));
  for (const { key, title } of choices.examples) select("example").add(new Option(title, key));
  makeBodies();
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
