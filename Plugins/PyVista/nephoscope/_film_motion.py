# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Streaks and segments of `add_splats` that move from step to step of a film."""
from __future__ import annotations

from typing import Any, Callable, Iterable

from .splats import TexturedSplatMapper

SMOOTH = 4.0  # least steps in which the fastest pattern moves by a period: with fewer it would seem to stand or to move backwards


def motion(actors: Iterable[Any], framerate: float) -> Callable[[int], None] | None:
    """A function that moves the vectors of the actors to a step; None if none of them has vectors to move.

    Those with ``true_speed`` have a ``film_time`` in seconds of the film. Others do the same, but the film is slowed down where fewer than 4 steps a second would
    show no motion. Where the user sets ``phase`` or ``film_time``, these stay.
    """
    mappers = [mapper for mapper in (getattr(actor, "mapper", None) for actor in actors) if isinstance(mapper, TexturedSplatMapper) and mapper.GetVectorArrayName()]
    free = [(mapper, framerate if mapper.GetTrueSpeed() else max(framerate, SMOOTH)) for mapper in mappers if mapper.moves_by_itself]
    for mapper, _ in free:
        if not mapper.GetTrueSpeed():
            mapper.carry(True)

    def move(step: int) -> None:
        for mapper, steps_per_second in free:
            if mapper.moves_by_itself:
                mapper.SetFilmTime(step / steps_per_second)
            else:
                mapper.carry(False)

    return move if free else None
