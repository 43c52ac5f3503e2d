# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""To be imported before `paraview.simple`, which makes a docstring for each of its 500 functions, twice, and looks through all definitions for each one: without
them, which no test reads, a start of ParaView's Python takes two thirds of its time."""
from paraview import servermanager

if hasattr(servermanager, "ProxyNamespace"):
    servermanager.ProxyNamespace.getDocumentation = lambda _self, _name: ""
