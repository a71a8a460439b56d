from collections.abc import Callable

__version__: str

class Stop:
    def request(self) -> None: ...

class Engine:
    def __init__(self, threads: int = 1) -> None: ...
    def answer(self, request: str, stop: Stop, on_round: Callable[[int, float], None] | None = None) -> str: ...
