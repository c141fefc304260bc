"""Checks a plan.pdf with pikepdf (qpdf) and pypdf: pdf_check.py plan.pdf plan.json STOREY.

One line a check; exits 1 where one failed.
"""

import json
import sys

import pikepdf
from pypdf import PdfReader

PAPERS = {"A4": (210, 297), "A3": (297, 420), "A2": (420, 594), "A1": (594, 841), "A0": (841, 1189)}
POINTS_PER_MM = 72 / 25.4


def main(path: str, plan_path: str, number: int) -> int:
    with open(plan_path, encoding="utf-8") as file:
        storey = json.load(file)["storeys"][number]
    failed = 0

    def say(name: str, passed: bool, found: str) -> None:
        nonlocal failed
        failed += not passed
        print(f"{'ok  ' if passed else 'FAIL'} {name}: {found}")

    with pikepdf.open(path) as pdf:
        problems = pdf.check_pdf_syntax() if hasattr(pdf, "check_pdf_syntax") else pdf.check()
        say("qpdf", not problems, "; ".join(map(str, problems)) or "no complaint")
        measure = pdf.pages[0].obj["/VP"][0]["/Measure"]
        say("scale", str(measure["/R"]).startswith("1"), str(measure["/R"]))

    reader = PdfReader(path, strict=True)
    page = reader.pages[0]
    size = sorted(round(float(side) / POINTS_PER_MM) for side in (page.mediabox.width, page.mediabox.height))
    papers = [name for name, sides in PAPERS.items() if size == sorted(sides)]
    say("paper", len(papers) == 1, f"{size[0]} × {size[1]} mm {' '.join(papers)}")
    text = page.extract_text()
    missing = [room["name"] for room in storey["rooms"] if room["name"].isascii() and room["name"] not in text]
    say("room names", not missing, f"{len(storey['rooms'])} rooms, missing {missing}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], int(sys.argv[3]) if len(sys.argv) > 3 else 0))
