import type { Point } from "../../typescript/src/index";
import { preferences } from "../base/preferences";
import type { Engine } from "../engine/engine";
import type { Places } from "../engine/places";
import { isLocked, type Piece } from "../marker/marker";
import type { Desk } from "../session/desk";
import { errorText } from "../session/messages";
import { say } from "../texts/texts";
import type { Scene } from "../view/scene";
import type { Stage } from "../view/stage";
import type { Commands } from "./commands";
import { FreeDrag } from "./free_drag";
import { announceDrag } from "./announce_drag";
import { LiveDrag } from "./live_drag";
import type { Settling } from "./settling";
import { gravity, openGap, tool } from "./tools";

const SLACK = 4; // pixels that a pointer may move in a click

interface Drag {
  move(by: Point): void;
  end(commit: boolean): Promise<void>;
}
type Doing =
  | { kind: "pan"; last: Point }
  | { kind: "press"; piece: Piece; at: Point; toggled: boolean }
  | { kind: "drag"; drag: Drag; from: Point }
  | { kind: "stroke"; adding: boolean }
  | { kind: "place"; place: number }
  | { kind: "pinch"; middle: Point; apart: number };

/** Handles mouse, pen and touch input on the canvas. */
export class Pointer {
  private doing: Doing | undefined;
  private readonly down = new Map<number, Point>();
  panning = false; // the space bar is held

