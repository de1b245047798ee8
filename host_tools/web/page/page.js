/* page - controls, figures, drag and drop
 * SPDX-License-Identifier: MIT */
const $ = (id) => document.getElementById(id);
const SHADERS = [ /* name, enum plt_shader, key */
  ["eye light", 0, "e"], ["normal", 1, "n"], ["triangle", 2, "t"], ["smooth", 3, "s"],
  ["depth", 4, "d"], ["heat: visits", 5, "h"], ["lights, glass", 16, "w"]];
const SMOOTH = 3, WHITTED = 16;
const SAMPLES = [["1 per pixel", 1], ["4", 4], ["16", 16], ["adaptive: 4, 16", 255]];
const SIZES = [[320, 200], [320, 240], [640, 400], [640, 480], [960, 600], [1280, 800]];
const KIB = [64, 128, 256, 512, 1024, 4096, 16384, 65536, 262144];
/* enum steer_action */
const KEYS = { ArrowLeft: 0, ArrowRight: 1, ArrowUp: 2, ArrowDown: 3, "+": 4, "=": 4, "-": 5,
  "_": 5, r: 6, R: 6 };
const DEGREES_PER_PIXEL = 0.4, NEARER = 1.15;

function fill(select, rows) {
  select.replaceChildren(...rows.map(([text, value]) => new Option(text, value)));
}
const kib = (n) => n >= 1024 * 1024 && n % (1024 * 1024) === 0 ?
  `${n / 1024 / 1024} MiB` : `${n / 1024} KiB`;
const bytes = (n) => n.toLocaleString("en");

function sizeRow([width, height]) {
  return [`${width} × ${height}`, `${width}x${height}`];
}

function fail(why, need) {
  const alert = $("alert");
  alert.textContent = why;
  alert.hidden = false;
  const enough = KIB.find((k) => k * 1024 >= need);
  if (need && enough) {
    const button = document.createElement("button");
    button.textContent = `use ${kib(enough * 1024)}`;
    button.onclick = () => choose({ arena: enough * 1024 });
    alert.append(button);
  }
  figures();
}

/* Settings that the scene is opened anew for. */
function choose(settings) {
  Object.assign(viewer.settings, settings);
  $("alert").hidden = true;
  show();
  return engine.file.length ? viewer.open(true) : false;
}

function show() {
  const { shader, samples, arena, where } = viewer.settings;
  $("shader").value = shader;
  $("samples").value = samples;
  $("arena").value = arena;
  $("where").value = where;
  $("size").value = `${viewer.width}x${viewer.height}`;
}

/* A scene with materials has lights, one with normals is smooth. */
async function scene(data, name, view) {
  $("alert").hidden = true;
  document.title = `${name} – Planelet`;
  Object.assign(viewer.settings, { shader: view ? WHITTED : 0, samples: 1 });
  let isOpen = await viewer.scene(data, name, view);
  const better = !isOpen || view ? 0 : engine.number("hasMaterials") ? WHITTED :
    engine.number("hasSurface") ? SMOOTH : 0;
  if (better) {
    viewer.settings.shader = better;
    isOpen = await viewer.open(true);
    isOpen = isOpen === false ? await choose({ shader: 0 }) : isOpen;
  }
  show();
  figures();
  return isOpen;
}

let taken = 0;

/* Of files that are chosen one after another the last is shown, whichever is read first. */
async function take(file) {
  const number = ++taken;
  try {
    const data = new Uint8Array(await file.arrayBuffer());
    if (number === taken) {
      await scene(data, file.name, null);
    }
  } catch (error) {
    fail(`${file.name}: cannot be read (${error.message}); choose it again`, 0);
  }
}

function demo() {
  const { data, ...view } = JSON.parse($("view").textContent);
  return scene(embedded(data), "marbles", view);
}

