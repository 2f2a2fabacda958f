"""Xacro without the program xacro: what a file expands to, and what is refused."""
import math
from xml.dom import minidom

import pytest

from hexapod_repertoire import xacro_document
from hexapod_repertoire.xacro_macros import parameters_of
from hexapod_repertoire.xacro_values import XacroError

HEAD = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'


def expanded(folder, body, **arguments):
    """The expansion of a file with this body; its elements as a DOM."""
    file = folder / "r.urdf.xacro"
    file.write_text(HEAD + body + "</robot>", encoding="utf-8")
    return minidom.parseString(xacro_document.expand(file, arguments))


def names(document, tag="link"):
    return [node.getAttribute("name") for node in document.getElementsByTagName(tag)]


def refusal(folder, body, **arguments):
    with pytest.raises(XacroError) as problem:
        expanded(folder, body, **arguments)
    return str(problem.value)


@pytest.mark.parametrize("text, value", [
    ("${pi/2}", repr(math.pi / 2)), ("${-l}", "-0.1"), ("${2*l + 0.05} 0 ${l}", "0.25 0 0.1"),
    ("${1 if side == 'left' else -1}", "1"), ("${sin(radians(90))}", "1.0"),
    ("${10**2}", "100"), ("$${kept}", "${kept}"), ("${side}_hip", "left_hip"),
    ("${sizes['femur'][1]}", "0.3"), ("${sizes.coxa}", "0.05"), ("${side.upper()}", "LEFT"),
    ("${l > 0 and not l == 1}", "true"), ("${max(l, 3)}", "3"), ("$(eval 1 + 1)", "2"),
    ("${{'a': 1}['a']}", "1"), ("${'%d' % 3}", "3")])
def test_expressions_are_worked_out(tmp_path, text, value):
    document = expanded(tmp_path, f"""
      <xacro:property name="l" value="0.1"/>
      <xacro:property name="side" value="left"/>
      <xacro:property name="sizes" value="${{dict(coxa=0.05, femur=[0.2, 0.3])}}"/>
      <link name="{text}"/>""")
    assert names(document) == [value]


def test_properties_may_use_later_ones_and_take_the_file_s_value_last(tmp_path):
    document = expanded(tmp_path, """
      <xacro:property name="twice" value="${2 * length}"/>
      <xacro:property name="length" value="0.5"/>
      <link name="${twice}"/>
      <xacro:property name="length" default="7"/>
      <link name="${length}"/>""")
    assert names(document) == ["1.0", "0.5"]


LEG = """
  <xacro:macro name="leg" params="name side:=1 length:=${unit * 2} *origin **more">
    <joint name="${name}_hip"><xacro:insert_block name="origin"/></joint>
    <link name="${name}_${side}_${length}"><xacro:insert_block name="more"/></link>
  </xacro:macro>
  <xacro:property name="unit" value="0.1"/>
  <xacro:leg name="lf" side="-1"><origin xyz="0 ${unit} 0"/><more><a/><b/></more></xacro:leg>
  <xacro:leg name="rf" length="3"><origin xyz="1 0 0"/><more/></xacro:leg>
"""


def test_macros_take_parameters_defaults_and_blocks(tmp_path):
    document = expanded(tmp_path, LEG)
    assert names(document) == ["lf_-1_0.2", "rf_1_3"]
    assert names(document, "joint") == ["lf_hip", "rf_hip"]
    origins = document.getElementsByTagName("origin")
    assert [origin.getAttribute("xyz") for origin in origins] == ["0 0.1 0", "1 0 0"]
    assert [child.tagName for child in document.getElementsByTagName("link")[0].childNodes] == [
        "a", "b"]


def test_parameters_of_macros_are_read():
    assert parameters_of("a b:=1 c:='x y' d:=^|2 *e **f g := 3") == [
        (0, "a", None), (0, "b", "1"), (0, "c", "x y"), (0, "d", "^|2"), (1, "e", None),
        (2, "f", None), (0, "g", "3")]


def test_defaults_may_be_those_of_the_caller(tmp_path):
    document = expanded(tmp_path, """
      <xacro:macro name="inner" params="x:=^ y:=^|5"><link name="${x}_${y}"/></xacro:macro>
      <xacro:macro name="outer" params="x"><xacro:inner/></xacro:macro>
      <xacro:outer x="3"/>""")
    assert names(document) == ["3_5"]


