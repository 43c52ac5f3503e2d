# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints whether the plugin was loaded when the host started, and the number of MPI processes."""
from paraview import servermanager, simple  # noqa: F401 - simple connects; unconnected, pvbatch's ranks never end
from vtkmodules.vtkParallelCore import vtkMultiProcessController

manager = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
information = manager.GetLocalInformation()
names = [information.GetPluginName(i) for i in range(information.GetNumberOfPlugins()) if information.GetPluginLoaded(i)]
processes = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
if "Nephoscope" in names:
    print(f"Nephoscope loaded, {processes} process{'es' if processes > 1 else ''}")
else:
    print("Nephoscope not loaded; loaded are", names)
