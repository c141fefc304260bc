import { IfcGuids } from './ifc-guids.ts';
import { IfcProperties } from './ifc-properties.ts';
import { IfcShapes } from './ifc-shapes.ts';
import { type Ref, StepFile } from './step-file.ts';
import { cutLabel, fixed, label, list, OMITTED, type StepValue } from './step-text.ts';

/** What tells a thing from others: its part in the building, what makes it itself, and what it is called. */
export interface Identity {
  readonly role: string;
  readonly content: string;
  readonly name: string;
  /** What the name stands for, where it is a number. */
  readonly longName?: string;
  readonly objectType?: string;
}

/** Decimals of a thickness: walls that are one to 0.1 mm are of one make. */
const THICKNESS_DIGITS = 4;

/** An IFC file in the making: things, how they hang together, their shapes and properties. */
export class IfcModel {
  readonly file = new StepFile();
  readonly properties = new IfcProperties(this.file);
  readonly guids: IfcGuids;
  readonly shapes: IfcShapes;
  /** The context of all shapes: metres, z up. */
  readonly context: Ref;
  readonly #walls = new Map<StepValue, Ref[]>();

  /** @param scan what tells the scan from others */
  constructor(scan: string) {
    this.guids = new IfcGuids(scan);
    const { file } = this;
    const origin = file.share('IFCCARTESIANPOINT', '(0.,0.,0.)');
    const axes = file.share('IFCAXIS2PLACEMENT3D', origin, OMITTED, OMITTED);
    // True north is not known: a projected grid's y axis is near it, other than by the convergence.
    this.context = file.add(
      'IFCGEOMETRICREPRESENTATIONCONTEXT',
      ...[OMITTED, "'Model'", '3', '1.E-06', axes, OMITTED],
    );
    const body = file.add(
      'IFCGEOMETRICREPRESENTATIONSUBCONTEXT',
      ...["'Body'", "'Model'", '*', '*', '*', '*', this.context, OMITTED, '.MODEL_VIEW.', OMITTED],
    );
    this.shapes = new IfcShapes(file, body);
  }

  /**
   * Adds a thing with a globally unique id.
   *
   * A name longer than an IfcLabel can be is cut and stands in full in the description.
   *
   * @param values what follows name, description and object type
   */
  thing(
    type: string,
    { role, content, name, longName = name, objectType }: Identity,
    ...values: readonly StepValue[]
  ): Ref {
    const kind = objectType === undefined ? OMITTED : label(objectType);
    return this.file.add(
      type,
      ...[this.guids.next(role, content), OMITTED, label(name), cutLabel(longName), kind, ...values],
    );
  }

  /** @param values what follows name and description */
  relation(type: string, content: readonly StepValue[], ...values: readonly StepValue[]): void {
    const guid = this.guids.next(type, content.join(' '));
    this.file.add(type, guid, OMITTED, OMITTED, OMITTED, ...values);
  }

  /** The parts that make up a whole. */
  aggregate(whole: Ref, parts: readonly Ref[]): void {
    if (parts.length > 0) this.relation('IFCRELAGGREGATES', [whole], whole, list(parts));
  }

  /** The elements that stand in a storey or a room. */
  contain(place: Ref, elements: readonly Ref[]): void {
    if (elements.length === 0) return;
    this.relation('IFCRELCONTAINEDINSPATIALSTRUCTURE', [place], list(elements), place);
  }

  /** Gives a wall its one layer, of a material that a scan cannot tell. */
  layer(wall: Ref, thickness: number): void {
    const written = fixed(thickness, THICKNESS_DIGITS);
    const others = this.#walls.get(written);
    if (others === undefined) this.#walls.set(written, [wall]);
    else others.push(wall);
  }

  /** Writes what things share. */
  end(): void {
    const material = this.file.share('IFCMATERIAL', "'Not known'", OMITTED, OMITTED);
    for (const [thickness, walls] of this.#walls) {
      const layer = this.file.add(
        'IFCMATERIALLAYER',
        ...[material, thickness, OMITTED, OMITTED, OMITTED, OMITTED, OMITTED],
      );
      const name = label(`Wall ${thickness} m`);
      const set = this.file.add('IFCMATERIALLAYERSET', list([layer]), name, OMITTED);
      this.relation('IFCRELASSOCIATESMATERIAL', [thickness], list(walls), set);
    }
    this.properties.end(this.guids);
    this.shapes.end();
  }
}
