import { make, setText } from './make.ts';

/** Files dropped on `host` are opened; while they hover an overlay says what will happen. */
export function makeDropTarget(host: HTMLElement, onDrop: (files: readonly File[]) => void): HTMLElement {
  const words = make('p', {});
  const overlay = make('div', { class: 'drop-overlay', hidden: true, 'aria-hidden': 'true' }, words);
  // Entering a child fires before leaving its parent, so both are counted.
  let depth = 0;
  const leave = () => {
    depth = 0;
    overlay.hidden = true;
  };
  host.addEventListener('dragenter', ({ dataTransfer }) => {
    if (!dataTransfer?.types.includes('Files')) return;
    depth++;
    const count = [...dataTransfer.items].filter(({ kind }) => kind === 'file').length;
    setText(
      words,
      count > 1 ? `Release to read these ${count} files as one scan` : 'Release to make a plan of this scan',
    );
    overlay.hidden = false;
  });
  host.addEventListener('dragover', (event) => {
    if (!event.dataTransfer?.types.includes('Files')) return;
    event.preventDefault();
    event.dataTransfer.dropEffect = 'copy';
  });
  host.addEventListener('dragleave', () => {
    depth--;
    if (depth <= 0) leave();
  });
  host.addEventListener('drop', (event) => {
    const files = [...(event.dataTransfer?.files ?? [])];
    leave();
    if (files.length === 0) return;
    event.preventDefault();
    onDrop(files);
  });
  return overlay;
}
