// The page in Chromium: numbers of the command line, files, messages, links, downloads, keyboard, and no request elsewhere.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { gzipSync } from "node:zlib";
import { cpus, loadavg, tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browser, program, trace } from "./pages.mjs";
import { folder, serve } from "./served.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** A factor on the bounds of times, for machines that do other work meanwhile. */
const slack = () => (loadavg()[0] > 0.8 * cpus().length ? 4 : 1.2);

let chromium;
let server;
before(async () => {
  chromium = await browser();
  server = await serve();
});
after(async () => {
  await chromium.close();
  server.end();
});

const hook = (page, name) => page.locator(`[data-testid="${name}"]`);

/** Opens the page, and collects what it asks the network for and what goes wrong. */
async function open(options = {}, fragment = "") {
  const context = await chromium.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  const requests = [];
  const complaints = [];
  context.on("request", (request) => requests.push(request.url()));
  page.on("console", (message) => { if (message.type() === "error" || message.type() === "warning") complaints.push(message.text()); });
  page.on("pageerror", (error) => complaints.push(String(error)));
  await page.goto(server.address + fragment);
  await page.waitForSelector("html[data-ready]", { state: "attached", timeout: 15_000 });
  return { context, page, requests, complaints };
}

const until = (page, state, timeout = 60_000) =>
  page.waitForFunction((state) => document.getElementById("status").dataset.state === state, state, { timeout });

/** Waits until the closed forms answer for a load. */
const answered = (page, load) =>
  page.waitForFunction((load) => document.getElementById("bodies").textContent.endsWith(`at ${load}`), load, { timeout: 20_000 });

async function example(page, key) {
  await hook(page, "example-select").selectOption(key);
  await page.waitForSelector("#screen:not([hidden])");
}

async function press(page, load) {
  await hook(page, "pressure").fill(load);
  await hook(page, "pressure").press("Enter");
  await answered(page, load);
}

/** Areas of all models in the page, by the names of their curves. */
const areas = (page) =>
  page.evaluate(() => Object.fromEntries([...document.querySelectorAll('[data-testid^="area-"]')].map((cell) => [cell.dataset.testid.slice(5), Number(cell.dataset.value)])));

/** Rows of a table that the command line wrote. */
function rows(text) {
  const [head, ...lines] = text.split("\n").filter((line) => line && !line.startsWith("#"));
  const names = head.split(",");
  return lines.map((line) => Object.fromEntries(line.split(",").map((value, at) => [names[at], value])));
}

function near(found, expected, words) {
  assert.ok(Math.abs(found / expected - 1) <= 1e-12, `${words}: ${found} in the page, ${expected} on the command line`);
}

function run(args, files = {}) {
  const folder = mkdtempSync(join(tmpdir(), "truearea-"));
  for (const [name, content] of Object.entries(files)) writeFileSync(join(folder, name), content);
  const printed = execFileSync(program, args, { cwd: folder, stdio: ["ignore", "pipe", "pipe"] }).toString();
  return { folder, printed };
}

/** Three rough traces at different pitches, as a stylus and two microscopes might give them. */
function traces() {
  const of = (pitch, seed) => {
    const lines = ["x (m),z (m)"];
    let [random, height] = [seed, 0];
    for (let at = 0; at < 700; at += 1) {
      random = (1_103_515_245 * random + 12_345) % 2_147_483_648;
      height = 0.98 * height + 2e-8 * (random / 2_147_483_648 - 0.5) * Math.sqrt(pitch / 1e-6);
      lines.push(`${at * pitch},${height}`);
    }
    return lines.join("\n");
  };
  return { "a.csv": of(1e-6, 1), "b.csv": of(5e-7, 2), "c.csv": of(1e-7, 3) };
}

const drop = (page, files, input = "file-input") =>
  hook(page, input).setInputFiles(Object.entries(files).map(([name, content]) => ({ name, mimeType: "text/plain", buffer: Buffer.from(content) })));

