# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The setting that draws Volume, mode Projected tetra, with Cell Compositing: the pictures of both differ little, and it can be turned off."""
import os

import numpy as np
from paraview import servermanager
from PluginTesting import check, image, load_plugin, new_view, passed, pvs
from vtkmodules.vtkRenderingVolume import vtkProjectedTetrahedraMapper

OURS, THEIRS = "vtkCellCompositingProjectedTetrahedraMapper", "vtkOpenGLProjectedTetrahedraMapper"


def setting():
    return servermanager.ProxyManager().GetProxy("settings", "NephoscopeSettings").SMProxy


def turn(on):
    servermanager.vtkSMPropertyHelper(setting(), "OverrideVTK").Set(on)
    setting().UpdateVTKObjects()
    check(vtkProjectedTetrahedraMapper().GetClassName() == (OURS if on else THEIRS), f"setting {on}: {vtkProjectedTetrahedraMapper().GetClassName()}")


def picture():
    view = new_view((120, 120))
    tetrahedra = pvs.Tetrahedralize(pvs.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5]))
    display = pvs.Show(tetrahedra, view, "UnstructuredGridRepresentation")
    pvs.ColorBy(display, ("POINTS", "RTData"))
    display.SetRepresentationType("Volume")
    check(display.SelectMapper == "Projected tetra", display.SelectMapper)
    pvs.ResetCamera(view)
    pvs.Render(view)
    drawn = [volume.GetMapper().GetClassName() for volume in view.SMProxy.GetClientSideView().GetRenderer().GetVolumes() if volume.GetVisibility()]
    result = image(view).astype(int)
    pvs.Delete(view)
    return result, drawn


load_plugin()
check(vtkProjectedTetrahedraMapper().GetClassName() == THEIRS, "off by default")
theirs, names = picture()
check(THEIRS in names, names)
turn(1)
ours, names = picture()
check(OURS in names, names)
check(ours.max() > 60, "nothing is drawn")
difference = np.abs(ours - theirs)
check(difference.max() > 0, "VTK's picture")
check(difference.mean() < 2, f"another scene: {difference.mean()}")
turn(0)
_, names = picture()
check(THEIRS in names and OURS not in names, names)
os.environ["NEPHOSCOPE_OVERRIDE_VTK"] = "1"  # precedes the setting
servermanager.vtkSMPropertyHelper(setting(), "OverrideVTK").Set(1)
setting().UpdateVTKObjects()
servermanager.vtkSMPropertyHelper(setting(), "OverrideVTK").Set(0)
setting().UpdateVTKObjects()
check(vtkProjectedTetrahedraMapper().GetClassName() == OURS, "the environment precedes the setting")
passed()
