/* browser - Chromium without a window, by its debugging protocol over a pipe: no packages
 *
 * Messages are JSON, a zero byte ends each (--remote-debugging-pipe: file descriptors 3 and 4).
 *
 * SPDX-License-Identifier: MIT */
"use strict";
const { spawn } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");

const ANSWER_MS = 240000;

class Browser {
  constructor(program) {
    this.profile = fs.mkdtempSync(path.join(os.tmpdir(), "planelet-browser-"));
    const flags = ["--headless=new", "--disable-gpu", "--no-first-run", "--disable-extensions",
      "--disable-background-networking", "--remote-debugging-pipe", "--disable-dev-shm-usage",
      "--hide-scrollbars", `--user-data-dir=${this.profile}`, "about:blank"];
    if (process.getuid() === 0) {
      flags.unshift("--no-sandbox");
    }
    this.child = spawn(program, flags, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.ended = new Promise((done) => this.child.on("exit", done));
    this.asked = new Map();
    this.errors = [];
    this.requests = [];
    this.last = 0;
    let text = "";
    this.child.stdio[3].on("error", () => {});
    this.child.stdio[4].setEncoding("utf8");
    this.child.stdio[4].on("data", (more) => {
      text += more;
      for (let end; (end = text.indexOf("\0")) >= 0; text = text.slice(end + 1)) {
        this.take(JSON.parse(text.slice(0, end)));
      }
    });
  }

  take(message) {
    const asked = this.asked.get(message.id);
    this.asked.delete(message.id);
    if (asked) {
      clearTimeout(asked.timer);
      message.error ? asked.fail(new Error(message.error.message)) : asked.done(message.result);
    } else if (message.method === "Runtime.exceptionThrown") {
      const details = message.params.exceptionDetails;
      this.errors.push(details.exception ? details.exception.description : details.text);
    } else if (message.method === "Network.requestWillBeSent") {
      this.requests.push(message.params.request.url);
    }
  }

  send(method, params = {}, sessionId = this.session) {
    const id = ++this.last;
    return new Promise((done, fail) => {
      const timer = setTimeout(() => fail(new Error(`${method}: no answer`)), ANSWER_MS);
      this.asked.set(id, { done, fail, timer });
      this.child.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    });
  }

  /* A page of its own; `first`: a script that runs before those of the page. */
  async open(url, first = "") {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" }, undefined);
    const all = { targetId, flatten: true };
    this.session = (await this.send("Target.attachToTarget", all, undefined)).sessionId;
    await this.send("Page.enable");
    await this.send("Runtime.enable");
    await this.send("Network.enable");
    await this.send("Page.addScriptToEvaluateOnNewDocument", { source: first });
    await this.send("Emulation.setDeviceMetricsOverride",
      { width: 1280, height: 860, deviceScaleFactor: 1, mobile: false });
    await this.send("Page.navigate", { url });
    for (let i = 0; i < 600; i++) {
      if (await this.run("document.readyState === 'complete' && !!window.planelet")) {
        return;
      }
      await new Promise((done) => setTimeout(done, 100));
    }
    throw new Error(`${url} does not load: ${this.errors.join("; ")}`);
  }

  async run(expression) {
    const answer = await this.send("Runtime.evaluate",
      { expression, awaitPromise: true, returnByValue: true });
    if (answer.exceptionDetails) {
      const { exception, text } = answer.exceptionDetails;
      throw new Error(`${expression}: ${exception ? exception.description : text}`);
    }
    return answer.result.value;
  }

  async key(key) {
    const text = key.length === 1 ? key : undefined;
    await this.send("Input.dispatchKeyEvent", { type: "keyDown", key, text });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", key });
  }

  /* A file that is dropped on the page, in its own events: a browser without a window has no desk
   * from which one could be dragged. */
  async drop(file) {
    const bytes = fs.readFileSync(file).toString("base64");
    await this.run(`(() => {
      const bytes = Uint8Array.from(atob("${bytes}"), (c) => c.charCodeAt(0));
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([bytes], ${JSON.stringify(path.basename(file))}));
      for (const type of ["dragenter", "dragover", "drop"]) {
        document.body.dispatchEvent(new DragEvent(type,
          { dataTransfer, bubbles: true, cancelable: true }));
      }
    })()`);
  }

  /* ... or chosen in the page's file dialogue. */
  async pick(file, selector) {
    const { root } = await this.send("DOM.getDocument");
    const { nodeId } = await this.send("DOM.querySelector", { nodeId: root.nodeId, selector });
    await this.send("DOM.setFileInputFiles", { nodeId, files: [path.resolve(file)] });
  }

  async picture(file) {
    const { data } = await this.send("Page.captureScreenshot", { format: "png" });
    fs.writeFileSync(file, Buffer.from(data, "base64"));
  }

  async close() {
    this.send("Browser.close", {}, undefined).catch(() => {});
    const timer = setTimeout(() => this.child.kill("SIGKILL"), 10000);
    await this.ended;
    clearTimeout(timer);
    this.asked.forEach((asked) => clearTimeout(asked.timer));
    fs.rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

module.exports = { Browser };
