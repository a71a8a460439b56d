/** Codes of errors on the wire; they never change their meaning. */
export const Code = {
  ParseError: -32700,
  InvalidRequest: -32600,
  MethodNotFound: -32601,
  InvalidParams: -32602,
  InternalError: -32603,
  MotionRefused: -32000,
  Busy: -32010,
  TooLarge: -32011,
  UnknownMarker: -32012,
  Limit: -32013,
  Draining: -32014,
  Unauthorised: -32015,
  Cancelled: -32800,
  RevisionMismatch: -32801,
  Superseded: -32802,
} as const;

export interface ErrorData {
  /** What exactly, as a number and a name such as "marker.overlaps". */
  code?: number;
  name?: string;
  /** A JSON pointer into the parameters. */
  field?: string;
  revision?: number;
  limit?: number;
  retryAfterMs?: number;
}

/** A call that the daemon refused. */
export class CallError extends Error {
  override readonly name = "CallError";
  constructor(
    readonly code: number,
    message: string,
    readonly data: ErrorData = {},
  ) {
    super(message);
  }
}

/** A call whose answer never came: nobody knows whether it was carried out. */
export class ConnectionLost extends Error {
  override readonly name = "ConnectionLost";
}
