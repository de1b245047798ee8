/* page_test - node page_test.js BROWSER PAGE FOLDER HOST PANEL_WASM DECK_REPORTS
 *
 * Loads the page, drops scenes of FOLDER (test_web.sh makes them), and compares frames and reports
 * with those of the host's programs.
 *
 * SPDX-License-Identifier: MIT */
"use strict";
const fs = require("node:fs");
const path = require("node:path");
const { execFileSync } = require("node:child_process");
const { Browser } = require("./browser.js");

const [program, pageFile, folder, host, panelFile, deckReports] = process.argv.slice(2);
const SIZE = "192x120";
const hashOfBoards = fs.readFileSync(path.join(__dirname, "../golden/boards.csv"), "utf8")
  .trim().split(",").pop();
const file = (name) => path.join(folder, name);
let passed = 0, failed = 0, browser;

function verdict(sentence, isGood, trouble) {
  if (!isGood) {
    console.log(`    ${trouble}`);
  }
  console.log(`${isGood ? "pass" : "FAIL"} ${sentence}`);
  isGood ? passed++ : failed++;
}

function same(sentence, got, want) {
  verdict(sentence, got === want && want !== undefined, `${got}, not ${want}`);
}

function matches(sentence, got, pattern) {
  verdict(sentence, pattern.test(got), `${got}, not ${pattern}`);
}

function render(name, ...flags) {
  const json = execFileSync(host, ["render", file(name), "--size", SIZE, "--json", "-", ...flags],
    { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] });
  return JSON.parse(json).frame_hash;
}

const frameHash = "(planelet.viewer.wake(), planelet.viewer.atRest())" +
  ".then(() => planelet.engine.hash())";
const figure = (name) => browser.run(`planelet.engine.number("${name}")`);
const choose = (settings) =>
  browser.run(`(planelet.choose(${JSON.stringify(settings)}), ${frameHash})`);
const alertText = () => browser.run("document.getElementById('alert').hidden ? '' : " +
  "document.getElementById('alert').textContent");

/* A file dropped on the page; the hash of its frame at rest, or "". */
async function drop(name) {
  await browser.run("planelet.viewer.atNext = planelet.viewer.atRest(), 0");
  await browser.drop(file(name));
  await browser.run("planelet.viewer.atNext");
  return browser.run(`planelet.viewer.isOpen ? ${frameHash} : ''`);
}

/* A file chosen in the dialogue. */
async function pick(name) {
  await browser.run("planelet.viewer.atNext = planelet.viewer.atRest(), 0");
  await browser.pick(file(name), "#file");
  await browser.run("planelet.viewer.atNext");
  return browser.run(frameHash);
}

async function press(...keys) {
  await browser.run("planelet.viewer.atNext = planelet.viewer.atRest(), 0");
  for (const key of keys) {
    await browser.key(key);
  }
  await browser.run("planelet.viewer.atNext");
  return browser.run(`${frameHash}`);
}

async function load(hash) {
  await browser.open(`file://${path.resolve(pageFile)}#${hash}`,
    fs.readFileSync(path.join(__dirname, "fake_hid.js"), "utf8"));
  await browser.run("planelet.begun");
}

async function frames(lanes) {
  await load(`scene=none&lanes=${lanes}`);
  const is = await browser.run("planelet.engine.lanes");
  verdict(`the page runs with ${is} lanes`, (is === "scalar") === (lanes === "scalar"), is);
  await browser.run(`planelet.viewer.size(${SIZE.replace("x", ",")})`);
  same(`${is}: a scene that is dropped is the host's frame`, await drop("knot.plt"),
    render("knot.plt"));
  /* all but node visits, which depend on packets */
  for (const [name, shader] of [["normal", 1], ["triangle", 2], ["depth", 4], ["whitted", 16]]) {
    same(`${is}: shader ${name} is the host's`, await choose({ shader }),
      render("knot.plt", "--shader", name));
  }
  same(`${is}: four samples per pixel are the host's`, await choose({ shader: 0, samples: 4 }),
    render("knot.plt", "--samples", "4"));
  same(`${is}: a scene with normals is smooth at once`, await drop("smooth.plt"),
    render("smooth.plt", "--shader", "smooth"));
  await browser.run("planelet.viewer.size(80, 60)");
  same(`${is}: the frame of all boards, ${hashOfBoards}`, await drop("boards.plt"), hashOfBoards);
  await browser.run(`planelet.viewer.size(${SIZE.replace("x", ",")})`);
}

