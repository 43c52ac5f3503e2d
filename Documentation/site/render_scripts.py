# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""render_scripts.py: the pictures of the gallery's short scripts at their own size, in Gallery/; `./nephoscope python Documentation/site/render_scripts.py`."""
import os
import pathlib
import shutil
import sys
import tempfile

import gallery
import render  # of Testing/Pictures, which `gallery` puts on the path


def main():
    failed = 0
    gallery.RENDERED.mkdir(exist_ok=True)
    for example in gallery.of_snippets():
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(gallery.TOP / "Data", pathlib.Path(folder, "Data"))
            _, why = render.run(render.command(example.name), folder)
            if why:
                failed += 1
                print(f"{example.name}: {why}", file=sys.stderr)
                continue
            shutil.copy(pathlib.Path(folder, "pictures", f"{example.name}.png"), gallery.RENDERED / f"{example.name}.png")
            print(f"wrote {gallery.RENDERED / example.name}.png", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
