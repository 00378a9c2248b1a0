#!/usr/bin/python3
"""SSIM and LDR-FLIP a second time, written from the papers in double precision: what the C++ is compared with.

    apt-get install python3-numpy python3-scipy python3-skimage python3-pil
    python3 tests/metrics/reference/metrics.py REFERENCE.png TEST.png                the metrics of two files
    python3 tests/metrics/reference/metrics.py > tests/metrics/reference/values.txt   what agreement_test.cpp reads

Nothing is separable here: the kernels are two-dimensional, as the paper has them, and scipy.ndimage convolves. Colour
spaces come from the definitions of their primaries and white, SSIM from scikit-image.
"""
import os
import sys

import numpy as np
import scipy.ndimage
import skimage.metrics
from PIL import Image

PIXELS_PER_DEGREE = 0.7 * (3840 / 0.7) * np.pi / 180
WHITE_XY = (0.31271, 0.32902)
PRIMARIES_XY = ((0.64, 0.33), (0.30, 0.60), (0.15, 0.06))  # ITU-R BT.709


def xyz_of_xy(xy):
    return np.array([xy[0] / xy[1], 1.0, (1 - xy[0] - xy[1]) / xy[1]])


WHITE = xyz_of_xy(WHITE_XY)
PRIMARIES = np.stack([xyz_of_xy(xy) for xy in PRIMARIES_XY], axis=1)
XYZ_FROM_RGB = PRIMARIES * np.linalg.solve(PRIMARIES, WHITE)


def linear_of_srgb(c):
    return np.where(c <= 0.04045, c / 12.92, ((np.maximum(c, 0.04045) + 0.055) / 1.055) ** 2.4)


def ycxcz_of_linear(rgb):
    x, y, z = np.moveaxis(rgb @ XYZ_FROM_RGB.T / WHITE, -1, 0)
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=-1)


def linear_of_ycxcz(ycxcz):
    y = (ycxcz[..., 0] + 16) / 116
    xyz = np.stack([y + ycxcz[..., 1] / 500, y, y - ycxcz[..., 2] / 200], axis=-1) * WHITE
    return xyz @ np.linalg.inv(XYZ_FROM_RGB).T


def hunt_lab_of_linear(rgb):
    t = rgb @ XYZ_FROM_RGB.T / WHITE
    delta = 6 / 29
    f = np.where(t > delta**3, np.cbrt(t), t / (3 * delta**2) + 4 / 29)
    lightness = 116 * f[..., 1] - 16
    a = 500 * (f[..., 0] - f[..., 1])
    b = 200 * (f[..., 1] - f[..., 2])
    return np.stack([lightness, 0.01 * lightness * a, 0.01 * lightness * b], axis=-1)


def hyab(p, q):
    d = p - q
    return np.abs(d[..., 0]) + np.hypot(d[..., 1], d[..., 2])


def convolve(plane, kernel):
    return scipy.ndimage.convolve(plane, kernel, mode="nearest")


def contrast_kernels():
    """Table 1 and section 4.1.1: lightness, red-green, blue-yellow."""
    tables = [((1, 0.0047),), ((1, 0.0053),), ((34.1, 0.04), (13.5, 0.025))]
    radius = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi**2)) * PIXELS_PER_DEGREE))
    y, x = np.mgrid[-radius : radius + 1, -radius : radius + 1] / PIXELS_PER_DEGREE
    for table in tables:
        kernel = sum(a * np.sqrt(np.pi / b) * np.exp(-np.pi**2 * (x * x + y * y) / b) for a, b in table)
        yield kernel / kernel.sum()


def feature_kernels():
    """Section 4.2: the derivatives of a Gaussian along x that find edges and points."""
    sigma = 0.5 * 0.082 * PIXELS_PER_DEGREE
    radius = int(np.ceil(3 * sigma))
    y, x = np.mgrid[-radius : radius + 1, -radius : radius + 1]
    gaussian = np.exp(-(x * x + y * y) / (2 * sigma**2))
    for kernel in (-x * gaussian, (x * x / sigma**2 - 1) * gaussian):
        yield np.where(kernel > 0, kernel / kernel[kernel > 0].sum(), kernel / -kernel[kernel < 0].sum())


