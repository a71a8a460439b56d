// Which regions of free cloth have room for a piece.
import type { Answer, Client } from "../../typescript/src/index";
import type { Marker, Piece } from "../marker/marker";

const NODES = 2000; // of the exact search in one region
const MOST = 400; // regions that are asked about, the largest of them
const CORNERS = 1000; // of a region that the daemon takes as a room

export type Regions = Answer<"marker.regions">;

/** The smallest piece that may move: what does not take it takes none that is larger in every direction. */
export const smallestOf = ({ pieces }: Marker): Piece | undefined =>
  pieces.reduce<Piece | undefined>((least, piece) => (piece.locked === false && (!least || piece.shape.area < least.shape.area) ? piece : least), undefined);

/** Goes through the regions that are as large as the piece, the largest first, and says of each whether an exact search fits the piece into it. */
export async function* fitting(client: Client, { markerId, regions }: Regions, { id, shape }: Piece): AsyncGenerator<{ index: number; fits: boolean }> {
  const asked = regions
    .map(({ area, outline }, index) => ({ area, outline, index }))
    .filter(({ area, outline }) => area >= shape.area && outline.length <= CORNERS)
    .sort((a, b) => b.area - a.area)
    .slice(0, MOST);
  for (const { outline, index } of asked) {
    const { verdict } = await client.call("motion.contain", { markerId, pieces: [id], room: outline, nodes: NODES, commit: false });
    yield { index, fits: verdict === "found" };
  }
}
