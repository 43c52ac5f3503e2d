# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What holds for every file of the project: licence lines, no path of one machine, documents that agree with the code."""
import ast
import pathlib
import re
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
SOURCE_SUFFIXES = {".cxx", ".h", ".py", ".cmake", ".sh", ".glsl", ".xml"}
SOURCE_NAMES = {"CMakeLists.txt", "nephoscope", "run", "vtk.module", "paraview.plugin"}
DOCUMENTS = ("README.md", "LICENSE", "CONTRIBUTING.md", "CHANGELOG.md", "CITATION.cff",
             "Documentation/architecture.md", "Documentation/references.bib")
# Folders in which the files of one person or machine live. Written in pieces: this file is read as well.
MACHINE_PATHS = re.compile("|".join((r"(?<![\w.])/" + folder + "/") for folder in ("work", "tmp", "root", "home")))


def listed_by_git():
    """What git has of the project; None where there is no git, or TOP is not the top of a checkout but an unpacked archive."""
    try:
        top = subprocess.run(["git", "-C", TOP, "rev-parse", "--show-toplevel"], capture_output=True, text=True)
        if top.returncode != 0 or pathlib.Path(top.stdout.rstrip("\n")).resolve() != TOP:
            return None
        listed = subprocess.run(["git", "-C", TOP, "ls-files", "-z"], capture_output=True, text=True, check=True)
    except FileNotFoundError:
        return None
    return [TOP / name for name in listed.stdout.split("\0") if name]


def tracked_files():
    """The files of the project that are there; without git, all but what the build and Python made."""
    files = listed_by_git()
    if files is None:
        made = {"build", "dist", "Gallery", ".git"}
        found = (f for top in TOP.iterdir() if top.name not in made for f in ([top] if top.is_file() else top.rglob("*")))
        files = [f for f in found if f.parent.name != "__pycache__"]
    return [f for f in files if f.is_file()]


def text_of(path):
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return None


def check_licence_lines(files):
    for path in files:
        if path.suffix in SOURCE_SUFFIXES or path.name in SOURCE_NAMES:
            head = "\n".join(text_of(path).splitlines()[:6])
            for line in ("SPDX-FileCopyrightText: The Nephoscope authors", "SPDX-License-Identifier: BSD-3-Clause"):
                if line not in head:
                    yield f"{path.relative_to(TOP)}: no line '{line}' among the first six"


def check_machine_paths(files):
    for path in files:
        for number, line in enumerate((text_of(path) or "").splitlines(), 1):
            if MACHINE_PATHS.search(line):
                yield f"{path.relative_to(TOP)}:{number}: a path of one machine: {line.strip()}"


def check_documents(files):
    names = {str(f.relative_to(TOP)) for f in files}
    for name in DOCUMENTS:
        if name not in names:
            yield f"{name} is missing"


def check_verbs(_files):
    """Every `./nephoscope VERB` of a document is a verb of the script, and the README shows demo and test."""
    usage = subprocess.run([TOP / "nephoscope", "help"], capture_output=True, text=True, check=True).stdout
    verbs = set(re.findall(r"^  ([a-z]+) ", usage, re.MULTILINE))
    for name in ("README.md", "CONTRIBUTING.md"):
        for verb in re.findall(r"\./nephoscope (?:--preset \S+ |--no-install |--root \S+ )*([a-z]+)", text_of(TOP / name)):
            if verb not in verbs:
                yield f"{name}: ./nephoscope has no verb {verb}"
    commands = re.findall(r"^\./nephoscope .*$", text_of(TOP / "README.md"), re.MULTILINE)
    if [c.split()[1] for c in commands[:2]] != ["demo", "test"]:
        yield f"README.md: the first two commands should be demo and test, not {commands[:2]}"


def check_installed(_files):
    """A page that names a command of ./nephoscope which an installed Nephoscope has in another form also has that form, or links to the page that translates. Scripts of the sources need none."""
    command = re.compile(r"\./nephoscope (?:python|pvpython|pvbatch|pvserver|paraview|viewer)\b(?! (?:-n \d )?(?:Figures|Testing|Documentation)/)")
    for path in (TOP / "README.md", *sorted((TOP / "Documentation").glob("*.md"))):
        found = command.search(text_of(path))
        if found and path.name != "commands.md" and "commands.md" not in text_of(path):
            yield f"{path.relative_to(TOP)}: {found.group()} without a link to commands.md"


def check_references(files):
    """Every key of the form NameYear in a source is in references.bib, once; its braces are in pairs."""
    references = text_of(TOP / "Documentation/references.bib")
    keys = re.findall(r"^@\w+\{(\w+),", references, re.MULTILINE)
    known = set(keys)
    for repeated in sorted(known):
        if keys.count(repeated) > 1:
            yield f"Documentation/references.bib: {repeated} is there {keys.count(repeated)} times"
    if references.count("{") != references.count("}"):
        yield "Documentation/references.bib: braces are not in pairs"
    key = re.compile(r"\b((?:[A-Z][a-z]+){1,4}(?:19|20)\d\d)\b")
    for path in files:
        if path.suffix in (".cxx", ".h", ".glsl", ".md"):
            for found in sorted(set(key.findall(text_of(path))) - known):
                yield f"{path.relative_to(TOP)}: {found} is not in Documentation/references.bib"


