#!/usr/bin/python3
"""How far `glassbox diff` and metrics.py, beside this file, agree on real pictures.

    python3 tests/metrics/reference/agree.py GLASSBOX images/golden ../shared/assets

Every PNG and JPEG below the folders is compared with itself after JPEG compression, and with the picture before it that
has its size and channels. Prints the largest disagreement for each metric.
"""
import json
import os
import subprocess
import sys
import tempfile

from PIL import Image

sys.dont_write_bytecode = True
import metrics  # noqa: E402

LARGEST = 640  # px; the two-dimensional kernels take their time


def pictures(folder):
    for place, _, names in sorted(os.walk(folder)):
        for name in sorted(names):
            if name.lower().endswith((".png", ".jpg")):
                image = Image.open(os.path.join(place, name))
                if max(image.size) <= LARGEST and image.mode in ("L", "RGB", "RGBA"):
                    yield image


def compressed(image, path):
    image.convert("RGB").save(path, quality=60)
    result = Image.open(path).convert(image.mode)
    if image.mode == "RGBA":
        result.putalpha(image.getchannel("A"))
    return result


def glassbox_metrics(program, reference, test):
    words = [program, "diff", reference, test, "--metric", "absmax,rmse,psnr,ssim,flip", "--json", "-"]
    report = json.loads(subprocess.run(words, capture_output=True).stdout)
    return {metric["name"]: float(metric["value"]) for metric in report["pictures"][0]["metrics"] if "value" in metric}


def main(program, folders):
    worst, count = {}, 0
    with tempfile.TemporaryDirectory() as place:
        reference, test, jpeg = [os.path.join(place, name) for name in ("a.png", "b.png", "c.jpg")]
        last = {}
        for image in (image for folder in folders for image in pictures(folder)):
            image.save(reference)
            for other in (compressed(image, jpeg), last.get((image.size, image.mode))):
                if other is None:
                    continue
                other.save(test)
                count += 1
                ours = glassbox_metrics(program, reference, test)
                for name, value in metrics.values(metrics.read(reference), metrics.read(test)).items():
                    if ours[name] != value:  # infinities among them
                        worst[name] = max(worst.get(name, 0), abs(ours[name] - value))
            last[image.size, image.mode] = image
    print(f"{count} pairs; largest disagreement:")
    for name, difference in worst.items():
        print(f"  {name:12} {difference:.1e}")


main(sys.argv[1], sys.argv[2:])
