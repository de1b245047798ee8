/* engine - the program in WebAssembly, and what it asks of the page
 *
 * Lists below are those of host_tools/web/viewer.h and engine/planelet.h.
 * SPDX-License-Identifier: MIT */
const NUMBERS = [
  "triangles", "imageBytes", "needBytes", "arenaBytes", "arenaPeak", "stackUsed", "stackBytes",
  "width", "height", "level", "isDue", "steps", "longestMs", "busyMs", "rays", "tiles",
  "tilesAll", "bytesFetched", "hasSurface", "hasMaterials", "frames",
  "eyeX", "eyeY", "eyeZ", "lookX", "lookY", "lookZ"];
const MAPPED = 0, MORE = 1;
const NEWS_TILES = 1, NEWS_COMPLETE = 2;
const FINEST = 0, PLAIN = 1; /* levels */

function embedded(id) {
  const element = document.getElementById(id);
  return element && Uint8Array.from(atob(element.textContent), (c) => c.charCodeAt(0));
}

const engine = {
  lanes: "", program: null, call: null, file: new Uint8Array(0), report: () => -1,

  /* SIMD where the browser has it, unless the address ends in #lanes=scalar. */
  async load() {
    const simd = /lanes=scalar/.test(location.hash) ? null : embedded("wasm");
    this.lanes = simd && WebAssembly.validate(simd) ? "simd128" : "scalar";
    const bytes = this.lanes === "scalar" ? embedded("scalar") : simd;
    this.program = await WebAssembly.compile(bytes);
    this.programBytes = bytes.length;
    await this.start();
  },

  /* A program that has stopped by a trap is begun anew. */
  async start() {
    const page = {
      clock: () => performance.now(),
      day: () => Date.now(),
      read: (offset, to, count) => {
        const part = this.file.subarray(offset >>> 0, (offset >>> 0) + (count >>> 0));
        this.bytes(to, part.length).set(part);
        return part.length === count >>> 0 ? 0 : -1;
      },
      report: (isFeature, at, count) => this.report(isFeature, this.bytes(at, count).slice()),
    };
    const { sin, cos, tan, asin } = Math;
    const math = { sin, cos, tan, asin, fmod: (x, y) => x % y };
    this.call = (await WebAssembly.instantiate(this.program, { page, math })).exports;
  },

  bytes(at, count) {
    return new Uint8Array(this.call.memory.buffer, at >>> 0, count);
  },

  text(at) {
    const all = new Uint8Array(this.call.memory.buffer, at >>> 0);
    return new TextDecoder().decode(all.subarray(0, all.indexOf(0)));
  },

  why() {
    return this.text(this.call.viewer_why());
  },

  number(name) {
    return this.call.viewer_number(NUMBERS.indexOf(name));
  },

  hash() {
    return BigInt.asUintN(64, this.call.viewer_hash()).toString(16).padStart(16, "0");
  },
};
