"""The guard at the door: who may ask for what, and the headers that keep a browser from being tricked.

A page of another site must not fly this server's aircraft: WebSockets and everything but reading need the server's own
origin. A server that listens on this machine alone must not answer under a foreign name (DNS rebinding).
"""

from collections.abc import Awaitable, Callable, MutableMapping
from ipaddress import ip_address
from typing import Any
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import PlainTextResponse

Scope = MutableMapping[str, Any]
Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

HEADERS = {
    "content-security-policy": "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "connect-src 'self' ws: wss:; object-src 'none'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'",
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
}


class Guard:
    """Middleware around the whole application. `loopback` says that it listens on this machine alone."""

    def __init__(self, app: App, *, loopback: bool = True) -> None:
        self._app, self._loopback = app, loopback

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer 403 to those who may not pass, and put the headers on what the others get."""
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        host, origin = headers.get("host", ""), headers.get("origin")
        reads = scope["type"] == "http" and scope["method"] in ("GET", "HEAD")
        refused = None
        if self._loopback and not is_loopback(host_name(host)):
            refused = f"This server answers as localhost only, not as {host[:80]!r}."
        elif not reads and origin is not None and not same_origin(origin, host):
            refused = f"Pages of {origin[:80]!r} may not use this server."
        if refused is None:
            await self._app(scope, receive, _with_headers(send) if scope["type"] == "http" else send)
        elif scope["type"] == "websocket":
            await send({"type": "websocket.close", "code": 1008, "reason": refused})
        else:
            await PlainTextResponse(refused, status_code=403)(scope, receive, send)


def host_name(host: str) -> str | None:
    """The name or address in a Host header, without its port; None when it cannot be read."""
    try:
        return urlsplit(f"//{host}").hostname
    except ValueError:
        return None


def is_loopback(host: str | None) -> bool:
    """Whether `host`, a name or an address without port, means this machine."""
    if host is None:
        return False
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def same_origin(origin: str, host: str) -> bool:
    """Whether a page of `origin` is from the server asked for as `host`: same port, and same name or this machine."""
    try:
        page, server = urlsplit(origin), urlsplit(f"{urlsplit(origin).scheme}://{host}")
        ports = [url.port or {"http": 80, "https": 443}.get(url.scheme) for url in (page, server)]
    except ValueError:
        return False
    if page.scheme not in ("http", "https") or ports[0] != ports[1]:
        return False
    return page.hostname == server.hostname or (is_loopback(page.hostname) and is_loopback(server.hostname))


def _with_headers(send: Send) -> Send:
    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in HEADERS.items():
                headers.setdefault(name, value)
        await send(message)

    return sending
