# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reference pages of the VTK classes, from the comments in their headers: one page a class, with its public, documented members."""
import pathlib
import re
import textwrap

TOP = pathlib.Path(__file__).resolve().parents[2]
TOKEN = re.compile(r"(?P<open>///@\{)|(?P<close>///@\})|/\*\*(?P<comment>.*?)\*/|(?P<access>\b(?:public|protected|private):)|"
                   r"(?P<line>//[^\n]*|^\s*#[^\n]*)|(?P<declaration>[^\s;/{#][^;{]*(?:;|\{))", re.DOTALL | re.MULTILINE)
MACRO = re.compile(r"vtk(Set|Get|Boolean)(Clamp|Vector\d|Object|)Macro\((.*)\)", re.DOTALL)


def paths():
    """The headers of the classes that users meet: not those of ParaView, and no internals."""
    found = [*TOP.glob("Filters/*/vtk*.h"), *TOP.glob("Representations/*/vtk*.h")]
    return sorted((path for path in found if not path.stem.endswith("Internals")), key=lambda path: path.stem)


def text_of(comment):
    """Without the asterisks of a comment."""
    return textwrap.dedent(re.sub(r"^[ \t]*\*[ ]?", "", comment.strip("\n "), flags=re.MULTILINE)).strip()


def body_end(text, start):
    """The end of what a brace before `start` opens."""
    depth = 1
    for brace in re.compile(r"[{}]").finditer(text, start):
        depth += 1 if brace[0] == "{" else -1
        if depth == 0:
            return brace.end()
    return len(text)


def signatures(declaration):
    """What a declaration declares, as C++; macros of VTK are expanded."""
    declaration = " ".join(re.sub(r"//[^\n]*", "", declaration).split()).rstrip(";{ ")
    declaration = re.sub(r" VTK_\w+\(\d+\)| override\b|\bVTK_FILEPATH ", "", declaration)
    macro = MACRO.match(declaration)
    if not macro:
        return [re.sub(r"^virtual ", "", declaration)]
    kind, form, (name, *types) = macro[1], macro[2], [part.strip() for part in macro[3].split(",")]
    if kind == "Boolean":
        return [f"void {name}On()", f"void {name}Off()"]
    length = form[6:] if form.startswith("Vector") else ""
    value = types[0] + ("*" if form == "Object" else "")
    if kind == "Get":
        return [f"{value}{'*' if length else ''} Get{name}()"]
    return [f"void Set{name}({value} value{f'[{length}]' if length else ''})"]


def limits(declaration):
    clamp = re.match(r"vtkSetClampMacro\((.*)\)", " ".join(declaration.split()))
    low, high = [part.strip() for part in clamp[1].split(",")][2:] if clamp else (None, None)
    return f"Set{clamp[1].split(',')[0]} limits its value to {low} ... {high}." if clamp and not re.search("[A-Z]{3}", low + high) else ""


class Members:
    """[(comment, signatures)] of the public part of a class."""

    def __init__(self, body):
        self.found = []
        self.public = self.grouped = False
        self.comment = None
        position = 0
        while match := TOKEN.search(body, position):
            position = match.end()
            if match["declaration"]:
                position = self.declare(body, match["declaration"], position)
            else:
                self.read(match)

    def read(self, match):
        if match["open"] or match["close"]:
            self.grouped, self.comment = bool(match["open"]), None
        elif match["comment"]:
            self.comment = text_of(match["comment"])
            self.found.append((self.comment, []))
        elif match["access"]:
            self.public = match["access"] == "public:"

    def declare(self, body, declaration, position):
        has_body = declaration.endswith("{")
        end = body_end(body, position) if has_body else position
        if declaration.startswith("enum"):
            declaration += body[position:end]
        if self.public and self.comment is not None and not declaration.startswith("using"):
            self.add(declaration)
        if not self.grouped:
            self.comment = None
        return end

    def add(self, declaration):
        comment, known = self.found[-1]
        limit = limits(declaration)
        if limit and limit not in comment:
            self.found[-1] = (comment + "\n\n" + limit, known)
        if declaration.startswith("enum"):
            known.append(" ".join(re.sub(r"//[^\n]*", "", declaration).split()).rstrip(";"))
        else:
            known.extend(one for one in signatures(declaration) if one not in known)


