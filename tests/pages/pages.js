// Loads every page of the built book in a browser, wide and narrow, light and dark, and as print; plays what
// plays, and says what a reader would stumble over. Other pages are looked at after those of the book.
//
//   node tests/pages/pages.js BROWSER [PAGE…]    after `cargo lab book`, and `npm ci` in this folder
"use strict";
const fs = require("fs");
const path = require("path");
const { fileURLToPath, pathToFileURL } = require("url");
const { chromium } = require("playwright-core");

const BOOK = path.join(__dirname, "../../book/build");
const AXE = fs.readFileSync(require.resolve("axe-core"), "utf8");
// In drawings on a phone, in pixels.
const LEAST_TEXT = 12;
const READERS = [
  { width: 1280, theme: "light", prints: true },
  { width: 1280, theme: "navy" },
  { width: 390, theme: "light" },
  { width: 390, theme: "navy" },
];

function pages(folder) {
  return fs.readdirSync(folder, { withFileTypes: true }).flatMap(entry => {
    const file = path.join(folder, entry.name);
    if (entry.isDirectory()) return pages(file);
    return /\.html$/.test(entry.name) && !/^(print|toc|404|index)\.html$/.test(entry.name) ? [file] : [];
  });
}

// The address without the part that figures write their state into.
const address = page => page.url().split("#")[0];
// That part, asked in the page: `page.url()` hears of it a little later.
const state = page => page.evaluate(() => location.hash);

// In the page: what is cut off. Code may be scrolled, and on a phone a table may; paper cannot.
function cutOff(wide) {
  const found = [];
  const over = document.documentElement.scrollWidth - innerWidth;
  if (over > 1) found.push(`the page is ${over} px wider than the window`);
  for (const element of document.querySelectorAll("main *")) {
    const lost = element.scrollWidth - element.clientWidth,
      style = getComputedStyle(element);
    if (lost <= 1 || element.closest("svg, math") || style.display === "inline") continue;
    const scrolls = /auto|scroll/.test(style.overflowX),
      isTable = element.matches(".table-wrapper");
    const name = `<${element.localName} class="${element.className}"> «${element.textContent.trim().slice(0, 40)}»`;
    if (style.overflowX === "hidden" && style.textOverflow !== "ellipsis")
      found.push(`${name} is cut off by ${lost} px`);
    if (!wide || !isTable) continue;
    if (scrolls) found.push(`a table must be scrolled by ${lost} px: ${name}`);
    const outside = element.getBoundingClientRect().left + element.scrollWidth - innerWidth;
    if (outside > 0) found.push(`a table leaves the page by ${Math.ceil(outside)} px: ${name}`);
  }
  return found;
}

