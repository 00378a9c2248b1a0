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
    failures = pathlib.Path(os.environ.get("GLASSBOX_FAILURES") or "golden-failures").absolute()
    page = failures / (name + ".html")
    page.unlink(missing_ok=True)  # that of an earlier failure
    program = os.environ.get("GLASSBOX_PROGRAM") or "glassbox"
    command = [program, "diff", str(GOLDEN / name), str(picture), *options]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode == 0:
        return
    if os.environ.get("GLASSBOX_APPROVE", "0") not in ("", "0"):
        run = subprocess.run([*command, "--approve"], capture_output=True, text=True)
        assert run.returncode == 0, run.stderr  # refused where CI is set
        return
    page.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run([*command, "--html", str(page)], capture_output=True)
    where = f"page: {page}\n" if page.exists() else ""  # there is none if an option is refused
    raise AssertionError(
        f"{run.stdout}{run.stderr}{where}"
        "If the picture is right, run the test again with GLASSBOX_APPROVE=1."
    )
