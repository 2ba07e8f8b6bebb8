"""The lists of mutations: small faults that the tests have to notice.

    == core/sampling/warp.h
    A comment for people follows a hash sign.
    Sphere: the radius of a circle of latitude is not halved      <- what is wrong
    - F(2.0f) * u.x                                               <- text that stands exactly once in the file
    + u.x                                                         <- what it becomes

Several lines with - or + are one text of several lines. The tests that mirror a file run first; where there are none of
its name, or better ones, the heading names them: == core/samplers/owen.h: core/samplers/sobol_test core/sobol_stat_test
"""

import dataclasses
import pathlib


@dataclasses.dataclass(frozen=True)
class Mutation:
    file: str  # from the root of the project
    tests: tuple[str, ...]  # "core/sampling/warp_test", ...: run first
    description: str
    search: str
    replacement: str
    line: int = 0  # in the list

    @property
    def name(self) -> str:
        return f"{self.file}: {self.description}"


class ListError(Exception):
    """A list that cannot be read or does not fit the sources; one problem per line."""


def mirrored_tests(root: pathlib.Path, file: str) -> tuple[str, ...]:
    """The tests of the same name: core/film/x.h has tests/core/film/x_test.cpp and x_stat_test.cpp."""
    names = [f"{pathlib.Path(file).with_suffix('')}{kind}" for kind in ("_test", "_stat_test")]
    return tuple(name for name in names if (root / "tests" / f"{name}.cpp").is_file())


def parse(text: str, root: pathlib.Path, source: str) -> list[Mutation]:
    """The mutations of one list; `source` is its name in messages."""
    mutations, problems = [], []
    file, tests, description, start = "", (), "", 0
    search: list[str] = []
    replacement: list[str] = []

    def finish() -> None:
        nonlocal description, search, replacement
        if description and not search:
            problems.append(f"{source}:{start}: \"{description}\" has no text to search for")
        elif description:
            mutations.append(Mutation(file, tests, description, "\n".join(search), "\n".join(replacement), start))
        description, search, replacement = "", [], []

    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("== "):
            finish()
            file, _, named = line[3:].partition(":")
            file = file.strip()
            tests = tuple(named.split()) or mirrored_tests(root, file)
        elif line.startswith("- ") and description and not replacement:
            search.append(line[2:])
        elif line.startswith("+ ") and search:
            replacement.append(line[2:])
        elif line.strip() and line[0] not in "#+-" and file:
            finish()
            description, start = line.strip(), number
        elif line.strip() and not line.startswith("#"):
            problems.append(f"{source}:{number}: out of place: {line}")
    finish()
    if problems:
        raise ListError("\n".join(problems))
    return mutations


def problems_of(mutations: list[Mutation], root: pathlib.Path) -> list[str]:
    """What is stale or wrong about them."""
    problems = []
    seen = set()
    for mutation in mutations:
        if mutation.name in seen:
            problems.append(f"{mutation.name}: listed twice")
        seen.add(mutation.name)
        if mutation.search == mutation.replacement:
            problems.append(f"{mutation.name}: changes nothing")
        if not mutation.tests:
            problems.append(f"{mutation.name}: no test mirrors the file; name one in its heading")
        for test in mutation.tests:
            if not (root / "tests" / f"{test}.cpp").is_file():
                problems.append(f"{mutation.name}: there is no tests/{test}.cpp")
        if not (root / mutation.file).is_file():
            problems.append(f"{mutation.name}: there is no such file")
            continue
        found = (root / mutation.file).read_text().count(mutation.search)
        if found != 1:
            problems.append(f"{mutation.name}: its text occurs {found} times, not once: {mutation.search}")
    return problems


def read_lists(root: pathlib.Path) -> list[Mutation]:
    """All lists of tests/mutations, checked. Raises ListError."""
    mutations = []
    for path in sorted((root / "tests" / "mutations").glob("*.txt")):
        mutations += parse(path.read_text(), root, path.name)
    problems = problems_of(mutations, root)
    if problems:
        raise ListError("\n".join(problems))
    return mutations
