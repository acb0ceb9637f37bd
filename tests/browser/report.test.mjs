// The report in Chromium: chips, rows, hover, focus, keyboard, sizes, colours, print; no request, no injection.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { browser, diamond, open, report, trace } from "./pages.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

let chromium;
let page_of_diamond;
before(async () => {
  chromium = await browser();
  page_of_diamond = diamond();
});
after(() => chromium.close());

const shown = (page, selector) => page.locator(selector).filter({ visible: true });

test("a chip shows its load and hides the others", async () => {
  const { page, context } = await open(chromium, page_of_diamond);
  const best = () => shown(page, ".card.best .number").allInnerTexts();
  const [one] = await best();
  await page.getByText("5.4 MPa", { exact: true }).first().click();
  const [other, ...rest] = await best();
  assert.notEqual(one, other);
  assert.equal(rest.length, 0, "one load at a time");
  assert.equal(await shown(page, "svg.area").count(), 1);
  await context.close();
});

test("arrow keys choose the load", async () => {
  const { page, context } = await open(chromium, page_of_diamond);
  const best = () => shown(page, ".card.best .number").innerText();
  await page.keyboard.press("Tab");
  const chosen = await best();
  await page.keyboard.press("ArrowLeft");
  assert.notEqual(await best(), chosen);
  await context.close();
});

test("a row draws its model, by mouse and by keyboard", async () => {
  const { page, context } = await open(chromium, page_of_diamond);
  const row = shown(page, ".matrix tbody tr:has(input:not(:checked))").first();
  const box = row.locator("input");
  const id = await box.getAttribute("id");
  const curve = id.split("-").at(-1);
  const line = () => shown(page, `svg.area g.${curve}`).count();
  const input = page.locator(`#${id}`);
  assert.equal(await line(), 0);
  await row.locator("label").click();
  assert.equal(await line(), 1);
  await input.focus();
  await page.keyboard.press("Space");
  assert.equal(await line(), 0);
  await context.close();
});

test("names of the lines that are drawn keep apart, inside the figure", async () => {
  const { page, context } = await open(chromium, page_of_diamond);
  for (const chip of await page.locator(".chips label").all()) {
    await chip.click();
    const names = await shown(page, "svg.area .name").evaluateAll((names) => names.map((name) => {
      const [box, figure] = [name, name.closest("svg")].map((element) => element.getBoundingClientRect());
      return { words: name.textContent, left: box.left, right: box.right, top: box.top, bottom: box.bottom, inside: box.left >= figure.left && box.right <= figure.right };
    }));
    assert.ok(names.length > 0 && names.every(({ inside }) => inside), JSON.stringify(names));
    for (const [at, one] of names.entries()) {
      // Boxes of letters are half as high again as their letters.
      const meets = (other) => one.left < other.right && other.left < one.right && Math.abs(one.top - other.top) < 0.6 * (one.bottom - one.top);
      assert.ok(!names.slice(at + 1).some(meets), JSON.stringify(names));
    }
  }
  await context.close();
});

test("a cell gives its reason on hover and on focus, inside the window", async () => {
  const { page, context } = await open(chromium, page_of_diamond);
  const cells = page.locator(".matrix td.cell:has(.reason)").filter({ visible: true });
  const count = await cells.count();
  assert.ok(count >= 10);
  for (const at of [0, Math.floor(count / 2), count - 1]) {
    const cell = cells.nth(at);
    const reason = cell.locator(".reason");
    await page.mouse.move(0, 0);
    assert.equal(await reason.isVisible(), false);
    await cell.hover();
    assert.equal(await reason.isVisible(), true);
    const box = await reason.boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 1280 && box.width >= 300, JSON.stringify(box));
    // Nothing cuts off its last line.
    const covers = await reason.evaluate((element) => {
      const { left, bottom } = element.getBoundingClientRect();
      return element.contains(document.elementFromPoint(left + 12, bottom - 8));
    });
    assert.ok(covers || box.y + box.height > 800, JSON.stringify(box));
    await page.mouse.move(0, 0);
    await cell.focus();
    assert.equal(await reason.isVisible(), true);
    await cell.evaluate((element) => element.blur());
  }
  await context.close();
});

test("the first screen holds number, range, condition, verdicts and cautions", async () => {
  const { page, context } = await open(chromium, page_of_diamond);
  for (const selector of [".card.best", ".card.before", ".card.other", "figure.contact svg", ".range-bar"]) {
    const box = await shown(page, selector).first().boundingBox();
    assert.ok(box && box.y >= 0 && box.y + box.height <= 500, `${selector}: ${JSON.stringify(box)}`);
  }
  // The picture comes first; models and curve begin below it on the same screen.
  for (const selector of [".matrix", "svg.area"]) {
    const box = await shown(page, selector).first().boundingBox();
    assert.ok(box && box.y + Math.min(box.height, 250) <= 800, `${selector}: ${JSON.stringify(box)}`);
  }
  await context.close();
});

test("no width needs sideways scrolling, and folded pages are short", async () => {
  for (const width of [360, 400, 768, 1280, 2200]) {
    const { page, context } = await open(chromium, page_of_diamond, { viewport: { width, height: 800 } });
    const [inner, scrolled, height] = await page.evaluate(() => {
      const { clientWidth, scrollWidth, scrollHeight } = document.documentElement;
      return [clientWidth, scrollWidth, scrollHeight];
    });
    assert.ok(scrolled <= inner, `${width}: ${scrolled}`);
    assert.ok(height < 3500, `${width}: ${height}`);
    for (const fold of await page.locator("details").all()) await fold.evaluate((element) => { element.open = true; });
    const opened = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(opened <= inner, `${width} with all open: ${opened}`);
    await context.close();
  }
});

