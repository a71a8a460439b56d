// Keyboard, screen readers, touch, themes, languages, units, small screens.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertValid, atRevision, revision, shown, spot, story, withBrowser } from "./visit.mjs";

const here = withBrowser();
const readable = `(() => {
  const small = [...document.querySelectorAll("body *")].filter((e) => e.offsetParent && [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim()) && parseFloat(getComputedStyle(e).fontSize) < 12);
  return small.map((e) => e.outerHTML.slice(0, 80));
})()`;
const nameless = `[...document.querySelectorAll("button, input, select, [role=listbox], canvas[tabindex]")].filter((e) => e.offsetParent && !(e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.length)).map((e) => e.outerHTML.slice(0, 80))`;
// The contrast of every text with the nearest ground behind it (WCAG 2.2, 1.4.3).
const faint = `(() => {
  const light = (c) => { const [r, g, b] = c.match(/[\\d.]+/g).map((v) => { v = v / 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; }); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const ground = (e) => { for (; e; e = e.parentElement) { const c = getComputedStyle(e).backgroundColor; if (!/, 0\\)$|transparent/.test(c)) return c; } return "rgb(255,255,255)"; };
  return [...document.querySelectorAll("body *")].filter((e) => e.offsetParent && !e.disabled && !e.closest("#toast, #offer, [inert]") && [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim())).map((e) => { const [a, b] = [light(getComputedStyle(e).color), light(ground(e))]; return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), e.outerHTML.slice(0, 90)]; }).filter(([ratio]) => ratio < 4.5);
})()`;

const looks = {
  light: [{ name: "prefers-color-scheme", value: "light" }],
  dark: [{ name: "prefers-color-scheme", value: "dark" }],
  "high contrast": [{ name: "prefers-contrast", value: "more" }],
  "high contrast, dark": [{ name: "prefers-contrast", value: "more" }, { name: "prefers-color-scheme", value: "dark" }],
};
for (const [look, media] of Object.entries(looks)) {
  test(`every control has a name, texts are 12 px or more and stand out: ${look}`, () =>
    story(here, async (page) => {
      const [x, y] = await spot(page, "20");
      await page.drag([x, y], [x, y]);
      await page.ask(`document.querySelectorAll("details").forEach((one) => (one.open = true))`);
      for (const tab of ["engine", "pieces", "length"]) {
        await page.click(`#tab-${tab}`);
        await new Promise((resolve) => setTimeout(resolve, 250));
        assert.deepEqual(await page.ask(readable), []);
        assert.deepEqual(await page.ask(nameless), []);
        assert.deepEqual(await page.ask(faint), []);
      }
    }, { page: { media } }));
}

test("everything works by keyboard: from piece to piece, bump, compact, take; the figures are read out", () =>
  story(here, async (page, port) => {
    await page.ask(`document.querySelector("#top").focus()`);
    await page.key("Tab");
    await page.until("selvageRoom.view().selected.length === 1");
    const [first] = (await page.ask("selvageRoom.view()")).selected;
    await page.key("Tab");
    await page.until(`selvageRoom.view().selected[0] !== ${JSON.stringify(first)}`);
    await page.key("ArrowRight");
    await page.until(`/moved|cannot/.test(document.querySelector("#toast").textContent)`);
    await page.key("c");
    await page.until(`document.querySelector("#offer").dataset.shown === "yes"`);
    const before = await revision(page);
    await page.key("Enter");
    await atRevision(page, before + 1);
    await page.until(`/^Length [\\d,.]+ mm, utilisation/.test(document.querySelector("#live").textContent)`);
  }));

test("the canvas does not trap Tab: after the last piece the focus moves on", () =>
  story(here, async (page) => {
    await page.ask(`document.querySelector("#top").focus()`);
    for (let k = 0; k < 45; ++k) await page.key("Tab");
    assert.notEqual(await page.ask("document.activeElement.id"), "top");
  }));

test("the listbox mirrors the canvas", () =>
  story(here, async (page) => {
    await page.click("#tab-pieces");
    const [x, y] = await spot(page, "20");
    await page.drag([x, y], [x, y]);
    await page.until(`document.querySelectorAll("#pieces [aria-selected=true]").length === 1`);
    assert.match(await page.ask(`document.querySelector("#pieces [aria-selected=true]").getAttribute("aria-label")`), /size \d+, at [\d,.]+ mm along/);
    await page.ask(`document.querySelector("#pieces").focus()`);
    await page.key("End");
    await page.until(`selvageRoom.view().selected[0] === "39"`);
    assert.equal(await page.ask(`document.getElementById(document.querySelector("#pieces").getAttribute("aria-activedescendant")).getAttribute("aria-posinset")`), "40");
  }));

