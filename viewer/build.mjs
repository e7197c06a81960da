// Builds the page's assets into the Python package, or compares them with what is committed.
//
//   node build.mjs          writes them
//   node build.mjs --check  fails where a committed file is not what the source gives
import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const assets = join(here, "../src/berthing/report/offline/assets");

const text = (path) => readFile(join(here, path), "utf8");

async function bundle() {
  const result = await build({
    absWorkingDir: here,
    entryPoints: ["src/main.ts", "src/page.css"],
    bundle: true,
    minify: true,
    charset: "utf8",
    format: "iife",
    target: ["es2021", "chrome100", "firefox100", "safari15"],
    legalComments: "inline",
    outdir: "out",
    write: false,
    logLevel: "warning",
  });
  const find = (suffix) => result.outputFiles.find((f) => f.path.endsWith(suffix)).text;
  return { script: find(".js"), style: find(".css") };
}

// The licences ask that they go with every copy; the page prints them.
async function licences() {
  const parts = [];
  for (const name of ["three", "uplot"]) {
    const { version } = JSON.parse(await text(`node_modules/${name}/package.json`));
    parts.push(`${name} ${version}\n\n${(await text(`node_modules/${name}/LICENSE`)).trim()}\n`);
  }
  return parts.join("\n" + "-".repeat(72) + "\n\n");
}

// A page ends its script at this, whatever the script means by it.
function inlined(script) {
  if (/<\/script|<!--/i.test(script)) throw new Error("the bundle cannot stand in a page");
  return script;
}

const { script, style } = await bundle();
const made = {
  "viewer.js": inlined(script),
  "viewer.css": style,
  "LICENCES.txt": await licences(),
};
const check = process.argv.includes("--check");
await mkdir(assets, { recursive: true });
for (const [name, content] of Object.entries(made)) {
  const path = join(assets, name);
  if (!check) {
    await writeFile(path, content);
    console.log(`${name}  ${(content.length / 1000).toFixed(1)} kB`);
  } else if ((await readFile(path, "utf8").catch(() => "")) !== content) {
    console.error(`${name} is not what viewer/src gives: run "make viewer"`);
    process.exitCode = 1;
  }
}
