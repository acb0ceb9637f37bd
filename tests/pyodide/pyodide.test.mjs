// The Python package in Pyodide: its answers are those of the native build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { loadPyodide } from "pyodide";

const { TRUEAREA_WHEEL: wheel, TRUEAREA_PYTHON: python } = process.env;
const calls = join(import.meta.dirname, "calls.py");

const pyodide = await loadPyodide();
// The package of npm holds no numpy; it is fetched from the network where that is open.
await pyodide.loadPackage("numpy", { messageCallback() {}, errorCallback() {} });
const hasNumpy = pyodide.runPython("import importlib.util; importlib.util.find_spec('numpy') is not None");
await pyodide.loadPackage(wheel, { messageCallback() {} });
pyodide.FS.writeFile("/home/pyodide/calls.py", readFileSync(calls));

/** Compares answers of Pyodide with those of the native build. */
function compare(kind) {
  const found = pyodide.runPython(`import calls; calls.write_answers("${kind}")`);
  const { status, stdout, stderr } = spawnSync(python, [calls, kind], { input: found, encoding: "utf8", maxBuffer: 1 << 28 });
  assert.equal(status, 0, stdout + stderr);
  return stdout;
}

test("materials, spectra, laws and scenes are those of the native build", (context) => {
  context.diagnostic(compare("without-arrays"));
});

if (hasNumpy) {
  test("arrays are those of the native build", (context) => {
    context.diagnostic(compare("with-arrays"));
  });
} else {
  test("a panic ends the call and not the interpreter", () => {
    const caught = pyodide.runPython(`
surface = calls.load_extension().Surface.of_file("builtin:uncd-measured", None, {})
try:
    surface.facts
except BaseException as error:
    caught = type(error).__name__
caught
`);
    assert.equal(caught, "PanicException");
    assert.equal(pyodide.runPython("calls.load_extension().threads()"), 1);
  });

  test("the package lacks nothing but numpy", () => {
    const lacking = pyodide.runPython(`
try:
    import truearea
except ModuleNotFoundError as error:
    lacking = error.name
lacking
`);
    assert.equal(lacking, "numpy");
  });
}
