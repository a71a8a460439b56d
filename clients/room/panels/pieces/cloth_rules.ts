import { follow } from "../../base/signal";
import type { Commands } from "../../input/commands";
import type { Marker } from "../../marker/marker";
import type { Desk } from "../../session/desk";
import { say, wording } from "../../texts/texts";
import { lengthText } from "../../texts/units";
import { lengthField, row, showLength } from "../controls";
import { disclosure } from "./disclosure";
import { pointRow } from "./point_row";

/** Fields for the cloth: its selvedges, the length within which the pieces of a shade lie, and the repeat of its stripes or plaid. */
export function buildClothRules(desk: Desk, commands: Commands): HTMLElement {
  const selvedge = (name: "below" | "above") => lengthField((length) => void commands.strip({ [name]: length ?? null }), { id: `cloth-${name}`, mayBeEmpty: true });
  const below = selvedge("below");
  const above = selvedge("above");
  const shade = lengthField((length) => void commands.shade(length ?? null), { id: "cloth-shade", mayBeEmpty: true });
  const repeat = (name: "along" | "across") => lengthField((length) => void commands.repeat(() => ({ [name]: length ?? 0 })), { id: `cloth-${name}`, mayBeEmpty: true });
  const along = repeat("along");
  const across = repeat("across");
  const phase = pointRow("cloth-phase", "phase", (change) => void commands.repeat((known) => ({ phase: change(known.phase) })));
  const { box, tell } = disclosure("cloth-rules", "clothRules", row("ruleBelow", below), row("ruleAbove", above), row("shadeWithin", shade), row("repeatX", along), row("repeatY", across), phase.row);
  follow([desk.marker, desk.figures, wording], () => {
    const marker = desk.marker.value;
    if (!marker) return;
    const { strip } = marker.document;
    tell(clothOf(marker));
    showLength(below, strip.below);
    showLength(above, strip.above);
    below.placeholder = above.placeholder = lengthText(marker.margin, { unit: false });
    showLength(shade, marker.shade);
    showLength(along, marker.repeat?.along || undefined);
    showLength(across, marker.repeat?.across || undefined);
    phase.show(marker.repeat?.phase);
  });
  return box;
}

/** A short description of the cloth's pattern. */
function clothOf({ repeat }: Marker): string {
  const { along = 0, across = 0 } = repeat ?? {};
  if (along > 0 && across > 0) return say("plaid", { along: lengthText(along, { unit: false }), across: lengthText(across) });
  return along > 0 || across > 0 ? say("striped", { repeat: lengthText(along || across) }) : say("plain");
}
