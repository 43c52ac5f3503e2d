# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""TestInstallation.py CMAKE BUILD: the installed package and the wheel work away from the build tree."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CMAKE, BUILD = sys.argv[1], Path(sys.argv[2])
PLUGIN = Path(__file__).resolve().parents[1]
CHECK = """
import nephoscope
assert len(nephoscope.__all__) >= 2, nephoscope.__all__
classes = [getattr(nephoscope, name) for name in nephoscope.__all__ if name.startswith('vtk')]
bases = {base for cls in classes for base in cls.__mro__[1:]}  # some are abstract
objects = [cls() for cls in classes if cls not in bases]
mapped = {line.split()[-1] for line in open('/proc/self/maps') if 'ephoscope' in line and '/preload/' not in line}
samples = [nephoscope.sample_data(name) for name in ('gfs_2p5deg_2011101100.nc', 'forecast_10deg_6h.nc', 'blue_marble_2048.jpg')]
print(nephoscope.__file__, *mapped, *samples)
"""


class Installation(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_clean(self, *command, **environment):
        kept = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "NEPHOSCOPE", "PIP_"))}
        result = subprocess.run(list(map(str, command)), capture_output=True, text=True, env={**kept, **environment},
                                cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def check_import(self, interpreter, **environment):
        for path in self.run_clean(interpreter, "-c", CHECK, **environment).split():
            self.assertTrue(Path(path).is_relative_to(self.folder), f"{path} is not below {self.folder}")
            self.assertTrue(Path(path).is_file(), path)

    def test_install_tree(self):
        self.run_clean(CMAKE, "--install", BUILD, "--prefix", self.folder / "prefix")
        package = next(self.folder.rglob("nephoscope/__init__.py")).parents[1]
        self.check_import(sys.executable, PYTHONPATH=str(package))

    def test_wheel_in_a_fresh_environment(self):
        self.run_clean(sys.executable, PLUGIN / "packaging" / "nephoscope_wheel.py", "--build", BUILD, "--output", self.folder)
        self.run_clean(sys.executable, "-m", "venv", "--system-site-packages", self.folder / "venv")
        interpreter = self.folder / "venv" / "bin" / "python"
        log = self.run_clean(interpreter, "-m", "pip", "--disable-pip-version-check", "install", "--no-index",
                             *self.folder.glob("*.whl"))
        self.assertIn("Successfully installed nephoscope", log)
        self.check_import(interpreter)
        self.run_clean(interpreter, "-m", "pip", "uninstall", "-y", "nephoscope")
        self.assertFalse(list((self.folder / "venv").rglob("*ephoscope*.so")))

    def test_pip_is_told_what_is_wrong(self):
        result = subprocess.run([sys.executable, PLUGIN / "packaging" / "nephoscope_wheel.py", "--build", self.folder],
                                capture_output=True, text=True, cwd=self.folder)
        self.assertIn("is not a configured build tree", result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
