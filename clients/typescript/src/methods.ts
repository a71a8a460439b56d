// Made by scripts/generate.mjs of the daemon's own description; do not edit.

/** How hard a motion tries. */
export type Accuracy = "draft" | "standard" | "fine";

/** What a dragged piece does to the others: nothing, or push them out of the way. */
export type DragMode = "place" | "push";

/** What motion.float makes large. */
export type FloatMode = "largest_minimum" | "given_distance" | "largest_total" | "uniform" | "two_step";

/** The form of a document. */
export type Format = "native" | "sparrow" | "outlines" | "svg";

/** What of a piece stays. */
export type LockedPart = "x" | "y" | "tilt";

/** Why a motion ended; each leaves the best valid marker so far. */
export type StopReason = "converged" | "work_limit" | "cancelled" | "solver_failed" | "deadline";

/** An edge of the strip. */
export type StripEdge = "left" | "right" | "bottom" | "top";

/** Where motion.separate aims a pair. */
export type TargetRule = "nearest" | "kernel_ray";

/** [x, y], never [0, 0]: x along the strip, y across; only where it leads counts. */
export type Direction = [number, number];

/** An operation of marker.apply. */
export type Edit = AddEdit | RemoveEdit | MoveEdit | RotateEdit | FlipEdit | TiltEdit | LockEdit | GroupEdit | BufferEdit | StripEdit | SpacingEdit;

/** A name; a whole number is read as its digits. */
export type Id = string | number;

/** All of the piece, or what of it stays. */
export type Locks = boolean | Array<LockedPart>;

/** [x, y] in the marker's unit. */
export type Point = [number, number];

/** Under it progress is told; a string has at most 128 bytes. */
export type ProgressToken = number | string;

/** A piece goes behind the others. */
export type AddEdit = {
  /** The operation. */
  op: "add";
  /** As in a native document. */
  piece: Record<string, unknown>;
  /** Likewise, when the marker has none of that id. */
  shape?: Record<string, unknown>;
};

/** Room kept about a piece. */
export type BufferEdit = {
  /** The operation. */
  op: "buffer";
  /** The piece's id. */
  piece: Id;
  /** A length. */
  buffer: number;
};

/** Of the Minkowski sums that are kept. */
export type CacheCounts = {
  /** Found. */
  hits: number;
  /** Computed. */
  misses: number;
  /** Kept now. */
  entries: number;
  /** Of memory. */
  bytes: number;
  /** Bytes at most. */
  limit: number;
};

/** Gaps that hold a minimum. */
export type CriticalSet = {
  /** The minimum. */
  distance: number;
  /** Those that hold it. */
  gaps: Array<Gap>;
};

/** A piece mirrored. */
export type FlipEdit = {
  /** The operation. */
  op: "flip";
  /** The piece's id. */
  piece: Id;
  /** Absent: the other way. */
  flip?: boolean;
};

/** A force on a piece. */
export type Force = {
  /** The piece's id. */
  piece: Id;
  /** Its size counts beside other forces. */
  force: Direction;
};

/** Between two pieces, or a piece and an edge. */
export type Gap = {
  /** Its id. */
  piece: string;
  /** The id of the piece beside it. */
  other?: string;
  /** Or the edge beside it. */
  edge?: StripEdge;
};

/** A gap, and how wide it is. */
export type GapWidths = {
  /** Its id. */
  piece: string;
  /** The id of the piece beside it. */
  other?: string;
  /** Or the edge beside it. */
  edge?: StripEdge;
  /** Its width. */
  before: number;
  /** Its width. */
  after: number;
};

/** Pieces of one group move as one. */
export type GroupEdit = {
  /** The operation. */
  op: "group";
  /** The piece's id. */
  piece: Id;
  /** Absent: of no group. */
  group?: Id;
};

