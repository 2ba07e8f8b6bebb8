#!/usr/bin/env python3
"""Applies the mutations of tests/mutations one at a time and reports which of them the tests notice.

All happens in build/mutate: `tree`, a copy of the sources; `build`, with an executable for each file of tests; and
results.json. So a run that is broken off leaves nothing behind, and --resume goes on with it: what was noticed stays
so while the file, its mirrored tests and the mutation are the same, what was not while no source at all has changed.

The mirrored tests of the mutated file run first, and only if they pass all unit and statistical tests, room by room.
Exit code: 0, or 1 if a mutation goes unnoticed or does not compile.
"""

import argparse
import contextlib
import dataclasses
import fcntl
import hashlib
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator

import mutation_list
from mutation_list import Mutation

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORK = ROOT / "build" / "mutate"
TREE, BUILD, RESULTS = WORK / "tree", WORK / "build", WORK / "results.json"
JOBS = len(os.sched_getaffinity(0))
# A safety net for loops that a mutation makes endless: so much longer than without it, and then some.
SLOWER, SECONDS_MORE = 10.0, 30.0

MIRRORED, WHOLE, SURVIVED, BROKEN = "mirrored test", "whole suite", "survived", "does not compile"
PASSES = "passes its mirrored tests"  # the whole suite has not run yet


class Failure(Exception):
    """What ends the run."""


@dataclasses.dataclass
class Result:
    verdict: str  # MIRRORED or WHOLE: which noticed it; SURVIVED, BROKEN, PASSES
    by: str = ""  # the test that failed
    seconds: float = 0.0
    fingerprint: str = ""  # of the file, its mirrored tests and the mutation
    sources: str = ""  # of all sources


# --- The copy of the sources ------------------------------------------------------------------------------------


def sources(root: pathlib.Path) -> dict[str, pathlib.Path]:
    """All files but what is hidden or built."""
    files = {}
    for top in root.iterdir():
        if top.name.startswith(".") or top.name == "build":
            continue
        for path in [top] if top.is_file() else top.rglob("*"):
            if path.is_file() and "__pycache__" not in path.parts:
                files[str(path.relative_to(root))] = path
    return files


def synchronise() -> str:
    """Makes the copy equal, touching nothing that is equal already; the fingerprint of all."""
    TREE.mkdir(parents=True, exist_ok=True)
    wanted, present = sources(ROOT), sources(TREE)
    for name in present.keys() - wanted.keys():
        present[name].unlink()
    whole = hashlib.sha256()
    for name in sorted(wanted):
        content = wanted[name].read_bytes()
        whole.update(name.encode() + b"\0" + hashlib.sha256(content).digest())
        if name not in present or present[name].read_bytes() != content:
            (TREE / name).parent.mkdir(parents=True, exist_ok=True)
            (TREE / name).write_bytes(content)
    return whole.hexdigest()


def fingerprint_of(mutation: Mutation) -> str:
    parts = [mutation.file, mutation.search, mutation.replacement, (TREE / mutation.file).read_text()]
    parts += [(TREE / "tests" / f"{test}.cpp").read_text() for test in mutation.tests]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()


# --- Building and running ---------------------------------------------------------------------------------------


