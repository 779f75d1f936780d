// Puts a film into the page, so that a single file can be sent: npm run pack -- FILM.glb PAGE.html
import { readFileSync, writeFileSync } from 'node:fs';
import { basename, resolve } from 'node:path';

const [film, page] = process.argv.slice(2);
if (!page) {
  console.error('usage: npm run pack -- FILM.glb PAGE.html');
  process.exit(2);
}
const fromCaller = (path) => resolve(process.env.INIT_CWD ?? '.', path);  // npm changes the directory
const viewer = readFileSync(new URL('dist/viewer.html', import.meta.url), 'utf8');
const name = basename(film).replace(/[&"<>]/g, '_');
const element = `<script type="text/plain" id="packed" data-name="${name}">` +
  `${readFileSync(fromCaller(film)).toString('base64')}</script>`;
writeFileSync(fromCaller(page), viewer.replace('<!-- film -->', () => element));
