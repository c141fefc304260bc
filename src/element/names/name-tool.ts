import { areaOf } from '../../core/geometry/areas.ts';
import { ringsOf } from '../../core/geometry/rings.ts';
import { automaticName, tidyName } from '../../core/room-names.ts';
import { planPlace } from '../../core/source-coordinates.ts';
import type { Vec2 } from '../../core/types.ts';
import type { SheetPlace } from '../../view/sheet.ts';
import type { SheetMark } from '../../view/sheet-marks.ts';
import { isolated } from '../../write/sheet/isolated.ts';
import { formatArea } from '../../write/sheet/measure-words.ts';
import type { Actions, Model } from '../model.ts';
import type { PlanTool } from '../plan-tool.ts';
import { TOOLS } from '../tools.ts';
import { NameBar, type NameShown } from './name-bar.ts';
import { PlanRoomNames } from './plan-room-names.ts';

const START = 'Press a room to name it.';
const NO_ROOM = 'No room is here.';
const EMPTY_STOREY = 'No room was found in this storey.';

/** Names rooms in the drawing: a press chooses one, its name is typed in the bar. */
export class NameTool implements PlanTool {
  readonly bar: NameBar;
  readonly #actions: Actions;
  readonly #redraw: () => void;
  #model: Model | null = null;
  #names: PlanRoomNames | null = null;
  /** Rooms by index; −1 for none. */
  #hovered = -1;
  #chosen = -1;
  /** In the room chosen, source units and coordinates: it stays there whatever becomes of the plan. */
  #place: Vec2 | null = null;

  constructor(actions: Actions, redraw: () => void) {
    this.#actions = actions;
    this.#redraw = redraw;
    this.bar = new NameBar({
      onName: (name) => this.#name(name),
      onNext: () => this.#next(),
      onLeave: () => actions.takeTool(null),
    });
  }

  show(model: Model): void {
    const before = this.#model;
    this.#model = model;
    const isInHand = model.tool === 'names';
    this.bar.node.hidden = !isInHand;
    if (!isInHand || before?.name !== model.name || before.storey !== model.storey) this.#place = null;
    const isSame =
      before?.view === model.view &&
      before?.storey === model.storey &&
      before?.unit === model.unit &&
      before?.tool === model.tool &&
      before?.options.roomNames === model.options.roomNames;
    if (!isSame) this.#take(model);
  }

  hover(place: SheetPlace | null): void {
    this.#hovered = place && this.#names ? this.#names.at(place.at) : -1;
    this.bar.say(this.#words);
    this.#redraw();
  }

  press({ at }: SheetPlace): void {
    const index = this.#names?.at(at) ?? -1;
    if (index >= 0) this.#choose(index);
    else this.bar.say(this.#names && this.#hasRooms ? NO_ROOM : this.#words);
  }

  get marks(): readonly SheetMark[] {
    const names = this.#names;
    if (!names) return [];
    const shown = [...new Set([this.#hovered, this.#chosen])].filter((index) => index >= 0);
    return shown.map((index) => ({
      kind: 'area',
      rings: ringsOf([names.rooms[index].outline]),
      isChosen: index === this.#chosen,
    }));
  }

  #take(model: Model): void {
    const { view, options, tool } = model;
    this.#names = tool === 'names' && view ? this.#read(options.roomNames) : null;
    this.#hovered = -1;
    const isKept = this.#names && view && this.#place;
    this.#chosen = isKept ? this.#names!.at(planPlace(view.plan.frame, ...this.#place!)) : -1;
    this.bar.show(this.#shown);
    this.bar.say(this.#words);
    this.#redraw();
  }

  /** @param text the parameter `roomNames` */
  #read(text: string): PlanRoomNames {
    const { view, storey } = this.#model!;
    const { plan, isSavedPlan } = view!;
    const shown = Math.min(storey, plan.storeys.length - 1);
    return new PlanRoomNames({ plan, storey: shown, text, isSaved: isSavedPlan });
  }

  #choose(index: number): void {
    this.#chosen = index;
    this.#place = this.#names!.placeOf(index);
    this.bar.edit(this.#shown);
    this.bar.say(this.#words);
    this.#redraw();
  }

  #next(): void {
    if (this.#hasRooms) this.#choose((this.#chosen + 1) % this.#names!.rooms.length);
  }

  #name(text: string): void {
    const names = this.#names;
    if (!names || this.#chosen < 0) return;
    const name = tidyName(text);
    if (name !== names.nameOf(this.#chosen)) {
      const roomNames = names.with(this.#chosen, name);
      // The plan follows; what is pressed next comes before it.
      this.#names = this.#read(roomNames);
      if (roomNames !== this.#model!.options.roomNames) this.#actions.change({ roomNames }, true);
    }
    this.bar.show(this.#shown);
    this.bar.say(this.#words);
  }

  get #hasRooms(): boolean {
    return (this.#names?.rooms.length ?? 0) > 0;
  }

  get #shown(): NameShown {
    const index = this.#chosen;
    const name = index < 0 ? null : this.#names!.nameOf(index);
    return { name, automatic: index < 0 ? '' : automaticName(index), hasRooms: this.#hasRooms };
  }

  get #words(): string {
    const { view, unit = 'm' } = this.#model ?? {};
    const why = view && TOOLS.names.lacks(view);
    if (why) return why;
    if (!this.#names || !this.#hasRooms) return EMPTY_STOREY;
    const index = this.#hovered < 0 ? this.#chosen : this.#hovered;
    if (index < 0) return START;
    const area = formatArea(areaOf([this.#names.rooms[index].outline]), unit);
    return `${isolated(this.#names.nameOf(index))}, ${area}`;
  }
}
