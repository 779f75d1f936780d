import { Film } from './film.js';
import { Stage } from './stage.js';

const element = (id) => document.getElementById(id);
const play = element('play'), scrub = element('scrub'), clock = element('clock'), speed = element('speed');

let film = null, stage = null, isPlaying = false, lastTick = 0;

function showError(message) {
  element('error').textContent = message;
  element('error').hidden = !message;
}

function setPlaying(value) {
  isPlaying = value && film !== null && film.duration > 0;
  if (isPlaying && film.time >= film.duration) seek(0);
  play.textContent = isPlaying ? 'Pause' : 'Play';
}

function seek(time) {
  if (!film) return;
  film.seek(time);
  scrub.value = film.time;
  scrub.setAttribute('aria-valuetext', `${film.time.toFixed(2)} s`);
  clock.textContent = `${film.time.toFixed(2)} / ${film.duration.toFixed(2)} s`;
  stage.touch();
}

async function open(name, bytes) {
  try {
    const next = await Film.read(bytes);
    stage.show(next);
    film = next;
  } catch (error) {
    showError(`${name} cannot be played: ${error.message}`);
    return;
  }
  showError('');
  document.title = `${name} - bullet_buoyancy`;
  element('hint').hidden = true;
  element('forces-label').hidden = film.markers.length === 0;
  film.showForces(element('forces').checked);
  scrub.max = film.duration;
  scrub.disabled = play.disabled = film.duration === 0;
  seek(0);
  setPlaying(true);
}

const openFile = async (file) => file && open(file.name, await file.arrayBuffer());

async function fetchFile(address) {
  try {
    const response = await fetch(address);
    if (!response.ok) throw new Error(`the server says ${response.status}`);
    await open(address.split('/').pop(), await response.arrayBuffer());
  } catch (error) {
    const reason = location.protocol === 'file:' ? 'a page from disk may not fetch files; drop it here' : error.message;
    showError(`${address} cannot be fetched: ${reason}`);
  }
}

/** The film that was packed into the page. */
async function openPacked(packed) {
  const bytes = Uint8Array.from(atob(packed.textContent), (character) => character.charCodeAt(0));
  await open(packed.dataset.name, bytes.buffer);
}

function tick(now) {
  const seconds = (now - lastTick) / 1000;
  lastTick = now;
  if (isPlaying) {
    const time = film.time + seconds * Number(speed.value);
    const isOver = time >= film.duration;
    seek(isOver && element('repeat').checked ? time % film.duration : time);
    if (isOver && !element('repeat').checked) setPlaying(false);
  }
  if (stage.isStale) stage.draw();
  requestAnimationFrame(tick);
}

/** Space plays and stops, arrows go 0.1 s, with Shift 1 s. */
function onKey(event) {
  const isControl = event.target instanceof HTMLElement && event.target.matches('select, button, [type=checkbox]');
  const step = event.shiftKey ? 1 : 0.1;
  const actions = {
    ' ': () => setPlaying(!isPlaying),
    ArrowLeft: () => seek(film.time - step),
    ArrowRight: () => seek(film.time + step),
    Home: () => seek(0),
    End: () => seek(film.duration),
  };
  const action = actions[event.key];
  if (!film || !action || isControl || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  action();
}

function listen() {
  play.addEventListener('click', () => setPlaying(!isPlaying));
  scrub.addEventListener('input', () => {
    setPlaying(false);
    seek(Number(scrub.value));
  });
  element('forces').addEventListener('change', (event) => {
    film?.showForces(event.target.checked);
    stage.touch();
  });
  element('reset').addEventListener('click', () => stage.resetView());
  element('file').addEventListener('change', (event) => {
    openFile(event.target.files[0]);
    event.target.value = '';  // so that the same file can be chosen again
  });
  window.addEventListener('keydown', onKey);
  for (const type of ['dragover', 'dragleave', 'drop'])
    window.addEventListener(type, (event) => {
      event.preventDefault();
      document.body.classList.toggle('dropping', type === 'dragover');
      if (type === 'drop') openFile(event.dataTransfer.files[0]);
    });
}

function start() {
  try {
    stage = new Stage(element('view'));
  } catch (error) {
    showError(`This browser cannot draw in three dimensions (WebGL 2): ${error.message}`);
    return;
  }
  listen();
  requestAnimationFrame(tick);
  const packed = element('packed'), address = new URLSearchParams(location.search).get('file');
  if (packed) openPacked(packed);
  else if (address) fetchFile(address);
}

start();

/** For the console, and for tests. */
window.viewer = { stage: () => stage, film: () => film };
