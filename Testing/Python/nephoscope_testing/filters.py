# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters made in one call."""


def configured(made, source, settings):
    """The filter with its first input (data, an algorithm or None) and its properties, not yet updated."""
    if hasattr(source, "GetOutputPort"):
        made.SetInputConnection(source.GetOutputPort())
    elif source is not None:
        made.SetInputData(source)
    for name, value in settings.items():
        set_value = getattr(made, "Set" + name)
        set_value(*value) if isinstance(value, (tuple, list)) else set_value(value)
    return made


def some_values_given(made):
    """The contour values of a filter after some of them have been set."""
    for i in range(4):
        made.SetValue(i, 5.0)
    made.SetNumberOfContours(1)
    made.SetNumberOfContours(3)
    made.SetValue(5, 2.0)
    return [made.GetValue(i) for i in range(made.GetNumberOfContours())]