/** Small overlaps that were parted first. */
export type Healing = {
  /** That overlapped. */
  pairs: number;
  /** Pieces that left the strip. */
  protruding: number;
  /** Overlap. */
  deepest: number;
  /** Of a piece. */
  farthestMove: number;
  /** By so much the marker grew for it. */
  lengthened: number;
};

/** Of this server. */
export type Limits = {
  /** Of one request. */
  requestBytes: number;
  /** Calls in one. */
  batch: number;
  /** Levels of nesting. */
  depth: number;
  /** Numbers, texts, arrays and so on, of one request. */
  values: number;
  /** Of a marker. */
  pieces: number;
  /** Of a shape. */
  vertices: number;
  /** At once. */
  openMarkers: number;
  /** In the queue. */
  waitingMotions: number;
  /** In the queue. */
  waitingReads: number;
  /** Of dragging hands, in the queue. */
  waitingMoves: number;
  /** From the arrival of a call that may take long to the best it has by then. */
  callMs: number;
  /** At once. */
  dragsPerConnection: number;
  /** At once. */
  connections: number;
  /** Unanswered. */
  callsPerConnection: number;
};

/** A marker that is open. */
export type ListedMarker = {
  /** Its id. */
  markerId: string;
  /** The present one. */
  revision: number;
  /** Its name. */
  name: string;
  /** How many. */
  pieces: number;
  /** Exact. */
  length: number;
  /** 0 to 1. */
  utilisation: number;
};

/** Of the chain that holds the length. */
export type LoadedContact = {
  /** Its id. */
  piece: string;
  /** The id of the piece beside it. */
  other?: string;
  /** Or the edge beside it. */
  edge?: StripEdge;
  /** Length per unit of room. */
  worth: number;
  /** Where they touch. */
  at: Point;
};

/** No motion may move it. */
export type LockEdit = {
  /** The operation. */
  op: "lock";
  /** The piece's id. */
  piece: Id;
  /** Absent: wholly. */
  locked?: Locks;
};

/** A piece goes to a place or by a way: either is required. */
export type MoveEdit = {
  /** The operation. */
  op: "move";
  /** The piece's id. */
  piece: Id;
  /** To here. */
  at?: Point;
  /** By so much. */
  by?: Point;
};

/** What was mended. */
export type Note = {
  /** A JSON pointer into the parameters. */
  field: string;
  /** In words. */
  text: string;
};

/** Two pieces that overlap. */
export type Overlap = {
  /** A piece's id. */
  first: string;
  /** The other's. */
  second: string;
  /** A point of both. */
  witness: Point;
  /** The shortest move that parts them; 0: not measured, the motion was stopped. */
  depth: number;
};

/** A piece, and how it lies. */
export type PieceState = {
  /** The piece's. */
  id: string;
  /** Its shape's id. */
  shape: string;
  /** Where the shape's origin lies. */
  at: Point;
  /** Degrees. */
  rotation: number;
  /** Is it mirrored? */
  flip: boolean;
  /** Degrees, on top of the rotation. */
  tilt: number;
  /** What of it stays. */
  locked: Locks;
  /** Where there is one. */
  group?: string;
  /** Where there is one. */
  buffer?: number;
};

/** How a piece lies now. */
export type Placement = {
  /** The piece's. */
  id: string;
  /** Where the shape's origin lies. */
  at: Point;
  /** Degrees. */
  rotation: number;
  /** Is it mirrored? */
  flip: boolean;
  /** Degrees, on top of the rotation. */
  tilt: number;
};

/** A piece that leaves the strip. */
export type Protrusion = {
  /** Its id. */
  piece: string;
  /** How far. */
  by: number;
};

/** Cloth that no piece covers; its corners are rounded. */
export type Region = {
  /** Counter-clockwise. */
  outline: Array<Point>;
  /** In it. */
  holes: Array<Array<Point>>;
  /** Without the holes. */
  area: number;
  /** Ids of the pieces beside it. */
  around: Array<string>;
};

