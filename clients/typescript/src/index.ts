export * from "./client.js";
export * from "./connection.js";
export * from "./errors.js";
export * from "./methods.js";
export type { Progress, Round } from "./progress.js";