test("the other face: the numbers of the command line, and back without it", async () => {
  const { page, context, complaints } = await open();
  const { "a.csv": ring, "b.csv": face } = traces();
  await hook(page, "material-select").selectOption("steel C45");
  await drop(page, { "face.csv": face }, "other-file-input");
  await until(page, "idle");
  assert.match(await hook(page, "status").textContent(), /first face/);
  await drop(page, { "ring.csv": ring });
  await until(page, "done");
  const both = await areas(page);
  const { folder } = run(
    ["report", "ring.csv", "--counterface-scans", "face.csv", "--material", "steel C45", "--pressure", "10MPa", "--out", "made"],
    { "ring.csv": ring, "face.csv": face },
  );
  for (const [name, area] of Object.entries(both)) {
    const expected = rows(readFileSync(join(folder, "made/data", `${name}.csv`), "utf8")).at(-1);
    near(area, Number(expected.area_fraction), `${name} of two faces`);
  }
  const fragment = new URL(page.url()).hash;
  assert.match(decodeURIComponent(fragment), /"face.csv","options":{},"is_counterface":true/);
  // One name for two files would be one file to the core.
  await drop(page, { "ring.csv": face }, "other-file-input");
  await until(page, "error");
  assert.match(await page.textContent("#error"), /rename one of them/);
  await page.getByRole("button", { name: "Remove face.csv" }).click();
  await until(page, "done");
  assert.notDeepEqual(await areas(page), both);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("both diamond spectra, all models, four loads: the numbers of the command line", async () => {
  const { page, context, requests, complaints } = await open();
  for (const key of ["uncd-measured", "uncd-reconstructed"]) {
    await example(page, key);
    for (const load of ["0.54 MPa", "5.4 MPa", "54 MPa", "540 MPa"]) {
      await press(page, load);
      const { folder } = run([
        "report", `builtin:${key}`, "--material", "diamond", "--yield-strength", "1.8GPa", "--strain-gradient-length", "5um",
        "--pressure", load, "--out", "made",
      ]);
      const found = await areas(page);
      const names = Object.keys(found);
      assert.ok(names.length >= 12, names.join(" "));
      for (const name of names) {
        const expected = rows(readFileSync(join(folder, "made/data", `${name}.csv`), "utf8")).at(-1);
        near(found[name], Number(expected.area_fraction), `${name} at ${load} of ${key}`);
      }
      if (load === "5.4 MPa") {
        await until(page, "done");
        const answer = JSON.parse(readFileSync(join(folder, "made/answer.json"), "utf8"));
        near(Number(await hook(page, "answer").getAttribute("data-value")), answer.loads[0].area.area_fraction, `answer of ${key}`);
        for (const group of answer.loads[0].references) {
          for (const model of group.models.filter((model) => model.ratio !== null)) {
            const cell = hook(page, `verdict-${answer.curves[model.curve]}`);
            near(Number(await cell.getAttribute("data-ratio")), model.ratio, `verdict on ${answer.curves[model.curve]}`);
          }
        }
      }
    }
  }
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests.filter((url) => !url.startsWith(server.address)), []);
  await context.close();
});

test("the shortest wavelength cuts as on the command line", async () => {
  const { page, context } = await open();
  await example(page, "uncd-measured");
  await hook(page, "shortest-wavelength").fill("100 nm");
  await hook(page, "shortest-wavelength").press("Enter");
  await page.waitForFunction(() => document.getElementById("status").dataset.state !== "idle");
  await until(page, "done");
  const scene = await page.evaluate(() => new Promise((resolve) => {
    const make = URL.createObjectURL;
    URL.createObjectURL = (blob) => { blob.text().then(resolve); return make(blob); };
    document.getElementById("download-scene").click();
  }));
  assert.match(scene, /shortest_wavelength = "100 nm"/);
  const { folder } = run(["run", "scene.toml", "--out", "made"], { "scene.toml": scene });
  for (const [name, found] of Object.entries(await areas(page))) {
    near(found, Number(rows(readFileSync(join(folder, "made", `${name}.csv`), "utf8")).at(-1).area_fraction), name);
  }
  await context.close();
});

test("three scans give the composite of the command line, an answer in a second, a verdict in five", async () => {
  const { page, context } = await open();
  const files = traces();
  const begin = Date.now();
  await drop(page, files);
  await page.waitForSelector("#screen:not([hidden])");
  const closed = Date.now() - begin;
  await page.waitForSelector('[data-testid^="verdict-"][data-value]:not([data-value=""])', { timeout: 30_000 });
  const verdict = Date.now() - begin;
  console.log(`three scans: closed forms after ${closed} ms, verdicts after ${verdict} ms`);
  assert.ok(closed < slack() * 1_000 && verdict < slack() * 5_000, `${closed} ms and ${verdict} ms`);
  const { printed } = run(["psd", ...Object.keys(files)], files);
  const expected = rows(printed);
  const [wavelengths, c1d] = await hook(page, "spectrum").evaluate((element) => [JSON.parse(element.dataset.wavelengths), JSON.parse(element.dataset.value)]);
  assert.equal(wavelengths.length, expected.length);
  expected.forEach((row, at) => {
    near(wavelengths[at], Number(row.wavelength_m), "wavelength");
    near(c1d[at], Number(row.C1D_m3), "spectrum");
  });
  await context.close();
});

/** A map of 64 x 48 points in m, with the header that Gwyddion writes. */
function map() {
  const lines = ["# Channel: Height", "# Width: 64 um", "# Height: 48 um", "# Value units: m"];
  for (let row = 0; row < 48; row += 1) {
    const heights = [];
    for (let column = 0; column < 64; column += 1) {
      heights.push(1e-8 * (Math.sin(column / 2.1) * Math.cos(row / 1.7) + 0.5 * Math.sin(1.3 * column + 0.7 * row) + 0.2 * Math.sin(column * row)));
    }
    lines.push(heights.join("\t"));
  }
  return lines.join("\n");
}

/** Waits until the map is pressed under a load. */
const pressed = (page, load) =>
  page.waitForFunction((load) => document.getElementById("press-status").dataset.state === "done" && document.getElementById("pressed-area").textContent.endsWith(`at ${load}`), load, { timeout: 30_000 });

test("a map is pressed as on the command line, and follows the pressure", async () => {
  const { page, context, complaints } = await open();
  const files = { "map.txt": map() };
  await drop(page, files);
  await page.waitForSelector("#screen:not([hidden])");
  const material = await hook(page, "material-select").inputValue();
  await press(page, "10 MPa");
  await hook(page, "press-map").click();
  const compare = async (load) => {
    await pressed(page, load);
    const { printed } = run(["bem", "map.txt", "--material", material, "--saturation", "1H", "--pressure", load], files);
    const [row] = rows(printed);
    const expected = Number(row.area_fraction_extrapolated || row.area_fraction_corrected);
    near(Number(await hook(page, "pressed-area").getAttribute("data-value")), expected, `area at ${load}`);
  };
  await compare("10 MPa");
  await hook(page, "press-pressure").focus();
  await page.keyboard.press("PageUp");
  const load = await hook(page, "pressure").inputValue();
  assert.notEqual(load, "10 MPa");
  await compare(load);
  assert.equal(await hook(page, "pressed-map").evaluate((canvas) => canvas.width), 64);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("values are read under the pointer and by arrow keys", async () => {
  const { page, context } = await open();
  await example(page, "uncd-measured");
  await until(page, "done");
  for (const figure of ["figure-main", "spectrum"]) {
    await hook(page, figure).scrollIntoViewIfNeeded();
    const box = await hook(page, figure).boundingBox();
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.4 * box.height);
    await hook(page, `${figure}-reading`).waitFor();
    assert.match(await hook(page, `${figure}-reading`).innerText(), /m[^]*\d/);
    await page.mouse.move(1, 1);
    assert.equal(await hook(page, `${figure}-reading`).count(), 0);
    await hook(page, figure).focus();
    await page.keyboard.press("End");
    const last = await hook(page, `${figure}-reading`).innerText();
    await page.keyboard.press("Home");
    assert.notEqual(await hook(page, `${figure}-reading`).innerText(), last);
    await page.keyboard.press("Escape");
  }
  // At the short end the values are the areas of the table.
  await hook(page, "figure-main").focus();
  await page.keyboard.press("Home");
  const area = await hook(page, "area-persson").innerText();
  if (!(await hook(page, "model-persson").isChecked())) await hook(page, "model-persson").check();
  await hook(page, "figure-main").focus();
  await page.keyboard.press("Home");
  assert.ok((await hook(page, "figure-main-reading").innerText()).includes(area), area);
  await hook(page, "model-persson").uncheck();
  await hook(page, "figure-main").focus();
  await page.keyboard.press("Home");
  assert.doesNotMatch(await hook(page, "figure-main-reading").innerText(), /^Persson$/m);
  await context.close();
});

test("a profile is drawn whole", async () => {
  const { context, page } = await open();
  await drop(page, { "trace.csv": trace("x (m),z (m)") });
  const drawn = page.locator(".profile svg").first();
  await drawn.waitFor();
  const found = await drawn.evaluate((svg) => {
    const [box, figure] = [svg, svg.closest("figure")].map((element) => element.getBoundingClientRect());
    const shown = svg.viewBox.baseVal;
    const texts = [...svg.querySelectorAll("text")].map((text) => text.getBoundingClientRect());
    const isInside = (at) => at.left >= box.left - 1 && at.right <= box.right + 1 && at.top >= box.top - 1 && at.bottom <= box.bottom + 1;
    return { skew: box.width / box.height / (shown.width / shown.height), fits: box.right <= figure.right + 1 && box.bottom <= figure.bottom + 1, inside: texts.length > 4 && texts.every(isInside) };
  });
  assert.ok(Math.abs(found.skew - 1) < 0.02 && found.fits && found.inside, JSON.stringify(found));
  await context.close();
});

test("on a phone the answer scrolls into view, and stays where the reader is", async () => {
  const { context, page } = await open({ viewport: { width: 400, height: 800 } });
  await example(page, "gasket");
  const top = () => page.locator("#result").evaluate((result) => result.getBoundingClientRect().top);
  await page.waitForFunction(() => Math.abs(document.getElementById("result").getBoundingClientRect().top) < 200);
  await page.evaluate(() => scrollTo(0, 0));
  await press(page, "2 MPa");
  assert.ok((await top()) > 400, "a later answer does not scroll");
  await until(page, "done");
  assert.match(await hook(page, "status").textContent(), /^Done: [^ ]+ % touches at 2 MPa\.$/);
  await context.close();
});

test("opened as a file the page says what it needs, and served it does not", async () => {
  const context = await chromium.newContext();
  const page = await context.newPage();
  await page.goto(`file://${folder}/index.html`);
  const words = page.locator(".needs-server");
  await page.waitForFunction(() => getComputedStyle(document.querySelector(".needs-server")).visibility === "visible", null, { timeout: 10_000 });
  const covered = await words.evaluate((words) => { const box = words.getBoundingClientRect(); return !words.contains(document.elementFromPoint(box.left + 20, box.top + box.height / 2)); });
  assert.ok(!covered);
  await context.close();
  const served = await open();
  assert.equal(await served.page.locator(".needs-server").isVisible(), false);
  await served.context.close();
});

test("a file of a rarer format loads the second core", async () => {
  const { page, context } = await open();
  await drop(page, { "a.csv": trace("x (m),z (m)") });
  await page.waitForSelector("#screen:not([hidden])");
  await hook(page, "file-input").setInputFiles([{ name: "b.csv.gz", mimeType: "application/gzip", buffer: gzipSync(trace("x (m),z (m)").replaceAll("e-7", "e-8")) }]);
  await page.waitForFunction(() => document.querySelectorAll(".file .words").length === 2, undefined, { timeout: 20_000 });
  await page.waitForSelector("#screen:not([hidden])");
  assert.equal(await hook(page, "file-error").count(), 0);
  await context.close();
});

test("a description beside a scan says its unit, whichever of them comes first", async () => {
  const { page, context } = await open();
  const heights = trace("").trim().split("\n").map((line) => line.split(",")[1]).join("\n");
  await drop(page, {
    "heights.txt": heights,
    "meta.yml": "version: '1'\nsurfaces:\n  - name: one\n    topographies:\n      - name: one\n        datafile: {original: heights.txt}\n        unit: m\n        size: [511.0e-6]\n        height_scale: 1.0\n",
  });
  await page.waitForSelector("#screen:not([hidden])");
  assert.equal(await page.locator(".needed").count(), 0);
  await context.close();
});

test("a file without a unit is asked for it, and answered", async () => {
  const { page, context } = await open();
  const plain = trace("").trim().split("\n").map((line) => line.split(",")[1]).join("\n");
  await drop(page, { "plain.txt": plain });
  await hook(page, "file-unit").waitFor();
  await hook(page, "file-unit").first().fill("m");
  await hook(page, "file-unit").first().press("Enter");
  await hook(page, "file-size").first().waitFor();
  await hook(page, "file-size").first().fill("511 um");
  await hook(page, "file-size").first().press("Enter");
  await page.waitForSelector("#screen:not([hidden])");
  await context.close();
});

/** Writes a map of 4096 x 4096 heights of 8 bytes, as numpy saves them. */
function largeMap() {
  const side = 4096;
  const head = `{'descr': '<f8', 'fortran_order': False, 'shape': (${side}, ${side}), }`.padEnd(117) + "\n";
  const bytes = Buffer.alloc(128 + 8 * side * side);
  bytes.write("\u0093NUMPY\u0001\u0000v\u0000" + head, "latin1");
  const heights = new Float64Array(bytes.buffer, bytes.byteOffset + 128, side * side);
  let random = 1;
  for (let row = 0; row < side; row += 1) {
    let height = 0;
    for (let column = 0; column < side; column += 1) {
      random = (1_103_515_245 * random + 12_345) % 2_147_483_648;
      height = 0.98 * height + 1e-9 * (random / 2_147_483_648 - 0.5);
      heights[row * side + column] = height + 2e-8 * Math.sin(row / 300);
    }
  }
  const path = join(mkdtempSync(join(tmpdir(), "truearea-")), "large.npy");
  writeFileSync(path, bytes);
  return { path, bytes: bytes.length };
}

test("a map of 4096 x 4096 points is read, drawn and judged in under four times its size, and the page never freezes", async () => {
  const { page, context, complaints } = await open();
  const { path, bytes } = largeMap();
  await page.evaluate(() => {
    const status = document.getElementById("status");
    window.seen = { bytes: 0, tasks: [] };
    new MutationObserver(() => (window.seen.bytes = Math.max(window.seen.bytes, Number(status.dataset.bytes)))).observe(status, { attributes: true });
    new PerformanceObserver((list) => window.seen.tasks.push(...list.getEntries().map((entry) => entry.duration))).observe({ type: "longtask" });
  });
  const begin = Date.now();
  await hook(page, "file-input").setInputFiles(path);
  for (const [name, value] of [["unit", "m"], ["size", "100 um"]]) {
    await hook(page, `file-${name}`).first().waitFor({ timeout: 60_000 });
    await hook(page, `file-${name}`).first().fill(value);
    await hook(page, `file-${name}`).first().press("Enter");
  }
  await page.waitForSelector("#screen:not([hidden])", { timeout: 60_000 });
  const closed = Date.now() - begin;
  await until(page, "done", 120_000);
  assert.ok((await hook(page, "map").first().evaluate((map) => (map.querySelector("canvas") ?? map).width)) > 100);
  const { bytes: most, tasks } = await page.evaluate(() => window.seen);
  console.log(`4096 x 4096: closed forms after ${closed} ms, all after ${Date.now() - begin} ms, ${(most / bytes).toFixed(2)} times the map, long tasks ${JSON.stringify(tasks)}`);
  assert.ok(most < 4 * bytes, `${most} bytes`);
  assert.ok(tasks.every((duration) => duration <= slack() * 50), JSON.stringify(tasks));
  // The load may change while the map is judged: the answer waits for the elements, and belongs to the new load.
  await press(page, "20 MPa");
  await until(page, "done", 120_000);
  assert.match(await hook(page, "status").innerText(), /at 20 MPa/);
  assert.deepEqual(complaints, []);
  await context.close();
});

test("bad files get a message each, and the page keeps working", async () => {
  const { page, context, complaints } = await open();
  await drop(page, {
    "empty.txt": "", "words.txt": "no heights here\nat all\n", "paper.pdf": "%PDF-1.4\n%\u00e2\u00e3\n1 0 obj\n", "broken.zip": "PK\u0003\u0004 broken",
    "trace.csv": trace("x (m),z (m)"),
  });
  await page.waitForSelector("#screen:not([hidden])");
  assert.equal(await hook(page, "file-error").count(), 4);
  for (const words of await hook(page, "file-error").allInnerTexts()) assert.ok(words.length > 10, words);
  await press(page, "20 MPa");
  assert.deepEqual(complaints, []);
  await context.close();
});

test("with files of no use alone the page says so, and the next file gets an answer and its notes", async () => {
  const { page, context, complaints } = await open();
  await drop(page, { "<img src=x onerror=alert(1)>.txt": "no heights here\nat all\n" });
  await until(page, "error");
  assert.equal(await page.locator(".file img").count(), 0);
  await drop(page, { "trace.csv": trace("x (m),z (m)") });
  await until(page, "done");
  const notes = await hook(page, "warning-list").locator("li").allInnerTexts();
  assert.ok(notes.length > 3 && notes.every((note) => !note.includes("FILE:")), notes.join("\n"));
  assert.deepEqual(complaints, []);
  await context.close();
});

test("files dropped while others are read join them, and a page closed at work leaves the next one whole", async () => {
  const { page, context } = await open();
  const files = Object.entries(traces());
  for (const file of files) await drop(page, Object.fromEntries([file]));
  await page.waitForFunction((count) => document.querySelectorAll(".file .words").length === count, files.length);
  await until(page, "done");
  const answer = await hook(page, "answer").getAttribute("data-value");
  await press(page, "20 MPa");
  const other = await context.newPage();
  await page.close();
  await other.goto(server.address);
  await other.waitForSelector("html[data-ready]", { state: "attached" });
  await drop(other, Object.fromEntries(files));
  await until(other, "done");
  assert.equal(await hook(other, "answer").getAttribute("data-value"), answer);
  await context.close();
});

test("a quantity that is none gets a message in place, and the next one an answer", async () => {
  const { page, context } = await open();
  await example(page, "gasket");
  await hook(page, "pressure").fill("10");
  await hook(page, "pressure").press("Enter");
  await page.waitForSelector("#pressure-error:not([hidden])");
  await press(page, "0.3 MPa");
  assert.equal(await page.locator("#pressure-error").isVisible(), false);
  await context.close();
});

test("cancel ends the elements and leaves the closed forms", async () => {
  const { page, context } = await open();
  // Elements may end sooner than a test can point at the button, so the page presses it once it appears.
  await hook(page, "cancel").evaluate((button) => {
    const shown = new MutationObserver(() => {
      if (button.hidden) return;
      shown.disconnect();
      button.click();
    });
    shown.observe(button, { attributes: true });
  });
  await example(page, "uncd-reconstructed");
  await until(page, "done");
  assert.match(await hook(page, "status").innerText(), /Cancelled/);
  assert.equal(await page.locator('[data-testid^="verdict-"]:not([data-value=""])').count(), 0);
  await press(page, "6 MPa");
  await until(page, "done");
  assert.ok(await page.locator('[data-testid^="verdict-"]:not([data-value=""])').count() > 8);
  await context.close();
});

test("a link holds the whole state but the files", async () => {
  const { page, context } = await open();
  await example(page, "uncd-measured");
  await hook(page, "material-select").selectOption("steel C45");
  await press(page, "7 MPa");
  await hook(page, "model-persson").click();
  const drawn = await hook(page, "model-persson").isChecked();
  const found = await areas(page);
  const fragment = new URL(page.url()).hash;
  const other = await open({}, fragment);
  await answered(other.page, "7 MPa");
  assert.deepEqual(await areas(other.page), found);
  assert.equal(await hook(other.page, "model-persson").isChecked(), drawn);
  assert.equal(await hook(other.page, "material-select").inputValue(), "steel C45");
  assert.ok(other.requests.every((url) => !url.includes("7%20MPa") && !url.includes("steel")));
  await context.close();
  await other.context.close();
});

test("a damaged link starts an empty page and says so", async () => {
  for (const state of ['{"files":5}', '{"files":[null]}', '{"files":{"a":1}}', '{"material":"steel"}', '{"drawn":[1]}', "[null]", '{"example":']) {
    const { page, context } = await open({}, `#${encodeURIComponent(state)}`);
    await page.waitForFunction(() => document.body.textContent.includes("The link is damaged"));
    assert.ok(!(await page.textContent("body")).includes("could not start"), state);
    await context.close();
  }
});

test("report, scene and figures are downloaded", async () => {
  const { page, context } = await open();
  await example(page, "gasket");
  const saved = async (name) => {
    const [download] = await Promise.all([page.waitForEvent("download", { timeout: 60_000 }), hook(page, name).click()]);
    return { name: download.suggestedFilename(), content: readFileSync(await download.path()) };
  };
  const scene = await saved("download-scene");
  assert.equal(scene.name, "scene.toml");
  const report = await saved("download-report");
  assert.equal(report.name, "report.html");
  assert.match(report.content.toString(), /Best estimate|Not checked/);
  const svg = await saved("download-figure-svg");
  assert.match(svg.content.toString(), /<svg/);
  const png = await saved("download-figure-png");
  assert.equal(png.content.subarray(1, 4).toString(), "PNG");
  await saved("download-spectrum-svg");
  await context.close();
});

test("everything is reached by keyboard", async () => {
  const { page, context } = await open();
  const reached = new Set();
  const tab = async () => {
    await page.keyboard.press("Tab");
    const name = await page.evaluate(() => document.activeElement.dataset.testid ?? document.activeElement.id);
    reached.add(name);
    return name;
  };
  for (let at = 0; at < 10 && !(await tab()).includes("example-select"); at += 1);
  await page.keyboard.press("ArrowDown");
  await page.waitForSelector("#screen:not([hidden])");
  await until(page, "done");
  for (let at = 0; at < 80; at += 1) await tab();
  for (const name of ["material-select", "pressure", "pressure-slider", "shortest-wavelength", "shortest-wavelength-slider", "model-persson", "download-report", "copy-link", "file-input"]) {
    assert.ok(reached.has(name), `${name} is not among ${[...reached].join(" ")}`);
  }
  await page.locator("#pressure-slider").focus();
  const before = await hook(page, "pressure").inputValue();
  await page.keyboard.press("ArrowRight");
  assert.notEqual(await hook(page, "pressure").inputValue(), before);
  await context.close();
});

test("sliding takes under 100 ms a step, and no task on the main thread over 50 ms", async () => {
  const { page, context } = await open();
  await example(page, "uncd-measured");
  await until(page, "done");
  const found = await page.evaluate(async () => {
    const tasks = [];
    new PerformanceObserver((list) => tasks.push(...list.getEntries().map((entry) => entry.duration))).observe({ type: "longtask" });
    const slider = document.getElementById("pressure-slider");
    const cell = document.querySelector('[data-testid="answer"]');
    const times = [];
    for (let step = 0; step < 40; step += 1) {
      const begin = performance.now();
      const changed = new Promise((resolve) => new MutationObserver((_, observer) => { observer.disconnect(); resolve(); }).observe(cell, { attributes: true }));
      slider.value = String(6 + 0.05 * step);
      slider.dispatchEvent(new Event("input", { bubbles: true }));
      await changed;
      times.push(performance.now() - begin);
    }
    await new Promise((resolve) => setTimeout(resolve, 100));
    return { times: times.sort((a, b) => a - b), tasks };
  });
  const middle = found.times[20];
  console.log(`slider: median ${middle.toFixed(0)} ms, slowest ${found.times.at(-1).toFixed(0)} ms, long tasks ${JSON.stringify(found.tasks)}`);
  assert.ok(middle < slack() * 100, `${middle} ms`);
  assert.ok(found.tasks.every((duration) => duration <= slack() * 50), JSON.stringify(found.tasks));
  await context.close();
});

test("light and dark pages meet WCAG AA, empty and with an answer", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const { page, context } = await open({ colorScheme });
    const faults = async () => {
      const found = await page.evaluate(() => axe.run({ runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"] }));
      return found.violations.map((fault) => `${fault.id}: ${fault.nodes.slice(0, 3).map((node) => node.html.slice(0, 200)).join(" | ")}`);
    };
    await page.evaluate(axe);
    assert.deepEqual(await faults(), [], `${colorScheme}, empty`);
    await drop(page, traces());
    await page.waitForSelector("#screen:not([hidden])");
    await until(page, "done");
    for (const fold of await page.locator("details").all()) await fold.evaluate((element) => { element.open = true; });
    assert.deepEqual(await faults(), [], `${colorScheme}, answered`);
    await context.close();
  }
});

test("print has the answer and the figures, and no controls", async () => {
  const { page, context } = await open();
  await example(page, "gasket");
  await until(page, "done");
  await page.emulateMedia({ media: "print" });
  for (const shown of ["#answer", "#models", "#figure-main svg", "#spectrum svg"]) assert.ok(await page.locator(shown).isVisible(), shown);
  for (const hidden of ["#controls", "#cancel", "#download-report", "#press"]) assert.ok(!(await page.locator(hidden).isVisible()), hidden);
  await context.close();
});

test("no width needs sideways scrolling", async () => {
  for (const width of [360, 768, 1280, 2560]) {
    const { page, context } = await open({ viewport: { width, height: 900 } });
    await drop(page, { "trace.csv": trace("x (m),z (m)") });
    await page.waitForSelector("#screen:not([hidden])");
    for (const fold of await page.locator("details").all()) await fold.evaluate((element) => { element.open = true; });
    const [inner, scrolled] = await page.evaluate(() => [document.documentElement.clientWidth, document.documentElement.scrollWidth]);
    assert.ok(scrolled <= inner, `${width}: ${scrolled}`);
    await context.close();
  }
});

test("after the first visit the page works offline", async () => {
  const { page, context } = await open();
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  await context.setOffline(true);
  await page.reload();
  await page.waitForSelector("html[data-ready]", { state: "attached", timeout: 15_000 });
  await example(page, "gasket");
  await context.close();
});

test("usable within a second of a cold load", async () => {
  const begin = Date.now();
  const { context } = await open();
  const took = Date.now() - begin;
  console.log(`cold load: ${took} ms`);
  assert.ok(took < slack() * 1_000, `${took} ms`);
  await context.close();
});
