# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers beside the figures' colour bars, on this VTK: its formats are those of C before 9.6, those of Python since."""
import glob
import os
import sys
import unittest

from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor

FIGURES = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "Figures")
sys.path.insert(0, os.path.join(FIGURES, "common"))
import pictures  # noqa: E402


class LabelFormat(unittest.TestCase):
    def test_numbers_are_whole(self):
        of_vtk = vtkScalarBarActor().GetLabelFormat()
        ours = pictures.whole_number_format(of_vtk)
        self.assertEqual(ours[0], of_vtk[0])
        self.assertEqual(ours.format(2999.7) if ours[0] == "{" else ours % 2999.7, "3000")

    def test_figures_leave_the_choice_to_it(self):
        for file in glob.glob(os.path.join(FIGURES, "**", "*.py"), recursive=True):
            with open(file, encoding="utf-8") as source:
                for line in source:
                    self.assertFalse("LabelFormat" in line and '"%' in line, f"{file}: {line}")


if __name__ == "__main__":
    unittest.main()