def escaped(text):
    return re.sub(r"([\\*`|_])", r"\\\1", text)


def linked(text, names):
    """reStructuredText, with our classes linked."""
    return re.sub(r"\bvtk\w+", lambda match: f":cpp:class:`{match[0]}`" if match[0].replace("\\", "") in names else match[0], escaped(text))


def paragraphs(text, names):
    """A comment as reStructuredText: paragraphs, lists, and what is set in further, word for word."""
    lines, listed = [], False
    for line in text.splitlines():
        if line.startswith("    ") and not listed:
            if not lines or not lines[-1].startswith("    "):
                lines += ["", "::", ""]
            lines.append(line)
            continue
        starts = bool(re.match(r"- |\d+\. ", line))
        if starts != listed and not (listed and line.startswith("  ")) or (lines and lines[-1].startswith("    ")):
            lines.append("")
        listed = starts or (listed and line.startswith("  "))
        lines.append(linked(line if listed else line.strip(), names))
    return "\n".join(lines)


def member(comment, declared, names):
    """A comment, below the methods that it is of; enumerations that it is of are shown word for word."""
    methods = [one for one in declared if not one.startswith("enum")]
    enums = [f".. code-block:: cpp\n\n   {one}\n" for one in declared if one.startswith("enum")]
    text = "\n".join([*enums, paragraphs(comment, names), ""])
    return f".. cpp:function:: {(chr(10) + ' ' * 18).join(methods)}\n\n{textwrap.indent(text, '   ')}" if methods else text


def properties(name, members):
    """Links to all that can be set, by its name, in one line."""
    declared = [one for _, signatures_ in members for one in signatures_]
    found = dict.fromkeys(re.findall(r"\bvoid Set(\w+)\(", "\n".join(declared)))
    chosen = [one for one in found if not any(one.startswith(other + "To") for other in found)]
    return ["**Properties:** " + ", ".join(f":cpp:func:`{one} <{name}::Set{one}>`" for one in chosen) + ".", ""] if chosen else []


def inherited(base, names):
    """Where the methods of the base class are."""
    return f"It also has the methods of :cpp:class:`{base}`." if base in names else f"Methods of {base} are in VTK's own documentation."


def page(path, names):
    text = re.sub(r"^#ifndef __VTK_WRAP__.*?^#endif", "", path.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    name, folder = path.stem, path.parent.relative_to(TOP).as_posix()
    brief = re.search(r"@brief (.*?)\n \*\n(.*?)\*/", text, re.DOTALL)
    head = re.search(r"^class \w+ " + name + r"(?:\s+final)?\s*:\s*public (\w+)\s*\{", text, re.MULTILINE)
    can_be_made = f"static {name}* New()" in text  # not so the base classes of mappers
    members = [entry for entry in Members(text[head.end():body_end(text, head.end())]).found if entry[1]]
    summary = escaped(text_of(brief[1]).replace("\n", " "))
    summary = summary[0].upper() + summary[1:]
    return summary, "\n".join([
        name, "=" * len(name), "", f".. cpp:class:: {name} : public {head[1]}", "", f"   {summary}", "",
        f"Header ``{folder}/{path.name}``; in Python ``nephoscope.{name}{'()' * can_be_made}``, with the methods below under the same names. "
        f"{inherited(head[1], names)} How it works: :doc:`/{folder}/README`.", "",
        paragraphs(text_of(brief[2]), names), "", *properties(name, members), "Methods", "-------", "",
        f".. cpp:namespace:: {name}", "", *[member(comment, declared, names) for comment, declared in members]])


def files():
    """{path on the site: text}"""
    names = {path.stem for path in paths()}
    made, rows = {}, []
    for path in paths():
        summary, text = page(path, names)
        made[f"api/vtk/{path.stem}.rst"] = text
        rows.append(f":doc:`{path.stem} <vtk/{path.stem}>`\n   {summary}\n")
    made["api/vtk.rst"] = "\n".join([
        "VTK classes", "===========", "",
        "For C++ and, under the same names, for Python: ``import nephoscope`` gives every class.", "",
        *rows,
        ".. toctree::", "   :hidden:", "", *[f"   vtk/{path.stem}" for path in paths()], ""])
    return made
