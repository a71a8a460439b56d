import { Code, type Answer, type Motion, type Params, type Placement } from "../../typescript/src/index";
import { Signal } from "../base/signal";
import { editsTo } from "../marker/edits";
import type { Pose } from "../marker/pose";
import { Copies } from "../session/copies";
import type { Desk } from "../session/desk";
import { hasCode, errorText } from "../session/messages";
import { say } from "../texts/texts";
import { lengthText } from "../texts/units";
import type { Scene } from "../view/scene";
import { differences, newcomers, posesAfter, type Result } from "./result";
import { search, type Search } from "./search";

export interface CurvePoint {
  seconds: number;
  length: number;
}
/** A motion in progress. */
export interface Run {
  title: string;
  round: number;
  curve: CurvePoint[];
  best: number | undefined;
  /** Whether it will end as soon as it has delivered its best result. */
  stopping: boolean;
  searching: boolean;
  stop(): void;
}

// The fields of every motion's answer that a result needs.
interface MotionAnswer {
  revision: number;
  lengthBefore: number;
  lengthAfter: number;
  utilisationAfter: number;
  placements: Placement[];
}
type Choice<M extends Motion> = Omit<Params<M>, "markerId" | "baseRev" | "commit">;

/** Runs motions without committing them, and keeps their results until the user takes or drops them. */
export class Engine {
  readonly run = new Signal<Run | undefined>(undefined);
  readonly preview = new Signal<Result | undefined>(undefined);
  readonly beside = new Signal<readonly Result[]>([]);
  readonly compared = new Signal<Result | "opening" | undefined>(undefined);
  private results = 0;
  private readonly copies: Copies;

  constructor(
    private readonly desk: Desk,
    private readonly scene: Scene,
    private readonly showMessage: (text: string) => void,
  ) {
    this.copies = new Copies(desk.link);
    this.preview.follow((result) => this.showPreview(result));
    this.compared.follow(() => this.showCompared());
    desk.marker.follow(() => this.putAside());
    desk.changed.follow(() => {
      this.showPreview(this.preview.value);
      this.showCompared();
    });
  }

  // When another marker is shown, the result waits beside it: it can be taken only by the marker that it was made of.
  private putAside(): void {
    const result = this.preview.value;
    if (!result || result.markerKey === this.desk.markerKey) return;
    this.beside.value = [...this.beside.value, result];
    this.preview.value = undefined;
  }

  private showPreview(result: Result | undefined): void {
    const marker = this.scene.marker;
    if (!marker || this.scene.dragged.size > 0) return;
    const fits = result && result.markerKey === this.desk.markerKey;
    this.scene.length = fits ? result.length : this.desk.figures.value.length;
    this.scene.newcomers = fits ? newcomers(marker, result.poses) : [];
    this.scene.showPoses(fits ? differences(marker, result.poses) : new Map<string, Pose>(), true);
  }

  private showCompared(): void {
    const { marker } = this.scene;
    const compared = this.compared.value;
    if (!marker) return;
    const poses = compared === "opening" ? this.desk.opening?.poses : compared?.poses;
    const differing = poses ? differences(marker, poses) : new Map<string, Pose>();
    this.scene.ghosts = [...differing].map(([id, pose]) => ({ piece: marker.byId.get(id)!, pose }));
    this.scene.onChange("moving");
  }

  /** Runs a motion and previews its result, which the user may take. `failure` returns a message if an answer has no result. */
  async start<M extends Motion>(method: M, choice: Choice<M>, title: string, failure: (answer: Answer<M>) => string | undefined = () => undefined): Promise<void> {
    if (this.run.value) return;
    await this.takeOrDrop(true);
    await this.withRun(title, async (run, signal, since) => {
      const client = await this.desk.link.ready();
      const start = this.desk.marker.value!.poses();
      const { markerId, markerKey } = this.desk;
      const params = { ...choice, markerId, baseRev: this.desk.figures.value.revision, commit: false } as Params<M>;
      const call = client.start(method, params, { signal });
      for await (const { round, length } of call.progress) this.round(run, round, length, since);
      const result = await call.result;
      const why = failure(result);
      if (why !== undefined) return this.showMessage(why);
      const answer = result as unknown as MotionAnswer;
      if (answer.placements.length === 0) return this.showMessage(say("noGain", { what: title }));
      this.offer(title, markerKey, answer, posesAfter(start, answer.placements), since);
    });
  }

  /** Arranges all pieces like those of the most similar stored markers. */
  remake(): Promise<void> {
    const title = say("fromLibrary");
    return this.start("marker.remake", {}, title, (answer) => (answer.outcome === "none_near" ? say("noneNear") : answer.outcome === "not_apart" ? say("notApart") : undefined));
  }

