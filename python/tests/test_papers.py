"""The papers made anew: `limn papers`."""

import pathlib

import pytest

import limn


def files_of(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_a_paper_is_the_commands(command, tmp_path):
    index = limn.papers(tmp_path / "mine", "augsdorfer")
    assert index == str(tmp_path / "mine" / "index.html")
    printed = command("papers", "augsdorfer", "-o", tmp_path / "theirs")
    assert printed["index"] == str(tmp_path / "theirs" / "index.html")
    mine, theirs = files_of(tmp_path / "mine"), files_of(tmp_path / "theirs")
    assert mine.keys() == theirs.keys() and len(mine) > 20
    for name, content in mine.items():
        assert content == theirs[name], name


def test_all_papers_have_a_page_that_leads_to_them(tmp_path, monkeypatch):
    made = []
    monkeypatch.setattr(limn._limn, "write_paper", lambda *words: made.append(words))
    names = limn._limn.paper_names()
    index = limn.papers(tmp_path)
    assert made == [(name, str(tmp_path / name)) for name in names] and len(names) == 3
    page = pathlib.Path(index).read_text()
    for name in names:
        assert f"{name}/index.html" in page


def test_no_such_paper(tmp_path):
    for names in (("nobody",), ("augsdorfer", "nobody")):
        with pytest.raises(limn.Error, match="there is no paper 'nobody' .the papers are augsdorfer"):
            limn.papers(tmp_path / "out", *names)
    assert not (tmp_path / "out").exists()  # nothing is made before all names are known
