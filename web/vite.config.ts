import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const example =
  process.env.ROULEAU_EXAMPLE_CASE ??
  fileURLToPath(new URL("../docs/examples/single_cell_8d0.json", import.meta.url));

const service = process.env.ROULEAU_SERVER ?? "http://127.0.0.1:8080";

export default defineConfig({
  // Relative addresses, so that the page also works behind a proxy that serves it below a prefix.
  base: "./",
  resolve: { alias: { "virtual:example-case": example } },
  build: {
    target: "es2022",
    // The server's policy allows no inline script.
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
  },
  server: { proxy: { "/v1": service } },
});
