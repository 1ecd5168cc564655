"""The page's files, kept in memory as they are and compressed: a room full of page loads costs next to nothing."""

import gzip
import mimetypes
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response

TEXTS = {
    ".html": "text/html",
    ".css": "text/css",
    ".js": "text/javascript",
    ".svg": "image/svg+xml",
    ".json": "application/json",
}


@dataclass(frozen=True)
class Kept:
    """One file as it was at `modified` [ns]."""

    modified: int
    body: bytes
    zipped: bytes | None
    media_type: str
    etag: str


class Folder:
    """Serves the files in `root` and below it, and nothing else. A file is read again when it has changed."""

    def __init__(self, root: Path) -> None:
        self._root = root.resolve()
        self._kept: dict[Path, Kept] = {}

    def respond(self, request: Request, name: str) -> Response:
        """The file `name` for a GET or HEAD request: compressed where it may be, 304 where the browser has it."""
        kept = self._file(name)
        headers = {"etag": kept.etag, "cache-control": "no-cache", "vary": "accept-encoding"}
        if request.headers.get("if-none-match") == kept.etag:
            return Response(status_code=304, headers=headers)
        if kept.zipped is not None and "gzip" in request.headers.get("accept-encoding", ""):
            return Response(kept.zipped, media_type=kept.media_type, headers=headers | {"content-encoding": "gzip"})
        return Response(kept.body, media_type=kept.media_type, headers=headers)

    def _file(self, name: str) -> Kept:
        try:
            path = (self._root / name).resolve()
            if not path.is_relative_to(self._root) or not path.is_file():
                raise HTTPException(404, f"There is no file {name[:80]!r} here.")
            modified = path.stat().st_mtime_ns
        except (OSError, ValueError):  # a name that no file system allows
            raise HTTPException(404, "There is no such file here.") from None
        kept = self._kept.get(path)
        if kept is None or kept.modified != modified:
            kept = self._kept[path] = _read(path, modified)
        return kept


def _read(path: Path, modified: int) -> Kept:
    body = path.read_bytes()
    text = TEXTS.get(path.suffix)
    media_type = f"{text}; charset=utf-8" if text else mimetypes.guess_type(path.name)[0] or "application/octet-stream"
    return Kept(
        modified, body, gzip.compress(body) if text else None, media_type, f'W/"{sha256(body).hexdigest()[:16]}"'
    )
