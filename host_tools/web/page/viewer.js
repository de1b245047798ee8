/* viewer - opens scenes, renders in slices of a frame's time, draws what has come
 * SPDX-License-Identifier: MIT */
const SLICE_MS = 10, DRAW_MS = 60;

const viewer = {
  name: "", view: null, isOpen: false, isOpening: false, width: 640, height: 400, drawn: 0,
  settings: { shader: 0, samples: 1, arena: 256 * 1024, where: MAPPED },
  stage: document.getElementById("picture"), scratch: document.createElement("canvas"),
  channel: new MessageChannel(), isAwake: false, rests: [], openings: 0, hash: "",
  onchange: () => {}, onfail: () => {}, oncomplete: () => {},

  /* view: a first camera and lights instead of the usual ones */
  scene(bytes, name, view) {
    engine.file = bytes;
    Object.assign(this, { name, view, isOpen: false });
    return this.open(false);
  },

  /* Whether it is open; null: another opening has begun meanwhile. */
  async open(isSame) {
    const { shader, samples, arena, where } = this.settings, { call } = engine;
    const opening = ++this.openings;
    this.isOpen = false;
    this.hash = "";
    this.isOpening = true;
    try {
      const at = call.viewer_begin(engine.file.length, where, isSame ? 1 : 0);
      if (where === MAPPED) {
        if (!at) {
          return this.fail();
        }
        engine.bytes(at, engine.file.length).set(engine.file);
      }
      if (!isSame && this.view) {
        call.viewer_camera(...this.view.eye, ...this.view.look, this.view.fov);
        call.viewer_sun(...this.view.sun);
        call.viewer_sky(...this.view.sky, ...this.view.ground);
      }
      let status = call.viewer_open(arena, shader, samples);
      while (status === MORE) { /* a tree is being built */
        const until = performance.now() + SLICE_MS;
        while (status === MORE && performance.now() < until) {
          status = call.viewer_open_step();
        }
        await new Promise((done) => setTimeout(done));
        if (opening !== this.openings) {
          return null;
        }
      }
      this.isOpening = false;
      if (status < 0 || call.viewer_size(this.width, this.height) < 0) {
        return this.fail();
      }
    } catch (error) {
      return this.trap(error);
    }
    this.isOpen = true;
    this.onchange();
    this.wake();
    return true;
  },

  /* What is shown in that size already is not rendered again. */
  size(width, height) {
    const { stage } = this;
    if (this.isOpen && width === this.width && height === this.height) {
      return;
    }
    Object.assign(this, { width, height });
    const before = document.createElement("canvas");
    before.width = stage.width;
    before.height = stage.height;
    before.getContext("2d").drawImage(stage, 0, 0);
    stage.width = width;
    stage.height = height;
    stage.getContext("2d").drawImage(before, 0, 0, width, height);
    if (this.isOpen && engine.call.viewer_size(width, height) < 0) {
      this.fail();
    }
    this.wake();
  },

  fail() {
    this.isOpen = this.isOpening = false;
    this.stage.getContext("2d").clearRect(0, 0, this.width, this.height);
    this.onfail(engine.why(), engine.number("needBytes"));
    this.rest();
    return false;
  },

  /* Not by any scene that is known: they are checked. */
  async trap(error) {
    this.isOpen = this.isOpening = false;
    this.openings++;
    await engine.start();
    this.onfail(`the program stopped (${error.message}); open the scene again`, 0);
    this.rest();
    return false;
  },

  turn(act) {
    if (this.isOpen) {
      act(engine.call);
      this.wake();
    }
  },

  wake() {
    if (!this.isAwake) {
      this.isAwake = true;
      this.channel.port2.postMessage(0);
    }
  },

  /* Input and drawing have their turn between two slices. */
  slice() {
    this.isAwake = false;
    if (!this.isOpen) {
      if (!this.isOpening) {
        this.rest();
      }
      return;
    }
    let news;
    try {
      news = engine.call.viewer_work(performance.now() + SLICE_MS);
    } catch (error) {
      this.trap(error);
      return;
    }
    if (news < 0) {
      this.fail();
      return;
    }
    const now = performance.now(), level = engine.number("level");
    const isComplete = (news & NEWS_COMPLETE) !== 0;
    if (isComplete || now - this.drawn > DRAW_MS) {
      this.drawn = now;
      if (isComplete || level <= PLAIN) {
        this.draw();
      }
      this.onchange();
    }
    if (isComplete) {
      this.oncomplete(level);
    }
    if (engine.number("isDue")) {
      this.wake();
    } else {
      this.rest();
    }
  },

  /* Where no tile has come the picture before shows through. */
  draw() {
    const width = engine.number("width"), height = engine.number("height");
    const pixels = engine.bytes(engine.call.viewer_pixels(), 4 * width * height);
    const image = new ImageData(new Uint8ClampedArray(pixels), width, height);
    Object.assign(this.scratch, { width, height });
    this.scratch.getContext("2d").putImageData(image, 0, 0);
    this.stage.getContext("2d").drawImage(this.scratch, 0, 0, this.width, this.height);
  },

  rest() {
    this.rests.splice(0).forEach((done) => done());
  },

  /* For scripts: when there is nothing more to render. */
  atRest() {
    return new Promise((done) => this.rests.push(done));
  },
};
viewer.channel.port1.onmessage = () => viewer.slice();
