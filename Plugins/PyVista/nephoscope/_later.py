# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Something to do once another package has been imported, without importing it."""
from __future__ import annotations

import importlib
import sys
from importlib.abc import Loader, MetaPathFinder
from importlib.util import find_spec


def when_imported(package: str, module: str, function: str) -> None:
    """Calls `function` of the module `module` of this package now if `package` has been imported, otherwise as soon as it is."""
    if hasattr(sys.modules.get(package), "__version__"):
        _call(module, function)
    else:
        sys.meta_path.insert(0, _Finder(package, module, function))


def _call(module: str, function: str) -> None:
    getattr(importlib.import_module(module, __package__), function)()


class _Finder(MetaPathFinder):
    def __init__(self, package: str, module: str, function: str) -> None:
        self._package, self._module, self._function = package, module, function

    def find_spec(self, name, path, target=None):
        if name != self._package:
            return None
        sys.meta_path.remove(self)
        spec = find_spec(name)
        if spec is not None and spec.loader is not None:
            spec.loader = _Loader(spec.loader, self._module, self._function)
        return spec


class _Loader(Loader):
    """The package's own loader, and the call after it."""

    def __init__(self, loader, module: str, function: str) -> None:
        self._loader, self._module, self._function = loader, module, function

    def create_module(self, spec):
        return self._loader.create_module(spec)

    def exec_module(self, module) -> None:
        module.__spec__.loader = module.__loader__ = self._loader
        self._loader.exec_module(module)
        _call(self._module, self._function)