/** A piece goes; its shape stays. */
export type RemoveEdit = {
  /** The operation. */
  op: "remove";
  /** The piece's id. */
  piece: Id;
};

/** A rotation that the shape allows: to or by is required. */
export type RotateEdit = {
  /** The operation. */
  op: "rotate";
  /** The piece's id. */
  piece: Id;
  /** Degrees. */
  to?: number;
  /** Degrees. */
  by?: number;
};

/** The least distance between two pieces. */
export type SpacingEdit = {
  /** The operation. */
  op: "setSpacing";
  /** A length. */
  spacing: number;
};

/** Milliseconds. */
export type StageTimes = {
  /** In Minkowski sums. */
  sums: number;
  /** In making programs. */
  rows: number;
  /** In solving them. */
  solve: number;
  /** In proving. */
  verify: number;
  /** In all. */
  total: number;
};

/** The strip; one of its fields is required. */
export type StripEdit = {
  /** The operation. */
  op: "setStrip";
  /** Across. */
  width?: number;
  /** Where the cloth ends; null: nowhere. */
  longest?: number | null;
  /** Pieces stay so far from the edges. */
  margin?: number;
};

/** Within the shape's tilt limit: to or by is required. */
export type TiltEdit = {
  /** The operation. */
  op: "tilt";
  /** The piece's id. */
  piece: Id;
  /** Degrees. */
  to?: number;
  /** Degrees. */
  by?: number;
};

/** What tilting a piece would bring. */
export type TiltWorth = {
  /** Its id. */
  piece: string;
  /** What the length would shrink by per degree counter-clockwise. */
  perDegree: number;
};

