# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""ShallowCopy() of a mapper takes over every setting that has a getter and a setter, and changes of the copy stay there."""
import unittest

import nephoscope
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkRenderingCore import vtkVolumeProperty

MAPPERS = (nephoscope.vtkCellCompositingMapper, nephoscope.vtkTexturedSplatMapper, nephoscope.vtkCloudTextureMapper)


def settings(kind):
    """Names X of SetX(value) and GetX() of this class, and of its base class where that is one of the suite."""
    inherited = set(dir(next(one for one in kind.__mro__ if one.__name__ not in dir(nephoscope))))
    return [name[3:] for name in dir(kind) if name.startswith("Set") and "Get" + name[3:] in dir(kind) and name not in inherited]


OTHERS = {"ImageSampleDistance": 2.5}  # where half of the default is not allowed


def other(value):
    """A value of the same type that is allowed for every setting."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, int):
        return value - 1 if value > 0 else value + 1
    if isinstance(value, float):
        return 0.5 * value if value else 0.375
    if isinstance(value, tuple):
        return tuple(0.25 * (i + 1) for i in range(len(value)))
    if isinstance(value, str):
        return value + "x"
    return None


def read(mapper):
    found = {}
    for name in settings(type(mapper)):
        try:
            value = getattr(mapper, "Get" + name)()
        except TypeError:
            continue  # numbered
        if other(value) is not None:
            found[name] = value
    return found


class Copies(unittest.TestCase):
    def test_every_setting(self):
        for kind in MAPPERS:
            mapper, copy = kind(), kind()
            defaults = read(mapper)
            self.assertGreater(len(defaults), 7)
            for name, value in defaults.items():
                getattr(mapper, "Set" + name)(OTHERS.get(name, other(value)))
            changed = read(mapper)
            for name, value in defaults.items():
                with self.subTest(kind.__name__, setting=name):
                    self.assertNotEqual(changed[name], value, "the test has not changed it")
            time = copy.GetMTime()
            copy.ShallowCopy(mapper)
            self.assertEqual(read(copy), changed)
            self.assertGreater(copy.GetMTime(), time)
            for name, value in defaults.items():
                getattr(copy, "Set" + name)(value)
            self.assertEqual((read(copy), read(mapper)), (defaults, changed))

    def test_input_scalars_and_planes(self):
        data = vtkImageData()
        for kind in MAPPERS[:2]:
            mapper, copy, plane = kind(), kind(), vtkPlane()
            mapper.SetInputData(data)
            mapper.SetScalarModeToUseCellFieldData()
            mapper.SelectScalarArray("q")
            mapper.AddClippingPlane(plane)
            copy.SelectScalarArray(3)
            copy.ShallowCopy(mapper)
            self.assertIs(copy.GetInputDataObject(0, 0), data)
            self.assertEqual((copy.GetScalarMode(), copy.GetArrayAccessMode(), copy.GetArrayName()),
                             (mapper.GetScalarMode(), mapper.GetArrayAccessMode(), "q"))
            self.assertIs(copy.GetClippingPlanes().GetItem(0), plane)
            copy.AddClippingPlane(vtkPlane())
            copy.SetInputData(vtkImageData())
            self.assertEqual((mapper.GetClippingPlanes().GetNumberOfItems(), copy.GetClippingPlanes().GetNumberOfItems()), (1, 2))
            self.assertIs(mapper.GetInputDataObject(0, 0), data)
            mapper.SelectScalarArray(2)
            copy.ShallowCopy(mapper)
            self.assertEqual((copy.GetArrayAccessMode(), copy.GetArrayId()), (mapper.GetArrayAccessMode(), 2))
            copy.ShallowCopy(copy)
            copy.ShallowCopy(kind())
            self.assertIsNone(copy.GetInputDataObject(0, 0))

    def test_contours_and_layers(self):
        mapper, copy, layer = MAPPERS[0](), MAPPERS[0](), vtkVolumeProperty()
        mapper.GenerateContourValues(3, 1, 5)
        mapper.SetContourOpacity(1, 0.75)
        mapper.SetContourColor(2, 0.25, 0.5, 1)
        mapper.SetLayerProperty(-4, layer)
        copy.ShallowCopy(mapper)
        rgb = [0.0] * 3
        copy.GetContourColor(2, rgb)
        self.assertEqual(([copy.GetContourValue(i) for i in range(3)], copy.GetContourOpacity(1), rgb), ([1, 3, 5], 0.75, [0.25, 0.5, 1]))
        self.assertEqual((copy.GetNumberOfLayerProperties(), copy.GetLayerWithProperty(0)), (1, -4))
        self.assertIs(copy.GetLayerProperty(-4), layer)
        copy.SetContourValue(0, 9)
        copy.RemoveAllLayerProperties()
        self.assertEqual((mapper.GetContourValue(0), mapper.GetNumberOfLayerProperties()), (1, 1))

    def test_colours_of_vectors(self):
        mapper, copy, table = MAPPERS[1](), MAPPERS[1](), vtkLookupTable()
        mapper.SetVectorColorFunction(table)
        copy.ShallowCopy(mapper)
        self.assertIs(copy.GetVectorColorFunction(), table)


if __name__ == "__main__":
    unittest.main()
