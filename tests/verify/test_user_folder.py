"""Plan folders that hold code of the user's own: run by word only, and marked as one source."""

import copy
import json
import subprocess
import sys

import numpy as np
import pytest
from typer.testing import CliRunner

from berthing.cli import app
from berthing.errors import InputError
from berthing.scenario.files import load
from berthing.verify.folder import read_plan, verify_folder
from berthing.verify.verification import INDEPENDENT, SAME_SOURCE, verify

CODE = """
from berthing import UserModel


def derivative(t, x, u, p, xp):
    q, w = x[6:10], x[10:13]
    return xp.vector(
        x[3:6], xp.rotate(q, u[0:3]) / p["mass_kg"], xp.quaternion_rate(q, w), u[3:6] / p["j"]
    )


craft = UserModel(
    "craft", 3,
    ("x_m", "y_m", "z_m", "vx_m_s", "vy_m_s", "vz_m_s",
     "qw", "qx", "qy", "qz", "wx_rad_s", "wy_rad_s", "wz_rad_s"),
    ("fx_n", "fy_n", "fz_n", "gx_nm", "gy_nm", "gz_nm"), derivative,
    place=lambda x, p, xp: (x[0:3], x[6:10]), attitude="quaternion",
    rates=lambda x, p, xp: (x[3:6], x[10:13]), parameters={"mass_kg": 3.0, "j": 5.0},
)


def level(t, x, u, p, xp):
    return xp.abs(x[2]) - p["most_m"]
"""


@pytest.fixture
def user_folder(make, tmp_path):
    """A sound plan of a vehicle whose dynamics are code; ``height_m`` bounds |z|."""

    def write(most_m=0.1, **parameters):
        document = copy.deepcopy(make.document)
        (tmp_path / "craft.py").write_text(CODE)
        vehicle = document["vehicles"][0]
        vehicle["dynamics"] = {"model": "user", "file": "craft.py", "name": "craft",
                               "parameters": parameters}  # fmt: skip
        vehicle["path_constraints"] = [
            {"file": "craft.py", "name": "level", "parameters": {"most_m": most_m}}
        ]
        (tmp_path / "glide.json").write_text(json.dumps(document))
        whole = load(tmp_path / "glide.json")
        own = make.glide(whole.phases[0].vehicles[0], (0, 0, 0), (10, 0, 0), np.pi / 2, 100.0, 20)
        made = make.plan([own], [make.glide_nodes(own)])
        make.write_folder(tmp_path / "plan", whole, made)
        return tmp_path / "plan", whole, made

    return write


def test_code_runs_by_word_only(user_folder):
    folder, _, _ = user_folder()
    for check in (verify_folder, read_plan):
        with pytest.raises(InputError, match=r"craft\.py, which is not run unasked"):
            check(folder)
    found = verify_folder(folder, trust=True)
    assert found.certified, found.reasons
    assert found.model_check == SAME_SOURCE


def test_the_command_says_how_to_trust(user_folder):
    folder, _, _ = user_folder()
    done = CliRunner().invoke(app, ["verify", str(folder)])
    assert done.exit_code == 2
    assert "--trust" in done.stderr
    done = CliRunner().invoke(app, ["verify", str(folder), "--trust", "--json"])
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["verification"]["model_check"] == SAME_SOURCE


def test_known_models_have_equations_of_their_own(make):
    whole, made = make.document_plan()
    assert verify(whole, made).model_check == INDEPENDENT


def test_other_dynamics_are_noticed(user_folder):
    _, whole, made = user_folder(mass_kg=3.3)
    found = verify(whole, made)
    assert not found.certified
    assert any(reason.startswith("replay[craft") for reason in found.reasons)


def test_other_code_is_noticed(user_folder):
    folder, _, _ = user_folder()
    path = folder / "plan.json"
    path.write_text(path.read_text().replace("u[3:6] / p", "1.0 * u[3:6] / p"))
    found = verify_folder(folder, trust=True)
    assert not found.certified
    assert any(reason.startswith("scenario: ") for reason in found.reasons)


def test_a_path_constraint_is_a_limit(user_folder):
    _, whole, made = user_folder(most_m=-1e-2)
    found = verify(whole, made)
    assert not found.limits_ok
    assert any(r.startswith("limit[craft, path level, t = ") for r in found.reasons)


def test_checking_it_brings_no_solver_along(user_folder):
    folder, _, _ = user_folder()
    code = (
        "import sys; from berthing.verify.folder import verify_folder; "
        f"print(verify_folder({str(folder)!r}, trust=True).certified, 'casadi' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "True False\n"
