type Attribute = string | number | boolean | null | undefined;

export interface Made {
  readonly class?: string;
  readonly testid?: string;
  readonly on?: Readonly<Record<string, (event: never) => void>>;
  readonly [attribute: string]: unknown;
}

/**
 * One element with attributes, listeners and children.
 *
 * `true` sets an attribute empty, `false`, `null` and `undefined` leave it out.
 */
export function make<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  { class: className, testid, on, ...attributes }: Made = {},
  ...children: (Node | string | null)[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  if (className) element.className = className;
  if (testid) element.dataset.testid = testid;
  for (const [name, value] of Object.entries(attributes)) setAttribute(element, name, value as Attribute);
  for (const [type, listener] of Object.entries(on ?? {})) {
    element.addEventListener(type, listener as EventListener);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

/** Sets or removes an attribute, touching the document only when something changes. */
export function setAttribute(element: Element, name: string, value: Attribute): void {
  const text =
    value === true ? '' : value === false || value === null || value === undefined ? null : String(value);
  if (element.getAttribute(name) === text) return;
  if (text === null) element.removeAttribute(name);
  else element.setAttribute(name, text);
}

/** Sets text, touching the document only when it changes: live regions speak what changes. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}
