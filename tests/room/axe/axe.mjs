// axe-core (https://github.com/dequelabs/axe-core) finds no serious issue on any tab, in either theme, with the menu and the dialogues open.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { spot, story, withBrowser } from "../visit.mjs";

const here = withBrowser();
const axe = readFileSync(process.env.AXE, "utf8");

async function judge(page, where) {
  await new Promise((resolve) => setTimeout(resolve, 350)); // until colour transitions have ended
  const found = await page.ask(`axe.run({ resultTypes: ["violations"] }).then(({ violations }) => violations.map(({ id, impact, nodes }) => ({ id, impact, nodes: nodes.slice(0, 3).map(({ html }) => html.slice(0, 140)) })))`);
  const serious = found.filter(({ impact }) => impact === "serious" || impact === "critical");
  for (const one of found) console.log(where, one.impact, one.id);
  assert.deepEqual(serious, [], where);
}

for (const theme of ["light", "dark"]) {
  test(`no serious issue: ${theme}`, () =>
    story(here, async (page) => {
      await page.ask(axe + ";0");
      await page.key("h");
      const [x, y] = await spot(page, "20");
      await page.drag([x, y], [x, y]);
      await page.ask(`document.querySelectorAll("details").forEach((one) => (one.open = true))`);
      for (const tab of ["engine", "pieces", "length"]) {
        await page.click(`#tab-${tab}`);
        await judge(page, tab);
      }
      await page.key("c");
      await page.until(`document.querySelector("#offer").dataset.shown === "yes"`);
      await judge(page, "a result");
      await page.click("#menu");
      await page.until(`document.querySelectorAll("#marker-menu [role=menuitem]").length > 6`);
      await judge(page, "the menu");
      await page.key("Escape");
      for (const name of ["Settings", "Keys"]) {
        await page.press(name);
        await judge(page, name);
        await page.press("Done", "dialog");
      }
    }, { page: { media: [{ name: "prefers-color-scheme", value: theme }] } }));
}
