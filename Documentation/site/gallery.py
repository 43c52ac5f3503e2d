# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery: one page a figure and one a snippet that writes a picture, with the picture, the script to download and how to run it.

Pictures are those of Gallery/, if they have been rendered (figures by `./nephoscope demo`, snippets by render_scripts.py), else the ones that
the project keeps.
"""
import ast
import io
import os
import pathlib
import re
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
IMAGES = TOP / "Documentation/images"
RENDERED = pathlib.Path(os.environ.get("NEPHOSCOPE_GALLERY", TOP / "Gallery"))
sys.path.insert(0, str(TOP / "Testing/Pictures"))
import snippets  # noqa: E402

# Figures whose picture in Documentation/images has not their own name.
KEPT = {"01_clouds_over_globe": ["clouds-over-globe.jpg", "terrain-under-clouds.jpg"], "07_smoothed_clouds": ["smoothed-cloud-surface.jpg"],
        "13_compositing_methods": ["cell-compositing-methods.jpg"]}
TITLES = {"README-1": "Clouds over the globe", "cfd-1": "A knotted vortex and smoke", "flow-volumes-1": "Smoke in the wind", "flow-volumes-4": "Smoke in ParaView",
          "flow-volumes-5": "Smoke that is dragged", "globe-grid-3": "Clouds over terrain", "pyvista-1": "Winds on textured splats",
          "pyvista-2": "Clouds that move with the wind"}  # of snippets
WRITES = re.compile(r"^(?!#).*(?:show\(screenshot=|\.screenshot\(\"|\.save\(\"|SaveScreenshot\()", re.MULTILINE)
WIDTH = 1400  # pixels, of rendered pictures on the site
THUMBNAIL = 480


def figures():
    return sorted((TOP / "Figures").glob("[0-9]*.py"))


def kept_pictures(figure):
    names = KEPT.get(figure.stem) or [figure.stem[3:].replace("_", "-") + suffix for suffix in (".jpg", ".png")]
    return [IMAGES / name for name in names if (IMAGES / name).is_file()]


def pictures(figure):
    """Those of Gallery/ first; the one that has the name of the figure before others."""
    rendered = sorted(RENDERED.glob(figure.stem[:3] + "*.png"), key=lambda path: (path.stem != figure.stem, path.name))
    return rendered or kept_pictures(figure)


def pages_of_pictures():
    """{picture of the documentation: page of the figure that draws it}"""
    return {path.relative_to(TOP).as_posix(): f"gallery/{figure.stem}.md" for figure in figures() for path in kept_pictures(figure)}


def smaller(path, width):
    """A picture as JPEG of at most this width; as it is without Pillow, or where it is small anyway."""
    try:
        from PIL import Image
    except ImportError:
        return path.name, path
    with Image.open(path) as picture:
        if picture.width <= width:
            return path.name, path
        made = io.BytesIO()
        picture.convert("RGB").resize((width, round(picture.height * width / picture.width)), Image.LANCZOS).save(made, "JPEG", quality=88)
    return path.stem + ".jpg", made.getvalue()


class Example:
    """A page of the gallery."""

    def __init__(self, name, title, text, code, command, shown):
        self.name, self.title, self.text, self.code, self.command, self.shown = name, title, text, code, command, shown

    def files(self):
        made, names = {f"gallery/scripts/{self.name}.py": self.code}, []
        for path in self.shown:
            name, data = smaller(path, WIDTH)
            made[f"gallery/pictures/{name}"] = data
            names.append(name)
        name, data = smaller(self.shown[0], THUMBNAIL)
        made[f"gallery/thumbnails/{name}"] = data
        self.thumbnail = f"thumbnails/{name}"
        shown = "\n\n".join(f"![{self.title}](pictures/{name})" for name in names)
        made[f"gallery/{self.name}.md"] = (
            f"# {self.title}\n\n{shown}\n\n```sh\n{self.command}\n```\n\n"
            f"{{download}}`Download {self.name}.py <scripts/{self.name}.py>`\n\n{self.text}\n\n"
            f"```{{literalinclude}} scripts/{self.name}.py\n:language: python\n```\n")
        return made

    def card(self):
        return f"[![{self.title}]({self.thumbnail})]({self.name}.md)\n[{self.title}]({self.name}.md)"


def pages_about(figure):
    """Links to the pages that show a figure, or link to it."""
    names = {f"images/{path.name}" for path in kept_pictures(figure)}
    for page in sorted((TOP / "Documentation").glob("*.md")):
        text = page.read_text(encoding="utf-8")
        if any(name in text for name in names):
            yield f"[{re.search('^# (.*)$', text, re.MULTILINE)[1]}](../Documentation/{page.name})"


def of_figure(figure):
    code = figure.read_text(encoding="utf-8")
    first, _, rest = ast.get_docstring(ast.parse(code)).partition("\n\n")
    title, colon, more = first.partition(": ")
    headline, _, more = " ".join(more.split()).partition(". ")
    name = figure.stem[3:].replace("_", " ").capitalize()
    about = ", ".join(pages_about(figure))
    text = f"{headline[0].upper()}{headline[1:].rstrip('.')}.\n{more}\n\n{rest}" + (f"\n\nMore: {about}." if about else "")
    return Example(figure.stem, f"{title}: {name}", blocks(text), code, f"./nephoscope demo {figure.stem[:2]}", pictures(figure))


def blocks(text):
    """Commands of a docstring, which are set in further, as blocks of the shell."""
    return re.sub(r"((?:^    .*(?:\n|$))+)", lambda match: "\n```sh\n" + re.sub("^    ", "", match[0], flags=re.MULTILINE).rstrip() + "\n```\n",
                  text, flags=re.MULTILINE)


def title_of(name, page, code):
    """The given one, else the title of the page and the heading above the snippet."""
    text = page.read_text(encoding="utf-8")
    headings = re.findall(r"^#+ (.*)$", text[:text.index(code)], re.MULTILINE)
    return TITLES.get(name) or ": ".join(dict.fromkeys([headings[0], headings[-1]])).replace("`", "")


def of_snippets():
    """Snippets that write their picture, each once."""
    seen = set()
    for page in snippets.pages():
        for number, code in enumerate(snippets.BLOCK.findall(page.read_text(encoding="utf-8")), 1):
            name = f"{snippets.name_of(page)}-{number}"
            found = [path for path in (RENDERED / f"{name}.png", TOP / f"Testing/Baselines/{name}.png") if path.is_file()]
            if WRITES.search(code) and found and code not in seen:
                seen.add(code)
                host = "pvpython" if snippets.is_for_paraview(name, code) else "python"
                where = os.path.relpath(page, TOP / "gallery")
                title, code = title_of(name, page, code), "\n".join([*(snippets.snippets()[part] for part in snippets.before(name)), code])
                reads = " It reads `Data/`: run it in the top folder of the project." if '"Data/' in code else ""
                yield Example(name, title, f"From [{page.relative_to(TOP)}]({where}).{reads}", code, f"./nephoscope {host} {name}.py", found[:1])


def grid(examples):
    cards = "\n".join(f":::{{container}} card\n{example.card()}\n:::\n" for example in examples)
    return f"::::{{container}} cards\n{cards}::::\n"


def files():
    """{path on the site: data}"""
    groups = {"Figures": [of_figure(figure) for figure in figures()], "Short scripts": list(of_snippets())}
    made = {}
    text = "# Gallery\n\nEvery picture has the whole script that draws it, and the command that runs it. `./nephoscope demo` renders all figures.\n"
    for title, examples in groups.items():
        for example in examples:
            made.update(example.files())
        text += f"\n## {title}\n\n{grid(examples)}"
    names = [example.name for examples in groups.values() for example in examples]
    made["gallery/index.md"] = text + "\n```{toctree}\n:hidden:\n\n" + "\n".join(names) + "\n```\n"
    return made
