import json
import re
from dataclasses import replace

import numpy as np
import pytest

from berthing.report.offline.page import asset, shown_page
from berthing.report.offline.shown import Shown
from berthing.report.plan_json import plan_document
from berthing.result import Attempt
from support import synthetic

ATTEMPTS = (Attempt("over <b>", "iteration_limit", 40, 3000, 21.0, cost=np.inf, note="a < b"),)


def shown(of, certified=True, label=None):
    plan, verification = synthetic.plan(of), synthetic.verification(of, certified)
    outcome = "certified" if certified else "not_certified"
    document = plan_document(of, plan, verification, outcome, ATTEMPTS)
    return Shown(label or of.name, of, plan, verification, synthetic.claims(of), document)


@pytest.fixture(scope="module")
def text():
    return shown_page([shown(synthetic.scenario())])


def without_data(text):
    """The page without the bundle and without what is drawn."""
    return re.sub(r"<(script|style|pre)\b.*?</\1>", "", text, flags=re.DOTALL)


def test_nothing_in_it_leads_elsewhere(text):
    markup = without_data(text)
    assert "://" not in markup
    assert re.findall(r'(?:src|href)="([^"]*)"', markup) == ["data:,", "#time"]
    assert "url(" not in text.split("<style>")[1].split("</style>")[0]


def test_its_own_policy_allows_the_bundle_alone(text):
    (policy,) = re.findall(r'Content-Security-Policy" content="([^"]*)"', text)
    assert policy.startswith("default-src 'none'; script-src 'sha256-")
    assert "connect-src" not in policy
    assert "unsafe-inline" not in policy.split("script-src")[1].split(";")[0]


def test_it_has_each_placeholder_filled_and_all_licences(text):
    assert not re.search(r"\$[a-z_]+", without_data(text))
    for name in ("three", "uplot"):
        assert name in asset("LICENCES.txt")
    assert asset("LICENCES.txt").count("The MIT License") == 2
    assert "Copyright" in text


def test_the_verdict_has_the_values_of_plan_json(text):
    document = shown(synthetic.scenario()).document
    cells = re.findall(r'data-fields="([^"]*)"', text)
    assert len(cells) >= 10
    for cell in cells:
        for key, value in json.loads(cell.replace("&quot;", '"')).items():
            found = document
            for name in key.split("."):
                found = found[name]
            assert value == found


def test_names_notes_and_reasons_are_escaped():
    of = replace(synthetic.scenario(), name="<b>x</b>", description="one & two\nthree < four")
    found = shown(of, certified=False)
    reasons = (*found.verification.reasons, "short by 3 < 4")
    text = shown_page([replace(found, verification=replace(found.verification, reasons=reasons))])
    for raw in ("<b>x", "over <b>", "a < b", "one & two", "3 < 4"):
        assert raw not in text
    assert "short by 3 &lt; 4" in text
    assert "<p>one &amp; two</p>\n<p>three &lt; four</p>" in text
    assert "over &lt;b&gt;" in text


def test_data_cannot_end_their_element():
    text = shown_page([shown(synthetic.scenario(name="</script>"))])
    data = text.split('id="data">')[1].split("</script>")[0]
    assert json.loads(data)["plans"][0]["label"] == "</script>"


def test_many_reasons_are_counted():
    found = shown(synthetic.scenario(), certified=False)
    many = replace(found.verification, reasons=tuple(f"reason {i}" for i in range(50)))
    text = shown_page([replace(found, verification=many)])
    assert "reason 11" in text
    assert "reason 12" not in text
    assert "and 38 more" in text


def test_a_certified_plan_has_no_banner(text):
    assert 'class="banner"' not in text
    assert 'class="banner"' in shown_page([shown(synthetic.scenario(), certified=False)])


def test_plans_compared_have_a_column_each():
    of = synthetic.scenario()
    text = shown_page([shown(of, label="one"), shown(of, certified=False, label="two")])
    table = text.split('<table class="verdict">')[1].split("</table>")[0]
    rows = table.split("<tr>")[2:]
    assert all(row.count("<td") == 2 for row in rows)
    assert "certified</td><td" in rows[0]
    assert "NOT certified" in rows[0]
    assert "<h1>synthetic, 2 plans</h1>" in text
    assert "<strong>two: Not certified.</strong>" in text


def test_every_pair_is_in_the_table(text):
    of = synthetic.scenario()
    table = text.split('id="pairs"')[1].split("</section>")[0]
    for pair in of.pairs(of.phases[0]):
        assert pair.name.replace("|", " – ") in table
    assert table.count("data-seek") == 3


@pytest.mark.parametrize(
    ("outcome", "said"),
    [
        ("not_certified", "<strong>Not certified.</strong>"),
        ("undecided", "<strong>Not certified: undecided.</strong>"),
    ],
)
def test_what_is_not_certified_is_said_without_scripts(outcome, said):
    found = shown(synthetic.scenario(), certified=False)
    document = {**found.document, "outcome": outcome}
    assert said in without_data(shown_page([replace(found, document=document)]))


def test_of_what_is_certified_no_banner_says_otherwise(text):
    assert "Not certified" not in without_data(text)
