// A map of heights in false colour, with a range of heights that takes all colours.

/** @typedef {{ columns: number, rows: number, aspect: number, heights: Uint16Array, range: string, range_m: number, colours: number[][] }} MapHeights */

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
  const counts = new Uint32Array(MISSING + 1);
  for (const level of map.heights) counts[level] += 1;
  const missing = counts[MISSING];
  const at = (/** @type {number} */ share) => levelAt(counts, share * (map.heights.length - missing)) / (MISSING - 1);
  const ends = [slider("Lowest colour", at(BEYOND)), slider("Highest colour", at(1 - BEYOND))];
  const caption = document.createElement("p");
  const paint = () => {
    const [low, high] = ends.map((end) => Number(end.querySelector("input")?.value) / 1000);
    draw(canvas, map, Math.min(low, high), Math.max(low, high));
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
 * Returns the level below which a number of points lie.
 * @param {Uint32Array} counts
 * @param {number} points
 */
function levelAt(counts, points) {
  let below = 0;
  let level = 0;
  while (level < MISSING - 1 && below + counts[level] < points) {
    below += counts[level];
    level += 1;
  }
  return level;
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
  const pixels = new Uint32Array(picture.data.buffer);
  const colours = Uint32Array.from(map.colours, packed);
  const grey = packed(GREY);
  const last = colours.length - 1;
  const scale = last / Math.max(high - low, 1e-9);
  for (let point = 0; point < pixels.length; point += 1) {
    const level = map.heights[point];
    const place = Math.round((level / (MISSING - 1) - low) * scale);
    pixels[point] = level === MISSING ? grey : colours[place < 0 ? 0 : place > last ? last : place];
  }
  context.putImageData(picture, 0, 0);
}

/** Returns a colour as canvases hold it, with red in the lowest byte. */
export function packed([red, green, blue] = GREY) {
  return ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0;
}
