import sys

from rich.console import Console

from berthing.commands import console
from berthing.report.verdict_table import Row
from berthing.result import ProgressEvent


def on_a_terminal(monkeypatch):
    monkeypatch.setattr(
        console, "Console", lambda **how: Console(**how, force_terminal=True, width=60)
    )


def test_progress_shows_stage_iterations_and_clearance(monkeypatch, capsys):
    on_a_terminal(monkeypatch)
    with console.progress_line() as progress:
        progress(ProgressEvent("refine", "straight", 143, 0.0981))
    shown = capsys.readouterr()
    assert "refine · straight · 143 iterations" in shown.err
    assert shown.out == ""


def test_progress_leaves_the_streams_alone(monkeypatch):
    on_a_terminal(monkeypatch)
    before = (sys.stdout, sys.stderr)
    with console.progress_line():
        assert (sys.stdout, sys.stderr) == before


def test_a_table_on_a_terminal_fits_it_and_is_coloured(monkeypatch, capsys):
    on_a_terminal(monkeypatch)
    console.print_rows([Row("verdict", "NOT certified", False), Row("because", "x " * 60)])
    shown = capsys.readouterr().out
    assert "\x1b[1;31mNOT certified" in shown
    assert shown.count("\n") > 2


def test_a_table_elsewhere_is_plain_and_keeps_its_lines(capsys):
    console.print_rows([Row("verdict", "NOT certified", False), Row("because", "x" * 300)])
    assert capsys.readouterr().out == "verdict  NOT certified\nbecause  " + "x" * 300 + "\n"
