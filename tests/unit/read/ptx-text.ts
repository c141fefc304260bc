/** A PTX header: columns, rows, scanner, axes and the matrix's first three columns. */
export function ptxHeader(
  columns: number,
  rows: number,
  matrix: readonly (readonly number[])[] = IDENTITY,
): string {
  const lines = [
    columns,
    rows,
    ...['0 0 0', '1 0 0', '0 1 0', '0 0 1'],
    ...matrix.map((row, i) => `${row.join(' ')} ${i === 3 ? 1 : 0}`),
  ];
  return lines.map((line) => `${line}\r\n`).join('');
}

const IDENTITY = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
  [0, 0, 0],
];