async function memory() {
  const wanted = render("compact.plt");
  same("compact blocks are the host's frame", await drop("compact.plt"), wanted);
  const peak = await figure("arenaPeak");
  verdict(`the arena is 262144 bytes, of which ${peak} are used`,
    await figure("arenaBytes") === 262144 && peak > 1000 && peak < 262144, peak);
  same("copied into the arena, too", await choose({ where: 1 }), wanted);
  same("streamed, too, in 65536 bytes", await choose({ where: 2, arena: 65536 }), wanted);
  const fetched = await figure("bytesFetched");
  verdict(`parts of it were fetched: ${fetched} bytes`, fetched > 1000, fetched);
  await choose({ where: 1, arena: 65536 });
  const alert = await alertText();
  matches("an arena that is too small is said with both sizes", alert,
    /arena: the scene needs \d{5,} bytes and there are 65536; choose a larger one/);
  same("and one button makes it large enough", await browser.run(
    `(document.querySelector('#alert button').click(), ${frameHash})`), wanted);
  await choose({ where: 0, arena: 262144 });
  const used = await figure("stackUsed"), all = await figure("stackBytes");
  verdict(`the stack was used up to ${used} of ${all} bytes`, used > 200 && used < all - 4096,
    used);
}

async function turned() {
  const before = await choose({ where: 0, arena: 262144, shader: 0 });
  const after = await press("ArrowLeft", "ArrowUp", "+");
  const at = await camera();
  verdict("keys turn the scene", before !== after, `${before} again`);
  same("and that frame is the host's with its camera", after, render("compact.plt", "--eye",
    at.slice(0, 3).join(), "--look", at.slice(3).join()));
  same("r is the first view again", await press("r"), before);
  await browser.run("planelet.viewer.atNext = planelet.viewer.atRest(), 0");
  const mouse = (type, x, more) => browser.send("Input.dispatchMouseEvent",
    { type, x, y: 300, button: "left", buttons: 1, clickCount: 1, ...more });
  await mouse("mousePressed", 300);
  await mouse("mouseMoved", 340);
  await mouse("mouseReleased", 340);
  await browser.run("planelet.viewer.atNext");
  const dragged = await browser.run(`${frameHash}`);
  verdict("the mouse turns it, too", dragged !== before, `${dragged} again`);
  same("a letter chooses the shader", await press("r", "n"),
    render("compact.plt", "--shader", "normal"));
  const steps = await figure("steps"), tiles = await figure("tiles");
  verdict(`the browser has its turn in a frame: ${steps} steps, ${tiles} tiles`, steps > tiles,
    steps);
}

async function wrong() {
  same("an image that was cut is not shown", await drop("cut.plt"), "");
  matches("and is said to be, in a sentence", await alertText(), /^(image|file): .*; .* again/);
  same("a file that is no image is not shown", await drop("knot.ply"), "");
  matches("and the rule that it breaks is said", await alertText(),
    /^image: .*rule R\d+, byte \d+\); pack the mesh again/);
  same("the next scene, from the file dialogue, is shown", await pick("compact.plt"),
    render("compact.plt"));
  same("and nothing is wrong any more", await alertText() === "", true);
}

const camera = () => browser.run("['eyeX', 'eyeY', 'eyeZ', 'lookX', 'lookY', 'lookZ'].map(" +
  "(name) => planelet.engine.number(name))");
/* Until an expression in the page is true. */
const until = (expression) => browser.run("new Promise((done) => { const look = () => " +
  `${expression} ? done() : setTimeout(look, 20); look(); })`);
const click = (id) => browser.run(`document.getElementById("${id}").click()`);
/* Until the device `d` has got a report, and for a while none. */
const sent = () => browser.run("(async () => { let n; do { n = d.outputs.length; await new " +
  "Promise((done) => setTimeout(done, 500)); } while (n === 0 || d.outputs.length !== n || " +
  "planelet.display.waiting); })()");

