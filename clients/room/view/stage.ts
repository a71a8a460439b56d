import { preferences } from "../base/preferences";
import type { Piece } from "../marker/marker";
import type { Box } from "../marker/outline";
import { paintChain, paintRegions } from "./chain_painter";
import { Camera } from "./camera";
import { paintCloth, paintRuler } from "./cloth_painter";
import { times } from "./frame_times";
import { paintFaults, paintGhosts, paintLength, paintNewcomers, paintOthersDrags, paintOverlaps, paintPlaces, paintSelection, paintStroke, paintTiltWorth } from "./marks_painter";
import { palette, readPalette } from "./palette";
import { paintLabel, paintPiece, type Brush } from "./piece_painter";
import { paintMatchPoints, paintPattern, paintRooms, paintRules } from "./rules_painter";
import type { Scene } from "./scene";

// Margins for the tools at the left, the ruler above, and the length or a result below.
const MARGIN = { left: 78, right: 52, top: 46, bottom: 74 };
const SMALL = { left: 14, right: 44, top: 92, bottom: 74 };
const SLOW = 9; // if drawing all settled pieces takes more milliseconds than this, panning first moves their picture

/**
 * Two canvases: the lower one shows the cloth and the settled pieces, the upper one the moving pieces and all marks. A drag
 * redraws only the upper one; the lower one is redrawn when the set of moving pieces changes.
 */
export class Stage {
  width = 0;
  height = 0;
  private ratio = 1;
  private frame = 0;
  private settledIsOld = true;
  private drawnIds = "";
  private drawnCamera: Camera | undefined;
  private pause = 0;
  private readonly lower: CanvasRenderingContext2D;
  private readonly upper: CanvasRenderingContext2D;

  constructor(
    private readonly host: HTMLElement,
    readonly base: HTMLCanvasElement,
    readonly top: HTMLCanvasElement,
    private readonly scene: Scene,
  ) {
    this.lower = base.getContext("2d", { alpha: false })!;
    this.upper = top.getContext("2d")!;
    scene.onChange = (what) => this.request(what === "settled");
    scene.camera.follow(() => this.request(true));
    preferences.follow(() => this.recolour());
    for (const query of ["(prefers-color-scheme: dark)", "(prefers-contrast: more)", "(forced-colors: active)"]) {
      matchMedia(query).addEventListener("change", () => this.recolour());
    }
    new ResizeObserver(() => this.resize()).observe(host);
  }

  private recolour(): void {
    document.documentElement.dataset["theme"] = preferences.value.theme;
    palette.value = readPalette();
    this.request(true);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    this.width = clientWidth;
    this.height = clientHeight;
    this.ratio = devicePixelRatio || 1;
    for (const canvas of [this.base, this.top]) {
      canvas.width = Math.round(clientWidth * this.ratio);
      canvas.height = Math.round(clientHeight * this.ratio);
    }
    if (this.fitted) this.fit(this.fitted === "whole");
    this.drawnCamera = undefined;
    this.request(true);
  }

  // What the view is fitted to, also when its size changes; undefined once the user has zoomed or panned.
  private fitted: "whole" | "width" | undefined = "whole";
  look(camera: Camera): void {
    this.fitted = undefined;
    this.scene.camera.value = camera;
  }

  get bounds(): Box {
    const marker = this.scene.marker;
    return { left: 0, right: Math.max(this.scene.length, 1e-9), bottom: 0, top: marker?.width ?? 1 };
  }

  /** Whether the whole marker would appear as a thin strip in this view. */
  get isLong(): boolean {
    const { right, top } = this.bounds;
    return right > 2.5 * top;
  }

  /** Shows the whole marker. For a long marker, it alternates between that and the beginning of the marker in full width. */
  fit(whole = !this.isLong || this.fitted !== "whole"): void {
    if (this.width === 0 || !this.scene.marker) return;
    this.fitted = whole ? "whole" : "width";
    const margin = this.width < 700 ? SMALL : MARGIN;
    const { top } = this.bounds;
    const right = (top * (this.width - margin.left - margin.right)) / (this.height - margin.top - margin.bottom);
    this.scene.camera.value = Camera.fitting(whole ? this.bounds : { left: 0, bottom: 0, right, top }, this.width, this.height, margin);
  }

  /** Pans to a part of the cloth, unless all of it is in view. */
  reveal(box: Box): void {
    const camera = this.scene.camera.value;
    if (!camera) return;
    const { left, right, bottom, top } = camera.window(this.width, this.height);
    if (box.left >= left && box.right <= right && box.bottom >= bottom && box.top <= top) return;
    const { scale } = camera;
    this.look(new Camera(scale, this.width / 2 - ((box.left + box.right) / 2) * scale, this.height / 2 + ((box.bottom + box.top) / 2) * scale));
  }

