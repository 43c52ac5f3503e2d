# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""refresh.py FOLDER [--yes] [NAME...]: makes the pictures of the documentation and of the mappers anew and, after showing them, stores those that have changed.

For every one that has: FOLDER/NAME.png with old, new and five times their difference side by side. Asks before it writes, unless --yes is given.
"""
import sys
from pathlib import Path

import pictures
import render


def main(folder, arguments):
    folder.mkdir(parents=True, exist_ok=True)
    chosen = [name for name in arguments if name != "--yes"]
    unknown = sorted(set(chosen) - set(render.all_names()))
    if unknown:
        sys.exit(f"There is no picture {', '.join(unknown)}. There are: {', '.join(render.all_names())}.")
    changed, failed = {}, 0
    for name in chosen or render.all_names():
        picture, why = render.render(name)
        stored = render.baseline(name)
        why = why or pictures.emptiness(picture)
        if why:
            failed += 1
            print(f"{name}: not stored, {why}", flush=True)
            if picture is not None:
                pictures.save(picture, folder / f"{name}.png")
            continue
        told = "new" if stored is None else render.problem(name, picture, stored)
        print(f"{name}: {told or 'as stored'}", flush=True)
        if told:
            changed[name] = picture
            pictures.save(pictures.side_by_side(picture, stored), folder / f"{name}.png")
    if changed:
        print(f"Old, new and difference of {len(changed)} pictures are in {folder}. Look at every one.", flush=True)
        if "--yes" in arguments or input("Store the new ones? [y/N] ").strip().lower() == "y":
            render.BASELINES.mkdir(exist_ok=True)
            for name, picture in changed.items():
                pictures.store(picture, render.BASELINES / f"{name}.png")
            print(f"Stored in {render.BASELINES}.", flush=True)
    for path in render.BASELINES.glob("*.png"):
        if path.stem not in render.all_names():
            print(f"{path} belongs to no snippet and no scene: delete it.", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), sys.argv[2:]))
