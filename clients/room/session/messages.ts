import { CallError, Code, ConnectionLost } from "../../typescript/src/index";
import { say, type TextName } from "../texts/texts";

/** The message that the user sees for an error; for most errors of the daemon, it is the daemon's own message. */
export function errorText(error: unknown): string {
  if (error instanceof ConnectionLost) return say("errorConnection");
  if (!(error instanceof CallError)) return error instanceof Error ? error.message : String(error);
  if (error.data.name === "history.nothing_to_undo") return say("errorNothingToUndo");
  switch (error.code) {
    case Code.RevisionMismatch: return say("errorClash", { revision: error.data.revision ?? "?" });
    case Code.Busy: return say("errorBusy");
    case Code.UnknownMarker: return say("errorGone");
    case Code.TooLarge: return say("errorTooLarge");
    case Code.Draining: return say("errorDraining");
    default: return error.message;
  }
}

export const hasCode = (error: unknown, code: number): boolean => error instanceof CallError && error.code === code;

const METHODS: Record<string, TextName> = {
  "marker.apply": "byEdit",
  "marker.undo": "undo",
  "marker.redo": "redo",
  "marker.nest": "nest",
  "marker.fillGaps": "fillGaps",
  "marker.compactExactly": "exactly",
  "marker.remake": "fromLibrary",
  "motion.compact": "compact",
  "motion.tilt": "tilt",
  "motion.separate": "separate",
  "motion.float": "float",
  "motion.relax": "relax",
  "motion.bump": "byDrag",
  "motion.place": "byDrag",
  "drag.end": "byDrag",
};
/** The name that the user sees for a method that changed the marker; without one, the method's own name. */
export function methodText(method: string): string {
  const name = METHODS[method];
  return name ? say(name) : method;
}
