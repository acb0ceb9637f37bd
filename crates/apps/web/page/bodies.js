// The two bodies: chosen from materials with their sources, or typed.

import { by, input, select, state } from "./page.js";

/** @typedef {import("./page.js").Body} Body */

/** The properties of a body: their keys, labels and examples. */
const PROPERTIES = [
  ["youngs_modulus", "Young's modulus", "210 GPa"],
  ["poisson_ratio", "Poisson's ratio", "0.3"],
  ["yield_strength", "Yield strength", "1.8 GPa"],
  ["indentation_hardness", "Indentation hardness", "6 GPa"],
  ["strain_gradient_length", "Strain-gradient length", "5 um"],
];

/** Called after a body has changed. */
let onChange = () => {};

/** The materials, with sources. @type {any[]} */
let materials = [];

/**
 * Makes the lists of materials, and the fields for values.
 * @param {any[]} known
 * @param {() => void} changed
 */
export function makeBodies(known, changed) {
  materials = known;
  onChange = changed;
  for (const which of ["material", "counterface"]) {
    const list = select(which);
    for (const material of materials) list.add(new Option(material.name, material.name));
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
  onChange();
}

export function fillBody(/** @type {string} */ which, /** @type {Body} */ body) {
  const list = select(which);
  const isEmpty = Object.values(body).every((value) => value === null);
  const known = materials.some((/** @type {any} */ material) => material.name === body.name);
  if (known) list.value = /** @type {string} */ (body.name);
  else list.value = which === "counterface" && !isEmpty ? "own" : "";
  for (const [key] of PROPERTIES) {
    const field = input(`${which}-${key}`);
    if (document.activeElement !== field) field.value = body[key] ?? "";
  }
  showSource(which);
}

export function showSource(/** @type {string} */ which) {
  const found = materials.find((/** @type {any} */ material) => material.name === select(which).value);
  by(`${which}-source`).textContent = found ? `${found.values} (${found.sources})` : "";
}
