"""What was edited, to be taken back: lists of changes, as they were and as they were to be."""

MOST = 200  # edits that can be taken back


class History:
    """The past and the undone future of one list of changes. What one drag of a slider does is one step."""

    def __init__(self) -> None:
        self._past: list[tuple[str, ...]] = []
        self._future: list[tuple[str, ...]] = []
        self._dragging = False

    @property
    def depth(self) -> tuple[int, int]:
        """How many edits can be undone, and how many redone."""
        return len(self._past), len(self._future)

    def note(self, before: tuple[str, ...], *, dragging: bool = False) -> None:
        """Remember the changes `before` an edit, which may go on with a drag that has begun, or end it."""
        if not self._dragging:
            self._past = [*self._past, before][-MOST:]
            self._future.clear()
        self._dragging = dragging

    def before(self) -> tuple[str, ...] | None:
        """The changes to go back to; None where there are none."""
        return self._past[-1] if self._past else None

    def after(self) -> tuple[str, ...] | None:
        """The changes to go forward to; None where nothing was undone."""
        return self._future[-1] if self._future else None

    def undone(self, now: tuple[str, ...]) -> None:
        """The last edit has been taken back; until then the changes were `now`."""
        self._past.pop()
        self._future.append(now)
        self._dragging = False

    def redone(self, now: tuple[str, ...]) -> None:
        """The edit undone last has been made again; until then the changes were `now`."""
        self._future.pop()
        self._past.append(now)
        self._dragging = False
