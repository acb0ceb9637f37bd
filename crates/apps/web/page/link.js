// The state of the page in the fragment of its address, which browsers send to nobody.

/**
 * Returns the fragment for a state.
 * @param {unknown} state
 */
export function stateLink(state) {
  return `#${encodeURIComponent(JSON.stringify(state, (_, value) => (value === null ? undefined : value)))}`;
}

/** @typedef {(value: any) => boolean} Check */

/** @type {Check} */
const isText = (value) => typeof value === "string";
/** @type {Check} */
const isTruth = (value) => typeof value === "boolean";
/** @type {(check: Check) => Check} */
const isTableOf = (check) => (value) => typeof value === "object" && value !== null && !Array.isArray(value) && Object.values(value).every(check);
/** @type {Check} */
const isFile = (value) => isTableOf(() => true)(value) && isText(value.name) && (value.is_counterface === undefined || isTruth(value.is_counterface)) && (value.options === undefined || isTableOf(isText)(value.options));

/**
 * What each key of a state holds.
 * @type {Record<string, Check>}
 */
const KEYS = {
  example: isText, material: isTableOf(isText), counterface: isTableOf(isText), pressure: isText, shortest_wavelength: isText,
  seal: isTruth, flatness: isText, drawn: isTableOf(isTruth), files: (value) => Array.isArray(value) && value.every(isFile),
};

/**
 * Returns the state in a fragment: nothing if there is none, null if it is damaged.
 * @param {string} hash
 * @returns {any}
 */
export function parsedLink(hash) {
  // A word alone is a place on the page.
  if (/^#?[\w-]*$/.test(hash)) return undefined;
  try {
    const found = JSON.parse(decodeURIComponent(hash.slice(1)));
    const isWhole = isTableOf(() => true)(found) && Object.entries(KEYS).every(([key, check]) => found[key] === undefined || check(found[key]));
    return isWhole ? found : null;
  } catch {
    return null;
  }
}
