/** The example markers that the daemon serves with this page; `examples.json` names their hashed files. */
export interface Example {
  name: string;
  file: string;
}

export async function examples(): Promise<Example[]> {
  const link = document.querySelector<HTMLLinkElement>('link[rel="x-examples"]');
  if (!link) return [];
  return (await (await fetch(link.href)).json()) as Example[];
}

export async function example(file: string): Promise<Record<string, unknown>> {
  return (await (await fetch(file)).json()) as Record<string, unknown>;
}
