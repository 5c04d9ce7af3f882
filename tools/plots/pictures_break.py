# Takes an engine; gives pictures of one eight-ball break: its tracks from above, and its events in time.
import math

from chart import GREY, INK, Panel, card, number, text
from engine import RADIUS_M, balls_of, on_slate

HALF_M = (1.12, 0.56)  # Half the playing surface of an 8 ft table.
MARGIN_M = 0.17
SCALE = 340.0  # Pixels a metre.
ORDER = (1, 9, 2, 10, 8, 3, 11, 4, 12, 5, 13, 6, 14, 7, 15)
COLORS = ("#e0ac00", "#1f57b8", "#d0202e", "#6a3d9a", "#e8731a", "#1b8048", "#7c2128", "#222222")


def break_case():
    """A frozen rack on the foot spot, struck hard from the right of the head spot."""
    balls = {"cue": {"position_m": on_slate(-HALF_M[0] / 2, 0.2)}}
    numbers = iter(ORDER)
    for row in range(5):
        x = HALF_M[0] / 2 + row * math.sqrt(3) * RADIUS_M
        for column in range(row + 1):
            balls[str(next(numbers))] = {"position_m": on_slate(x, (2 * column - row) * RADIUS_M)}
    angle = math.degrees(math.atan2(-0.2, HALF_M[0]))
    return {"table": "8ft", "balls": balls, "shot": {"power": 0.8, "angle_deg": angle}}


def color_of(ball):
    return INK if ball == "cue" else COLORS[(int(ball) - 1) % 8]


def is_stripe(ball):
    return ball != "cue" and int(ball) > 8


def event_times(answer, ball):
    times = {event["t"] for event in answer["events"] if ball in balls_of(event)}
    return sorted(times | {0.0})


def view(point):
    """From the table's metres to pixels; y goes up on the table."""
    return (HALF_M[0] + MARGIN_M + point[0]) * SCALE + 20, (HALF_M[1] + MARGIN_M - point[1]) * SCALE + 20


def track(answer, ball):
    """A ball's path: each segment is a parabola, and so one quadratic Bezier curve, drawn exactly."""
    samples = {sample["t"]: sample["balls"][ball] for sample in answer["samples"]}
    times = event_times(answer, ball)
    path = "M{} {}".format(*map(number, view(samples[times[0]]["position_m"])))
    for start, end in zip(times, times[1:]):
        before, after = samples[start], samples[end]
        middle = [p + v * (end - start) / 2 for p, v in zip(before["position_m"], before["velocity_mps"])]
        path += "Q{} {} {} {}".format(*map(number, (*view(middle), *view(after["position_m"]))))
    dashes = ' stroke-dasharray="6 3"' if is_stripe(ball) else ""
    width = 2.4 if ball == "cue" else 1.6
    return f'<path d="{path}" fill="none" stroke="{color_of(ball)}" stroke-width="{width}"{dashes} stroke-linejoin="round"/>'


def ball_mark(place, ball):
    x, y = view(place)
    radius, fill = RADIUS_M * SCALE, "#fff" if ball == "cue" else color_of(ball)
    marks = [f'<circle cx="{number(x)}" cy="{number(y)}" r="{number(radius)}" fill="{fill}" stroke="{INK}"/>']
    if is_stripe(ball):
        marks.append(f'<circle cx="{number(x)}" cy="{number(y)}" r="{number(radius * 0.7)}" fill="#fff"/>')
    if ball != "cue":
        marks.append(text(x, y + 3.5, ball, INK if is_stripe(ball) else "#fff", 10, "middle", "600"))
    return "".join(marks)


def rectangle(half, fill, radius=0):
    left, top = view((-half[0], half[1]))
    return (f'<rect x="{number(left)}" y="{number(top)}" width="{number(2 * half[0] * SCALE)}" '
            f'height="{number(2 * half[1] * SCALE)}" rx="{radius}" fill="{fill}"/>')


def table_parts():
    """Rail, cushions, bed and pocket circles, by the numbers of common/model/table_spec.cpp."""
    parts = [rectangle((HALF_M[0] + 0.146, HALF_M[1] + 0.146), "#c9b79c", 14),
             rectangle((HALF_M[0] + 0.049, HALF_M[1] + 0.049), "#a9c9b6", 3), rectangle(HALF_M, "#eaf3ee")]
    for x in (-1, 0, 1):
        for y in (-1, 1):
            out = 0.0292 if x else 0.0691
            cx, cy = view((x * (HALF_M[0] + out), y * (HALF_M[1] + out)))
            radius = 0.0579 if x else 0.0643
            parts.append(f'<circle cx="{number(cx)}" cy="{number(cy)}" r="{number(radius * SCALE)}" fill="#3b4148"/>')
    return parts