def test_macros_that_call_themselves_end_by_a_condition(tmp_path):
    loop = """
      <xacro:macro name="loop" params="i">
        <link name="leg_${i}"/>
        <xacro:if value="${i &lt; 3}"><xacro:loop i="${i + 1}"/></xacro:if>
        <xacro:unless value="${i &lt; 3}"><joint name="last"/></xacro:unless>
      </xacro:macro>"""
    document = expanded(tmp_path, loop + '<xacro:loop i="0"/>')
    assert names(document) == ["leg_0", "leg_1", "leg_2", "leg_3"]
    assert names(document, "joint") == ["last"]
    assert "without end" in refusal(tmp_path, loop.replace("i &lt; 3", "True") +
                                    '<xacro:loop i="0"/>')


def test_macros_may_be_used_above_their_definition_and_the_last_one_counts_below(tmp_path):
    body = """
      <xacro:wheel name="a"/>
      <xacro:macro name="wheel" params="name"><link name="${name}_1"/></xacro:macro>
      <xacro:macro name="wheel" params="name"><link name="${name}_2"/></xacro:macro>
      <xacro:wheel name="b"/>"""
    assert names(expanded(tmp_path, body)) == ["a_1", "b_2"]


def test_tags_of_older_files_need_no_prefix(tmp_path):
    (tmp_path / "more.xacro").write_text(HEAD + """
      <macro name="leg" params="name *place">
        <joint name="${name}"><insert_block name="place"/></joint>
      </macro></robot>""")
    document = expanded(tmp_path, """
      <property name="length" value="0.5"/>
      <include filename="more.xacro"/>
      <leg name="left"><origin xyz="${length} 0 0"/></leg>
      <if value="${length > 1}"><link name="long"/></if>
      <unless value="${length > 1}"><link name="short"/></unless>
      <gazebo><property>kept</property></gazebo>""")
    assert names(document, "joint") == ["left"]
    assert document.getElementsByTagName("origin")[0].getAttribute("xyz") == "0.5 0 0"
    assert names(document) == ["short"]
    assert document.getElementsByTagName("property")[0].firstChild.data == "kept"


def test_arguments_files_and_packages_are_found(tmp_path):
    urdf = tmp_path / "my_description" / "urdf"
    urdf.mkdir(parents=True)
    (urdf / "parts.xacro").write_text(HEAD + """
      <xacro:property name="sizes"
        value="${xacro.load_yaml('$(find my_description)/urdf/sizes.yaml')}"/>
      <xacro:macro name="part" params=""><link name="${sizes['mass']}"/></xacro:macro></robot>""")
    (urdf / "sizes.yaml").write_text("mass: 1.5\n")
    body = """
      <xacro:arg name="prefix" default="a"/>
      <xacro:include filename="$(find my_description)/urdf/parts.xacro"/>
      <xacro:part/>
      <link name="$(arg prefix)_link"/>"""
    assert names(expanded(urdf, body)) == ["1.5", "a_link"]
    assert names(expanded(urdf, body, prefix="b")) == ["1.5", "b_link"]


@pytest.mark.parametrize("body, says", [
    ('<link name="${length}"/>', "'length' is not defined"),
    ("<xacro:leg/>", "<xacro:leg> is no macro"),
    ("<xacro:element xacro:name='x'/>", "<xacro:element> is no macro"),
    ('<link name="$(arg side)"/>', "side:=.."),
    ('<link name="$(find nowhere_at_all)"/>', "nowhere_at_all is not found"),
    ('<xacro:if value="perhaps"/>', "'perhaps'"),
    ('<link name="${1/0}"/>', "cannot be worked out"),
    ('<link name="${9**9**9}"/>', "too high"),
    ('<link name="${().__class__}"/>', "'.__class__' is not known"),
    ('<link name="${open(1)}"/>', "'open' is not defined"),
    ('<xacro:include filename="nowhere.xacro"/>', "nowhere.xacro cannot be read"),
    ('<xacro:macro name="m" params="a"/><xacro:m/>', "'a' is missing"),
    ('<xacro:macro name="m" params="a"/><xacro:m a="1" b="2"/>', "has no parameter b"),
    ('<xacro:macro name="m" params="*a"/><xacro:m/>', "the block 'a' is missing"),
    ('<xacro:property name="a" value="${b}"/><xacro:property name="b" value="${a}"/>'
     '<link name="${a}"/>', "is not defined")])
def test_what_is_wrong_is_told(tmp_path, body, says):
    assert says in refusal(tmp_path, body)
