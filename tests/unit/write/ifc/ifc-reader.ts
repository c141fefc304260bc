import * as webIfc from 'web-ifc';

/** A plan.ifc as web-ifc reads it. */
export class IfcReader {
  readonly #api: webIfc.IfcAPI;
  readonly #model: number;

  private constructor(api: webIfc.IfcAPI, model: number) {
    this.#api = api;
    this.#model = model;
  }

  static async open(file: string): Promise<IfcReader> {
    const api = new webIfc.IfcAPI();
    await api.Init();
    api.SetLogLevel(webIfc.LogLevel.LOG_LEVEL_OFF);
    return new IfcReader(api, api.OpenModel(new TextEncoder().encode(file)));
  }

  ids(type: number): number[] {
    const found = this.#api.GetLineIDsWithType(this.#model, type);
    return Array.from({ length: found.size() }, (_, i) => found.get(i));
  }

  /** A line with its values; what it refers to is a `{ value: id }`, or resolved where asked for. */
  // biome-ignore lint/suspicious/noExplicitAny: web-ifc's lines have no common type.
  line(id: number, isDeep = false): any {
    return this.#api.GetLine(this.#model, id, isDeep);
  }

  // biome-ignore lint/suspicious/noExplicitAny: as above.
  lines(type: number, isDeep = false): any[] {
    return this.ids(type).map((id) => this.line(id, isDeep));
  }

  names(type: number): string[] {
    return this.lines(type).map(({ Name }) => Name.value);
  }

  /** m³, openings cut; by the divergence theorem over the triangles that web-ifc makes. */
  volume(id: number): number {
    const mesh = this.#api.GetFlatMesh(this.#model, id);
    let volume = 0;
    for (let g = 0; g < mesh.geometries.size(); g++) {
      const geometry = this.#api.GetGeometry(this.#model, mesh.geometries.get(g).geometryExpressID);
      const vertices = this.#api.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize());
      const indices = this.#api.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize());
      volume += Math.abs(enclosed(vertices, indices));
    }
    return volume;
  }

  /** What a set says of a thing, by name; properties and quantities alike. */
  set(id: number, name: string): Record<string, unknown> {
    for (const relation of this.lines(webIfc.IFCRELDEFINESBYPROPERTIES)) {
      if (!relation.RelatedObjects.some(({ value }: { value: number }) => value === id)) continue;
      const set = this.line(relation.RelatingPropertyDefinition.value, true);
      if (set.Name.value !== name) continue;
      // biome-ignore lint/suspicious/noExplicitAny: as above.
      const items: any[] = set.HasProperties ?? set.Quantities;
      return Object.fromEntries(
        items.map((item) => {
          const value = item.NominalValue ?? item.LengthValue ?? item.AreaValue ?? item.VolumeValue;
          return [item.Name.value, value.value];
        }),
      );
    }
    return {};
  }

  close(): void {
    this.#api.CloseModel(this.#model);
  }
}

/** Six numbers a vertex: place and normal. */
function enclosed(vertices: Float32Array, indices: Uint32Array): number {
  let six = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [6 * indices[i], 6 * indices[i + 1], 6 * indices[i + 2]];
    const v = vertices;
    six +=
      v[a] * (v[b + 1] * v[c + 2] - v[b + 2] * v[c + 1]) +
      v[a + 1] * (v[b + 2] * v[c] - v[b] * v[c + 2]) +
      v[a + 2] * (v[b] * v[c + 1] - v[b + 1] * v[c]);
  }
  return six / 6;
}
