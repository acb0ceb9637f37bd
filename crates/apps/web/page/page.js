// The state of the page, and its elements.

/** @typedef {Record<string, string | null>} Body */
/** @typedef {{ name: string, bytes: number, options: Record<string, string>, kind: string, is_counterface: boolean, file: File | null, sight: any }} PageFile */

export const state = {
  /** @type {string | null} */ example: null,
  /** @type {PageFile[]} */ files: [],
  /** @type {Body | null} */ material: null,
  /** @type {Body | null} */ counterface: null,
  /** @type {string | null} */ pressure: null,
  /** @type {string | null} */ shortest: null,
  seal: false,
  /** @type {string | null} */ flatness: null,
  /** @type {Record<string, boolean>} */ drawn: {},
};

/** The request of the state, as the core reads it. */
export function request() {
  const files = state.files.map(({ name, bytes, options, kind, is_counterface }) => ({ name, bytes, options, kind, is_counterface }));
  return {
    example: state.example,
    files,
    material: state.material,
    counterface: state.counterface,
    pressure: state.pressure,
    shortest_wavelength: state.shortest,
    seal: state.seal,
    flatness: state.flatness,
  };
}

/**
 * @template {HTMLElement} [T=HTMLElement]
 * @param {string} id
 * @returns {T}
 */
export const by = (id) => /** @type {T} */ (document.getElementById(id));
export const input = (/** @type {string} */ id) => /** @type {HTMLInputElement} */ (by(id));
export const select = (/** @type {string} */ id) => /** @type {HTMLSelectElement} */ (by(id));

/** A pressure with three digits, as a person types it. */
export function pressureText(/** @type {number} */ pressure_pa) {
  for (const [unit, one] of /** @type {[string, number][]} */ ([["GPa", 1e9], ["MPa", 1e6], ["kPa", 1e3]])) {
    if (pressure_pa >= 0.9995 * one) return `${Number((pressure_pa / one).toPrecision(3))} ${unit}`;
  }
  return `${Number(pressure_pa.toPrecision(3))} Pa`;
}
