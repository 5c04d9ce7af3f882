# Takes an engine; gives pictures of what two balls do to each other.
import math

from chart import BLUE, GREEN, GREY, INK, RED, Panel, card
from engine import RADIUS_M, angle_deg, on_slate, rolling_spin

SPEED_MPS = 2.0
TOUCHING_M = 2 * RADIUS_M


def deflection_deg(engine, cut_deg, is_rolling, model):
    """Of the cue ball, once it rolls again, from where it was going; it goes along +x."""
    cut = math.radians(cut_deg)
    velocity = [SPEED_MPS, 0, 0]
    case = {"table": "open", "physics": {"ball_ball": {"model": model}}, "balls": {
        "cue": {"position_m": on_slate(0, 0), "velocity_mps": velocity,
                "spin_radps": rolling_spin(velocity) if is_rolling else [0, 0, 0]},
        "1": {"position_m": on_slate(TOUCHING_M * math.cos(cut), TOUCHING_M * math.sin(cut))}}}
    answer = engine.solve_at_events(case)
    if not is_rolling:
        return -angle_deg(answer["samples"][0]["balls"]["cue"]["velocity_mps"])
    for sample in answer["samples"]:
        if sample["balls"]["cue"]["motion"] == "rolling":
            return -angle_deg(sample["balls"]["cue"]["velocity_mps"])
    raise RuntimeError("the cue ball never rolled")


def angle_rules(engine):
    """Where the cue ball goes, by the cut: the 90-degree rule and the 30-degree rule."""
    panel = Panel((70, 50, 560, 340), (0, 90), (0, 95), "cut angle, degrees", "cue ball deflected by, degrees",
                  "Where the cue ball goes", x_ticks=range(0, 91, 15), y_ticks=range(0, 91, 15))
    cuts = [1 + 2 * i for i in range(45)]
    for is_rolling, color in ((False, BLUE), (True, GREEN)):
        ideal = [(cut, deflection_deg(engine, cut, is_rolling, "elastic")) for cut in cuts]
        real = [(cut, deflection_deg(engine, cut, is_rolling, "frictional")) for cut in cuts]
        panel.line(ideal, color)
        panel.line(real, color, dash="2 5")
    panel.rule(y=33.749)
    panel.dots([(28.126, 33.749)], GREEN, fill="#fff")
    panel.note(28.126, 33.749, "33.749\u00b0 at 28.1\u00b0", GREEN, "middle", dy=-10)
    panel.note(46, 46, "stun: at right angles to the object ball", BLUE, dx=6, dy=-6)
    panel.note(33, 22, "natural roll: about 30\u00b0", GREEN, "middle")
    panel.note(11, 4, "solid: e = 1, no friction; dotted: e = 0.95 with friction between the balls", GREY, size=12)
    return card(660, 450, [panel.svg()], "Deflection of the cue ball against the cut angle, for stun and for natural roll")


def throw_deg(engine, cases):
    """Angles of the object ball from the line of centres, +y; the cue ball comes cut by cut_deg."""
    asked = []
    for cut_deg, speed_mps, tip in cases:
        cut = math.radians(cut_deg)
        spin = [0, 0, 2.5 * -tip * speed_mps / RADIUS_M]
        asked.append({"table": "open", "sample_times_s": [0], "balls": {
            "cue": {"position_m": on_slate(0, 0), "spin_radps": spin,
                    "velocity_mps": [speed_mps * math.cos(cut), speed_mps * math.sin(cut), 0]},
            "1": {"position_m": on_slate(TOUCHING_M, 0)}}})
    answers = engine.solve(asked)
    return [angle_deg(answer["samples"][0]["balls"]["1"]["velocity_mps"]) for answer in answers]


def throw(engine):
    """How far friction pulls the object ball off the line of centres: by cut and by side spin."""
    speeds = ((0.447, "slow, 0.45 m/s", BLUE), (1.341, "medium, 1.34 m/s", GREEN), (3.129, "fast, 3.13 m/s", RED))
    by_cut = Panel((66, 50, 340, 300), (0, 90), (0, 6), "cut angle, degrees", "throw, degrees",
                   "Stun shots, by cut angle", x_ticks=range(0, 91, 15))
    by_tip = Panel((486, 50, 390, 300), (-0.5, 0.5), (-7, 7), "tip offset, ball radii", "throw, degrees",
                   "Half-ball hits, by side spin", y_ticks=range(-6, 7, 2))
    cuts = [i * 0.75 for i in range(120)]
    tips = [i / 100 - 0.5 for i in range(101)]
    by_tip.rule(y=0, dash="")
    by_tip.rule(x=0.2)
    for speed_mps, name, color in speeds:
        throws = throw_deg(engine, [(cut, speed_mps, 0.0) for cut in cuts])
        by_cut.line(list(zip(cuts, throws)), color)
        throws = throw_deg(engine, [(30.0, speed_mps, tip) for tip in tips])
        by_tip.line(list(zip(tips, throws)), color)
    by_cut.note(88, 5.5, "slow, 0.45 m/s", BLUE, "end")
    by_cut.note(88, 3.9, "medium, 1.34 m/s", GREEN, "end")
    by_cut.note(88, 1.5, "fast, 3.13 m/s", RED, "end")
    by_tip.dots([(0.2, 0)], INK, fill="#fff")
    for line, words in enumerate(("gearing:", "(2/5) sin 30\u00b0 = 0.2,", "no slip, no throw")):
        by_tip.note(0.22, 4.6 - 0.9 * line, words)
    by_tip.note(-0.48, -6.4, "inside english", GREY)
    by_tip.note(0.48, -6.4, "outside english", GREY, "end")
    return card(900, 410, [by_cut.svg(), by_tip.svg()], "Throw against cut angle and against side spin, at three speeds")