/** Every method: what it takes and what it answers. */
export interface Methods {
  /** What this server is and allows. */
  "engine.info": {
    params: Record<string, never>;
    result: {
      /** selvage */
      name: string;
      /** The daemon's. */
      version: string;
      /** Their names. */
      methods: Array<string>;
      /** Forms of documents that it reads. */
      reads: Array<string>;
      /** Forms that it writes. */
      writes: Array<Format>;
      /** Those there are. */
      accuracies: Array<Accuracy>;
      /** Threads for motions. */
      workers: number;
      /** That are open. */
      markers: number;
      /** Of this server. */
      limits: Limits;
      /** Of Minkowski sums. */
      cache: CacheCounts;
    };
  };
  /** This description. */
  "rpc.discover": {
    params: Record<string, never>;
    result: {
      /** The version of OpenRPC. */
      openrpc: string;
      /** Title and version. */
      info: Record<string, unknown>;
      /** All methods. */
      methods: Array<Record<string, unknown>>;
      /** Types. */
      components: Record<string, unknown>;
      /** What the daemon sends unasked. */
      "x-notifications": Array<Record<string, unknown>>;
    };
  };
  /** A document becomes an open marker. */
  "marker.open": {
    params: {
      /** A native or sparrow document. */
      marker: Record<string, unknown>;
      /** Overrides the document's. */
      spacing?: number;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** How many there are. */
      pieces: number;
      /** Where the rightmost piece ends; exact. */
      length: number;
      /** The pieces' area over width times length, 0 to 1. */
      utilisation: number;
      /** Proved in integers. */
      valid: boolean;
      /** What was mended. */
      notes: Array<Note>;
    };
  };
  /** The markers that are open. */
  "marker.list": {
    params: Record<string, never>;
    result: {
      /** Those that are open. */
      markers: Array<ListedMarker>;
    };
  };
  /** A marker is forgotten. */
  "marker.close": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** True. */
      closed: boolean;
    };
  };
  /** From now on changes are told. */
  "marker.watch": {
    params: {
      /** The marker's id. */
      markerId: string;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** From now on it is told of changes. */
      watching: boolean;
    };
  };
  /** And no longer. */
  "marker.unwatch": {
    params: {
      /** The marker's id. */
      markerId: string;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** Never any more. */
      watching: boolean;
      /** Did it until now? */
      watched: boolean;
    };
  };
  /** Operations on the marker, all or none. */
  "marker.apply": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** 1 to 100,000, one after another, all or none. */
      ops: Array<Edit>;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Of the pieces that are new or lie or are locked otherwise. */
      placements: Array<PieceState>;
      /** Ids of the pieces that are gone. */
      removed: Array<string>;
      /** True: more than that changed. */
      whole?: boolean;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Where the rightmost piece ends; exact. */
      length: number;
      /** The pieces' area over width times length, 0 to 1. */
      utilisation: number;
      /** Proved in integers. */
      valid: boolean;
      /** What was mended in shapes that were added. */
      notes?: Array<Note>;
    };
  };
  /** The last change taken back. */
  "marker.undo": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Of the pieces that are new or lie or are locked otherwise. */
      placements: Array<PieceState>;
      /** Ids of the pieces that are gone. */
      removed: Array<string>;
      /** True: more than that changed. */
      whole?: boolean;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Where the rightmost piece ends; exact. */
      length: number;
      /** The pieces' area over width times length, 0 to 1. */
      utilisation: number;
      /** Proved in integers. */
      valid: boolean;
    };
  };
  /** And made again. */
  "marker.redo": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Of the pieces that are new or lie or are locked otherwise. */
      placements: Array<PieceState>;
      /** Ids of the pieces that are gone. */
      removed: Array<string>;
      /** True: more than that changed. */
      whole?: boolean;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Where the rightmost piece ends; exact. */
      length: number;
      /** The pieces' area over width times length, 0 to 1. */
      utilisation: number;
      /** Proved in integers. */
      valid: boolean;
    };
  };
  /** A hand takes hold of a piece. */
  "drag.begin": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** The piece's id. */
      piece: Id;
      /** place when absent. */
      mode?: DragMode;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
    };
    result: {
      /** The drag's id. */
      dragId: string;
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Its id. */
      piece: string;
      /** Where it lies. */
      at: Point;
    };
  };
  /** Where the piece comes to lie. */
  "drag.move": {
    params: {
      /** The drag's id. */
      dragId: string;
      /** Where the piece's origin is wanted. */
      to: Point;
    };
    result: {
      /** The drag's id. */
      dragId: string;
      /** Where it lies now. */
      at: Point;
      /** It is where it is wanted. */
      reached: boolean;
      /** Others made way. */
      pushed: boolean;
      /** Of all that lie elsewhere than at the beginning. */
      placements: Array<Placement>;
      /** Where the rightmost piece ends; exact. */
      length: number;
      /** The pieces' area over width times length, 0 to 1. */
      utilisation: number;
      /** Proved in integers. */
      valid: boolean;
    };
  };
  /** The hand lets go. */
  "drag.end": {
    params: {
      /** The drag's id. */
      dragId: string;
      /** The marker's id. */
      markerId: string;
      /** False: leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Of the pieces that are new or lie or are locked otherwise. */
      placements: Array<PieceState>;
      /** Ids of the pieces that are gone. */
      removed: Array<string>;
      /** True: more than that changed. */
      whole?: boolean;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Where the rightmost piece ends; exact. */
      length: number;
      /** The pieces' area over width times length, 0 to 1. */
      utilisation: number;
      /** Proved in integers. */
      valid: boolean;
    };
  };
  /** Ends a call that is under way. */
  "$/cancelRequest": {
    params: {
      /** Of a call of this connection that is under way. */
      id: number | string | null;
    };
    result: {
      /** It was not too late. */
      cancelled: boolean;
    };
  };
  /** A marker as a document. */
  "marker.get": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** The form of the document; native when absent. */
      format?: Format;
      /** A revision: only what changed after it, where that is known. */
      since?: number;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** The form of the document. */
      format?: Format;
      /** The document; for svg a string. Absent when the answer is by since. */
      marker?: Record<string, unknown> | string;
      /** The revision asked from. */
      since?: number;
      /** The pieces that changed after it. */
      placements?: Array<PieceState>;
    };
  };
  /** Is the marker valid, and where not? */
  "marker.check": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** Then the call is refused if it has no answer; 1 to 86,400,000. */
      deadlineMs?: number;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Proved in integers. */
      valid: boolean;
      /** Pairs that overlap or are too close. */
      overlaps: Array<Overlap>;
      /** Pieces that leave the strip. */
      protrusions: Array<Protrusion>;
    };
  };
  /** What holds the length of the marker. */
  "marker.hold": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** Then the call is refused if it has no answer; 1 to 86,400,000. */
      deadlineMs?: number;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** The marker's. */
      length: number;
      /** The contacts that carry load, from left to right. */
      contacts: Array<LoadedContact>;
      /** What tilting a piece would bring, the most telling first. */
      tilts: Array<TiltWorth>;
      /** What a unit less of spacing would bring. */
      perSpacing: number;
    };
  };
  /** The cloth that no piece covers. */
  "marker.regions": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** Smaller regions are left out; 1e-4 of the width squared when absent. */
      leastArea?: number;
      /** How far regions stay from pieces; 2e-3 of the width when absent. */
      clearance?: number;
      /** Then the call is refused if it has no answer; 1 to 86,400,000. */
      deadlineMs?: number;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** From left to right. */
      regions: Array<Region>;
    };
  };
  /** The marker made shorter, all pieces moving at once. */
  "motion.compact": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** How hard to try; standard when absent. */
      accuracy?: Accuracy;
      /** At most this many, 0 to 100,000. */
      rounds?: number;
      /** Outlines that are farther apart than this part of the strip's width are modelled by simpler ones that hold them, 0 to 1; 0 when absent. */
      simplification?: number;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Rounds that were done. */
      rounds: number;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
  /** Pieces follow forces, the length held. */
  "motion.push": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** Those on one piece add up; a piece without one moves only out of the way. */
      forces: Array<Force>;
      /** How hard to try; standard when absent. */
      accuracy?: Accuracy;
      /** At most this many, 0 to 100,000. */
      rounds?: number;
      /** Outlines that are farther apart than this part of the strip's width are modelled by simpler ones that hold them, 0 to 1; 0 when absent. */
      simplification?: number;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** The sum over the pieces of force times the way along it. */
      gain: number;
      /** Rounds that were done. */
      rounds: number;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
  /** Every piece follows one force, the length held. */
  "motion.gravity": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** On every piece. */
      force: Direction;
      /** How hard to try; standard when absent. */
      accuracy?: Accuracy;
      /** At most this many, 0 to 100,000. */
      rounds?: number;
      /** Outlines that are farther apart than this part of the strip's width are modelled by simpler ones that hold them, 0 to 1; 0 when absent. */
      simplification?: number;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** The sum over the pieces of force times the way along it. */
      gain: number;
      /** Rounds that were done. */
      rounds: number;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
  /** One piece slides as far as it can, all others still. */
  "motion.bump": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** The piece's id. */
      piece: Id;
      /** Where to. */
      direction: Direction;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Where the piece's origin now lies; exact. */
      at: Point;
      /** How far it came in the direction. */
      gain: number;
      /** Ids of the pieces that hold it there. */
      touching: Array<string>;
      /** Is it elsewhere than before? */
      moved: boolean;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
  /** A piece dropped anywhere goes to the nearest free position. */
  "motion.place": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** The piece's id. */
      piece: Id;
      /** Where its origin is wanted. */
      to: Point;
      /** When nothing within the marker's length is free, beyond it. */
      mayGrow?: boolean;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** There is a free position; without one the piece stays. */
      found: boolean;
      /** Where its origin now lies; exact. */
      at: Point;
      /** From the wanted place; null when none was found. */
      distance: number | null;
      /** The marker had to become longer. */
      grown: boolean;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
  /** Overlapping pieces parted with little motion. */
  "motion.separate": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** The part of its length that the marker may become longer by, 0 to 10; 0 when absent. */
      grow?: number;
      /** When the pieces cannot be parted, leave out those that hold up the rest. */
      popOut?: boolean;
      /** Commit what was reached even when pieces still overlap. */
      partial?: boolean;
      /** Where a pair is aimed; nearest when absent. */
      target?: TargetRule;
      /** At most this many, 0 to 100,000. */
      rounds?: number;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Nothing overlaps any more. */
      apart: boolean;
      /** The sum over the pieces of how far each moved along x and along y. */
      moved: number;
      /** The largest of these. */
      farthestMove: number;
      /** Pairs that still overlap. */
      remaining: Array<Overlap>;
      /** Ids of the pieces left out. */
      popped: Array<string>;
      /** Rounds that were done. */
      rounds: number;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
  /** Free space shared out among the gaps between pieces. */
  "motion.float": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** Wider gaps count as this wide; in given_distance, the one wanted. */
      distance: number;
      /** What is made large; largest_minimum when absent. */
      mode?: FloatMode;
      /** Gaps to the strip's edges count, too. */
      edges?: boolean;
      /** At most this many, 0 to 100,000. */
      rounds?: number;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** The narrowest gap, at most the distance. */
      leastBefore: number;
      /** Likewise afterwards; proved. */
      leastAfter: number;
      /** The narrowest gap has the distance. */
      reached: boolean;
      /** Those narrower than the distance before or after. */
      gaps: Array<GapWidths>;
      /** Sets of gaps that hold a minimum. */
      critical: Array<CriticalSet>;
      /** Rounds that were done. */
      rounds: number;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
  /** Pieces move away from a point or an unoccupied region, the length held. */
  "motion.openGap": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** In an unoccupied region: pieces around it move away from the point. Required without a region. */
      point?: Point;
      /** A region's place in the list of marker.regions, from 0: pieces move away from its outline. */
      region?: number;
      /** Smaller regions are left out; 1e-4 of the width squared when absent. */
      leastArea?: number;
      /** How far regions stay from pieces; 2e-3 of the width when absent. */
      clearance?: number;
      /** How hard to try; standard when absent. */
      accuracy?: Accuracy;
      /** At most this many, 0 to 100,000. */
      rounds?: number;
      /** Outlines that are farther apart than this part of the strip's width are modelled by simpler ones that hold them, 0 to 1; 0 when absent. */
      simplification?: number;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Of the region that holds the point inside. */
      areaBefore: number;
      /** Never smaller. */
      areaAfter: number;
      /** A point of the gap, before and after. */
      inside: Point;
      /** The region afterwards. */
      gap: Region;
      /** Rounds that were done. */
      rounds: number;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
  /** The marker made shorter with small tilts. */
  "motion.tilt": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** All pieces at once (when absent), or one after another. */
      method?: "linearisation" | "relaxation";
      /** Largest tilt in degrees, 0 to 45, in place of every shape's own. */
      limit?: number;
      /** So often the pieces are shaken for the rounds to begin again, 0 to 10,000. */
      shakes?: number;
      /** Of relaxation: so many tilts are tried, 1 to 1,001. */
      tilts?: number;
      /** How hard to try; standard when absent. */
      accuracy?: Accuracy;
      /** At most this many, 0 to 100,000. */
      rounds?: number;
      /** Outlines that are farther apart than this part of the strip's width are modelled by simpler ones that hold them, 0 to 1; 0 when absent. */
      simplification?: number;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** After compaction, before any piece was tilted. */
      lengthCompacted: number;
      /** The largest tilt of any piece either way, in degrees. */
      farthestTilt: number;
      /** Rounds that were done. */
      rounds: number;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
  /** One piece goes to where it has most room. */
  "motion.relax": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** The piece's id. */
      piece: Id;
      /** So many tilts are tried; 0, as when absent: it keeps its tilt. */
      tilts?: number;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Where it lies now. */
      at: Point;
      /** How it is tilted now, in degrees. */
      tilt: number;
      /** It may move by so much along both axes at once, either way. */
      freedom: number;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
  /** A baseline: every piece bumped to the left, one after another. */
  "motion.oneAtATime": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** At most this many, 0 to 100,000. */
      rounds?: number;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Rounds that were done. */
      rounds: number;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
  /** A baseline: pieces pushed by a piston, time step by time step. */
  "motion.velocity": {
    params: {
      /** The marker's id. */
      markerId: string;
      /** At most this many, 0 to 100,000. */
      rounds?: number;
      /** Refuse when the marker is at another revision. */
      baseRev?: number;
      /** False: answer, but leave the marker as it is. */
      commit?: boolean;
      /** A name for this call: a retry of it gets the same answer. */
      opId?: string;
      /** Then the best so far is answered; 1 to 86,400,000. */
      deadlineMs?: number;
      /** Rounds are told under it. */
      progressToken?: ProgressToken;
      /** Answer with ms and cache, too. */
      timing?: boolean;
    };
    result: {
      /** The marker's id. */
      markerId: string;
      /** The marker's revision. */
      revision: number;
      /** Rounds that were done. */
      rounds: number;
      /** Why it ended. */
      stop: StopReason;
      /** The marker's. */
      name: string;
      /** How many there are. */
      pieces: number;
      /** Exact. */
      lengthBefore: number;
      /** Exact. */
      lengthAfter: number;
      /** 0 to 1. */
      utilisationBefore: number;
      /** 0 to 1. */
      utilisationAfter: number;
      /** Of the result, proved anew. */
      valid: boolean;
      /** Small overlaps that were parted first. */
      healed: Healing;
      /** Of the pieces that moved. */
      placements: Array<Placement>;
      /** With timing. */
      ms?: StageTimes;
      /** With timing. */
      cache?: CacheCounts;
    };
  };
}

