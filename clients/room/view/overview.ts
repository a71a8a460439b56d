import { palette } from "../view/palette";
import { Camera } from "./camera";
import { enter } from "./piece_painter";
import type { Scene } from "./scene";
import type { Stage } from "./stage";

/** The overview of the marker at the bottom, with a frame around the part that the stage shows; the frame can be dragged. */
export class Overview {
  private readonly context: CanvasRenderingContext2D;
  private picture: HTMLCanvasElement | undefined;
  private camera: Camera | undefined;
  private waiting = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly scene: Scene,
    private readonly stage: Stage,
  ) {
    this.context = canvas.getContext("2d")!;
    const go = (event: PointerEvent) => this.go(event);
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      go(event);
    });
    canvas.addEventListener("pointermove", (event) => event.buttons && go(event));
    scene.camera.follow(() => this.drawFrame());
    palette.follow(() => this.renew());
    new ResizeObserver(() => this.renew()).observe(canvas);
  }

  /** Redraws the pieces when the browser is idle. */
  renew(): void {
    if (this.waiting) return;
    this.waiting = window.setTimeout(() => {
      this.waiting = 0;
      this.paint();
    }, 60);
  }

  private paint(): void {
    const { canvas, scene } = this;
    const marker = scene.marker;
    const colours = palette.value;
    const ratio = devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (!marker || !colours || width === 0 || height === 0) return;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    this.camera = Camera.fitting(this.stage.bounds, width, height, { left: 12, right: 12, top: 8, bottom: 8 });
    this.picture = document.createElement("canvas");
    this.picture.width = canvas.width;
    this.picture.height = canvas.height;
    const context = this.picture.getContext("2d")!;
    const brush = { context, camera: this.camera, ratio, colours };
    const [left, top] = this.camera.toScreen([0, marker.width]);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = colours.cloth;
    context.fillRect(left, top, this.stage.bounds.right * this.camera.scale, marker.width * this.camera.scale);
    for (const piece of marker.pieces) {
      enter(brush, piece.pose);
      context.fillStyle = scene.colouring.value.fillOf(piece, colours);
      const { box } = piece.shape;
      if (marker.pieces.length > 3000) context.fillRect(box.left, box.bottom, box.right - box.left, box.top - box.bottom);
      else context.fill(piece.shape.coarse);
    }
    this.drawFrame();
  }

  private drawFrame(): void {
    const { context, canvas, camera, picture, stage } = this;
    const view = this.scene.camera.value;
    const colours = palette.value;
    if (!camera || !view || !picture || !colours) return;
    const ratio = devicePixelRatio || 1;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(picture, 0, 0);
    const box = view.window(stage.width, stage.height);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const [left, top] = camera.toScreen([box.left, box.top]);
    const [right, bottom] = camera.toScreen([box.right, box.bottom]);
    const clip = (value: number, most: number) => Math.min(Math.max(value, 1), most - 1);
    const [x, y] = [clip(left, canvas.clientWidth), clip(top, canvas.clientHeight)];
    context.strokeStyle = colours.accent;
    context.lineWidth = 1.5;
    context.strokeRect(x, y, clip(right, canvas.clientWidth) - x, clip(bottom, canvas.clientHeight) - y);
  }

  private go(event: PointerEvent): void {
    const view = this.scene.camera.value;
    if (!this.camera || !view) return;
    const [x] = this.camera.toCloth([event.offsetX, event.offsetY]);
    this.stage.look(new Camera(view.scale, this.stage.width / 2 - x * view.scale, view.y));
  }
}
