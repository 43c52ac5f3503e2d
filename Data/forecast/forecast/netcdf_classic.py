# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes NetCDF files record by record, in the classic format with offsets of 64 bits (CDF-2), with numpy alone.

    file = Writer(path, {"time": None, "lat": 19}, [Variable("t", ("time", "lat"), "f4", {"units": "K"})], {"title": "..."})
    file.write("t", values, record=0)
    file.finish_record(0)

After finish_record(n) the file is whole, with n + 1 records; what was written later is no part of it.
"""
import os
import struct

import numpy as np

DIMENSIONS, VARIABLES, ATTRIBUTES = 10, 11, 12
TYPES = {"i1": 1, "S1": 2, "i2": 3, "i4": 4, "f4": 5, "f8": 6}


class Variable:
    """packing: values are stored as whole numbers of this step."""

    def __init__(self, name, dimensions, kind, attributes=None, packing=None):
        self.name, self.dimensions, self.kind, self.packing = name, tuple(dimensions), kind, packing
        self.attributes = dict(attributes or {})
        if packing:
            self.attributes["scale_factor"] = float(packing)

    def bytes_of(self, values):
        if self.packing:
            limits = np.iinfo(self.kind)
            values = np.clip(np.rint(np.asarray(values, float) / self.packing), limits.min, limits.max)
        return _pad(np.ascontiguousarray(values).astype(">" + self.kind).tobytes())


class Writer:
    def __init__(self, path, dimensions, variables, attributes, keep_records=None):
        """keep_records: go on with the file that is there, behind so many records."""
        self.dimensions, self.variables = dimensions, {v.name: v for v in variables}
        self.record = [n for n, size in dimensions.items() if size is None][0]
        self.places, header_size = {}, len(self._header(attributes, {}))
        self._place(header_size)
        self.file = open(path, "w+b" if keep_records is None else "r+b")
        if keep_records is None:
            self.file.write(self._header(attributes, self.places))
        else:
            self.file.truncate(self.records_begin + keep_records * self.record_size)

    def write(self, name, values, record=0):
        variable = self.variables[name]
        offset = self.places[name] + (record * self.record_size if self._is_record(variable) else 0)
        content = variable.bytes_of(values)
        if len(content) != self._size(variable):
            raise ValueError("%s has %d bytes, not %d" % (name, len(content), self._size(variable)))
        self.file.seek(offset)
        self.file.write(content)

    def finish_record(self, record):
        self.file.flush()
        os.fsync(self.file.fileno())
        self.file.seek(4)
        self.file.write(struct.pack(">i", record + 1))
        self.file.flush()

    def close(self):
        self.file.close()

    def _is_record(self, variable):
        return self.record in variable.dimensions

    def _size(self, variable):
        count = int(np.prod([self.dimensions[d] for d in variable.dimensions if d != self.record], dtype=np.int64))
        size = count * np.dtype(variable.kind).itemsize
        return size + -size % 4

    def _place(self, offset):
        """First the variables without records, then the first record of the others."""
        for is_record in (False, True):
            if is_record:
                self.records_begin = offset
            for variable in self.variables.values():
                if self._is_record(variable) == is_record:
                    self.places[variable.name] = offset
                    offset += self._size(variable)
        self.record_size = offset - self.records_begin

    def _header(self, attributes, places):
        ids = {name: i for i, name in enumerate(self.dimensions)}
        dimensions = [_name(name) + struct.pack(">i", size or 0) for name, size in self.dimensions.items()]
        variables = [_name(v.name) + struct.pack(">i", len(v.dimensions)) + b"".join(struct.pack(">i", ids[d]) for d in v.dimensions) +
                     _attributes(v.attributes) + struct.pack(">iiq", TYPES[v.kind], min(self._size(v), 2**31 - 1), places.get(v.name, 0))
                     for v in self.variables.values()]
        return b"CDF\x02" + struct.pack(">i", 0) + _list(DIMENSIONS, dimensions) + _attributes(attributes) + _list(VARIABLES, variables)


def _pad(content):
    return content + b"\0" * (-len(content) % 4)


def _name(text):
    return struct.pack(">i", len(text.encode())) + _pad(text.encode())


def _list(tag, items):
    return struct.pack(">ii", tag if items else 0, len(items)) + b"".join(items)


def _attributes(attributes):
    items = []
    for name, value in attributes.items():
        if isinstance(value, str):
            kind, count, content = "S1", len(value.encode()), value.encode()
        else:
            values = np.atleast_1d(value)
            kind = "f8" if values.dtype.kind == "f" else "i4"
            count, content = len(values), values.astype(">" + kind).tobytes()
        items.append(_name(name) + struct.pack(">ii", TYPES[kind], count) + _pad(content))
    return _list(ATTRIBUTES, items)
