// The files of the page: what each is, what it lacks, and its options.

import { mapElement } from "./map.js";
import { by, input, state } from "./page.js";

/** @typedef {import("./page.js").PageFile} PageFile */

/** The options of a scan: their keys, labels and examples. */
const OPTIONS = [
  ["unit", "Unit", "um"],
  ["height-unit", "Unit of heights", "um"],
  ["size", "Size along the lines", "100 um"],
  ["tip-radius", "Tip radius", "2 um, or auto"],
  ["shortest", "Shortest wavelength trusted", "1 um"],
  ["instrument", "Instrument", "stylus"],
  ["channel", "Channel", "Height"],
];

/** Options of a scan with few values. */
const CHOICES = [
  ["direction", "Direction", ["", "x", "y", "both"]],
  ["detrend", "Trend subtracted", ["", "mean", "line", "plane"]],
  ["gaps", "Missing points", ["", "harmonic", "lines", "refuse"]],
];

/** Called after a file or an option of it has changed. */
let onChange = () => {};

/** @param {() => void} take */
export function listenToFiles(take) {
  onChange = take;
}

/** The names of files whose options are shown. @type {Set<string>} */
const unfolded = new Set();

export function showFiles() {
  const kept = document.activeElement?.id ?? "";
  const items = state.files.map(fileItem);
  for (const [list, isOther] of /** @type {[string, boolean][]} */ ([["file-list", false], ["other-file-list", true]])) {
    by(list).replaceChildren(...items.filter((_, at) => state.files[at].is_counterface === isOther));
  }
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
    onChange();
    input(file.is_counterface ? "files-other" : "files").focus();
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
    title.textContent = "Unit, tip, trend, direction …";
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
    onChange();
  });
  label.append(words, field);
  return label;
}
