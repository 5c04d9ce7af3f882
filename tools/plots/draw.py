#!/usr/bin/env python3
# Takes a build; gives the pictures of docs/physics.md as SVG.
# Needs Python 3 alone: tools/plots/draw.py [--bin FOLDER] [--into FOLDER] [PICTURE ...]
import argparse
import pathlib

from engine import Engine
import pictures_break
import pictures_contact
import pictures_cushion
import pictures_motion

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURES = {
    "roll-out": pictures_motion.roll_out,
    "angle-rules": pictures_contact.angle_rules,
    "throw": pictures_contact.throw,
    "cushions": pictures_cushion.cushions,
    "convergence": pictures_motion.convergence,
    "break-tracks": pictures_break.tracks,
    "break-events": pictures_break.raster,
}


def main():
    parser = argparse.ArgumentParser(description="Draws the pictures of docs/physics.md")
    parser.add_argument("pictures", nargs="*", metavar="PICTURE", help=f"of {', '.join(PICTURES)}; default: all")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/bin", help="default: that of ./test.sh")
    parser.add_argument("--into", type=pathlib.Path, default=ROOT / "docs/images")
    options = parser.parse_args()
    engine = Engine(options.bin)
    options.into.mkdir(parents=True, exist_ok=True)
    for name in options.pictures or PICTURES:
        (options.into / f"{name}.svg").write_text(PICTURES[name](engine), encoding="utf-8")


if __name__ == "__main__":
    main()
