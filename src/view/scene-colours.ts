/** Colours of the scene; each is the custom property `--scene-<name>` of the style sheet. */
const SCENE_COLOURS = ['ground', 'wall', 'cut', 'floor', 'structure', 'edge', 'grid'] as const;
/** As CSS writes them. */
export type SceneColours = Readonly<Record<(typeof SCENE_COLOURS)[number], string>>;

/** What the style sheet gives under the theme that holds now: a custom property resolves only through a real one. */
export function readColours(host: HTMLElement): SceneColours {
  const probe = document.createElement('span');
  probe.hidden = true;
  host.append(probe);
  const entries = SCENE_COLOURS.map((name) => {
    probe.style.color = `var(--scene-${name})`;
    return [name, getComputedStyle(probe).color] as const;
  });
  probe.remove();
  return Object.fromEntries(entries) as unknown as SceneColours;
}
