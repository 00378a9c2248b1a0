"""Golden images for tests in Python. Needs the standard library and the program glassbox."""

import os
import pathlib
import subprocess

GOLDEN = pathlib.Path(__file__).parent / "golden"


def assert_matches_golden(picture, name, *options):
    """Fails unless the picture file equals the golden image of this name.

    The options are those of `glassbox diff`. GLASSBOX_APPROVE=1 makes a picture that differs, or is
    new, the golden image.
    """
    program = os.environ.get("GLASSBOX_PROGRAM") or "glassbox"
    command = [program, "diff", str(GOLDEN / name), str(picture), *options]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode == 0:
        return
    if os.environ.get("GLASSBOX_APPROVE", "0") not in ("", "0"):
        run = subprocess.run([*command, "--approve"], capture_output=True, text=True)
        assert run.returncode == 0, run.stderr  # refused where CI is set
        return
    failures = pathlib.Path(os.environ.get("GLASSBOX_FAILURES") or "golden-failures").absolute()
    page = failures / (name + ".html")
    page.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run([*command, "--html", str(page)], capture_output=True)
    raise AssertionError(
        f"{run.stdout}{run.stderr}page: {page}\n"
        "If the picture is right, run the test again with GLASSBOX_APPROVE=1."
    )
