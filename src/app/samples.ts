import { icon } from '../element/icon.ts';
import { make } from '../element/make.ts';

/** Scans that come with the page; paths relative to it. */
export const SAMPLES = [
  { name: 'Home', file: 'samples/home.ply', doc: 'Several rooms and a column' },
  { name: 'Office', file: 'samples/office.ply', doc: 'A corridor with offices' },
  { name: 'Hallway', file: 'samples/hallway.csv', doc: 'A ready slice with a curved wall' },
] as const;

/** The samples in the bar: in a row where there is room, else behind a button. */
export function fillSamples(nav: HTMLElement, open: (file: string) => void): void {
  const list = make('div', { class: 'sample-list', id: 'sample-list' });
  const toggle = make(
    'button',
    {
      type: 'button',
      class: 'sample-toggle',
      'aria-expanded': 'false',
      'aria-controls': 'sample-list',
      'aria-label': 'Samples',
      on: { click: () => fold(toggle.getAttribute('aria-expanded') === 'true') },
    },
    icon('samples'),
  );
  const fold = (isFolded: boolean) => {
    toggle.setAttribute('aria-expanded', String(!isFolded));
    list.classList.toggle('is-open', !isFolded);
  };
  for (const [i, { name, file, doc }] of SAMPLES.entries()) {
    const pick = () => {
      fold(true);
      open(file);
    };
    const testid = i === 0 ? 'sample' : `sample-${name.toLowerCase()}`;
    list.append(make('button', { type: 'button', testid, title: doc, on: { click: pick } }, name));
  }
  nav.append(make('span', { class: 'samples-label' }, 'Samples'), toggle, list);
}

/** The samples with their pictures, under the invitation. */
export function fillThumbnails(place: HTMLElement, open: (file: string) => void): void {
  for (const { name, file, doc } of SAMPLES) {
    const picture = make('img', {
      src: `thumbnails/${name.toLowerCase()}.svg`,
      alt: '',
      width: 120,
      height: 80,
    });
    const words = make('span', { class: 'thumbnail-name' }, name);
    const button = make('button', { type: 'button', on: { click: () => open(file) } }, picture, words);
    button.append(make('span', { class: 'thumbnail-doc' }, doc));
    place.append(button);
  }
}
