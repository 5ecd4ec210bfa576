// The guided tour: figures of three papers, each as a state of the page. What the texts claim, the numbers beside them show.
import { initial, type State } from '../state';
import { cube, peak, plane, saddle, torus } from './meshes';

export interface Step {
  paper: string;
  figure: string;
  title: string;
  text: string;
  state: Partial<State>;
}

const ads = 'Augsdörfer, Dodgson, Sabin: Artifact analysis';
const bgsk = 'Barthe, Gérot, Sabin, Kobbelt: Eigencomponents in the Fourier domain';
const ks = 'Kawaharada, Sugihara: Laplacian subdivision';

const on = (name: string, obj: string): Partial<State> => ({ mesh: `${name}.obj`, obj });

export const steps: Step[] = [
  { paper: ads, figure: 'Fig. 1', title: 'A wave on a triangular mesh',
    text: 'Control points sample a wave of frequency f = (0.1, 0.2). The limit surface is that wave, damped, and ripples that no control point can take away: the artifacts. Colour shows them. Pick another frequency on the map.',
    state: { scheme: 'loop', focus: 'artifacts', frequency: [0.1, 0.2] } },
  { paper: ads, figure: 'Fig. 7', title: 'Loop: artifacts over all frequencies',
    text: 'The region of frequencies that the mesh can carry is a hexagon. In the middle, where waves are long, artifacts are far below one percent; towards the border they outgrow the signal.',
    state: { scheme: 'loop', focus: 'artifacts', frequency: [0.3, 0] } },
  { paper: ads, figure: 'Fig. 9', title: 'Butterfly',
    text: 'The butterfly interpolates: the signal keeps its height, but the artifacts are larger than those of Loop beside it. For the same quality it needs about 1.4 times as many control edges along a wave.',
    state: { scheme: 'butterfly', other: 'loop', focus: 'artifacts', frequency: [0.3, 0] } },
  { paper: ads, figure: 'Fig. 11 and 12', title: 'The interpolating scheme with two smoothing stages',
    text: 'The third scheme of the paper. Perpendicular to an edge it has the artifacts of the butterfly; along an edge a little more. Drag the frequency both ways and compare.',
    state: { scheme: 'interpolating-loop', other: 'butterfly', focus: 'artifacts', frequency: [0, 0.25] } },
  { paper: bgsk, figure: 'Fig. 1, first row', title: 'Eigenvalues in their right places',
    text: 'A variant of Loop with eigenvalues 1, 1/2, 1/2, 1/4, 1/4, 1/4 at a vertex of valence 7. The tangent has frequency 1, cup and saddle are at its square: the saddle mesh becomes a smooth saddle.',
    state: { scheme: 'loop-7-bounded', focus: 'surface', valence: 7, shade: 'reflection', net: false, ...on('saddle-7', saddle(7)), camera: [30, 50, 2.2] } },
  { paper: bgsk, figure: 'Fig. 1, second row', title: 'The same list, shrinking',
    text: 'The same eigenvalues, exchanged between frequencies: now the saddle has 1/2 and the tangent 1/4. The planar mesh shrinks at the vertex, and the surface is not C¹ there. A bare list of eigenvalues cannot tell.',
    state: { scheme: 'loop-7-shrinking', other: 'loop-7-bounded', focus: 'surface', valence: 7, limit: false, levels: 3, net: false, ...on('plane-7', plane(7)), camera: [0, 89, 2.2] } },
  { paper: bgsk, figure: 'Fig. 1, third row', title: 'The same list, flat',
    text: 'A third arrangement: 1/4 sits at frequency 3, where it is no curvature. In a saddle the curvature goes to zero at the vertex, and the reflection lines show it.',
    state: { scheme: 'loop-7-flat', other: 'loop-7-bounded', focus: 'surface', valence: 7, shade: 'reflection', net: false, ...on('saddle-7', saddle(7)), camera: [30, 50, 2.2] } },
  { paper: bgsk, figure: '§2.2', title: 'Frequency says which is which',
    text: 'Every eigenvalue stands over its rotational frequency ω: tangent at 1, cup at 0, saddle at 2. Change the valence: for Loop, cup meets μ₁² exactly, while the saddle comes out above it from valence 7 on.',
    state: { scheme: 'loop', focus: 'vertex', valence: 7 } },
  { paper: bgsk, figure: '§3', title: 'Other lattices, the same view',
    text: 'Catmull–Clark by the same method. The characteristic map shows how sectors shrink towards the vertex; it is regular and injective where the surface can be C¹.',
    state: { scheme: 'catmull-clark', focus: 'vertex', valence: 5 } },
  { paper: ks, figure: 'Fig. 6 to 9', title: 'High pass and low pass Loop on a torus',
    text: 'Loop’s vertex rule with a part of the Laplacian added or taken away. High pass on the left keeps the outline, low pass on the right shrinks more than Loop.',
    state: { scheme: 'laplacian-loop', other: 'laplacian-loop-low', focus: 'surface', ...on('torus', torus()) } },
  { paper: ks, figure: 'Fig. 10 to 15', title: 'The same on a cube',
    text: 'Colour is the distance between the limit surfaces of low pass Laplacian Loop and Loop. Drag the parameter a: at 0 they are one.',
    state: { scheme: 'laplacian-loop-low', other: 'loop', focus: 'surface', shade: 'distance', ...on('cube', cube()) } },
  { paper: ks, figure: 'Fig. 23 to 28', title: 'Basis functions of the Laplacian butterfly',
    text: 'One control point at height 1, all others at 0. The low pass blend (left) is calmer than the butterfly’s basis function (right).',
    state: { scheme: 'laplacian-butterfly', parameters: { b: '3/16' }, other: 'butterfly', focus: 'surface', net: false, shade: 'gaussian', ...on('peak', peak()), camera: [20, 25, 2.6] } },
  { paper: ks, figure: 'Fig. 29 to 32', title: 'How far can b go?',
    text: 'The sweep takes b from 0, the butterfly, upwards, on the cube. Under each picture stand the tangent eigenvalue and the verdict on C¹ at a regular vertex; the paper finds C¹ lost at b = 1/4.',
    state: { scheme: 'laplacian-butterfly', focus: 'sweep', sweep: 'b', valence: 6, ...on('cube', cube()) } },
];

/** The whole state of a step: the defaults, what a person chose for the eyes, and what the step shows. */
export function stateOf(index: number, now: State): State {
  return { ...initial, theme: now.theme, projector: now.projector, ...steps[index]!.state, tour: index };
}