async function deck(driver, product, size) {
  await browser.run(`(window.d = fakeHid.deck(0x${product}), planelet.choose({ shader: 0 }))`);
  await click("connect");
  await until("planelet.display.isSized");
  const hash = await browser.run(frameHash), at = await camera(), last = file(`${driver}.png`);
  await sent();
  const json = execFileSync(host, ["render", file("compact.plt"), "--size", size, "-o", last,
    "--json", "-", "--eye", at.slice(0, 3).join(), "--look", at.slice(3).join()]);
  same(`${driver}: the frame has the panel's size, and is the host's`, hash,
    JSON.parse(json).frame_hash);
  await click("connect");
  await browser.run("planelet.display.chain.then(() => { d.outputs = []; })");
  await click("connect");
  await sent();
  same(`${driver}: its reports are those of planelet-hid, byte for byte`,
    await browser.run("d.digest()"),
    execFileSync(deckReports, [driver, product, last], { encoding: "utf8" }).trim());
  if (driver === "streamdeck") {
    await browser.run(`(planelet.viewer.atNext = planelet.viewer.atRest(),
      d.input(1, [0, 15, 0, 0, 0, 0, 0, 0, 1, ...Array(502).fill(0)]),
      d.input(1, [0, 15, 0, ...Array(508).fill(0)]), planelet.viewer.atNext)`);
    verdict("streamdeck: its keys turn the scene", await browser.run(frameHash) !== hash, hash);
  }
  await browser.run("(d.isGone = true, planelet.viewer.turn((call) => call.viewer_steer(0)))");
  await until("planelet.display.device === null");
  matches(`${driver}: one that is unplugged is said to be gone`,
    await browser.run("document.getElementById('display').textContent"), /display is gone .*;/);
}

async function panel() {
  const bytes = fs.readFileSync(panelFile).toString("base64");
  await browser.run(`(window.d = fakeHid.panel("${bytes}"), 0)`);
  await click("connect");
  await until("planelet.display.isSized");
  const hash = await browser.run(frameHash);
  await until("planelet.engine.call.shown_is_done()");
  same("a Planelet display shows the frame, every pixel, by the wire",
    await browser.run("d.hash()"), hash);
  const asked = await browser.run("fakeHid.asked.length");
  verdict(`the browser was asked for ${asked} kinds of devices`, asked >= 10, asked);
  await browser.run("(planelet.viewer.atNext = planelet.viewer.atRest(), d.key(1, 1), " +
    "d.key(1, 0), planelet.viewer.atNext)");
  const turned = await browser.run(frameHash);
  await until("planelet.engine.call.shown_is_done()");
  verdict("its key turns the scene", turned !== hash, turned);
  same("and it shows that frame", await browser.run("d.hash()"), turned);
  await browser.run("(fakeHid.unplug(), 0)");
  matches("one that is unplugged while nothing is sent is said to be gone",
    await browser.run("document.getElementById('display').textContent"), /display is gone;/);
  await click("connect");
  await until("planelet.display.isSized");
  await browser.run("planelet.engine.start().then(() => 0)");
  await until("planelet.display.device === null");
  matches("a program that is begun anew has no display, and the page says so",
    await browser.run("document.getElementById('display').textContent"), /begun anew; connect/);
}

async function looks() {
  await load("");
  await browser.run("(planelet.viewer.size(320, 200), planelet.viewer.atRest())");
  await browser.picture(path.join(path.dirname(pageFile), "page.png"));
  const triangles = await figure("triangles");
  verdict(`the page begins with a scene of ${triangles} triangles, without an alert`,
    triangles > 30000 && await alertText() === "", await alertText());
  same("nothing was fetched but the page itself",
    browser.requests.filter((url) => !/^(file|data):/.test(url)).join(), "");
  await browser.open(`file://${path.resolve(pageFile)}#scene=none`,
    "Object.defineProperty(Navigator.prototype, 'hid', { value: undefined });");
  await browser.run("planelet.begun");
  matches("without WebHID the page says so", await browser.run(
    "document.getElementById('connect').disabled + " +
    "document.getElementById('display').textContent"), /^trueThis browser has no WebHID/);
}

async function main() {
  browser = new Browser(program);
  try {
    await frames("scalar");
    await frames("simd128");
    await memory();
    await turned();
    await wrong();
    await deck("streamdeck-mini", "0063", "240x160");
    await deck("streamdeck-original", "0060", "360x216");
    await deck("streamdeck", "0080", "360x216");
    await deck("streamdeck-plus", "0084", "480x300");
    await panel();
    await looks();
  } catch (error) {
    verdict("the page answers", false, error.stack);
  }
  verdict("no script of the page has failed", browser.errors.length === 0,
    browser.errors.join("\n    "));
  await browser.close();
  console.log(`${passed} passed, ${failed} failed`);
  process.exit(failed > 0 ? 1 : 0);
}
main();