def flip_of_linear(reference, test):
    """The error of every pixel; both pictures (height, width, 3) in linear sRGB."""
    seen, strengths = [], []
    for picture in (reference, test):
        ycxcz = ycxcz_of_linear(picture)
        filtered = np.stack([convolve(ycxcz[..., i], k) for i, k in enumerate(contrast_kernels())], axis=-1)
        seen.append(hunt_lab_of_linear(np.clip(linear_of_ycxcz(filtered), 0, 1)))
        y = (ycxcz[..., 0] + 16) / 116
        strengths.append([np.hypot(convolve(y, k), convolve(y, k.T)) for k in feature_kernels()])
    colour = hyab(*seen) ** 0.7
    largest = hyab(hunt_lab_of_linear(np.array([0.0, 1, 0])), hunt_lab_of_linear(np.array([0.0, 0, 1]))) ** 0.7
    turn = 0.4 * largest
    colour = np.where(colour < turn, 0.95 / turn * colour, 0.95 + (colour - turn) / (largest - turn) * 0.05)
    feature = np.maximum(*[np.abs(a - b) for a, b in zip(*strengths)])
    return colour ** (1 - (feature / np.sqrt(2)) ** 0.5)


def over(picture, background):
    """Linear RGB of a picture (height, width, channels) in [0, 1], alpha last where it has 2 or 4 channels."""
    channels = picture.shape[-1]
    colours = picture[..., :-1] if channels in (2, 4) else picture
    linear = linear_of_srgb(np.broadcast_to(colours, colours.shape[:2] + (3,)))
    if channels in (1, 3):
        return linear
    alpha = picture[..., -1:]
    return alpha * linear + (1 - alpha) * background


def flip(reference, test):
    return np.maximum(*[flip_of_linear(over(reference, b), over(test, b)) for b in (0.0, 1.0)])


def ssim(reference, test):
    """Mean and smallest over the windows wholly inside; all channels."""
    _, windows = skimage.metrics.structural_similarity(
        reference, test, gaussian_weights=True, sigma=1.5, use_sample_covariance=False, data_range=1,
        channel_axis=-1, full=True)
    inside = windows[5:-5, 5:-5]
    return inside.mean(), inside.min()


def values(reference, test):
    errors = flip(reference, test).ravel()
    difference = reference - test
    rmse = np.sqrt(np.mean(difference**2))
    found = {
        "absmax": np.abs(difference).max(),
        "rmse": rmse,
        "psnr": -20 * np.log10(rmse) if rmse else np.inf,
        "flip.mean": errors.mean(),
        "flip.median": np.percentile(errors, 50, method="inverted_cdf"),
        "flip.p95": np.percentile(errors, 95, method="inverted_cdf"),
        "flip.max": errors.max(),
    }
    if min(reference.shape[:2]) >= 11:
        found["ssim.mean"], found["ssim.min"] = ssim(reference, test)
    return found


def report(name, reference, test):
    for key, value in values(reference, test).items():
        print(f"{name}\t{key}\t{value:.17g}")


def read(path):
    image = Image.open(path)
    samples = np.asarray(image)
    scale = 65535 if samples.dtype in (np.uint16, np.int32) else 255
    samples = samples.astype(float) / scale
    return samples if samples.ndim == 3 else samples[..., None]


def noise(x, y, channel, seed):
    """A byte that looks random: the same as test::noise in tests/metrics/pictures.h."""
    v = np.uint32(0x9E3779B1) * x + np.uint32(0x85EBCA77) * y
    v = v + np.uint32((0xC2B2AE3D * channel + 0x27D4EB2F * seed) % 2**32)
    v = (v ^ (v >> np.uint32(15))) * np.uint32(0x2C1B3C6D)
    v = (v ^ (v >> np.uint32(12))) * np.uint32(0x297A2D39)
    return ((v ^ (v >> np.uint32(15))) >> np.uint32(24)).astype(int)


