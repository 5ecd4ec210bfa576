import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { deflateSync } from 'node:zlib';
import { build, defineConfig, type Plugin, type Rollup } from 'vite';
import type { Core } from './src/core/api';
import { toBase85 } from './src/core/base85';
import { catalogueOf } from './src/core/catalogue';
import { packOpening } from './src/core/opening';
import { Session } from './src/core/session';

// The folder with limn_core.mjs and limn_core.wasm (web/core builds them).
const coreFolder = resolve(__dirname, process.env.LIMN_CORE_DIR ?? '../../build/page/core');
const coreScript = resolve(coreFolder, 'limn_core.mjs');
const coreBytes = (): Buffer => readFileSync(resolve(coreFolder, 'limn_core.wasm'));
const target = 'es2022';

const policy = [
  "default-src 'none'",
  "script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:",
  'worker-src blob:',
  "style-src 'unsafe-inline'",
  'img-src data: blob:',
  "connect-src 'none'",
  "form-action 'none'",
  "base-uri 'none'",
].join('; ');

/** One script with all that it imports. */
async function bundled(entry: string, format: 'es' | 'iife'): Promise<string> {
  const made = (await build({
    configFile: false,
    logLevel: 'warn',
    resolve: { alias: { 'limn-core': coreScript } },
    build: { target, write: false, modulePreload: false, chunkSizeWarningLimit: 4000,
      rollupOptions: { input: resolve(__dirname, entry), preserveEntrySignatures: 'strict', output: { format } } },
  })) as Rollup.RollupOutput;
  return made.output[0].code;
}

let running: Promise<Core> | undefined;
/** The core, at work in this program: what the page is to know before its own core is there, it says. */
function core(): Promise<Core> {
  // Emscripten's script asks for it under Node.
  Object.assign(globalThis, { __dirname: coreFolder });
  return (running ??= (import(pathToFileURL(coreScript).href) as Promise<typeof import('limn-core')>)
    .then(async ({ default: make }) => (await make({ wasmBinary: coreBytes() })) as unknown as Core));
}

/** What the core says that it ships, as a module. */
function catalogue(): Plugin {
  const name = 'limn-catalogue';
  return {
    name,
    resolveId: (id) => (id === name ? `\0${name}` : undefined),
    async load(id) {
      return id === `\0${name}` ? `export default JSON.parse(${JSON.stringify(JSON.stringify(catalogueOf(await core())))});` : undefined;
    },
  };
}

// Puts scripts, styles and the core into the one HTML file, and the policy that forbids the network. All parts are deflated; the loader
// inflates them.
function oneFile(): Plugin {
  return {
    name: 'limn-one-file',
    enforce: 'post',
    async generateBundle(_options, bundle) {
      const html = Object.values(bundle).find((item) => item.fileName.endsWith('.html'));
      if (!html || html.type !== 'asset') return;
      let page = String(html.source);
      let program = '';
      for (const [name, item] of Object.entries(bundle)) {
        if (item.type === 'chunk') program += item.code;
        else if (name.endsWith('.css')) page = page.replace('</head>', () => `<style>${item.source}</style></head>`);
        else continue;
        delete bundle[name];
      }
      page = page.replace(/<script type="module"[^>]*><\/script>/, '').replace(/<link rel="stylesheet"[^>]*>/g, '');
      page = page.replace('<meta charset="utf-8">',
        () => `<meta charset="utf-8">\n<meta http-equiv="Content-Security-Policy" content="${policy}">`);
      const code = (text: string): Uint8Array => new TextEncoder().encode(text);
      const element = (id: string, bytes: Uint8Array): string => {
        const text = toBase85(deflateSync(bytes, { level: 9 }));
        this.info(`${id}: ${bytes.length} bytes, packed ${text.length}`);
        return `<script type="text/plain" id="${id}">${text}</script>\n`;
      };
      const opening = packOpening(new Session(await core()), catalogueOf(await core()));
      const parts = [element('opening', opening), element('worker', code(await bundled('src/core/worker.ts', 'iife'))), element('core', coreBytes()),
        `<script>${await bundled('src/loader.ts', 'iife')}</script>\n`,
        element('program', code(program)), element('painter', code(await bundled('src/space/gl_painter.ts', 'es'))), element('later', code(await bundled('src/later.ts', 'es')))];
      page = page.replace('</body>', () => `${parts.join('')}</body>`);
      html.source = page;
      const size = Buffer.byteLength(page);
      this.info(`index.html: ${size} bytes`);
      if (size > 2_000_000) this.error(`index.html has ${size} bytes; 2000000 are allowed`);
    },
  };
}

export default defineConfig({
  base: './',
  build: { target, assetsInlineLimit: 1e9, cssCodeSplit: false, modulePreload: false, chunkSizeWarningLimit: 4000 },
  plugins: [catalogue(), oneFile()],
  test: { include: ['test/unit/**/*.test.ts'], testTimeout: 30_000 },
} as Parameters<typeof defineConfig>[0]);