/** What the daemon sends unasked. */
export interface Notifications {
  /** A marker that is watched has a new revision. */
  "marker.changed": {
    /** The marker's id. */
    markerId: string;
    /** The marker's revision. */
    revision: number;
    /** Of the pieces that are new or lie or are locked otherwise. */
    placements: Array<PieceState>;
    /** Ids of the pieces that are gone. */
    removed: Array<string>;
    /** The marker's. */
    name: string;
    /** How many there are. */
    pieces: number;
    /** Where the rightmost piece ends; exact. */
    length: number;
    /** The pieces' area over width times length, 0 to 1. */
    utilisation: number;
    /** Proved in integers. */
    valid: boolean;
    /** The method that changed it. */
    by: string;
    /** True: more than that changed. */
    whole?: boolean;
  };
  /** A marker that was watched is closed. */
  "marker.closed": {
    /** The marker's id. */
    markerId: string;
  };
  /** A round of a motion is done. */
  "$/progress": {
    /** The call's progressToken. */
    token: ProgressToken;
    /** Which is done. */
    round: number;
    /** The marker's now. */
    length: number;
  };
}

/** Methods that take an opId: a retry does nothing twice. */
export const retriable: ReadonlySet<string> = new Set([
  "marker.open",
  "marker.close",
  "marker.apply",
  "marker.undo",
  "marker.redo",
  "drag.end",
  "motion.compact",
  "motion.push",
  "motion.gravity",
  "motion.bump",
  "motion.place",
  "motion.separate",
  "motion.float",
  "motion.openGap",
  "motion.tilt",
  "motion.relax",
  "motion.oneAtATime",
  "motion.velocity",
]);
