# Takes questions as Python values; gives the answers of billiards-sim, and a table that a test records.
import json
import math
import pathlib
import re
import subprocess
import tempfile

RADIUS_M = 0.028575


class Engine:
    """The programs of one build's bin folder."""

    def __init__(self, folder):
        self.program = folder / "billiards-sim"
        self.tests = folder / "physics_test"

    def ask(self, subcommand, cases):
        """One run for all cases; an answer each, or the first error."""
        lines = "\n".join(json.dumps(case) for case in cases) + "\n"
        run = subprocess.run([self.program, subcommand, "--jsonl"], input=lines, text=True,
                             capture_output=True, check=True)
        answers = [json.loads(line) for line in run.stdout.splitlines()]
        for answer in answers:
            if "error" in answer:
                raise RuntimeError(f"{subcommand}: {answer['error']}")
        return answers

    def classic_errors_m(self):
        """By frames a second: how far the original's own algorithm is from the preset `classic`."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "report.json"
            subprocess.run([self.tests, "--gtest_filter=Classic.*", f"--gtest_output=json:{path}"],
                           stdout=subprocess.DEVNULL, check=True)
            report = path.read_text(encoding="utf-8")
        found = re.findall(r'"error_m_at_(\d+)_hz": "([^"]+)"', report)
        return [(int(rate), float(error)) for rate, error in found]

    def solve(self, cases):
        return self.ask("solve", cases)

    def solve_at_events(self, case):
        """The answer, with samples at 0 and at every event: between them lie the record's segments."""
        first = self.solve([case])[0]
        times = sorted({0.0, first["duration_s"], *(event["t"] for event in first["events"])})
        return self.solve([{**case, "sample_times_s": times}])[0]


def balls_of(event):
    return event["balls"] if "balls" in event else [event["ball"]]


def on_slate(x, y):
    return [x, y, RADIUS_M]


def rolling_spin(velocity):
    """w = (z x v) / R."""
    return [-velocity[1] / RADIUS_M, velocity[0] / RADIUS_M, 0.0]


def angle_deg(vector):
    return math.degrees(math.atan2(vector[1], vector[0]))


def speed(vector):
    return math.hypot(vector[0], vector[1])
