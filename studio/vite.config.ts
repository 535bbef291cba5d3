import { defineConfig } from "vite";

// The page is static: relative addresses, so that it can be served from any folder.
export default defineConfig({
  base: "./",
  worker: { format: "es" },
  build: { target: "es2022", chunkSizeWarningLimit: 900, assetsInlineLimit: 0 },
  server: { port: 8017, fs: { allow: [".."] } },
  preview: { port: 8017 },
});
