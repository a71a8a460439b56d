// The types of marker documents, which the TypeScript client generates from the daemon's description.
export type { MarkerDocument, PieceDocument, ShapeDocument, UnplacedPieceDocument } from "../../typescript/src/index";
