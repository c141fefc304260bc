interface LookFacts {
  /** Layer by AIA names, as in the DXF. */
  readonly layer: string;
  /** sRGB, 0 to 1: the glTF's clay walls, paper floors, muted blue structures. */
  readonly colour: readonly [number, number, number];
  /** 0 is solid. */
  readonly transparency: number;
}

/** How each kind of thing looks, and its layer. */
export const LOOKS = {
  wall: { layer: 'A-WALL', colour: [0.886, 0.875, 0.855], transparency: 0 },
  floor: { layer: 'A-FLOR', colour: [0.957, 0.953, 0.937], transparency: 0 },
  ceiling: { layer: 'A-CLNG', colour: [0.957, 0.953, 0.937], transparency: 0 },
  structure: { layer: 'A-COLS', colour: [0.635, 0.714, 0.855], transparency: 0 },
  space: { layer: 'A-AREA', colour: [0.75, 0.85, 0.95], transparency: 0.8 },
  opening: { layer: 'A-OPENING', colour: [0.9, 0.6, 0.4], transparency: 0.8 },
  door: { layer: 'A-DOOR', colour: [0.72, 0.56, 0.4], transparency: 0 },
  frame: { layer: 'A-GLAZ', colour: [0.93, 0.93, 0.93], transparency: 0 },
  glass: { layer: 'A-GLAZ', colour: [0.7, 0.85, 0.9], transparency: 0.6 },
  furniture: { layer: 'A-FURN', colour: [0.8, 0.74, 0.66], transparency: 0 },
} as const satisfies Record<string, LookFacts>;

export type Look = keyof typeof LOOKS;
