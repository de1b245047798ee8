/* display - the picture on a USB display, by WebHID; its keys turn the scene
 *
 * The drivers are in the program (host_tools/hid, platform/wire); here reports pass through.
 * SPDX-License-Identifier: MIT */
const display = {
  device: null, call: null, waiting: 0, chain: Promise.resolve(), timer: 0, isSized: false,
  onchange: () => {},

  /* Why there is none, or "". */
  reason() {
    return navigator.hid ? "" :
      "This browser has no WebHID. Chrome and Edge have it on a computer; planelet-hid needs none.";
  },

  filters() {
    const list = [];
    for (let i = 0, id; (id = engine.call.shown_device(i) >>> 0) !== 0; i++) {
      list.push({ vendorId: id >>> 16, productId: id & 0xffff });
    }
    return list;
  },

  /* Bytes of the longest report, without its number. */
  longest(collections, kind) {
    const bits = (report) => report.items.reduce((n, i) => n + i.reportSize * i.reportCount, 0);
    return Math.max(0, ...collections.flatMap((c) => c[kind] || []).map((r) => bits(r) / 8));
  },

  /* One that is unplugged while nothing is sent is gone, too. */
  watch() {
    navigator.hid?.addEventListener("disconnect", ({ device }) => {
      if (device === this.device) {
        this.close("The display is gone; plug it in and connect it again.");
      }
    });
  },

  async connect() {
    /* A device of several interfaces comes as several: the one that takes reports has the panel. */
    const devices = await navigator.hid.requestDevice({ filters: this.filters() });
    const device = devices.find((d) => this.longest(d.collections, "outputReports") > 0) ||
      devices[0];
    if (!device) {
      return;
    }
    try {
      await this.chain; /* it may still be closing */
      await device.open();
    } catch (error) {
      this.onchange(`It cannot be opened: ${error.message}. Close other programs that use it, or ` +
        "see planelet-hid rules.");
      return;
    }
    Object.assign(this, { device, call: engine.call, waiting: 0, isSized: false });
    engine.report = (isFeature, report) => this.send(isFeature, report);
    const status = engine.call.shown_open(device.vendorId, device.productId,
      this.longest(device.collections, "outputReports"),
      this.longest(device.collections, "inputReports"));
    if (status < 0) {
      this.close(this.why());
      return;
    }
    device.oninputreport = (event) => this.hear(event);
    this.timer = setInterval(() => this.tick(), 20);
    this.onchange(`${device.productName || "Display"}: waiting for its answer`);
    this.tick();
  },

  why() {
    return engine.text(engine.call.shown_why());
  },

  /* Called by the program: the number comes first, and 0 is none. A display that was closed gets no
   * more of them. */
  send(isFeature, report) {
    const { device } = this;
    if (!device) {
      return -1;
    }
    this.waiting++;
    const kind = isFeature ? "sendFeatureReport" : "sendReport";
    this.chain = this.chain
      .then(() => this.device && device[kind](report[0], report.subarray(1)))
      .then(() => { this.waiting--; }, (error) => {
        if (this.device === device) {
          this.close(`The display is gone (${error.message}); plug it in and connect it again.`);
        }
      });
    return 0;
  },

  hear(event) {
    const data = new Uint8Array(event.data.buffer, event.data.byteOffset, event.data.byteLength);
    const report = event.reportId ? [event.reportId, ...data] : data;
    const room = engine.bytes(engine.call.shown_room(), 512);
    room.set(report.length > 512 ? report.slice(0, 512) : report);
    engine.call.shown_came(Math.min(report.length, 512));
    this.tick();
  },

  tick() {
    const { call } = engine;
    if (!this.device) {
      return;
    }
    if (call !== this.call) {
      this.close("The program was begun anew; connect the display again.");
      return;
    }
    const turned = call.shown_tick();
    if (turned < 0) {
      this.close(this.why());
      return;
    }
    if (turned) {
      viewer.wake();
    }
    if (!this.isSized && call.shown_width()) {
      this.isSized = true;
      this.onchange(`${engine.text(call.shown_name())}`, call.shown_width(), call.shown_height());
    }
    if (this.waiting === 0 && call.shown_show() < 0) {
      this.close(this.why());
    }
  },

  close(why) {
    const { device } = this;
    clearInterval(this.timer);
    this.device = null;
    if (device) {
      engine.call.shown_close();
      device.oninputreport = null;
      this.chain = this.chain.then(() => device.close()).catch(() => {});
    }
    this.onchange(why);
  },
};