def run(command: list[str], cwd: pathlib.Path, timeout: float | None = None) -> tuple[int, str]:
    """Exit code and output; with its children it ends at the timeout, which counts as code -1."""
    process = subprocess.Popen(command, cwd=cwd, text=True, errors="replace", start_new_session=True,
                               stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    try:
        output, _ = process.communicate(timeout=timeout)
        return process.returncode, output
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        output, _ = process.communicate()
        return -1, output + "\ntimeout"
    except BaseException:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        raise


def configure() -> None:
    # Compiling is most of the work, so it is worth optimising less; but the statistical tests must run too.
    code, output = run(["cmake", "-S", str(TREE), "-B", str(BUILD), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", "-DSTERADIAN_TESTS=ON",
                        "-DSTERADIAN_TEST_PER_FILE=ON", "-DSTERADIAN_ARCH=native"], ROOT)
    if code != 0:
        raise Failure(f"cmake failed:\n{output}")


def executable(test: str) -> pathlib.Path:
    return BUILD / "tests" / f"tests_{test.replace('/', '_')}"


def build(tests: list[str]) -> tuple[bool, str]:
    targets = [option for test in tests for option in ("--target", executable(test).name)]
    code, output = run(["cmake", "--build", str(BUILD), "--parallel", str(JOBS), *targets], ROOT)
    return code == 0, output


def failure_of(test: str, timeout: float | None = None) -> str:
    """Which test of the file fails; empty if none does."""
    code, output = run([str(executable(test)), "--gtest_brief=1", "--gtest_fail_fast"], BUILD, timeout)
    if code == 0:
        return ""
    named = re.search(r"\[  FAILED  \] (\w+[./]\w[\w./]*)", output)
    how = named[1] if named else "timeout" if code == -1 else f"exit code {code}"
    return f"{test}: {how}"


ROOMS = ("core", "accel/shapes", "accel", "materials", "lights", "integrators")  # from the inside out, as includes point


def room_of(test: str) -> str:
    """The room that a test, "core/film/film_test", belongs to."""
    for room in ROOMS:
        if test.startswith(room + "/"):
            return room
    return test.partition("/")[0]


def all_tests() -> list[str]:
    """The unit and statistical tests."""
    tests = TREE / "tests"
    names = [str(path.relative_to(tests).with_suffix("")) for path in sorted(tests.rglob("*_test.cpp"))]
    return [name for name in names if not re.search("_(render|cli|book)_test$", name)]


def rooms() -> list[str]:
    found = {room_of(test) for test in all_tests()}
    return [room for room in ROOMS if room in found] + sorted(found.difference(ROOMS))


def tests_of(room: str) -> list[str]:
    return [test for test in all_tests() if room_of(test) == room]


@contextlib.contextmanager
def applied(mutation: Mutation) -> Iterator[None]:
    """Changes the copy of the file, and takes it back."""
    path = TREE / mutation.file
    original = path.read_text()
    try:
        path.write_text(original.replace(mutation.search, mutation.replacement))
        yield
    finally:
        path.write_text(original)


class Runner:
    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}  # of the tests that are known to pass without a mutation

    def expect_green(self, tests: list[str]) -> None:
        """A test that fails anyway would notice every mutation."""
        unknown = [test for test in tests if test not in self.seconds]
        if not unknown:
            return
        good, output = build(unknown)
        if not good:
            raise Failure(f"without a mutation there is an error:\n{output[-4000:]}")
        for test in unknown:
            start = time.monotonic()
            failure = failure_of(test)
            if failure:
                raise Failure(f"without a mutation there fails {failure}")
            self.seconds[test] = time.monotonic() - start

    def first_failure(self, tests: list[str]) -> str:
        for test in tests:
            failure = failure_of(test, SLOWER * self.seconds[test] + SECONDS_MORE)
            if failure:
                return failure
        return ""

    def judge_mirrored(self, mutation: Mutation) -> Result:
        self.expect_green(list(mutation.tests))
        with applied(mutation):
            for test in mutation.tests:
                good, output = build([test])
                if not good:
                    return Result(BROKEN, output[-4000:])
                failure = self.first_failure([test])
                if failure:
                    return Result(MIRRORED, failure)
        return Result(PASSES)

    def judge_whole(self, mutation: Mutation) -> Result:
        self.expect_green([test for room in rooms() for test in tests_of(room)])
        own = room_of(mutation.tests[0])
        with applied(mutation):
            for room in sorted(rooms(), key=lambda room: room != own):
                tests = [test for test in tests_of(room) if test not in mutation.tests]
                before = {test: executable(test).stat().st_mtime_ns for test in tests}
                good, output = build(tests)
                if not good:
                    return Result(BROKEN, output[-4000:])
                # What has not been linked again cannot fail.
                failure = self.first_failure([t for t in tests if executable(t).stat().st_mtime_ns != before[t]])
                if failure:
                    return Result(WHOLE, failure)
        return Result(SURVIVED)


# --- Results ----------------------------------------------------------------------------------------------------


def load_results() -> dict[str, Result]:
    if not RESULTS.is_file():
        return {}
    return {name: Result(**fields) for name, fields in json.loads(RESULTS.read_text()).items()}


def save_results(results: dict[str, Result]) -> None:
    text = json.dumps({name: dataclasses.asdict(result) for name, result in results.items()}, indent=1)
    unfinished = RESULTS.with_suffix(".part")
    unfinished.write_text(text)
    unfinished.replace(RESULTS)