function figures() {
  const n = (name) => engine.number(name), ms = n("busyMs");
  const isStreamed = viewer.isOpen && Number(viewer.settings.where) === 2;
  const level = n("level");
  const rows = [
    ["frame", `${n("width")} × ${n("height")}${level > PLAIN ? ", coarse" : ""}`],
    ["steps", bytes(n("steps"))],
    ["longest step", `${n("longestMs").toFixed(1)} ms`],
    ["rays", `${(n("rays") / 1e6).toFixed(2)} million`],
    ["speed", ms ? `${(n("rays") / ms / 1e3).toFixed(2)} Mrays/s` : "–"],
    ["time", `${(ms / 1e3).toFixed(2)} s`],
    ["arena", `${bytes(n("arenaPeak"))} of ${bytes(n("arenaBytes"))}`],
    ["stack", `${bytes(n("stackUsed"))} of ${bytes(n("stackBytes"))} *`],
    isStreamed ? ["fetched", bytes(n("bytesFetched"))] : null,
    ["lanes", engine.lanes],
    ["hash", viewer.hash || "–"]];
  $("figures").replaceChildren(...rows.filter(Boolean).map(([name, text]) => {
    const row = document.createElement("tr");
    row.insertCell().textContent = name;
    row.insertCell().textContent = text;
    return row;
  }));
  $("figures").title = "* bytes of variables that have an address; the browser keeps the others. " +
    "The hash is that of planelet render --json for the same frame.";
  const all = n("tilesAll");
  $("bar").firstChild.style.width = `${all ? 100 * n("tiles") / all : 0}%`;
  $("scene").textContent = viewer.name;
  if (viewer.isOpen) {
    const small = document.createElement("small");
    small.textContent = `${bytes(n("triangles"))} triangles, ${bytes(n("imageBytes"))} bytes`;
    $("scene").append(small);
  }
}

/* ---- input ---- */

function key(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === "SELECT") {
    return;
  }
  const shader = SHADERS.find((row) => row[2] === event.key.toLowerCase());
  if (event.key in KEYS) {
    viewer.turn((call) => call.viewer_steer(KEYS[event.key]));
    event.preventDefault();
  } else if (shader) {
    choose({ shader: shader[1] });
  }
}

function listen() {
  const { stage } = viewer;
  document.addEventListener("keydown", key);
  stage.addEventListener("pointerdown", (event) => stage.setPointerCapture(event.pointerId));
  stage.addEventListener("pointermove", (event) => {
    if (event.buttons & 1 || event.pointerType === "touch") {
      viewer.turn((call) => call.viewer_turn(-DEGREES_PER_PIXEL * event.movementX,
        DEGREES_PER_PIXEL * event.movementY));
    }
  });
  stage.addEventListener("wheel", (event) => {
    viewer.turn((call) => call.viewer_zoom(event.deltaY < 0 ? NEARER : 1 / NEARER));
    event.preventDefault();
  }, { passive: false });
  for (const name of ["dragenter", "dragover", "dragleave", "drop"]) {
    document.addEventListener(name, (event) => {
      event.preventDefault();
      $("drop").hidden = name === "drop" || (name === "dragleave" && !event.relatedTarget);
    });
  }
  document.addEventListener("drop", (event) => {
    if (event.dataTransfer.files.length > 0) {
      take(event.dataTransfer.files[0]);
    }
  });
  $("open").onclick = () => $("file").click();
  $("file").onchange = () => $("file").files.length > 0 && take($("file").files[0]);
  $("demo").onclick = demo;
  for (const name of ["shader", "samples", "arena", "where"]) {
    $(name).onchange = () => choose({ [name]: Number($(name).value) });
  }
  $("size").onchange = () => viewer.size(...$("size").value.split("x").map(Number));
  $("connect").onclick = () => display.device ? display.close("") :
    display.connect().catch((error) => display.onchange(error.message));
}

function displayed(text, width, height) {
  $("connect").textContent = display.device ? "Disconnect" : "Connect…";
  $("display").textContent = text || "a Planelet display, or an Elgato Stream Deck";
  if (width) { /* pixel by pixel */
    fill($("size"), [sizeRow([width, height]), ...SIZES.map(sizeRow)]);
    viewer.size(width, height);
    show();
  }
}

async function begin() {
  fill($("shader"), SHADERS.map(([text, value, letter]) => [`${text}  (${letter})`, value]));
  fill($("samples"), SAMPLES);
  fill($("arena"), KIB.map((k) => [kib(k * 1024), k * 1024]));
  fill($("size"), SIZES.map(sizeRow));
  viewer.onchange = figures;
  viewer.onfail = fail;
  viewer.oncomplete = () => {
    viewer.hash = engine.hash();
    display.tick();
  };
  display.onchange = displayed;
  try {
    await engine.load();
  } catch (error) {
    $("alert").textContent = `This browser does not run WebAssembly here (${error.message}).`;
    $("alert").hidden = false;
    return;
  }
  $("connect").disabled = display.reason() !== "";
  display.watch();
  $("display").textContent = display.reason() || $("display").textContent;
  listen();
  show();
  if (!/scene=none/.test(location.hash)) {
    await demo();
  }
}
window.planelet = { engine, viewer, display, scene, take, choose, demo, begun: begin() };
