import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

# A loaded machine takes long to start and to stop; an idle one a second or two.
PATIENCE_S = 60.0


def children(pid: int) -> list[int]:
    """Of a process; none where it has ended."""
    try:
        return [int(n) for n in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
    except OSError:
        return []


def wait_until_it_solves(pid: int) -> list[int]:
    """Until the process has children: it solves its guesses in them."""
    began = time.monotonic()
    while time.monotonic() - began < PATIENCE_S:
        if found := children(pid):
            return found
        time.sleep(0.02)
    raise AssertionError("it never began to solve")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("stop", "number"), [(os.killpg, signal.SIGINT), (os.kill, signal.SIGTERM)]
)
def test_stopped_while_solving_it_exits_130_at_once_and_leaves_nothing(tmp_path, stop, number):
    # The whole group is interrupted, as a terminal does it; a service manager asks one process.
    command = [sys.executable, "-m", "berthing", "plan", "scenario-b-tight"]
    process = subprocess.Popen(
        command, cwd=tmp_path, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    solving = wait_until_it_solves(process.pid)
    time.sleep(0.2)
    stop(process.pid, number)
    _, errors = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 130
    assert errors == "berthing: interrupted; nothing was written\n"
    assert os.listdir(tmp_path) == []
    assert not [pid for pid in solving if Path(f"/proc/{pid}/exe").exists()]
