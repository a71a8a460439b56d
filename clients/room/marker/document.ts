// A marker's document, as the TypeScript client describes it: generated from protocol/marker.schema.json.
export type { MarkerDocument, PieceDocument, ShapeDocument, UnplacedPieceDocument } from "../../typescript/src/index";