def tracks(engine):
    answer = engine.solve_at_events(break_case())
    parts = table_parts()
    balls = sorted(answer["final"], key=lambda ball: -1 if ball == "cue" else int(ball), reverse=True)
    for ball in balls:
        x, y = view(answer["samples"][0]["balls"][ball]["position_m"])
        parts.append(f'<circle cx="{number(x)}" cy="{number(y)}" r="{number(RADIUS_M * SCALE)}" fill="#fff" stroke="{GREY}"/>')
    parts += [track(answer, ball) for ball in balls]
    for ball in balls:
        parts.append(ball_mark(answer["final"][ball]["position_m"], ball))
    width, height = [round(2 * (half + MARGIN_M) * SCALE + 40) for half in HALF_M]
    return card(width, height, parts, "Tracks of all balls of an eight-ball break, seen from above")


SIGNS = {
    "ball-ball": lambda x, y, c: f'<circle cx="{x}" cy="{y}" r="3.4" fill="{c}"/>',
    "cushion": lambda x, y, c: f'<path d="M{x} {y - 7}v14" stroke="{c}" stroke-width="2.4"/>',
    "jaw": lambda x, y, c: f'<path d="M{x - 5} {y + 4}l5 -9 5 9z" fill="#fff" stroke="{c}" stroke-width="1.5"/>',
    "pocketed": lambda x, y, c: f'<circle cx="{x}" cy="{y}" r="6.5" fill="#fff" stroke="{c}" stroke-width="2.4"/>',
    "head-string": lambda x, y, c: f'<path d="M{x - 4} {y - 4}l8 8m0 -8l-8 8" stroke="{c}" stroke-width="1.5"/>',
}
BARS = {"sliding": 7, "rolling": 2.5, "spinning": 1}


def raster(engine):
    """Every event of the break at its time, in its balls' rows; a row's bar is as thick as the ball slips."""
    answer = engine.solve_at_events(break_case())
    balls = ["cue", *map(str, range(1, 16))]
    row_px, left, top = 25, 70, 62
    panel = Panel((left, top, 800, row_px * 16), (0, math.ceil(answer["duration_s"])), (0, 16), "time, s", y_ticks=[])
    parts = [panel.svg()]
    for row, ball in enumerate(balls):
        y = top + row_px * (row + 0.5)
        parts.append(text(left - 12, y + 4, ball, INK, 12, "end"))
        parts += bars(answer, ball, panel, y)
    for event in answer["events"]:
        for ball in balls_of(event):
            y = top + row_px * (balls.index(ball) + 0.5)
            if event["kind"] in SIGNS:
                parts.append(SIGNS[event["kind"]](round(panel.x(event["t"]), 1), y, color_of(ball)))
    parts += legend(left, 30)
    return card(900, top + row_px * 16 + 56, parts, "Events of an eight-ball break: time across, a row a ball")


def bars(answer, ball, panel, y):
    samples = {sample["t"]: sample["balls"][ball] for sample in answer["samples"]}
    times = event_times(answer, ball)
    for start, end in zip(times, times[1:]):
        thickness = BARS.get(samples[start]["motion"])
        if thickness is not None:
            yield (f'<path d="M{number(panel.x(start))} {y}H{number(panel.x(end))}" stroke="{color_of(ball)}" '
                   f'stroke-width="{thickness}" opacity=".45"/>')


def legend(x, y):
    words = {"ball-ball": "balls meet", "cushion": "cushion", "jaw": "jaw", "pocketed": "pocketed",
             "head-string": "crosses head string"}
    for kind, label in words.items():
        yield SIGNS[kind](x + 8, y - 4, GREY)
        yield text(x + 22, y, label, GREY, 12)
        x += 44 + 6.4 * len(label)
    for motion, thickness in (("sliding", 7), ("rolling", 2.5), ("spinning", 1)):
        yield f'<path d="M{x} {y - 4}h26" stroke="{GREY}" stroke-width="{thickness}" opacity=".6"/>'
        yield text(x + 34, y, motion, GREY, 12)
        x += 48 + 6.4 * len(motion)