  zoom(factor: number, at: [number, number] = [this.width / 2, this.height / 2]): void {
    const { camera, marker } = this.scene;
    if (!camera.value || !marker) return;
    const whole = Math.min(this.width / this.bounds.right, this.height / marker.width);
    this.look(camera.value.zoomed(factor, at, { least: whole / 4, most: (this.height / marker.width) * 400 }));
  }

  /** The selected pieces or, if there are none, those that are entirely in view. */
  chosen(): Piece[] {
    const { scene } = this;
    const view = scene.camera.value?.window(this.width, this.height);
    const selected = scene.selected();
    if (selected.length > 0 || !view || !scene.marker) return selected;
    return scene.marker.pieces.filter(({ box }) => box.left >= view.left && box.right <= view.right && box.bottom >= view.bottom && box.top <= view.top);
  }

  /** Requests an animation frame. */
  request(settled: boolean): void {
    this.settledIsOld ||= settled;
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.draw());
  }

  private draw(): void {
    this.frame = 0;
    const start = performance.now();
    const { marker, camera } = this.scene;
    const colours = palette.value;
    if (!marker || !camera.value || !colours || this.width === 0) return;
    const ids = this.scene.movingIds();
    const key = ids.size > 2000 ? `${ids.size}` : [...ids].join("\n");
    if (key !== this.drawnIds) this.settledIsOld = true;
    this.drawnIds = key;
    if (this.settledIsOld) this.drawSettled(camera.value);
    const brush: Brush = { context: this.upper, camera: camera.value, ratio: this.ratio, colours };
    this.drawMoving(brush, ids);
    times.frame.add(performance.now() - start);
    if (this.scene.flying) this.request(false);
  }

  // Moves the picture of the settled pieces while the camera moves, if redrawing them would be too slow.
  private drawSettled(camera: Camera): void {
    const drawn = this.drawnCamera;
    if (drawn && drawn !== camera && times.settled.last > SLOW && this.pause === 0) {
      this.pause = window.setTimeout(() => {
        this.pause = 0;
        this.drawnCamera = undefined;
        this.request(true);
      }, 90);
    }
    if (drawn && drawn !== camera && this.pause !== 0) {
      const ratio = camera.scale / drawn.scale;
      this.base.style.transform = `translate(${camera.x - drawn.x * ratio}px, ${camera.y - drawn.y * ratio}px) scale(${ratio})`;
      return;
    }
    const start = performance.now();
    this.base.style.transform = "";
    this.settledIsOld = false;
    this.drawnCamera = camera;
    const brush: Brush = { context: this.lower, camera, ratio: this.ratio, colours: palette.value! };
    this.paintSettled(brush);
    times.settled.add(performance.now() - start);
  }

  private paintSettled(brush: Brush): void {
    const { context, camera } = brush;
    const { scene, width, height } = this;
    const marker = scene.marker!;
    const paper = getComputedStyle(this.host).backgroundColor;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = paper;
    context.fillRect(0, 0, this.base.width, this.base.height);
    paintCloth(brush, scene, width, height, preferences.value);
    paintRules(brush, scene, width);
    paintRegions(brush, scene);
    const view = camera.window(width, height);
    const colouring = scene.colouring.value;
    const visible = marker.pieces.filter(
      ({ id, box }) => box.right >= view.left && box.left <= view.right && box.top >= view.bottom && box.bottom <= view.top && !scene.moves(id),
    );
    for (const piece of visible) paintPiece(brush, piece, piece.pose, colouring);
    for (const piece of visible) paintLabel(brush, piece, piece.pose, preferences.value.labels);
    paintPattern(brush, marker, width);
    paintMatchPoints(brush, visible, ({ pose }) => pose);
    paintRuler(brush, scene, width, paper);
  }

  private drawMoving(brush: Brush, ids: ReadonlySet<string>): void {
    const { context } = brush;
    const { scene } = this;
    const now = performance.now();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.top.width, this.top.height);
    const moving = [...ids].flatMap((id) => scene.marker!.byId.get(id) ?? []);
    moving.sort((a, b) => Number(scene.dragged.has(a.id)) - Number(scene.dragged.has(b.id)) || a.index - b.index);
    for (const piece of moving) paintPiece(brush, piece, scene.poseOf(piece, now), scene.colouring.value);
    for (const piece of moving) paintLabel(brush, piece, scene.poseOf(piece, now), preferences.value.labels);
    paintMatchPoints(brush, moving, (piece) => scene.poseOf(piece, now));
    paintOverlaps(brush, scene, now);
    paintPlaces(brush, scene);
    paintNewcomers(brush, scene, preferences.value.labels);
    paintGhosts(brush, scene);
    paintLength(brush, scene);
    paintSelection(brush, scene, now);
    paintChain(brush, scene, now, preferences.value.labels);
    paintRooms(brush, scene);
    paintTiltWorth(brush, scene, now);
    paintOthersDrags(brush, scene);
    paintFaults(brush, scene);
    if (scene.stroke) paintStroke(brush, scene.stroke);
  }
}
