# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sentences that the classes can say, from their sources."""
import re


def sentences(folder):
    """String literals of the C++ sources with more than one word; adjacent ones are one. Without those of tests and of hosts below the folder."""
    for path in sorted(folder.rglob("*.cxx")) + sorted(folder.rglob("*.h")):
        if {"Testing", "ParaView"} & set(path.relative_to(folder).parts):
            continue
        text = "\n".join(line for line in path.read_text().splitlines() if "indent" not in line and "#include" not in line)
        for literals in re.findall(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*', text):
            joined = "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', literals))
            if " " in joined.strip():
                yield path.name, joined
