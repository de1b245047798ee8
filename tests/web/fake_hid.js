/* fake_hid - navigator.hid with one device, before the page's own scripts run
 *
 * fakeHid.deck(product) or fakeHid.panel(base64 of panel.wasm) plug one in. Of each report the
 * number and the bytes are kept, as planelet-hid would hand them to hidapi.
 *
 * SPDX-License-Identifier: MIT */
"use strict";
(() => {
  const report = (bytes) => [{ reportId: 0, items: [{ reportSize: 8, reportCount: bytes }] }];
  let device = null;

  class FakeDevice {
    constructor(vendorId, productId, productName, out, into) {
      Object.assign(this, { vendorId, productId, productName, outputs: [], features: 0 });
      this.collections = [{ outputReports: report(out), inputReports: report(into) }];
      this.oninputreport = null;
      this.isOpen = false;
      this.isGone = false;
    }
    async open() {
      this.isOpen = true;
    }
    async close() {
      this.isOpen = false;
    }
    async sendReport(id, data) {
      if (!this.isOpen || this.isGone) {
        throw new Error("Failed to write the report.");
      }
      await new Promise((done) => setTimeout(done));
      this.outputs.push(Uint8Array.of(id, ...data));
      this.take(id, data);
    }
    async sendFeatureReport() {
      this.features++;
    }
    take() {}
    input(reportId, data) {
      const copy = Uint8Array.from(data);
      if (this.oninputreport) {
        this.oninputreport({ reportId, data: new DataView(copy.buffer) });
      }
    }
    /* "COUNT HASH", as tests/web/deck_reports.c prints it */
    digest() {
      let hash = 0xcbf29ce484222325n;
      for (const bytes of this.outputs) {
        for (const byte of bytes) {
          hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
        }
      }
      return `${this.outputs.length} ${hash.toString(16).padStart(16, "0")}`;
    }
  }

  class FakePanel extends FakeDevice {
    constructor(program) {
      super(0x1209, 0x0001, "fake panel", 64, 64);
      const bytes = Uint8Array.from(atob(program), (c) => c.charCodeAt(0));
      this.call = new WebAssembly.Instance(new WebAssembly.Module(bytes), {}).exports;
      this.call.panel_open(12345, this.now());
      this.timer = setInterval(() => this.give(), 10);
    }
    now() {
      return Math.floor(performance.now());
    }
    bytes(at, count) {
      return new Uint8Array(this.call.memory.buffer, at, count);
    }
    take(id, data) {
      this.bytes(this.call.panel_report(), 64).set(data);
      this.call.panel_take(data.length, this.now());
      this.give();
    }
    give() {
      for (let n; this.isOpen && (n = this.call.panel_give(this.now())) > 0;) {
        this.input(0, this.bytes(this.call.panel_report(), n));
      }
    }
    key(key, isDown) {
      this.call.panel_key(key, isDown);
      this.give();
    }
    /* FNV-1a of what is on it */
    hash() {
      let hash = 0xcbf29ce484222325n;
      for (const byte of this.bytes(this.call.panel_pixels(), 3 * 96 * 64)) {
        hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
      }
      return hash.toString(16).padStart(16, "0");
    }
  }

  /* The device's first interface takes no reports. unplug() is told at once. */
  window.fakeHid = {
    asked: null, listener: {},
    unplug: () => window.fakeHid.listener.disconnect({ device }),
    deck: (product) => (device = new FakeDevice(0x0fd9, product, "fake deck", 1023, 511)),
    panel: (program) => (device = new FakePanel(program)),
  };
  Object.defineProperty(navigator, "hid", {
    configurable: true,
    value: {
      requestDevice: async ({ filters }) => {
        window.fakeHid.asked = filters;
        const other = { collections: [], open: () => Promise.reject(new Error("a keyboard")) };
        return device && filters.some((f) => f.vendorId === device.vendorId &&
          f.productId === device.productId) ? [other, device] : [];
      },
      addEventListener: (kind, act) => { window.fakeHid.listener[kind] = act; },
    },
  });
})();
