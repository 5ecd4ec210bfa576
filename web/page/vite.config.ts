import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { deflateSync } from 'node:zlib';
import { defineConfig, type Plugin } from 'vite';
import { toBase85 } from './src/core/base85';

// The folder with limn_core.mjs and limn_core.wasm (web/core builds them).
const coreFolder = resolve(__dirname, process.env.LIMN_CORE_DIR ?? '../../build/page/core');

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

const packed = (bytes: Uint8Array): Buffer => deflateSync(bytes, { level: 9 });

// Puts scripts, styles and the core into the one HTML file, and the policy that forbids the network. The program is
// deflated like the core: a line of script inflates it and imports it from a blob.
function oneFile(): Plugin {
  return {
    name: 'limn-one-file',
    enforce: 'post',
    generateBundle(_options, bundle) {
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
      const wasm = toBase85(packed(readFileSync(resolve(coreFolder, 'limn_core.wasm'))));
      const loader = readFileSync(resolve(__dirname, 'src/loader.js'), 'utf8');
      page = page.replace('</body>', () => `<script type="text/plain" id="core">${wasm}</script>\n` +
        `<script type="text/plain" id="program">${packed(new TextEncoder().encode(program)).toString('base64')}</script>\n` +
        `<script>${loader}</script>\n</body>`);
      html.source = page;
      const size = Buffer.byteLength(page);
      this.info(`index.html: ${size} bytes (core ${wasm.length}, program ${program.length} before deflation)`);
      if (size > 2_000_000) this.error(`index.html has ${size} bytes; 2000000 are allowed`);
    },
  };
}

export default defineConfig({
  base: './',
  resolve: { alias: { 'limn-core': resolve(coreFolder, 'limn_core.mjs') } },
  build: { target: 'es2022', assetsInlineLimit: 1e9, cssCodeSplit: false, modulePreload: false, chunkSizeWarningLimit: 4000 },
  worker: { format: 'iife' },
  plugins: [oneFile()],
  test: { include: ['test/unit/**/*.test.ts'], testTimeout: 30_000 },
} as Parameters<typeof defineConfig>[0]);
