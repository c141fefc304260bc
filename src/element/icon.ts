import check from 'lucide-static/icons/check.svg?raw';
import chevron from 'lucide-static/icons/chevron-right.svg?raw';
import alert from 'lucide-static/icons/circle-alert.svg?raw';
import help from 'lucide-static/icons/circle-question-mark.svg?raw';
import crop from 'lucide-static/icons/crop.svg?raw';
import door from 'lucide-static/icons/door-open.svg?raw';
import download from 'lucide-static/icons/download.svg?raw';
import open from 'lucide-static/icons/folder-open.svg?raw';
import picture from 'lucide-static/icons/images.svg?raw';
import spinner from 'lucide-static/icons/loader-circle.svg?raw';
import fit from 'lucide-static/icons/maximize.svg?raw';
import minus from 'lucide-static/icons/minus.svg?raw';
import system from 'lucide-static/icons/monitor.svg?raw';
import dark from 'lucide-static/icons/moon.svg?raw';
import plus from 'lucide-static/icons/plus.svg?raw';
import redo from 'lucide-static/icons/redo-2.svg?raw';
import reset from 'lucide-static/icons/rotate-ccw.svg?raw';
import ruler from 'lucide-static/icons/ruler.svg?raw';
import samples from 'lucide-static/icons/shapes.svg?raw';
import light from 'lucide-static/icons/sun.svg?raw';
import tag from 'lucide-static/icons/tag.svg?raw';
import warning from 'lucide-static/icons/triangle-alert.svg?raw';
import undo from 'lucide-static/icons/undo-2.svg?raw';
import close from 'lucide-static/icons/x.svg?raw';

const SOURCES = {
  alert,
  check,
  chevron,
  close,
  crop,
  dark,
  door,
  download,
  fit,
  help,
  light,
  minus,
  open,
  picture,
  plus,
  redo,
  reset,
  ruler,
  samples,
  spinner,
  system,
  tag,
  undo,
  warning,
} as const;

export type IconName = keyof typeof SOURCES;

const parsed = new Map<IconName, Element>();

/** An icon of the lucide set (ISC) as nodes; it says nothing to a screen reader, so label what it stands on. */
export function icon(name: IconName): Element {
  let original = parsed.get(name);
  if (!original) {
    original = new DOMParser().parseFromString(SOURCES[name], 'image/svg+xml').documentElement;
    original.setAttribute('class', 'icon');
    original.setAttribute('aria-hidden', 'true');
    parsed.set(name, original);
  }
  return document.importNode(original, true);
}
