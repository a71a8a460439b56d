import type { Connect } from "../../typescript/src/index";

const contentOf = (id: string) => document.getElementById(id)?.textContent?.trim();

/**
 * The transport to the engine inside a page that was built as one file: a connection starts the engine in a worker, and is lost
 * if the engine fails. Undefined if the page was served by a daemon.
 */
export function engineInPage(): Connect | undefined {
  const program = contentOf("engine");
  if (!program) return undefined;
  const script = URL.createObjectURL(new Blob([contentOf("engine-worker") ?? ""], { type: "text/javascript" }));
  return (listener) =>
    new Promise((resolve) => {
      const worker = new Worker(script);
      const close = () => worker.terminate();
      worker.onmessage = ({ data }: MessageEvent<string | true>) => {
        if (data === true) resolve({ send: (text) => worker.postMessage(text), close });
        else listener.message(data);
      };
      worker.onerror = ({ message }) => {
        close();
        listener.closed(`the engine failed: ${message}`);
      };
      const bytes = Uint8Array.from(atob(program), (letter) => letter.charCodeAt(0));
      worker.postMessage(bytes.buffer, [bytes.buffer]);
    });
}
