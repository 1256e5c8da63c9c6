from itertools import groupby

from repository import ROOT, packages, source_files


def test_groups_are_those_that_the_installer_knows():
    assert [group for group, _ in groupby(packages(), key=lambda line: line[0])] == ["build", "test"]


def test_no_package_is_listed_twice():
    names = [package for _, package, _ in packages()]
    assert sorted(names) == sorted(set(names))


def test_each_group_is_sorted():
    for _, lines in groupby(packages(), key=lambda line: line[0]):
        names = [package for _, package, _ in lines]
        assert names == sorted(names)


def test_each_package_is_used():
    listed = ROOT / "deploy/packages.txt"
    kinds = (".cpp", ".h", ".txt", ".cmake", ".json", ".py", ".ts", "run", "install", "test")
    text = "\n".join(path.read_text(errors="replace") for path in source_files(*kinds) if path != listed)
    unused = [f"{package}: {mark}" for _, package, mark in packages() if not mark or mark not in text]
    assert unused == []
