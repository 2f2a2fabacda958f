"""One list of dependencies: package.xml, packages.txt, CMake and the sources agree."""
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
# What CMake or pkg-config calls a library, and what package.xml calls it.
NAME_IN_PACKAGE_XML = {
    "Eigen3": "eigen", "TBB": "tbb", "ode": "opende", "urdfdom": "liburdfdom-dev",
    "GTest": "gtest", "MPI": "mpi", "Qt5": "qtbase5-dev", "pybind11": "pybind11-dev",
}
# Parts of CMake, of the compiler, of [tools], or what the headers of pluginlib and rviz include.
NOT_DEPENDENCIES = {"PkgConfig", "Threads", "catkin", "class_loader", "rcpputils", "rcutils",
                    "OgreMain", "OgrePlane"}
# Python modules whose Debian package is called otherwise in package.xml.
MODULE_IN_PACKAGE_XML = {
    "numpy": "python3-numpy", "matplotlib": "python3-matplotlib",
    "mpl_toolkits": "python3-matplotlib", "yaml": "python3-yaml",
    "pytest": "python3-pytest", "scipy": "python3-scipy", "setuptools": "python3-setuptools",
    "catkin_pkg": "catkin",
    "tf": "tf", "tf2_ros": "tf2_ros",
}
OWN = {"hexapod_repertoire"}


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def files(*patterns):
    return [file for folder in ("src", "test") for pattern in patterns
            for file in sorted((ROOT / folder).rglob(pattern))]


def package():
    return pytest.importorskip("catkin_pkg.package").parse_package(str(ROOT))


def names(dependencies):
    return {dependency.name for dependency in dependencies}


def all_names():
    declared = package()
    return names(declared.buildtool_depends + declared.build_depends + declared.exec_depends
                 + declared.build_export_depends + declared.test_depends)


def debian_groups():
    groups = {}
    for line in read("packages.txt").splitlines():
        if line.startswith("["):
            group = groups.setdefault(line.strip("[]"), {})
        elif line and not line.startswith("#"):
            key, _, packages = line.partition(": ")
            assert key not in group, f"packages.txt names {key} twice"
            group[key] = packages.split()
    return groups


def found_by_cmake():
    text = "\n".join(re.sub("#.*", "", file.read_text(encoding="utf-8"))
                     for file in [ROOT / "CMakeLists.txt", *files("CMakeLists.txt")])
    found = set(re.findall(r"find_package\(([\w-]+)", text))
    found |= set(re.findall(r"pkg_check_modules\([^)]*?([\w-]+)\)", text))
    found |= set(re.findall(r"find_(?:path|library)\(\w+ (\w+)", text))
    for components in re.findall(r"find_package\(catkin[^)]*COMPONENTS([^)]*)\)", text):
        found |= set(components.split())
    return {NAME_IN_PACKAGE_XML.get(name, name) for name in found - NOT_DEPENDENCIES}


def test_debian_packages_serve_exactly_the_dependencies_of_package_xml():
    groups = debian_groups()
    assert set(groups) == {"tools", "package.xml", "display", "checks"}
    assert set(groups["package.xml"]) | set(groups["display"]) == all_names()
    assert all(packages for group in groups.values() for packages in group.values())


def test_no_debian_package_is_listed_twice():
    listed = [name for group in debian_groups().values() for names_ in group.values()
              for name in names_]
    assert sorted(listed) == sorted(set(listed))


def test_cmake_finds_exactly_the_build_dependencies():
    declared = package()
    for_cmake = names(declared.build_depends) | names(declared.test_depends)
    found = found_by_cmake()
    undeclared = found - for_cmake
    assert not undeclared
    unused = names(declared.build_depends) - found
    assert not unused


def test_headers_of_ros_packages_come_from_declared_dependencies():
    declared = names(package().build_depends)
    used = {header for file in files("*.h", "*.cpp")
            for header in re.findall(r"#include <(\w+(?:_msgs|_srvs|_ros)|tf2\w*|actionlib)/",
                                     file.read_text(encoding="utf-8"))}
    undeclared = used - declared
    assert not undeclared


def test_python_imports_come_from_declared_dependencies():
    declared = all_names()
    standard = getattr(sys, "stdlib_module_names", None)
    if standard is None:
        pytest.skip("this Python does not list its standard library")
    local = {name for file in files("*.py") for name in (file.stem, file.parent.name)} | OWN
    local |= {file.stem for file in (ROOT / "doc").glob("*.py")}
    used = {module for file in files("*.py")
            for module in re.findall(r"^\s*(?:import|from) (\w+)", file.read_text(encoding="utf-8"),
                                     re.MULTILINE)} - set(standard) - local
    undeclared = {MODULE_IN_PACKAGE_XML.get(module, module) for module in used} - declared
    assert not undeclared


def test_nodes_of_launch_files_come_from_declared_dependencies():
    used = {name for file in (ROOT / "launch").glob("*.launch")
            for name in re.findall(r'pkg="(\w+)"', file.read_text(encoding="utf-8"))}
    undeclared = used - OWN - names(package().exec_depends)
    assert not undeclared


def test_catkin_lint_is_content():
    if not shutil.which("catkin_lint"):
        pytest.skip("catkin_lint is not installed")
    result = subprocess.run(
        ["catkin_lint", "--offline", "--strict", str(ROOT)],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, check=False)
    assert result.returncode == 0, result.stdout
