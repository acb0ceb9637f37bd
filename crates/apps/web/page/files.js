// Files that were dropped or chosen, with those in folders.

/** @typedef {{ name: string, file: File }} Named */

/**
 * Returns the files of a drop, under their names with folders.
 * @param {DataTransfer} transfer
 * @returns {Promise<Named[]>}
 */
export async function dropped(transfer) {
  const entries = [...transfer.items].filter((item) => item.kind === "file").map((item) => item.webkitGetAsEntry());
  if (entries.every((entry) => entry === null)) return chosen(transfer.files);
  const found = await Promise.all(entries.map((entry) => (entry ? inside(entry, "") : [])));
  return found.flat();
}

/**
 * Returns the files of an input.
 * @param {FileList} list
 * @returns {Named[]}
 */
export function chosen(list) {
  return [...list].map((file) => ({ name: file.webkitRelativePath || file.name, file }));
}

/**
 * @param {FileSystemEntry} entry
 * @param {string} folder
 * @returns {Promise<Named[]>}
 */
async function inside(entry, folder) {
  const name = folder + entry.name;
  if (entry.isFile) {
    const file = await new Promise((resolve, reject) => /** @type {FileSystemFileEntry} */ (entry).file(resolve, reject));
    return [{ name, file }];
  }
  const reader = /** @type {FileSystemDirectoryEntry} */ (entry).createReader();
  /** @type {Named[]} */
  const found = [];
  for (;;) {
    /** @type {FileSystemEntry[]} */
    const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return found;
    for (const each of some) found.push(...await inside(each, `${name}/`));
  }
}
