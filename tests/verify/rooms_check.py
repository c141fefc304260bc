"""Checks rooms.csv and rooms.xlsx of plans against each other, the latter with openpyxl where it is there.

    python tests/verify/rooms_check.py DIR|FILE

One line a check; ends with 1 where one failed.
"""

import csv
import sys
from pathlib import Path

try:
    import openpyxl
except ImportError:
    openpyxl = None

TOLERANCE = 1e-3
# The product of what was rounded, m³.
VOLUME_ERROR = 0.05
# Columns of the sheet by those of the CSV.
COLUMNS = {
    "No.": "number",
    "Storey": "storey",
    "Area (m²)": "areaM2",
    "Perimeter (m)": "perimeterM",
    "Height (m)": "heightM",
    "Volume (m³)": "volumeM3",
    "Doors": "doors",
    "Windows": "windows",
    "Passages": "passages",
    "Confidence": "confidence",
}

failures = 0


def check(name, is_right, words):
    global failures
    failures += not is_right
    print(f"{'ok' if is_right else 'FAILED'}  {name}: {words}")


def near(a, b):
    return abs(float(a) - float(b)) <= TOLERANCE


def check_sheet(name, lines, path):
    values = openpyxl.load_workbook(path, data_only=True)
    formulas = openpyxl.load_workbook(path)
    head, *rows = list(values["Rooms"].iter_rows(values_only=True))
    rooms = rows[: len(lines)]
    wrong = [
        f"{line['name'][:40]} {label}"
        for line, row in zip(lines, rooms)
        for label, key in COLUMNS.items()
        if not near(row[head.index(label)], line[key])
    ]
    # An apostrophe stands in the CSV before what a spreadsheet would reckon.
    named = all(row[head.index("Room")] == line["name"].removeprefix("'") for line, row in zip(lines, rooms))
    check(name, not wrong and named, f"{len(lines)} rooms as in rooms.csv {wrong[:3] or ''}")
    texts = [cell for row in formulas["Rooms"].iter_rows(min_row=2, max_row=len(lines) + 1) for cell in row]
    check(name, all(cell.data_type != "f" for cell in texts), "no room is a formula")
    check_totals(name, lines, values["Totals"])


def check_totals(name, lines, sheet):
    rows = [row for row in sheet.iter_rows(min_row=2, values_only=True)]
    building = next(i for i, row in enumerate(rows) if row[0] == "Building")
    for storey, count, net, internal, external, volume, _ in rows[:building]:
        own = [line for line in lines if int(line["storey"]) == storey]
        area = sum(float(line["areaM2"]) for line in own)
        is_right = count == len(own) and (net is None if not own else near(net, area))
        is_ordered = (net or 0) <= internal + TOLERANCE and internal <= external + TOLERANCE
        words = f"storey {storey}: net {net}, gross internal {internal}, gross external {external} m²"
        check(name, is_right and is_ordered, words)
    for column in range(1, 6):
        told = [row[column] for row in rows[:building] if row[column] is not None]
        if told:
            check(name, near(sum(told), rows[building][column]), f"building: {rows[building][column]}, sum of its storeys")


def main(folders):
    for folder in folders:
        table, book = Path(folder) / "rooms.csv", Path(folder) / "rooms.xlsx"
        with open(table, encoding="utf-8", newline="") as file:
            lines = list(csv.DictReader(file))
        is_right = all(
            abs(float(line["areaM2"]) * float(line["heightM"]) - float(line["volumeM3"])) < VOLUME_ERROR for line in lines
        )
        check(str(table), is_right, f"{len(lines)} rooms, volumes are area times height")
        if not book.exists():
            print(f"skip  {book}: is not there")
        elif openpyxl is None:
            print(f"skip  {book}: openpyxl is not installed")
        else:
            check_sheet(str(book), lines, book)
    sys.exit(1 if failures else 0)


main([path.parent if path.is_file() else path for path in map(Path, sys.argv[1:2])])
