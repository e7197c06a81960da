import json
import math
from dataclasses import replace

import pytest

from berthing.errors import InputError
from berthing.report.plan_json import plan_document, to_text
from berthing.report.recorded import recorded_verification
from berthing.report.verdict_table import verification_rows
from berthing.verify.verdict import exempt, unproven
from support import synthetic


def document(verification, of):
    made = plan_document(of, synthetic.plan(of), verification, "certified")
    return json.loads(to_text(made))


def recorded(verification, of=None):
    return recorded_verification(document(verification, of or synthetic.scenario()), "plan.json")


@pytest.mark.parametrize("certified", [True, False])
def test_what_was_recorded_is_read_back(certified):
    of = synthetic.scenario()
    verification = synthetic.verification(of, certified)
    assert recorded(verification) == replace(verification, hamiltonian=())


def test_infinities_come_back_with_their_sign():
    of = synthetic.scenario(structures=())
    nothing_around = synthetic.verification(of)
    assert recorded(nothing_around, of).clearance_lower_bound_m == math.inf
    verification = synthetic.verification(synthetic.scenario())
    pairs = (exempt("main", "a|b", 0.0), unproven("main", "a|c", 3.0, 0.1))
    unknown = replace(
        verification, pairs=pairs, clearance_lower_bound_m=-math.inf,
        replay_position_error_m=math.inf, replays=(), ends=(),
    )  # fmt: skip
    found = recorded(unknown)
    assert found == replace(unknown, hamiltonian=())
    assert [r.value for r in verification_rows(found)] == [
        r.value for r in verification_rows(unknown)
    ]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda v: v.pop("limits_ok"), "limits_ok: is missing"),
        (lambda v: v.update(limits_ok=1), "limits_ok: is 1"),
        (lambda v: v.update(required_clearance_m=True), "required_clearance_m: is True"),
        (lambda v: v.update(reasons="none"), "reasons: is 'none'"),
        (lambda v: v.update(pairs={}), "pairs: is not a list"),
        (lambda v: v["pairs"].append(3), r"pairs\[3\]: is not an object"),
        (lambda v: v["pairs"][0].update(verdict="fine"), r"pairs\[0\].verdict: is 'fine'"),
        (lambda v: v["ends"][0].pop("time_s"), r"ends\[0\].time_s: is missing"),
    ],
)
def test_anything_else_is_refused(change, message):
    of = synthetic.scenario()
    found = document(synthetic.verification(of), of)
    change(found["verification"])
    with pytest.raises(InputError, match=message):
        recorded_verification(found, "plan.json")
