import { CallError, Client, Code, overWebSocket, type Connect } from "../../typescript/src/index";
import { Signal } from "../base/signal";
import { engineInPage } from "../standalone/connect";

export type LinkState = "connecting" | "open" | "lost" | "token" | "refused";

const TOKEN = "selvage-token";
const wait = (milliseconds: number) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** The address of the daemon that served this page. */
const address = () => `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/ws`;

/** The connection to the engine inside the page, if the page was opened as a file. */
const inPage = engineInPage();

/**
 * The connection to the daemon, for as long as the page is open. The client resends what was in progress when a connection is
 * lost; when it gives up, a new client is made, until the daemon answers again.
 */
export class Link {
  readonly state = new Signal<LinkState>("connecting");
  /** Whether there is no daemon, because the engine runs in the page; it then handles one call at a time. */
  readonly alone = inPage !== undefined;
  /** The number of connections made so far; code that watches a marker watches it again when this changes. */
  readonly joined = new Signal(0);
  private client: Client | undefined;
  private opening: Promise<Client> | undefined;
  private answerToken: (token: string) => void = () => {};

  constructor() {
    if (this.alone) return;
    // A page that is left may be kept by the browser for a return, with its connection.
    addEventListener("pagehide", () => {
      this.client?.close();
      this.client = undefined;
    });
    addEventListener("pageshow", ({ persisted }) => persisted && void this.ready());
  }

  /** The client; waits until the daemon can be reached. */
  ready(): Promise<Client> {
    return this.client ? Promise.resolve(this.client) : (this.opening ??= this.open());
  }

  /** Passes on the token that the user entered when the daemon required one. */
  giveToken(token: string): void {
    sessionStorage.setItem(TOKEN, token);
    this.answerToken(token);
  }

  private async open(): Promise<Client> {
    for (let pause = 250; ; pause = Math.min(4000, pause * 1.6)) {
      try {
        const client = await Client.open(this.observed(), { attempts: 7 });
        this.client = client;
        this.opening = undefined;
        client.on("reconnected", () => (this.joined.value += 1));
        this.joined.value += 1;
        return client;
      } catch (error) {
        if (error instanceof CallError && error.code === Code.Unauthorised) await this.askForToken();
        else {
          this.state.value = this.joined.value > 0 ? "lost" : "refused";
          await wait(pause);
        }
      }
    }
  }

  private async askForToken(): Promise<void> {
    this.state.value = "token";
    await new Promise<string>((resolve) => (this.answerToken = resolve));
    this.state.value = "connecting";
  }

  // Connects as the client does, and reports the state of the connection.
  private observed(): Connect {
    return async (listener) => {
      const token = sessionStorage.getItem(TOKEN) ?? undefined;
      const connect = inPage ?? overWebSocket(address(), token === undefined ? {} : { token });
      const connection = await connect({
        message: (text) => {
          if (this.state.value !== "open" && !text.includes('"error"')) this.state.value = "open";
          listener.message(text);
        },
        closed: (reason) => {
          if (this.state.value === "open") this.state.value = "lost";
          listener.closed(reason);
          void this.revive();
        },
      });
      return connection;
    };
  }

  // The client tries to reconnect for about ten seconds. After that, this page makes a new client.
  private async revive(): Promise<void> {
    const client = this.client;
    await wait(13_000);
    if (this.state.value === "open" || this.client !== client) return;
    client?.close();
    this.client = undefined;
    void this.ready();
  }
}
