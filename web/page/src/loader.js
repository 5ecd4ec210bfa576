// Inflates the program and runs it; says what is needed where the browser cannot.
(async () => {
  try {
    const text = document.getElementById('program').textContent;
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    const url = URL.createObjectURL(await new Response(stream).blob().then((b) => b.slice(0, b.size, 'text/javascript')));
    await import(url);
    URL.revokeObjectURL(url);
  } catch (error) {
    document.getElementById('app').textContent =
      'This page needs a browser with WebAssembly and DecompressionStream (Chrome 103, Firefox 113, Safari 16.4 or newer). ' + error;
  }
})();
