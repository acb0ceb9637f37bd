// The table of models: areas, verdicts, and which lines are drawn.

import { by, state } from "./page.js";

/** The models of the answer. @type {any[]} */
let shown = [];
/** The rows of the table of models. */
let shownOrder = "";

/** Called after a person chose which lines are drawn. */
let onChoice = () => {};

/** @param {() => void} take */
export function listenToModels(take) {
  onChoice = take;
}

/** True if the lines of a class are drawn. */
export function isLineDrawn(/** @type {string} */ line) {
  const model = shown.find(({ curve }) => `m${curve}` === line);
  return model === undefined || isDrawn(model);
}

function isDrawn(/** @type {any} */ model) {
  return state.drawn[model.key] ?? model.is_drawn;
}

/** Rows that stay in place while only their numbers change, so that focus and sliders are not disturbed. */
export function showModels(/** @type {any[]} */ models, /** @type {boolean} */ isFirst) {
  shown = models;
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
    onChoice();
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

export function drawLines() {
  for (const model of shown) {
    for (const element of by("figure-main").querySelectorAll(`.m${model.curve}`)) {
      /** @type {SVGElement} */ (element).style.display = isDrawn(model) ? "" : "none";
    }
  }
  const named = shown.filter(isDrawn).length;
  by("figure-main").classList.toggle("crowded", named > 4);
}
