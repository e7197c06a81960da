"""Cases as files that other planners can read, each with its solution."""

from __future__ import annotations

from pathlib import Path

from ruamel.yaml import YAML

from benchmarks.tight3d._scene import Case
from support import hand_made


def export(case: Case, folder: Path) -> None:
    """``NAME.yaml``, and ``NAME.witness``, a plan folder that ``berthing verify`` checks."""
    folder.mkdir(parents=True, exist_ok=True)
    yaml = YAML(typ="safe", pure=True)
    yaml.sort_base_mapping_type_on_output = False
    with (folder / f"{case.name}.yaml").open("w", encoding="utf-8") as file:
        yaml.dump(case.document, file)
    scenario = case.scenario()
    hand_made.write_folder(folder / f"{case.name}.witness", scenario, case.witness(scenario))
