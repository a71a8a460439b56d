// Debian's Chromium, driven through its own protocol over a pipe (https://chromedevtools.github.io/devtools-protocol).
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const program = process.env.CHROMIUM ?? "/usr/bin/chromium";
const flags = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run", "--hide-scrollbars", "--force-color-profile=srgb", "--remote-debugging-pipe"];

/** A browser with a profile that is removed at the end. */
export class Browser {
  #ids = 0;
  #pending = new Map();
  #listeners = new Set();
  #text = "";

  static async launch(more = []) {
    const browser = new Browser();
    browser.folder = mkdtempSync(join(tmpdir(), "selvage-room-"));
    const child = spawn(program, [...flags, ...more, `--user-data-dir=${browser.folder}`, "about:blank"], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    browser.child = child;
    browser.ended = new Promise((resolve) => child.once("exit", resolve));
    process.once("exit", () => child.kill("SIGKILL"));
    child.stdio[4].setEncoding("utf8").on("data", (text) => browser.#hear(text));
    await browser.send("Browser.getVersion");
    return browser;
  }

  #hear(text) {
    const messages = (this.#text + text).split("\0");
    this.#text = messages.pop();
    for (const message of messages.map((one) => JSON.parse(one))) {
      if (message.id === undefined) for (const listener of this.#listeners) listener(message);
      else {
        const { resolve, reject } = this.#pending.get(message.id);
        this.#pending.delete(message.id);
        message.error ? reject(new Error(message.error.message)) : resolve(message.result);
      }
    }
  }

  send(method, params = {}, sessionId = undefined) {
    const id = ++this.#ids;
    this.child.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + "\0");
    return new Promise((resolve, reject) => this.#pending.set(id, { resolve, reject }));
  }

  on(listener) {
    this.#listeners.add(listener);
  }

  /** A page in a separate context, like that of another user. */
  async open(url, { width = 1440, height = 860, language = "en-US", media = [], touch = false, token = undefined } = {}) {
    const { browserContextId } = await this.send("Target.createBrowserContext");
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank", browserContextId });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const page = new Page(this, sessionId, browserContextId);
    await page.start({ width, height, language, media, touch, token });
    await page.send("Page.navigate", { url });
    return page;
  }

  async close() {
    await this.send("Browser.close").catch(() => {});
    await this.ended;
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 5 });
  }
}

const KEYS = { Backspace: 8, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Enter: 13, Escape: 27, Tab: 9, Home: 36, End: 35, PageUp: 33, PageDown: 34, " ": 32 };
const MODIFIERS = { alt: 1, control: 2, shift: 8 };

export class Page {
  /** The page's errors, console messages and refused loads. */
  faults = [];
  requests = [];

  constructor(browser, session, context) {
    this.browser = browser;
    this.session = session;
    this.context = context;
  }

  /** Closes the page, as a user closes the browser. */
  close() {
    return this.browser.send("Target.disposeBrowserContext", { browserContextId: this.context });
  }

