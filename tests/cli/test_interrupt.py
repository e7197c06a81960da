import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

# A loaded machine takes long to start and to stop; an idle one a second or two.
PATIENCE_S = 60.0


def wait_until_it_solves(pid: int) -> None:
    """Until the process has children: it solves its guesses in them."""
    children = Path(f"/proc/{pid}/task/{pid}/children")
    began = time.monotonic()
    while time.monotonic() - began < PATIENCE_S:
        if children.read_text().strip():
            return
        time.sleep(0.02)
    raise AssertionError("it never began to solve")


@pytest.mark.slow
def test_ctrl_c_while_solving_exits_130_at_once_and_leaves_nothing(tmp_path):
    # The whole group is interrupted, as a terminal does it.
    command = [sys.executable, "-m", "berthing", "plan", "scenario-b-tight"]
    process = subprocess.Popen(
        command, cwd=tmp_path, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    wait_until_it_solves(process.pid)
    time.sleep(0.2)
    os.killpg(process.pid, signal.SIGINT)
    _, errors = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 130
    assert errors == "berthing: interrupted; nothing was written\n"
    assert os.listdir(tmp_path) == []
