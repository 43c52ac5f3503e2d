# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `nephoscope-viewer`, also `python -m nephoscope`: a file in the browser. Its help needs neither PyVista nor trame."""
from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Sequence

from .viewer_state import PORT, TECHNIQUES


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command and returns its exit status."""
    given = vars(_parser().parse_args(arguments))
    try:
        import nephoscope
        nephoscope.viewer(_path(given.pop("file")), **given)
    except (ImportError, OSError, TypeError, ValueError, RuntimeError) as error:
        print(f"nephoscope-viewer: {error}", file=sys.stderr)
        return 1
    return 0


def _path(file: str) -> str:
    """The file, or the sample data of that name."""
    from .samples import SAMPLES, sample_data
    return sample_data(file) if file in SAMPLES and not Path(file).exists() else file


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="nephoscope-viewer", description="Shows a file in the browser, with a side bar for choosing what is drawn.")
    parser.add_argument("file", help="NetCDF with CF conventions, any file that PyVista reads, or the name of sample data: gfs_2p5deg_2011101100.nc")
    parser.add_argument("--field", help="array to draw")
    parser.add_argument("--technique", choices=list(TECHNIQUES), help="default: the first that the data allow")
    parser.add_argument("--time", metavar="STEP", help="time step, from 0 (default: 0)")
    parser.add_argument("--exaggeration", metavar="FACTOR", help="exaggeration of heights on a globe, 1 to 100 (default: 10)")
    parser.add_argument("--opacity", metavar="FACTOR", help="0.1 to 5 (default: 1)")
    parser.add_argument("--preset", help="colours and opacities, for example 'wind speed' (default: chosen by the field)")
    parser.add_argument("--no-terrain", dest="terrain", action="store_const", const="0", help="draw a smooth globe instead of the terrain")
    parser.add_argument("--port", type=int, default=PORT, help=f"port of the web server, 0: any free port (default: {PORT})")
    parser.add_argument("--host", default="127.0.0.1", help="address to listen on (default: 127.0.0.1, this machine only)")
    parser.add_argument("--no-browser", dest="open_browser", action="store_false", help="do not open the page in a browser")
    return parser


if __name__ == "__main__":
    sys.exit(main())
