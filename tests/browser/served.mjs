// The page for browsers, as `cargo xtask web` builds it, behind a server of static files.

import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { root } from "./pages.mjs";

export const folder = join(process.env.CARGO_TARGET_DIR ?? join(root, "target"), "web");

const TYPES = {
  ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".json": "application/json", ".css": "text/css", ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
};

/** Serves the folder below /some/folder/, and returns address and a function that ends it. */
export async function serve() {
  const requests = [];
  const server = createServer((request, response) => {
    requests.push(request.url);
    const path = normalize(decodeURIComponent(new URL(request.url, "http://x").pathname)).replace(/^\/some\/folder/, "");
    const file = join(folder, path === "/" ? "index.html" : path);
    if (!request.url.startsWith("/some/folder/") || !file.startsWith(folder) || !existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end();
      return;
    }
    const headers = { "content-type": TYPES[extname(file)] ?? "application/octet-stream" };
    const packed = `${file}.br`;
    const isPacked = existsSync(packed) && (request.headers["accept-encoding"] ?? "").includes("br");
    if (isPacked) headers["content-encoding"] = "br";
    response.writeHead(200, headers);
    createReadStream(isPacked ? packed : file).pipe(response);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const { port } = server.address();
  return { address: `http://127.0.0.1:${port}/some/folder/`, requests, end: () => server.close() };
}
