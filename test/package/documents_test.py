"""The documents: their links lead somewhere, and the code in them is code that is tested."""
import pathlib
import re
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


def test_the_code_of_the_other_task_is_the_code_that_is_tested():
    tested = (ROOT / "test" / "study" / "planar_arm_test.cpp").read_text(encoding="utf-8")
    blocks = CODE.findall((ROOT / "doc" / "another_task.md").read_text(encoding="utf-8"))
    assert len(blocks) == 2
    for block in blocks:
        assert block in textwrap.dedent(tested) or textwrap.indent(block, "    ") in tested
