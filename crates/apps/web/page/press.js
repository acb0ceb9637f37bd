// A measured map pressed as it was scanned: contact drawn over its heights, under the pressure of the page.

import { Cancelled, Client } from "./client.js";
import { packed } from "./map.js";
import { by, input, pressureText, request, select } from "./page.js";

/** Colours of points that touch, and of points that yield. */
const TOUCHING = packed([213, 94, 0]);
const YIELDING = packed([130, 20, 90]);

/** Made when a map is pressed first. @type {Client | null} */
let presser = null;
/** The names of the maps. @type {string[]} */
let maps = [];
/** The chosen map as the core gives it. @type {any} */
let chosen = null;
let isOn = false;
let isPressing = false;
let isStale = false;
let nominal_pressure_pa = 0;

/** Memory that pressing has taken. */
export const pressedBytes = () => presser?.bytes ?? 0;

/**
 * Lets maps be pressed.
 * @param {Client} desk
 * @param {(pressure: string) => void} takePressure
 */
export function listenToPress(desk, takePressure) {
  by("press").addEventListener("click", () => {
    isOn = true;
    press(desk);
  });
  select("press-which").addEventListener("change", () => {
    forget();
    if (isOn) press(desk);
  });
  input("press-pressure").addEventListener("input", () => takePressure(pressureText(10 ** Number(input("press-pressure").value))));
}

/**
 * Takes the maps of a surface that was read anew.
 * @param {Client} desk
 * @param {string[]} names
 */
export function showMaps(desk, names) {
  const isSame = JSON.stringify(names) === JSON.stringify(maps);
  maps = names;
  forget();
  by("press-section").hidden = maps.length === 0;
  if (isSame) {
    if (isOn) press(desk);
    return;
  }
  isOn = false;
  by("pressed").hidden = true;
  select("press-which").replaceChildren(...maps.map((name, at) => new Option(name, String(at))));
  by("press-choice").hidden = maps.length < 2;
  say("idle", "");
}

/** Ends what is being pressed, and forgets the map. */
function forget() {
  chosen = null;
  if (isPressing) presser?.end();
}

/**
 * Follows the pressure of the page.
 * @param {Client} desk
 * @param {number} pressure_pa
 * @param {string} words
 */
export function followPressure(desk, pressure_pa, words) {
  const hasMoved = nominal_pressure_pa !== pressure_pa;
  nominal_pressure_pa = pressure_pa;
  const slider = input("press-pressure");
  if (document.activeElement !== slider) slider.value = String(Math.log10(pressure_pa));
  slider.setAttribute("aria-valuetext", words);
  if (isOn && hasMoved) press(desk);
}

/** Says what goes on, to people and to scripts. */
function say(/** @type {string} */ what, /** @type {string} */ words) {
  by("press-status").dataset.state = what;
  by("press-status").textContent = words;
}

async function press(/** @type {Client} */ desk) {
  if (isPressing) {
    isStale = true;
    return;
  }
  isPressing = true;
  presser ??= new Client();
  let isCancelled = false;
  try {
    do {
      isStale = false;
      say("working", "Pressing …");
      chosen ??= await desk.ask("map", request(), Number(select("press-which").value || 0));
      show(await presser.ask("press", `{"question":${chosen.question},"nominal_pressure_pa":${nominal_pressure_pa}}`));
    } while (isStale);
  } catch (error) {
    isCancelled = error instanceof Cancelled;
    if (!isCancelled) {
      by("pressed").hidden = true;
      say("error", /** @type {Error} */ (error).message);
    } else if (!isStale) {
      say("idle", "");
    }
  }
  isPressing = false;
  if (isCancelled && isStale) press(desk);
}

function show(/** @type {any} */ found) {
  by("pressed").hidden = false;
  by("press-words").textContent = chosen.words;
  draw(/** @type {HTMLCanvasElement} */ (by("pressed-map")), chosen.heights, found.states);
  by("pressed-map").setAttribute("aria-label", `Contact at ${found.load} over the heights of ${chosen.name}: ${found.area} of the area touches`);
  by("pressed-area").dataset.value = String(found.area_fraction);
  by("pressed-area").textContent = `${found.area} touches at ${found.load}`;
  by("pressed-values").replaceChildren(...found.quantities.flatMap((/** @type {[string, string]} */ [name, value]) => {
    const [term, detail] = [document.createElement("dt"), document.createElement("dd")];
    term.textContent = name;
    detail.textContent = value;
    return [term, detail];
  }));
  by("press-yields").hidden = !found.states.includes(2);
  by("press-notes").replaceChildren(...found.notes.map((/** @type {string} */ note) => {
    const item = document.createElement("li");
    item.textContent = note;
    return item;
  }));
  say("done", "");
}

/**
 * Draws heights in grey, the highest white, and contact in colour.
 * @param {HTMLCanvasElement} canvas
 * @param {import("./map.js").MapHeights} map
 * @param {Uint8Array} states
 */
function draw(canvas, map, states) {
  canvas.width = map.columns;
  canvas.height = map.rows;
  canvas.style.aspectRatio = String(1 / map.aspect);
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const picture = context.createImageData(map.columns, map.rows);
  const pixels = new Uint32Array(picture.data.buffer);
  for (let point = 0; point < pixels.length; point += 1) {
    const grey = 40 + Math.round((map.heights[point] / 65534) * 215);
    pixels[point] = states[point] === 0 ? packed([grey, grey, grey]) : states[point] === 1 ? TOUCHING : YIELDING;
  }
  context.putImageData(picture, 0, 0);
}
