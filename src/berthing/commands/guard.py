"""From errors to exit codes."""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Callable

from berthing.commands.exit_codes import BAD_INPUT, INTERRUPTED
from berthing.errors import BerthingError


def guarded(work: Callable[[], int]) -> int:
    """The exit code of ``work``; one message on standard error where it fails on purpose.

    To be asked to end (SIGTERM) is to be interrupted, so that no solve outlives the command.
    Anything else that it raises is a mistake of this package, and keeps its traceback.
    """
    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        return work()
    except BerthingError as error:
        print(f"berthing: {error}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        print("berthing: interrupted; nothing was written", file=sys.stderr)
        return INTERRUPTED
