# Takes an engine; gives pictures of how a ball comes to rest, and of how frames come to the same.
import math

from chart import BLUE, GREEN, GREY, RED, Panel, card
from engine import RADIUS_M

SPEED_MPS = 2.0


def roll_out(engine):
    """Speed and distance of a ball that slides, rolls and rests, by how high the tip hit it."""
    shots = (("follow, tip R/2 above", GREEN, 0.5), ("stun, centre", BLUE, 0.0), ("draw, tip R/2 below", RED, -0.5))
    until_s, slide_s = 24.0, 1.0
    speeds, zoom_speeds, metres = (0.0, 2.6), (-1.0, 2.6), (0.0, 26.0)
    panels = [[Panel((64, 46, 400, 210), (0, slide_s), zoom_speeds, "time, s", "speed, m/s", "Sliding becomes rolling ..."),
               Panel((540, 46, 330, 210), (0, until_s), speeds, "time, s", "speed, m/s", "... and rolling becomes rest")],
              [Panel((64, 346, 400, 210), (0, slide_s), (0.0, 2.2), "time, s", "distance, m"),
               Panel((540, 346, 330, 210), (0, until_s), metres, "time, s", "distance, m")]]
    for name, color, tip in shots:
        spin = [0, 2.5 * tip * SPEED_MPS / RADIUS_M, 0]  # As the tip leaves it: w = (5/2) b v / R.
        case = {"table": "open", "balls": {"cue": {"position_m": [0, 0], "velocity_mps": [SPEED_MPS, 0, 0],
                                                   "spin_radps": spin}}}
        times = [slide_s * i / 50 for i in range(50)] + [slide_s + i / 2 for i in range(int(2 * until_s) - 1)]
        answer = engine.solve([{**case, "sample_times_s": times}])[0]
        rolls_s, rests_s = (event["t"] for event in answer["events"])
        balls = [(sample["t"], sample["balls"]["cue"]) for sample in answer["samples"]]
        speeds = [(t, ball["velocity_mps"][0]) for t, ball in balls]
        places = [(t, ball["position_m"][0]) for t, ball in balls]
        rims = [(t, RADIUS_M * ball["spin_radps"][1]) for t, ball in balls if t < rolls_s + 0.02]
        panels[0][0].line(rims, color, dash="2 5", width=1.8)
        for row, points in enumerate((speeds, places)):
            for panel in panels[row]:
                panel.line(points, color)
            at_roll = min(points, key=lambda point: abs(point[0] - rolls_s))[1]
            panels[row][0].dots([(rolls_s, at_roll)], color, fill="#fff")
        end_m = answer["final"]["cue"]["position_m"][0]
        panels[0][1].dots([(rests_s, 0)], color)
        panels[1][1].dots([(rests_s, end_m)], color)
        panels[1][1].note(rests_s, end_m, f"{end_m:.1f} m", color, dy=-8, dx=8, anchor="end")
        panels[0][0].note(0.98, speeds[49][1], name, color, "end", dy=-8)
    panels[0][0].note(0.98, -0.8, "dotted: speed of the rim, R\u03c9", GREY, "end", size=12)
    parts = [panel.svg() for row in panels for panel in row]
    return card(900, 616, parts, "Speed and distance against time of a ball struck above, at and below its centre")


def convergence(engine):
    """How far frames are from the exact solution, by their length, both axes in powers of ten."""
    errors = [(1 / rate, error) for rate, error in engine.classic_errors_m()]
    panel = Panel((84, 50, 540, 320), (1e-5, 3e-2), (1e-6, 1e-2), "length of a frame, s", "largest error of a place, m",
                  "The original's frames, against the exact solution", is_log=True, tick_text=power_of_ten)
    panel.line([(dt, 0.25 * dt) for dt in (1e-5, 3e-2)], GREY, dash="4 4", width=1.4)
    panel.line(errors, BLUE)
    panel.dots(errors, BLUE)
    panel.note(1.6e-4, 4e-5, "0.25 m/s \u00d7 frame: first order", GREY, "end", dx=-8, dy=-8)
    panel.note(1 / 64, errors[0][1], "64 frames/s: 3.2 mm", BLUE, "end", dx=-6, dy=-20)
    panel.note(1 / 65536, errors[-1][1], "65,536 frames/s", BLUE, dx=14, dy=10)
    return card(660, 440, [panel.svg()], "Error of the frame-stepped original against its frame length: first order")


def power_of_ten(value):
    return "10" + "".join("\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076"["-0123456".index(c)]
                          for c in str(round(math.log10(value))))