def picture(width, height, channels, sample):
    y, x = np.mgrid[0:height, 0:width].astype(np.uint32)
    return np.stack([sample(x, y, c) + np.zeros((height, width), int) for c in range(channels)], axis=-1)


def gradient(x, y, c):
    return [255 * x.astype(int) // 66, 255 * y.astype(int) // 40, 128][c]


def blocks(x, y, c):
    return noise(x // np.uint32(8), y // np.uint32(8), c, 1)


def speckled(sample, seed, spread, largest=255):
    """`sample` with up to `spread` added or taken away."""
    def changed(x, y, c):
        return np.clip(sample(x, y, c) + noise(x, y, c, seed) % (2 * spread + 1) - spread, 0, largest)
    return changed


def cases():
    """Name, reference, test, the sample that stands for 1: the pictures of tests/metrics/agreement_test.cpp."""
    def to_the_right(x, y, c):
        return blocks(np.maximum(x, 1) - np.uint32(1), y, c)

    def saturated(x, y, c):
        return 255 * (blocks(x, y, c) // 128)

    def saturated_to_the_right(x, y, c):
        return 255 * (to_the_right(x, y, c) // 128)

    def slope(x, y, c):
        return 90 + (x.astype(int) + y.astype(int)) // 2

    def magenta_dot(x, y, c):
        return np.where((x == 24) & (y == 20), [255, 0, 255][c], slope(x, y, c))

    def grey(x, y, c):
        return noise(x, y, 0, 2) // 2 + 64

    def deep(x, y, c):
        return 257 * gradient(x, y, c)

    def transparent(x, y, c):
        return 4 * x.astype(int) if c == 3 else blocks(x, y, c)

    def less_transparent(x, y, c):
        return speckled(transparent, 3, 10)(x, y, c) if c == 3 else transparent(x, y, c)

    def deep_transparent(x, y, c):
        return 251 * noise(x, y, c, 4) if c == 0 else 2000 * x.astype(int)

    yield "noise on a gradient", *[picture(67, 41, 3, s) for s in (gradient, speckled(gradient, 5, 8))], 255
    yield "blocks moved by a pixel", *[picture(96, 64, 3, s) for s in (blocks, to_the_right)], 255
    yield "saturated blocks moved", *[picture(96, 64, 3, s) for s in (saturated, saturated_to_the_right)], 255
    yield "one magenta pixel", *[picture(48, 40, 3, s) for s in (slope, magenta_dot)], 255
    yield "one step brighter", *[picture(40, 30, 1, s) for s in (grey, lambda *p: grey(*p) + 1)], 255
    yield "16 bits", *[picture(67, 41, 3, s) for s in (deep, speckled(deep, 6, 100, 65535))], 65535
    yield "alpha alone", *[picture(64, 40, 4, s) for s in (transparent, less_transparent)], 255
    yield "grey and alpha, 16 bits", *[
        picture(33, 29, 2, s) for s in (deep_transparent, speckled(deep_transparent, 7, 127, 65535))], 65535
    yield "red and green", *[picture(1, 1, 3, lambda x, y, c: 255 * (c == i)) for i in (0, 1)], 255
    yield "black and white", *[picture(20, 20, 1, lambda x, y, c: v) for v in (0, 255)], 255
    yield "two rows", *[picture(7, 2, 3, lambda x, y, c: noise(x, y, c, s)) for s in (8, 9)], 255
    yield "unrelated noise", *[picture(50, 50, 3, lambda x, y, c: noise(x, y, c, s)) for s in (10, 11)], 255


if __name__ == "__main__":
    if len(sys.argv) == 3:
        report(os.path.basename(sys.argv[2]), read(sys.argv[1]), read(sys.argv[2]))
    else:
        for name, reference, test, one in cases():
            report(name, reference / one, test / one)
