"""Commands that need no time, carried out."""

from fdes.cockpit import commands
from fdes.cockpit.session import Session


def obey_at_once(session: Session, command: commands.Command) -> None:
    """Carry out a command that needs no time. Raises SpecError, NoSuchPart."""
    match command:
        case commands.Freeze(True):
            session.freeze()
        case commands.Freeze(False):
            session.run()
        case commands.Reset():
            session.reset()
        case commands.Step():
            session.step()
        case commands.ClearInputs():
            session.clear_inputs()
        case commands.Disturb(text):
            session.disturb(text)
        case commands.Seek(t):
            session.seek(t)
        case commands.StopReplay():
            session.stop_replay()
