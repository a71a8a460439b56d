import { CallError, Code, ConnectionLost } from "../../typescript/src/index";
import { say, type TextName } from "../texts/texts";

/** An error in the user's words; the daemon's own message where it names what is wrong. */
export function inWords(error: unknown): string {
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

const DEEDS: Record<string, TextName> = {
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
/** What a method did to a marker, in the user's words; its name where there are none. */
export function deedInWords(method: string): string {
  const deed = DEEDS[method];
  return deed ? say(deed) : method;
}
