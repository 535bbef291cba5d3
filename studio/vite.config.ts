import { defineConfig, type Plugin } from "vite";

/** The built page asks nothing of the network but its own files. */
const closed: Plugin = {
  name: "closed-page",
  apply: "build",
  transformIndexHtml: () => [
    {
      tag: "meta",
      injectTo: "head-prepend",
      attrs: {
        "http-equiv": "Content-Security-Policy",
        content:
          "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; " +
          "img-src 'self' data: blob:; object-src 'none'; base-uri 'none'",
      },
    },
  ],
};

// The page is static: relative addresses, so that it can be served from any folder.
export default defineConfig({
  base: "./",
  plugins: [closed],
  worker: { format: "es" },
  build: { target: "es2022", chunkSizeWarningLimit: 900, assetsInlineLimit: 0 },
  server: { port: 8017, fs: { allow: [".."] } },
  preview: { port: 8017 },
});
