/**
 * The encoding of a text file, by the rules of the command line (protocol/trade/unicode/utf8_text.h and encoding_of in
 * protocol/trade/text.h), so that both read the same names. The daemon receives text, not the bytes of a file.
 */
interface Pair {
  lead: number;
  trail: number;
}
type Test = (pair: Pair) => boolean;

const within = (value: number, first: number, last: number) => value >= first && value <= last;

/** A file's text, and the name of its encoding if that was guessed or stated, as the command line notes it. */
export interface Decoded {
  text: string;
  readAs?: string;
}

/** Throws for UTF-32, which the command line does not read either. */
export function decode(buffer: ArrayBuffer): Decoded {
  const bytes = new Uint8Array(buffer);
  const begins = (...mark: number[]) => mark.every((byte, k) => bytes[k] === byte);
  if (begins(0xff, 0xfe, 0, 0) || begins(0, 0, 0xfe, 0xff)) throw new Error("UTF-32 is not read; save the file as UTF-8 or UTF-16");
  const label = begins(0xff, 0xfe) || beginsInAscii(bytes, 0) ? "utf-16le" : begins(0xfe, 0xff) || beginsInAscii(bytes, 1) ? "utf-16be" : encodingOf(bytes);
  const text = new TextDecoder(label).decode(bytes);
  const readAs = NAMES[label];
  return readAs === undefined ? { text } : { text, readAs };
}

// As name_of in protocol/trade/text.h, and kKnown in protocol/trade/unicode/utf8_text.cpp.
const NAMES: Record<string, string> = {
  "utf-16le": "UTF-16 (little-endian)",
  "utf-16be": "UTF-16 (big-endian)",
  gbk: "GBK",
  big5: "Big5",
  "windows-1252": "Windows-1252",
  "windows-1250": "Windows-1250",
  "windows-1251": "Windows-1251",
  "windows-1254": "Windows-1254",
  shift_jis: "Shift JIS",
  "euc-kr": "Korean (949)",
};

// Whether the first four units of two bytes are ASCII characters, with the character's own byte first (0) or second (1).
function beginsInAscii(bytes: Uint8Array, low: 0 | 1): boolean {
  if (bytes.length < 8) return false;
  return [0, 2, 4, 6].every((at) => {
    const own = bytes[at + low]!;
    return bytes[at + 1 - low] === 0 && (within(own, 0x20, 0x7e) || own === 9 || own === 10 || own === 13);
  });
}

const CODE_PAGES: Record<string, string> = {
  ANSI_936: "gbk",
  ANSI_950: "big5",
  ANSI_1250: "windows-1250",
  ANSI_1251: "windows-1251",
  ANSI_1254: "windows-1254",
  ANSI_932: "shift_jis",
  ANSI_949: "euc-kr",
};

const inGb2312: Test = ({ lead, trail }) => (within(lead, 0xa1, 0xa3) || within(lead, 0xb0, 0xf7)) && within(trail, 0xa1, 0xfe);
const inBig5: Test = ({ lead, trail }) => within(lead, 0xa1, 0xf9) && (within(trail, 0x40, 0x7e) || within(trail, 0xa1, 0xfe));
const inGbk: Test = ({ lead, trail }) => within(lead, 0x81, 0xfe) && within(trail, 0x40, 0xfe) && trail !== 0x7f;

function encodingOf(bytes: Uint8Array): string {
  // Some words of GB 2312 are UTF-8 as well, of letters that are hardly ever written.
  if (isUtf8(bytes)) return mostlyPairs(bytes, inGb2312, ({ lead }) => within(lead, 0xc6, 0xcd)) ? "gbk" : "utf-8";
  const stated = CODE_PAGES[statedCodePage(bytes)];
  if (stated !== undefined) return stated;
  if (mostlyPairs(bytes, inGb2312, ({ lead }) => lead <= 0xd7)) return "gbk";
  if (mostlyPairs(bytes, inBig5, ({ lead }) => within(lead, 0xa4, 0xc6))) return "big5";
  return mostlyPairs(bytes, inGbk, () => true) ? "gbk" : "windows-1252";
}

function isUtf8(bytes: Uint8Array): boolean {
  try {
    new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    return true;
  } catch {
    return false;
  }
}

// The code page that the header of a DXF file states, or "".
function statedCodePage(bytes: Uint8Array): string {
  const header = new TextDecoder("windows-1252").decode(bytes.subarray(0, 1 << 16));
  return /\$DWGCODEPAGE\s+3\s+(\S+)/.exec(header)?.[1] ?? "";
}

const isLetter = (byte: number | undefined) => byte !== undefined && within(byte | 0x20, 0x61, 0x7a);

// Whether all bytes above 0x7f come in pairs that `suits` accepts, at least half of which are `frequent` characters and do not
// look like an accented letter within a Latin word.
function mostlyPairs(bytes: Uint8Array, suits: Test, frequent: Test): boolean {
  let pairs = 0;
  let likely = 0;
  for (let at = 0; at < bytes.length; ++at) {
    const lead = bytes[at]!;
    if (lead < 0x80) continue;
    const trail = bytes[at + 1];
    if (trail === undefined || !suits({ lead, trail })) return false;
    const behind = isLetter(bytes[at - 1]);
    const before = isLetter(bytes[at + 2]);
    const inWord = isLetter(trail) ? behind || before : behind && before && bytes[at + 2]! >= 0x61;
    ++pairs;
    if (frequent({ lead, trail }) && !inWord) ++likely;
    ++at;
  }
  return pairs > 0 && 2 * likely >= pairs;
}
