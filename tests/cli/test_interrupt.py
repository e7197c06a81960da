import os
import signal
import subprocess
import sys
import time

import pytest


@pytest.mark.slow
def test_ctrl_c_while_solving_exits_130_at_once_and_leaves_nothing(tmp_path):
    # The whole group is interrupted, as a terminal does it; this scenario takes far longer.
    command = [sys.executable, "-m", "berthing", "plan", "scenario-b-tight"]
    process = subprocess.Popen(
        command, cwd=tmp_path, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    time.sleep(5.0)
    os.killpg(process.pid, signal.SIGINT)
    began = time.monotonic()
    _, errors = process.communicate(timeout=60.0)
    assert process.returncode == 130
    assert errors == "berthing: interrupted; nothing was written\n"
    assert time.monotonic() - began < 10.0
    assert os.listdir(tmp_path) == []
