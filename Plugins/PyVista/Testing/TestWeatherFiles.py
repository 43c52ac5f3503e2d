# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that are no weather data that can be read: each is named for what it is, with a remedy. Files that can are found whatever their names are."""
import gzip
import io
import itertools
import struct
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import nephoscope
from nephoscope.weather.foreign import format_of
import numpy as np
import pyvista
from PIL import Image
from weather_data import isothermal

LON, LAT = np.arange(0, 40, 5.0), np.arange(20, 60, 5.0)


def saved(save, *args, **options):
    stream = io.BytesIO()
    save(stream, *args, **options)
    return stream.getvalue()


def pp_file():
    header = struct.pack(">45i19f", *([0] * 45), *([0.0] * 19))
    return struct.pack(">i", 256) + header + struct.pack(">i", 256) + struct.pack(">i", 16) + bytes(16) + struct.pack(">i", 16)


def archive(*names):
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as file:
        for name in names:
            file.writestr(name, "x")
    return stream.getvalue()


FOREIGN = {  # name: content, words of the message
    "umglaa.pp": (pp_file(), "PP file of the Met Office.*scitools-iris.*iris.save"),
    "qrparm.orog": (struct.pack(">2q", 20, 1) + bytes(2000), "fields file of the Unified Model.*iris.load"),
    "height.tif": (saved(Image.new("F", (4, 4)).save, "TIFF"), "GeoTIFF.*rioxarray.*engine='rasterio'"),
    "MOD06_L2.hdf": (b"\x0e\x03\x13\x01" + bytes(60), "HDF4.*h4tonccf"),
    "temp.bufr": (b"****\n0001\r\nBUFR" + bytes(50), "BUFR.*observations.*pdbufr"),
    "stations.csv": (b"lat,lon,t\n47.1,10.2,281.5\n", r"text file.*pandas.read_csv\(path\).*to_xarray"),
    "notes": (b"Station 11; +3 \xb0C\n", "text file"),
    "model.ctl": (b"dset ^model.dat\nundef -9.99e8\nxdef 144 linear 0 2.5\n", "GrADS.*cdo -f nc import_binary"),
    "model.cdl": (b"netcdf model {\ndimensions:\n", "CDL.*ncgen"),
    "refs.json": (b'{"version": 1, "refs": {}}', "kerchunk"),
    "era5.nc": (b"\n<!DOCTYPE html>\n<html><title>Log in</title></html>", "web page.*download has failed"),
    "gfs.grib2.gz": (gzip.compress(b"GRIB"), "compressed by gzip.*gunzip gfs.grib2.gz"),
    "gfs.bz2": (b"BZh91AY&SY", "compressed by bzip2"),
    "cds.zip": (archive("data_0.nc", "data_1.nc", "a", "b"), r"archive of data_0.nc, data_1.nc, a, \.\.\..*unzip cds.zip"),
    "broken.zip": (b"PK nothing", "damaged"),
    "KTLX20130520": (b"AR2V0006.", "NEXRAD.*xradar"),
    "field.npy": (saved(np.save, np.ones(3)), "array of numpy"),
    "table.parquet": (b"PAR1" + bytes(8), "Parquet.*read_parquet"),
    "case.foam": (b"", r"mesh.*pyvista.read\(.*add_cells"),
    "README.md": (b"# About\n\nIt reads GRIB and NetCDF. GRIB\n", "neither GRIB nor NetCDF, but a text file"),
    "GRIB.txt": (b"GRIB files are good\n", "neither GRIB nor NetCDF, but a text file"),
    "unknown.bin": (bytes(range(1, 30)), "neither GRIB nor NetCDF: it begins with"),
    "damaged.nc": (b"nothing of the kind", "neither GRIB nor NetCDF"),
    "empty": (b"", "the file is empty"),
}


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_foreign_files(self):
        for name, (content, words) in FOREIGN.items():
            with self.subTest(name):
                self.folder.joinpath(name).write_bytes(content)
                with self.assertRaisesRegex(ValueError, rf"(?s){name}.*{words}"):
                    nephoscope.open(self.folder / name)

    def test_headers_of_bulletins(self):
        for start in (b"GRIB\0\0\0\1", b"GRIB\0\0\0\2", b"\1\r\r\n001\r\r\nHTPA50 ECMF 111200\r\r\nGRIB\0\1\2\1", b"GRIB\xff\xff\xff\x07"):
            self.assertEqual(format_of(start + bytes(99)), "GRIB")
        for start in (b"It reads GRIB and more", b"GRIB", b"\x89PNG GRIB\0\0\0\4"):
            self.assertEqual(format_of(start), "")

    def test_meshes(self):
        pyvista.ImageData(dimensions=(2, 2, 2)).save(self.folder / "a.vti")
        pyvista.Sphere().save(self.folder / "b.vtk")
        self.folder.joinpath("b.vtk").rename(self.folder / "noname")
        for name in ("a.vti", "noname"):
            with self.assertRaisesRegex(ValueError, "is a mesh. Read it by pyvista.read"):
                nephoscope.open(self.folder / name)

    def test_folders(self):
        isothermal(LON, LAT).to_zarr(self.folder / "store.zarr")
        name = next(path.name for path in (self.folder / "store.zarr").iterdir() if path.is_dir())
        with self.assertRaisesRegex(ValueError, f"{name} is one array of a Zarr store. Name the store, .*store.zarr"):
            nephoscope.open(self.folder / "store.zarr" / name)
        self.folder.joinpath("third").mkdir()
        self.folder.joinpath("third", "zarr.json").write_text('{"zarr_format": 3, "node_type": "array"}')
        with self.assertRaisesRegex(ValueError, "third is one array of a Zarr store"):
            nephoscope.open(self.folder / "third")
        self.folder.joinpath("case", "system").mkdir(parents=True)
        self.folder.joinpath("case", "system", "controlDict").write_text("")
        with self.assertRaisesRegex(ValueError, "case of OpenFOAM.*OpenFOAMReader"):
            nephoscope.open(self.folder / "case")

    def test_names_do_not_matter(self):
        dataset = isothermal(LON, LAT)
        dataset.to_netcdf(self.folder / "a.nc")
        for name in ("wrfout_d01_2020-01-01_00:00:00", "a.nc4", "a.h5", "a.cdf", "a.dat", "noname"):
            self.folder.joinpath(name).write_bytes(self.folder.joinpath("a.nc").read_bytes())
            with nephoscope.open(self.folder / name) as opened:
                self.assertEqual(set(opened.data_vars), set(dataset.data_vars))

    def test_both_readers_in_one_process(self):
        """The process ends well, though VTK's NetCDF and the packages that xarray imports bring several versions of the same libraries."""
        isothermal(LON, LAT).to_netcdf(self.folder / "a.nc")
        for first, second in itertools.permutations(("nephoscope.open(path)", "nephoscope.read_cf(path)")):
            with self.subTest(first):
                code = f"import nephoscope; path = {str(self.folder / 'a.nc')!r}; kept = {first}, {second}"
                done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