test("German, decimal comma, inches", () =>
  story(here, async (page) => {
    assert.equal(await page.text("#length"), "2.460,4 mm");
    assert.equal(await page.text("#tab-engine"), "Motor");
    await page.click("[aria-label=Einstellungen]");
    await page.ask(`(() => { const s = [...document.querySelectorAll("dialog select")][1]; s.value = "in"; s.dispatchEvent(new Event("change")); })()`);
    await page.until(`document.querySelector("#length").textContent === "96,86 in"`);
    await page.ask(`(() => { const s = [...document.querySelectorAll("dialog select")][0]; s.value = "en"; s.dispatchEvent(new Event("change")); })()`);
    await page.until(`document.querySelector("#length").textContent === "96.86 in" && document.querySelector("#tab-engine").textContent === "Engine"`);
  }, { page: { language: "de-DE" } }));

test("centimetres, yards, decimal point and comma; a nudge is a millimetre in every unit", () =>
  story(here, async (page, port) => {
    const set = (k, value) => page.ask(`(() => { const s = [...document.querySelectorAll("dialog select")][${k}]; s.value = "${value}"; s.dispatchEvent(new Event("change")); })()`);
    await page.press("Settings");
    await set(1, "cm");
    await page.until(`document.querySelector("#length").textContent === "246.04 cm"`);
    await set(2, "comma");
    await page.until(`document.querySelector("#length").textContent === "246,04 cm"`);
    await set(1, "yd");
    await page.until(`document.querySelector("#length").textContent === "2,691 yd"`);
    await page.press("Done", "dialog");
    const before = (await shown(page, port)).marker.pieces.find(({ id }) => id === "39").at;
    await page.click("#tab-pieces");
    await page.ask(`document.querySelector("#pieces").focus()`);
    await page.key("End");
    await page.until(`selvageRoom.view().selected[0] === "39"`);
    await page.key("Enter"); // to the marker
    await page.key("ArrowRight", "shift");
    await atRevision(page, 2);
    const after = (await shown(page, port)).marker.pieces.find(({ id }) => id === "39").at;
    assert.ok(Math.hypot(after[0] - before[0], after[1] - before[1]) < 30, "not by a yard");
  }));

test("a pen drags as a mouse does", () =>
  story(here, async (page, port) => {
    const pen = { pointerType: "pen" };
    const [x, y] = await spot(page, "20");
    await page.mouse("mousePressed", x, y, { clickCount: 1, ...pen });
    for (let k = 1; k <= 8; ++k) await page.mouse("mouseMoved", x + 4 * k, y - 3 * k, pen);
    await page.mouse("mouseReleased", x + 32, y - 24, pen);
    await atRevision(page, 2);
    await assertValid(port, (await shown(page, port)).markerId);
  }));

test("in the list of pieces, Shift and Ctrl select several", () =>
  story(here, async (page) => {
    await page.click("#tab-pieces");
    await page.ask(`document.querySelector("#pieces").focus()`);
    await page.key("Home");
    await page.key("ArrowDown", "shift");
    await page.key("ArrowDown", "shift");
    await page.until("selvageRoom.view().selected.length === 3");
  }));

test("two fingers pan and zoom, one drags", () =>
  story(here, async (page, port) => {
    const touch = (type, points) => page.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
    const { scale } = await page.ask("selvageRoom.view()");
    await touch("touchStart", [[300, 300]]);
    await touch("touchStart", [[300, 300], [500, 300]]);
    for (let k = 1; k <= 5; ++k) await touch("touchMove", [[300 - 12 * k, 300], [500 + 12 * k, 300]]);
    await touch("touchEnd", []);
    assert.ok((await page.ask("selvageRoom.view()")).scale > scale * 1.3);
    await page.ask(`document.querySelector("#top").focus()`);
    await page.key("0");
    const [x, y] = await spot(page, "20");
    await touch("touchStart", [[x, y]]);
    for (let k = 1; k <= 6; ++k) await touch("touchMove", [[x + 6 * k, y - 4 * k]]);
    await touch("touchEnd", []);
    await atRevision(page, 2);
    await assertValid(port, (await shown(page, port)).markerId);
  }, { page: { touch: true } }));

test("a phone's screen shows everything important", () =>
  story(here, async (page) => {
    assert.equal(await page.ask("document.documentElement.scrollWidth"), 390);
    assert.deepEqual(await page.ask(readable), []);
    assert.ok(await page.ask(`document.querySelector("#length").getBoundingClientRect().right <= 390`));
  }, { page: { width: 390, height: 780, touch: true } }));
