/** One measured figure. */
export interface Figure {
  readonly name: string;
  /** Figures of one unit that have this form a table: names down, these across. */
  readonly of?: string;
  readonly value: number;
  readonly unit: string;
  readonly note?: string;
  /** It was stopped there: the true value is larger. */
  readonly isLeast?: boolean;
}

const NAME_WIDTH = 44;
const LEAST_WIDTH = 10;

/** Lines of a bench: its tables, a unit each, then its single figures. */
export function formatFigures(figures: readonly Figure[]): string {
  const inTables = figures.filter(({ of }) => of !== undefined);
  const units = [...new Set(inTables.map(({ unit }) => unit))];
  const tables = units.map((unit) => formatTable(inTables.filter((figure) => figure.unit === unit)));
  const single = figures.filter(({ of }) => of === undefined).map(formatSingle);
  return [...tables, ...(single.length > 0 ? [single.join('\n')] : [])].join('\n\n');
}

function formatTable(figures: readonly Figure[]): string {
  const columns = [...new Set(figures.map(({ of }) => of!))];
  const names = [...new Set(figures.map(({ name }) => name))];
  const width = Math.max(LEAST_WIDTH, ...columns.map((column) => column.length)) + 2;
  const head = `  ${figures[0].unit.padEnd(NAME_WIDTH)}${columns.map((column) => column.padStart(width)).join('')}`;
  const rows = names.map((name) => {
    const own = figures.filter((figure) => figure.name === name);
    const cells = columns.map((column) => {
      const figure = own.find(({ of }) => of === column);
      return (figure ? formatValue(figure) : '–').padStart(width);
    });
    const note = own.find((figure) => figure.note)?.note ?? '';
    return `  ${name.padEnd(NAME_WIDTH)}${cells.join('')}  ${note}`.trimEnd();
  });
  return [head, ...rows].join('\n');
}

function formatSingle(figure: Figure): string {
  const { name, unit, note = '' } = figure;
  return `  ${name.padEnd(NAME_WIDTH)} ${formatValue(figure).padStart(LEAST_WIDTH)} ${unit.padEnd(12)} ${note}`.trimEnd();
}

/** Four decimals of an IoU, two and the sign of an error, else three digits. */
function formatValue({ value, unit, isLeast = false }: Figure): string {
  const bound = isLeast ? '> ' : '';
  if (unit.startsWith('IoU')) return value.toFixed(4);
  if (unit.endsWith('%')) return `${value < 0 ? '−' : '+'}${Math.abs(value).toFixed(2)}`;
  const digits = { maximumSignificantDigits: value < 1000 ? 3 : 4 };
  return bound + value.toLocaleString('en-GB', digits);
}
