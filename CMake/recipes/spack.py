# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Not tested. See README.md.
from spack.package import CMakePackage, depends_on, extends, license, variant, version


class Nephoscope(CMakePackage):
    """Filters, OpenGL mappers and ParaView representations for clouds, smoke and wind."""

    license("BSD-3-Clause")
    version("main")

    variant("openvdb", default=True, description="Read and write .vdb files")
    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.16:", type="build")
    depends_on("paraview@5.11: +opengl2 +python +development_files")
    depends_on("openvdb", when="+openvdb")
    extends("python")

    def cmake_args(self):
        return [
            self.define("BUILD_TESTING", False),
            self.define("NEPHOSCOPE_USE_TETGEN", "OFF"),
            self.define("NEPHOSCOPE_USE_OPENVDB", "ON" if self.spec.satisfies("+openvdb") else "OFF"),
            self.define("Python3_EXECUTABLE", self.spec["python"].command.path),
        ]

    def setup_run_environment(self, env):
        env.prepend_path("PV_PLUGIN_PATH", self.prefix.lib.join("nephoscope-plugins/Nephoscope"))
