"""Pages: of a run in memory and of its folder the same, whole within a notebook, and what a result shows of itself."""

from __future__ import annotations

import html
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import cantilever

import coque


def head(page: str) -> dict[str, Any]:
    """What a page says beside its numbers."""
    found = re.search(r'<script type="?application/json"? id="?head"?>(.*?)</script>', page, re.DOTALL)
    assert found is not None
    return dict(json.loads(found.group(1)))


def test_a_page_from_memory_is_that_of_the_folder(tmp_path: Path) -> None:
    text = coque.Scene(cantilever(title="A <b>strip</b>", analysis={"static": {"levels": 3}})).text
    scene = coque.Scene(text, set={"output.fields": {"stresses": True}})
    memory = head(scene.run(out=tmp_path / "out").view().page)
    folder = head(coque.load(tmp_path / "out").view().page)
    assert len(memory["frames"]) == 4 and [body["name"] for body in memory["bodies"]] == ["shell"]
    # The copy of the scene has what was replaced.
    del memory["scene"], folder["scene"]
    assert memory == folder and "u1" in dict(memory["bodies"][0]["sets"])


def test_sets_are_numbers_of_points(tmp_path: Path) -> None:
    scene = coque.Scene(cantilever(sets={"tip": {"nearest": [10.0, 1.0, 0.0]}}))
    result = scene.run(fields=True)
    tip = result.sets["shell"]["tip"]
    assert np.array_equal(scene.points()[tip], [[10.0, 1.0, 0.0]]) and "all" not in result.sets["shell"]
    scene.with_({"output.fields": {}}).run(out=tmp_path / "out")
    assert np.array_equal(coque.load(tmp_path / "out").sets["shell"]["tip"], tip)


@pytest.mark.filterwarnings("ignore::coque.CoqueWarning")
def test_several_bodies_stand_on_one_page(scenes: Path) -> None:
    changes = {"analysis.explicit.transient.duration": 0.01}
    result = coque.Scene(scenes / "dam-break.toml", set=changes).run(fields=True)
    shown = head(result.view().page)
    assert len(shown["bodies"]) == 2 and len(shown["frames"]) == len(result.frames)


def test_a_notebook_holds_the_whole_page(tmp_path: Path) -> None:
    result = coque.Scene(cantilever(title='"Quoted" & <i>')).run(fields=True)
    view = result.view(height=300)
    found = re.fullmatch(r'<iframe srcdoc="([^"]*)" style="([^"]*)"></iframe>', view._repr_html_())
    assert found is not None and html.unescape(found.group(1)) == view.page and "height:300px" in found.group(2)
    # Nothing is fetched.
    assert "default-src 'none'" in view.page and " src=" not in view.page
    result.save_view(tmp_path / "strip.html")
    assert (tmp_path / "strip.html").read_text(encoding="utf-8") == view.page
    # A page without frames has the curve and the words.
    plain = coque.Scene(cantilever()).run().view()
    assert head(plain.page)["frames"] == [] and "w_tip" in plain.page
    with pytest.raises(ValueError, match="must be positive"):
        result.view(size=0.0)


def test_a_page_has_no_more_than_it_may() -> None:
    march = {"explicit": {"transient": {"duration": 4.0, "record_every": 0.02}}}
    result = coque.Scene(cantilever(analysis=march)).run(fields=True)
    whole, small = (result.view(size=size).page for size in (30.0, 0.1))
    assert len(small) < len(whole) and len(head(small)["frames"]) < len(result.frames) == 201


def test_a_frame_that_was_bent_is_refused() -> None:
    result = coque.Scene(cantilever()).run(fields=True)
    body = result.frames[0].body
    body.connectivity = body.connectivity + 1000
    with pytest.raises(ValueError, match="no point"):
        result.view()
    body.connectivity = body.connectivity - 1000
    body.point_data["displacement"] = body.point_data["displacement"][:-1]
    with pytest.raises(ValueError, match="displacement has not a row"):
        result.view()


def test_a_result_shows_a_table() -> None:
    scene = coque.Scene(cantilever(title="<script>"), set={"loads[0].force.total": [0, 0, 1.0]})
    with pytest.warns(coque.CoqueWarning):
        table = scene.run()._repr_html_()
    assert "&lt;script&gt;" in table and "<td>w_tip</td>" in table and "no longer small" in table
    assert len(table) < 2000
