# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures on disk, and contact sheets: all pictures of a function, for a person to look at."""
import os
import textwrap

import numpy as np
from PIL import Image, ImageDraw

COLUMNS, TILE, MARGIN, LABEL = 14, 100, 4, 24
COLORS = {"ok": (90, 90, 90), "finding": (255, 40, 40), "known": (230, 170, 0)}


def write(name, image):
    Image.fromarray(image).save(name)


def contact_sheet(name, rows, folder):
    """rows: (function, dataset, state, text) in order; a tile without a picture shows what was said."""
    lines = -(-len(rows) // COLUMNS)
    width, height = TILE + 2 * MARGIN, TILE + 2 * MARGIN + LABEL
    sheet = Image.new("RGB", (COLUMNS * width, lines * height), "white")
    draw = ImageDraw.Draw(sheet)
    for k, (function, dataset, state, text) in enumerate(rows):
        x, y = k % COLUMNS * width, k // COLUMNS * height
        draw.rectangle((x + 1, y + 1, x + width - 2, y + height - LABEL - 1), fill=COLORS[state])
        picture = os.path.join(folder, f"{function}@{dataset}.png")
        box = x + MARGIN, y + MARGIN
        if os.path.exists(picture):
            sheet.paste(Image.open(picture).convert("RGB").resize((TILE, TILE)), box)
        else:
            draw.rectangle((*box, box[0] + TILE - 1, box[1] + TILE - 1), fill=(225, 225, 225))
            draw.text((box[0] + 2, box[1] + 2), "\n".join(textwrap.wrap(text, 16)[:6]).encode("latin1", "replace").decode("latin1"), fill="black")
        draw.text((x + 3, y + height - LABEL + 1), "\n".join(textwrap.wrap(dataset, 17)[:2]), fill="black", spacing=0)
    sheet.save(name)
    return np.asarray(sheet).shape
