// First: the kernel compiles while the page is put together.
import { spawn } from "./engine/spawn";
import "./style/index.css";
import { EngineClient } from "./engine/client";
import { preferredLanguage, setLanguage } from "./i18n";
import { lastSheet } from "./keep";
import { figure } from "./panels/gallery";
import { Studio } from "./studio";

/** The sheet that a first visit opens. */
const FIRST = "octant";

async function start(): Promise<void> {
  const kept = localStorage.getItem("pforms.language");
  setLanguage(preferredLanguage(kept ? [kept] : navigator.languages));
  const studio = new Studio(() => new EngineClient(spawn));
  document.getElementById("studio")?.replaceWith(studio.root);
  const sheet = await lastSheet().catch(() => null);
  await studio.begin(sheet?.snapshot ?? null, figure(FIRST)?.text ?? "pfs = 1\n");
}

void start();
