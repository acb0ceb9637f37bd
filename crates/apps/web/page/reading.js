// Values of a figure under the pointer, or under a cursor that the arrow keys move.

/** @typedef {{ class: string, name: string, points: [number, number, string][] }} Line */
/** @typedef {{ frame: [number, number, number, number], places: [number, string][], lines: Line[] }} Reading */

const SVG = "http://www.w3.org/2000/svg";
/** How far beyond its ends a line is still read, in units of the drawing. */
const BEYOND = 6;

export class Reader {
  /** @type {Reading | null} */ #reading = null;
  /** The place that is read, by index. @type {number | null} */ #at = null;
  #box = document.createElement("div");
  #spoken = document.createElement("p");

  /**
   * Reads values off a figure; lines of which `isShown` is false for their class are left out.
   * @param {HTMLElement} figure
   * @param {(line: string) => boolean} isShown
   */
  constructor(figure, isShown = () => true) {
    this.figure = figure;
    this.isShown = isShown;
    this.#box.className = "reading";
    this.#box.dataset.testid = `${figure.dataset.testid}-reading`;
    this.#box.setAttribute("aria-hidden", "true");
    this.#spoken.className = "spoken";
    this.#spoken.setAttribute("aria-live", "polite");
    figure.after(this.#spoken);
    figure.addEventListener("pointermove", (event) => this.#point(event));
    figure.addEventListener("pointerleave", () => this.#end());
    figure.addEventListener("blur", () => this.#end());
    figure.addEventListener("keydown", (event) => this.#key(event));
  }

  /**
   * Takes the values of the figure that is shown now.
   * @param {Reading | null} reading
   */
  set(reading) {
    this.#reading = reading;
    this.figure.tabIndex = reading ? 0 : -1;
    if (!reading) this.#at = null;
    this.show();
  }

  #end() {
    this.#at = null;
    this.show();
  }

  #point(/** @type {PointerEvent} */ event) {
    const svg = this.figure.querySelector("svg");
    const matrix = svg?.getScreenCTM();
    if (!this.#reading || !matrix) return;
    const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    const [left, top, right, bottom] = this.#reading.frame;
    const isInside = place.x >= left - BEYOND && place.x <= right + BEYOND && place.y >= top && place.y <= bottom;
    this.#at = isInside ? nearest(this.#reading.places, place.x) : null;
    this.show();
  }

  #key(/** @type {KeyboardEvent} */ event) {
    if (!this.#reading) return;
    const last = this.#reading.places.length - 1;
    const at = this.#at ?? last;
    const moves = /** @type {Record<string, number>} */ ({ ArrowLeft: this.#at === null ? last : at - 1, ArrowRight: at + 1, Home: 0, End: last });
    if (event.key === "Escape") this.#end();
    if (!(event.key in moves)) return;
    event.preventDefault();
    this.#at = Math.min(Math.max(moves[event.key], 0), last);
    this.#spoken.textContent = [this.show(), ...this.#values().map((value) => `${value.line.name} ${value.words}`)].join("; ");
  }

  /** The values at the place that is read, the largest first. */
  #values() {
    const { places, lines } = /** @type {Reading} */ (this.#reading);
    const x = places[/** @type {number} */ (this.#at)][0];
    const values = [];
    for (const line of lines) {
      const { points } = line;
      if (points.length === 0 || !this.isShown(line.class) || x < points[0][0] - BEYOND || x > points[points.length - 1][0] + BEYOND) continue;
      const [, y, words] = points[nearest(points, x)];
      values.push({ line, y, words });
    }
    return values.sort((one, other) => one.y - other.y);
  }

  /** Shows the values, or nothing, and returns the abscissa in print. */
  show() {
    this.figure.querySelector("g.cursor")?.remove();
    this.#box.remove();
    const svg = this.figure.querySelector("svg");
    if (!this.#reading || this.#at === null || !svg) return "";
    const [left, top, right, bottom] = this.#reading.frame;
    const [x, words] = this.#reading.places[Math.min(this.#at, this.#reading.places.length - 1)];
    const cursor = element("g", { class: "cursor", "aria-hidden": "true" });
    cursor.append(element("path", { d: `M${x} ${top}V${bottom}` }));
    const title = document.createElement("strong");
    title.textContent = words;
    const list = document.createElement("dl");
    for (const { line, y, words } of this.#values()) {
      const own = svg.querySelector(`.${line.class}`);
      const colours = own?.getAttribute("style") ?? "";
      cursor.append(element("circle", { class: "line", style: colours, cx: String(x), cy: String(y), r: "3.2" }));
      const name = document.createElement("dt");
      name.className = "line";
      name.setAttribute("style", colours);
      name.textContent = line.name;
      const value = document.createElement("dd");
      value.textContent = words;
      list.append(name, value);
    }
    svg.append(cursor);
    this.#box.replaceChildren(title, list);
    // Beside the cursor, on the side with more room.
    const share = (100 * x) / svg.viewBox.baseVal.width;
    const isLeft = x < 0.5 * (left + right);
    this.#box.style.left = isLeft ? `calc(${share}% + .8rem)` : "";
    this.#box.style.right = isLeft ? "" : `calc(${100 - share}% + .8rem)`;
    this.figure.append(this.#box);
    return words;
  }
}

/**
 * Returns the index of the point nearest to an abscissa; abscissas rise.
 * @param {readonly (readonly [number, ...unknown[]])[]} points
 * @param {number} x
 */
function nearest(points, x) {
  let at = points.findIndex((point) => point[0] >= x);
  if (at < 0) at = points.length - 1;
  return at > 0 && x - points[at - 1][0] < points[at][0] - x ? at - 1 : at;
}

/**
 * @param {string} name
 * @param {Record<string, string>} attributes
 */
function element(name, attributes) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}
