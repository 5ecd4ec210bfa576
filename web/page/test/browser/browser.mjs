// Debian's chromium, headless, with WebGL in software, on the one file as it is opened from a disk.
import { existsSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const places = [process.env.LIMN_CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];

export async function launch({ webgl = true } = {}) {
  const executablePath = places.find((place) => place && existsSync(place));
  if (!executablePath) throw new Error('no chromium: apt-get install chromium, or LIMN_CHROMIUM=PATH');
  const gl = webgl ? ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'] : ['--disable-gpu', '--disable-3d-apis'];
  return chromium.launch({ executablePath, args: ['--no-sandbox', ...gl] });
}

/** A page that is ready, with all that went wrong in it and every request that it made. */
export async function open(browser, file, fragment = '', { width = 1280, height = 800 } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, acceptDownloads: true });
  const page = await context.newPage();
  const trouble = [];
  const requests = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && !/GPU stall|swiftshader|Automatic fallback|willReadFrequently/i.test(message.text()) && trouble.push(message.text()));
  page.on('pageerror', (error) => trouble.push(String(error)));
  await context.route('**/*', (route) => {
    const url = route.request().url();
    if (url === pathToFileURL(file).href.split('#')[0] || /^(blob|data):/.test(url)) return route.continue();
    requests.push(url);
    return route.abort();
  });
  const begun = Date.now();
  await page.goto(pathToFileURL(file).href + fragment);
  await ready(page);
  return { page, context, trouble, requests, milliseconds: Date.now() - begun };
}

/** The first surface stands. */
export const ready = (page) => page.waitForFunction(() => Number(document.querySelector('[data-test=surface-status]')?.dataset.vertices) > 0, null, { timeout: 120_000 });

export const text = (page, selector) => page.locator(selector).first().textContent();
export const until = (page, act, arg) => page.waitForFunction(act, arg, { timeout: 60_000 });
