"""The parameter `progress`: a function that is called with each Progress, or True for a progress bar of tqdm."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator

from ..extras import imported
from ..messages.results import Progress

OnProgress = Callable[[Progress], None]
ProgressOption = OnProgress | bool | None


@contextlib.contextmanager
def progress_callback(progress: ProgressOption) -> Iterator[OnProgress | None]:
    """The function to call for each round; a bar ends with the block.  Raises MissingExtra if tqdm is missing."""
    if not isinstance(progress, bool):
        yield progress
    elif not progress:
        yield None
    else:
        tqdm = imported("tqdm.auto", "progress=True", "progress").tqdm
        with tqdm(unit=" rounds", bar_format="{n_fmt}{unit}, {elapsed}{postfix}") as bar:

            def show(step: Progress) -> None:
                bound = "" if step.bound is None else f", bound {step.bound:.2f}"
                bar.set_postfix_str(f"length {step.length:.2f}{bound}", refresh=False)
                bar.update(step.round - bar.n)

            yield show
