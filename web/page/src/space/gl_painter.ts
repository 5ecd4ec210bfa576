// Draws pictures with WebGL, all of them by one context: each is drawn off screen and copied to the canvas that shows it.
import {
  BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, LineBasicMaterial, LineSegments, LinearFilter, Mesh, Points,
  PointsMaterial, RepeatWrapping, Scene, ShaderMaterial, Texture, WebGLRenderer,
} from 'three';
import { strip } from '../ui/colours';
import { camera, type Body, type Colours, type Look, type Painter, type Picture } from './picture';

const vertexShader = `
attribute float value;
varying vec3 n; varying vec3 eye; varying float v; varying vec2 t; varying vec3 place;
void main() {
  vec4 p = modelViewMatrix * vec4(position, 1.0);
  n = normalMatrix * normal; eye = -p.xyz; v = value; t = uv; place = position;
  gl_Position = projectionMatrix * p;
}`;
// Stripes are those of a room with long parallel lamps: where the mirrored ray meets a ceiling far away.
const fragmentShader = `
uniform int shade; uniform vec3 surface; uniform vec3 back; uniform vec3 ground; uniform vec2 range; uniform sampler2D scale;
uniform int pattern; uniform float cell; uniform sampler2D image;
varying vec3 n; varying vec3 eye; varying float v; varying vec2 t; varying vec3 place;
// 1 on the dark fields of the texture's checker: over the texture, in each triangle, in each quad, in space.
float field() {
  vec3 f;
  if (pattern == 0) f = floor(16.0 * vec3(t, 0.0));
  else if (pattern == 1) f = floor(4.0 * clamp(vec3(t, 1.0 - t.x - t.y), 1e-3, 0.999));
  else if (pattern == 2) f = vec3(floor(5.0 * clamp(t, 1e-3, 0.999)), 0.0);
  else f = floor(place / cell + 0.013);
  return mod(f.x + f.y + f.z, 2.0);
}
vec3 lit(vec3 c, vec3 m, vec3 e) {
  vec3 key = normalize(vec3(-0.45, 0.75, 0.6)), fill = normalize(vec3(0.8, -0.1, 0.5));
  float d = 0.30 + 0.66 * max(dot(m, key), 0.0) + 0.16 * max(dot(m, fill), 0.0) + 0.08 * m.y;
  float s = pow(max(dot(reflect(-key, m), e), 0.0), 36.0) * 0.22;
  float rim = pow(1.0 - abs(dot(m, e)), 3.0) * 0.10;
  return c * d + s + rim;
}
void main() {
  vec3 e = normalize(eye), m = normalize(n);
  bool inside = dot(m, e) < 0.0;
  if (inside) m = -m;
  vec3 c = inside ? back : surface;
  if (shade == 1) {
    vec3 r = reflect(-e, m);
    float t = 9.0 * atan(r.x, r.y + 1.35);
    float w = max(fwidth(t), 1e-4);
    float band = abs(fract(t) - 0.5) * 2.0;
    float ink = smoothstep(0.5 - w * 1.2, 0.5 + w * 1.2, band);
    c = mix(vec3(0.10, 0.11, 0.13), vec3(0.97, 0.96, 0.93), mix(ink, 0.5, smoothstep(0.4, 1.2, w)));
    gl_FragColor = vec4(mix(c, lit(c, m, e), 0.25), 1.0);
  } else if (shade == 2) {
    gl_FragColor = vec4(0.5 + 0.5 * m, 1.0);
  } else if (shade == 3) {
    if (v != v) gl_FragColor = vec4(vec3(0.5), 1.0);
    else gl_FragColor = vec4(lit(texture2D(scale, vec2(clamp((v - range.x) / (range.y - range.x), 0.002, 0.998), 0.5)).rgb, m, e) , 1.0);
  } else if (shade == 4) {
    if (pattern == 4) c = texture2D(image, t).rgb;
    else if (pattern == 0) c = mix(c, c * vec3(0.35 + 0.5 * fract(t.x), 0.45, 0.35 + 0.5 * fract(t.y)), field());
    else c = mix(c, c * 0.55, field());
    gl_FragColor = vec4(lit(c, m, e), 1.0);
  } else gl_FragColor = vec4(lit(c, m, e), 1.0);
}`;

