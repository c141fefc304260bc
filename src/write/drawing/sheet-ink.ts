/** The colours of a sheet that does not follow a page's. */
export const INK = '#1B1F24';
export const PAPER = '#FFFFFF';
/** Share of ink in the points beneath a plan, and their size, mm. */
export const POINT_INK = 0.2;
export const POINT_SIZE = 0.25;