  /** Searches until it is stopped, and shows the best result so far. */
  async search(wanted: Search, title: string): Promise<void> {
    if (this.run.value) return;
    await this.takeOrDrop(true);
    await this.withRun(title, async (run, signal, since) => {
      run.searching = true;
      const client = await this.desk.link.ready();
      const marker = this.desk.marker.value!;
      const start = marker.poses();
      const { markerKey } = this.desk;
      const { revision, length } = this.desk.figures.value;
      let found = false;
      const best = wanted.kind === "nest" && marker.unplaced.length > 0 ? Infinity : length; // placing all pieces has priority
      await search(wanted, client, this.copies, marker.toDocument(), best, signal, {
        goesOn: () => !run.stopping,
        round: (round, length) => this.round(run, round, length, since),
        better: (answer, placements) => {
          found = true;
          if (this.preview.value && this.preview.value.title !== title) return; // the user is looking at another result
          this.offer(title, markerKey, { ...answer, revision, lengthBefore: length, placements }, posesAfter(start, placements), since);
        },
      }, this.desk.link.alone ? "page" : "daemon");
      if (!found) this.showMessage(say("noGain", { what: title }));
    });
  }

  private round(run: Run, round: number, length: number, since: number): void {
    run.round = round;
    run.best = Math.min(run.best ?? Infinity, length);
    run.curve.push({ seconds: (performance.now() - since) / 1000, length: run.best });
    this.run.announce();
  }

  private async withRun(title: string, act: (run: Run, signal: AbortSignal, since: number) => Promise<void>): Promise<void> {
    if (this.run.value || !this.desk.marker.value) return;
    const controller = new AbortController();
    const since = performance.now();
    // The length of a marker with unplaced pieces cannot be compared with that of a result.
    const curve = this.desk.marker.value.unplaced.length > 0 ? [] : [{ seconds: 0, length: this.desk.figures.value.length }];
    const run: Run = { title, round: 0, curve, best: undefined, stopping: false, searching: false, stop: () => this.stop(run, controller) };
    this.run.value = run;
    try {
      await act(run, controller.signal, since);
    } catch (error) {
      if (!hasCode(error, Code.Cancelled)) this.showMessage(errorText(error));
    } finally {
      this.run.value = undefined;
    }
  }

  // A search that has found a shorter marker than the one shown first delivers it. Otherwise, or when stopped again, it ends at once.
  private stop(run: Run, controller: AbortController): void {
    const shown = this.preview.value?.length ?? this.desk.figures.value.length;
    const found = run.searching && run.best !== undefined && run.best < shown - 1e-9;
    if (run.stopping || !found) return controller.abort();
    run.stopping = true;
    this.run.announce();
  }

  // Shows a result of the marker `markerKey`; if another one is shown by now, it replaces the run's last result beside it.
  private offer(title: string, markerKey: string, answer: MotionAnswer, poses: Map<string, Pose>, since: number): void {
    const result: Result = {
      id: ++this.results,
      title,
      markerKey,
      base: answer.revision,
      before: answer.lengthBefore,
      length: answer.lengthAfter,
      utilisation: answer.utilisationAfter,
      seconds: (performance.now() - since) / 1000,
      poses,
    };
    if (markerKey === this.desk.markerKey) this.preview.value = result;
    else this.beside.value = [...this.beside.value.filter((kept) => kept.title !== title || kept.markerKey !== markerKey), result];
  }

  /** Moves all pieces to their places in the result, which one undo takes back. */
  async take(result = this.preview.value): Promise<void> {
    const marker = this.desk.marker.value;
    if (!result || !marker || !this.desk.markerId || result.markerKey !== this.desk.markerKey) return;
    const ops = editsTo(marker, result.poses);
    try {
      if (ops.length > 0) await this.desk.apply(ops);
      this.showMessage(say("taken", { length: lengthText(this.desk.figures.value.length) }));
    } catch (error) {
      this.showMessage(errorText(error));
    }
    if (this.preview.value === result) this.preview.value = undefined;
    this.beside.value = this.beside.value.filter((kept) => kept !== result);
    if (this.compared.value === result) this.compared.value = undefined;
  }

  /** Keeps the previewed result or, without one, the current revision, so that it can be compared with later results. */
  keepBeside(): void {
    const result = this.preview.value ?? this.currentRevision();
    if (!result) return;
    this.beside.value = [...this.beside.value, result];
    this.preview.value = undefined;
  }

  private currentRevision(): Result | undefined {
    const marker = this.desk.marker.value;
    if (!marker) return undefined;
    const { revision, length, utilisation } = this.desk.figures.value;
    const title = say("revisionIs", { revision });
    return { id: ++this.results, title, markerKey: this.desk.markerKey, base: revision, before: length, length, utilisation, seconds: undefined, poses: marker.poses() };
  }

  drop(result = this.preview.value): void {
    if (!result) return;
    if (this.preview.value === result) {
      this.preview.value = undefined;
      this.showMessage(say("dropped"));
    }
    if (this.compared.value === result) this.compared.value = undefined;
    this.beside.value = this.beside.value.filter((kept) => kept !== result);
  }

  /** Ends the preview before other work begins; a user who goes on working with a previewed result has accepted it. */
  async takeOrDrop(taking: boolean): Promise<void> {
    if (!this.preview.value) return;
    if (taking) await this.take();
    else this.drop();
  }
}
