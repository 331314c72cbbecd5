#!/usr/bin/env python3
"""Sets our path tracer beside Blender's Cycles on the same homes, and its own techniques beside each other.

Usage: bench/peers/compare.py [--without-cycles] BUILD_FOLDER WORK_FOLDER HOME...
Needs Debian's blender and python3-numpy for Cycles; without them only our own figures are made. The machine
should be idle: two threads are used for everything. References are kept in WORK_FOLDER and made once; they take
about a quarter of an hour a home. Prints tables in Markdown.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys

SIZE, CYCLES_SAMPLES, CYCLES_REFERENCE, OUR_REFERENCE = "160x120", 256, 4096, 3072
LARGE, LARGE_SAMPLES = "640x480", 16
HERE = pathlib.Path(__file__).resolve().parent


def run(*words):
    # Debian's Blender wants Debian's Python, whatever else stands first in the path.
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True,
                          env={**os.environ, "PATH": "/usr/bin:/bin"})
    lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
    if not lines:
        sys.exit(f"{' '.join(map(str, words))}: {done.stderr[-500:]}")
    return json.loads(lines[-1])


def kept(picture, make):
    """The figures of a picture that is made once and kept."""
    figures = picture.with_suffix(".json")
    if not (picture.exists() and figures.exists()):
        figures.write_text(json.dumps(make()))
    return json.loads(figures.read_text())


def main():
    words = [word for word in sys.argv[1:] if word != "--without-cycles"]
    peer, work = pathlib.Path(words[0]) / "bench" / "bench_peer", pathlib.Path(words[1])
    blender = shutil.which("blender") if len(words) == len(sys.argv) - 1 else None
    for home in map(pathlib.Path, words[2:]):
        folder = work / home.stem
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run([peer, "scene", home, folder, "--size", SIZE], check=True)

        def ours(*options):
            figures = run(peer, "render", home, folder / "now.exr", "--size", SIZE, "--threads", 2, *options)
            figures.update(run(peer, "compare", folder / "now.exr", folder / "ours.exr"))
            return figures

        def cycles(name, samples, *options):
            out = folder / f"{name}.exr"
            return kept(out, lambda: run(blender, "-b", "--factory-startup", "-P", HERE / "cycles.py", "--", folder, out,
                                         samples, 8, *options))

        kept(folder / "ours.exr", lambda: run(peer, "render", home, folder / "ours.exr", "--size", SIZE, "--spp",
                                              OUR_REFERENCE, "--seed", 99))
        print(f"\n### {home.stem}, {SIZE}\n\n| | seconds | paths a second | relative error | RMS on the screen, of 255 |")
        print("|---|---|---|---|---|")

        def row(what, seconds, paths, figures):
            print(f"| {what} | {seconds:.2f} | {paths:,.0f} | {figures['relative_error']:.3f} | "
                  f"{figures['display_rmse']:.1f} |", flush=True)

        peers = 13.0
        if blender:
            cycles("cycles-reference", CYCLES_REFERENCE, "portals")
            for name, options in (("cycles", ()), ("cycles-portals", ("portals",))):
                made = cycles(name, CYCLES_SAMPLES, *options)
                figures = run(peer, "compare", folder / f"{name}.exr", folder / "cycles-reference.exr")
                row(f"Cycles, {CYCLES_SAMPLES} paths a pixel{', portals' if options else ''}", made["seconds"],
                    made["paths_per_s"], figures)
                peers = made["seconds"]
        for part in (4, 20):
            seconds = peers / part
            for name, options in (("paths without looks and guide", ["--no-looks", "--no-guide"]),
                                  ("paths without guide", ["--no-guide"]), ("paths", []),
                                  ("with the light cache", ["--cache", 50000 * seconds])):
                for cleaned in ([], ["--denoise"]):
                    figures = ours("--time", seconds, *options, *cleaned)
                    row(f"{name}{', denoised' if cleaned else ''}, 1/{part} of that time",
                        figures["learn_s"] + figures["render_s"] + figures["denoise_s"], figures["paths_per_s"], figures)
        large = folder / "large"
        subprocess.run([peer, "scene", home, large, "--size", LARGE], check=True)
        print(f"\n{LARGE}, {LARGE_SAMPLES} paths a pixel, from the built scene to the last path:\n")
        print("| | seconds | million paths a second |\n|---|---|---|")

        def rate(what, seconds):
            width, height = map(int, LARGE.split("x"))
            print(f"| {what} | {seconds:.1f} | {width * height * LARGE_SAMPLES / seconds / 1e6:.3f} |", flush=True)

        if blender:
            rate("Cycles", run(blender, "-b", "--factory-startup", "-P", HERE / "cycles.py", "--", large,
                               folder / "now.exr", LARGE_SAMPLES, 8)["seconds"])
        for name, options in (("paths", []), ("paths without looks and guide", ["--no-looks", "--no-guide"])):
            made = run(peer, "render", home, folder / "now.exr", "--size", LARGE, "--spp", LARGE_SAMPLES,
                       "--threads", 2, *options)
            rate(name, made["compile_s"] + made["learn_s"] + made["render_s"])


main()