// The smallest text of each drawing that is shown, as high as it is shown.
async function tooSmall(page) {
  const shown = await page.evaluate(() =>
    [...document.querySelectorAll("main img")].map(image => [image.currentSrc, image.getBoundingClientRect().width]),
  );
  return shown.flatMap(([src, width]) => {
    if (!src.startsWith("file:") || !src.endsWith(".svg") || width === 0) return [];
    const svg = fs.readFileSync(fileURLToPath(src), "utf8");
    const sizes = [...svg.matchAll(/font-size(?:="|: )([\d.]+)/g)].map(found => Number(found[1]));
    const least = (Math.min(...sizes) * width) / Number(svg.match(/viewBox="0 0 ([\d.]+)/)[1]);
    return least < LEAST_TEXT - 0.1 ? [`text of ${least.toFixed(1)} px in ${path.basename(src)}`] : [];
  });
}

// Options in commands that a line breaks behind their hyphens.
function broken() {
  const found = [];
  for (const code of document.querySelectorAll("main code:not([class*=language-]), main code.language-sh")) {
    const texts = document.createTreeWalker(code, NodeFilter.SHOW_TEXT);
    while (texts.nextNode())
      for (const { 0: word, index } of texts.currentNode.data.matchAll(/(?<![\w-])--?[a-z][\w-]*/g)) {
        const range = document.createRange();
        range.setStart(texts.currentNode, index);
        range.setEnd(texts.currentNode, index + word.length);
        if (range.getClientRects().length > 1) found.push(`the option ${word} is broken`);
      }
  }
  return found;
}

// Plays each box: its buttons; by keyboard what is to switch on, the sliders and the drawing.
async function play(page) {
  const found = [];
  for (const figure of await page.locator("figure.live").all()) {
    const name = await figure.getAttribute("data-box");
    const note = text => found.push(`the figure ${name} ${text}`);
    const has = async what => (await figure.locator(what).count()) > 0;
    // Without the buttons, whose own words change too.
    const said = async () => (await figure.locator(".live-line").allTextContents()).join();
    const button = text => figure.getByRole("button", { name: text });
    if (!(await has("img[alt]")) || !(await has("figcaption")))
      note("has no picture or no caption for who sees it still");
    await figure.scrollIntoViewIfNeeded();
    const before = await said();
    await button("Step").click();
    const stepped = await said();
    if (stepped === before) note("says the same after a step");
    await button("Play").click();
    // A busy machine takes its time for the first picture.
    for (let looks = 0; looks < 100 && (await said()) === stepped; looks++) await page.waitForTimeout(50);
    await button("Pause").click();
    // What is switched on may show more sliders, and off again, fewer.
    const toggles = await figure.getByRole("checkbox").all();
    for (const toggle of toggles) if (!(await toggle.isChecked())) await toggle.press("Space");
    for (const choice of await figure.getByRole("combobox").all()) {
      const chosen = await choice.inputValue();
      await choice.press("ArrowDown");
      if ((await choice.inputValue()) === chosen) await choice.press("ArrowUp");
      if ((await choice.inputValue()) === chosen) note("has a choice that the keys do not change");
    }
    for (const slider of await figure.getByRole("slider").all()) await slider.press("ArrowRight");
    const canvas = figure.locator("canvas").first();
    if ((await canvas.getAttribute("tabindex")) !== null) {
      await canvas.press("ArrowRight");
      await canvas.press("Shift+ArrowUp");
    }
    await canvas.click();
    if (await button("Back").count()) await back(page, figure, note);
    const drawn = await canvas.evaluate(canvas => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return data.some(value => value > 0);
    });
    if (!drawn) note("is empty");
    for (const toggle of toggles) {
      const before = await toggle.isChecked();
      await toggle.press("Space");
      if ((await toggle.isChecked()) === before) note("has a layer that the space bar does not switch");
    }
    await button("From the start").click();
  }
  return found;
}

// A step on and back says what was said before, by buttons and by the arrow keys of the page.
async function back(page, figure, note) {
  const said = () => figure.locator(".live-line").first().textContent();
  const button = text => figure.getByRole("button", { name: text, exact: true });
  await button("From the start").click();
  const first = await said();
  await button("Step").click();
  if ((await said()) === first) note("says the same after a step");
  await button("Back").click();
  if ((await said()) !== first) note("does not go back");
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("ArrowRight");
  if ((await said()) === first) note("does not step by the arrow key");
  await page.keyboard.press("ArrowLeft");
  if ((await said()) !== first) note("does not go back by the arrow key");
  await page.keyboard.press("Space");
  for (let looks = 0; looks < 100 && (await said()) === first; looks++) await page.waitForTimeout(50);
  if ((await said()) === first) note("does not play by the space bar");
  await page.keyboard.press("Space");
  if ((await button("Play").count()) === 0) note("does not pause by the space bar");
}

// Steps through each table to its end, by button and by keyboard: what it shows then is what was
// recorded, its picture has changed, and the address leads to the same moment.
async function stepThrough(page) {
  const found = [];
  for (const figure of await page.locator("figure.steps").all()) {
    const said = () => figure.locator("output").textContent();
    await figure.evaluate(figure => {
      for (let fold = figure.closest("details"); fold; fold = fold.parentElement.closest("details"))
        fold.open = true;
    });
    const first = await said();
    const picture = () => figure.locator(".steps-picture").innerHTML();
    const url = address(page);
    await figure.getByRole("button", { name: "From the start" }).click();
    const [begun, drawn] = [await said(), await picture()];
    const note = text => found.push(`steps, ${first}: ${text}`);
    await figure.getByRole("button", { name: "Next" }).click();
    const [second, moved] = [await said(), await picture()];
    if (second === begun) note("the button does not go on");
    await figure.locator(".steps-frame").press("ArrowLeft");
    if ((await said()) !== begun || address(page) !== url) note("the arrow key does not go back");
    await figure.locator(".steps-frame").press("End");
    const [shown, recorded] = await figure.evaluate(figure => {
      const rows = [...figure.querySelectorAll("tr")];
      const visible = rows.filter(row => getComputedStyle(row).visibility === "visible");
      const texts = [...visible, figure.querySelector("pre code")].map(text => text.textContent);
      return [texts.slice(0, -1).join(""), texts.at(-1)].map(text => text.replace(/\s/g, ""));
    });
    if (shown !== recorded) note("it does not show what was recorded");
    if ([moved, await picture()].every(now => now === drawn)) note("its picture does not change");
    const [end, moment] = [await said(), await state(page)];
    await figure.getByRole("button", { name: "From the start" }).click();
    await page.evaluate(hash => (location.hash = hash), moment);
    await page.waitForFunction(([figure, end]) => figure.querySelector("output").textContent === end, [
      await figure.elementHandle(),
      end,
    ]).catch(() => note("its address does not lead to its moment"));
  }
  return found;
}

// What axe-core calls serious or worse.
async function inaccessible(page) {
  await page.evaluate(AXE);
  const { violations } = await page.evaluate(() => axe.run({ resultTypes: ["violations"], preload: false }));
  const grave = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
  return grave.map(({ id, nodes: [first, ...others] }) => {
    const why = first.failureSummary.split("\n")[1] ?? "";
    return `${id}, ${others.length + 1} times: ${first.html.slice(0, 120)}: ${why}`;
  });
}

// A box whose slider was moved has its state in the address, which restores it.
async function restored(page) {
  const figure = page.locator("figure.live").first();
  if ((await figure.count()) === 0) return [];
  const slider = figure.getByRole("slider").first();
  const begun = await slider.inputValue();
  await slider.press("End");
  const [moved, end] = [await slider.inputValue(), await state(page)];
  await slider.press("Home");
  await page.evaluate(hash => (location.hash = hash), end);
  await page.waitForTimeout(50);
  return moved !== begun && (await slider.inputValue()) === moved ? [] : ["the address does not restore a slider"];
}

// A box that is not checked hides the programs on such workers, and only those.
async function filter(page) {
  const found = [];
  for (const plot of await page.locator("figure.plot").all()) {
    const rows = () => plot.locator(".plot-row >> visible=true").count();
    const ranks = await plot.locator(".plot-row.ranks").count();
    const all = await rows();
    await plot.getByRole("checkbox", { name: "ranks" }).uncheck();
    if (ranks === 0 || (await rows()) !== all - ranks) found.push("a filter of the plot does not hide its programs");
    await plot.getByRole("checkbox", { name: "ranks" }).check();
  }
  return found;
}

// The head of a long table stays in sight.
async function headStays(page) {
  const table = page.locator("main table:has(tr:nth-child(30))").first();
  if ((await table.count()) === 0) return [];
  const top = await table.evaluate(table => {
    table.rows[25].scrollIntoView();
    return table.tHead.rows[0].cells[0].getBoundingClientRect().top;
  });
  await page.evaluate(() => scrollTo(0, 0));
  return top >= 0 && top < 200 ? [] : [`the head of a long table is at ${Math.round(top)} px`];
}

// A prediction that is committed is shown below its question and beside its answer, and stored. (Chromium without a
// window loses what a page from a file has stored every now and then, so the page is not loaded again.)
async function predict(page) {
  const form = page.locator("form.prediction").first();
  if ((await form.count()) === 0) return [];
  const beside = page.locator(".predicted").first();
  await form.getByRole("textbox").fill("twice");
  await form.getByRole("button", { name: "Commit" }).click();
  const stored = () => Object.values(localStorage).includes("twice");
  const shown = [await form.locator("output").textContent(), await beside.textContent(), await page.evaluate(stored)];
  await form.getByRole("button", { name: "Change" }).click();
  const isGone = await beside.isHidden();
  return shown.join() === "twice,You predicted: twice,true" && isGone ? [] : [`a prediction is lost: ${shown}`];
}

// The links that the Tab key meets first lead past the table of contents.
async function skip(page) {
  const found = [];
  for (const link of await page.locator("a.skip").all()) {
    await link.focus();
    await page.keyboard.press("Enter");
    const id = (await link.getAttribute("href")).slice(1);
    const reached = await page.evaluate(() => document.activeElement.id);
    if (reached !== id) found.push(`the link to ${id} leads to ${reached || "nothing"}`);
  }
  return found;
}

// On paper the columns of a stepper stay below their names: no line wraps.
function wrapped() {
  const found = [];
  for (const code of document.querySelectorAll("figure.steps pre > code")) {
    const lines = code.textContent.trimEnd().split("\n").length;
    const height = parseFloat(getComputedStyle(code).lineHeight) || 1.5 * parseFloat(getComputedStyle(code).fontSize);
    if (code.getBoundingClientRect().height > (lines + 2) * height * 1.2) found.push("a line of a stepper wraps");
  }
  return found;
}

// An arrow key turns the page, unless something has the focus: a button, a fold, a block that can be scrolled.
async function turns(page) {
  const url = address(page);
  for (const what of ["figure button", "summary", "pre > code[tabindex]", ".table-wrapper[tabindex]", "a.figure"]) {
    const element = page.locator(`main ${what} >> visible=true`).first();
    if ((await element.count()) === 0) continue;
    await element.press("ArrowRight");
    await page.waitForTimeout(20);
    if (address(page) !== url) return [`an arrow key on ${what} turns the page`];
  }
  const canvas = page.locator("figure.live canvas").first();
  if ((await canvas.count()) === 0) return [];
  await canvas.click();
  await page.keyboard.press("ArrowRight");
  await page.waitForTimeout(20);
  return address(page) === url ? [] : ["an arrow key after a click into a box turns the page"];
}

// A lecture has eight to fourteen slides, among them a picture, a question, and an exercise with its answer in the
// notes. On a screen each slide holds all of its contents, also with notes, and the arrow keys lead to the last one.
async function present(page, wide) {
  const slides = await page.locator("main > .slide").count();
  if (slides === 0) return [];
  const found = [];
  const note = text => found.push(`slides: ${text}`);
  const has = async (what, text) => (await page.locator(`.slide ${what}`, { hasText: text }).count()) > 0;
  if (slides < 8 || slides > 14) note(`there are ${slides}`);
  if (!(await has("img")) || !(await has("aside", "Ask:"))) note("no picture or no question");
  if (!(await has("h2 ~ aside", "Answer:")) || !(await has("h2", "Five minutes:"))) note("no exercise or no answer");
  if (!wide) return found;
  await page.setViewportSize({ width: 1280, height: 720 });
  await page.keyboard.press("Home");
  for (const notes of ["without", "with"]) {
    const full = await page.evaluate(() =>
      [...document.querySelectorAll(".slide")].flatMap((slide, k) => {
        const end = slide.getBoundingClientRect().bottom - 0.04 * innerHeight;
        return [...slide.children].some(child => child.getBoundingClientRect().bottom > end) ? [k + 1] : [];
      }),
    );
    if (full.length) note(`${notes} notes there is no room on ${full}`);
    await page.keyboard.press("n");
  }
  for (let k = 1; k < slides; k++) await page.keyboard.press(k % 2 ? "ArrowRight" : "Space");
  const end = await state(page);
  if (end !== `#slide-${slides}`) note(`the keys lead to ${end} of ${slides}`);
  return found;
}

// A click on a drawing shows it larger, in the page.
async function enlarge(page) {
  const drawing = page.locator("main a.figure >> visible=true").first();
  if ((await drawing.count()) === 0) return [];
  const url = page.url();
  await drawing.click();
  const sheet = page.locator("dialog.zoom[open]");
  // It has no size until it is loaded.
  const shown = await sheet.locator("img").waitFor({ timeout: 5000 }).then(() => true, () => false);
  if (page.url() !== url || !shown) return ["a drawing is not shown in the page"];
  await page.keyboard.press("Escape");
  const closed = sheet.waitFor({ state: "detached", timeout: 5000 });
  return closed.then(() => [], () => ["the drawing stays large"]);
}

// On a phone the buttons of a box are seen with each of its panels.
async function together(page) {
  const found = [];
  for (const figure of await page.locator("figure.live").all()) {
    for (const canvas of await figure.locator("canvas").all()) {
      await canvas.evaluate(canvas => canvas.scrollIntoView());
      const row = await figure.locator(".live-buttons").first().boundingBox();
      if (row.y < 0 || row.y + row.height > 900)
        found.push(`the figure ${await figure.getAttribute("data-box")}: no buttons beside a panel`);
    }
  }
  return found;
}

async function look(page, file, { width, theme, prints }) {
  const found = [];
  const note = text => found.push(text);
  const onError = error => note(`script: ${error.message}`);
  const onConsole = message => message.type() === "error" && note(`console: ${message.text()}`);
  // A browser gives up its request for the icon when the address changes.
  const isGivenUp = request => request.failure().errorText === "net::ERR_ABORTED";
  const onFailed = request => isGivenUp(request) || note(`not found: ${request.url()}`);
  page.on("pageerror", onError).on("console", onConsole).on("requestfailed", onFailed);
  await page.goto(pathToFileURL(file).href);
  await page.evaluate(() => document.fonts.ready);
  (await page.evaluate(cutOff, width > 1000)).forEach(note);
  if (width < 600) (await tooSmall(page)).forEach(note);
  if (width < 600) (await together(page)).forEach(note);
  (await page.evaluate(broken)).forEach(note);
  (await play(page)).forEach(note);
  (await stepThrough(page)).forEach(note);
  // A movie, which is no page of the book, has no state in its address.
  if (file.startsWith(BOOK)) (await restored(page)).forEach(note);
  (await filter(page)).forEach(note);
  if (width > 1000) (await headStays(page)).forEach(note);
  (await turns(page)).forEach(note);
  (await enlarge(page)).forEach(note);
  (await skip(page)).forEach(note);
  (await predict(page)).forEach(note);
  (await inaccessible(page)).forEach(note);
  (await present(page, width > 1000)).forEach(note);
  await page.setViewportSize({ width, height: 900 });
  if (prints) {
    // A4 with the usual margins.
    await page.setViewportSize({ width: 718, height: 900 });
    await page.emulateMedia({ media: "print" });
    (await page.evaluate(cutOff, true)).forEach(text => note(`in print ${text}`));
    (await page.evaluate(wrapped)).forEach(text => note(`in print ${text}`));
    await page.emulateMedia({ media: "screen" });
    await page.setViewportSize({ width, height: 900 });
  }
  page.off("pageerror", onError).off("console", onConsole).off("requestfailed", onFailed);
  return found.map(text => `${path.relative(BOOK, file)}, ${width} px, ${theme}: ${text}`);
}

// All pages as one reader sees them.
async function read(browser, reader, files) {
  const colorScheme = reader.theme === "light" ? "light" : "dark";
  const context = await browser.newContext({ viewport: { width: reader.width, height: 900 }, colorScheme });
  await context.addInitScript(theme => localStorage.setItem("mdbook-theme", theme), reader.theme);
  const page = await context.newPage();
  // On a busy machine a page takes its time.
  page.setDefaultTimeout(120_000);
  const faults = [];
  for (const file of files) faults.push(...(await look(page, file, reader)));
  await context.close();
  return faults;
}

// Where no scripts run, on a phone: what plays is a picture, with text that can be read, and a caption.
async function still(browser, files) {
  const page = await browser.newPage({ javaScriptEnabled: false, viewport: { width: 390, height: 900 } });
  const faults = [];
  for (const file of files.filter(file => fs.readFileSync(file, "utf8").includes('<figure class="live"'))) {
    await page.goto(pathToFileURL(file).href);
    faults.push(...(await tooSmall(page)).map(text => `${path.relative(BOOK, file)}, no scripts: ${text}`));
    for (const figure of await page.locator("figure.live").all()) {
      const sees = what => figure.locator(what).isVisible();
      if (!(await sees("img")) || !(await sees("figcaption")))
        faults.push(`${path.relative(BOOK, file)}: no picture or no caption where no scripts run`);
    }
  }
  await page.close();
  return faults;
}

async function main() {
  const args = ["--no-sandbox", "--disable-gpu"];
  const [executablePath, ...others] = process.argv.slice(2);
  const browser = await chromium.launch({ executablePath, args });
  const files = [...pages(BOOK), ...others.map(file => path.resolve(file))];
  const faults = (await Promise.all(READERS.map(reader => read(browser, reader, files)))).flat();
  faults.push(...(await still(browser, files)));
  await browser.close();
  faults.forEach(fault => console.log(fault));
  console.log(`${files.length} pages, ${READERS.length} ways to see them, ${faults.length} faults`);
  process.exit(faults.length > 0 ? 1 : 0);
}

main();
