import subprocess

from golden import assert_matches_golden


def test_cube(tmp_path):
    picture = tmp_path / "cube.png"  # made by your own program, in place of this one
    subprocess.run(["glassbox", "render", "cube", "--size", "96x64", "-o", picture], check=True)
    assert_matches_golden(picture, "cube.png", "--max-differing", "0.1%")
