/** The error codes of the protocol, whose meanings never change. */
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
  /** The exact error, as a number and as a name such as "marker.overlaps". */
  code?: number;
  name?: string;
  /** A JSON pointer to the wrong parameter. */
  field?: string;
  revision?: number;
  limit?: number;
  retryAfterMs?: number;
}

/** The daemon answered a call with an error. */
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

/** The connection ended before a call was answered, so the call may or may not have been carried out. */
export class ConnectionLost extends Error {
  override readonly name = "ConnectionLost";
}
