"""The documents: their links lead somewhere, and the code in them is code that is tested."""
import pathlib
import re
import sys
import textwrap

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = sorted([ROOT / "README.md", *(ROOT / "doc").glob("*.md"),
                    *(ROOT / "results").glob("**/*.md")])
LINK = re.compile(r"\]\(([^)\s#]+)(?:#[^)]*)?\)")
CODE = re.compile(r"```cpp\n(.*?)```", re.DOTALL)


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_links_lead_to_files(document):
    links = LINK.findall(document.read_text(encoding="utf-8"))
    local = [link for link in links if not link.startswith(("http://", "https://"))]
    assert [link for link in local if not (document.parent / link).exists()] == []


def test_the_readme_is_one_screen_and_leads_to_the_pages():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    lines = readme.splitlines()
    assert len(lines) <= 50 and max(map(len, lines)) <= 110
    first = {"doc/index.md", "doc/tutorial.md", "doc/using.md", "doc/reference.md", "doc/measured.md"}
    assert first <= set(LINK.findall(readme))


def test_the_picture_of_the_house_is_that_of_the_includes():
    sys.path.insert(0, str(ROOT / "doc"))
    import house  # pylint: disable=import-outside-toplevel
    assert house.table() in (ROOT / "doc" / "house.md").read_text(encoding="utf-8")


def test_every_page_is_in_the_site_and_every_verb_in_the_reference():
    site = (ROOT / "mkdocs.yml").read_text(encoding="utf-8")
    assert [page.name for page in (ROOT / "doc").glob("*.md") if f": {page.name}" not in site] == []
    verbs = re.findall(r"^  (\w+) +[a-z]", (ROOT / "run").read_text(encoding="utf-8")
                       .partition("examples")[0], re.MULTILINE)
    reference = (ROOT / "doc" / "reference.md").read_text(encoding="utf-8")
    assert len(verbs) > 15
    assert [verb for verb in verbs if not re.search(rf"\b{verb}\b", reference)] == []


def calls_of_the_front_door():
    """(page, verb, names of launch arguments, where there are) of each `./run ...` in the documents."""
    for document in DOCUMENTS:
        text = document.read_text(encoding="utf-8").replace("\\\n", " ")
        for verb, rest in re.findall(r"\./run ([a-z_]+)([^`\n#]*)", text):
            yield document.name, verb, re.findall(r"(?<![\w\"'])([a-z_]+):=", rest)


def test_what_the_documents_say_to_the_front_door_it_knows():
    roslaunch = pytest.importorskip("roslaunch.arg_dump")
    verbs = set(re.findall(r"^  (\w+) +[a-z]", (ROOT / "run").read_text(encoding="utf-8")
                           .partition("examples")[0], re.MULTILINE))
    arguments = {file.stem: set(roslaunch.get_args([str(file)]))
                 for file in (ROOT / "launch").glob("*.launch") if file.stem in verbs}
    calls = list(calls_of_the_front_door())
    assert len(calls) > 50 and len(arguments) >= 4
    assert [call for call in calls if call[1] not in verbs] == []
    assert [(page, verb, name) for page, verb, names in calls for name in names
            if verb in arguments and name not in arguments[verb]] == []


def test_commands_of_the_tutorial_are_found_whole():
    sys.path.insert(0, str(ROOT / "doc"))
    import run_commands  # pylint: disable=import-outside-toplevel
    text = (ROOT / "doc" / "tutorial.md").read_text(encoding="utf-8")
    found = list(run_commands.commands(text))
    assert (True, "./run walk repertoire_file:=tutorial.db rviz:=false") in found
    assert [command for _, command in found if command.count('"') % 2] == []


def test_the_code_of_the_other_task_is_the_code_that_is_tested():
    tested = (ROOT / "test" / "study" / "planar_arm_test.cpp").read_text(encoding="utf-8")
    blocks = CODE.findall((ROOT / "doc" / "another_task.md").read_text(encoding="utf-8"))
    assert len(blocks) == 2
    for block in blocks:
        assert block in textwrap.dedent(tested) or textwrap.indent(block, "    ") in tested
