import {
  BackSide, DirectionalLight, Mesh, NeutralToneMapping, PCFShadowMap, PerspectiveCamera, PMREMGenerator, Scene,
  ShaderMaterial, SphereGeometry, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const towardsSun = new Vector3(0.5, 0.75, 0.35).normalize();

/** Camera, light and sky about a film. Draws only when something has changed. */
export class Stage {
  constructor(canvas) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.toneMapping = NeutralToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(30);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.touch());

    const light = new Scene().add(sky(true));
    this.scene.environment = new PMREMGenerator(this.renderer).fromScene(light, 0.01).texture;
    this.sky = sky(false);
    this.sun = new DirectionalLight(0xfff0d8, 2.6);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.radius = 3;
    this.sun.shadow.normalBias = 0.02;
    this.scene.add(this.sky, this.sun, this.sun.target);

    new ResizeObserver(() => this.#resize()).observe(canvas);
    this.#resize();
  }

  touch() {
    this.isStale = true;
  }

  show(film) {
    if (this.film) {
      this.scene.remove(this.film.root);
      this.film.dispose();
    }
    this.film = film;
    this.scene.add(film.root);
    this.#lightUp();
    this.resetView();
  }

  /** Seen from above and aside, from as near as all of the film's stage is in the picture, above the controls. */
  resetView() {
    if (!this.film) return;
    const { min, max } = this.film.bounds, radius = min.distanceTo(max) / 2;
    const backward = new Vector3(0.45, 0.4, 0.8).normalize();
    const right = new Vector3(0, 1, 0).cross(backward).normalize(), up = backward.clone().cross(right);
    const tangent = Math.tan(this.camera.fov * Math.PI / 360);
    const above = 0.94 * tangent, below = 0.76 * tangent, beside = 0.94 * tangent * this.camera.aspect;
    // Each side of the picture is a plane that all corners lie within.
    const corners = Array.from({ length: 8 }, (_, i) =>
      new Vector3(i & 1 ? min.x : max.x, i & 2 ? min.y : max.y, i & 4 ? min.z : max.z));
    const furthest = (axis, slope) => Math.max(...corners.map((c) => c.dot(axis) + slope * c.dot(backward)));
    const top = furthest(up, above), bottom = furthest(up.clone().negate(), below);
    const rightmost = furthest(right, beside), leftmost = furthest(right.clone().negate(), beside);
    const back = Math.max((top + bottom) / (above + below), (rightmost + leftmost) / (2 * beside));
    const place = new Vector3()
      .addScaledVector(backward, back)
      .addScaledVector(right, (rightmost - leftmost) / 2)
      .addScaledVector(up, (top - bottom + (below - above) * back) / 2);

    this.camera.near = radius / 100;
    this.camera.far = radius * 60;
    this.camera.updateProjectionMatrix();
    this.sky.scale.setScalar(radius * 50);
    Object.assign(this.controls, { minDistance: radius / 20, maxDistance: radius * 8 });
    this.camera.position.copy(place);
    const centre = min.clone().add(max).divideScalar(2);
    this.controls.target.copy(place).addScaledVector(backward, -place.sub(centre).dot(backward));
    this.controls.update();
    this.touch();
  }

  draw() {
    this.sky.position.copy(this.camera.position);
    this.renderer.render(this.scene, this.camera);
    this.isStale = false;
  }

  #lightUp() {
    const { min, max } = this.film.bounds, radius = min.distanceTo(max) / 2;
    this.sun.target.position.addVectors(min, max).divideScalar(2);
    this.sun.position.copy(this.sun.target.position).addScaledVector(towardsSun, 2 * radius);
    Object.assign(this.sun.shadow.camera, {
      left: -radius, right: radius, bottom: -radius, top: radius, near: radius / 10, far: 4 * radius,
    });
    this.sun.shadow.camera.updateProjectionMatrix();
  }

  #resize() {
    const { clientWidth, clientHeight } = this.renderer.domElement;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / Math.max(clientHeight, 1);
    this.camera.updateProjectionMatrix();
    this.draw();  // at once, since the canvas is blank now
  }
}

/** As the eye sees it: light all around. Or as it lights and the water mirrors it: darker above, with a glow of sun. */
function sky(lights) {
  const material = new ShaderMaterial({
    side: BackSide, depthWrite: false, toneMapped: false,
    defines: lights ? { LIGHTS: '' } : {},
    uniforms: { towardsSun: { value: towardsSun } },
    vertexShader: `
      varying vec3 direction;
      void main() {
        direction = position;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      uniform vec3 towardsSun;
      varying vec3 direction;
      void main() {
        vec3 towards = normalize(direction);
        #ifdef LIGHTS
          vec3 colour = mix(vec3(0.85, 0.9, 0.95), vec3(0.10, 0.26, 0.55), pow(max(towards.y, 0.0), 0.5));
          colour = mix(colour, vec3(0.22, 0.27, 0.30), smoothstep(0.0, -0.3, towards.y));
          colour += 6.0 * pow(max(dot(towards, towardsSun), 0.0), 120.0);
        #else
          vec3 colour = mix(vec3(0.78, 0.86, 0.93), vec3(0.55, 0.72, 0.90), max(towards.y, 0.0));
        #endif
        gl_FragColor = vec4(colour, 1.0);
        #include <colorspace_fragment>
        float noise = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453);
        gl_FragColor.rgb += (noise - 0.5) / 255.0;  // or steps of brightness would be seen
      }`,
  });
  const mesh = new Mesh(new SphereGeometry(1, 48, 24), material);
  mesh.frustumCulled = false;
  mesh.renderOrder = -1;
  return mesh;
}