def check_test_targets(files):
    """C++ tests are made and linked by the functions of CMake/NephoscopeTesting.cmake alone: the build of a wheel has none of their targets."""
    for path in files:
        if path.name == "CMakeLists.txt" and "Testing" in path.parts:
            for found in re.findall(r"^\s*target_\w+\((Test\w+)", text_of(path), re.MULTILINE):
                yield f"{path.relative_to(TOP)}: changes the target {found}, which the build of a wheel does not have"


def check_changelog(_files):
    """CHANGELOG.md has the form of Keep a Changelog: what is unreleased first, each kind of change once a version."""
    versions = re.split(r"^## ", text_of(TOP / "CHANGELOG.md"), flags=re.MULTILINE)[1:]
    kinds = ["Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"]
    for number, version in enumerate(versions):
        title, *rest = version.splitlines()
        form = (r"\[Unreleased\]|" if number == 0 else "") + r"\[\d+\.\d+\.\d+\] - \d{4}-\d\d-\d\d"
        if not re.fullmatch(form, title):
            yield f"CHANGELOG.md: the heading '{title}' should have the form {form}"
        found = [line[4:] for line in rest if line.startswith("### ")]
        if found != [kind for kind in kinds if kind in found]:
            yield f"CHANGELOG.md: {title}: the kinds of changes should be {kinds}, in this order, not {found}"


def check_sentences(files):
    """No sentence begins with "Of": it says what it is about too late."""
    begins = re.compile(r'''(^\s*(//|/\*\*|\*|\#|- |"""|<!--|<Documentation>)?|[^.\s][.:;])\s+Of [a-z]|"""Of [a-z]''')
    for path in files:
        if path.suffix in SOURCE_SUFFIXES | {".md", ".in"} or path.name in SOURCE_NAMES:
            for number, line in enumerate(text_of(path).splitlines(), 1):
                if begins.search(line):
                    yield f"{path.relative_to(TOP)}:{number}: a sentence begins with 'Of': {line.strip()[:80]}"


def module_of(path):
    """The folder of the nearest vtk.module above a file, from TOP; None for what is in no module, and for tests."""
    relative = path.relative_to(TOP)
    if "Testing" in relative.parts:
        return None
    return next((str(folder.relative_to(TOP)) for folder in path.parents if (folder / "vtk.module").exists()), None)


def declared_modules(folder):
    """The name of the module in a folder, and the names below DEPENDS and PRIVATE_DEPENDS."""
    name, used, section = "", set(), ""
    for line in text_of(TOP / folder / "vtk.module").splitlines():
        if not line.startswith((" ", "#")):
            section = line.strip()
        elif section == "NAME":
            name = line.strip()
        elif section in ("DEPENDS", "PRIVATE_DEPENDS"):
            used.add(line.strip())
    return name, used


def check_flat_folders(files):
    """No folder of a module has more than 40 sources: a reader finds them by the folders of its parts."""
    counts = {}
    for path in files:
        if path.suffix in (".h", ".cxx") and module_of(path):
            counts[path.parent] = counts.get(path.parent, 0) + 1
    for folder, count in sorted(counts.items()):
        if count > 40:
            yield f"{folder.relative_to(TOP)}: {count} sources; divide them among folders for the parts of the module"


def includes_of(files):
    """(file, header) for each header of the project that a file of a module includes."""
    headers = {f.name: f for f in files if f.suffix == ".h"}
    for path in files:
        if path.suffix in (".h", ".cxx") and module_of(path):
            for name in re.findall(r'^\s*#\s*include "([^"]+)"', text_of(path), re.MULTILINE):
                if pathlib.Path(name).name in headers:
                    yield path, headers[pathlib.Path(name).name]


def find_cycle(edges):
    """Names along a cycle of a graph {name: names}; empty if there is none."""
    state = {}

    def visit(name, way):
        state[name] = "open"
        for other in sorted(edges.get(name, ())):
            if state.get(other) == "open":
                return way[way.index(other):] + [other] if other in way else [other, name]
            if other not in state:
                found = visit(other, way + [other])
                if found:
                    return found
        state[name] = "done"
        return []

    for name in sorted(edges):
        found = [] if name in state else visit(name, [name])
        if found:
            return found
    return []


def layer_of(folder):
    """The bottom layer, filters, the bottom of the mappers, mappers, hosts: a module may use those of a lower number, and of its own."""
    if "ParaView" in folder:
        return 4
    return {"Filters/Common": 0, "Representations/Common": 2}.get(folder, 1 if folder.startswith("Filters/") else 3)


