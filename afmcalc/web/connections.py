"""Connections of the page's server: a connection without a request is closed, and the oldest if there are too many."""

import asyncio

from uvicorn.protocols.http.h11_impl import H11Protocol


def protocol(seconds: float = 10.0, most: int = 100) -> type[H11Protocol]:
    """Protocol of which at most ``most`` connections may wait, each at most ``seconds``, for the head of a request."""
    waiting: dict[H11Protocol, asyncio.TimerHandle] = {}

    class Patient(H11Protocol):
        """Connection that is closed if no request has come in time."""

        def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
            """Wait for the first request; if too many connections wait, close the one that has waited longest."""
            super().connection_made(transport)
            self._wait()
            if len(waiting) > most:
                next(iter(waiting)).transport.abort()

        def data_received(self, data: bytes) -> None:
            """Stop waiting if the head of the request is now complete."""
            super().data_received(data)
            if self.cycle and not self.cycle.response_complete:
                self._stop()

        def on_response_complete(self) -> None:
            super().on_response_complete()
            self._wait()

        def connection_lost(self, exc: Exception | None) -> None:
            super().connection_lost(exc)
            self._stop()

        def _wait(self) -> None:
            self._stop()
            if not self.transport.is_closing():
                waiting[self] = self.loop.call_later(seconds, self.transport.abort)

        def _stop(self) -> None:
            if timer := waiting.pop(self, None):
                timer.cancel()

    return Patient
