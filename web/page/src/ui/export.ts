// Pictures as files.
import { download } from './dom';

export function savePng(canvas: HTMLCanvasElement, name: string): void {
  const copy = document.createElement('canvas');
  Object.assign(copy, { width: canvas.width, height: canvas.height });
  const to = copy.getContext('2d')!;
  to.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--stage');
  to.fillRect(0, 0, copy.width, copy.height);
  to.drawImage(canvas, 0, 0);
  copy.toBlob((blob) => blob && download(name, blob), 'image/png');
}

export function saveSvgText(text: string, name: string): void {
  download(name, new Blob([text], { type: 'image/svg+xml' }));
}

/** An SVG with the colours that the page's style gives it written into it. */
export function standalone(svg: SVGSVGElement): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const originals = [svg, ...svg.querySelectorAll<SVGElement>('*')];
  const copies = [copy, ...copy.querySelectorAll<SVGElement>('*')];
  originals.forEach((original, i) => {
    const style = getComputedStyle(original);
    for (const name of ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'opacity', 'fill-opacity', 'stroke-opacity', 'font-size', 'font-family', 'text-anchor'])
      copies[i]!.setAttribute(name, style.getPropertyValue(name));
    copies[i]!.removeAttribute('class');
  });
  const box = svg.getBoundingClientRect();
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  copy.setAttribute('width', String(Math.round(box.width)));
  copy.setAttribute('height', String(Math.round(box.height)));
  if (!copy.hasAttribute('viewBox')) copy.setAttribute('viewBox', `0 0 ${Math.round(box.width)} ${Math.round(box.height)}`);
  return copy.outerHTML;
}

export function saveSvg(svg: SVGSVGElement | null, name: string): void {
  if (svg) download(name, new Blob([standalone(svg)], { type: 'image/svg+xml' }));
}

export function saveSvgAsPng(svg: SVGSVGElement | null, name: string): void {
  if (!svg) return;
  const box = svg.getBoundingClientRect();
  const url = URL.createObjectURL(new Blob([standalone(svg)], { type: 'image/svg+xml' }));
  const image = new Image();
  image.onload = () => {
    const canvas = document.createElement('canvas');
    Object.assign(canvas, { width: Math.round(box.width * 2), height: Math.round(box.height * 2) });
    canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
    savePng(canvas, name);
    URL.revokeObjectURL(url);
  };
  image.src = url;
}