test("light and dark pages meet WCAG AA", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const { page, context } = await open(chromium, page_of_diamond, { colorScheme });
    for (const fold of await page.locator("details").all()) await fold.evaluate((element) => { element.open = true; });
    await page.evaluate(axe);
    const found = await page.evaluate(() =>
      axe.run({ runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"] }));
    const faults = found.violations.map((fault) => `${fault.id}: ${fault.nodes.slice(0, 3).map((node) => node.html.slice(0, 200)).join(" | ")}`);
    assert.deepEqual(faults, [], colorScheme);
    await context.close();
  }
});

/** Sizes of letters on the screen, and the least contrast of those in figures against the page. */
const lettersOf = (page) => page.evaluate(() => {
  const parsed = (colour) => colour.match(/[\d.]+/g).map(Number);
  const linear = (part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
  const luminance = (colour) => { const [r, g, b] = parsed(colour).map((part) => linear(part / 255)); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const paper = luminance(getComputedStyle(document.body).backgroundColor);
  const contrast = (colour) => { const ink = luminance(colour); return (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05); };
  const found = [];
  const walker = document.createTreeWalker(document.querySelector(".screen"), NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement;
    const words = walker.currentNode.textContent.trim();
    if (!words || element.closest("style, .unseen, title") || !element.checkVisibility({ visibilityProperty: true })) continue;
    const svg = element.closest("svg");
    const scale = svg ? element.getScreenCTM().a : 1;
    const style = getComputedStyle(element);
    const isOnPage = svg && element.closest(".area, .range-bar") && !element.closest(".share");
    found.push({ words, px: scale * parseFloat(style.fontSize), contrast: isOnPage ? contrast(style.fill) : 21 });
  }
  return found;
});

test("no letter of the first screen is under 11 px or paler than 4.5 to 1", async () => {
  for (const [width, colorScheme] of [[1280, "light"], [1280, "dark"], [400, "light"]]) {
    const { page, context } = await open(chromium, page_of_diamond, { viewport: { width, height: 800 }, colorScheme });
    const letters = await lettersOf(page);
    assert.ok(letters.length > 40, `${letters.length} texts`);
    const faults = letters.filter(({ px, contrast }) => px < 10.95 || contrast < 4.5);
    assert.deepEqual(faults, [], `${width} ${colorScheme}`);
    await context.close();
  }
});

test("a page asks for nothing, runs nothing and has no script", async () => {
  const { page, context, requests, complaints } = await open(chromium, page_of_diamond);
  await page.getByText("5.4 MPa", { exact: true }).first().click();
  assert.deepEqual(requests, [`file://${page_of_diamond}`]);
  assert.deepEqual(complaints, []);
  assert.equal(await page.locator("script").count(), 0);
  // The check of requests is able to fail.
  await page.evaluate(() => { document.body.append(Object.assign(new Image(), { src: "other.png" })); });
  await page.waitForTimeout(100);
  assert.equal(requests.length, 2);
  await context.close();
});

test("printed, the answer takes two pages and the rest is an appendix", async () => {
  const { page, context } = await open(chromium, page_of_diamond);
  const pdf = (await page.pdf({ format: "A4", preferCSSPageSize: true })).toString("latin1");
  const pages = pdf.match(/\/Type \/Page\b/g).length;
  assert.ok(pages >= 3 && pages <= 14, `${pages} pages`);
  await page.emulateMedia({ media: "print" });
  const loads = await page.locator(".chips input").count();
  assert.equal(await shown(page, ".printed table tbody tr").count(), loads, "every load");
  assert.equal(await shown(page, ".legend .hint").count(), 0);
  await page.locator("#all-numbers").evaluate((element) => element.remove());
  const answer = (await page.pdf({ format: "A4", preferCSSPageSize: true })).toString("latin1");
  assert.ok(answer.match(/\/Type \/Page\b/g).length <= 2);
  await context.close();
});

test("no name in a scan becomes markup", async () => {
  const hurt = "<script>alert(1)</script>\u001b[31m\u202e<img src=x onerror=alert(2)>\"' onload='alert(3)";
  const name = "a\" onmouseover='alert(4)' <img src=x onerror=alert(5)>.csv";
  const path = report(
    [name, "--title", hurt, "--material", "diamond", "--pressure", "10MPa"],
    // A file with escape sequences is no text.
    { [name]: trace(`# ${hurt}\nx (m),${hurt.replaceAll(",", " ")} z (m)`.replaceAll("\u001b", "")) },
  );
  const { page, context, requests, complaints } = await open(chromium, path);
  for (const fold of await page.locator("details").all()) await fold.evaluate((element) => { element.open = true; });
  for (const element of await page.locator("h1, td.cell, figcaption").all()) {
    if (await element.isVisible()) await element.hover();
  }
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests, [`file://${path}`]);
  assert.equal(await page.locator("script, img[src=x], [onload], [onerror], [onmouseover]").count(), 0);
  assert.ok((await page.locator("h1").innerText()).includes("<script>"));
  await context.close();
});