  /** Files that the page saves go to a folder. */
  saveTo(downloadPath) {
    return this.browser.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath, browserContextId: this.context });
  }

  send(method, params) {
    return this.browser.send(method, params, this.session);
  }

  async start({ width, height, language, media, touch, token }) {
    this.browser.on(({ method, params, sessionId }) => {
      if (sessionId !== this.session) return;
      if (method === "Runtime.exceptionThrown") this.faults.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
      if (method === "Log.entryAdded" && params.entry.level === "error") this.faults.push(params.entry.text);
      if (method === "Network.requestWillBeSent") this.requests.push(params.request.url);
    });
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await this.send(`${domain}.enable`);
    await this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: touch });
    await this.send("Emulation.setLocaleOverride", { locale: language });
    await this.send("Emulation.setEmulatedMedia", { features: media });
    if (touch) await this.send("Emulation.setTouchEmulationEnabled", { enabled: true, maxTouchPoints: 2 });
    const before = `Object.defineProperty(navigator, "language", { value: "${language}" });` + (token ? `sessionStorage.setItem("selvage-token", ${JSON.stringify(token)});` : "");
    await this.send("Page.addScriptToEvaluateOnNewDocument", { source: before });
  }

  /** The value of an expression in the page. */
  async ask(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /** Waits until an expression is true and returns its value; fails after a minute with the expression. */
  async until(expression, what = expression) {
    for (const end = Date.now() + 60_000; Date.now() < end; await new Promise((resolve) => setTimeout(resolve, 20))) {
      const value = await this.ask(expression).catch(() => undefined);
      if (value) return value;
    }
    throw new Error(`waited in vain for: ${what}; the page says "${await this.text("#toast").catch(() => "")}"; faults: ${this.faults.join("; ")}`);
  }

  /**
   * The number of nodes, listeners, functions and the page's own objects in memory after garbage collection, once the counts no longer fall.
   * A node's wrapper does not count: the browser creates it when a script accesses the node, and may collect it while the node exists.
   */
  async living() {
    let now = await this.countedNow();
    for (let tries = 0, same = 0; tries < 20 && same < 2; ++tries) {
      await new Promise((resolve) => setTimeout(resolve, 200)); // for finalisers and timers
      const next = await this.countedNow();
      same = Object.keys(now).every((kind) => next[kind] >= now[kind]) ? same + 1 : 0;
      now = next;
    }
    return now;
  }

  async countedNow() {
    await this.send("HeapProfiler.collectGarbage");
    const { nodes, jsEventListeners } = await this.send("Memory.getDOMCounters");
    return { nodes, listeners: jsEventListeners, functions: await this.countOf("Function"), objects: await this.countOf("Object") };
  }

  async countOf(type) {
    const objectGroup = "counted";
    const { result } = await this.send("Runtime.evaluate", { expression: `${type}.prototype`, objectGroup });
    const { objects } = await this.send("Runtime.queryObjects", { prototypeObjectId: result.objectId, objectGroup });
    const own = `function () { return this.filter((one) => !(one instanceof Node || one instanceof CSSStyleDeclaration)).length; }`;
    const counted = await this.send("Runtime.callFunctionOn", { objectId: objects.objectId, functionDeclaration: own });
    await this.send("Runtime.releaseObjectGroup", { objectGroup });
    return counted.result.value;
  }

  text(selector) {
    return this.ask(`document.querySelector(${JSON.stringify(selector)})?.textContent ?? ""`);
  }

  /** Clicks an element; repeats that if an update of the page has meanwhile moved it away from the pointer. */
  async click(selector) {
    const find = `document.querySelector(${JSON.stringify(selector)})`;
    for (let tries = 0; tries < 10; ++tries) {
      await this.until(`!!${find} && !${find}.disabled && ${find}.getClientRects().length > 0`, selector);
      const [x, y] = await this.ask(`(() => {
        const e = ${find};
        // The page may replace the element before the click comes: whatever then has the selector is clicked as well.
        document.removeEventListener("click", window.noteClick, { capture: true });
        window.clickArrived = false;
        window.noteClick = (event) => { window.clickArrived ||= event.composedPath().some((node) => node.matches?.(${JSON.stringify(selector)})); };
        document.addEventListener("click", window.noteClick, { capture: true });
        e.scrollIntoView({ block: "nearest" });
        const r = e.getBoundingClientRect();
        return [r.x + r.width / 2, r.y + r.height / 2];
      })()`);
      await this.mouse("mousePressed", x, y, { clickCount: 1 });
      await this.mouse("mouseReleased", x, y, { clickCount: 1 });
      if (await this.ask(`window.clickArrived || !${find}`).catch(() => true)) return; // a click may lead to another page
    }
    throw new Error(`ten clicks at ${selector} did not arrive`);
  }

  /** Clicks the button whose text or name is this. */
  async press(name, within = "body") {
    const mark = `[...document.querySelectorAll(${JSON.stringify(within + " button")})].find((b) => !b.disabled && b.offsetParent && (b.textContent.trim() === ${JSON.stringify(name)} || (b.getAttribute("aria-label") ?? "").startsWith(${JSON.stringify(name)})))`;
    await this.until(`(() => { const b = ${mark}; document.querySelector("[data-wanted]")?.removeAttribute("data-wanted"); b?.setAttribute("data-wanted", ""); return !!b; })()`, `the button ${name}`);
    await this.click("[data-wanted]");
  }

  mouse(type, x, y, { button = "left", modifiers = 0, buttons = type === "mouseReleased" ? 0 : 1, ...more } = {}) {
    return this.send("Input.dispatchMouseEvent", { type, x, y, button, buttons, modifiers, pointerType: "mouse", ...more });
  }

  async drag([x, y], [toX, toY], { steps = 12, hold = false, button = "left", modifiers = 0, pause = 10 } = {}) {
    await this.mouse("mouseMoved", x, y, { button: "none", buttons: 0, modifiers });
    await this.mouse("mousePressed", x, y, { button, clickCount: 1, modifiers, buttons: button === "right" ? 2 : 1 });
    for (let k = 1; k <= steps; ++k) {
      await this.mouse("mouseMoved", x + ((toX - x) * k) / steps, y + ((toY - y) * k) / steps, { button, modifiers, buttons: button === "right" ? 2 : 1 });
      await new Promise((resolve) => setTimeout(resolve, pause));
    }
    if (!hold) await this.mouse("mouseReleased", toX, toY, { button, modifiers });
  }

  wheel(x, y, deltaY, modifiers = 0) {
    return this.send("Input.dispatchMouseEvent", { type: "mouseWheel", x, y, deltaX: 0, deltaY, modifiers });
  }

  async key(name, ...held) {
    const modifiers = held.reduce((sum, one) => sum + MODIFIERS[one], 0);
    const code = KEYS[name] ?? name.toUpperCase().charCodeAt(0);
    const text = name.length === 1 && !held.includes("control") ? name : name === "Enter" ? "\r" : undefined;
    const event = { key: name, windowsVirtualKeyCode: code, modifiers, text };
    await this.send("Input.dispatchKeyEvent", { type: "keyDown", ...event });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", ...event, text: undefined });
  }

  type(text) {
    return this.send("Input.insertText", { text });
  }

  /** Replaces the text in a field and leaves the field. */
  async enter(selector, text) {
    await this.click(selector);
    await this.key("a", "control");
    if (text === "") await this.key("Backspace");
    else await this.type(text);
    await this.key("Tab");
  }

  async picture() {
    const { data } = await this.send("Page.captureScreenshot", { format: "png" });
    return Buffer.from(data, "base64");
  }
}
