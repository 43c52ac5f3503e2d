# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Debian's CMake package of VTK, rewritten so that its targets are the libraries of VTK's wheel.

A target whose library the wheel does not have (MPI, Qt, Java, some readers) is dropped with all that mentions it, and so are other
packages: VTK's headers need none of them.
"""
import re

# Their libraries are in the wheel, or they need none, but their sources are not.
NOT_IN_THE_WHEEL = {"VTK::mpi", "VTK::vtkviskores", "VTK::WebPython"}
PREFIX = """# The targets of Debian's package, with the libraries of VTK's wheel.
if (TARGET VTK::CommonCore)
  return ()
endif ()
set(_IMPORT_PREFIX "@SDK@")

"""
# The wheel's libraries have std::string as it was before GCC 5: the headers must agree.
OLD_STRINGS = """set_target_properties(VTK::vtkplatform PROPERTIES
  INTERFACE_COMPILE_DEFINITIONS "_GLIBCXX_USE_CXX11_ABI=0")

"""
FIND_PACKAGES = """find_package(Threads QUIET REQUIRED)
# Python's headers are known; there need be no interpreter of this version.
set(Python3_VERSION_MAJOR @MAJOR@)
set(Python3_VERSION_MINOR @MINOR@)
if (NOT TARGET Python3::Module)
  add_library(Python3::Module INTERFACE IMPORTED)
  set_target_properties(Python3::Module PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "@HEADERS@")
endif ()
"""


class CMakePackage:
    """The package in `folder` of the SDK `sdk`; `file_of(path)` is the file in place of one of Debian's, or None.

    Fewer than `least` targets with such files are an error: the package is then written in another way than this script knows.
    """

    def __init__(self, folder, sdk, file_of, least=150):
        self.folder, self.sdk = folder, sdk
        text = (folder / "VTK-targets.cmake").read_text()
        blocks = re.split(r"^(?=# Create imported target )", text, flags=re.MULTILINE)[1:]
        blocks[-1] = blocks[-1].split("# Load information for each installed configuration", 1)[0]
        self.blocks = {block.split()[4]: block for block in blocks}
        self.files = {target: file_of(path) for target, path in self._paths().items()}
        self.dropped = {target for target, block in self.blocks.items() if self._is_dropped(target, block)}
        if len(self.kept()) < least:
            raise SystemExit(f"{folder / 'VTK-targets.cmake'} is not as expected: {len(self.kept())} targets could be matched.")

    def kept(self):
        return [target for target in self.blocks if target not in self.dropped]

    def rewrite(self, python, headers):
        self._write_targets()
        self._write_properties()
        major, minor = python.split(".")
        (self.folder / "VTK-vtk-module-find-packages.cmake").write_text(
            FIND_PACKAGES.replace("@MAJOR@", major).replace("@MINOR@", minor).replace("@HEADERS@", ";".join(map(str, headers))))
        self._write_config()

    def _paths(self):
        """{target: path of its file below the prefix} in Debian."""
        text = (self.folder / "VTK-targets-none.cmake").read_text()
        return dict(re.findall(r'set_target_properties\((VTK::\S+) PROPERTIES[^)]*?IMPORTED_LOCATION_NONE "\$\{_IMPORT_PREFIX\}/([^"]+)"', text))

    def _is_dropped(self, target, block):
        if target.endswith("-private-kit-links"):
            return True
        needs_file = re.search(r"^add_(library\(\S+ (SHARED|MODULE|STATIC)|executable)", block, re.MULTILINE)
        return target in NOT_IN_THE_WHEEL or (needs_file and not self.files.get(target))

    def _links(self, found):
        def stays(item):
            return item.startswith("VTK::") and item not in self.dropped or item.startswith(("Threads::", "Python3::")) or "Python3::" in item
        return found[1] + ";".join(item for item in found[2].split(";") if stays(item)) + '"'

    def _write_targets(self):
        parts = [PREFIX.replace("@SDK@", str(self.sdk))]
        for target in self.kept():
            parts.append(re.sub(r'(INTERFACE_LINK_LIBRARIES ")([^"]*)"', self._links, self.blocks[target]))
            if target == "VTK::vtkplatform":
                parts.append(OLD_STRINGS)
            file = self.files.get(target)
            if file:
                soname = "" if file.parent.name == "bin" else f' IMPORTED_SONAME "{file.name}"'
                parts.append(f'set_target_properties({target} PROPERTIES IMPORTED_LOCATION "{file}"{soname})\n\n')
        (self.folder / "VTK-targets.cmake").write_text("".join(parts))
        (self.folder / "VTK-targets-none.cmake").unlink()

    def _write_properties(self):
        for name in ("VTK-vtk-module-properties.cmake", "vtkmodules-vtk-python-module-properties.cmake"):
            path = self.folder / name
            path.write_text("".join(filter(None, map(self._property, path.read_text().splitlines(keepends=True)))))

    def _property(self, line):
        """A line that sets a property of a module, without the targets that were dropped; None if nothing is left of it."""
        found = re.match(r'set_property\(TARGET "(VTK::[^"]+)" PROPERTY "([^"]+)" "(.*)"\)$', line)
        if not found:
            return line
        target, name, value = found.groups()
        if target in self.dropped or target not in self.blocks or "private_kit_link" in name:
            return None
        if name.endswith(("depends", "forward_link", "implements")):
            value = ";".join(item for item in value.split(";") if item not in self.dropped)
        return f'set_property(TARGET "{target}" PROPERTY "{name}" "{value}")\n'

    def _write_config(self):
        for path in self.folder.glob("VTK[JP]*-targets*.cmake"):
            path.unlink()
        path = self.folder / "vtk-config.cmake"
        text = path.read_text()
        for pattern, replacement in (
                (r'(_HAS_VISKORES|_HAS_VTKm|_WRAP_JAVA)" "ON"', r'\1" "OFF"'),
                (r'^ *include\("[^"]*/VTKPython-targets\.cmake"\)\n', ""),
                (r'_SMP_BACKENDS" "TBB;', '_SMP_BACKENDS" "'),
                (r'(_AVAILABLE_COMPONENTS" )"([^"]*)"', self._components)):
            text, count = re.subn(pattern, replacement, text, flags=re.MULTILINE)
            if not count:
                raise SystemExit(f"{path} is not as expected: nothing matches {pattern}")
        path.write_text(text)

    def _components(self, found):
        kept = {target.split("::")[1] for target in self.kept()}
        return found[1] + '"' + ";".join(name for name in found[2].split(";") if name in kept) + '"'
