# Takes an engine; gives a picture of what a cushion does to a ball, by each model.
import math

from chart import AMBER, BLUE, GREEN, GREY, VIOLET, Panel, card, text
from engine import RADIUS_M, on_slate, rolling_spin, speed

SPEED_MPS = 2.0
# Han's line is broad: Stronge's lies on it wherever the contact slips throughout.
CUSHIONS = (("han2005", BLUE, 6), ("mathavan2010", GREEN, 2.2), ("stronge", AMBER, 2.2), ("mirror", VIOLET, 2.2))


def rebounds(engine, model, cases, is_rolling):
    """(angle from the normal in degrees, share of the speed kept) as a ball leaves a cushion at +y."""
    asked = []
    for angle, tip in cases:
        velocity = [SPEED_MPS * math.sin(math.radians(angle)), SPEED_MPS * math.cos(math.radians(angle)), 0]
        spin = rolling_spin(velocity) if is_rolling else [0, 0, 0]
        spin[2] = 2.5 * -tip * SPEED_MPS / RADIUS_M
        asked.append({"kind": "cushion", "model": model, "normal": [0, -1], "ball": {
            "position_m": on_slate(0, 0), "velocity_mps": velocity, "spin_radps": spin}})
    after = [answer["ball"]["velocity_mps"] for answer in engine.ask("collide", asked)]
    return [(math.degrees(math.atan2(v[0], -v[1])), speed(v) / SPEED_MPS) for v in after]


def cushions(engine):
    """The models of a cushion side by side: where and how fast a ball comes off."""
    top, size = 84, (226, 250)
    turns = Panel((62, top, *size), (0, 90), (-8, 8), "comes in at, degrees", "leaves wider by, degrees", "Rolling: angle",
                  x_ticks=range(0, 91, 30), y_ticks=range(-8, 9, 4))
    speeds = Panel((366, top, *size), (0, 90), (0.7, 1), "comes in at, degrees", "share of the speed kept", "Rolling: speed",
                   x_ticks=range(0, 91, 30))
    spins = Panel((656, top, *size), (-0.5, 0.5), (30, 62), "tip offset, ball radii", "leaves at, degrees",
                  "Stun, in at 45\u00b0, by side spin", x_ticks=[-0.5, -0.25, 0, 0.25, 0.5])
    cuts = [1.5 * i for i in range(60)]
    tips = [i / 50 - 0.5 for i in range(51)]
    parts, x = [], 62
    for model, color, width in CUSHIONS:
        by_cut = rebounds(engine, model, [(cut, 0.0) for cut in cuts], is_rolling=True)
        turns.line([(cut, angle - cut) for cut, (angle, _) in zip(cuts, by_cut)], color, width=width)
        speeds.line([(cut, kept) for cut, (_, kept) in zip(cuts, by_cut)], color, width=width)
        by_tip = rebounds(engine, model, [(45.0, tip) for tip in tips], is_rolling=False)
        spins.line([(tip, angle) for tip, (angle, _) in zip(tips, by_tip)], color, width=width)
        parts.append(f'<path d="M{x} 30h28" stroke="{color}" stroke-width="{width}" stroke-linecap="round"/>')
        parts.append(text(x + 38, 34, model, color, weight="600"))
        x += 160
    spins.note(-0.48, 31, "running", GREY)
    spins.note(0.48, 31, "reverse", GREY, "end")
    parts += [turns.svg(), speeds.svg(), spins.svg()]
    return card(900, top + 310, parts, "Angle and speed of the rebound from a cushion, by model, incoming angle and side spin")
