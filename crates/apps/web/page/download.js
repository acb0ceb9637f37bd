// Downloads of texts and figures.

/**
 * Offers a text or a picture as a file.
 * @param {string} name
 * @param {BlobPart} content
 * @param {string} type
 */
export function offer(name, content, type = "text/plain;charset=utf-8") {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

const PROPERTIES = [
  "fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-opacity", "font-size", "font-family",
  "font-weight", "text-anchor", "paint-order", "opacity",
];

/**
 * Returns a figure of the page as an SVG document of its own: as it looks, on white.
 * @param {SVGSVGElement} svg
 */
export function document_of(svg) {
  const copy = /** @type {SVGSVGElement} */ (svg.cloneNode(true));
  const pairs = [...svg.querySelectorAll("*")].map((element, at) => [element, copy.querySelectorAll("*")[at]]);
  /** @type {Element[]} */
  const hidden = [];
  for (const [shown, own] of pairs) {
    const style = getComputedStyle(shown);
    if (style.display === "none") hidden.push(own);
    for (const property of PROPERTIES) {
      const value = style.getPropertyValue(property);
      if (value) own.setAttribute(property, value);
    }
    own.removeAttribute("class");
    own.removeAttribute("style");
  }
  for (const element of hidden) element.remove();
  const { width, height } = svg.viewBox.baseVal;
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(width));
  copy.setAttribute("height", String(height));
  const paper = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  paper.setAttribute("width", "100%");
  paper.setAttribute("height", "100%");
  paper.setAttribute("fill", getComputedStyle(svg).getPropertyValue("--paper").trim() || "#fff");
  copy.prepend(paper);
  return new XMLSerializer().serializeToString(copy);
}

/**
 * Returns an SVG document as the bytes of a PNG, three times as fine as on a plain screen.
 * @param {string} text
 * @returns {Promise<Blob>}
 */
export async function png_of(text) {
  const url = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  const image = new Image();
  image.src = url;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = 3 * image.width;
  canvas.height = 3 * image.height;
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(url);
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the picture could not be drawn"))), "image/png"));
}
