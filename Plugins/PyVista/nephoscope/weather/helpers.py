# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The variables of a dataset that only describe its cells, levels and times, and are not fields."""
from __future__ import annotations

import re

from .horizontal import is_latitude, is_longitude

# Attributes that name such variables (CF, UGRID).
_NAMING = ("bounds", "climatology", "grid_mapping", "face_node_connectivity", "edge_node_connectivity", "face_edge_connectivity", "face_face_connectivity",
           "edge_face_connectivity", "boundary_node_connectivity", "node_coordinates", "face_coordinates", "edge_coordinates")
# Of MPAS, SCRIP, ESMF and the cubed sphere of GEOS.
_USUAL = ("verticesoncell", "edgesoncell", "cellsoncell", "cellsonvertex", "cellsonedge", "edgesonvertex", "edgesonedge", "verticesonedge", "kiteareasonvertex", "weightsonedge", "nedgesoncell",
          "nedgesonedge", "indextocellid", "indextoedgeid", "indextovertexid", "xcell", "ycell", "zcell", "xvertex", "yvertex", "zvertex", "xedge", "yedge", "zedge", "areacell", "areatriangle",
          "dcedge", "dvedge", "angleedge", "lonedge", "latedge", "lonvertex", "latvertex", "grid_corner_lon", "grid_corner_lat", "grid_center_lon", "grid_center_lat", "grid_dims", "nodecoords",
          "elementconn", "numelementconn", "centercoords", "corner_lons", "corner_lats", "contacts", "orientation", "anchor", "gw", "time_bnds", "date_written", "time_written")

_ENDINGS = ("_bnds", "_bounds", "_vertices")


def helpers(dataset) -> set[str]:
    """Their names."""
    found = set()
    for name, variable in dataset.variables.items():
        keys = {**variable.encoding, **variable.attrs}
        found.update(word for key in _NAMING for word in str(keys.get(key, "")).split() if word in dataset.variables)
        if "cf_role" in keys or "start_index" in keys or str(name).lower() in _USUAL or str(name).lower().endswith(_ENDINGS) or is_longitude(str(name), variable) or is_latitude(str(name), variable):
            found.add(str(name))
    for name in [name for name in found if name in dataset.variables and "formula_terms" in dataset[name].attrs]:  # of bounds, whose terms are bounds too
        terms = re.findall(r":\s*(\S+)", str(dataset[name].attrs["formula_terms"]))
        found.update(term for term in terms if term in dataset.variables and dataset[term].dims == dataset[name].dims)
    return found