def still_holds(result: Result, fingerprint: str, whole: str) -> bool:
    """Whether an earlier result says something about the present sources."""
    if result.verdict in (SURVIVED, WHOLE):
        return result.sources == whole
    return result.verdict in (MIRRORED, PASSES) and result.fingerprint == fingerprint


def print_summary(mutations: list[Mutation], results: dict[str, Result]) -> None:
    present = {results[mutation.name].verdict for mutation in mutations}
    verdicts = [v for v in (MIRRORED, WHOLE, SURVIVED, BROKEN, PASSES) if v in present]
    files = list(dict.fromkeys(mutation.file for mutation in mutations))
    width = max(len(file) for file in files)
    print(f"\n{'file':{width}}  " + "  ".join(f"{verdict:>13}" for verdict in verdicts))
    for file in [*files, "all"]:
        own = [results[m.name].verdict for m in mutations if file in (m.file, "all")]
        print(f"{file:{width}}  " + "  ".join(f"{own.count(v):{max(13, len(v))}}" for v in verdicts))
    for mutation in mutations:
        verdict = results[mutation.name].verdict
        if verdict not in (MIRRORED, WHOLE):
            print(f"{verdict}: {mutation.name}")
            print("\n".join(f"  - {line}" for line in mutation.search.splitlines()))
            print("\n".join(f"  + {line}" for line in mutation.replacement.splitlines()))


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="dev mutate", description="Which small faults do the tests notice?")
    parser.add_argument("--filter", metavar="TEXT", default="", help="only those whose file or description has TEXT")
    parser.add_argument("--resume", action="store_true", help="go on with a run that was broken off")
    parser.add_argument("--mirrored", action="store_true", help="leave out the whole suites")
    parser.add_argument("--list", action="store_true", help="list the mutations and do nothing")
    return parser.parse_args()


def judge_all(mutations: list[Mutation], resume: bool, mirrored_only: bool) -> dict[str, Result]:
    """Reports each result at once and keeps it in the file. First the mirrored tests of all, then the rest."""
    sources_now = synchronise()
    configure()
    results, runner = load_results(), Runner()

    def judge(number: int, mutation: Mutation, how: Callable[[Mutation], Result]) -> None:
        start = time.monotonic()
        result = how(mutation)
        result.seconds = round(time.monotonic() - start, 1)
        result.fingerprint, result.sources = fingerprint_of(mutation), sources_now
        results[mutation.name] = result
        save_results(results)
        progress = f"{number:4}/{len(mutations)} {result.seconds:6.1f} s"
        print(f"{progress}  {mutation.name}: {result.verdict} {result.by}", flush=True)

    for number, mutation in enumerate(mutations, 1):
        known = results.get(mutation.name)
        if not (resume and known and still_holds(known, fingerprint_of(mutation), sources_now)):
            judge(number, mutation, runner.judge_mirrored)
    for number, mutation in enumerate(mutations, 1):
        if results[mutation.name].verdict == PASSES and not mirrored_only:
            judge(number, mutation, runner.judge_whole)
    return results


def main() -> int:
    chosen = arguments()
    mutations = [m for m in mutation_list.read_lists(ROOT) if chosen.filter in m.name]
    if not mutations:
        raise Failure(f"no mutation has \"{chosen.filter}\" in its name")
    if chosen.list:
        for mutation in mutations:
            print(f"{mutation.name}  [{' '.join(mutation.tests)}]")
        return 0
    WORK.mkdir(parents=True, exist_ok=True)
    with open(WORK / "lock", "w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Failure("another run is at work here") from None
        results = judge_all(mutations, chosen.resume, chosen.mirrored)
    print_summary(mutations, results)
    return 0 if all(results[m.name].verdict in (MIRRORED, WHOLE) for m in mutations) else 1


def break_off(*_) -> None:
    raise KeyboardInterrupt


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, break_off)
    try:
        sys.exit(main())
    except (Failure, mutation_list.ListError) as error:
        print(f"mutate: {error}", file=sys.stderr)
        sys.exit(1)
    except BrokenPipeError:
        sys.stdout = None  # the reader has closed the pipe
        sys.exit(1)
    except KeyboardInterrupt:
        print("mutate: broken off; --resume goes on", file=sys.stderr)
        sys.exit(130)
