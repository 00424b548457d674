// The lumen in space, by three.js.
"use strict";

class Space {
  constructor(canvas, hint, lumen, state) {
    Object.assign(this, { canvas, hint, lumen, state });
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.localClippingEnabled = true;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.01, 1000);
    this.scene.add(this.camera, new THREE.HemisphereLight(0xffffff, 0xcfd6da, 1.6));
    const lamp = new THREE.DirectionalLight(0xffffff, 1.6);
    lamp.position.set(0.4, 0.8, 1);
    this.camera.add(lamp);
    this.cut = new THREE.Plane(new THREE.Vector3(0, 0, -1), 0);
    this.makeSurface();
    this.makeArrow();
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enablePan = false;
    this.controls.enableZoom = false; // until the canvas is taken hold of: the wheel is for the page
    this.controls.addEventListener("change", () => this.render());
    canvas.addEventListener("pointerdown", () => { this.controls.enableZoom = true; });
    canvas.addEventListener("pointerleave", () => { this.controls.enableZoom = false; hint.textContent = ""; });
    canvas.addEventListener("pointermove", (event) => this.read(event));
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.lookAt();
    this.resize();
  }

  makeSurface() {
    this.geometry = new THREE.BufferGeometry();
    for (const name of ["position", "color"]) {
      this.geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(3 * this.lumen.vertices), 3));
    }
    this.geometry.setIndex(new THREE.BufferAttribute(this.lumen.triangles(), 1));
    this.material = new THREE.MeshLambertMaterial({ vertexColors: true, side: THREE.DoubleSide });
    this.mesh = new THREE.Mesh(this.geometry, this.material);
    this.scene.add(this.mesh);
  }

  makeArrow() {
    if (!this.lumen.arrow) return;
    const [from, to] = this.lumen.arrow.map((end) => new THREE.Vector3(...end));
    const way = to.clone().sub(from), length = way.length();
    if (!(length > 0)) return;
    const reach = this.lumen.kind === "grid" ? 0.35 * length : Math.min(0.25 * length, 0.5 * this.lumen.length_mm);
    // In a lumen that lies as it likes, before the inlet; else beneath the middle
    const start = this.lumen.kind === "grid" ? from.lerp(to, 0.325) : from.addScaledVector(way, -1.2 * reach / length);
    this.scene.add(new THREE.ArrowHelper(way.normalize(), start, reach, 0x1d2328, 0.3 * reach, 0.16 * reach));
  }

  lookAt() {
    this.geometry.computeBoundingSphere();
    const half = (this.camera.fov * Math.PI) / 360;
    this.reach = this.lumen.reach;
    this.back = ((this.lumen.kind === "grid" ? 1.25 : 1.12) * this.reach) / Math.sin(half);
    this.camera.position.set(...this.lumen.from).setLength(this.back);
    this.controls.update();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    // A narrow window sees as much of the width as a wide one
    this.camera.zoom = Math.min(1.25, width / height);
    this.camera.near = this.back / 100;
    this.camera.far = 10 * this.back;
    this.camera.updateProjectionMatrix();
    this.render();
  }

  show() {
    const { frame, quantity, steel } = this.state;
    const position = this.geometry.getAttribute("position"), color = this.geometry.getAttribute("color");
    const tone = new THREE.Color();
    for (let v = 0; v < this.lumen.vertices; ++v) {
      position.setXYZ(v, ...this.lumen.position(frame, v));
      const grey = steel && this.lumen.strut(frame, v);
      const share = quantity ? (quantity.at(frame, v) - quantity.low) / (quantity.high - quantity.low) : NaN;
      const [r, g, b] = grey ? steelColour : colourOf(quantity?.map ?? "stress", share);
      tone.setRGB(r / 255, g / 255, b / 255, "srgb");
      color.setXYZ(v, tone.r, tone.g, tone.b);
    }
    position.needsUpdate = color.needsUpdate = true;
    this.geometry.computeVertexNormals();
    this.geometry.computeBoundingSphere();
    this.material.clippingPlanes = this.state.cut ? [this.cut] : [];
    this.render();
  }

  render() { this.renderer.render(this.scene, this.camera); }

  read(event) {
    const box = this.canvas.getBoundingClientRect();
    const at = new THREE.Vector2((2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(at, this.camera);
    const hit = ray.intersectObject(this.mesh).find(({ point }) => !this.state.cut || this.cut.distanceToPoint(point) >= 0);
    this.hint.textContent = hit ? this.state.reading(hit.face.a) : "";
  }
}
