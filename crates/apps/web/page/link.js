// The state of the page in the fragment of its address, which browsers send to nobody.

/**
 * Returns the fragment for a state.
 * @param {unknown} state
 */
export function stateLink(state) {
  return `#${encodeURIComponent(JSON.stringify(state, (_, value) => (value === null ? undefined : value)))}`;
}

/**
 * Returns the state in a fragment; nothing if there is none.
 * @param {string} hash
 * @returns {any}
 */
export function parsedLink(hash) {
  if (hash.length < 2) return undefined;
  try {
    const found = JSON.parse(decodeURIComponent(hash.slice(1)));
    return typeof found === "object" && found !== null ? found : undefined;
  } catch {
    return undefined;
  }
}
