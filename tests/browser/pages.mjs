// Pages to test: reports made by the program, opened in Chromium.

import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { chromium } from "playwright-core";

export const root = resolve(import.meta.dirname, "../..");
export const program = join(process.env.CARGO_TARGET_DIR ?? join(root, "target"), "debug/truearea");

/** Starts the browser. Its own background traffic is off, so that every request comes from a page. */
export function browser() {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--disable-background-networking", "--disable-sync"],
  });
}

/** Runs the program in a new folder that holds the given files, and returns the path of its report. */
export function report(args, files = {}) {
  const folder = mkdtempSync(join(tmpdir(), "truearea-"));
  for (const [name, content] of Object.entries(files)) writeFileSync(join(folder, name), content);
  execFileSync(program, ["report", ...args, "--out", "made"], { cwd: folder, stdio: "pipe" });
  return join(folder, "made/report.html");
}

/** A report with every part of the first screen: two loads, a hole, a hardness that may grow, a seal. */
export function diamond() {
  return report([
    "builtin:uncd-measured", "--material", "diamond", "--yield-strength", "1.8GPa",
    "--strain-gradient-length", "5um", "--pressure", "5.4MPa", "--pressure", "54MPa", "--seal",
  ]);
}

/** A trace of heights in m with a hostile header. */
export function trace(header) {
  const rows = [];
  for (let at = 0; at < 512; at += 1) {
    const height = 1e-7 * (Math.sin(at / 9) + 0.3 * Math.sin(at * 1.7) + 0.1 * Math.sin(at * at));
    rows.push(`${at * 1e-6},${height}`);
  }
  return `${header}\n${rows.join("\n")}\n`;
}

/** Opens a page at a size, and collects what it asks the network for and what its scripts print. */
export async function open(browser, path, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  const requests = [];
  const complaints = [];
  page.on("request", (request) => requests.push(request.url()));
  page.on("console", (message) => complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("dialog", (dialog) => { complaints.push(dialog.message()); dialog.dismiss(); });
  await page.goto(`file://${path}`);
  return { context, page, requests, complaints };
}
