// Bundles the page, its style and its script into one file, which needs no other: dist/viewer.html.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

const at = (path) => new URL(path, import.meta.url);
const bundle = await build({
  entryPoints: [at('src/main.js').pathname],
  bundle: true, minify: true, write: false, format: 'iife', target: 'es2022', logLevel: 'warning',
});
const page = readFileSync(at('src/page.html'), 'utf8')
  .replace('/* style */', () => readFileSync(at('src/style.css'), 'utf8'))
  .replace('/* script */', () => bundle.outputFiles[0].text);
mkdirSync(at('dist'), { recursive: true });
writeFileSync(at('dist/viewer.html'), page);
console.log(`dist/viewer.html: ${Math.round(page.length / 1024)} kB`);
