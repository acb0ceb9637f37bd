// A map of heights in false colour, with a range of heights that takes all colours.

/** @typedef {{ columns: number, rows: number, aspect: number, heights: number[], range: string, range_m: number, colours: number[][] }} MapHeights */

/** The level of a missing point. */
const MISSING = 65535;
/** The colour of a missing point. */
const GREY = [150, 150, 150];
/** The share of points at either end that take the first and the last colour at first. */
const BEYOND = 0.002;

/**
 * Returns an element with the map and two sliders for the range of its colours.
 * @param {MapHeights} map
 * @param {string} name
 */
export function mapElement(map, name) {
  const canvas = document.createElement("canvas");
  canvas.width = map.columns;
  canvas.height = map.rows;
  canvas.style.aspectRatio = String(1 / map.aspect);
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `heights of ${name}, ${map.range} from the lowest to the highest point`);
  const sorted = Uint16Array.from(map.heights.filter((level) => level !== MISSING)).sort();
  const at = (/** @type {number} */ share) => sorted[Math.round(share * (sorted.length - 1))] / 65534;
  const ends = [slider("Lowest colour", at(BEYOND)), slider("Highest colour", at(1 - BEYOND))];
  const caption = document.createElement("p");
  const paint = () => {
    const [low, high] = ends.map((end) => Number(end.querySelector("input")?.value) / 1000);
    draw(canvas, map, Math.min(low, high), Math.max(low, high));
    const missing = map.heights.length - sorted.length;
    caption.textContent = `${Math.round(100 * Math.min(low, high))} to ${Math.round(100 * Math.max(low, high))} % of ${map.range}${missing ? "; grey: missing" : ""}`;
  };
  ends.forEach((end) => end.addEventListener("input", paint));
  paint();
  const holder = document.createElement("div");
  holder.className = "map";
  holder.dataset.testid = "map";
  holder.append(canvas, caption, ...ends);
  return holder;
}

/**
 * @param {string} words
 * @param {number} share
 */
function slider(words, share) {
  const label = document.createElement("label");
  const input = Object.assign(document.createElement("input"), { type: "range", min: "0", max: "1000", value: String(Math.round(1000 * share)) });
  label.append(words, input);
  return label;
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {MapHeights} map
 * @param {number} low
 * @param {number} high
 */
function draw(canvas, map, low, high) {
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const picture = context.createImageData(map.columns, map.rows);
  const last = map.colours.length - 1;
  const scale = last / Math.max(high - low, 1e-9);
  map.heights.forEach((level, point) => {
    const colour = level === MISSING ? GREY : map.colours[Math.min(last, Math.max(0, Math.round((level / 65534 - low) * scale)))];
    picture.data.set(colour, 4 * point);
    picture.data[4 * point + 3] = 255;
  });
  context.putImageData(picture, 0, 0);
}
