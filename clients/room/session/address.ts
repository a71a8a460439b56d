/** The id of the marker that the page's address names, as in #m3; empty if it names none. */
export function markerInAddress(): string {
  const text = location.hash.slice(1);
  try {
    return decodeURIComponent(text);
  } catch {
    return text; // not an encoded text, and so not the id of a marker
  }
}

/** Makes the address name a marker, without a new entry in the browser's history. */
export const putInAddress = (markerId: string): void => history.replaceState(null, "", `#${markerId}`);