const textures = new Map<boolean, DataTexture>();
function scale(signed: boolean): DataTexture {
  let made = textures.get(signed);
  if (!made) {
    made = new DataTexture(strip(signed), 256, 1);
    made.magFilter = made.minFilter = LinearFilter;
    made.needsUpdate = true;
    textures.set(signed, made);
  }
  return made;
}

const shadeNumber = { plain: 0, reflection: 1, normals: 2, gaussian: 3, mean: 3, distance: 3, texture: 4 } as const;
const patterns = ['image', 'triangles', 'quads', 'none'];

interface Built {
  scene: Scene;
  picture: Picture;
  geometry?: BufferGeometry;
}

/** Where the texture differs from corner to corner, each triangle has vertices of its own. */
function cornerByCorner(body: Body, coordinates: Float32Array): BufferGeometry {
  const { triangles } = body;
  const spread = (from: Float32Array): Float32Array => {
    const to = new Float32Array(3 * triangles.length);
    for (let i = 0; i < triangles.length; ++i) for (let c = 0; c < 3; ++c) to[3 * i + c] = from[3 * triangles[i]! + c]!;
    return to;
  };
  const made = new BufferGeometry();
  made.setAttribute('position', new BufferAttribute(spread(body.positions), 3));
  made.setAttribute('normal', new BufferAttribute(spread(body.normals), 3));
  made.setAttribute('uv', new BufferAttribute(coordinates, 2));
  return made;
}

export class GlPainter implements Painter {
  readonly name = 'webgl';
  private renderer: WebGLRenderer;
  private material = new ShaderMaterial({
    vertexShader, fragmentShader, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    uniforms: { shade: { value: 0 }, surface: { value: new Color() }, back: { value: new Color() }, ground: { value: new Color() },
      range: { value: [0, 1] }, scale: { value: null }, pattern: { value: 3 }, cell: { value: 1 }, image: { value: null } },
  });
  private built = new WeakMap<HTMLCanvasElement, Built>();
  private flat = new Float32Array(0);
  private image?: Texture;