  constructor(
    private readonly canvas: HTMLElement,
    private readonly stage: Stage,
    private readonly scene: Scene,
    private readonly desk: Desk,
    private readonly engine: Engine,
    private readonly places: Places,
    private readonly commands: Commands,
    private readonly settling: Settling,
    private readonly showMessage: (text: string) => void,
  ) {
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.release(event, true));
    canvas.addEventListener("pointercancel", (event) => this.release(event, false));
    canvas.addEventListener("pointerleave", () => this.hover(undefined));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    tool.follow((chosen) => (canvas.dataset["tool"] = chosen));
  }

  private press(event: PointerEvent): void {
    const at: Point = [event.offsetX, event.offsetY];
    const { camera, marker } = this.scene;
    this.canvas.focus({ preventScroll: true });
    if (!camera.value || !marker) return;
    this.canvas.setPointerCapture(event.pointerId);
    this.down.set(event.pointerId, at);
    if (this.down.size === 2) return this.beginPinch();
    if (this.doing) return;
    const touch = event.pointerType === "touch";
    if (event.button === 1 || event.button === 2 || this.panning) this.doing = { kind: "pan", last: at };
    else if (tool.value !== "select") this.beginStroke(tool.value, at, false);
    else {
      const piece = marker.pieceAt(camera.value.toCloth(at), 0, this.scene.shown);
      const place = piece ? -1 : this.places.at(camera.value.toCloth(at));
      const adding = event.shiftKey || event.ctrlKey || event.metaKey;
      if (place >= 0) this.doing = { kind: "place", place };
      else if (piece) this.doing = { kind: "press", piece, at, toggled: this.pick(piece, event.ctrlKey || event.metaKey) };
      else if (touch) this.doing = { kind: "pan", last: at };
      else this.beginStroke("band", at, adding);
    }
    this.canvas.dataset["doing"] = this.doing?.kind ?? "";
  }

  // Selects the pressed piece, unless it is selected already, or with `adding`, adds it to the selection or takes it out.
  // Returns `adding`.
  private pick(piece: Piece, adding: boolean): boolean {
    const { selection } = this.scene;
    const together = this.scene.marker!.together(piece).map(({ id }) => id);
    if (adding) {
      const rest = new Set(selection.value);
      const had = rest.has(piece.id);
      for (const id of together) had ? rest.delete(id) : rest.add(id);
      this.scene.select(rest);
    } else if (!selection.value.has(piece.id)) this.scene.select(together);
    return adding;
  }

  private beginStroke(kind: "band" | "ruler" | "gap" | "gravity", at: Point, adding: boolean): void {
    const from = this.scene.camera.value!.toCloth(at);
    this.scene.stroke = { kind, from, to: from };
    this.doing = { kind: "stroke", adding };
    this.scene.onChange("moving");
  }

  private beginPinch(): void {
    if (this.doing?.kind === "drag") this.drop(this.doing.drag);
    this.scene.stroke = undefined;
    this.doing = { kind: "pinch", ...this.pinch() };
  }
  private pinch(): { middle: Point; apart: number } {
    const [a, b] = [...this.down.values()] as [Point, Point];
    return { middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], apart: Math.max(10, Math.hypot(a[0] - b[0], a[1] - b[1])) };
  }

  private move(event: PointerEvent): void {
    const at: Point = [event.offsetX, event.offsetY];
    const camera = this.scene.camera.value;
    if (!camera) return;
    if (this.down.has(event.pointerId)) this.down.set(event.pointerId, at);
    const doing = this.doing;
    switch (doing?.kind) {
      case undefined: return this.hover(at);
      case "pan":
        this.stage.look(camera.panned(at[0] - doing.last[0], at[1] - doing.last[1]));
        doing.last = at;
        return;
      case "pinch": {
        if (this.down.size < 2) return;
        const { middle, apart } = this.pinch();
        this.stage.look(camera.panned(middle[0] - doing.middle[0], middle[1] - doing.middle[1]));
        this.stage.zoom(apart / doing.apart, middle);
        Object.assign(doing, { middle, apart });
        return;
      }
      case "stroke":
        if (this.scene.stroke) this.scene.stroke = { ...this.scene.stroke, to: camera.toCloth(at) };
        return this.scene.onChange("moving");
      case "press":
        if (Math.hypot(at[0] - doing.at[0], at[1] - doing.at[1]) < SLACK || doing.toggled) return;
        void this.beginDrag(doing.piece, camera.toCloth(doing.at), event.shiftKey, at);
        return;
      case "drag": {
        const to = camera.toCloth(at);
        return doing.drag.move([to[0] - doing.from[0], to[1] - doing.from[1]]);
      }
    }
  }

  private async beginDrag(piece: Piece, from: Point, free: boolean, at: Point): Promise<void> {
    this.doing = undefined;
    const together = this.scene.marker!.together(piece);
    if (together.some((one) => isLocked(one, "x") && isLocked(one, "y"))) return this.showMessage(say("locked", { name: piece.shape.label }));
    if (together.some(({ id }) => this.desk.draggedByOthers.value.some((dragged) => dragged.piece === id))) this.showMessage(say("alsoInOtherHand", { name: piece.shape.label }));
    const several = this.scene.selected().filter((one) => !together.includes(one));
    if (this.engine.preview.value) {
      // The previewed result is taken first; the drag starts from it if the pointer is still down.
      await this.engine.take();
      if (this.down.size !== 1) return;
    }
    const rescue = async (to: Point) => void (await this.settling.place(piece.id, to));
    const drag: Drag =
      free || several.length > 0
        ? this.freeDrag(several.length > 0 ? [...this.scene.selected()] : together)
        : new LiveDrag(this.desk, this.scene, piece, preferences.value.dragMode, rescue, this.commands.idle());
    this.doing = { kind: "drag", drag, from };
    this.canvas.dataset["doing"] = "drag";
    const to = this.scene.camera.value!.toCloth(at);
    drag.move([to[0] - from[0], to[1] - from[1]]);
  }

  private freeDrag(pieces: Piece[]): FreeDrag {
    return new FreeDrag(this.scene, pieces, announceDrag(this.desk, pieces), async (to) => void (await this.settling.dropped(pieces, to)));
  }

  private release(event: PointerEvent, commit: boolean): void {
    this.down.delete(event.pointerId);
    const doing = this.doing;
    if (doing?.kind === "pinch") {
      if (this.down.size === 0) this.doing = undefined;
      return;
    }
    this.doing = undefined;
    this.canvas.dataset["doing"] = "";
    if (doing?.kind === "drag") void this.commands.queue(() => doing.drag.end(commit)).then(() => this.scene.onChange("settled"));
    else if (doing?.kind === "press" && !doing.toggled && commit) this.scene.select(this.scene.marker!.together(doing.piece).map(({ id }) => id));
    else if (doing?.kind === "stroke") this.endStroke(doing.adding, commit);
    else if (doing?.kind === "place" && commit) this.layAt(doing.place);
  }

  private layAt(place: number): void {
    const piece = this.places.piece.value;
    const ghost = this.scene.places[place];
    if (piece && ghost) void this.commands.layAt(piece.id, ghost.pose);
  }

  private endStroke(adding: boolean, commit: boolean): void {
    const { stroke, camera, marker } = this.scene;
    if (!stroke || !camera.value || !marker) return;
    const { kind, from, to } = stroke;
    const long = Math.hypot(to[0] - from[0], to[1] - from[1]) * camera.value.scale > SLACK;
    if (kind !== "ruler" || !long) this.scene.stroke = undefined;
    if (kind === "band") this.band(from, to, adding, long);
    else if (long && commit && kind !== "ruler") {
      tool.value = "select";
      void (kind === "gap" ? openGap(this.engine, marker, from, to) : gravity(this.engine, from, to));
    }
    this.scene.onChange("moving");
  }

  private band(from: Point, to: Point, adding: boolean, long: boolean): void {
    const [left, right] = [Math.min(from[0], to[0]), Math.max(from[0], to[0])];
    const [bottom, top] = [Math.min(from[1], to[1]), Math.max(from[1], to[1])];
    const inside = this.scene.marker!.pieces.filter(({ box }) => box.left >= left && box.right <= right && box.bottom >= bottom && box.top <= top);
    const ids = long ? inside.map(({ id }) => id) : [];
    this.scene.select(adding ? [...this.scene.selection.value, ...ids] : ids);
  }

  private drop(drag: Drag): void {
    drag.end(false).catch((error) => this.showMessage(errorText(error)));
  }

  /** Cancels the gesture in progress and undoes its effects. Returns whether there was one. */
  cancel(): boolean {
    const doing = this.doing;
    this.doing = undefined;
    const had = doing !== undefined || this.scene.stroke !== undefined;
    this.scene.stroke = undefined;
    if (doing?.kind === "drag") this.drop(doing.drag);
    this.scene.onChange("moving");
    return had;
  }

  private hover(at: Point | undefined): void {
    const { camera, marker } = this.scene;
    if (at && camera.value && this.scene.places.length > 0) {
      const place = this.places.at(camera.value.toCloth(at));
      if (place >= 0) this.places.choose(place);
    }
    const over = at && tool.value === "select" && camera.value && marker ? marker.pieceAt(camera.value.toCloth(at), 0, this.scene.shown)?.id : undefined;
    if (over === this.scene.hovered) return;
    this.scene.hovered = over;
    this.canvas.dataset["over"] = over === undefined ? "" : "piece";
    this.scene.onChange("moving");
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const at: Point = [event.offsetX, event.offsetY];
    const camera = this.scene.camera.value;
    if (!camera) return;
    const lines = event.deltaMode === 1 ? 16 : 1;
    if (event.altKey) void this.commands.tilt(event.deltaY < 0 ? 1 : -1);
    else if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      this.stage.look(camera.panned(-(event.deltaX || event.deltaY) * lines, 0));
    } else this.stage.zoom(Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0016)), at);
  }
}
