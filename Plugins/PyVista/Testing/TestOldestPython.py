# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package can be imported by the oldest Python that it allows: syntax, names of `typing`, annotations that are evaluated, arguments of the standard library."""
import ast
import re
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[3]
PACKAGE = TOP / "Plugins/PyVista/nephoscope"
OLDEST = (3, 9)
TYPING = set("""AbstractSet Annotated Any AnyStr AsyncContextManager AsyncGenerator AsyncIterable AsyncIterator Awaitable BinaryIO ByteString Callable
    ChainMap ClassVar Collection Container ContextManager Coroutine Counter DefaultDict Deque Dict Final ForwardRef FrozenSet Generator Generic Hashable
    IO ItemsView Iterable Iterator KeysView List Literal Mapping MappingView Match MutableMapping MutableSequence MutableSet NamedTuple NewType NoReturn
    Optional OrderedDict Pattern Protocol Reversible Sequence Set Sized SupportsAbs SupportsBytes SupportsComplex SupportsFloat SupportsIndex SupportsInt
    SupportsRound TYPE_CHECKING Text TextIO Tuple Type TypeVar TypedDict Union ValuesView cast final get_args get_origin get_type_hints no_type_check
    no_type_check_decorator overload runtime_checkable""".split())  # typing.__all__ of Python 3.9
NEWER_ARGUMENTS = {"zip": {"strict"}, "dataclass": {"slots", "kw_only", "match_args", "weakref_slot"}}


def name_of(node):
    return node.id if isinstance(node, ast.Name) else node.attr if isinstance(node, ast.Attribute) else ""


class RunTime(ast.NodeVisitor):
    """Collects, as text, what only a newer Python can run; leaves out what is for type checkers alone."""

    def __init__(self, tree):
        self.found = []
        self.evaluated = not any(isinstance(node, ast.ImportFrom) and node.module == "__future__" and any(name.name == "annotations" for name in node.names)
                                 for node in tree.body)
        self.visit(tree)

    def report(self, node, what):
        self.found.append(f"line {node.lineno}: {what}")

    def visit_If(self, node):
        for part in node.orelse if name_of(node.test).lstrip("_") == "TYPE_CHECKING" else [node.test, *node.body, *node.orelse]:
            self.visit(part)

    def visit_ImportFrom(self, node):
        if node.module == "typing":
            for name in node.names:
                if name.name not in TYPING:
                    self.report(node, f"typing.{name.name}")

    def visit_Attribute(self, node):
        if name_of(node.value) == "typing" and node.attr not in TYPING:
            self.report(node, f"typing.{node.attr}")
        self.generic_visit(node)

    def visit_Call(self, node):
        for keyword in node.keywords:
            if keyword.arg in NEWER_ARGUMENTS.get(name_of(node.func), ()):
                self.report(node, f"{name_of(node.func)}({keyword.arg}=)")
        if name_of(node.func) in ("isinstance", "issubclass") and len(node.args) == 2:
            self.no_union(node.args[1])
        self.generic_visit(node)

    def annotation(self, node):
        if node is not None and self.evaluated:
            self.no_union(node)
            self.visit(node)

    def no_union(self, node):
        if any(isinstance(part, ast.BinOp) and isinstance(part.op, ast.BitOr) for part in ast.walk(node)):
            self.report(node, "a union by | that is evaluated")

    def visit_arg(self, node):
        self.annotation(node.annotation)

    def visit_AnnAssign(self, node):
        self.annotation(node.annotation)
        for part in (node.target, node.value):
            if part is not None:
                self.visit(part)

    def visit_FunctionDef(self, node):
        self.annotation(node.returns)
        for part in (*node.decorator_list, node.args, *node.body):
            self.visit(part)

    visit_AsyncFunctionDef = visit_FunctionDef


def newer(source):
    try:
        return RunTime(ast.parse(source, feature_version=OLDEST)).found
    except SyntaxError as error:
        return [str(error)]


class OldestPython(unittest.TestCase):
    def test_stated(self):
        stated = re.search(r'nephoscope_requirements "Requires-Python: >=(\d+)\.(\d+)"', (TOP / "CMake/NephoscopePython.cmake").read_text())
        self.assertEqual(tuple(map(int, stated.groups())), OLDEST)

    def test_package(self):
        files = [*PACKAGE.rglob("*.py"), *PACKAGE.parent.glob("packaging/*.py"), *(TOP / "Plugins/ParaView").rglob("*.py")]
        self.assertGreater(len(files), 60)
        for file in files:
            with self.subTest(file=str(file.relative_to(TOP))):
                self.assertEqual(newer(file.read_text()), [])

    def test_finds(self):
        future = "from __future__ import annotations\n"
        for source in ("from typing import Unpack", future + "from typing import ParamSpec", "import typing\nx = typing.Self", "def f(a: int | None): pass",
                       "def f() -> int | None: pass", "a: int | None = 1", future + "isinstance(1, int | str)", "zip(a, b, strict=True)",
                       "@dataclass(slots=True)\nclass A: pass", "match a:\n    case 1: pass", "if not TYPE_CHECKING:\n    from typing import Self",
                       "if TYPE_CHECKING:\n    pass\nelse:\n    from typing import Self", "try:\n    pass\nexcept* ValueError:\n    pass"):
            with self.subTest(source=source):
                self.assertTrue(newer(source))
        for source in ("from typing import Any", "if TYPE_CHECKING:\n    from typing import Unpack", future + "def f(a: int | None) -> int | str: b: int | None = 1",
                       "a | b", "zip(a, b)"):
            with self.subTest(source=source):
                self.assertEqual(newer(source), [])


if __name__ == "__main__":
    unittest.main()