  constructor(canvas: HTMLCanvasElement, context: WebGL2RenderingContext) {
    this.renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true });
    this.renderer.outputColorSpace = 'srgb-linear' as never;
    this.renderer.setClearColor(0, 0);
    // Sorting asks for bounds, which points without a limit (NaN) do not have.
    this.renderer.sortObjects = false;
  }

  draw(picture: Picture, look: Look, canvas: HTMLCanvasElement, colours: Colours): boolean {
    const { width, height } = canvas;
    if (width === 0 || height === 0) return true;
    const built = this.build(picture, canvas, colours);
    const target = this.renderer.domElement;
    if (target.width < width || target.height < height)
      this.renderer.setSize(Math.max(width, target.width), Math.max(height, target.height), false);
    this.renderer.setViewport(0, 0, width, height);
    this.renderer.setScissor(0, 0, width, height);
    this.renderer.setScissorTest(true);
    const uniforms = this.material.uniforms;
    const colour = (text: string): Color => new Color().setStyle(text, 'srgb-linear');
    uniforms.surface!.value = colour(colours.surface);
    uniforms.back!.value = colour(colours.back);
    if (picture.body) {
      const { shade, texture, image } = picture.body;
      uniforms.shade!.value = picture.body.values || shadeNumber[shade] !== 3 ? shadeNumber[shade] : 0;
      const pattern = texture?.pattern ?? 'none';
      uniforms.pattern!.value = image && (pattern === 'image' || pattern === 'quads') ? 4 : patterns.indexOf(pattern);
      uniforms.cell!.value = picture.radius / 8;
      uniforms.image!.value = image && shade === 'texture' ? this.imageOf(image) : null;
      uniforms.range!.value = picture.body.range ?? [0, 1];
      uniforms.scale!.value = scale(picture.body.shade !== 'distance');
    }
    this.renderer.render(built.scene, camera(picture, look, width / height));
    const to = canvas.getContext('2d')!;
    to.clearRect(0, 0, width, height);
    to.drawImage(target, 0, target.height - height, width, height, 0, 0, width, height);
    return true;
  }

  private build(picture: Picture, canvas: HTMLCanvasElement, colours: Colours): Built {
    const before = this.built.get(canvas);
    if (before?.picture === picture) return before;
    const scene = new Scene();
    const built: Built = { scene, picture };
    if (picture.body) {
      built.geometry = this.geometry(picture.body, before);
      const mesh = new Mesh(built.geometry, this.material);
      mesh.frustumCulled = false;
      scene.add(mesh);
    }
    if (before?.geometry && before.geometry !== built.geometry) before.geometry.dispose();
    before?.scene.traverse((item) => {
      if (item instanceof LineSegments || item instanceof Points) {
        item.geometry.dispose();
        item.material.dispose();
      }
    });
    this.addMarks(scene, picture, colours);
    this.built.set(canvas, built);
    return built;
  }

  /** Of an animation only the positions change: the buffers of before are filled anew. */
  private geometry(body: Body, before?: Built): BufferGeometry {
    if (body.texture && body.texture.pattern !== 'none') return cornerByCorner(body, body.texture.coordinates);
    const old = before?.geometry;
    const values = body.values ?? this.zeros(body.positions.length / 3);
    if (old && before?.picture.body?.triangles === body.triangles && old.index && old.getAttribute('position').count * 3 === body.positions.length) {
      for (const [name, array] of [['position', body.positions], ['normal', body.normals], ['value', values]] as const) {
        const attribute = old.getAttribute(name) as BufferAttribute;
        attribute.array = array;
        attribute.needsUpdate = true;
      }
      return old;
    }
    const made = new BufferGeometry();
    made.setAttribute('position', new BufferAttribute(body.positions, 3));
    made.setAttribute('normal', new BufferAttribute(body.normals, 3));
    made.setAttribute('value', new BufferAttribute(values, 1));
    made.setIndex(new BufferAttribute(body.triangles, 1));
    return made;
  }

  private imageOf(image: ImageBitmap): Texture {
    if (this.image?.image !== image) {
      this.image?.dispose();
      this.image = new Texture(image);
      this.image.wrapS = this.image.wrapT = RepeatWrapping;
      this.image.flipY = false;
      this.image.needsUpdate = true;
    }
    return this.image;
  }

  private zeros(count: number): Float32Array {
    if (this.flat.length !== count) this.flat = new Float32Array(count);
    return this.flat;
  }

  private addMarks(scene: Scene, picture: Picture, colours: Colours): void {
    const colour = (kind: string): Color =>
      new Color().setStyle(kind === 'net' ? colours.net : kind === 'seam' ? colours.ink : colours.accent, 'srgb-linear');
    for (const wires of picture.wires) {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(wires.positions, 3));
      geometry.setIndex(new BufferAttribute(wires.segments, 1));
      const lines = new LineSegments(geometry, new LineBasicMaterial({
        color: colour(wires.kind), transparent: true, opacity: wires.kind === 'seam' ? 0.28 : wires.kind === 'net' ? 0.75 : 1 }));
      lines.frustumCulled = false;
      scene.add(lines);
    }
    for (const dots of picture.dots) {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(dots.positions, 3));
      const size = (dots.kind === 'net' ? 4 : 9) * Math.min(2, globalThis.devicePixelRatio || 1);
      const points = new Points(geometry, new PointsMaterial({ color: colour(dots.kind), size, sizeAttenuation: false }));
      points.frustumCulled = false;
      scene.add(points);
    }
  }
}
