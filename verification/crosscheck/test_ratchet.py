"""The ratchet holds: it fails when an error grows, and does not learn a worsening by itself. On made-up values, in a folder of its own."""

import dataclasses

import pytest

import ratchet
from values import Value


def value(error, row="a", noise=1e-16):
    return Value("special", "made_up.csv", row, "f", 1.0 + error, "1", 1.0, 1e-3, noise)


@pytest.fixture
def table(tmp_path):
    path = str(tmp_path / "ratchet.csv")
    code, _ = ratchet.run([value(1e-9), value(2e-9, "b")], ratchet.parsed(["--record"]), path)
    assert code == 0
    return path


def run(values, path, *words):
    code, lines = ratchet.run(values, ratchet.parsed(list(words)), path)
    return code, "\n".join(lines)


def test_it_passes_as_recorded_and_within_the_budget(table):
    assert run([value(1e-9), value(2e-9, "b")], table)[0] == 0
    assert run([value(2.9e-9), value(2e-9, "b")], table)[0] == 0


def test_it_fails_when_an_error_grows(table):
    code, text = run([value(3.1e-9), value(2e-9, "b")], table)
    assert code == 1 and "outgrew its budget" in text and "made_up.csv: a f" in text


def test_it_fails_on_what_is_no_number(table):
    assert run([value(float("nan")), value(2e-9, "b")], table)[0] == 1
    assert run([value(float("inf")), value(2e-9, "b")], table)[0] == 1


def test_it_fails_on_a_value_without_a_row_and_on_a_row_without_a_value(table):
    assert "no row" in run([value(1e-9), value(2e-9, "b"), value(1e-9, "c")], table)[1]
    assert run([value(1e-9), value(2e-9, "b"), value(1e-9, "c")], table)[0] == 1
    assert run([value(1e-9)], table)[0] == 1


def test_one_command_records_an_improvement_and_keeps_it(table):
    assert run([value(1e-12), value(2e-9, "b")], table, "--record")[0] == 0
    assert run([value(1e-9), value(2e-9, "b")], table)[0] == 1, "what was good enough before is worse now"
    assert run([value(1e-12), value(2e-9, "b")], table)[0] == 0


def test_recording_never_raises_a_budget_by_itself(table):
    before = open(table, encoding="utf-8").read()
    code, text = run([value(1e-8), value(2e-9, "b")], table, "--record")
    assert code == 1 and "--worse" in text and open(table, encoding="utf-8").read() == before
    # Within the budget, but larger than on the day of the record: the budget stays.
    assert run([value(2.9e-9), value(2e-9, "b")], table, "--record")[0] == 0
    assert run([value(3.1e-9), value(2e-9, "b")], table)[0] == 1


def test_a_worsening_is_recorded_with_its_reason(table):
    assert run([value(1e-8), value(2e-9, "b")], table, "--record", "--worse", "a coarser rule is twice as fast")[0] == 0
    assert "a coarser rule is twice as fast" in open(table, encoding="utf-8").read()
    assert run([value(1e-8), value(2e-9, "b")], table)[0] == 0
    assert run([value(2e-8)], table, "--record", "--worse", "gone")[0] == 0


def test_a_value_that_misses_its_target_is_never_recorded(table):
    code, text = run([value(1e-2), value(2e-9, "b")], table, "--record", "--worse", "anything")
    assert code == 1 and "misses its target" in text


def test_a_budget_is_no_less_than_the_noise(table):
    assert ratchet.budget_of(value(0.0)) == 1e-16
    assert ratchet.budget_of(dataclasses.replace(value(1e-9), noise=1e-8)) == 1e-8


def test_a_true_value_made_worse_is_caught(everything):
    """The committed table, and one value of the solver in each group moved by a hundred of its budgets."""
    table, _ = ratchet.read()
    for group in {v.group for v in everything}:
        index = next(i for i, v in enumerate(everything) if v.group == group)
        one = everything[index]
        budget = max(float(table[one.key]["budget"]), 1e-15)
        moved = dataclasses.replace(one, value=one.value + 100.0 * budget * one.scale)
        assessment = ratchet.assess(everything[:index] + [moved] + everything[index + 1:], table)
        assert [v.key for v, _ in assessment.worse] == [one.key]
