# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The classes, methods, functions and figures that Documentation/paper.md names exist; its links lead somewhere."""
import re
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
PAGE = TOP / "Documentation" / "paper.md"


def header_of(name):
    """With those of its base classes in the project; empty if there is none."""
    text = next((file.read_text(encoding="utf-8") for folder in ("Filters", "Representations") for file in (TOP / folder).rglob(name + ".h")), "")
    base = re.search(rf"class (?:\w+_EXPORT )?{name}\s*:\s*public (\w+)", text)
    return text + (header_of(base[1]) if base else "")


def has_method(header, method):
    """A function, or one that a macro of VTK makes."""
    member = re.sub("^Set", "", method)
    return re.search(rf"\b{method}\(", header) or re.search(rf"vtkSet\w*Macro\({member}\b", header)


def functions():
    package = TOP / "Plugins" / "PyVista" / "nephoscope"
    return {name for file in package.glob("*.py") for name in re.findall(r"^def (\w+)", file.read_text(encoding="utf-8"), re.MULTILINE)}


def problem_of(code, known):
    """What is wrong with a word in code style; None if it is right or names nothing of the project."""
    if found := re.fullmatch(r"(vtk\w+)(?:::(\w+))?", code):
        header = header_of(found[1])
        if not header:
            return "there is no such class"
        return None if not found[2] or has_method(header, found[2]) else "the class has no such method"
    if found := re.fullmatch(r"nephoscope\.(\w+)", code):
        return None if found[1] in known else "there is no such function"
    if found := re.fullmatch(r"\./nephoscope demo (\d+)", code):
        return None if list((TOP / "Figures").glob(f"{found[1]}_*.py")) else "there is no such figure"
    return None


def main():
    text, known = PAGE.read_text(encoding="utf-8"), functions()
    assert problem_of("vtkHaze::SetNothing", known) and problem_of("vtkNothing", known) and problem_of("nephoscope.nothing", known)
    assert problem_of("./nephoscope demo 99", known) and not problem_of("vtkHaze::SetVisibility", known)
    codes = sorted(set(re.findall(r"`([^`]+)`", text)))
    problems = [f"{code}: {why}" for code in codes if (why := problem_of(code, known))]
    problems += [f"{link}: there is no such page" for link in re.findall(r"\]\(([\w.-]+)", text) if not (PAGE.parent / link).is_file()]
    problems += [f"row without a state: {row}" for row in re.findall(r"^\| (?!system|-)[^\n]*\|$", text.split("## Figures")[0], re.MULTILINE)
                 if not re.search(r"\| (as printed|changed|missing|ours) \|", row) and "---" not in row]
    print("\n".join(problems) or f"{len(codes)} names are right")
    return 1 if problems or len(codes) < 40 else 0


if __name__ == "__main__":
    sys.exit(main())
