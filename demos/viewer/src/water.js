import {
  BackSide, BufferAttribute, BufferGeometry, Color, DoubleSide, FrontSide, Mesh, MeshBasicMaterial,
  MeshPhysicalMaterial, Vector3,
} from 'three';

const shallow = new Color(0x8cc3d0), deep = new Color(0x2f7f98);

/**
 * Makes of the film's surface a block that is cut out of the sea, down to the height `bottom`: the surface, which is
 * clear from above and a mirror of the sky from aside, clear walls before the bodies, and coloured ones behind them.
 */
export function dressWater(surface, bottom) {
  surface.material.dispose();
  surface.material = surfaceMaterial();
  surface.receiveShadow = true;
  surface.renderOrder = 2;

  const walls = wallGeometry(surface.geometry, bottom);
  const behind = new Mesh(walls, new MeshBasicMaterial({ vertexColors: true, side: BackSide }));
  const before = new Mesh(walls, new MeshBasicMaterial({
    vertexColors: true, transparent: true, opacity: 0.45, side: FrontSide, depthWrite: false,
  }));
  before.renderOrder = 1;
  for (const wall of [behind, before]) {
    wall.morphTargetInfluences = surface.morphTargetInfluences;  // they move as one
    surface.add(wall);
  }
}

function surfaceMaterial() {
  const material = new MeshPhysicalMaterial({
    color: 0x0f5b70, roughness: 0.12, ior: 1.33, transparent: true, side: DoubleSide, envMapIntensity: 1.3,
  });
  // What is not reflected is let through.
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace('#include <opaque_fragment>', `
      float aslant = 1.0 - abs(dot(normal, normalize(vViewPosition)));
      diffuseColor.a = mix(0.5, 1.0, pow(aslant, 4.0));
      #include <opaque_fragment>`);
  };
  return material;
}

/** Edges of only one triangle, as pairs of vertices, with the surface to their left as seen from above. */
function borderOf(index) {
  const edges = new Map();
  for (let i = 0; i < index.count; ++i) {
    const from = index.getX(i), to = index.getX(i % 3 === 2 ? i - 2 : i + 1);
    if (!edges.delete(`${to} ${from}`)) edges.set(`${from} ${to}`, [from, to]);
  }
  return [...edges.values()];
}

/** A wall under each edge of the border, whose top moves with the surface, and a floor; all face outward. */
function wallGeometry(surface, bottom) {
  const border = borderOf(surface.index), indices = [];
  const tops = border.flat();  // then as many at the bottom
  for (let i = 0; i < tops.length; i += 2)
    indices.push(i, tops.length + i, tops.length + i + 1, i, tops.length + i + 1, i + 1);

  const positions = [], colours = [], vertex = new Vector3();
  for (const isTop of [true, false])
    for (const top of tops) {
      vertex.fromBufferAttribute(surface.attributes.position, top);
      if (!isTop) vertex.y = bottom;
      positions.push(...vertex);
      colours.push(...(isTop ? shallow : deep));
    }

  const centre = positions.length / 3;
  surface.computeBoundingBox();
  surface.boundingBox.getCenter(vertex).setY(bottom);
  positions.push(...vertex);
  colours.push(...deep);
  for (let i = tops.length; i < centre; i += 2) indices.push(i + 1, i, centre);

  const geometry = new BufferGeometry().setIndex(indices);
  const attribute = (numbers) => new BufferAttribute(new Float32Array(numbers), 3);
  geometry.setAttribute('position', attribute(positions));
  geometry.setAttribute('color', attribute(colours));
  geometry.morphTargetsRelative = true;
  const rises = surface.morphAttributes.position;
  if (rises)
    geometry.morphAttributes.position = rises.map((rise) => attribute(Array.from({ length: positions.length }, (_, i) =>
      i < 3 * tops.length ? rise.array[3 * tops[Math.floor(i / 3)] + i % 3] : 0)));
  return geometry;
}
