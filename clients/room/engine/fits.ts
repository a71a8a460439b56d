// Finds the regions of free cloth into which a piece fits.
import type { Answer, Client } from "../../typescript/src/index";
import type { Marker, Piece } from "../marker/marker";

const NODES = 2000; // limit of the exact search in one region
const MOST = 400; // number of regions that are searched, the largest first
const CORNERS = 1000; // largest number of points that the daemon accepts for a room

export type Regions = Answer<"marker.regions">;

/** The piece of the smallest area that may move. */
export const smallestOf = ({ pieces }: Marker): Piece | undefined =>
  pieces.reduce<Piece | undefined>((least, piece) => (piece.locked === false && (!least || piece.shape.area < least.shape.area) ? piece : least), undefined);

/** Checks by an exact search, for each region that is large enough, whether the piece fits into it; the largest region comes first. */
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