def check_layers(files):
    """A module includes headers of modules that its vtk.module declares, of none above it, and in no circle."""
    folders = {module_of(f) for f in files} - {None}
    declared = {folder: declared_modules(folder) for folder in folders}
    used = {folder: set() for folder in folders}
    included = {}
    for path, header in includes_of(files):
        its, other = module_of(path), module_of(header)
        if path.suffix == ".h":
            included.setdefault(path.name, set()).add(header.name)
        if other and other != its:
            used[its].add(other)
            where = f"{path.relative_to(TOP)} includes {header.relative_to(TOP)}"
            if layer_of(other) > layer_of(its):
                yield f"{where}, which is in a layer above it"
            if declared[other][0] not in declared[its][1]:
                yield f"{where}, but {its}/vtk.module does not name {declared[other][0]}"
    for kind, edges in (("modules", used), ("headers", included)):
        cycle = find_cycle(edges)
        if cycle:
            yield f"{kind} that include each other: {' -> '.join(cycle)}"


def check_include_paths(files):
    """No module includes from folders of another by a path: CMake knows them by the modules it depends on."""
    for path in files:
        if path.name == "CMakeLists.txt" and module_of(path):
            for call in re.findall(r"(?:target_include_directories|include_directories|vtk_module_include)\s*\([^)]*\)", text_of(path)):
                if re.search(r"/\.\.|PROJECT_SOURCE_DIR", call):
                    yield f"{path.relative_to(TOP)}: a path to another folder: {' '.join(call.split())}"


def reading_list(readme):
    """The names in the first column of the tables below 'Reading order', in the folder that the head of their table names."""
    folder, names, below = "", [], False
    for line in readme.splitlines():
        if line.startswith("#"):
            below = line == "## Reading order"
        elif below and line.startswith("|"):
            quoted = re.findall(r"`([^`]+)`", line.split("|")[1])
            if len(quoted) == 1 and quoted[0].endswith("/"):
                folder = "" if quoted[0] == "Testing/" else quoted[0]
            elif quoted:
                names += [folder + name for name in quoted]
            elif not set(line) <= set("|-: "):
                folder = ""
    return names


def check_readmes(files):
    """The README of every technique names each of its files once, and none that is not there. `Name` is Name.h and Name.cxx."""
    for module in files:
        technique = module.parent
        if module.name != "vtk.module" or technique.parent.name not in ("Filters", "Representations"):
            continue
        sources = {str(f.relative_to(technique)) for f in files if technique in f.parents and f.suffix in (".h", ".cxx", ".glsl")}
        sources = {name for name in sources if "Testing/" not in name}
        readme = technique / "README.md"
        if readme not in files:
            yield f"{technique.relative_to(TOP)} has no README.md"
            continue
        named = []
        for name in reading_list(text_of(readme)):
            its = {name} if pathlib.Path(name).suffix else {name + ".h", name + ".cxx"} & sources
            if not its <= sources or not its:
                yield f"{readme.relative_to(TOP)}: {name} is not there"
            named += its
        for name in sorted(sources):
            if named.count(name) != 1:
                yield f"{readme.relative_to(TOP)}: {name} is named {named.count(name)} times in the reading order, not once"


def imported_names(tree):
    """{name: line of the import statement}"""
    imports = (node for node in ast.walk(tree) if isinstance(node, ast.Import) or isinstance(node, ast.ImportFrom) and node.module != "__future__")
    return {alias.asname or alias.name.split(".")[0]: node.lineno for node in imports for alias in node.names}


def check_imports(files):
    """Python sources use what they import; "noqa: F401" marks a module that is imported for its effect."""
    for path in files:
        if path.suffix != ".py" or path.name == "__init__.py":
            continue
        text = text_of(path)
        tree = ast.parse(text)
        used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
        used |= {node.value for node in ast.walk(tree) if isinstance(node, ast.Constant)}  # in __all__
        for name, line in imported_names(tree).items():
            if name not in used and "F401" not in text.splitlines()[line - 1]:
                yield f"{path.relative_to(TOP)}:{line}: {name} is imported but not used"


def check_guards(files):
    """Include guards are those of VTK for its classes, and have the project's name for other headers."""
    for path in files:
        if path.suffix == ".h":
            guard = f"{path.stem}_h" if path.stem.startswith("vtk") else f"nephoscope_{path.stem}_h"
            if f"#ifndef {guard}\n#define {guard}\n" not in text_of(path):
                yield f"{path.relative_to(TOP)}: its include guard is not {guard}"


def main():
    files = tracked_files()
    problems = []
    for check in (check_licence_lines, check_machine_paths, check_documents, check_verbs, check_installed, check_references, check_test_targets, check_changelog, check_sentences,
                  check_layers, check_flat_folders, check_include_paths, check_readmes, check_imports, check_guards):
        problems += check(files)
    print("\n".join(problems) or f"{len(files)} files: nothing to complain of")
    return 1 if problems or not files else 0


sys.exit(main())
