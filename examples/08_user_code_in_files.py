"""Dynamics of your own in a file beside the scenario's, and why a folder must be trusted.

The same with the command line: ``berthing plan examples/rover/rover.yaml`` and then
``berthing verify plans/rover --trust``.
"""

import tempfile
from pathlib import Path

import berthing as bt
from berthing.errors import InputError
from berthing.report.folder import write_result

scenario = bt.load(Path(__file__).parent / "rover" / "rover.yaml")
result = bt.plan(scenario)
print(result.outcome, result.verification.model_check)

with tempfile.TemporaryDirectory() as temporary:
    folder = Path(temporary) / "rover"
    write_result(scenario, result, scenario.solver, folder)
    try:
        bt.verify_folder(folder)
    except InputError as error:
        print("unasked:", error.what)
    print("trusted:", "certified" if bt.verify_folder(folder, trust=True).certified else "not")
